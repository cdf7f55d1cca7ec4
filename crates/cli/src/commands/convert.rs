//! `lancer convert IN OUT`: a scene or views to another document format, or a picture to another picture format.

use crate::console::Console;
use crate::documents::{self, Content};
use crate::form::{Form, Written};
use crate::{Context, Exit, Failure, flags, target};
use clap::{ArgMatches, Command, value_parser};
use lancer_formats::load::LoadOptions;
use lancer_formats::n7_2009;
use lancer_formats::picture::{self, Format};
use lancer_formats::save::{self, Origin, SceneFormat};
use lancer_formats::{nff, xml};
use lancer_scene::View;
use lancer_words::Lang;
use lancer_words::cli::help;
use std::path::{Path, PathBuf};

/// What the command line asks to be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wanted {
    Document(Form),
    Picture(Format),
}

pub(crate) fn command(lang: Lang) -> Command {
    Command::new("convert")
        .about(help::about_convert(lang))
        .args([
            flags::path("in", lang, help::input_value(lang), help::convert_in_help(lang)).required(true),
            flags::path("out", lang, help::converted_value(lang), help::convert_out_help(lang)).required(true),
        ])
        .args([
            flags::option("to", lang, help::convert_to_help(lang))
                .value_name(help::form_value(lang))
                .value_parser(["xml", "binary", "2009", "pov", "gltf", "glb"])
                .hide_possible_values(true),
            flags::switch("binary", lang, help::binary_help(lang)).conflicts_with("to"),
            flags::option("views", lang, help::convert_views_help(lang))
                .value_name(help::file_value(lang))
                .value_parser(value_parser!(PathBuf)),
            flags::view_name(lang),
            flags::quiet(lang),
            flags::allow_outside(lang),
        ])
}

pub(crate) fn run(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    let console = context.console.quiet_if(matches.get_flag("quiet"));
    let (input, output) = (flags::path_of(matches, "in"), flags::path_of(matches, "out"));
    let options = flags::load_options(matches);
    let form = wanted(matches, output)?;
    save::check(output).map_err(Failure::Save)?;
    let form = match form {
        Wanted::Picture(format) => {
            if let Ok(Some(_)) = documents::read(input, &options).map(|document| document.content) {
                return Err(Failure::NeedsRendering { path: output.to_owned() });
            }
            let picture = documents::picture(input, &console)?;
            target::write(output, context, |out| picture::write(&picture, format, out))?;
            return Ok(Exit::Done);
        }
        Wanted::Document(form) => form,
    };
    let mut document = documents::read(input, &options)?;
    // one file is scene and views
    let is_both = nff::is_nff(document.source.text.as_bytes());
    if output.to_string_lossy().ends_with(".view.xml") && is_both {
        // the output's name says which of them is meant
        document = documents::read_views(input, &options)?;
    }
    let written = match (document.accepted(&console)?, form) {
        (Content::Scene(scene), Form::Xml) => {
            // in the canonical layout, whatever the input's was
            let origin = Some(Origin { path: input, document: None });
            Written::whole(save::scene_bytes(&scene, SceneFormat::Xml, output, origin, options))
        }
        (Content::Scene(scene), form) => {
            form.of_scene(&scene, output, || camera(matches, is_both, &options, &console))?
        }
        (Content::Views(views), Form::Xml) => Written::whole(xml::write_views(&views).into_bytes()),
        (Content::Views(_), Form::Binary) => return Err(Failure::ViewsAsBinary),
        (Content::Views(views), Form::Of2009) => Written::of_2009(n7_2009::write_views(&views)),
        (Content::Views(_), Form::Povray | Form::Obj | Form::Gltf(_)) => {
            return Err(Failure::NeedsScene { path: output.to_owned() });
        }
    };
    written.save(output, &Context { console, ..context.clone() }).map(|()| Exit::Done)
}

/// The view that a scene with a camera gets: of the views that are named, of those of the scene's own file if it is both,
/// or of those beside the scene.
fn camera(matches: &ArgMatches, is_both: bool, options: &LoadOptions, console: &Console) -> Result<View, Failure> {
    let (input, output) = (flags::path_of(matches, "in"), flags::path_of(matches, "out"));
    let path = match matches.get_one::<PathBuf>("views") {
        Some(path) => path.clone(),
        None if is_both => input.to_owned(),
        None => {
            let beside = input.with_extension("view.xml");
            if target::is_standard(input) || !beside.is_file() {
                return Err(Failure::NeedsViews { path: output.to_owned(), beside });
            }
            beside
        }
    };
    let views = documents::views(&path, options, console)?;
    let name = matches.get_one::<String>("view").map(String::as_str);
    documents::view(&views, name, &path).map(|view| View::clone(view))
}

/// What is to be written, by `--to` or the extension of the output.
fn wanted(matches: &ArgMatches, output: &Path) -> Result<Wanted, Failure> {
    if let Some(form) = matches.get_one::<String>("to") {
        return Ok(Wanted::Document(match form.as_str() {
            "binary" => Form::Binary,
            "2009" => Form::Of2009,
            other => Form::of_extension(other).unwrap_or(Form::Xml),
        }));
    }
    if let Some(form) = Form::of_path(output) {
        return Ok(Wanted::Document(form));
    }
    match output.extension() {
        None if target::is_standard(output) => Ok(Wanted::Document(Form::Xml)),
        Some(_) => match Format::of_path(output, matches.get_flag("binary")) {
            Ok(format) => Ok(Wanted::Picture(format)),
            Err(_) => Err(Failure::UnknownForm { path: output.to_owned() }),
        },
        None => Err(Failure::UnknownForm { path: output.to_owned() }),
    }
}
