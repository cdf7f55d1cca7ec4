//! The tokeniser: one pass over the source text that proves it well-formed XML 1.0 and lists its nodes as offsets.
//!
//! It is written by hand because a document must be kept byte for byte and every fault must be told where it begins:
//! event readers neither give the places of attributes nor refuse all that the grammar refuses. There is no recursion,
//! and no entity is ever replaced by another text, so the work and the memory are linear in the text.

use super::reference::{is_blank, is_legal, name_length, resolve};
use super::syntax::{CodePoint, SyntaxProblem};
use super::{Excerpt, MAX_DEPTH};
use crate::Span;
use memchr::{memchr, memchr_iter, memchr3, memmem};

/// One node of the document, as offsets into the text and into the table of nodes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// The first byte.
    pub(super) start: u32,
    /// The byte after an element's start tag; of other nodes the same as `end`.
    pub(super) head_end: u32,
    /// The byte after the last.
    pub(super) end: u32,
    /// The entry after this node and all within it.
    pub(super) next: u32,
    pub(super) kind: EntryKind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EntryKind {
    Element,
    Text,
    Cdata,
    Comment,
    Instruction,
}

/// The first fault of a text, with the place at which the scan met it.
#[derive(Debug)]
pub(super) struct Fault {
    met_at: usize,
    pub(super) span: Span,
    pub(super) problem: SyntaxProblem,
}

type Scan<T> = Result<T, Box<Fault>>;

/// The nodes of a text in document order. Text of nothing but white space is no node.
pub(super) fn scan(text: &str) -> Scan<Vec<Entry>> {
    let mut scanner = Scanner { text, at: 0, entries: Vec::new(), open: Vec::new(), attributes: Vec::new() };
    let result = scanner.document();
    let illegal = first_illegal(text);
    match (result, illegal) {
        (Ok(()), None) => Ok(scanner.entries),
        (Err(fault), Some(at)) if fault.met_at < at => Err(fault),
        (_, Some(at)) => {
            let character = text[at..].chars().next().unwrap_or_default();
            let span = Span { start: at, end: at + character.len_utf8() };
            let problem = SyntaxProblem::IllegalCharacter { code: CodePoint(character) };
            Err(Box::new(Fault { met_at: at, span, problem }))
        }
        (Err(fault), None) => Err(fault),
    }
}

/// The first character that no document may hold.
fn first_illegal(text: &str) -> Option<usize> {
    let control = text.bytes().position(|byte| byte < b' ' && !is_blank(byte));
    // U+FFFE and U+FFFF, the only others, begin with the byte EF.
    let within = &text[..control.unwrap_or(text.len())];
    let wide = memchr_iter(0xEF, within.as_bytes())
        .find(|&at| within[at..].chars().next().is_some_and(|character| !is_legal(character)));
    wide.or(control)
}

/// The number of the line that holds an offset, from 1.
fn line_of(text: &str, offset: usize) -> usize {
    memchr_iter(b'\n', &text.as_bytes()[..offset]).count() + 1
}

struct Scanner<'t> {
    text: &'t str,
    at: usize,
    entries: Vec<Entry>,
    /// The entries of the open elements.
    open: Vec<usize>,
    /// The names of the attributes of one tag, kept to be used again.
    attributes: Vec<Span>,
}

impl<'t> Scanner<'t> {
    fn document(&mut self) -> Scan<()> {
        self.declaration()?;
        let (mut root, mut doctype) = (false, false);
        loop {
            self.skip_blanks();
            let rest = &self.text[self.at..];
            if rest.is_empty() {
                let end = self.text.len();
                return if root { Ok(()) } else { self.fault(end, end, SyntaxProblem::NoRoot) };
            } else if !rest.starts_with('<') {
                let problem = if self.entries.is_empty() { SyntaxProblem::NotXml } else { SyntaxProblem::TextOutside };
                return self.fault(self.at, self.line_end(self.at, b'<'), problem);
            } else if rest.starts_with("<!DOCTYPE") {
                if root || doctype {
                    return self.fault(self.at, self.at + "<!DOCTYPE".len(), SyntaxProblem::MisplacedDoctype);
                }
                doctype = true;
                self.doctype()?;
            } else if rest.starts_with("<![CDATA[") {
                return self.fault(self.at, self.at + "<![CDATA[".len(), SyntaxProblem::TextOutside);
            } else if let Some(tag) = rest.strip_prefix("</") {
                let (start, end) = (self.at, self.at + 2 + name_length(tag));
                let name = self.excerpt(start + 2, end);
                return self.fault(start, end, SyntaxProblem::EndWithoutStart { name });
            } else if !self.comment_or_instruction()? {
                if root {
                    let (start, end) = (self.at, self.at + 1 + name_length(&rest[1..]));
                    let name = self.excerpt(start + 1, end);
                    let problem = if end == start + 1 {
                        SyntaxProblem::TagWithoutName
                    } else {
                        SyntaxProblem::SecondRoot { name }
                    };
                    return self.fault(start, end, problem);
                }
                root = true;
                self.start_tag()?;
                self.content()?;
            }
        }
    }

