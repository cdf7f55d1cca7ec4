//! The document: the stage, the history, the selection.

use crate::gesture::Gesture;
use crate::{History, Item, Selection, StepName};
use lancer_scene::{Edit, EditError, Stage};

/// A scene and its views while they are edited.
#[derive(Clone, Debug)]
pub struct Document {
    stage: Stage,
    revision: u64,
    history: History,
    gesture: Option<Gesture>,
    selection: Selection,
}

impl Document {
    /// A document that begins with a stage.
    pub fn new(name: StepName, stage: Stage) -> Document {
        Document {
            history: History::new(name, stage.clone()),
            stage,
            revision: 1,
            gesture: None,
            selection: Selection::default(),
        }
    }

    /// The scene and the views as they are now, within a gesture too.
    pub fn stage(&self) -> &Stage {
        &self.stage
    }

    /// A number that grows with every change of the stage.
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
        if stage != self.stage {
            self.follow(edit);
            self.history.push(name, stage.clone());
            self.show(stage);
        }
        Ok(())
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
        let Some(stage) = self.history.jump(step).cloned() else { return false };
        self.show(stage);
        true
    }

    fn show(&mut self, stage: Stage) {
        self.stage = stage;
        self.revision += 1;
        self.selection.prune(&self.stage);
    }

    /// Lets the selection follow what an edit renames.
    fn follow(&mut self, edit: &Edit) {
        use lancer_scene::ListEdit;
        let (scene, views) = (&self.stage.scene, &self.stage.views);
        let renamed = match edit {
            Edit::Objects(ListEdit::Set { index, item }) => {
                scene.objects.get(*index).map(|old| (Item::Object(old.name.clone()), Item::Object(item.name.clone())))
            }
            Edit::Lights(ListEdit::Set { index, item }) => {
                scene.lights.get(*index).map(|old| (Item::Light(old.name.clone()), Item::Light(item.name.clone())))
            }
            Edit::Materials(ListEdit::Set { index, item }) => scene
                .materials
                .get(*index)
                .map(|old| (Item::Material(old.name.clone()), Item::Material(item.name.clone()))),
            Edit::Views(ListEdit::Set { index, item }) => {
                views.get(*index).map(|old| (Item::View(old.name.clone()), Item::View(item.name.clone())))
            }
            Edit::Title(_)
            | Edit::World(_)
            | Edit::Materials(_)
            | Edit::Lights(_)
            | Edit::Objects(_)
            | Edit::Views(_)
            | Edit::Batch(_) => None,
        };
        if let Some((from, to)) = renamed {
            self.selection.rename(&from, &to);
        }
    }
}
