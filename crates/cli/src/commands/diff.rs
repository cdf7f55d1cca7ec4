//! `lancer diff A B`: how many pixels of two pictures differ, where, and by how much.

use crate::{Context, Exit, Failure, documents, flags, target};
use clap::{ArgMatches, Command};
use lancer_formats::picture::{self, Difference, Format};
use lancer_formats::save;
use lancer_words::cli as words;
use lancer_words::cli::help;
use lancer_words::{Lang, number};
use std::path::PathBuf;

pub(crate) fn command(lang: Lang) -> Command {
    let file = |id, name: &str| flags::path(id, lang, name.to_owned(), help::diff_picture_help(lang)).required(true);
    Command::new("diff").about(help::about_diff(lang)).args([file("a", "A"), file("b", "B")]).args([
        flags::number("tolerance", lang, help::tolerance_help(lang), 0, 255),
        flags::option("output", lang, help::diff_output_help(lang))
            .short('o')
            .value_name(help::output_value(lang))
            .value_parser(clap::value_parser!(PathBuf)),
        flags::quiet(lang),
    ])
}

pub(crate) fn run(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    let console = context.console.quiet_if(matches.get_flag("quiet"));
    let output = match matches.get_one::<PathBuf>("output") {
        Some(path) => {
            save::check(path).map_err(Failure::Save)?;
            Some((path, Format::of_path(path, false).map_err(Failure::UnknownExtension)?))
        }
        None => None,
    };
    let [a, b] = ["a", "b"].map(|name| flags::path_of(matches, name));
    documents::read_once(a, b)?;
    let (first, second) = (documents::picture(a, &console)?, documents::picture(b, &console)?);
    let tolerance = flags::number_of(matches, "tolerance").unwrap_or(0);
    let (difference, drawn) = match picture::compare(&first, &second, tolerance) {
        Ok(compared) => compared,
        Err(sizes) => {
            console.print(sizes.message(console.lang) + "\n")?;
            return Ok(Exit::Wrong);
        }
    };
    if let Some((path, format)) = output {
        target::write(path, context, |out| picture::write(&drawn, format, out))?;
    }
    if !console.quiet {
        console.print(told(&difference, tolerance, console.lang))?;
    }
    Ok(if difference.differing == 0 { Exit::Done } else { Exit::Wrong })
}

/// The difference in words and, for the first places, in numbers.
fn told(difference: &Difference, tolerance: u8, lang: Lang) -> String {
    let Difference { pixels, differing, max, mean, bounds, first } = difference;
    let pixels_told = number::pixels(lang, *pixels);
    if *max == 0 {
        return words::diff_same(lang) + "\n";
    }
    if *differing == 0 {
        return words::diff_within(lang, pixels_told, tolerance, max) + "\n";
    }
    let percent = 100.0 * *differing as f64 / *pixels as f64;
    let mut text = words::diff_count(lang, differing, pixels_told, format!("{percent:.4}")) + "\n";
    text += &(words::diff_amount(lang, max, format!("{mean:.6}")) + "\n");
    if let Some(at) = bounds {
        text += &(words::diff_bounds(lang, at.x, at.x + at.width - 1, at.y, at.y + at.height - 1) + "\n");
    }
    text += &(words::diff_first(lang, first.len()) + "\n");
    let (column, row) = (words::diff_column(lang), words::diff_row(lang));
    text += &format!(
        "  {column:>7}  {row:>7}  {:<11}  B
",
        "A"
    );
    for place in first {
        let bytes = |bytes: [u8; 3]| bytes.map(|byte| format!("{byte:>3}")).join(" ");
        text += &format!("  {:>7}  {:>7}  {}  {}\n", place.x, place.y, bytes(place.first), bytes(place.second));
    }
    text
}
