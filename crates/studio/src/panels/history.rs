//! The steps of the document; a click goes to one.

use crate::widgets::line;
use crate::{Action, Context};
use egui::{RichText, ScrollArea, Ui};

/// The height of a row.
const ROW: f32 = 22.0;

/// Shows the panel; gives what the user wants.
pub fn show(ui: &mut Ui, context: &Context<'_>) -> Vec<Action> {
    let mut actions = Vec::new();
    let history = context.document.history();
    let names: Vec<String> = history.names().map(|name| name.text(context.lang)).collect();
    ui.spacing_mut().item_spacing.y = 0.0;
    ScrollArea::vertical().auto_shrink(false).stick_to_bottom(true).show_rows(ui, ROW, names.len(), |ui, seen| {
        for step in seen {
            let current = step == history.current();
            let text = RichText::new(format!("{}   {}", step + 1, names[step]));
            let text = if step > history.current() { text.weak().italics() } else { text };
            let size = egui::vec2(ui.available_width(), ROW);
            if line(ui, size, current, &names[step], text).clicked() {
                actions.push(Action::Jump(step));
            }
        }
    });
    actions
}
