//! Writing files: the one place where files are opened for writing.
//!
//! A file is written beside its place and moved there when it is whole, so a full disk or a kill leaves the old file as
//! it was; what [`save`] writes is on the disk by then, so that a power cut does too. A kill that lets nothing be tidied
//! up (SIGKILL), and a power cut, can leave the unfinished `.lancer-….part` beside it. Links are followed: what a link
//! names is replaced, the link stays. The mode and, where the system lets us, the owner of the old file are kept.
//! Devices, pipes and standard output have no old content to keep and are written directly.

mod scene;

pub use scene::{Origin, SceneFormat, UnknownSceneExtension, save_scene, scene_bytes};

use crate::Describe;
use crate::refusal::Refusal;
use lancer_words::{Lang, file as words};
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// The name of standard output.
pub const STANDARD: &str = "-";
/// Links of links that are followed; as many as Linux follows.
const MOST_LINKS: usize = 40;

/// A file that could not be written.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", .path.display())]
pub struct SaveError {
    /// The path as the user gave it.
    pub path: PathBuf,
    /// Why.
    pub cause: SaveCause,
}

/// Why a file cannot be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SaveCause {
    /// The folder does not exist.
    MissingFolder(PathBuf),
    /// This part of the path is no folder.
    NotAFolder(PathBuf),
    /// The path names a folder.
    IsAFolder,
    /// The file exists and must not be written.
    ReadOnly,
    /// No file can be made in the folder.
    ReadOnlyFolder(PathBuf),
    /// The disk or the user's share of it is full.
    NoSpace,
    /// The file would exceed a limit.
    TooLarge,
    /// The links on the way lead in a circle.
    LinksInACircle,
    /// The name is longer than the system allows.
    NameTooLong,
    /// The reader of the pipe is gone: no error for a program whose output goes to `head`.
    Closed,
    /// Anything else, in the system's or the writer's words.
    Other(String),
}

impl Describe for SaveError {
    fn code(&self) -> &'static str {
        match self.cause {
            SaveCause::MissingFolder(_) => "save::missing-folder",
            SaveCause::NotAFolder(_) => "save::not-a-folder",
            SaveCause::IsAFolder => "save::is-a-folder",
            SaveCause::ReadOnly => "save::read-only",
            SaveCause::ReadOnlyFolder(_) => "save::read-only-folder",
            SaveCause::NoSpace => "save::no-space",
            SaveCause::TooLarge => "save::too-large",
            SaveCause::LinksInACircle => "save::links-in-a-circle",
            SaveCause::NameTooLong => "save::name-too-long",
            SaveCause::Closed => "save::closed",
            SaveCause::Other(_) => "save::failed",
        }
    }

    fn message(&self, lang: Lang) -> String {
        let cause = match &self.cause {
            SaveCause::MissingFolder(folder) => words::missing_folder(lang, folder.display()),
            SaveCause::NotAFolder(folder) => words::not_a_folder(lang, folder.display()),
            SaveCause::IsAFolder => words::is_a_folder(lang),
            SaveCause::ReadOnly => words::read_only(lang),
            SaveCause::ReadOnlyFolder(folder) => words::read_only_folder(lang, folder.display()),
            SaveCause::NoSpace => words::no_space(lang),
            SaveCause::TooLarge => words::too_large(lang),
            SaveCause::LinksInACircle => words::links_in_a_circle(lang),
            SaveCause::NameTooLong => words::name_too_long(lang),
            SaveCause::Closed => words::closed(lang),
            SaveCause::Other(cause) => cause.clone(),
        };
        if is_standard(&self.path) {
            words::cannot_write_standard(lang, cause)
        } else {
            words::cannot_write(lang, self.path.display(), cause)
        }
    }

    fn label(&self, _lang: Lang) -> String {
        String::new()
    }

    fn help(&self, lang: Lang) -> Option<String> {
        match self.cause {
            SaveCause::MissingFolder(_) => Some(words::missing_folder_help(lang)),
            SaveCause::IsAFolder => Some(words::is_a_folder_help(lang)),
            SaveCause::ReadOnly => Some(words::read_only_help(lang)),
            SaveCause::ReadOnlyFolder(_) => Some(words::read_only_folder_help(lang)),
            SaveCause::NoSpace | SaveCause::TooLarge => Some(words::old_file_whole(lang)),
            SaveCause::NotAFolder(_)
            | SaveCause::LinksInACircle
            | SaveCause::NameTooLong
            | SaveCause::Closed
            | SaveCause::Other(_) => None,
        }
    }
}

