//! The command-line program `lancer`: a scene and a view in, an exact picture out; and what goes with it.
//!
//! A command is one file of `commands`; it describes its arguments and runs with them. Everything that is printed goes
//! through the `console`, and every failure is handled once, in [`run`], where it becomes a message and an exit code.

mod command;
mod commands;
mod console;
mod documents;
mod exit;
mod failure;
mod flags;
mod form;
mod interrupt;
mod language;
mod mistyped;
mod progress;
pub mod report;
mod stats;
mod target;
mod usage;

pub use exit::Exit;
pub(crate) use failure::Failure;

use clap::ArgMatches;
use console::Console;
use interrupt::Writing;
use lancer_trace::Cancel;
use std::ffi::OsString;
use std::process::ExitCode;

/// What every command needs beside its arguments.
#[derive(Clone, Debug)]
pub(crate) struct Context {
    /// Where it speaks, and in which language.
    pub(crate) console: Console,
    /// Raised when the program is asked to stop.
    pub(crate) cancel: Cancel,
    /// Held while a temporary file exists.
    pub(crate) writing: Writing,
}

/// Runs the program with its arguments, the first of which is its own name.
pub fn run(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    let (lang, args) = language::choose(args);
    let console = Console { lang, quiet: false };
    let (cancel, writing) = match interrupt::install() {
        Ok(flags) => flags,
        Err(error) => return console.fail(&Failure::Signals(error.to_string())).into(),
    };
    let command = command::command(lang);
    let meant = mistyped::meant(&args, command.get_subcommands().map(clap::Command::get_name)).map(str::to_owned);
    let exit = match command.try_get_matches_from(args) {
        Err(error) => usage::answer(&error, &console),
        Ok(matches) => {
            let context = Context { console, cancel, writing };
            dispatch(&matches, &context).unwrap_or_else(|failure| console.fail(&failure))
        }
    };
    if let Some(command) = meant.filter(|_| exit != Exit::Done && exit != Exit::Interrupted) {
        console.tell(&usage::meant(lang, &command));
    }
    exit.into()
}

/// Runs the command that the arguments name.
fn dispatch(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    match matches.subcommand() {
        Some(("show", matches)) => commands::show::run(matches, context),
        Some(("check", matches)) => commands::check::run(matches, context),
        Some(("convert", matches)) => commands::convert::run(matches, context),
        Some(("explain", matches)) => commands::explain::run(matches, context),
        Some(("diff", matches)) => commands::diff::run(matches, context),
        Some(("generate", matches)) => commands::generate::run(matches, context),
        Some(("bench", matches)) => commands::bench::run(matches, context),
        Some(("schema", matches)) => commands::schema::run(matches, context),
        Some(("completions", matches)) => commands::completions::run(matches, context),
        Some(("man", matches)) => commands::man::run(matches, context),
        Some(("help", matches)) => commands::help::run(matches, context),
        Some((_, _)) | None => commands::render::run(matches, context),
    }
}