    /// Everything from after the root's start tag to after its end tag.
    fn content(&mut self) -> Scan<()> {
        while let Some(&open) = self.open.last() {
            let start = self.at;
            let Some(length) = memchr(b'<', &self.text.as_bytes()[start..]) else {
                self.character_data(start, self.text.len())?;
                self.at = self.text.len();
                let tag = self.entries[open].start as usize;
                let name_end = tag + 1 + name_length(&self.text[tag + 1..]);
                let name = self.excerpt(tag + 1, name_end);
                let line = line_of(self.text, self.text.trim_end().len());
                return self.fault(tag, name_end, SyntaxProblem::ElementNotClosed { name, line });
            };
            self.character_data(start, start + length)?;
            self.at = start + length;
            let rest = &self.text[self.at..];
            if rest.starts_with("</") {
                self.end_tag(open)?;
            } else if rest.starts_with("<![CDATA[") {
                let Some(length) = memmem::find(rest.as_bytes(), b"]]>") else {
                    return self.fault(self.at, self.at + "<![CDATA[".len(), SyntaxProblem::CdataNotEnded);
                };
                self.leaf(EntryKind::Cdata, self.at, self.at + length + 3);
            } else if rest.starts_with("<!DOCTYPE") {
                return self.fault(self.at, self.at + "<!DOCTYPE".len(), SyntaxProblem::MisplacedDoctype);
            } else if !self.comment_or_instruction()? {
                self.start_tag()?;
            }
        }
        Ok(())
    }

    /// Text between two tags.
    fn character_data(&mut self, start: usize, end: usize) -> Scan<()> {
        let data = &self.text.as_bytes()[start..end];
        if data.iter().all(|&byte| is_blank(byte)) {
            return Ok(());
        }
        let stray = memmem::find(data, b"]]>").map(|at| start + at);
        self.references(start, stray.unwrap_or(end))?;
        if let Some(stray) = stray {
            return self.fault(stray, stray + 3, SyntaxProblem::StrayCdataEnd);
        }
        self.leaf(EntryKind::Text, start, end);
        Ok(())
    }

