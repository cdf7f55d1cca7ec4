//! House rules and chores as code: `cargo xtask test`, `cargo xtask ci`, `cargo xtask tidy`,
//! `cargo xtask instructions`.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program for the terminal")]

mod chores;
mod documents;
mod instructions;
mod tidy;

use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "\
cargo xtask COMMAND

  test          runs every test, after installing the Debian packages they use where they are missing
  ci            test, then formatting, lints, documentation and the count of instructions
  tidy          checks the house rules alone
  instructions  counts the instructions of small pictures and compares with the record in benches;
                with --renew writes the record
";

fn main() -> ExitCode {
    let root = root();
    let done = match std::env::args().nth(1).as_deref() {
        Some("test") => chores::test(root),
        Some("ci") => chores::ci(root),
        Some("tidy") => tidy::report(root),
        Some("instructions") => match std::env::args().nth(2).as_deref() {
            Some("--renew") => instructions::renew(root),
            None => instructions::compare(root),
            Some(_) => Err(USAGE.to_owned()),
        },
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
