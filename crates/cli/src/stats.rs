//! What `--stats` tells: the time of each stage, and the rays by kind.

use crate::console;
use lancer_render::{Still, Tracing};
use lancer_trace::RayCounts;
use lancer_words::cli as words;
use lancer_words::{Lang, number};
use serde::Serialize;
use std::path::Path;
use std::time::Duration;

/// The stages of a run. In JSON, version 1: durations are seconds; later versions may add members.
#[derive(Debug, Serialize)]
pub(crate) struct Stats {
    pub(crate) version: u32,
    /// Reading and checking both documents.
    #[serde(serialize_with = "seconds")]
    pub(crate) read: Duration,
    /// Compiling the scene.
    #[serde(serialize_with = "seconds")]
    pub(crate) compile: Duration,
    /// One for each picture.
    pub(crate) pictures: Vec<PictureStats>,
}

/// One picture.
#[derive(Debug, Serialize)]
pub(crate) struct PictureStats {
    pub(crate) view: String,
    /// The path as it was given, `-` for standard output.
    pub(crate) output: String,
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) threads: usize,
    /// `simd` or `reference`.
    pub(crate) engine: &'static str,
    /// Those of the engine `simd`: `portable`, `avx2` or `avx512`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) instructions: Option<&'static str>,
    #[serde(serialize_with = "seconds")]
    pub(crate) render: Duration,
    #[serde(serialize_with = "seconds")]
    pub(crate) write: Duration,
    /// With adaptive samples, how many pixels got all of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) refined: Option<u64>,
    pub(crate) rays: Rays,
}

/// Rays by kind.
#[derive(Debug, Serialize)]
pub(crate) struct Rays {
    total: u64,
    primary: u64,
    /// Primary rays that met an object.
    primary_hits: u64,
    reflected: u64,
    refracted: u64,
    shadow: u64,
}

impl From<RayCounts> for Rays {
    fn from(counts: RayCounts) -> Rays {
        let RayCounts { primary, primary_hits, reflected, refracted, shadow } = counts;
        Rays { total: counts.total(), primary, primary_hits, reflected, refracted, shadow }
    }
}

fn seconds<S: serde::Serializer>(duration: &Duration, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(duration.as_secs_f64())
}

impl PictureStats {
    /// The figures of a finished picture.
    pub(crate) fn new(
        view: &str,
        output: &Path,
        still: &Still,
        tracing: Tracing,
        [render, write]: [Duration; 2],
    ) -> PictureStats {
        let (engine, instructions) = match tracing {
            Tracing::Engine(simd) => ("simd", Some(simd.name())),
            Tracing::Reference => ("reference", None),
        };
        PictureStats {
            view: view.to_owned(),
            output: output.display().to_string(),
            width: still.picture.width,
            height: still.picture.height,
            threads: still.threads,
            engine,
            instructions,
            render,
            write,
            refined: still.refined,
            rays: still.counts.into(),
        }
    }
}

impl PictureStats {
    /// `simd (avx2)`.
    fn engine_name(&self) -> String {
        self.instructions.map_or_else(|| self.engine.to_owned(), |name| format!("{} ({name})", self.engine))
    }

    /// One line for somebody who looks: where the picture is and how long it took.
    pub(crate) fn summary(&self, lang: Lang) -> String {
        let PictureStats { output, width, height, render, .. } = self;
        words::picture_done(lang, output, width, height, format!("{:.2}", render.as_secs_f64())) + "\n"
    }
}

impl Stats {
    /// The figures as one line of JSON, or as text for a person.
    pub(crate) fn told(&self, as_json: bool, lang: Lang) -> String {
        if as_json { console::json(self) } else { self.text(lang) }
    }

    fn text(&self, lang: Lang) -> String {
        let mut rows = vec![
            (words::stage_read(lang), time(self.read), String::new()),
            (words::stage_compile(lang), time(self.compile), String::new()),
        ];
        for picture in &self.pictures {
            let PictureStats { view, output, width, height, threads, render, write, refined, rays, .. } = picture;
            let threads = number::threads(lang, *threads);
            let of = words::picture_of(lang, view, output, width, height, threads, picture.engine_name());
            rows.push((words::stage_render(lang), time(*render), of));
            rows.push((words::stage_write(lang), time(*write), String::new()));
            if let Some(refined) = refined {
                let all = grouped(lang, u64::from(*width) * u64::from(*height));
                rows.push((words::refined(lang), grouped(lang, *refined), words::refined_pixels(lang, all)));
            }
            let counts = [
                (words::rays_total(lang), rays.total, rate(lang, rays.total, *render)),
                (words::rays_primary(lang), rays.primary, words::rays_hits(lang, grouped(lang, rays.primary_hits))),
                (words::rays_reflected(lang), rays.reflected, String::new()),
                (words::rays_refracted(lang), rays.refracted, String::new()),
                (words::rays_shadow(lang), rays.shadow, String::new()),
            ];
            rows.extend(counts.map(|(kind, count, more)| (kind, grouped(lang, count), more)));
        }
        let widths = |f: fn(&(String, String, String)) -> &String| {
            rows.iter().map(|row| f(row).chars().count()).max().unwrap_or(0)
        };
        let (first, second) = (widths(|row| &row.0), widths(|row| &row.1));
        rows.iter().fold(String::new(), |text, (what, value, more)| {
            let row = format!("{what:<first$}  {value:>second$}  {more}");
            text + row.trim_end() + "\n"
        })
    }
}

/// Seconds with their unit, to a tenth of a millisecond.
fn time(duration: Duration) -> String {
    format!("{:.4} s", duration.as_secs_f64())
}

/// Rays per second.
fn rate(lang: Lang, rays: u64, time: Duration) -> String {
    words::rays_rate(lang, format!("{:.2}", rays as f64 / 1e6 / time.as_secs_f64().max(1e-9)))
}

/// A count with its thousands set apart.
fn grouped(lang: Lang, count: u64) -> String {
    let digits = count.to_string();
    let separator = match lang {
        Lang::English => ',',
        Lang::French => '\u{202f}',
    };
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(separator);
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_set_apart() {
        assert_eq!(grouped(Lang::English, 0), "0");
        assert_eq!(grouped(Lang::English, 999), "999");
        assert_eq!(grouped(Lang::English, 1_000), "1,000");
        assert_eq!(grouped(Lang::English, 12_345_678), "12,345,678");
        assert_eq!(grouped(Lang::French, 12_345_678), "12\u{202f}345\u{202f}678");
    }
}