impl From<io::Error> for SaveCause {
    fn from(error: io::Error) -> SaveCause {
        let kind = error.kind();
        if matches!(kind, ErrorKind::StorageFull | ErrorKind::QuotaExceeded) {
            SaveCause::NoSpace
        } else if kind == ErrorKind::FileTooLarge {
            SaveCause::TooLarge
        } else if kind == ErrorKind::BrokenPipe {
            SaveCause::Closed
        } else {
            match Refusal::of(&error) {
                Some(Refusal::LinksInACircle) => SaveCause::LinksInACircle,
                Some(Refusal::NameTooLong) => SaveCause::NameTooLong,
                None => SaveCause::Other(error.to_string()),
            }
        }
    }
}

/// Writes a file of somebody's work: `write` is called once with the place to write to, and the file appears when it
/// has succeeded and its content is on the disk. The path `-` means standard output.
///
/// # Errors
/// Why the file cannot be written, be it the system or `write` that says so. A regular file that stood there before is
/// then whole, and nothing is left beside it.
pub fn save(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), SaveError> {
    save_together([(path, write)])
}

/// Writes files of somebody's work that belong together, a scene and the materials beside it: none of them appears
/// before all of them are on the disk.
///
/// # Errors
/// Those of [`save`], of the first file that cannot be written. All regular files that stood there before are then
/// whole: only when the system refuses to move one that is whole, the ones before it have moved already.
pub fn save_together<'a, W: FnOnce(&mut dyn Write) -> io::Result<()>>(
    files: impl IntoIterator<Item = (&'a Path, W)>,
) -> Result<(), SaveError> {
    let mut waiting = Vec::new();
    for (path, write) in files {
        let failed = |cause| SaveError { path: path.to_owned(), cause };
        if let Some((file, target)) = filled(path, write)? {
            file.as_file().sync_all().map_err(|error| failed(error.into()))?;
            waiting.push((path, file, target));
        }
    }
    for (path, file, target) in waiting {
        appear(file, &target).map_err(|error| SaveError { path: path.to_owned(), cause: error.into() })?;
        // The move itself reaches the disk with the folder. Where that fails, the file is whole all the same.
        if let Ok(folder) = File::open(folder_of(&target)) {
            let _ = folder.sync_all();
        }
    }
    Ok(())
}

/// Writes a file that can be computed again, a picture: as [`save`] does, but the system brings it to the disk when it
/// likes. To wait for that can take as long as the picture took.
///
/// # Errors
/// Those of [`save`].
pub fn save_output(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), SaveError> {
    match filled(path, write)? {
        Some((file, target)) => {
            appear(file, &target).map_err(|error| SaveError { path: path.to_owned(), cause: error.into() })
        }
        None => Ok(()),
    }
}

/// Moves a whole file to its place.
fn appear(file: NamedTempFile, target: &Path) -> io::Result<()> {
    file.persist(target).map(drop).map_err(|error| error.error)
}

