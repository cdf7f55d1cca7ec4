//! Undo and redo: a list of named snapshots and the place in it. Snapshots share what did not change, so the list is
//! limited by memory alone.

use crate::StepName;
use lancer_scene::Stage;

/// The steps of a document; the first one is how it began.
#[derive(Clone, Debug)]
pub struct History {
    steps: Vec<(StepName, Stage)>,
    current: usize,
}

impl History {
    /// A history of one step.
    pub(crate) fn new(name: StepName, stage: Stage) -> History {
        History { steps: vec![(name, stage)], current: 0 }
    }

    /// Adds a step after the current one; the steps that were undone are gone.
    pub(crate) fn push(&mut self, name: StepName, stage: Stage) {
        self.steps.truncate(self.current + 1);
        self.steps.push((name, stage));
        self.current += 1;
    }

    /// Goes to a step and gives its stage; `None` where there is no such step.
    pub(crate) fn jump(&mut self, step: usize) -> Option<&Stage> {
        let (_, stage) = self.steps.get(step)?;
        self.current = step;
        Some(stage)
    }

    /// The stage after a step.
    pub fn stage(&self, step: usize) -> Option<&Stage> {
        self.steps.get(step).map(|(_, stage)| stage)
    }

    /// The names of the steps, the oldest first.
    pub fn names(&self) -> impl ExactSizeIterator<Item = &StepName> {
        self.steps.iter().map(|(name, _)| name)
    }

    /// The place of the current step.
    pub fn current(&self) -> usize {
        self.current
    }

    /// The step that an undo takes back.
    pub fn undoable(&self) -> Option<&StepName> {
        (self.current > 0).then(|| self.steps.get(self.current).map(|(name, _)| name)).flatten()
    }

    /// The step that a redo brings back.
    pub fn redoable(&self) -> Option<&StepName> {
        self.steps.get(self.current + 1).map(|(name, _)| name)
    }
}
