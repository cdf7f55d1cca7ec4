//! stub
use crate::{Context, Exit, Failure};
use clap::{ArgMatches, Command};
use lancer_words::Lang;
use lancer_words::cli::help;
pub(crate) fn command(lang: Lang) -> Command {
    Command::new("schema").about(help::about_schema(lang))
}
pub(crate) fn run(_m: &ArgMatches, _c: &Context) -> Result<Exit, Failure> {
    unimplemented!()
}
