//! House rules and chores as code: `cargo xtask test`, `cargo xtask ci`, `cargo xtask tidy`.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program for the terminal")]

mod chores;
mod documents;
mod tidy;

use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "\
cargo xtask COMMAND

  test   runs every test, after installing the Debian packages they use where they are missing
  ci     test, then formatting, lints and documentation
  tidy   checks the house rules alone
";

fn main() -> ExitCode {
    let root = root();
    let done = match std::env::args().nth(1).as_deref() {
        Some("test") => chores::test(root),
        Some("ci") => chores::ci(root),
        Some("tidy") => tidy::report(root),
        Some(_) | None => Err(USAGE.to_owned()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// The root of the checkout.
fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}
