//! `lancer completions SHELL`: the script that makes a shell complete the program's arguments.

use crate::{Context, Exit, Failure, command, flags};
use clap::builder::EnumValueParser;
use clap::{ArgMatches, Command};
use clap_complete::Shell;
use lancer_words::Lang;
use lancer_words::cli::help;

pub(crate) fn command(lang: Lang) -> Command {
    Command::new("completions").about(help::about_completions(lang)).arg(
        flags::positional("shell", lang, "SHELL".to_owned(), help::shell_help(lang))
            .value_parser(EnumValueParser::<Shell>::new())
            .hide_possible_values(true)
            .required(true),
    )
}

pub(crate) fn run(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    let mut script = Vec::new();
    if let Some(&shell) = matches.get_one::<Shell>("shell") {
        clap_complete::generate(shell, &mut command::command(context.console.lang), "lancer", &mut script);
    }
    context.console.print(script).map(|()| Exit::Done)
}
