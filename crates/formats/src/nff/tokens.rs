//! The words of a file with their places.

use crate::Span;

/// A word of the file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token<'t> {
    pub(super) text: &'t str,
    pub(super) span: Span,
    /// Whether it is the first of its line.
    pub(super) first: bool,
}

/// The words of a text, without comments: a `#` ends its line.
#[derive(Clone, Debug)]
pub(super) struct Tokens<'t> {
    text: &'t str,
    at: usize,
    first: bool,
}

impl<'t> Tokens<'t> {
    pub(super) fn of(text: &'t str) -> Tokens<'t> {
        // a mark at the beginning is no character of the text
        let at = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        Tokens { text, at, first: true }
    }

    /// The next word without taking it.
    pub(super) fn peek(&self) -> Option<Token<'t>> {
        self.clone().next()
    }

    /// The place behind the last word.
    pub(super) fn end(&self) -> Span {
        let end = self.text.trim_end().len().max(self.at.min(self.text.len()));
        Span { start: end, end }
    }
}

impl<'t> Iterator for Tokens<'t> {
    type Item = Token<'t>;

    fn next(&mut self) -> Option<Token<'t>> {
        let bytes = self.text.as_bytes();
        loop {
            match bytes.get(self.at)? {
                b'\n' | b'\r' => self.first = true,
                b'#' => {
                    let end = memchr::memchr2(b'\n', b'\r', &bytes[self.at..]);
                    self.at = end.map_or(bytes.len(), |end| self.at + end);
                    continue;
                }
                byte if byte.is_ascii_whitespace() => {}
                _ => break,
            }
            self.at += 1;
        }
        let start = self.at;
        let end = bytes[start..].iter().position(|byte| byte.is_ascii_whitespace() || *byte == b'#');
        let span = Span { start, end: end.map_or(bytes.len(), |length| start + length) };
        self.at = span.end;
        let first = std::mem::replace(&mut self.first, false);
        Some(Token { text: &self.text[span.start..span.end], span, first })
    }
}
