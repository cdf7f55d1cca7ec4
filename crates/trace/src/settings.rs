//! What of the model is computed, and how far.

use crate::World;
use lancer_scene::{Steps, View};

/// The limits and the steps of a computation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// A ray of this level casts no further ray.
    pub depth: u32,
    /// The steps that are carried out.
    pub steps: Steps,
    /// How many rays of all kinds a pixel may cost before it is an error.
    pub max_rays: u64,
}

impl Settings {
    /// The budget of a pixel's rays where nobody says otherwise.
    pub const MAX_RAYS: u64 = 1_000_000;

    /// What a view asks for: its own depth or the world's, its steps, the usual budget.
    pub fn of(world: &World, view: &View) -> Settings {
        Settings { depth: view.depth.unwrap_or(world.environment().depth), steps: view.steps, max_rays: Self::MAX_RAYS }
    }
}
