//! What the lower crates say, in the language of the window.

use lancer_formats::{Describe, Problem};
use lancer_render::{PixelFault, RenderError, SimdError, Tracing};
use lancer_scene::{EditError, Invalid};
use lancer_trace::Simd;
use lancer_words::{Lang, engine, studio::app as words, studio::view};

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

/// Why the engine cannot be had with the instructions that were asked for, as a whole sentence.
pub fn simd(error: &SimdError, lang: Lang) -> String {
    let cause = match error {
        SimdError::Unknown { name } => engine::unknown_simd(lang, Tracing::VARIABLE, name),
        SimdError::Missing { simd } => engine::missing_simd(lang, Tracing::VARIABLE, simd.name()),
    };
    let available = Simd::ALL.into_iter().filter(|simd| simd.is_available()).map(Simd::name).collect::<Vec<_>>();
    format!("{cause} ({}).", engine::available_simd(lang, available.join(", ")))
}

/// A sentence of a lower crate with its full stop.
pub fn sentence(message: &str) -> String {
    format!("{message}.")
}
