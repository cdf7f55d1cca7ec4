//! The tokeniser's part for tags, their attributes, and the references within text and values.

use super::super::reference::{name_length, resolve};
use super::super::{Excerpt, MAX_DEPTH, SyntaxProblem};
use super::{Entry, EntryKind, Scan, Scanner, line_of};
use crate::Span;
use memchr::{memchr_iter, memchr3};

impl Scanner<'_> {
    /// `<name attribute="value" …>` or `… />`.
    pub(super) fn start_tag(&mut self) -> Scan<()> {
        let start = self.at;
        let length = name_length(&self.text[start + 1..]);
        if length == 0 {
            return self.fault(start, start + 1, SyntaxProblem::TagWithoutName);
        }
        let name = Span { start: start + 1, end: start + 1 + length };
        self.at = name.end;
        self.attributes.clear();
        self.value = Span::default();
        let empty = loop {
            let spaced = self.skip_blanks();
            match self.byte() {
                Some(b'>') => break false,
                Some(b'/') if self.text[self.at..].starts_with("/>") => break true,
                Some(b'<') => {
                    let problem = SyntaxProblem::TagNotEnded { name: self.excerpt(name.start, name.end) };
                    return self.fault(start, name.end, problem);
                }
                Some(_) => self.attribute(name, spaced)?,
                None => return self.ends_within(name),
            }
        };
        self.unique_attributes(name)?;
        self.at += if empty { 2 } else { 1 };
        if self.open.len() >= MAX_DEPTH {
            return self.fault(start, name.end, SyntaxProblem::TooDeep { limit: MAX_DEPTH });
        }
        if empty {
            self.leaf(EntryKind::Element, start, self.at);
        } else {
            self.open.push(self.entries.len());
            let (start, end) = (start as u32, self.at as u32);
            self.entries.push(Entry { start, head_end: end, end, next: 0, kind: EntryKind::Element });
        }
        Ok(())
    }

    /// `name="value"` within a tag.
    fn attribute(&mut self, element: Span, spaced: bool) -> Scan<()> {
        let start = self.at;
        let end = start + name_length(&self.text[start..]);
        if end == start {
            self.quote_was_missing()?;
            let found = self.text[start..].chars().next().unwrap_or_default();
            let name = self.excerpt(element.start, element.end);
            return self.fault(start, start + found.len_utf8(), SyntaxProblem::StrayInTag { found, name });
        }
        let text = self.text;
        let name = || Excerpt::new(&text[start..end]);
        if !spaced {
            self.quote_was_missing()?;
            return self.fault(start, end, SyntaxProblem::AttributesTouch { name: name() });
        }
        let mut at = self.after_blanks(end);
        if at == text.len() {
            return self.ends_within(element);
        }
        if self.text.as_bytes().get(at) != Some(&b'=') {
            return self.fault(start, end, SyntaxProblem::AttributeWithoutValue { name: name() });
        }
        at = self.after_blanks(at + 1);
        if at == text.len() {
            return self.ends_within(element);
        }
        let Some(&quote @ (b'"' | b'\'')) = self.text.as_bytes().get(at) else {
            let rest = &self.text[at..];
            let value = rest.find(|c: char| c.is_whitespace() || "/><\"'".contains(c)).unwrap_or(rest.len());
            let problem = match value {
                0 => SyntaxProblem::AttributeWithoutValue { name: name() },
                _ => SyntaxProblem::ValueWithoutQuotes { name: name(), value: Excerpt::new(&rest[..value]) },
            };
            return if value == 0 { self.fault(start, end, problem) } else { self.fault(at, at + value, problem) };
        };
        let value = at + 1;
        let mut referred = false;
        at = value;
        loop {
            match memchr3(quote, b'<', b'&', &self.text.as_bytes()[at..]).map(|next| at + next) {
                Some(next) if self.text.as_bytes()[next] == quote => {
                    at = next;
                    break;
                }
                Some(next) if self.text.as_bytes()[next] == b'&' => {
                    referred = true;
                    at = next + 1;
                }
                unended => {
                    self.at = unended.unwrap_or(self.text.len());
                    if referred {
                        self.references(value, self.at)?;
                    }
                    if unended.is_none() {
                        return self.ends_within(element);
                    }
                    let problem = SyntaxProblem::ValueNotEnded { name: name(), quote: char::from(quote) };
                    return self.fault(value - 1, self.line_end(value - 1, b'<'), problem);
                }
            }
        }
        if referred {
            self.references(value, at)?;
        }
        self.attributes.push(Span { start, end });
        self.value = Span { start: value, end: at };
        self.at = at + 1;
        Ok(())
    }

    fn ends_within<T>(&self, element: Span) -> Scan<T> {
        let problem = SyntaxProblem::EndsWithinTag { name: self.excerpt(element.start, element.end) };
        self.fault(element.start - 1, element.end, problem)
    }

    /// Where something is wrong after a value such as `0 0 0 radius=`, its closing quote was forgotten, and the next
    /// attribute's opening quote taken for it.
    fn quote_was_missing(&self) -> Scan<()> {
        let value = &self.text[self.value.start..self.value.end];
        let swallowed = value.trim_end().strip_suffix('=').map(str::trim_end);
        let Some((kept, _)) = swallowed.and_then(|value| value.rsplit_once(|c: char| c.is_ascii_whitespace())) else {
            return Ok(());
        };
        let Some(name) = self.attributes.last() else { return Ok(()) };
        let quote = char::from(self.text.as_bytes()[self.value.start - 1]);
        let problem = SyntaxProblem::ValueNotEnded { name: self.excerpt(name.start, name.end), quote };
        self.fault(self.value.start - 1, self.value.start + kept.trim_end().len(), problem)
    }

    /// No attribute may stand twice in a tag.
    fn unique_attributes(&mut self, element: Span) -> Scan<()> {
        let text = self.text;
        let name = |span: &Span| &text[span.start..span.end];
        self.attributes.sort_unstable_by(|a, b| name(a).cmp(name(b)).then(a.cmp(b)));
        let twice =
            self.attributes.windows(2).filter(|pair| name(&pair[0]) == name(&pair[1])).min_by_key(|pair| pair[1]);
        let Some(&[first, second]) = twice.and_then(|pair| pair.as_array()) else { return Ok(()) };
        let problem = SyntaxProblem::DuplicateAttribute {
            name: self.excerpt(second.start, second.end),
            element: self.excerpt(element.start, element.end),
            line: line_of(text, first.start),
        };
        self.fault(second.start, second.end, problem)
    }

    /// `</name>`, which must end the open element.
    pub(super) fn end_tag(&mut self, open: usize) -> Scan<()> {
        let start = self.at;
        let length = name_length(&self.text[start + 2..]);
        let found = &self.text[start + 2..start + 2 + length];
        self.at = start + 2 + length;
        let name = |entry: usize| {
            let tag = self.entries[entry].start as usize + 1;
            &self.text[tag..tag + name_length(&self.text[tag..])]
        };
        let open_name = name(open);
        if length > 0 && found != open_name {
            let line = line_of(self.text, self.entries[open].start as usize);
            let is_outer = self.open.iter().any(|outer| name(*outer) == found);
            let (found, open) = (Excerpt::new(found), Excerpt::new(open_name));
            let problem = match is_outer {
                true => SyntaxProblem::OuterEnd { found, open, line },
                false => SyntaxProblem::MismatchedEnd { found, open, line },
            };
            return self.fault(start, self.at, problem);
        }
        self.skip_blanks();
        if length == 0 || self.byte() != Some(b'>') {
            return self.fault(start, self.at.min(self.line_end(start, b'\n')), SyntaxProblem::BadEndTag);
        }
        self.at += 1;
        let next = self.entries.len() as u32;
        let entry = &mut self.entries[open];
        (entry.end, entry.next) = (self.at as u32, next);
        self.open.pop();
        Ok(())
    }

    /// Every reference of a stretch of text must be known.
    pub(super) fn references(&mut self, start: usize, end: usize) -> Scan<()> {
        for at in memchr_iter(b'&', &self.text.as_bytes()[start..end]) {
            let at = start + at;
            let body = &self.text[at + 1..end];
            let part = |byte: u8| byte.is_ascii_alphanumeric() || !byte.is_ascii() || b"#_.:-".contains(&byte);
            let length = body.bytes().position(|byte| !part(byte)).unwrap_or(body.len());
            let name = &body[..length];
            let after = at + 1 + length;
            if name.is_empty() || !body[length..].starts_with(';') {
                return self.fault(at, at + 1, SyntaxProblem::BareAmpersand);
            }
            if resolve(name).is_none() {
                let problem = if name.starts_with('#') {
                    SyntaxProblem::BadCharacterReference { reference: self.excerpt(at, after + 1) }
                } else {
                    SyntaxProblem::UnknownEntity { name: Excerpt::new(name) }
                };
                return self.fault(at, after + 1, problem);
            }
        }
        Ok(())
    }
}
