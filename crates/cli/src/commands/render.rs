//! `lancer SCENE VIEW [OUTPUT]`: the subject's contract (§5.3): two mandatory arguments, `output.ppm` by default.

use crate::failure::PictureOf;
use crate::stats::{PictureStats, Stats, StatsForm};
use crate::{Context, Exit, Failure, documents, flags, progress, target};
use clap::{Arg, ArgMatches};
use lancer_formats::picture::{self, Format};
use lancer_formats::save;
use lancer_render::{RenderOptions, Still, render_still};
use lancer_trace::World;
use lancer_words::Lang;
use lancer_words::cli::help;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Where the picture goes if nothing is said (subject §5.3).
const OUTPUT: &str = "output.ppm";

/// The most threads that can be asked for: far more than any machine has, far fewer than the system refuses.
const MOST_THREADS: u64 = 1024;

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
        flags::region(lang),
        flags::number("threads", lang, help::threads_help(lang), 1, MOST_THREADS),
        flags::max_rays(lang),
        flags::switch("binary", lang, help::binary_help(lang)),
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
    let binary = matches.get_flag("binary");
    let all_views = matches.get_flag("all-views");
    if all_views && target::is_standard(output) {
        return Err(Failure::AllViewsToStdout);
    }
    let stats_form = matches.get_one::<String>("stats").map(|form| match form.as_str() {
        "json" => StatsForm::Json,
        _ => StatsForm::Text,
    });
    let format = Format::of_path(output, binary).map_err(Failure::UnknownExtension)?;

    let started = Instant::now();
    let options = flags::load_options(matches);
    let scene = documents::scene(flags::path_of(matches, "scene"), &options, &console)?;
    let view_path = flags::path_of(matches, "view-file");
    let views = documents::views(view_path, &options, &console)?;
    let chosen = match all_views {
        true => views.iter().map(|view| flags::changed_view(view, matches)).collect(),
        false => {
            let name = matches.get_one::<String>("view").map(String::as_str);
            vec![flags::changed_view(documents::view(&views, name, view_path)?, matches)]
        }
    };
    let read = started.elapsed();

    let render = RenderOptions {
        threads: flags::number_of(matches, "threads").and_then(NonZeroUsize::new),
        region: matches.get_one("region").copied(),
        max_rays: flags::number_of(matches, "max-rays"),
        keep_linear: format.is_linear(),
    };
    for view in &chosen {
        documents::check_view(view)?;
        if let Some(region) = render.region.filter(|region| !region.lies_within(view.width, view.height)) {
            return Err(Failure::RegionOutside { region, picture: PictureOf::new(view) });
        }
    }
    let outputs = match all_views {
        true => target::for_all_views(output, &chosen)?,
        false => vec![output.to_owned()],
    };
    for output in &outputs {
        save::check(output).map_err(Failure::Save)?;
    }

    let started = Instant::now();
    let world = World::compile(&scene);
    let mut stats = Stats { version: 1, read, compile: started.elapsed(), pictures: Vec::new() };
    for (view, output) in chosen.iter().zip(&outputs) {
        let bar = progress::bar(&console, &view.name, 1);
        let started = Instant::now();
        let still: Still = render_still(&world, view, &render, &context.cancel, |done, all| {
            bar.set_length(all);
            bar.set_position(done);
        })
        .map_err(|error| Failure::render(error, view))?;
        bar.finish_and_clear();
        let rendered = started.elapsed();
        let started = Instant::now();
        target::write(output, context, |out| picture::write(&still.picture, format, out))?;
        stats.pictures.push(PictureStats::new(&view.name, output, &still, rendered, started.elapsed()));
    }
    if let Some(form) = stats_form {
        let told = stats.told(form, console.lang);
        match target::is_standard(output) {
            true => console.tell(&told),
            false => console.print(told)?,
        }
    } else if console.shows_progress() {
        stats.pictures.iter().for_each(|picture| console.tell(&picture.summary(console.lang)));
    }
    Ok(Exit::Done)
}
