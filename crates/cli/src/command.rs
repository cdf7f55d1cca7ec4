//! The program's command line as the parser sees it: one value, from which help, manual page and completions come too.

use crate::commands::{bench, check, completions, convert, diff, explain, generate, help, man, render, schema, show};
use crate::flags;
use clap::builder::{PossibleValuesParser, Styles};
use clap::{Arg, ArgAction, Command};
use lancer_words::Lang;
use lancer_words::cli::{bench as bench_words, generate as generate_words, help as words};

/// The whole command line in a language.
pub(crate) fn command(lang: Lang) -> Command {
    let subcommands = [
        (show::command(lang), words::usage_show(lang)),
        (check::command(lang), words::usage_check(lang)),
        (convert::command(lang), words::usage_convert(lang)),
        (explain::command(lang), words::usage_explain(lang)),
        (diff::command(lang), words::usage_diff(lang)),
        (generate::command(lang), generate_words::usage_generate(lang)),
        (bench::command(lang), bench_words::usage_bench(lang)),
        (schema::command(lang), words::usage_schema(lang)),
        (completions::command(lang), words::usage_completions(lang)),
        (man::command(lang), words::usage_man(lang)),
        (help::command(lang), words::usage_help(lang)),
    ];
    let program = Command::new("lancer")
        .bin_name("lancer")
        .version(env!("CARGO_PKG_VERSION"))
        .about(words::about(lang))
        .after_help(words::after_help(lang))
        .args(render::arguments(lang))
        .arg(
            Arg::new("version")
                .long("version")
                .short('V')
                .action(ArgAction::Version)
                .help(words::version_help(lang))
                .help_heading(words::options_heading(lang)),
        )
        .disable_version_flag(true)
        .disable_help_subcommand(true)
        .subcommand_help_heading(words::commands_heading(lang))
        .subcommand_value_name(words::command_value(lang))
        .args_conflicts_with_subcommands(true)
        .subcommand_negates_reqs(true)
        .styles(Styles::plain());
    let program = with_common_parts(program, words::usage(lang), lang);
    program.subcommands(subcommands.map(|(command, usage)| with_common_parts(command, usage, lang)))
}

/// What the program and each command have in common.
fn with_common_parts(command: Command, usage: String, lang: Lang) -> Command {
    let heading = words::usage_heading(lang);
    let mut place = 0;
    command
        .mut_args(|argument| {
            // under a heading of our own the parser would sort positional arguments by their names
            place += 1;
            if argument.is_positional() { argument.display_order(place) } else { argument }
        })
        .override_usage(usage)
        .help_template(format!("{{about}}\n\n{heading} {{usage}}\n\n{{all-args}}{{after-help}}"))
        .disable_help_flag(true)
        .arg(
            Arg::new("help")
                .long("help")
                .short('h')
                .action(ArgAction::Help)
                .help(words::help_help(lang))
                .help_heading(words::options_heading(lang)),
        )
        .arg(
            // taken out before the parser looks (see `language`); here for its place in help and for wrong values
            flags::option("lang", lang, words::lang_help(lang))
                .value_name("LANG")
                .value_parser(PossibleValuesParser::new(Lang::ALL.map(Lang::code)))
                .hide_possible_values(true),
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parser_finds_no_fault_in_it() {
        for lang in Lang::ALL {
            command(lang).debug_assert();
        }
    }
}
