//! What a panel may read.

use crate::explainer::Explainer;
use crate::report::Report;
use crate::settings::Settings;
use crate::swatches::Swatches;
use crate::theme::Palette;
use lancer_document::{Document, Item};
use lancer_scene::View;
use lancer_words::Lang;
use std::path::Path;
use std::sync::Arc;

/// Everything that a panel shows. A panel is a function of this and of its own memory in egui.
#[derive(Clone, Copy, Debug)]
pub struct Context<'a> {
    /// Scene, views, history and selection.
    pub document: &'a Document,
    /// The language of every word.
    pub lang: Lang,
    /// The colours of the theme.
    pub palette: &'a Palette,
    /// The name of the view that is worked in: new objects arrive in front of it.
    pub active: Option<&'a str>,
    /// The pane of that view.
    pub pane: Option<PaneState>,
    /// What is remembered: which panels are shown, the recent files.
    pub settings: &'a Settings,
    /// The file of the scene.
    pub path: Option<&'a Path>,
    /// Whether there are changes that are not saved.
    pub modified: bool,
    /// What is being renamed in the outliner.
    pub renaming: Option<&'a Item>,
    /// What was found in the files that were opened last, the newest last.
    pub reports: &'a [Report],
    /// The pixel that is explained, and its explanation.
    pub explainer: &'a Explainer,
    /// Small pictures of materials, rendered beside the window.
    pub swatches: &'a Swatches,
}

/// What menus need to know of the pane of the active view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PaneState {
    /// The picture fits the pane.
    pub fit: bool,
    /// Grid and axes are shown.
    pub grid: bool,
    /// The work rests.
    pub paused: bool,
    /// The view is in a window of its own.
    pub detached: bool,
}

impl Context<'_> {
    /// The view that is worked in.
    pub fn active_view(&self) -> Option<&Arc<View>> {
        let name = self.active?;
        self.document.stage().views.iter().find(|view| &*view.name == name)
    }
}
