//! Changes of stretches of a document's text; what is between them stays byte for byte.

use super::super::write::STEP;
use super::super::{Document, Element};
use crate::Span;

/// Changes of a document's text, made all at once.
pub(super) struct Splices<'d> {
    text: &'d str,
    line_end: &'static str,
    changes: Vec<(Span, String)>,
}

impl<'d> Splices<'d> {
    pub(super) fn new(document: &'d Document) -> Splices<'d> {
        let text = document.text();
        let first = text.find('\n').map(|at| &text[..at]);
        let line_end = if first.is_some_and(|line| line.ends_with('\r')) { "\r\n" } else { "\n" };
        Splices { text, line_end, changes: Vec::new() }
    }

    /// No changes yet of the same document.
    pub(super) fn another(&self) -> Splices<'d> {
        Splices { text: self.text, line_end: self.line_end, changes: Vec::new() }
    }

    pub(super) fn line_end(&self) -> &'static str {
        self.line_end
    }

    pub(super) fn text(&self) -> &'d str {
        self.text
    }

    /// Puts a text in the place of a stretch.
    pub(super) fn replace(&mut self, span: Span, text: impl Into<String>) {
        self.changes.push((span, text.into()));
    }

    pub(super) fn insert(&mut self, at: usize, text: impl Into<String>) {
        self.replace(Span { start: at, end: at }, text);
    }

    /// What `write` writes, with the document's line ends.
    pub(super) fn written(&self, write: impl FnOnce(&mut String)) -> String {
        let mut text = String::new();
        write(&mut text);
        if self.line_end == "\n" { text } else { text.replace('\n', self.line_end) }
    }

    /// The text of a stretch with the changes within it. What is inserted at one place keeps its order.
    pub(super) fn apply(&mut self, within: Span) -> String {
        self.changes.sort_by_key(|(span, _)| *span);
        let mut text = String::with_capacity(within.end - within.start);
        let mut copied = within.start;
        for (span, change) in &self.changes {
            if span.start >= copied && span.end <= within.end {
                text.push_str(&self.text[copied..span.start]);
                text.push_str(change);
                copied = span.end;
            }
        }
        text.push_str(&self.text[copied..within.end]);
        text
    }

    /// The blanks before an element that is the first thing on its line.
    fn indent_at(&self, at: usize) -> Option<&'d str> {
        let start = self.line_start(at);
        let before = &self.text[start..at];
        before.bytes().all(|byte| matches!(byte, b' ' | b'\t')).then_some(before)
    }

    fn line_start(&self, at: usize) -> usize {
        self.text[..at].rfind('\n').map_or(0, |newline| newline + 1)
    }

    /// The start of the next line, if nothing but blanks and whole comments stand between `at` and the line's end.
    fn next_line(&self, at: usize) -> Option<usize> {
        let length = self.text[at..].find('\n')?;
        let mut rest = self.text[at..at + length].trim_start();
        while let Some(comment) = rest.strip_prefix("<!--") {
            rest = comment.split_once("-->")?.1.trim_start();
        }
        rest.is_empty().then_some(at + length + 1)
    }

    /// How far an element is indented.
    pub(super) fn indent(&self, element: Element<'_>) -> String {
        self.indent_at(element.span().start).unwrap_or_default().to_owned()
    }

    /// How far what stands within an element is indented.
    pub(super) fn inner_indent(&self, element: Element<'_>) -> String {
        let first = element.elements().next().and_then(|child| self.indent_at(child.span().start));
        first.map_or_else(|| self.indent(element) + STEP, str::to_owned)
    }

    /// Takes an element out, with its lines where nothing else stands on them.
    pub(super) fn remove(&mut self, element: Element<'_>) {
        let span = element.span();
        let rest = self.text[span.end..].find('\n').map(|length| &self.text[span.end..span.end + length]);
        let alone = self.indent_at(span.start).is_some() && rest.is_some_and(|rest| rest.trim().is_empty());
        let whole = match rest {
            Some(rest) if alone => Span { start: self.line_start(span.start), end: span.end + rest.len() + 1 },
            _ => span,
        };
        self.replace(whole, "");
    }

    /// Puts a text that begins with its indentation and ends with a line end on lines of its own after an element.
    pub(super) fn insert_after(&mut self, element: Element<'_>, lines: &str) {
        let end = element.span().end;
        match self.next_line(end) {
            Some(next) => self.insert(next, lines),
            None => self.insert(end, format!("{}{}", self.line_end, lines.trim_end())),
        }
    }

    /// Puts a text that begins with its indentation and ends with a line end on lines of its own before an element.
    pub(super) fn insert_before(&mut self, element: Element<'_>, lines: &str) {
        let start = element.span().start;
        match self.indent_at(start) {
            Some(_) => self.insert(self.line_start(start), lines),
            None => self.insert(start, lines.trim_start()),
        }
    }

    /// Puts a text that begins with its indentation and ends with a line end at the end of an element's content.
    pub(super) fn insert_within(&mut self, element: Element<'_>, lines: &str) {
        let indent = self.indent(element);
        match element.content_span() {
            Some(content) => match self.indent_at(content.end) {
                Some(_) => self.insert(self.line_start(content.end), lines),
                None => self.insert(content.end, format!("{}{lines}{indent}", self.line_end)),
            },
            None => {
                let tag = element.start_tag();
                let head = self.text[tag.start..tag.end - "/>".len()].trim_end();
                let slash = Span { start: tag.start + head.len(), end: tag.end };
                self.replace(slash, format!(">{}{lines}{indent}</{}>", self.line_end, element.name()));
            }
        }
    }
}
