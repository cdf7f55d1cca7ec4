//! What was measured, as a table for people and as JSON for programs.

use super::measure::{Cast, Frame, Measured};
use super::timing::Took;
use lancer_words::cli::bench as words;
use lancer_words::{Lang, number};
use serde::Serialize;
use unicode_width::UnicodeWidthStr;

/// The figures for programs; docs/performance.md says what each member is. Version 1; later versions may add members.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    version: u32,
    program: &'static str,
    engine: &'static str,
    width: u32,
    height: u32,
    threads: usize,
    repeat: usize,
    scenes: Vec<SceneFigures>,
}

/// One scene.
#[derive(Debug, Serialize)]
struct SceneFigures {
    name: String,
    primitives: u64,
    build: Took,
    bytes: usize,
    primary: Cast,
    shadow: Cast,
    reflected: Cast,
    diffuse: Cast,
    frame: Frame,
}

impl Report {
    /// The report of all that was measured.
    pub(super) fn new((width, height): (u32, u32), threads: usize, repeat: usize, measured: &[Measured]) -> Report {
        Report {
            version: 1,
            program: env!("CARGO_PKG_VERSION"),
            engine: "reference",
            width,
            height,
            threads,
            repeat,
            scenes: measured.iter().map(SceneFigures::new).collect(),
        }
    }

    /// The table, under a line that says how it was measured.
    pub(super) fn text(&self, lang: Lang) -> String {
        let Report { program, width, height, threads, repeat, .. } = self;
        let threads = number::threads(lang, *threads);
        let title = words::title(lang, program, words::reference(lang), width, height, threads, repeat);
        let groups =
            [(2, String::new()), (3, words::building(lang)), (4, words::casting(lang)), (2, words::frame(lang))];
        let heads = [
            words::scene(lang),
            words::primitives(lang),
            words::milliseconds(lang),
            words::build_rate(lang),
            words::bytes(lang),
            words::primary(lang),
            words::shadow(lang),
            words::reflected(lang),
            words::diffuse(lang),
            words::milliseconds(lang),
            words::frame_rate(lang),
        ];
        let rows: Vec<_> = self.scenes.iter().map(SceneFigures::row).collect();
        format!("{title}\n\n{}", table(&groups, &heads, &rows))
    }
}

impl SceneFigures {
    fn new(measured: &Measured) -> SceneFigures {
        SceneFigures {
            name: measured.case.name(),
            primitives: measured.primitives,
            build: measured.build,
            bytes: measured.bytes,
            primary: measured.primary,
            shadow: measured.shadow,
            reflected: measured.reflected,
            diffuse: measured.diffuse,
            frame: measured.frame,
        }
    }

    fn row(&self) -> [String; COLUMNS] {
        let cast = |cast: &Cast| rate(cast.rays, cast.took.seconds);
        [
            self.name.clone(),
            self.primitives.to_string(),
            format!("{:.2}", self.build.seconds * 1e3),
            rate(self.primitives, self.build.seconds),
            format!("{:.1}", self.bytes as f64 / self.primitives.max(1) as f64),
            cast(&self.primary),
            cast(&self.shadow),
            cast(&self.reflected),
            cast(&self.diffuse),
            format!("{:.1}", self.frame.took.seconds * 1e3),
            rate(self.frame.rays, self.frame.took.seconds),
        ]
    }
}

/// Millions a second.
fn rate(count: u64, seconds: f64) -> String {
    // no machine is so fast that a clock sees nothing; but a clock may be so coarse
    format!("{:.2}", count as f64 / 1e6 / seconds.max(1e-9))
}

const COLUMNS: usize = 11;

/// Columns that line up, the first to the left and the others to the right, with names over groups of them.
fn table(groups: &[(usize, String)], heads: &[String; COLUMNS], rows: &[[String; COLUMNS]]) -> String {
    let mut widths: [usize; COLUMNS] = std::array::from_fn(|column| {
        let cells = rows.iter().map(|row| row[column].width());
        cells.chain([heads[column].width()]).max().unwrap_or(0)
    });
    // a group that is narrower than its name makes its last column wider
    let mut end = 0;
    for (columns, name) in groups {
        let group = &mut widths[end..end + columns];
        let room = group.iter().sum::<usize>() + GAP * (columns - 1);
        if let Some(last) = group.last_mut() {
            *last += name.width().saturating_sub(room);
        }
        end += columns;
    }
    let mut text = String::new();
    let mut start = 0;
    for (columns, name) in groups {
        let room = widths[start..start + columns].iter().sum::<usize>() + GAP * (columns - 1);
        if start > 0 {
            text.extend(std::iter::repeat_n(' ', GAP));
        }
        let fill = if name.is_empty() { ' ' } else { '─' };
        let line = room - name.width();
        // ── name ──
        text.extend(std::iter::repeat_n(fill, line / 2));
        text += name;
        text.extend(std::iter::repeat_n(fill, line - line / 2));
        start += columns;
    }
    text.push('\n');
    for row in std::iter::once(heads).chain(rows) {
        let mut line = String::new();
        for (column, cell) in row.iter().enumerate() {
            let blanks = widths[column] - cell.width();
            if column == 0 {
                line += cell;
                line.extend(std::iter::repeat_n(' ', blanks));
            } else {
                line.extend(std::iter::repeat_n(' ', GAP + blanks));
                line += cell;
            }
        }
        text += line.trim_end();
        text.push('\n');
    }
    text
}

/// Blanks between two columns.
const GAP: usize = 2;
