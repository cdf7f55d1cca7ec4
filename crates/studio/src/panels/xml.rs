//! The scene as a document, as it would be saved for the first time.

use super::lines;
use crate::{Action, Context};

/// Shows the panel; gives what the user wants.
pub fn show(ui: &mut egui::Ui, context: &Context<'_>) -> Vec<Action> {
    lines::show(ui, context, "scene.xml", |stage, _| lancer_formats::xml::write_scene(&stage.scene))
}
