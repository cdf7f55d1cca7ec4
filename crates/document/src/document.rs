//! The document: the stage, the history, the selection.

use crate::files::Files;
use crate::gesture::Gesture;
use crate::insert::{self, NewItem, Standpoint};
use crate::{Command, History, Item, Selection, StepName, arrange};
use lancer_scene::{Edit, EditError, Stage};
use std::sync::atomic::{AtomicU64, Ordering};

/// A number that no revision had before.
fn new_revision() -> u64 {
    static LAST: AtomicU64 = AtomicU64::new(0);
    LAST.fetch_add(1, Ordering::Relaxed) + 1
}

/// A scene and its views while they are edited.
#[derive(Clone, Debug)]
pub struct Document {
    stage: Stage,
    revision: u64,
    history: History,
    gesture: Option<Gesture>,
    selection: Selection,
    pub(crate) files: Files,
}

impl Document {
    /// A document that begins with a stage.
    pub fn new(name: StepName, stage: Stage) -> Document {
        Document {
            files: Files::none(stage.clone()),
            history: History::new(name, stage.clone()),
            stage,
            revision: new_revision(),
            gesture: None,
            selection: Selection::default(),
        }
    }

    /// The scene and the views as they are now, within a gesture too.
    pub fn stage(&self) -> &Stage {
        &self.stage
    }

    /// A number that grows with every change of the stage, and that no other document ever has.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// The steps.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// What is selected.
    pub fn selection(&self) -> &Selection {
        &self.selection
    }

    /// Changes what is selected; that is no step.
    pub fn select(&mut self, change: impl FnOnce(&mut Selection)) {
        change(&mut self.selection);
        self.selection.prune(&self.stage);
    }

    /// Makes an edit as one step. A gesture that is going on is committed first. An edit that changes nothing is no step.
    ///
    /// # Errors
    /// Why the edit cannot be made; the document is then as it was.
    pub fn apply(&mut self, name: StepName, edit: &Edit) -> Result<(), EditError> {
        self.commit();
        let (stage, _) = self.stage.apply(edit)?;
        self.replace(name, stage);
        Ok(())
    }

    /// Puts another stage in place of this one as a step, if it is another.
    pub(crate) fn replace(&mut self, name: StepName, stage: Stage) {
        self.commit();
        if stage != self.stage {
            self.history.push(name, stage.clone());
            self.show(stage);
        }
    }

    /// Begins a gesture, the one before committed.
    pub fn begin(&mut self, name: StepName) {
        self.commit();
        self.gesture = Some(Gesture { name, base: self.stage.clone() });
    }

    /// Whether a gesture is going on.
    pub fn in_gesture(&self) -> bool {
        self.gesture.is_some()
    }

    /// The stage before the gesture, or as it is where there is none.
    pub fn base(&self) -> &Stage {
        self.gesture.as_ref().map_or(&self.stage, |gesture| &gesture.base)
    }

    /// Shows what the gesture has come to: an edit of the stage before the gesture.
    ///
    /// # Errors
    /// Why the edit cannot be made; what the last preview showed stays.
    pub fn preview(&mut self, edit: &Edit) -> Result<(), EditError> {
        let (stage, _) = self.base().apply(edit)?;
        if stage != self.stage {
            self.show(stage);
        }
        Ok(())
    }

    /// Ends the gesture: what it shows becomes one step, if anything changed.
    pub fn commit(&mut self) {
        if let Some(gesture) = self.gesture.take()
            && gesture.base != self.stage
        {
            self.history.push(gesture.name, self.stage.clone());
        }
    }

    /// Ends the gesture and takes it back.
    pub fn cancel(&mut self) {
        if let Some(gesture) = self.gesture.take()
            && gesture.base != self.stage
        {
            self.show(gesture.base);
        }
    }

    /// Takes the last step back; whether there was one.
    pub fn undo(&mut self) -> bool {
        self.commit();
        self.history.current().checked_sub(1).is_some_and(|step| self.jump(step))
    }

    /// Brings the last undone step back; whether there was one.
    pub fn redo(&mut self) -> bool {
        self.commit();
        self.jump(self.history.current() + 1)
    }

    /// Goes to a step of the history; whether it exists.
    pub fn jump(&mut self, step: usize) -> bool {
        self.commit();
        let before = self.history.current();
        let Some(stage) = self.history.jump(step).cloned() else { return false };
        // step by step, so that the selection follows every new name on the way
        let steps = before.min(step)..=before.max(step);
        let mut way: Vec<&Stage> = steps.filter_map(|step| self.history.stage(step)).collect();
        if step < before {
            way.reverse();
        }
        for pair in way.windows(2) {
            let &[from, to] = pair else { continue };
            self.selection.follow(from, to);
        }
        self.show(stage);
        true
    }

    /// Makes the step of a command and selects what it asks for.
    ///
    /// # Errors
    /// Why its edit cannot be made; the document is then as it was.
    pub fn run(&mut self, command: Command) -> Result<(), EditError> {
        self.apply(command.name, &command.edit)?;
        if let Some(items) = command.select {
            self.select(|selection| selection.set(items));
        }
        Ok(())
    }

    /// Adds a thing in front of the active view and selects it.
    ///
    /// # Errors
    /// Why it cannot be added.
    pub fn add(&mut self, item: NewItem, at: &Standpoint) -> Result<(), EditError> {
        self.run(insert::added(&self.stage, item, at))
    }

    /// Deletes what is selected; whether anything was.
    ///
    /// # Errors
    /// Why it cannot be deleted.
    pub fn delete_selected(&mut self) -> Result<bool, EditError> {
        self.run_if(arrange::deleted(&self.stage, self.selection.iter()))
    }

    /// Copies what is selected and selects the copies; whether anything was.
    ///
    /// # Errors
    /// Why it cannot be copied.
    pub fn duplicate_selected(&mut self) -> Result<bool, EditError> {
        self.run_if(arrange::duplicated(&self.stage, self.selection.iter()))
    }

    /// Renames a thing; whether anything changed.
    ///
    /// # Errors
    /// The name is empty or taken.
    pub fn rename(&mut self, item: &Item, new: &str) -> Result<bool, EditError> {
        let command = arrange::renamed(&self.stage, item, new)?;
        self.run_if(command)
    }

    /// Brings a thing to another place of its list; whether anything changed.
    ///
    /// # Errors
    /// Why it cannot be moved there.
    pub fn reorder(&mut self, item: &Item, to: usize) -> Result<bool, EditError> {
        self.run_if(arrange::reordered(&self.stage, item, to))
    }

    /// Lets what is selected take part in the picture, or not; whether anything changed.
    ///
    /// # Errors
    /// Why it cannot be changed.
    pub fn show_selected(&mut self, visible: bool) -> Result<bool, EditError> {
        self.run_if(arrange::shown(&self.stage, self.selection.iter(), visible))
    }

    fn run_if(&mut self, command: Option<Command>) -> Result<bool, EditError> {
        command.map_or(Ok(false), |command| self.run(command).map(|()| true))
    }

    fn show(&mut self, stage: Stage) {
        self.selection.follow(&self.stage, &stage);
        self.stage = stage;
        self.revision = new_revision();
    }
}
