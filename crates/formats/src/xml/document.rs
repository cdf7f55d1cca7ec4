//! A document as it was read: the source text and a flat table of its nodes, each a few offsets.
//!
//! There is no second tree: an element's name, attributes and text are looked up in the source when they are asked for,
//! so a list of a million numbers is one span. Both the native reader and the reader of the documents of 2009 walk it.

use super::encoding::{self, Encoding};
use super::reference::{is_blank, name_length, unescape};
use super::scan::{Entry, EntryKind, scan};
use crate::{Diagnostic, Source, Span};
use std::borrow::Cow;
use std::sync::Arc;

/// A well-formed document.
#[derive(Clone, Debug)]
pub struct Document {
    source: Source,
    encoding: Encoding,
    entries: Arc<Vec<Entry>>,
    root: usize,
}

/// A document that is not well-formed: its text as far as it could be decoded, and the first fault.
#[derive(Clone, Debug)]
pub struct Malformed {
    /// The text, for the report.
    pub source: Source,
    /// The first fault.
    pub diagnostic: Diagnostic,
}

impl Document {
    /// Decodes the bytes of a document and proves them well-formed.
    ///
    /// # Errors
    /// The first fault: bytes that are no text, or a text that is no well-formed XML 1.0. Refused too are a DOCTYPE with
    /// declarations of its own, entities that are not predefined, nesting deeper than [`super::MAX_DEPTH`], and files
    /// of more than 4 GiB.
    pub fn read(name: impl Into<Arc<str>>, bytes: &[u8]) -> Result<Document, Box<Malformed>> {
        let malformed = |source, diagnostic| Box::new(Malformed { source, diagnostic });
        let (source, encoding) = encoding::decode(name.into(), bytes)
            .map_err(|(source, span, problem)| malformed(source, Diagnostic::error(span, problem)))?;
        match scan(&source.text) {
            Ok(entries) => {
                let root = entries.iter().position(|entry| entry.kind == EntryKind::Element).unwrap_or_default();
                Ok(Document { source, encoding, entries: Arc::new(entries), root })
            }
            Err(fault) => Err(malformed(source, Diagnostic::error(fault.span, fault.problem))),
        }
    }

    /// The source text, with the name that messages give it.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// The source text.
    pub fn text(&self) -> &str {
        &self.source.text
    }

    /// How the text stands in bytes.
    pub fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// The bytes of the document: those that it was read from.
    pub fn to_bytes(&self) -> Vec<u8> {
        self.encoding.encode(self.text())
    }

    /// The element that holds everything.
    pub fn root(&self) -> Element<'_> {
        Element { document: self, index: self.root }
    }
}

/// An element of a document.
#[derive(Clone, Copy, Debug)]
pub struct Element<'d> {
    document: &'d Document,
    index: usize,
}

impl<'d> Element<'d> {
    fn entry(self) -> &'d Entry {
        &self.document.entries[self.index]
    }

    fn slice(self, span: Span) -> &'d str {
        &self.document.text()[span.start..span.end]
    }

    /// The element's name, with its prefix.
    pub fn name(self) -> &'d str {
        self.slice(self.name_span())
    }

    /// The name in the start tag.
    pub fn name_span(self) -> Span {
        let start = self.entry().start as usize + 1;
        Span { start, end: start + name_length(&self.document.text()[start..]) }
    }

    /// The whole element, from the `<` of its start tag to after its end tag.
    pub fn span(self) -> Span {
        Span { start: self.entry().start as usize, end: self.entry().end as usize }
    }

    /// The start tag, or the whole of `<name …/>`.
    pub fn start_tag(self) -> Span {
        Span { start: self.entry().start as usize, end: self.entry().head_end as usize }
    }

    /// What stands between start tag and end tag; `None` for `<name …/>`.
    pub fn content_span(self) -> Option<Span> {
        let (head, whole) = (self.start_tag(), self.span());
        if head.end == whole.end {
            return None;
        }
        let end_tag = self.slice(Span { start: head.end, end: whole.end }).rfind("</").unwrap_or_default();
        Some(Span { start: head.end, end: head.end + end_tag })
    }

    /// The attributes in the order of the text, namespace declarations too.
    pub fn attributes(self) -> Attributes<'d> {
        let tag = self.start_tag();
        let slash = if self.slice(tag).ends_with("/>") { 2 } else { 1 };
        Attributes { text: self.document.text(), at: self.name_span().end, end: tag.end - slash }
    }

    /// The attribute of that name.
    pub fn attribute(self, name: &str) -> Option<Attribute<'d>> {
        self.attributes().find(|attribute| attribute.name == name)
    }

    /// The nodes directly within the element. Text of nothing but white space is no node.
    pub fn children(self) -> Children<'d> {
        Children { document: self.document, index: self.index + 1, end: self.entry().next as usize }
    }

    /// The elements directly within the element.
    pub fn elements(self) -> impl Iterator<Item = Element<'d>> {
        self.children().filter_map(|node| match node {
            Node::Element(element) => Some(element),
            Node::Text(_) | Node::Comment(_) | Node::Instruction(_) => None,
        })
    }

    /// The texts directly within the element; comments between them part them.
    pub fn texts(self) -> impl Iterator<Item = Text<'d>> {
        self.children().filter_map(|node| match node {
            Node::Text(text) => Some(text),
            Node::Element(_) | Node::Comment(_) | Node::Instruction(_) => None,
        })
    }
}

