//! `lancer schema`: the published schema of scene and view documents, RELAX NG, for `xmllint --relaxng` and editors.

use crate::{Context, Exit, Failure};
use clap::{ArgMatches, Command};
use lancer_formats::xml;
use lancer_words::Lang;
use lancer_words::cli::help;

pub(crate) fn command(lang: Lang) -> Command {
    Command::new("schema").about(help::about_schema(lang))
}

pub(crate) fn run(_: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    context.console.print(xml::schema(context.console.lang)).map(|()| Exit::Done)
}
