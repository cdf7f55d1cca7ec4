//! Complaints about the command line. In English they are the parser's own, but for one that would mislead; in French
//! they are put together here from what the parser found.

use crate::{Exit, console::Console};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use lancer_words::Lang;
use lancer_words::cli::usage as words;

/// Prints help or a version on standard output, a complaint on standard error.
pub(crate) fn answer(error: &clap::Error, console: &Console) -> Exit {
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => match console.print(error.render().to_string()) {
            Ok(()) => Exit::Done,
            Err(failure) => console.fail(&failure),
        },
        ErrorKind::InvalidValue
        | ErrorKind::UnknownArgument
        | ErrorKind::InvalidSubcommand
        | ErrorKind::NoEquals
        | ErrorKind::ValueValidation
        | ErrorKind::TooManyValues
        | ErrorKind::TooFewValues
        | ErrorKind::WrongNumberOfValues
        | ErrorKind::ArgumentConflict
        | ErrorKind::MissingRequiredArgument
        | ErrorKind::MissingSubcommand
        | ErrorKind::InvalidUtf8
        | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
        | ErrorKind::Io
        | ErrorKind::Format
        | _ => {
            match console.lang {
                Lang::English if !is_one_too_many(error) => console.tell(&error.render().to_string()),
                Lang::English | Lang::French => console.tell(&in_words(error, console.lang)),
            }
            Exit::Usage
        }
    }
}

/// The command that may have been meant by what was taken for a scene.
pub(crate) fn meant(lang: Lang, command: &str) -> String {
    format!("  {} {}\n", words::help_prefix(lang), words::meant_command(lang, command))
}

/// Whether a positional argument too many was found: the parser then takes it for a command that does not go with the
/// others.
fn is_one_too_many(error: &clap::Error) -> bool {
    error.kind() == ErrorKind::ArgumentConflict && error.get(ContextKind::InvalidSubcommand).is_some()
}

/// The complaint, the way out where the parser knows one, the form of the command.
fn in_words(error: &clap::Error, lang: Lang) -> String {
    let text = |kind| error.get(kind).map(strings).unwrap_or_default();
    let argument = text(ContextKind::InvalidArg).join(", ");
    let value = text(ContextKind::InvalidValue).join(", ");
    let message = match error.kind() {
        _ if is_one_too_many(error) => words::unknown_argument(lang, text(ContextKind::InvalidSubcommand).join(", ")),
        ErrorKind::UnknownArgument => words::unknown_argument(lang, argument),
        ErrorKind::InvalidSubcommand => words::unknown_command(lang, text(ContextKind::InvalidSubcommand).join(", ")),
        ErrorKind::InvalidValue if value.is_empty() => words::missing_value(lang, argument),
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => words::invalid_value(lang, value, argument),
        ErrorKind::NoEquals | ErrorKind::TooFewValues | ErrorKind::WrongNumberOfValues => {
            words::missing_value(lang, argument)
        }
        ErrorKind::TooManyValues => words::unknown_argument(lang, value),
        ErrorKind::ArgumentConflict => {
            let prior = text(ContextKind::PriorArg).join(", ");
            if prior == argument || prior.is_empty() {
                words::repeated_argument(lang, argument)
            } else {
                words::conflicting_arguments(lang, argument, prior)
            }
        }
        ErrorKind::MissingRequiredArgument => words::missing_arguments(lang, argument),
        ErrorKind::InvalidUtf8 => words::not_unicode(lang),
        ErrorKind::MissingSubcommand
        | ErrorKind::DisplayHelp
        | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
        | ErrorKind::DisplayVersion
        | ErrorKind::Io
        | ErrorKind::Format
        | _ => words::wrong_use(lang),
    };
    let mut complaint = format!("{} {message}", words::error_prefix(lang));
    if let Some(source) = std::error::Error::source(error) {
        complaint += &format!("{} {source}", words::colon(lang));
    }
    complaint.push('\n');
    let legal = text(ContextKind::ValidValue);
    if !legal.is_empty() {
        complaint += &format!("  {}\n", words::legal_values(lang, legal.join(", ")));
    }
    for kind in [ContextKind::SuggestedArg, ContextKind::SuggestedValue, ContextKind::SuggestedSubcommand] {
        for similar in text(kind) {
            complaint += &format!("  {}\n", words::similar(lang, similar));
        }
    }
    if let Some(ContextValue::StyledStr(usage)) = error.get(ContextKind::Usage) {
        // the form of the command is our own text, and in our language; the parser's heading is not
        let usage = usage.to_string();
        let heading = lancer_words::cli::help::usage_heading(lang);
        complaint += &format!("\n{heading}{}\n", usage.trim_start_matches("Usage:"));
    }
    complaint + "\n" + &words::see_help(lang) + "\n"
}

/// The strings of a piece of context.
fn strings(value: &ContextValue) -> Vec<String> {
    match value {
        ContextValue::None => Vec::new(),
        ContextValue::Bool(value) => vec![value.to_string()],
        ContextValue::String(value) => vec![value.clone()],
        ContextValue::Strings(values) => values.clone(),
        ContextValue::StyledStr(value) => vec![value.to_string()],
        ContextValue::StyledStrs(values) => values.iter().map(ToString::to_string).collect(),
        ContextValue::Number(value) => vec![value.to_string()],
        _ => Vec::new(),
    }
}
