//! Asking for a file: through the system's dialog, and through one of our own where there is none.

mod browser;
mod system;

pub use browser::Browser;
pub use system::SystemDialogs;

use std::path::PathBuf;

/// What a dialog asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Request {
    /// The dialog's title.
    pub title: String,
    /// Whether a file is to be written; else it must exist.
    pub save: bool,
    /// The folder to begin in.
    pub folder: Option<PathBuf>,
    /// The proposed file name.
    pub name: String,
    /// Kinds of files: their names and extensions, the proposed one first.
    pub filters: Vec<(String, Vec<String>)>,
}

/// What a dialog answered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reply {
    /// A file was chosen.
    Chosen(PathBuf),
    /// Nothing was chosen.
    Cancelled,
    /// There is no such dialog on this machine.
    Unavailable,
}

/// Something that asks for files; tests put another one in its place.
pub trait Dialogs {
    /// Begins to ask. An earlier question is forgotten.
    fn ask(&mut self, request: &Request);
    /// The reply, once there is one.
    fn poll(&mut self) -> Option<Reply>;
}
