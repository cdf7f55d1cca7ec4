//! What a panel may read.

use crate::report::Report;
use crate::swatches::Swatches;
use crate::theme::Palette;
use lancer_document::{Document, Item};
use lancer_scene::Name;
use lancer_words::Lang;

/// Everything that a panel shows. A panel is a function of this and of its own memory in egui.
#[derive(Clone, Copy, Debug)]
pub struct Context<'a> {
    /// Scene, views, history and selection.
    pub document: &'a Document,
    /// The language of every word.
    pub lang: Lang,
    /// The colours of the theme.
    pub palette: &'a Palette,
    /// The view that is worked in: new objects arrive in front of it.
    pub active_view: Option<&'a Name>,
    /// What is being renamed in the outliner.
    pub renaming: Option<&'a Item>,
    /// What was found in the files that were opened last, the newest last.
    pub reports: &'a [Report],
    /// Small pictures of materials, rendered beside the window.
    pub swatches: &'a Swatches,
}
