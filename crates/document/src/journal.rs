//! The journal: after every step the stage is written to a file of the user's data folder in the background, so that a
//! crash or a kill loses at most the last step. The user's own files are never touched.
//!
//! A journal is one file, written beside and renamed, and an empty one beside it that is locked as long as its program
//! lives. On the next start, a journal without a living program is offered. It goes when the document is saved or
//! discarded.
//!
//! ```text
//! 8 bytes         magic
//! 4 × (8 + n)     length, little-endian, and bytes of: path of the scene, path of the views (UTF-8, empty for none),
//!                 the scene (binary format), the views (native document)
//! ```

use crate::Document;
use crate::open::{self, SceneFile, ViewsFile};
use lancer_formats::load::LoadOptions;
use lancer_formats::save::{SaveError, save};
use lancer_formats::{binary, xml};
use lancer_scene::Stage;
use std::ffi::OsStr;
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::SystemTime;

const MAGIC: &[u8; 8] = b"\x89LJN\r\n\x1a\x01";
const EXTENSION: &str = "journal";
const LOCK: &str = "lock";
/// Journals in one folder that are tried for a free name.
const MOST: u32 = 10_000;

/// What a journal keeps of a document.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The scene and its views.
    pub stage: Stage,
    /// The file of the scene.
    pub scene: Option<PathBuf>,
    /// The file of the views.
    pub views: Option<PathBuf>,
}

/// The journal of a running program.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    orders: Option<Sender<Order>>,
    thread: Option<JoinHandle<()>>,
    failure: Arc<Mutex<Option<SaveError>>>,
    /// The revision that is kept; `None` if nothing is.
    kept: Option<u64>,
    /// Held until the program ends, however it does.
    _lock: File,
}

enum Order {
    Keep(Entry),
    Forget,
    /// Answered when everything before is done.
    Answer(Sender<()>),
}

impl Journal {
    /// A journal in a folder, which is made if it does not exist.
    ///
    /// # Errors
    /// The folder cannot be made or written.
    pub fn begin(folder: &Path) -> io::Result<Journal> {
        fs::create_dir_all(folder)?;
        let (path, lock) = free_name(folder)?;
        let failure = Arc::new(Mutex::new(None));
        let (orders, inbox) = channel();
        let thread = {
            let (path, failure) = (path.clone(), Arc::clone(&failure));
            std::thread::spawn(move || work(&inbox, &path, &failure))
        };
        Ok(Journal { path, orders: Some(orders), thread: Some(thread), failure, kept: None, _lock: lock })
    }

    /// Keeps what the document has come to, if that is another step than the last time; to be called whenever something
    /// may have changed. A gesture is kept when it is over. When nothing would be lost, nothing is kept.
    pub fn follow(&mut self, document: &Document) {
        if document.in_gesture() {
            return;
        }
        if !document.has_work_to_lose() {
            self.forget();
        } else if self.kept != Some(document.revision()) {
            self.kept = Some(document.revision());
            self.order(Order::Keep(document.entry()));
        }
    }

    /// Forgets what is kept: the changes were discarded.
    pub fn forget(&mut self) {
        if self.kept.take().is_some() {
            self.order(Order::Forget);
        }
    }

    /// Waits until everything is on the disk.
    pub fn wait(&self) {
        let (answer, done) = channel();
        self.order(Order::Answer(answer));
        // a thread that is gone has nothing to do any more
        let _ = done.recv();
    }

