//! How the problems of a document are shown: the sentence, the place as `file:line:column`, the text underlined, and the
//! rule or the way out.
//!
//! miette draws the snippet. It is given the few lines around the place, cut to the width, so that a line of fifty
//! megabytes costs nothing; and line and column are counted here, in characters.

use lancer_formats::{Describe, Diagnostic, Lines, Severity, Source, Span};
use lancer_words::{Lang, xml::report as words};
use miette::{GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError, MietteSpanContents};
use miette::{SourceCode, SourceSpan, SpanContents};
use std::fmt::{self, Write as _};

/// More problems than this are only counted.
const MOST: usize = 100;
/// Columns beside the text of a snippet: line number, frame, and blanks.
const MARGIN: usize = 12;
/// The least and the greatest width of a report in columns.
const WIDTHS: std::ops::RangeInclusive<usize> = 40..=160;

/// The problems of a source as they are printed, in their order; nothing if there are none.
///
/// `width` is the terminal's in columns. Colours are ANSI sequences; without them the text holds none.
pub fn render(source: &Source, diagnostics: &[Diagnostic], lang: Lang, color: bool, width: usize) -> String {
    let width = width.clamp(*WIDTHS.start(), *WIDTHS.end());
    let theme = if color { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
    let handler = GraphicalReportHandler::new_themed(theme).with_width(width).with_links(false);
    let mut places = Places::new(source);
    let mut report = String::new();
    for (number, diagnostic) in diagnostics.iter().take(MOST).enumerate() {
        if number > 0 {
            report.push('\n');
        }
        let shown = Shown {
            message: clean(&diagnostic.problem.message(lang)),
            label: clean(&diagnostic.problem.label(lang)),
            severity: diagnostic.severity,
            snippet: diagnostic.span.map(|span| Snippet::around(span, &mut places, width - MARGIN)),
        };
        // Writing to a string does not fail; a failure of the drawing would leave the sentence and the place out.
        if handler.render_report(&mut report, &shown).is_err() {
            let _ = writeln!(report, "{}", shown.message);
        }
        if shown.snippet.is_none() {
            let _ = writeln!(report, "   ╰─[{}]", clean(&source.name));
        }
        if let Some(help) = diagnostic.problem.help(lang) {
            report.push_str(&wrapped(&words::help(lang, clean(&help)), width, color));
        }
    }
    if diagnostics.len() > MOST {
        let _ = writeln!(report, "\n  {}", words::and_more(lang, diagnostics.len() - MOST));
    }
    report
}

/// A text without characters that a terminal would obey.
fn clean(text: &str) -> String {
    text.chars().map(|character| if is_hostile(character) { '\u{FFFD}' } else { character }).collect()
}

/// Control characters, and those that turn the direction of writing.
fn is_hostile(character: char) -> bool {
    character.is_control() && character != '\t'
        || matches!(character, '\u{200E}' | '\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}')
}

/// The help in lines of at most `width`, indented under its first word. No line breaks within French quotes or before
/// the signs that French sets apart.
fn wrapped(help: &str, width: usize, color: bool) -> String {
    const JOINT: &str = "\u{A0}";
    let mut help = help.replace("« ", "«\u{A0}");
    for sign in ["»", ":", ";", "?", "!"] {
        help = help.replace(&format!(" {sign}"), &format!("{JOINT}{sign}"));
    }
    let (lead, _) = help.split_at(help.find(": ").map_or(0, |colon| colon + 2));
    let indent = 2 + lead.chars().count();
    let mut text = String::new();
    let mut column = usize::MAX;
    for word in help[lead.len()..].split(' ') {
        let length = word.chars().count();
        if column.saturating_add(1 + length) > width {
            if text.is_empty() {
                text = if color { format!("  \u{1b}[36m{lead}\u{1b}[0m") } else { format!("  {lead}") };
            } else {
                let _ = write!(text, "\n{:indent$}", "");
            }
            column = indent;
        } else {
            text.push(' ');
            column += 1;
        }
        text.push_str(word);
        column += length;
    }
    text.push('\n');
    text.replace(JOINT, " ")
}

/// Lines and columns of a source.
struct Places<'s> {
    source: &'s Source,
    lines: Lines,
    /// The place that was asked for last, from which the next one's column is counted: a line can be very long.
    last: Place,
}

#[derive(Clone, Copy, Default)]
struct Place {
    offset: usize,
    line_start: usize,
    column: usize,
}

