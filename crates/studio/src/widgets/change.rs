//! What became of a value: nothing, one change, or a drag that is one step however long it lasts.

use egui::{Id, Ui};

/// What the user did to a value in this frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change<T> {
    /// Nothing.
    Kept,
    /// A drag goes on; `started` in its first frame.
    Dragging {
        /// Whether this is the first frame of it.
        started: bool,
        /// What it has come to.
        value: T,
    },
    /// The drag is over.
    Released,
    /// One change: typed, picked, switched.
    Set(T),
}

impl<T> Change<T> {
    /// The change of something that this is a part of.
    pub fn map<U>(self, whole: impl FnOnce(T) -> U) -> Change<U> {
        match self {
            Change::Kept => Change::Kept,
            Change::Released => Change::Released,
            Change::Dragging { started, value } => Change::Dragging { started, value: whole(value) },
            Change::Set(value) => Change::Set(whole(value)),
        }
    }

    /// This change, or the other one where nothing happened here.
    #[must_use]
    pub fn or(self, other: Change<T>) -> Change<T> {
        match self {
            Change::Kept => other,
            Change::Released | Change::Dragging { .. } | Change::Set(_) => self,
        }
    }
}

/// Tells a drag from one change. `changed` is what the widgets themselves report, never a comparison of values: some
/// round what they show. As long as the pointer is down, changes belong to one drag.
pub fn track<T>(ui: &Ui, id: Id, changed: Option<T>) -> Change<T> {
    let id = id.with("drag");
    let active = ui.data(|data| data.get_temp::<bool>(id).unwrap_or(false));
    let down = ui.input(|input| input.pointer.any_down());
    let set_active = |active: bool| ui.data_mut(|data| data.insert_temp(id, active));
    match (changed, active, down) {
        (Some(value), _, true) => {
            set_active(true);
            // the release may come when nothing else happens
            ui.ctx().request_repaint();
            Change::Dragging { started: !active, value }
        }
        (Some(value), true, false) => Change::Dragging { started: false, value },
        (Some(value), false, false) => Change::Set(value),
        (None, true, false) => {
            set_active(false);
            Change::Released
        }
        (None, _, _) => Change::Kept,
    }
}