    /// Why the last step is not on the disk.
    pub fn failure(&self) -> Option<SaveError> {
        self.failure.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    fn order(&self, order: Order) {
        if let Some(orders) = &self.orders {
            // the thread lives as long as this
            let _ = orders.send(order);
        }
    }
}

impl Drop for Journal {
    fn drop(&mut self) {
        self.orders = None;
        if let Some(thread) = self.thread.take() {
            // one that panicked has nothing left to end
            let _ = thread.join();
        }
        if !self.path.exists() {
            let _ = fs::remove_file(self.path.with_extension(LOCK));
        }
    }
}

/// A name in the folder that no living program has, and its lock.
fn free_name(folder: &Path) -> io::Result<(PathBuf, File)> {
    for number in 1..=MOST {
        let path = folder.join(format!("{number}.{EXTENSION}"));
        let lock = File::options().create(true).truncate(false).write(true).open(path.with_extension(LOCK))?;
        // what a dead program left is not written over
        if lock.try_lock().is_ok() && !path.exists() {
            return Ok((path, lock));
        }
    }
    Err(io::ErrorKind::AlreadyExists.into())
}

/// The thread: of several entries that wait only the last one is written.
fn work(inbox: &Receiver<Order>, path: &Path, failure: &Mutex<Option<SaveError>>) {
    while let Ok(first) = inbox.recv() {
        let (mut last, mut answers) = (None, Vec::new());
        for order in std::iter::once(first).chain(inbox.try_iter()) {
            match order {
                Order::Keep(entry) => last = Some(Some(entry)),
                Order::Forget => last = Some(None),
                Order::Answer(answer) => answers.push(answer),
            }
        }
        match last {
            Some(Some(entry)) => {
                let bytes = entry.to_bytes();
                let result = save(path, |out| out.write_all(&bytes));
                *failure.lock().unwrap_or_else(PoisonError::into_inner) = result.err();
            }
            Some(None) => {
                // what cannot be removed is offered again, which loses nothing
                let _ = fs::remove_file(path);
            }
            None => {}
        }
        for answer in answers {
            // nobody waits any more
            let _ = answer.send(());
        }
    }
}

/// A journal whose program is gone.
#[derive(Debug)]
pub struct LeftBehind {
    path: PathBuf,
    /// When its last step was written.
    pub written: SystemTime,
    _lock: File,
}

/// The journals of a folder whose programs are gone, the newest first. They are held for this program alone as long as
/// they are not dropped.
pub fn left_behind(folder: &Path) -> Vec<LeftBehind> {
    let Ok(files) = fs::read_dir(folder) else { return Vec::new() };
    let mut found: Vec<LeftBehind> = files
        .filter_map(|file| {
            let path = file.ok()?.path();
            if path.extension() != Some(OsStr::new(EXTENSION)) {
                return None;
            }
            let written = fs::metadata(&path).ok()?.modified().unwrap_or(SystemTime::UNIX_EPOCH);
            let lock = File::options().create(true).truncate(false).write(true).open(path.with_extension(LOCK)).ok()?;
            match lock.try_lock() {
                Ok(()) => Some(LeftBehind { path, written, _lock: lock }),
                Err(TryLockError::WouldBlock | TryLockError::Error(_)) => None,
            }
        })
        .collect();
    found.sort_by(|a, b| (b.written, &b.path).cmp(&(a.written, &a.path)));
    found
}

impl LeftBehind {
    /// What it kept; `None` if that cannot be read.
    pub fn read(&self) -> Option<Entry> {
        Entry::from_bytes(&fs::read(&self.path).ok()?)
    }

    /// Removes it: it was taken over by another journal, or is not wanted.
    pub fn discard(self) {
        let lock = self.path.with_extension(LOCK);
        // what cannot be removed is offered again, which loses nothing
        if fs::remove_file(&self.path).is_ok() {
            let _ = fs::remove_file(lock);
        }
    }
}

impl Entry {
    /// The files that it names, read as they are now, as far as they can be.
    pub fn files(&self, options: &LoadOptions) -> (Option<SceneFile>, Option<ViewsFile>) {
        let scene = self.scene.as_deref().and_then(|path| open::read_scene(path, options).ok());
        let views = self.views.as_deref().and_then(|path| open::read_views(path, options).ok());
        (scene, views)
    }

    fn to_bytes(&self) -> Vec<u8> {
        // a path that is no text is not remembered: the document is then one that was never saved
        let text = |path: &Option<PathBuf>| path.as_deref().and_then(Path::to_str).unwrap_or("").as_bytes().to_vec();
        let scene = binary::write_scene(&self.stage.scene);
        let views = xml::write_views(&self.stage.views).into_bytes();
        let mut bytes = MAGIC.to_vec();
        for part in [text(&self.scene), text(&self.views), scene, views] {
            bytes.extend_from_slice(&(part.len() as u64).to_le_bytes());
            bytes.extend_from_slice(&part);
        }
        bytes
    }

    fn from_bytes(bytes: &[u8]) -> Option<Entry> {
        let mut rest = bytes.strip_prefix(MAGIC)?;
        let mut part = || {
            let (length, after) = rest.split_first_chunk::<8>()?;
            let length = usize::try_from(u64::from_le_bytes(*length)).ok()?;
            let (part, after) = after.split_at_checked(length)?;
            rest = after;
            Some(part)
        };
        let (scene_path, views_path, scene, views) = (part()?, part()?, part()?, part()?);
        let path = |bytes: &[u8]| {
            let text = std::str::from_utf8(bytes).ok()?;
            Some((!text.is_empty()).then(|| PathBuf::from(text)))
        };
        let document = xml::Document::read("views", views).ok()?;
        let stage = Stage { scene: binary::read_scene(scene).ok()?, views: xml::read_views(&document).value? };
        Some(Entry { stage, scene: path(scene_path)?, views: path(views_path)? })
    }
}
