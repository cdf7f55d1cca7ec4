//! Everything that can be wrong with an XML document, and how it is told.

use super::{StructureProblem, SyntaxProblem, ValueProblem};
use crate::{Describe, Problem};
use lancer_scene::Invalid;
use lancer_words::{Lang, xml::Report, xml::value as words};
use std::fmt;

/// What is wrong with an XML document.
#[derive(Clone, Debug, PartialEq)]
pub enum XmlProblem {
    /// The bytes are no well-formed XML.
    Syntax(SyntaxProblem),
    /// A value is not written as it must be.
    Value(ValueProblem),
    /// An element, an attribute, a name or a reference is not what the vocabulary asks for.
    Structure(StructureProblem),
    /// A scene or a view would break a rule.
    Rule(Invalid),
}

impl XmlProblem {
    fn told(&self, lang: Lang) -> (&'static str, Report) {
        match self {
            XmlProblem::Syntax(problem) => problem.told(lang),
            XmlProblem::Value(problem) => problem.told(lang),
            XmlProblem::Structure(problem) => problem.told(lang),
            XmlProblem::Rule(rule) => super::rule::told(rule, lang),
        }
    }
}

impl Describe for XmlProblem {
    fn code(&self) -> &'static str {
        self.told(Lang::English).0
    }

    fn message(&self, lang: Lang) -> String {
        self.told(lang).1.message
    }

    fn label(&self, lang: Lang) -> String {
        self.told(lang).1.label
    }

    fn help(&self, lang: Lang) -> Option<String> {
        Some(self.told(lang).1.help).filter(|help| !help.is_empty())
    }
}

macro_rules! kinds {
    ($($kind:ident($problem:ty);)*) => {$(
        impl From<$problem> for XmlProblem {
            fn from(problem: $problem) -> XmlProblem {
                XmlProblem::$kind(problem)
            }
        }

        impl From<$problem> for Problem {
            fn from(problem: $problem) -> Problem {
                Problem::Xml(XmlProblem::$kind(problem))
            }
        }
    )*};
}

kinds! {
    Syntax(SyntaxProblem);
    Value(ValueProblem);
    Structure(StructureProblem);
    Rule(Invalid);
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

impl AsRef<str> for Excerpt {
    fn as_ref(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for Excerpt {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

/// The legal word that was probably meant, if one is near.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Guess(pub Option<Excerpt>);

impl Guess {
    /// The nearest of several legal words.
    pub fn among<'a>(found: &str, legal: impl IntoIterator<Item = &'a str>) -> Guess {
        Guess(super::nearest::nearest(found, legal).map(Excerpt::new))
    }

    pub(crate) fn word(&self, lang: Lang) -> String {
        match &self.0 {
            Some(name) => words::did_you_mean(lang, name),
            None => words::unknown(lang),
        }
    }
}
