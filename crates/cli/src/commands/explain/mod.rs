//! `lancer explain SCENE VIEW X Y`: one pixel opened: the tree of its rays, every term, every ⊕, down to the byte.
//!
//! The tree is recorded by the reference tracer, whose every term can be told. Pictures are rendered by the engine, so
//! its colour stands beside the reference's: the explanation says itself whether it tells the picture's story.

mod json;
mod table;
mod text;

use crate::failure::PictureOf;
use crate::{Context, Exit, Failure, documents, flags};
use clap::{ArgMatches, Command};
use lancer_render::{RenderError, Tracing, render_pixel};
use lancer_scene::{Color, Scene, View, limits};
use lancer_trace::{Camera, PixelTree, Settings, Simd, World, explain};
use lancer_words::Lang;
use lancer_words::cli::help;

/// A pixel, and all that it depends on.
struct Explanation<'a> {
    scene: &'a Scene,
    view: &'a View,
    settings: Settings,
    pixel: PixelTree,
    /// What the engine says, and with which instructions.
    engine: (Color, Simd),
    x: u32,
    y: u32,
}

pub(crate) fn command(lang: Lang) -> Command {
    let place = |id: &'static str, name: &'static str, text: String| {
        flags::positional(id, lang, name.to_owned(), text)
            .required(true)
            .allow_negative_numbers(true)
            .value_parser(move |text: &str| flags::whole_number(lang, text, 0, u64::from(limits::PIXELS - 1)))
    };
    Command::new("explain")
        .about(help::about_explain(lang))
        .args([flags::scene(lang), flags::view(lang)])
        .args([place("x", "X", help::x_help(lang)), place("y", "Y", help::y_help(lang))])
        .arg(flags::view_name(lang))
        .args(flags::view_changes(lang))
        .args([
            flags::max_rays(lang),
            flags::number("levels", lang, help::levels_help(lang), 0, u64::from(limits::DEPTH)).conflicts_with("json"),
            flags::switch("json", lang, help::explain_json_help(lang)),
            flags::quiet(lang),
            flags::allow_outside(lang),
        ])
}

pub(crate) fn run(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    let console = context.console.quiet_if(matches.get_flag("quiet"));
    let simd = flags::simd()?;
    let options = flags::load_options(matches);
    let view_path = flags::path_of(matches, "view-file");
    let stage = documents::stage(flags::path_of(matches, "scene"), view_path, &options, &console)?;
    let name = matches.get_one::<String>("view").map(String::as_str);
    let view = flags::changed_view(documents::view(&stage.views, name, view_path)?, matches);
    let camera = Camera::new(&view).map_err(|rule| Failure::render(RenderError::View(rule), &view))?;
    let (x, y) = (flags::number_of(matches, "x").unwrap_or(0), flags::number_of(matches, "y").unwrap_or(0));
    if x >= view.width || y >= view.height {
        return Err(Failure::PixelOutside { x, y, picture: PictureOf::new(&view) });
    }

    let world = World::compile(&stage.scene);
    let mut settings = Settings::of(&world, &view);
    settings.max_rays = flags::number_of(matches, "max-rays").unwrap_or(settings.max_rays);
    let pixel = explain(&world, &camera, settings, (x, y), &context.cancel)
        .map_err(|error| Failure::render(RenderError::at((x, y), error), &view))?;
    let engine = render_pixel(&world, &camera, settings, Tracing::Engine(simd), (x, y), &context.cancel)
        .map_err(|error| Failure::render(error, &view))?;
    let explanation = Explanation { scene: &stage.scene, view: &view, settings, pixel, engine: (engine, simd), x, y };
    let levels = flags::number_of(matches, "levels");
    match matches.get_flag("json") {
        true => console.print_json(&json::json(&explanation))?,
        false => console.print_with(|out| text::write(&explanation, levels, console.lang, out))?,
    }
    Ok(Exit::Done)
}
