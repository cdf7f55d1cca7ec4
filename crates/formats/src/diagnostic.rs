//! What readers say of a document: located problems that can be told in each language.

use lancer_scene::Finding;
use lancer_words::Lang;
use std::sync::Arc;

/// A run of bytes of a source text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// The first byte.
    pub start: usize,
    /// The byte after the last.
    pub end: usize,
}

/// A source text, decoded to UTF-8, with the name that messages give it.
#[derive(Clone, Debug)]
pub struct Source {
    /// The path as the user gave it.
    pub name: Arc<str>,
    /// The whole text.
    pub text: Arc<str>,
}

impl Source {
    /// Line and column of a byte, both from 1, the column in characters. For many places, take [`Lines`].
    pub fn position(&self, offset: usize) -> (usize, usize) {
        let offset = self.text.floor_char_boundary(offset);
        let before = &self.text[..offset];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
    }
}

/// Where the lines of a text begin, for the places of many problems in a long text.
#[derive(Clone, Debug)]
pub struct Lines {
    starts: Vec<usize>,
}

impl Lines {
    /// Finds the lines of a text.
    pub fn new(text: &str) -> Lines {
        let starts = memchr::memchr_iter(b'\n', text.as_bytes()).map(|newline| newline + 1);
        Lines { starts: std::iter::once(0).chain(starts).collect() }
    }

    /// The number of the line that holds an offset, from 1.
    pub fn line(&self, offset: usize) -> usize {
        self.starts.partition_point(|start| *start <= offset)
    }

    /// The first byte of the line that holds an offset.
    pub fn start(&self, offset: usize) -> usize {
        self.starts.get(self.line(offset) - 1).copied().unwrap_or_default()
    }
}

/// How bad a problem is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Severity {
    /// The document is legal, but perhaps not what was meant.
    Warning,
    /// The document breaks a rule.
    Error,
}

/// A problem and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// The bytes it is about; `None` where a file has no text.
    pub span: Option<Span>,
    /// What is wrong.
    pub problem: Problem,
}

impl Diagnostic {
    /// An error at a place.
    pub fn error(span: impl Into<Option<Span>>, problem: impl Into<Problem>) -> Diagnostic {
        Diagnostic { severity: Severity::Error, span: span.into(), problem: problem.into() }
    }

    /// A warning at a place.
    pub fn warning(span: impl Into<Option<Span>>, problem: impl Into<Problem>) -> Diagnostic {
        Diagnostic { severity: Severity::Warning, span: span.into(), problem: problem.into() }
    }
}

/// A value as far as it could be read, and everything there is to say about it.
#[derive(Clone, Debug)]
pub struct Outcome<T> {
    /// The value; `None` if some diagnostic is an error.
    pub value: Option<T>,
    /// All that was found, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
}

/// How a problem is told.
pub trait Describe {
    /// A stable code such as `xml::unknown-attribute`.
    fn code(&self) -> &'static str;
    /// The sentence that says what is wrong; no full stop.
    fn message(&self, lang: Lang) -> String;
    /// The words under the underlined text; may be empty.
    fn label(&self, lang: Lang) -> String;
    /// The rule or the way out.
    fn help(&self, lang: Lang) -> Option<String>;
}

macro_rules! problems {
    ($($variant:ident($problem:ty),)*) => {
        /// Everything that can be wrong, by the format that says it.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Problem {$(
            #[doc = concat!("Said by [`", stringify!($problem), "`].")]
            $variant($problem),
        )*}

        impl Describe for Problem {
            fn code(&self) -> &'static str {
                match self { $(Problem::$variant(problem) => problem.code(),)* }
            }
            fn message(&self, lang: Lang) -> String {
                match self { $(Problem::$variant(problem) => problem.message(lang),)* }
            }
            fn label(&self, lang: Lang) -> String {
                match self { $(Problem::$variant(problem) => problem.label(lang),)* }
            }
            fn help(&self, lang: Lang) -> Option<String> {
                match self { $(Problem::$variant(problem) => problem.help(lang),)* }
            }
        }

        $(impl From<$problem> for Problem {
            fn from(problem: $problem) -> Problem {
                Problem::$variant(problem)
            }
        })*
    };
}

problems! {
    Xml(crate::xml::XmlProblem),
    N7(crate::n7_2009::N7Problem),
    Nff(crate::nff::NffProblem),
    Binary(crate::binary::BinaryProblem),
    Mesh(crate::mesh::MeshProblem),
    Picture(crate::picture::PictureProblem),
    Export(crate::export::Loss),
    Lint(Finding),
}
