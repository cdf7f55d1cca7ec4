//! The one place that writes to standard output and standard error.
//!
//! Rust's `println!` panics when the reader of a pipe has gone away. Here that is no error: whoever closed the pipe has
//! seen enough.

use crate::{Exit, Failure};
use lancer_formats::save::{self, STANDARD, SaveCause};
use lancer_words::Lang;
use lancer_words::cli::usage;
use serde::Serialize;
use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::Path;

/// Where the program speaks, and in which language.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Console {
    /// The language.
    pub(crate) lang: Lang,
    /// Whether warnings and progress are left out.
    pub(crate) quiet: bool,
}

impl Console {
    /// The same, but silent if asked to be.
    pub(crate) fn quiet_if(self, quiet: bool) -> Console {
        Console { quiet: self.quiet || quiet, ..self }
    }

    /// Writes to standard output.
    ///
    /// # Errors
    /// What the system says, except that the reader went away.
    pub(crate) fn print(&self, text: impl AsRef<[u8]>) -> Result<(), Failure> {
        self.print_with(|out| out.write_all(text.as_ref()))
    }

    /// Writes a value to standard output as one line of JSON.
    ///
    /// # Errors
    /// What the system says, except that the reader went away.
    pub(crate) fn print_json(&self, value: &impl Serialize) -> Result<(), Failure> {
        self.print_with(|out| {
            serde_json::to_writer(&mut *out, value)?;
            out.write_all(b"\n")
        })
    }

    /// Lets `write` write to standard output.
    ///
    /// # Errors
    /// What the system says, except that the reader went away.
    pub(crate) fn print_with(&self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
        let printed = save::save(Path::new(STANDARD), |out| {
            // standard output by itself is written line by line
            let mut out = BufWriter::new(out);
            write(&mut out)?;
            out.flush()
        });
        match printed {
            Err(error) if error.cause != SaveCause::Closed => Err(Failure::Save(error)),
            Err(_) | Ok(()) => Ok(()),
        }
    }

    /// Writes to standard error. That nobody can be told of a failure there is no reason to fail.
    pub(crate) fn tell(&self, text: &str) {
        let mut stderr = io::stderr().lock();
        let _ = stderr.write_all(text.as_bytes()).and_then(|()| stderr.flush());
    }

    /// Tells of a failure, with the way out where there is one, and gives its exit code.
    pub(crate) fn fail(&self, failure: &Failure) -> Exit {
        if let Some(message) = failure.message(self.lang) {
            let mut text = format!("{} {message}\n", usage::error_prefix(self.lang));
            if let Some(help) = failure.help(self.lang) {
                text += &format!("  {} {help}\n", usage::help_prefix(self.lang));
            }
            self.tell(&text);
        }
        failure.exit()
    }

    /// Whether progress is shown: somebody looks, and wants it.
    pub(crate) fn shows_progress(&self) -> bool {
        !self.quiet && Stream::Errors.is_terminal()
    }
}

/// One of the two streams.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stream {
    /// Standard output.
    Output,
    /// Standard error.
    Errors,
}

impl Stream {
    /// Whether colours are shown: on a terminal, unless `NO_COLOR` says otherwise (no-color.org).
    pub(crate) fn has_colors(self) -> bool {
        self.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
    }

    /// The width for texts that are laid out: the terminal's, else 100 columns.
    pub(crate) fn width(self) -> usize {
        let size = match self {
            Stream::Output => terminal_size::terminal_size_of(io::stdout()),
            Stream::Errors => terminal_size::terminal_size_of(io::stderr()),
        };
        size.map_or(100, |(terminal_size::Width(columns), _)| usize::from(columns))
    }

    fn is_terminal(self) -> bool {
        match self {
            Stream::Output => io::stdout().is_terminal(),
            Stream::Errors => io::stderr().is_terminal(),
        }
    }
}

/// A value as one line of JSON.
pub(crate) fn json(value: &impl Serialize) -> String {
    // only maps with keys that are no strings and failing `Serialize` implementations fail, and we have neither
    serde_json::to_string(value).unwrap_or_default() + "\n"
}
