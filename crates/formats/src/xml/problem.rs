//! Everything that can be wrong with an XML document, and how it is told.

use super::SyntaxProblem;
use crate::Describe;
use lancer_words::{Lang, xml::Report};
use std::fmt;

/// What is wrong with an XML document.
#[derive(Clone, Debug, PartialEq)]
pub enum XmlProblem {
    /// The bytes are no well-formed XML.
    Syntax(SyntaxProblem),
}

impl From<SyntaxProblem> for XmlProblem {
    fn from(problem: SyntaxProblem) -> XmlProblem {
        XmlProblem::Syntax(problem)
    }
}

impl XmlProblem {
    fn report(&self, lang: Lang) -> Report {
        match self {
            XmlProblem::Syntax(problem) => problem.report(lang),
        }
    }
}

impl Describe for XmlProblem {
    fn code(&self) -> &'static str {
        match self {
            XmlProblem::Syntax(problem) => problem.code(),
        }
    }

    fn message(&self, lang: Lang) -> String {
        self.report(lang).message
    }

    fn label(&self, lang: Lang) -> String {
        self.report(lang).label
    }

    fn help(&self, lang: Lang) -> Option<String> {
        Some(self.report(lang).help).filter(|help| !help.is_empty())
    }
}

/// A piece of a document as a message quotes it: on one line, and short whatever the document holds.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Excerpt(Box<str>);

impl Excerpt {
    /// Longer texts are cut.
    const CHARACTERS: usize = 48;

    /// The beginning of a text.
    pub fn new(text: &str) -> Excerpt {
        let clean = |character: char| if character.is_control() { ' ' } else { character };
        let mut short: String = text.chars().take(Excerpt::CHARACTERS).map(clean).collect();
        if text.chars().nth(Excerpt::CHARACTERS).is_some() {
            short.push('…');
        }
        Excerpt(short.into())
    }
}

impl fmt::Display for Excerpt {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}
