//! The compiled scene: flat arrays of bodies, surfaces and lamps, and hierarchies of boxes over what is bounded.
//!
//! Only what takes part in the picture is here: invisible objects and lamps are left out. Everything that costs more
//! than a glance at each object is shared: between clones, between a world and those that are updated from it, and
//! between objects of one geometry.

mod body;
mod compile;
mod contains;
mod facets;
mod few;
mod media;
mod packed;
mod packs;
mod placed;
mod stats;
mod surfaces;
mod top;

#[cfg(test)]
mod tests;

pub(crate) use body::{Body, Extent, Geometry};
pub(crate) use facets::Facets;
pub(crate) use few::{FEW, Few};
pub(crate) use media::Media;
pub use stats::BuildStats;

use crate::bvh::Bvh;
use glam::DVec3;
use lancer_scene::{Color, Environment, Name, Scene, Surface};
use packs::Packs;
use std::sync::Arc;
use top::Top;

/// A scene ready for rays. A clone costs little.
#[derive(Clone, Debug, Default)]
pub struct World {
    /// What was compiled: an update compares by identity with it.
    scene: Scene,
    surfaces: Arc<Vec<Surface>>,
    lamps: Arc<Vec<Lamp>>,
    bodies: Arc<Vec<Body>>,
    top: Arc<Top>,
    packs: Packs,
}

/// A lamp that takes part.
#[derive(Clone, Debug)]
pub(crate) struct Lamp {
    pub(crate) name: Name,
    pub(crate) position: DVec3,
    pub(crate) color: Color,
}

impl World {
    /// Ambient light, background, medium, depth and composition.
    pub fn environment(&self) -> &Environment {
        &self.scene.world
    }

    /// A body by its number.
    pub(crate) fn body(&self, number: u32) -> &Body {
        &self.bodies[number as usize]
    }

    /// The bodies in document order.
    pub(crate) fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// A surface by its number.
    pub(crate) fn surface(&self, number: u32) -> &Surface {
        &self.surfaces[number as usize]
    }

    /// The lamps in document order.
    pub(crate) fn lamps(&self) -> &[Lamp] {
        &self.lamps
    }

    /// The bodies that every ray is tried against.
    pub(crate) fn unbounded(&self) -> &[u32] {
        self.top.unbounded()
    }

    /// The bounded bodies by the balls around them, if they are few.
    pub(crate) fn few(&self) -> Option<&Few> {
        self.top.few()
    }

    /// The hierarchy over the bounded bodies, and their numbers in the order of its leaves.
    pub(crate) fn bounded(&self) -> (&Bvh, &[u32]) {
        self.top.bounded()
    }
}
