//! `lancer help [COMMAND]`: the same as `--help`.

use crate::{Context, Exit, Failure, command, flags};
use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgMatches, Command};
use lancer_words::Lang;
use lancer_words::cli::help;

/// The commands that can be asked about.
const COMMANDS: [&str; 10] =
    ["show", "check", "convert", "explain", "diff", "generate", "bench", "schema", "completions", "man"];

pub(crate) fn command(lang: Lang) -> Command {
    Command::new("help").about(help::about_help(lang)).arg(command_argument(lang))
}

/// The argument that names a command.
pub(crate) fn command_argument(lang: Lang) -> Arg {
    flags::positional("command", lang, help::command_value(lang), help::command_help(lang))
        .value_parser(PossibleValuesParser::new(COMMANDS))
        .hide_possible_values(true)
}

/// The command that the argument names, else the whole program.
pub(crate) fn asked_command(mut program: Command, matches: &ArgMatches) -> Command {
    // names and usage of the commands are complete only once the whole is built
    program.build();
    let asked = matches.get_one::<String>("command").and_then(|name| program.find_subcommand(name)).cloned();
    asked.unwrap_or(program)
}

pub(crate) fn run(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    let mut asked = asked_command(command::command(context.console.lang), matches);
    context.console.print(asked.render_help().to_string()).map(|()| Exit::Done)
}