impl Places<'_> {
    fn new(source: &Source) -> Places<'_> {
        Places { source, lines: Lines::new(&source.text), last: Place::default() }
    }

    /// The column of an offset in characters, from 0.
    fn column(&mut self, offset: usize) -> usize {
        let line_start = self.lines.start(offset);
        let (from, before) = match self.last {
            last if last.line_start == line_start && last.offset <= offset => (last.offset, last.column),
            _ => (line_start, 0),
        };
        let column = before + self.source.text[from..offset].chars().count();
        self.last = Place { offset, line_start, column };
        column
    }

    /// The line that holds an offset, without its end.
    fn line(&self, offset: usize) -> Span {
        let start = self.lines.start(offset);
        let end = self.source.text[offset..].find('\n').map_or(self.source.text.len(), |length| offset + length);
        Span { start, end: start.max(start + self.source.text[start..end].trim_end_matches('\r').len()) }
    }
}

/// The lines around a place, cut to a width, with the place's true line and column.
#[derive(Debug)]
struct Snippet {
    name: String,
    text: String,
    /// The underlined bytes of `text`.
    span: SourceSpan,
    /// Line and column of the place, and the first line of `text`, all from 0.
    line: usize,
    column: usize,
    first_line: usize,
}

impl Snippet {
    /// One line before the place, its own, and one after. Of a place of several lines the first is underlined.
    fn around(span: Span, places: &mut Places<'_>, width: usize) -> Snippet {
        let source = places.source;
        let place = source.text.floor_char_boundary(span.start);
        let own = places.line(place);
        // A place at the very end of a line stands before its line end.
        let start = place.min(own.end);
        let end = source.text.floor_char_boundary(span.end).clamp(start, own.end);
        let line = places.lines.line(place) - 1;
        let before = own.start.checked_sub(1).map(|end| places.line(end));
        let after = source.text[own.end..].find('\n').map(|length| own.end + length + 1);
        let after = after.filter(|start| *start < source.text.len()).map(|start| places.line(start));

        let own_start = window_start(&source.text[own.start..own.end], start - own.start, width);
        let shift = own.start + own_start;
        let mut text = String::new();
        if let Some(before) = before {
            text.push_str(&cut(&source.text[before.start..before.end], 0, width));
            text.push('\n');
        }
        let begun = text.len();
        let shown = cut(&source.text[own.start..own.end], own_start, width);
        let ellipsis = if own_start > 0 { '…'.len_utf8() } else { 0 };
        // Cleaning may change the length of a character, so offsets are counted again.
        let length = |from: usize, to: usize| clean(&source.text[from..to]).len();
        let from = (begun + ellipsis + length(shift, start)).min(begun + shown.len());
        let to = (from + length(start, end)).min(begun + shown.len());
        text.push_str(&shown);
        if let Some(after) = after {
            text.push('\n');
            text.push_str(&cut(&source.text[after.start..after.end], 0, width));
        }
        Snippet {
            name: clean(&source.name),
            span: (from, to - from).into(),
            line,
            column: places.column(place),
            first_line: line - usize::from(before.is_some()),
            text,
        }
    }
}

/// Where a line is shown from: its beginning if all of it fits, or else so that the place `at` is well within the width.
fn window_start(line: &str, at: usize, width: usize) -> usize {
    let fits = line.chars().nth(width).is_none();
    let before = || line[..at].char_indices().rev();
    if fits || before().nth(width * 2 / 3).is_none() { 0 } else { before().nth(width / 3).map_or(0, |(at, _)| at) }
}

/// A line from `start` on, cut to a width, with an ellipsis where something is left out.
fn cut(line: &str, start: usize, width: usize) -> String {
    let mut shown = String::from(if start > 0 { "…" } else { "" });
    let mut characters = line[start..].chars();
    shown.extend(
        characters.by_ref().take(width).map(|character| if is_hostile(character) { '\u{FFFD}' } else { character }),
    );
    if characters.next().is_some() {
        shown.push('…');
    }
    shown
}

impl SourceCode for Snippet {
    /// Asked for the place alone, it tells the place's true line and column; asked for the lines around it, the text.
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        _after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let contents = if before == 0 {
            let data = self.text.as_bytes().get(span.offset()..).unwrap_or_default();
            MietteSpanContents::new_named(self.name.clone(), data, *span, self.line, self.column, 1)
        } else {
            let whole = (0, self.text.len()).into();
            MietteSpanContents::new_named(self.name.clone(), self.text.as_bytes(), whole, self.first_line, 0, 3)
        };
        Ok(Box::new(contents))
    }
}

/// A problem as miette sees it.
#[derive(Debug)]
struct Shown {
    message: String,
    label: String,
    severity: Severity,
    snippet: Option<Snippet>,
}

impl fmt::Display for Shown {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for Shown {}

impl miette::Diagnostic for Shown {
    fn severity(&self) -> Option<miette::Severity> {
        Some(match self.severity {
            Severity::Error => miette::Severity::Error,
            Severity::Warning => miette::Severity::Warning,
        })
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.snippet.as_ref().map(|snippet| snippet as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let label = Some(self.label.clone()).filter(|label| !label.is_empty());
        let span = self.snippet.as_ref()?.span;
        Some(Box::new(std::iter::once(LabeledSpan::new_primary_with_span(label, span))))
    }
}
