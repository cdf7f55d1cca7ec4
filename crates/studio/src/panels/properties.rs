//! Every attribute of what is selected.

use crate::{Action, Context};

/// Shows the panel; gives what the user wants.
pub fn show(_ui: &mut egui::Ui, _context: &Context<'_>) -> Vec<Action> {
    Vec::new()
}
