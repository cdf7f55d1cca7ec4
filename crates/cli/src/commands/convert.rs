//! `lancer convert IN OUT`: a scene or views to another document format, or a picture to another picture format.

use crate::documents::{self, Content};
use crate::{Context, Exit, Failure, flags, target};
use clap::{ArgMatches, Command};
use lancer_formats::load::{FolderOfDocument, LoadOptions};
use lancer_formats::mesh::MeshFiles;
use lancer_formats::n7_2009::{self, Loss, N7Problem};
use lancer_formats::picture::{self, Format};
use lancer_formats::{Diagnostic, Source, binary, nff, save, xml};
use lancer_scene::{Mesh, Object, Scene, Shape};
use lancer_words::Lang;
use lancer_words::cli::help;
use std::path::Path;
use std::sync::Arc;

/// A format that a document can be written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// The native documents.
    Xml,
    /// The binary scenes.
    Binary,
    /// The documents of 2009.
    Of2009,
}

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
                .value_parser(["xml", "binary", "2009"])
                .hide_possible_values(true),
            flags::switch("binary", lang, help::binary_help(lang)).conflicts_with("to"),
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
    if output.to_string_lossy().ends_with(".view.xml") && nff::is_nff(document.source.text.as_bytes()) {
        // one file is scene and views: the output's name says which of them is meant
        document = documents::read_views(input, &options)?;
    }
    let (bytes, losses) = match (document.accepted(&console)?, form) {
        (Content::Scene(scene), Form::Xml) => {
            (xml::write_scene(&with_files_of(output, &scene, options)).into_bytes(), Vec::new())
        }
        (Content::Scene(scene), Form::Binary) => (binary::write_scene(&scene), Vec::new()),
        (Content::Scene(scene), Form::Of2009) => written(n7_2009::write_scene(&scene)),
        (Content::Views(views), Form::Xml) => (xml::write_views(&views).into_bytes(), Vec::new()),
        (Content::Views(_), Form::Binary) => return Err(Failure::ViewsAsBinary),
        (Content::Views(views), Form::Of2009) => written(n7_2009::write_views(&views)),
    };
    let source = Source { name: output.display().to_string().into(), text: "".into() };
    documents::tell(&source, &losses, &console);
    target::write_document(output, context, &bytes)?;
    Ok(Exit::Done)
}

/// A document of 2009 and what it cannot hold.
fn written((text, losses): (String, Vec<Loss>)) -> (Vec<u8>, Vec<Diagnostic>) {
    let warning = |loss| Diagnostic::warning(None, N7Problem::Loss(loss));
    (text.into_bytes(), losses.into_iter().map(warning).collect())
}

/// What is to be written, by `--to` or the extension of the output.
fn wanted(matches: &ArgMatches, output: &Path) -> Result<Wanted, Failure> {
    if let Some(form) = matches.get_one::<String>("to") {
        return Ok(Wanted::Document(match form.as_str() {
            "binary" => Form::Binary,
            "2009" => Form::Of2009,
            _ => Form::Xml,
        }));
    }
    match output.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase()).as_deref() {
        Some("xml") => Ok(Wanted::Document(Form::Xml)),
        Some("lancer") => Ok(Wanted::Document(Form::Binary)),
        None if target::is_standard(output) => Ok(Wanted::Document(Form::Xml)),
        Some(_) => match Format::of_path(output, matches.get_flag("binary")) {
            Ok(format) => Ok(Wanted::Picture(format)),
            Err(_) => Err(Failure::UnknownForm { path: output.to_owned() }),
        },
        None => Err(Failure::UnknownForm { path: output.to_owned() }),
    }
}

/// The scene as a document at `output` can hold it. A mesh stays the name of its file where that file, seen from the
/// new document's folder, is the same mesh; elsewhere its vertices are written out.
fn with_files_of(output: &Path, scene: &Scene, options: LoadOptions) -> Scene {
    let mut files = FolderOfDocument::new(output, options);
    let mut is_there = |mesh: &Mesh, path: &str, has_material: bool| {
        files.read(path).is_ok_and(|file| match has_material {
            true => *file.without_materials() == *mesh.geometry,
            false => *file.geometry == *mesh.geometry,
        })
    };
    let objects = scene.objects.iter().map(|object| match &object.shape {
        Shape::Mesh(mesh) => match &mesh.source {
            Some(path) if !is_there(mesh, path, object.material != lancer_scene::MaterialRef::Default) => {
                let shape = Shape::Mesh(Mesh { source: None, ..mesh.clone() });
                Arc::new(Object { shape, ..Object::clone(object) })
            }
            Some(_) | None => Arc::clone(object),
        },
        Shape::Sphere { .. }
        | Shape::Plane { .. }
        | Shape::Facet { .. }
        | Shape::Cube { .. }
        | Shape::Parallelepiped { .. }
        | Shape::Cone { .. } => Arc::clone(object),
    });
    Scene { objects: objects.collect(), ..scene.clone() }
}
