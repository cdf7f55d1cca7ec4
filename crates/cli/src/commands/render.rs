//! `lancer SCENE VIEW [OUTPUT]`: the subject's contract (§5.3): two mandatory arguments, `output.ppm` by default.

use crate::console::Console;
use crate::failure::PictureOf;
use crate::stats::{PictureStats, Stats};
use crate::{Context, Exit, Failure, documents, flags, progress, target};
use clap::{Arg, ArgMatches};
use lancer_formats::picture;
use lancer_formats::save;
use lancer_render::{RenderOptions, Still, render_still};
use lancer_scene::{View, Views};
use lancer_trace::World;
use lancer_words::Lang;
use lancer_words::cli::help;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

/// Where the picture goes if nothing is said (subject §5.3).
const OUTPUT: &str = "output.ppm";

/// The arguments, which belong to the program itself.
pub(crate) fn arguments(lang: Lang) -> Vec<Arg> {
    let mut arguments = vec![
        flags::scene(lang),
        flags::view(lang),
        flags::path("output", lang, help::output_value(lang), help::output_help(lang, "ppm png exr qoi tiff bmp")),
        flags::view_name(lang),
        flags::switch("all-views", lang, help::all_views_help(lang)).conflicts_with("view"),
    ];
    arguments.extend(flags::view_changes(lang));
    arguments.extend([
        flags::adaptive(lang),
        flags::region(lang),
        flags::threads(lang),
        flags::engine(lang),
        flags::max_rays(lang),
        flags::binary(lang),
        flags::option("stats", lang, help::stats_help(lang))
            .value_name(help::form_value(lang))
            .num_args(0..=1)
            .require_equals(true)
            .default_missing_value("text")
            .value_parser(["text", "json"])
            .hide_possible_values(true),
        flags::quiet(lang),
        flags::allow_outside(lang),
    ]);
    arguments
}

pub(crate) fn run(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    let console = context.console.quiet_if(matches.get_flag("quiet"));
    let output = matches.get_one::<PathBuf>("output").map_or(Path::new(OUTPUT), PathBuf::as_path);
    if matches.get_flag("all-views") && target::is_standard(output) {
        return Err(Failure::AllViewsToStdout);
    }
    let tracing = flags::tracing(matches)?;
    let format = flags::picture_format(matches, output)?;

    let started = Instant::now();
    let view_path = flags::path_of(matches, "view-file");
    let scene_path = flags::path_of(matches, "scene");
    let stage = documents::stage(scene_path, view_path, &flags::load_options(matches), &console)?;
    let chosen = chosen(&stage.views, view_path, matches)?;
    // of the views as they stand: what the command line asks for is meant
    stage.warn(&chosen, &console);
    let read = started.elapsed();

    let options = RenderOptions {
        tracing,
        threads: flags::number_of(matches, "threads").and_then(NonZeroUsize::new),
        region: matches.get_one("region").copied(),
        max_rays: flags::number_of(matches, "max-rays"),
        adaptive: matches.get_one("adaptive").copied(),
        keep_linear: format.is_linear(),
    };
    let views: Vec<View> = chosen.iter().map(|view| flags::changed_view(view, matches)).collect();
    let outputs = match matches.get_flag("all-views") {
        true => target::for_all_views(output, &views)?,
        false => vec![output.to_owned()],
    };
    // everything that can be known to go wrong is told before the first ray
    views.iter().try_for_each(|view| check(view, &options))?;
    outputs.iter().try_for_each(|output| save::check(output).map_err(Failure::Save))?;

    let started = Instant::now();
    let world = World::compile(&stage.scene);
    let mut stats = Stats { version: 1, read, compile: started.elapsed(), pictures: Vec::new() };
    for (view, output) in views.iter().zip(&outputs) {
        let started = Instant::now();
        let still = render(&world, view, &options, context, &console)?;
        let rendered = started.elapsed();
        let started = Instant::now();
        target::write(output, context, |out| picture::write(&still.picture, format, out))?;
        stats.pictures.push(PictureStats::new(&view.name, output, &still, tracing, [rendered, started.elapsed()]));
    }
    tell(&stats, output, matches, &console)?;
    Ok(Exit::Done)
}

/// The views that are asked for: all of them, the one of a name, or the first.
fn chosen(views: &Views, path: &Path, matches: &ArgMatches) -> Result<Vec<Arc<View>>, Failure> {
    let name = matches.get_one::<String>("view").map(String::as_str);
    let one = documents::view(views, name, path)?;
    Ok(if matches.get_flag("all-views") { views.to_vec() } else { vec![Arc::clone(one)] })
}

/// Whether a view, as the command line has changed it, can be rendered.
fn check(view: &View, options: &RenderOptions) -> Result<(), Failure> {
    view.check().map_err(|rule| Failure::ViewInvalid { view: view.name.clone(), rule })?;
    if options.adaptive.is_some() && view.samples == 1 {
        return Err(Failure::AdaptiveOfOne { view: view.name.clone() });
    }
    match options.region.filter(|region| !region.lies_within(view.width, view.height)) {
        Some(region) => Err(Failure::RegionOutside { region, picture: PictureOf::new(view) }),
        None => Ok(()),
    }
}

/// Renders a view, with a progress bar for somebody who looks.
fn render(
    world: &World,
    view: &View,
    options: &RenderOptions,
    context: &Context,
    console: &Console,
) -> Result<Still, Failure> {
    let bar = progress::bar(console, &view.name);
    let still = render_still(world, view, options, &context.cancel, |done, all| {
        bar.set_length(all);
        bar.set_position(done);
    });
    bar.finish_and_clear();
    still.map_err(|error| Failure::render(error, view))
}

/// The statistics where they are asked for; else, for somebody who looks, where the pictures are.
fn tell(stats: &Stats, output: &Path, matches: &ArgMatches, console: &Console) -> Result<(), Failure> {
    match matches.get_one::<String>("stats").map(String::as_str) {
        // standard output may be the picture's
        Some(form) if target::is_standard(output) => console.tell(&stats.told(form == "json", console.lang)),
        Some(form) => console.print(stats.told(form == "json", console.lang))?,
        None if console.shows_progress() => {
            stats.pictures.iter().for_each(|picture| console.tell(&picture.summary(console.lang)));
        }
        None => {}
    }
    Ok(())
}
