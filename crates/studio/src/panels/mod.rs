//! The panels: each is a function of what it may read, and returns what the user wants.

pub mod explain;
pub mod history;
mod lines;
pub mod outliner;
pub mod problems;
pub mod properties;
pub mod text;
pub mod view;
pub mod xml;

use lancer_formats::Describe;
use lancer_formats::xml::XmlProblem;
use lancer_scene::Invalid;
use lancer_words::{Lang, studio::app as words};

/// Says that an edit would break a rule, and which.
pub(crate) fn refusal(rule: Invalid, lang: Lang) -> String {
    words::refused(lang, XmlProblem::Rule(rule).message(lang))
}
