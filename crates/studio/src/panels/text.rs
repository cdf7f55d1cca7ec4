//! The scene in words, as the subject asks for it (§5.1) and `lancer show` prints it.

use super::lines;
use crate::{Action, Context};

/// Shows the panel; gives what the user wants.
pub fn show(ui: &mut egui::Ui, context: &Context<'_>) -> Vec<Action> {
    lines::show(
        ui,
        context,
        "scene.txt",
        |document, lang| {
            let stage = document.stage();
            let mut text = lancer_formats::text::describe(&stage.scene, lang);
            if !stage.views.is_empty() {
                text.push('\n');
                text.push_str(&lancer_formats::text::describe_views(&stage.views, lang));
            }
            text
        },
        |_| (),
    )
}
