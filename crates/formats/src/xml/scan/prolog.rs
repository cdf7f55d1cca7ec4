//! The tokeniser's part for what stands before the root: the XML declaration and the DOCTYPE.

use super::super::reference::{is_blank, name_length};
use super::super::{Excerpt, SyntaxProblem};
use super::{Scan, Scanner};
use crate::Span;
use memchr::{memchr, memmem};

impl<'t> Scanner<'t> {
    /// `<?xml version="1.0" …?>`, if the text begins with it.
    pub(super) fn declaration(&mut self) -> Scan<()> {
        let begins = self.text.strip_prefix("<?xml").is_some_and(|rest| rest.bytes().next().is_none_or(is_blank));
        if !begins {
            return Ok(());
        }
        let Some(end) = memmem::find(self.text.as_bytes(), b"?>") else {
            return self.fault(0, self.line_end(0, b'\n'), SyntaxProblem::BadDeclaration);
        };
        self.at = "<?xml".len();
        let version = self.pseudo_attribute("version", end)?;
        let Some(version) = version else { return self.fault(0, end + 2, SyntaxProblem::BadDeclaration) };
        let value = &self.text[version.start..version.end];
        if !value.strip_prefix("1.").is_some_and(|minor| !minor.is_empty() && minor.bytes().all(|b| b.is_ascii_digit()))
        {
            let version_name = Excerpt::new(value);
            return self.fault(version.start, version.end, SyntaxProblem::UnknownXmlVersion { version: version_name });
        }
        if let Some(encoding) = self.pseudo_attribute("encoding", end)? {
            let label = &self.text[encoding.start..encoding.end];
            let legal = |byte: u8| byte.is_ascii_alphanumeric() || b"._-".contains(&byte);
            if !label.starts_with(|first: char| first.is_ascii_alphabetic()) || !label.bytes().all(legal) {
                return self.fault(encoding.start, encoding.end, SyntaxProblem::BadDeclaration);
            }
        }
        if let Some(standalone) = self.pseudo_attribute("standalone", end)?
            && !["yes", "no"].contains(&&self.text[standalone.start..standalone.end])
        {
            return self.fault(standalone.start, standalone.end, SyntaxProblem::BadDeclaration);
        }
        self.skip_blanks();
        if self.at != end {
            return self.fault(self.at, end, SyntaxProblem::BadDeclaration);
        }
        self.at = end + 2;
        Ok(())
    }

    /// The place of the value of `name="value"` in the XML declaration, if that comes next.
    fn pseudo_attribute(&mut self, name: &str, end: usize) -> Scan<Option<Span>> {
        let start = self.at;
        self.skip_blanks();
        if self.at == start || !self.text[self.at..end.max(self.at)].starts_with(name) {
            self.at = start;
            return Ok(None);
        }
        self.at += name.len();
        self.skip_blanks();
        let equals = self.byte() == Some(b'=');
        self.at += usize::from(equals);
        self.skip_blanks();
        let value = self.at + 1;
        match self.byte() {
            Some(quote @ (b'"' | b'\'')) if equals && value <= end => {
                if let Some(length) = memchr(quote, &self.text.as_bytes()[value..end]) {
                    self.at = value + length + 1;
                    return Ok(Some(Span { start: value, end: value + length }));
                }
            }
            _ => {}
        }
        self.fault(start, end.max(start), SyntaxProblem::BadDeclaration)
    }

    /// `<!DOCTYPE name …>`. Its external identifier is read over; declarations of its own are refused.
    pub(super) fn doctype(&mut self) -> Scan<()> {
        let start = self.at;
        self.at += "<!DOCTYPE".len();
        let spaced = self.skip_blanks();
        let name = name_length(&self.text[self.at..]);
        let bad =
            |scanner: &Scanner<'t>| scanner.fault(start, scanner.line_end(start, b'>'), SyntaxProblem::BadDoctype);
        if !spaced || name == 0 {
            return bad(self);
        }
        self.at += name;
        let spaced = self.skip_blanks();
        let literals = match &self.text[self.at..] {
            rest if rest.starts_with("SYSTEM") => 1,
            rest if rest.starts_with("PUBLIC") => 2,
            _ => 0,
        };
        if literals > 0 {
            if !spaced {
                return bad(self);
            }
            self.at += "SYSTEM".len();
        }
        for number in 0..literals {
            let spaced = self.skip_blanks();
            let Some(quote @ (b'"' | b'\'')) = self.byte() else { return bad(self) };
            let literal = self.at + 1;
            let Some(length) = memchr(quote, &self.text.as_bytes()[literal..]) else { return bad(self) };
            let public = literals == 2 && number == 0;
            if !spaced || public && !self.text[literal..literal + length].bytes().all(is_public_id) {
                return bad(self);
            }
            self.at = literal + length + 1;
        }
        self.skip_blanks();
        match self.byte() {
            Some(b'[') => self.fault(self.at, self.at + 1, SyntaxProblem::InternalSubset),
            Some(b'>') => {
                self.at += 1;
                Ok(())
            }
            _ => bad(self),
        }
    }
}

/// Whether a DOCTYPE's public identifier may hold the byte (production 13).
fn is_public_id(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b' ' | b'\r' | b'\n') || b"-'()+,./:=?;!*#@$_%".contains(&byte)
}