/// Writes to a path: a regular file beside its place, which is given with it; anything else, directly.
fn filled(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<Option<(NamedTempFile, PathBuf)>, SaveError> {
    let failed = |cause| SaveError { path: path.to_owned(), cause };
    match Destination::of(path).map_err(failed)? {
        Destination::Standard => {
            let mut out = io::stdout().lock();
            write(&mut out).and_then(|()| out.flush()).map_err(|error| failed(error.into()))?;
            Ok(None)
        }
        Destination::Direct => {
            let open = OpenOptions::new().write(true).open(path);
            open.and_then(|file| fill(file, write).map(drop)).map_err(|error| failed(error.into()))?;
            Ok(None)
        }
        Destination::Replace { target, old } => {
            let temporary = beside(&target, old.as_ref()).map_err(failed)?;
            fill(temporary.as_file(), write).map_err(|error| failed(error.into()))?;
            Ok(Some((temporary, target)))
        }
    }
}

/// Whether a file can be written there as far as one can tell without writing it: to be asked before a long
/// computation.
///
/// # Errors
/// Why not.
pub fn check(path: &Path) -> Result<(), SaveError> {
    let failed = |cause| SaveError { path: path.to_owned(), cause };
    match Destination::of(path).map_err(failed)? {
        Destination::Standard | Destination::Direct => Ok(()),
        Destination::Replace { target, old } => beside(&target, old.as_ref()).map(drop).map_err(failed),
    }
}

/// Hands `write` a buffer before `file` and empties it.
fn fill<F: Write>(file: F, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<F> {
    let mut buffer = BufWriter::with_capacity(1 << 16, file);
    if let Err(error) = write(&mut buffer) {
        // Taken apart, for a dropped buffer would try to write its rest.
        drop(buffer.into_parts());
        return Err(error);
    }
    buffer.into_inner().map_err(io::IntoInnerError::into_error)
}

/// What a path means.
enum Destination {
    /// Standard output.
    Standard,
    /// A device or a pipe.
    Direct,
    /// A regular file.
    Replace {
        /// The place behind all links.
        target: PathBuf,
        /// What stands there.
        old: Option<Metadata>,
    },
}

impl Destination {
    fn of(path: &Path) -> Result<Destination, SaveCause> {
        if is_standard(path) {
            return Ok(Destination::Standard);
        }
        let target = behind_links(path)?;
        let old = match fs::metadata(&target) {
            Ok(old) => Some(old),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(error.into()),
        };
        match &old {
            Some(old) if old.is_dir() => return Err(SaveCause::IsAFolder),
            Some(old) if !old.is_file() => return Ok(Destination::Direct),
            Some(old) if old.permissions().readonly() => return Err(SaveCause::ReadOnly),
            Some(_) => may_be_written(&target)?,
            // `new/` asks for a folder.
            None if target.as_os_str().as_encoded_bytes().ends_with(b"/") => return Err(SaveCause::IsAFolder),
            None => {}
        }
        Ok(Destination::Replace { target, old })
    }
}

fn is_standard(path: &Path) -> bool {
    path == Path::new(STANDARD) || path == Path::new("/dev/stdout")
}

/// The place that a path names behind all its links, whether or not something stands there.
fn behind_links(path: &Path) -> Result<PathBuf, SaveCause> {
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::symlink_metadata(&target) {
            Ok(found) if found.is_symlink() => target = folder_of(&target).join(fs::read_link(&target)?),
            Ok(_) => return Ok(target),
            Err(error) if error.kind() == ErrorKind::NotFound => {
                let folder = folder_of(&target);
                return match fs::metadata(folder) {
                    Ok(found) if found.is_dir() => Ok(target),
                    Ok(_) => Err(SaveCause::NotAFolder(folder.to_owned())),
                    Err(_) => Err(SaveCause::MissingFolder(folder.to_owned())),
                };
            }
            Err(error) if error.kind() == ErrorKind::NotADirectory => {
                return Err(SaveCause::NotAFolder(folder_of(&target).to_owned()));
            }
            Err(error) => return Err(error.into()),
        }
    }
    Err(SaveCause::LinksInACircle)
}

/// The folder in which a path's last part stands.
fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// A rename needs no leave to write the file that it replaces; we ask for it all the same.
fn may_be_written(target: &Path) -> Result<(), SaveCause> {
    match OpenOptions::new().write(true).open(target) {
        Ok(_) => Ok(()),
        Err(error) if forbidden(&error) => Err(SaveCause::ReadOnly),
        Err(error) => Err(error.into()),
    }
}

fn forbidden(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem)
}

/// A new file in the target's folder that goes when it is dropped.
fn beside(target: &Path, old: Option<&Metadata>) -> Result<NamedTempFile, SaveCause> {
    let folder = folder_of(target);
    let mut builder = tempfile::Builder::new();
    builder.prefix(".lancer-").suffix(".part");
    #[cfg(unix)]
    let builder = {
        use std::os::unix::fs::PermissionsExt;
        // As the user's mask leaves it, like any new file.
        builder.permissions(fs::Permissions::from_mode(0o666))
    };
    let temporary = builder
        .tempfile_in(folder)
        .map_err(|error| if forbidden(&error) { SaveCause::ReadOnlyFolder(folder.to_owned()) } else { error.into() })?;
    if let Some(old) = old {
        #[cfg(unix)]
        {
            use std::os::unix::fs::{MetadataExt, fchown};
            // Only root may give files away; for others, the file becomes theirs. It comes before the mode, whose
            // special bits it would take away.
            let _ = fchown(temporary.as_file(), Some(old.uid()), Some(old.gid()));
        }
        temporary.as_file().set_permissions(old.permissions())?;
    }
    Ok(temporary)
}
