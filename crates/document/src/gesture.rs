//! Gestures: a drag or a slider's movement is one step, however many pictures it shows on its way.

use crate::StepName;
use lancer_scene::Stage;

/// A gesture that is going on.
#[derive(Clone, Debug)]
pub(crate) struct Gesture {
    /// The name of the step that it will be.
    pub(crate) name: StepName,
    /// The stage as it was before; every preview is an edit of this one.
    pub(crate) base: Stage,
}
