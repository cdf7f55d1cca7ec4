//! `lancer show SCENE`: the whole scene as text, which the subject asks for from the main program (§5.1); views too.

use crate::documents::{self, Content};
use crate::{Context, Exit, Failure, flags};
use clap::{ArgMatches, Command};
use lancer_formats::text;
use lancer_words::Lang;
use lancer_words::cli::help;

pub(crate) fn command(lang: Lang) -> Command {
    Command::new("show")
        .about(help::about_show(lang))
        .arg(flags::path("scene", lang, help::scene_value(lang), help::show_help(lang)).required(true))
        .args([flags::allow_outside(lang), flags::quiet(lang)])
}

pub(crate) fn run(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    let console = context.console.quiet_if(matches.get_flag("quiet"));
    let document = documents::read(flags::path_of(matches, "scene"), &flags::load_options(matches))?;
    let told = match document.accepted(&console)? {
        Content::Scene(scene) => text::describe(&scene, console.lang),
        Content::Views(views) => text::describe_views(&views, console.lang),
    };
    console.print(told).map(|()| Exit::Done)
}
