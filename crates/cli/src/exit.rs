//! The exit codes, the same for every command.

use std::process::ExitCode;

/// How the program ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Exit {
    /// Done.
    Done = 0,
    /// The input is wrong; `diff` found differences; `check` found errors.
    Wrong = 1,
    /// The command line is wrong.
    Usage = 2,
    /// The system: missing or unreadable input, failed output, memory.
    System = 3,
    /// Ctrl-C, or asked to end.
    Interrupted = 130,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> ExitCode {
        ExitCode::from(exit as u8)
    }
}