/// A node within an element.
#[derive(Clone, Copy, Debug)]
pub enum Node<'d> {
    /// An element.
    Element(Element<'d>),
    /// Text that is more than white space.
    Text(Text<'d>),
    /// A comment, with its delimiters.
    Comment(Span),
    /// A processing instruction, with its delimiters.
    Instruction(Span),
}

impl Node<'_> {
    /// The node's bytes.
    pub fn span(&self) -> Span {
        match self {
            Node::Element(element) => element.span(),
            Node::Text(text) => text.span,
            Node::Comment(span) | Node::Instruction(span) => *span,
        }
    }
}

/// The nodes of an element in the order of the text.
#[derive(Clone, Debug)]
pub struct Children<'d> {
    document: &'d Document,
    index: usize,
    end: usize,
}

impl<'d> Iterator for Children<'d> {
    type Item = Node<'d>;

    fn next(&mut self) -> Option<Node<'d>> {
        if self.index >= self.end {
            return None;
        }
        let index = self.index;
        let entry = &self.document.entries[index];
        self.index = entry.next as usize;
        let span = Span { start: entry.start as usize, end: entry.end as usize };
        Some(match entry.kind {
            EntryKind::Element => Node::Element(Element { document: self.document, index }),
            EntryKind::Text => {
                let raw = &self.document.text()[span.start..span.end];
                Node::Text(Text { span, raw, literal: false })
            }
            EntryKind::Cdata => {
                let span = Span { start: span.start + "<![CDATA[".len(), end: span.end - "]]>".len() };
                let raw = &self.document.text()[span.start..span.end];
                Node::Text(Text { span, raw, literal: true })
            }
            EntryKind::Comment => Node::Comment(span),
            EntryKind::Instruction => Node::Instruction(span),
        })
    }
}

/// A stretch of text between two tags or comments.
#[derive(Clone, Copy, Debug)]
pub struct Text<'d> {
    /// The raw text's bytes; of a CDATA section those within its delimiters.
    pub span: Span,
    /// The text as it stands in the source.
    pub raw: &'d str,
    literal: bool,
}

impl<'d> Text<'d> {
    /// The text that is meant: references resolved, line ends made `\n`.
    pub fn value(&self) -> Cow<'d, str> {
        if self.literal { Cow::Borrowed(self.raw) } else { unescape(self.raw, false) }
    }

    /// Whether it means nothing but white space.
    pub fn is_blank(&self) -> bool {
        self.value().bytes().all(is_blank)
    }

    /// The bytes without the white space around them.
    pub fn trimmed_span(&self) -> Span {
        let blank = |character: char| u8::try_from(character).is_ok_and(is_blank);
        let start = self.span.start + self.raw.len() - self.raw.trim_start_matches(blank).len();
        Span { start, end: start + self.raw.trim_matches(blank).len() }
    }
}

/// An attribute of an element.
#[derive(Clone, Copy, Debug)]
pub struct Attribute<'d> {
    /// The name, with its prefix.
    pub name: &'d str,
    /// The value as it stands in the source, without its quotes.
    pub raw: &'d str,
    /// The name's bytes.
    pub name_span: Span,
    /// The value's bytes, without its quotes.
    pub value_span: Span,
}

impl<'d> Attribute<'d> {
    /// The value that is meant: references resolved, line ends and tabs made blanks.
    pub fn value(&self) -> Cow<'d, str> {
        unescape(self.raw, true)
    }

    /// The attribute from its name to after its closing quote.
    pub fn span(&self) -> Span {
        Span { start: self.name_span.start, end: self.value_span.end + 1 }
    }

    /// Whether it is one of XML's own, `xml:*` or `xmlns*`, which every reader lets pass.
    pub fn is_reserved(&self) -> bool {
        self.name == "xmlns" || self.name.starts_with("xml:") || self.name.starts_with("xmlns:")
    }
}

/// The attributes of an element in the order of the text.
#[derive(Clone, Debug)]
pub struct Attributes<'d> {
    text: &'d str,
    at: usize,
    end: usize,
}

impl<'d> Iterator for Attributes<'d> {
    type Item = Attribute<'d>;

    // The scan has proved the tag, so what is looked for is there; if it were not, the attributes would simply end.
    fn next(&mut self) -> Option<Attribute<'d>> {
        let bytes = &self.text.as_bytes()[..self.end];
        let find = |from: usize, wanted: &dyn Fn(u8) -> bool| {
            bytes.get(from..)?.iter().position(|&byte| wanted(byte)).map(|at| from + at)
        };
        let start = find(self.at, &|byte| !is_blank(byte))?;
        let name_span = Span { start, end: start + name_length(&self.text[start..self.end]) };
        let quote = find(name_span.end, &|byte| matches!(byte, b'"' | b'\''))?;
        let value = quote + 1;
        let value_span = Span { start: value, end: value + memchr::memchr(bytes[quote], &bytes[value..])? };
        self.at = value_span.end + 1;
        Some(Attribute {
            name: &self.text[name_span.start..name_span.end],
            raw: &self.text[value_span.start..value_span.end],
            name_span,
            value_span,
        })
    }
}
