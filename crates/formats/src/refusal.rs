//! What the system answers about a path where its own words, which are English, would reach a person: the two answers
//! that come from the path alone, whether the file is to be read or to be written.

use std::io::{Error, ErrorKind};

/// A path that the system does not follow to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Refusal {
    /// The links on its way lead in a circle, or there are more of them than the system follows.
    LinksInACircle,
    /// The path, or a name in it, has more bytes than the system takes.
    NameTooLong,
}

impl Refusal {
    /// The refusal that an error of the system is, if it is one.
    pub(crate) fn of(error: &Error) -> Option<Refusal> {
        if error.kind() == ErrorKind::InvalidFilename {
            Some(Refusal::NameTooLong)
        } else {
            leads_in_a_circle(error).then_some(Refusal::LinksInACircle)
        }
    }
}

// the library's own kind for it is not stable yet
#[cfg(unix)]
fn leads_in_a_circle(error: &Error) -> bool {
    rustix::io::Errno::from_io_error(error) == Some(rustix::io::Errno::LOOP)
}

#[cfg(not(unix))]
fn leads_in_a_circle(_error: &Error) -> bool {
    false
}
