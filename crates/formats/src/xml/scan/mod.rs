//! The tokeniser: one pass over the source text that proves it well-formed XML 1.0 and lists its nodes as offsets.
//!
//! It is written by hand because a document must be kept byte for byte and every fault must be told where it begins:
//! event readers neither give the places of attributes nor refuse all that the grammar refuses. There is no recursion,
//! and no entity is ever replaced by another text, so the work and the memory are linear in the text.

mod prolog;
mod tag;

use super::Excerpt;
use super::reference::{is_blank, is_legal, name_length};
use super::syntax::{CodePoint, SyntaxProblem};
use crate::Span;
use memchr::{memchr, memchr_iter, memmem};

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
    pub(super) span: Option<Span>,
    pub(super) problem: SyntaxProblem,
}

type Scan<T> = Result<T, Box<Fault>>;

/// The nodes of a text in document order. Text of nothing but white space is no node.
pub(super) fn scan(text: &str) -> Scan<Vec<Entry>> {
    let mut scanner =
        Scanner { text, at: 0, entries: Vec::new(), open: Vec::new(), attributes: Vec::new(), value: Span::default() };
    let result = scanner.document();
    let illegal = first_illegal(text);
    match (result, illegal) {
        (Ok(()), None) => Ok(scanner.entries),
        (Err(fault), Some(at)) if fault.met_at < at => Err(fault),
        (_, Some(at)) => {
            let character = text[at..].chars().next().unwrap_or_default();
            let span = Span { start: at, end: at + character.len_utf8() };
            let problem = SyntaxProblem::IllegalCharacter { code: CodePoint(character) };
            Err(Box::new(Fault { met_at: at, span: Some(span), problem }))
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
    /// The value of the last of them.
    value: Span,
}

impl<'t> Scanner<'t> {
    fn document(&mut self) -> Scan<()> {
        self.declaration()?;
        let (mut root, mut doctype) = (false, false);
        loop {
            self.skip_blanks();
            let rest = &self.text[self.at..];
            if rest.is_empty() {
                return if root { Ok(()) } else { self.no_place(SyntaxProblem::NoRoot) };
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
        Err(Box::new(Fault { met_at: self.at.max(start), span: Some(Span { start, end }), problem }))
    }

    /// A fault of the whole text.
    fn no_place<T>(&self, problem: SyntaxProblem) -> Scan<T> {
        Err(Box::new(Fault { met_at: self.text.len(), span: None, problem }))
    }
}
