//! `lancer man [COMMAND]`: the manual page of the program or of a command, in roff, for `man -l -`.

use crate::commands::help;
use crate::{Context, Exit, Failure, command};
use clap::{ArgMatches, Command};
use lancer_words::Lang;
use lancer_words::cli::help as words;

/// What every page belongs to.
const PROGRAM: &str = concat!("lancer ", env!("CARGO_PKG_VERSION"));

pub(crate) fn command(lang: Lang) -> Command {
    Command::new("man").about(words::about_man(lang)).arg(help::command_argument(lang))
}

pub(crate) fn run(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    let lang = context.console.lang;
    let asked = help::asked_command(command::command(lang), matches);
    let mut page = Vec::new();
    // writing into memory cannot fail
    let _ = clap_mangen::Man::new(asked.disable_help_subcommand(true)).source(PROGRAM).render(&mut page);
    context.console.print(with_headings(&String::from_utf8_lossy(&page), lang)).map(|()| Exit::Done)
}

/// The page with its section headings in the language; the generator knows English ones only.
fn with_headings(page: &str, lang: Lang) -> String {
    let mut text = String::with_capacity(page.len());
    for line in page.lines() {
        let line = match line {
            ".SH NAME" => format!(".SH {}", words::man_name(lang)),
            ".SH SYNOPSIS" => format!(".SH {}", words::man_synopsis(lang)),
            ".SH DESCRIPTION" => format!(".SH {}", words::man_description(lang)),
            ".SH EXTRA" => format!(".SH {}", words::man_extra(lang)),
            ".SH VERSION" => format!(".SH {}", words::man_version(lang)),
            _ => line.to_owned(),
        };
        text += &line;
        text.push('\n');
    }
    text
}