    /// Every reference of a stretch of text must be known.
    fn references(&mut self, start: usize, end: usize) -> Scan<()> {
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

    /// `<?xml version="1.0" …?>`, if the text begins with it.
    fn declaration(&mut self) -> Scan<()> {
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
    fn doctype(&mut self) -> Scan<()> {
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

    /// Reads a comment or a processing instruction, if one begins here; other things with `<!` are faults.
    fn comment_or_instruction(&mut self) -> Scan<bool> {
        let start = self.at;
        let rest = &self.text[start..];
        if rest.starts_with("<!--") {
            let body = &rest.as_bytes()[4..];
            let Some(length) = memmem::find(body, b"--") else {
                return self.fault(start, start + 4, SyntaxProblem::CommentNotEnded);
            };
            if body.get(length + 2) != Some(&b'>') {
                let dashes = start + 4 + length;
                let problem = match memmem::find(&body[length..], b"-->") {
                    Some(_) => SyntaxProblem::DoubleDash,
                    None => SyntaxProblem::CommentNotEnded,
                };
                let (from, to) =
                    if problem == SyntaxProblem::DoubleDash { (dashes, dashes + 2) } else { (start, start + 4) };
                return self.fault(from, to, problem);
            }
            self.leaf(EntryKind::Comment, start, start + 4 + length + 3);
            Ok(true)
        } else if rest.starts_with("<!") {
            self.fault(start, start + 2, SyntaxProblem::UnknownMarkup)
        } else if let Some(rest) = rest.strip_prefix("<?") {
            let name = &rest[..name_length(rest)];
            if name.eq_ignore_ascii_case("xml") {
                let problem = if start == 0 { SyntaxProblem::BadDeclaration } else { SyntaxProblem::LateDeclaration };
                return self.fault(start, start + 5, problem);
            }
            let body = &rest[name.len()..];
            let separated = body.starts_with("?>") || body.bytes().next().is_some_and(is_blank);
            match memmem::find(body.as_bytes(), b"?>") {
                Some(length) if !name.is_empty() && separated => {
                    self.leaf(EntryKind::Instruction, start, start + 2 + name.len() + length + 2);
                    Ok(true)
                }
                _ => self.fault(start, start + 2 + name.len(), SyntaxProblem::BadInstruction),
            }
        } else {
            Ok(false)
        }
    }

    /// `<name attribute="value" …>` or `… />`.
    fn start_tag(&mut self) -> Scan<()> {
        let start = self.at;
        let length = name_length(&self.text[start + 1..]);
        if length == 0 {
            return self.fault(start, start + 1, SyntaxProblem::TagWithoutName);
        }
        let name = Span { start: start + 1, end: start + 1 + length };
        self.at = name.end;
        self.attributes.clear();
        let empty = loop {
            let spaced = self.skip_blanks();
            match self.byte() {
                Some(b'>') => break false,
                Some(b'/') if self.text[self.at..].starts_with("/>") => break true,
                Some(b'<') | None => {
                    let problem = SyntaxProblem::TagNotEnded { name: self.excerpt(name.start, name.end) };
                    return self.fault(start, name.end, problem);
                }
                Some(_) => self.attribute(name, spaced)?,
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
            let found = self.text[start..].chars().next().unwrap_or_default();
            let name = self.excerpt(element.start, element.end);
            return self.fault(start, start + found.len_utf8(), SyntaxProblem::StrayInTag { found, name });
        }
        let text = self.text;
        let name = || Excerpt::new(&text[start..end]);
        if !spaced {
            return self.fault(start, end, SyntaxProblem::AttributesTouch { name: name() });
        }
        let mut at = self.after_blanks(end);
        if self.text.as_bytes().get(at) != Some(&b'=') {
            return self.fault(start, end, SyntaxProblem::AttributeWithoutValue { name: name() });
        }
        at = self.after_blanks(at + 1);
        let Some(&quote @ (b'"' | b'\'')) = self.text.as_bytes().get(at) else {
            let rest = &self.text[at..];
            let value = rest.find(|c: char| c.is_whitespace() || "/><\"'".contains(c)).unwrap_or(rest.len());
            let problem = match value {
                0 => SyntaxProblem::AttributeWithoutValue { name: name() },
                _ => SyntaxProblem::ValueWithoutQuotes { name: name() },
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
                    let problem = SyntaxProblem::ValueNotEnded { name: name(), quote: char::from(quote) };
                    return self.fault(value - 1, self.line_end(value - 1, b'<'), problem);
                }
            }
        }
        if referred {
            self.references(value, at)?;
        }
        self.attributes.push(Span { start, end });
        self.at = at + 1;
        Ok(())
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
    fn end_tag(&mut self, open: usize) -> Scan<()> {
        let start = self.at;
        let length = name_length(&self.text[start + 2..]);
        let found = &self.text[start + 2..start + 2 + length];
        self.at = start + 2 + length;
        let tag = self.entries[open].start as usize + 1;
        let open_name = &self.text[tag..tag + name_length(&self.text[tag..])];
        if length > 0 && found != open_name {
            let problem = SyntaxProblem::MismatchedEnd {
                found: Excerpt::new(found),
                open: Excerpt::new(open_name),
                line: line_of(self.text, tag),
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

    /// Adds a node with nothing within it, and goes on after it.
    fn leaf(&mut self, kind: EntryKind, start: usize, end: usize) {
        let next = self.entries.len() as u32 + 1;
        self.entries.push(Entry { start: start as u32, head_end: end as u32, end: end as u32, next, kind });
        self.at = end;
    }

    fn byte(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Goes over white space; whether there was some.
    fn skip_blanks(&mut self) -> bool {
        let start = self.at;
        self.at = self.after_blanks(start);
        self.at > start
    }

    fn after_blanks(&self, start: usize) -> usize {
        let bytes = &self.text.as_bytes()[start..];
        start + bytes.iter().position(|&byte| !is_blank(byte)).unwrap_or(bytes.len())
    }

    /// The end of what is worth underlining from `start` on: the end of the line, or `stop` after the first byte.
    fn line_end(&self, start: usize, stop: u8) -> usize {
        let bytes = &self.text.as_bytes()[start..];
        let length = bytes.iter().skip(1).position(|&byte| byte == b'\n' || byte == stop);
        let end = length.map_or(self.text.len(), |length| start + 1 + length);
        start + self.text[start..end].trim_end().len().max(1)
    }

    fn excerpt(&self, start: usize, end: usize) -> Excerpt {
        Excerpt::new(&self.text[start..end])
    }

    fn fault<T>(&self, start: usize, end: usize, problem: SyntaxProblem) -> Scan<T> {
        Err(Box::new(Fault { met_at: self.at.max(start), span: Span { start, end }, problem }))
    }
}

/// Whether a DOCTYPE's public identifier may hold the byte (production 13).
fn is_public_id(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b' ' | b'\r' | b'\n') || b"-'()+,./:=?;!*#@$_%".contains(&byte)
}
