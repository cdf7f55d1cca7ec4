//! Commands: a step that can be made, as a value. Panels, menus and keys get one from a pure function of the stage and
//! hand it to the document.

use crate::{Item, StepName};
use lancer_scene::Edit;

/// A step: its name in the history, its edit, and what is selected after it.
#[derive(Clone, Debug, PartialEq)]
pub struct Command {
    /// The name of the step.
    pub name: StepName,
    /// What it changes.
    pub edit: Edit,
    /// What is selected afterwards; `None` leaves the selection as it is.
    pub select: Option<Vec<Item>>,
}

impl Command {
    /// A step that leaves the selection as it is.
    pub fn new(name: StepName, edit: Edit) -> Command {
        Command { name, edit, select: None }
    }

    /// The step with what is selected after it.
    #[must_use]
    pub fn selecting(self, items: Vec<Item>) -> Command {
        Command { select: Some(items), ..self }
    }
}
