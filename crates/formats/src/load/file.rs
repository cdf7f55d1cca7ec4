//! The bytes of a file, or why there are none.

use crate::Describe;
use crate::progress::{self, Stage};
use crate::refusal::Refusal;
use lancer_words::{Lang, file as words};
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};

/// The name of standard input.
pub const STANDARD: &str = "-";

/// A file that could not be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{}` cannot be read", .path.display())]
pub struct LoadError {
    /// The path as the user gave it.
    pub path: PathBuf,
    /// Why.
    pub cause: LoadCause,
}

/// Why a file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LoadCause {
    /// There is no such file.
    Missing,
    /// The path names a folder.
    IsAFolder,
    /// It is a pipe or a device: reading it might never end.
    NotAFile,
    /// The user must not read it.
    Forbidden,
    /// It has more bytes than are read.
    TooLarge {
        /// How many are read.
        most: u64,
    },
    /// There is no memory for it.
    NoMemory,
    /// The links on the way lead in a circle.
    LinksInACircle,
    /// The name is longer than the system allows.
    NameTooLong,
    /// Anything else, in the system's words.
    Other(String),
}

impl Describe for LoadError {
    fn code(&self) -> &'static str {
        match self.cause {
            LoadCause::Missing => "load::missing",
            LoadCause::IsAFolder => "load::is-a-folder",
            LoadCause::NotAFile => "load::not-a-file",
            LoadCause::Forbidden => "load::forbidden",
            LoadCause::TooLarge { .. } => "load::too-large",
            LoadCause::NoMemory => "load::no-memory",
            LoadCause::LinksInACircle => "load::links-in-a-circle",
            LoadCause::NameTooLong => "load::name-too-long",
            LoadCause::Other(_) => "load::failed",
        }
    }

    fn message(&self, lang: Lang) -> String {
        let cause = match &self.cause {
            LoadCause::Missing => words::missing(lang),
            LoadCause::IsAFolder => words::is_a_folder(lang),
            LoadCause::NotAFile => words::not_a_file(lang),
            LoadCause::Forbidden => words::forbidden(lang),
            LoadCause::TooLarge { most } => words::larger_than(lang, most >> 20),
            LoadCause::NoMemory => words::no_memory(lang),
            LoadCause::LinksInACircle => words::links_in_a_circle(lang),
            LoadCause::NameTooLong => words::name_too_long(lang),
            LoadCause::Other(cause) => cause.clone(),
        };
        if self.path == Path::new(STANDARD) {
            words::cannot_read_standard(lang, cause)
        } else {
            words::cannot_read(lang, self.path.display(), cause)
        }
    }

    fn label(&self, _lang: Lang) -> String {
        String::new()
    }

    fn help(&self, lang: Lang) -> Option<String> {
        match self.cause {
            LoadCause::Missing => Some(words::missing_help(lang)),
            LoadCause::NotAFile => Some(words::not_a_file_help(lang)),
            LoadCause::IsAFolder
            | LoadCause::Forbidden
            | LoadCause::TooLarge { .. }
            | LoadCause::NoMemory
            | LoadCause::LinksInACircle
            | LoadCause::NameTooLong
            | LoadCause::Other(_) => None,
        }
    }
}

impl From<io::Error> for LoadCause {
    fn from(error: io::Error) -> LoadCause {
        let kind = error.kind();
        if matches!(kind, ErrorKind::NotFound | ErrorKind::NotADirectory) {
            LoadCause::Missing
        } else if kind == ErrorKind::PermissionDenied {
            LoadCause::Forbidden
        } else if kind == ErrorKind::OutOfMemory {
            LoadCause::NoMemory
        } else {
            match Refusal::of(&error) {
                Some(Refusal::LinksInACircle) => LoadCause::LinksInACircle,
                Some(Refusal::NameTooLong) => LoadCause::NameTooLong,
                None => LoadCause::Other(error.to_string()),
            }
        }
    }
}

/// The bytes of a regular file, or of standard input.
pub(super) fn read(path: &Path, most: u64) -> Result<Vec<u8>, LoadError> {
    let bytes = if path == Path::new(STANDARD) { up_to(io::stdin().lock(), most, 0) } else { regular(path, most) };
    bytes.map_err(|cause| LoadError { path: path.to_owned(), cause })
}

/// The bytes of a regular file.
pub(super) fn regular(path: &Path, most: u64) -> Result<Vec<u8>, LoadCause> {
    // Asked before it is opened, for to open a pipe is to wait; and again after, for the name may have changed hands.
    check(&fs::metadata(path)?, most)?;
    let file = File::open(path)?;
    let found = file.metadata()?;
    check(&found, most)?;
    up_to(file, most, found.len())
}

fn check(found: &fs::Metadata, most: u64) -> Result<(), LoadCause> {
    if found.is_dir() {
        Err(LoadCause::IsAFolder)
    } else if !found.is_file() {
        Err(LoadCause::NotAFile)
    } else if found.len() > most {
        Err(LoadCause::TooLarge { most })
    } else {
        Ok(())
    }
}

/// Everything to the end, which must come within `most` bytes.
fn up_to(input: impl Read, most: u64, expected: u64) -> Result<Vec<u8>, LoadCause> {
    /// How far it is, is told after so many bytes.
    const PIECE: u64 = 4 << 20;
    let mut bytes = Vec::new();
    // One more than the file has, so that its end is met without growing.
    let room = usize::try_from(expected.saturating_add(1)).map_err(|_| LoadCause::NoMemory)?;
    bytes.try_reserve_exact(room).map_err(|_| LoadCause::NoMemory)?;
    progress::begin(Stage::Bytes, expected);
    let mut input = input.take(most.saturating_add(1));
    while input.by_ref().take(PIECE).read_to_end(&mut bytes)? > 0 {
        progress::at(bytes.len() as u64);
    }
    progress::begin(Stage::Content, bytes.len() as u64);
    if bytes.len() as u64 > most { Err(LoadCause::TooLarge { most }) } else { Ok(bytes) }
}
