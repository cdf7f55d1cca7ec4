//! The words of the text formats, with the line that each stands in.

use super::MeshFault;

/// At most so many characters of a file are quoted.
const QUOTED: usize = 40;

/// The words of a text, separated by white space.
pub(super) struct Words<'a> {
    rest: &'a [u8],
    /// The line of the last word, from 1.
    pub(super) line: usize,
}

impl<'a> Words<'a> {
    pub(super) fn new(text: &'a [u8], line: usize) -> Words<'a> {
        Words { rest: text, line }
    }

    /// How many bytes are not read yet.
    pub(super) fn left(&self) -> usize {
        self.rest.len()
    }

    /// Lets the rest of the last word's line pass.
    pub(super) fn skip_line(&mut self) {
        let end = memchr::memchr(b'\n', self.rest).unwrap_or(self.rest.len());
        self.rest = &self.rest[end..];
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let mut start = 0;
        loop {
            match self.rest.get(start)? {
                b'\n' => self.line += 1,
                byte if byte.is_ascii_whitespace() => {}
                _ => break,
            }
            start += 1;
        }
        let rest = &self.rest[start..];
        let end = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        let (word, rest) = rest.split_at(end);
        self.rest = rest;
        Some(word)
    }
}

/// A decimal number.
pub(super) fn number(word: &[u8]) -> Result<f64, MeshFault> {
    let text = std::str::from_utf8(word).ok();
    text.and_then(|text| text.parse().ok()).ok_or_else(|| MeshFault::NotANumber(quoted(word)))
}

/// A word as a message quotes it.
pub(super) fn quoted(word: &[u8]) -> String {
    let text = String::from_utf8_lossy(word);
    let short: String = text.chars().take(QUOTED).collect();
    if short.len() < text.len() { short + "…" } else { short }
}
