//! The arguments that several commands share: each one is a function that describes it to the parser, and where it
//! needs one, a function that takes its value out again.

use crate::Failure;
use clap::{Arg, ArgAction, ArgMatches, value_parser};
use lancer_formats::load::LoadOptions;
use lancer_formats::picture::Format;
use lancer_render::{Region, Tracing};
use lancer_scene::{Steps, View, limits};
use lancer_trace::Simd;
use lancer_words::Lang;
use lancer_words::cli::{help, usage};
use std::path::{Path, PathBuf};

/// A positional argument.
pub(crate) fn positional(id: &'static str, lang: Lang, value_name: String, text: String) -> Arg {
    Arg::new(id).value_name(value_name).help(text).help_heading(help::arguments_heading(lang))
}

/// A positional argument that is a path.
pub(crate) fn path(id: &'static str, lang: Lang, value_name: String, text: String) -> Arg {
    positional(id, lang, value_name, text).value_parser(value_parser!(PathBuf))
}

/// The value of an argument that is a path and is always there.
pub(crate) fn path_of<'a>(matches: &'a ArgMatches, id: &str) -> &'a Path {
    matches.get_one::<PathBuf>(id).map_or(Path::new(""), PathBuf::as_path)
}

/// An option.
pub(crate) fn option(id: &'static str, lang: Lang, text: String) -> Arg {
    Arg::new(id).long(id).help(text).help_heading(help::options_heading(lang))
}

/// An option without a value.
pub(crate) fn switch(id: &'static str, lang: Lang, text: String) -> Arg {
    option(id, lang, text).action(ArgAction::SetTrue)
}

/// An option whose value is a whole number within a range.
pub(crate) fn number(id: &'static str, lang: Lang, text: String, min: u64, max: u64) -> Arg {
    option(id, lang, text).value_name("N").value_parser(move |text: &str| whole_number(lang, text, min, max))
}

/// A whole number within a range, or what is due instead.
pub(crate) fn whole_number(lang: Lang, text: &str, min: u64, max: u64) -> Result<u64, String> {
    text.parse().ok().filter(|number| (min..=max).contains(number)).ok_or_else(|| match max {
        u64::MAX => usage::bad_count(lang, min),
        _ => usage::bad_number(lang, min, max),
    })
}

/// The value of an option that is a number and fits where it is used, because its range says so.
pub(crate) fn number_of<T: TryFrom<u64>>(matches: &ArgMatches, id: &str) -> Option<T> {
    matches.get_one::<u64>(id).and_then(|number| T::try_from(*number).ok())
}

/// The scene's document.
pub(crate) fn scene(lang: Lang) -> Arg {
    path("scene", lang, help::scene_value(lang), help::scene_help(lang)).required(true)
}

/// The views' document.
pub(crate) fn view(lang: Lang) -> Arg {
    path("view-file", lang, help::view_value(lang), help::view_help(lang)).required(true)
}

/// `--allow-outside`.
pub(crate) fn allow_outside(lang: Lang) -> Arg {
    switch("allow-outside", lang, help::allow_outside_help(lang))
}

/// How documents are read.
pub(crate) fn load_options(matches: &ArgMatches) -> LoadOptions {
    LoadOptions { allow_outside: matches.get_flag("allow-outside"), ..LoadOptions::default() }
}

/// `--quiet`.
pub(crate) fn quiet(lang: Lang) -> Arg {
    switch("quiet", lang, help::quiet_help(lang)).short('q')
}

/// `--view NAME`.
pub(crate) fn view_name(lang: Lang) -> Arg {
    option("view", lang, help::view_name_help(lang)).value_name(help::name_value(lang))
}

/// The most threads that can be asked for: far more than any machine has, far fewer than the system refuses.
const MOST_THREADS: u64 = 1024;

/// `--threads N`.
pub(crate) fn threads(lang: Lang) -> Arg {
    number("threads", lang, help::threads_help(lang), 1, MOST_THREADS)
}

/// `--max-rays N`.
pub(crate) fn max_rays(lang: Lang) -> Arg {
    number("max-rays", lang, help::max_rays_help(lang, lancer_trace::Settings::MAX_RAYS), 1, u64::MAX)
}

/// `--engine NAME`.
pub(crate) fn engine(lang: Lang) -> Arg {
    option("engine", lang, help::engine_help(lang))
        .value_name(help::name_value(lang))
        .value_parser(["simd", "reference"])
        .hide_possible_values(true)
}

/// The picture's form for those who do not want it as text.
pub(crate) fn binary(lang: Lang) -> Arg {
    switch("binary", lang, help::binary_help(lang))
}

/// The format of a picture: that of its name, in the form that [`binary`] asks for.
///
/// # Errors
/// The name means no picture, or one that has no such form.
pub(crate) fn picture_format(matches: &ArgMatches, output: &Path) -> Result<Format, Failure> {
    let is_binary = matches.get_flag("binary");
    match Format::of_path(output, is_binary).map_err(Failure::UnknownExtension)? {
        format if is_binary && format != Format::RawPpm => Err(Failure::BinaryOfAnother { path: output.to_owned() }),
        format => Ok(format),
    }
}

