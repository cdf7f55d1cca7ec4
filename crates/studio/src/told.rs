//! What the lower crates say, in the language of the window.

use lancer_formats::{Describe, Problem};
use lancer_scene::{EditError, Invalid};
use lancer_words::{Lang, studio::app as words};

/// A broken rule as a sentence without a full stop.
pub fn rule(rule: &Invalid, lang: Lang) -> String {
    Problem::from(rule.clone()).message(lang)
}

/// Why an edit cannot be made, as a sentence without a full stop.
pub fn edit(error: &EditError, lang: Lang) -> String {
    match error {
        EditError::NoSuchItem { .. } => words::no_such_item(lang),
        EditError::Invalid(invalid) => rule(invalid, lang),
        EditError::MaterialInUse { name, user } => words::material_in_use(lang, name, user),
    }
}
