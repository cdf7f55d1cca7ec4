//! `lancer bench`: how fast the tracer is, on generated scenes that are the same everywhere. One table, or JSON; or the
//! same scenes and rays as files, so that other programs can be measured with them.

mod case;
mod cast;
mod export;
mod measure;
mod rays;
mod report;
mod timing;

use crate::{Context, Exit, Failure, flags};
use case::Case;
use clap::{ArgAction, ArgMatches, Command, value_parser};
use lancer_words::Lang;
use lancer_words::cli::{bench as words, help};
use measure::Conditions;
use rayon::ThreadPool;
use report::Report;
use std::path::PathBuf;

/// The size of the pictures where none is given.
const SIZE: (u32, u32) = (1920, 1080);
/// The most pixels: their rays take about two hundred and fifty bytes for each.
const MOST_PIXELS: u64 = 1 << 23;
/// How often each thing is measured where nothing is said.
const REPEAT: usize = 5;

pub(crate) fn command(lang: Lang) -> Command {
    let fixed: Vec<String> = Case::fixed().into_iter().map(Case::name).collect();
    Command::new("bench")
        .about(words::about_bench(lang))
        .after_help(words::after_bench(lang, fixed.join(" ")))
        .arg(
            flags::positional("names", lang, help::name_value(lang), words::names_help(lang, case::names()))
                .value_parser(move |text: &str| Case::asked(lang, text))
                .action(ArgAction::Append)
                .num_args(0..),
        )
        .args([
            flags::option("size", lang, words::size_help(lang, SIZE.0, SIZE.1))
                .value_name(help::size_value(lang))
                .value_parser(move |text: &str| size(text).ok_or_else(|| words::too_many_pixels(lang, MOST_PIXELS))),
            flags::threads(lang),
            flags::number("repeat", lang, words::repeat_help(lang, REPEAT), 1, 1000),
            flags::switch("json", lang, words::json_help(lang)),
            flags::option("export", lang, words::export_help(lang))
                .value_name(help::folder_value(lang))
                .value_parser(value_parser!(PathBuf))
                .conflicts_with_all(["json", "repeat"]),
            flags::quiet(lang),
        ])
}

/// A size whose rays fit into memory.
fn size(text: &str) -> Option<(u32, u32)> {
    flags::size(text).filter(|&(width, height)| u64::from(width) * u64::from(height) <= MOST_PIXELS)
}

pub(crate) fn run(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    let context = Context { console: context.console.quiet_if(matches.get_flag("quiet")), ..context.clone() };
    let mut cases = Vec::new();
    for case in matches.get_many::<Vec<Case>>("names").into_iter().flatten().flatten() {
        if !cases.contains(case) {
            cases.push(*case);
        }
    }
    if cases.is_empty() {
        cases = Case::fixed();
    }
    let size = matches.get_one("size").copied().unwrap_or(SIZE);
    let pool = pool(flags::number_of(matches, "threads").unwrap_or(0))?;
    if let Some(folder) = matches.get_one::<PathBuf>("export") {
        return export::export(folder, &cases, size, &pool, &context).map(|()| Exit::Done);
    }
    if cfg!(debug_assertions) && !context.console.quiet {
        context.console.tell(&(words::unoptimised(context.console.lang) + "\n"));
    }
    let repeat = flags::number_of(matches, "repeat").unwrap_or(REPEAT);
    let conditions = Conditions { size, repeat, pool: &pool, simd: flags::simd()?, context: &context };
    let measured = cases.into_iter().map(|case| measure::measure(case, &conditions)).collect::<Result<Vec<_>, _>>()?;
    let report = Report::new(size, pool.current_num_threads(), repeat, &measured);
    match matches.get_flag("json") {
        true => context.console.print_json(&report)?,
        false => context.console.print(report.text(context.console.lang))?,
    }
    Ok(Exit::Done)
}

/// A pool of that many threads; of 0, of as many as the machine offers.
fn pool(threads: usize) -> Result<ThreadPool, Failure> {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| Failure::Threads(error.to_string()))
}
