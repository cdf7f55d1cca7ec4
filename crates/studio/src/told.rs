//! What the lower crates say, in the language of the window.

use lancer_formats::{Describe, Problem};
use lancer_render::{PixelFault, RenderError};
use lancer_scene::{EditError, Invalid};
use lancer_words::{Lang, studio::app as words, studio::view};

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

/// Why a picture cannot be rendered, as a whole sentence.
pub fn render(error: &RenderError, lang: Lang) -> String {
    let cause = match error {
        RenderError::Cancelled | RenderError::Region { .. } => error.to_string(),
        RenderError::View(invalid) => rule(invalid, lang),
        RenderError::Memory { width, height } => words::no_memory(lang, width, height),
        RenderError::Threads { reason } => words::no_threads(lang, reason),
        RenderError::Pixel { x, y, fault: PixelFault::Budget { limit } } => view::over_budget(lang, x, y, limit),
        RenderError::Pixel { x, y, fault: PixelFault::NotFinite } => view::not_a_number(lang, x, y),
    };
    words::cannot_export(lang, cause)
}

/// A sentence of a lower crate with its full stop.
pub fn sentence(message: &str) -> String {
    format!("{message}.")
}