/// What follows the rays.
///
/// # Errors
/// What the environment asks for is not there, even if the reference needs none of it.
pub(crate) fn tracing(matches: &ArgMatches) -> Result<Tracing, Failure> {
    let simd = simd()?;
    Ok(match matches.get_one::<String>("engine").map(String::as_str) {
        Some("reference") => Tracing::Reference,
        Some(_) | None => Tracing::Engine(simd),
    })
}

/// The instructions that the environment asks for, or the best that this machine has.
///
/// # Errors
/// They are not there.
pub(crate) fn simd() -> Result<Simd, Failure> {
    let name = std::env::var_os(Tracing::VARIABLE).unwrap_or_default();
    Tracing::simd_named(&name.to_string_lossy()).map_err(Failure::Simd)
}

/// `--adaptive T`.
pub(crate) fn adaptive(lang: Lang) -> Arg {
    option("adaptive", lang, help::adaptive_help(lang))
        .value_name("T")
        .value_parser(move |text: &str| threshold(text).ok_or_else(|| usage::bad_threshold(lang)))
}

/// A number from 0 to 1.
fn threshold(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number| (0.0..=1.0).contains(number))
}

/// The options that change a view: `--size`, `--depth`, `--samples`, `--without`.
pub(crate) fn view_changes(lang: Lang) -> [Arg; 4] {
    [
        option("size", lang, help::size_help(lang))
            .value_name(help::size_value(lang))
            .value_parser(move |text: &str| size(text).ok_or_else(|| usage::bad_size(lang))),
        number("depth", lang, help::depth_help(lang), 0, u64::from(limits::DEPTH)),
        number("samples", lang, help::samples_help(lang), 1, u64::from(limits::SAMPLES)),
        option("without", lang, help::without_help(lang))
            .value_name(help::list_value(lang))
            .value_parser(move |text: &str| steps_without(text).ok_or_else(|| usage::bad_step(lang))),
    ]
}

/// The view with the changes that the command line asks for.
pub(crate) fn changed_view(view: &View, matches: &ArgMatches) -> View {
    let mut view = view.clone();
    if let Some(&(width, height)) = matches.get_one::<(u32, u32)>("size") {
        (view.width, view.height) = (width, height);
    }
    if let Some(depth) = number_of(matches, "depth") {
        view.depth = Some(depth);
    }
    if let Some(samples) = number_of(matches, "samples") {
        view.samples = samples;
    }
    if let Some(without) = matches.get_one::<Steps>("without") {
        // A step that the document leaves out stays left out.
        view.steps.shadows &= without.shadows;
        view.steps.reflection &= without.reflection;
        view.steps.transparency &= without.transparency;
    }
    view
}

/// `640x480`; a multiplication sign does too.
pub(crate) fn size(text: &str) -> Option<(u32, u32)> {
    let (width, height) = text.split_once(['x', 'X', '×'])?;
    let pixels = |text: &str| text.parse().ok().filter(|pixels| (1..=limits::PIXELS).contains(pixels));
    Some((pixels(width)?, pixels(height)?))
}

/// The steps that are left when those of a list are taken away.
fn steps_without(list: &str) -> Option<Steps> {
    let mut steps = Steps::default();
    for name in list.split(',') {
        match name.trim() {
            "shadows" => steps.shadows = false,
            "reflection" => steps.reflection = false,
            "transparency" => steps.transparency = false,
            _ => return None,
        }
    }
    Some(steps)
}

/// `--region X,Y,W,H`.
pub(crate) fn region(lang: Lang) -> Arg {
    option("region", lang, help::region_help(lang))
        .value_name(help::region_value(lang))
        .value_parser(move |text: &str| region_of(text).ok_or_else(|| usage::bad_region(lang)))
}

/// Four whole numbers, the last two of them at least 1.
fn region_of(text: &str) -> Option<Region> {
    let numbers: Vec<u32> = text.split(',').map(|number| number.trim().parse().ok()).collect::<Option<_>>()?;
    match numbers.as_slice() {
        &[x, y, width, height] if width > 0 && height > 0 => Some(Region { x, y, width, height }),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!(size("640x480"), Some((640, 480)));
        assert_eq!(size("1×65535"), Some((1, 65_535)));
        for wrong in ["", "640", "640x", "0x1", "1x65536", "640x480x3", "-1x2", "6.5x4", "640 x 480"] {
            assert_eq!(size(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn thresholds() {
        assert_eq!(threshold("0.05"), Some(0.05));
        assert_eq!((threshold("0"), threshold("1")), (Some(0.0), Some(1.0)));
        for wrong in ["", "0,05", "-0.1", "1.01", "nan", "inf", "5%"] {
            assert_eq!(threshold(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn regions() {
        assert_eq!(region_of("1, 2,3 ,4"), Some(Region { x: 1, y: 2, width: 3, height: 4 }));
        for wrong in ["", "1,2,3", "1,2,3,4,5", "1,2,0,4", "1,2,3,0", "-1,2,3,4", "1;2;3;4"] {
            assert_eq!(region_of(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn steps() {
        let all = Steps::default();
        assert_eq!(steps_without("shadows"), Some(Steps { shadows: false, ..all }));
        let neither = Steps { reflection: false, transparency: false, ..all };
        assert_eq!(steps_without("transparency, reflection"), Some(neither));
        assert_eq!(steps_without("mirrors"), None);
        assert_eq!(steps_without(""), None);
    }
}
