//! A hierarchy of boxes, eight to a node, over anything that has bounds. It knows boxes and items only; the caller owns
//! the items.
//!
//! The boxes cull conservatively: single precision throws away what a ray cannot meet, and whatever is left is decided
//! by the caller in double precision. So the answer is that of trying every item, whatever way the tree is walked.
//!
//! What may be relied on: a box holds everything that its items hold, as double precision says it, seen from
//! [`Bvh::origin`]. The arithmetic of a ray adds errors of its own that grow with its distance; [`Bvh::margin`] says by
//! how much the boxes have to be wider for a ray.

mod beam;
mod block;
mod bounds;
mod build;
mod cost;
mod extreme;
mod huge;
mod node;
mod shadow;
mod turns;
mod walk;

#[cfg(test)]
mod tests;

pub(crate) use beam::{Beam, Visit};
pub(crate) use block::{Block, NO_FACET, Triangles};
pub(crate) use bounds::Bounds;
pub(crate) use build::{Frame, Source};
pub(crate) use node::{Child, Entry, Node};
pub(crate) use shadow::{Shadow, Start};
pub(crate) use turns::Follow;
pub(crate) use walk::Sight;

use glam::DVec3;

/// How many children a node has at most.
pub(crate) const WIDTH: usize = 8;

/// How many nodes lie on the longest way from the root to a leaf, whatever the input. A traversal that pushes all
/// children but one at each level needs a stack of `MAX_DEPTH · (WIDTH - 1) + 1`.
pub(crate) const MAX_DEPTH: usize = 48;

/// The hierarchy. An empty one has no nodes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bvh {
    origin: DVec3,
    nodes: Vec<Node>,
    bounds: Option<Bounds>,
}

/// How much wider the boxes have to be for a ray, on every side: what the double-precision arithmetic of ray and item
/// may be off, in the hierarchy's own lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Margin {
    /// For every ray.
    pub(crate) fixed: f64,
    /// Times the greatest coordinate of the ray's origin in the world.
    pub(crate) per_origin: f64,
}

impl Margin {
    /// How many roundings of the greatest number an intersection adds up at most.
    pub(crate) const ROUNDINGS: f64 = 64.0 * f64::EPSILON;

    /// The margin of a ray that starts at `origin` in the world.
    pub(crate) fn at(self, origin: DVec3) -> f64 {
        self.fixed + self.per_origin * origin.abs().max_element()
    }
}

impl Bvh {
    /// Builds over the bounds of items 0, 1, 2 … and gives the items in the order of the leaves: a leaf is
    /// `order[first..first + count]`.
    pub(crate) fn build(bounds: &[Bounds]) -> (Bvh, Vec<u32>) {
        Bvh::over(&Boxes(bounds))
    }

    /// Builds over a source, and gives its packs in the order of the leaves: a leaf is `packs[first..first + count]`.
    pub(crate) fn over<S: Source>(source: &S) -> (Bvh, Vec<S::Pack>) {
        build::build(source)
    }

    /// What the coordinates of nodes and blocks are relative to.
    pub(crate) fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The nodes; the first one is the root.
    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The box around everything.
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        self.bounds
    }

    /// The greatest coordinate, relative to the origin.
    pub(crate) fn extent(&self) -> f32 {
        let extent = |bounds: Bounds| (bounds.low - self.origin).abs().max((bounds.high - self.origin).abs());
        self.bounds.map_or(0.0, |bounds| (extent(bounds).max_element() * 1.000_001) as f32)
    }

    /// The margin of rays that are given in the hierarchy's own space.
    pub(crate) fn margin(&self) -> Margin {
        let reach = self.bounds.map_or(0.0, |bounds| bounds.reach());
        Margin { fixed: Margin::ROUNDINGS * reach, per_origin: Margin::ROUNDINGS }
    }
}

/// Boxes that are items by themselves: a pack is one number.
struct Boxes<'a>(&'a [Bounds]);

impl Source for Boxes<'_> {
    type Pack = u32;
    const PACK: usize = 1;

    fn len(&self) -> usize {
        self.0.len()
    }

    fn hull(&self) -> Bounds {
        self.0.iter().copied().fold(Bounds::EMPTY, Bounds::union)
    }

    fn bounds(&self, number: u32) -> Bounds {
        self.0[number as usize]
    }

    fn cost(packs: usize) -> f32 {
        packs as f32
    }

    fn pack(&self, numbers: &[u32], _: &Frame, place: &mut u32) -> Bounds {
        numbers.iter().fold(Bounds::EMPTY, |_, &number| {
            *place = number;
            self.0[number as usize]
        })
    }
}
