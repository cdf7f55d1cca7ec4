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
        let mut command = command::command(context.console.lang);
        clap_complete::generate(shell, &mut command, "lancer", &mut script);
        script = match (shell, String::from_utf8(script)) {
            (Shell::Zsh, Ok(text)) => for_zsh(&text).into_bytes(),
            (Shell::Fish, Ok(text)) => for_fish(&text, &command).into_bytes(),
            (_, Ok(text)) => text.into_bytes(),
            (_, Err(error)) => error.into_bytes(),
        };
    }
    context.console.print(script).map(|()| Exit::Done)
}

/// The generator offers commands to zsh only behind the program's own arguments, where none can stand: a command is
/// offered beside the files that may be the scene, and what follows a scene are files and the program's options.
fn for_zsh(script: &str) -> String {
    const COMMANDS: &str = "\":: :_lancer_commands\" \\\n";
    const END: &str = "        esac\n    ;;\nesac\n}";
    const BEGIN: &str = "_arguments \"${_arguments_options[@]}\" : \\\n";
    let Some((head, tail)) = script.split_once(COMMANDS) else { return script.to_owned() };
    let Some((before, arguments)) = head.split_once(BEGIN) else { return script.to_owned() };
    let Some((branches, after)) = tail.split_once(END) else { return script.to_owned() };
    let is_positional = |line: &&str| line.starts_with("':");
    let options: String = arguments.split_inclusive('\n').filter(|line| !is_positional(line)).collect();
    let positions = arguments.lines().filter(is_positional).count();
    let branches = branches.replace(&format!("$line[{}]", positions + 1), "$line[1]");
    format!(
        "{before}{BEGIN}{options}\":: :{{_alternative 'commands::_lancer_commands' 'files::_files'}}\" \\\n{branches}\
         (*)\n{BEGIN}{options}'*:file:_files' \\\n&& ret=0\n;;\n{END}{after}"
    )
}

/// The generator offers the program's options to fish only before its first argument, and values of arguments that
/// are no options not at all.
fn for_fish(script: &str, program: &Command) -> String {
    let names: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
    let rendering = format!("-n \"not __fish_seen_subcommand_from {}\"", names.join(" "));
    let mut told: String = script
        .split_inclusive('\n')
        .map(|line| match line.contains("\" -l ") || line.contains("\" -s ") {
            true => line.replacen("-n \"__fish_lancer_needs_command\"", &rendering, 1),
            false => line.to_owned(),
        })
        .collect();
    for command in program.get_subcommands() {
        for argument in command.get_positionals() {
            let values: Vec<String> =
                argument.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect();
            if !values.is_empty() {
                let (name, values) = (command.get_name(), values.join(" "));
                told +=
                    &format!("complete -c lancer -n \"__fish_lancer_using_subcommand {name}\" -f -a \"{values}\"\n");
            }
        }
    }
    told
}
