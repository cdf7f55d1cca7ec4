//! Rays in f32, as the boxes of a hierarchy see them.
//!
//! How far f32 may be off: an origin relative to the hierarchy's is off by 2⁻²⁴ of itself, and so are products and
//! differences with the boxes' coordinates, so every box is taken wider by 2⁻²² of the greatest coordinate; inverse
//! directions and quotients are off by a few 2⁻²⁴ of themselves, so the far end is taken longer by 2⁻²⁰.

use super::{Bvh, Margin};
use crate::engine::lanes::{Lanes, Mask, Real, Single};
use crate::engine::vector::{Vector, narrow};

/// 2⁻²² and 1 + 2⁻²⁰, see above.
const WIDER: f32 = 1.0 / 4_194_304.0;
pub(super) const LONGER: f32 = 1.0 + 1.0 / 1_048_576.0;
/// A component of a direction is never less than this share of the greatest: its quotients stay finite. Within any
/// distance that coordinates allow a ray turned by this much stays within the widening of the boxes.
const FLAT: f32 = 1e-20;

/// Where the rays of a packet start, relative to a hierarchy's origin.
#[derive(Clone, Copy)]
pub(crate) struct Start<L: Lanes> {
    origin: [L::Single; 3],
    /// The sum of the greatest coordinates of start and hierarchy, and of what double precision may be off.
    coordinates: L::Single,
    /// What the boxes are wider by.
    wider: L::Single,
}

impl<L: Lanes> Start<L> {
    /// Rays that start `here` in the hierarchy's space, which is at `world` in the world. The margin is that of f64: what
    /// a ray's hits can be off.
    #[inline(always)]
    pub(crate) fn new(bvh: &Bvh, margin: Margin, world: Vector<L::Real>, here: Vector<L::Real>) -> Start<L> {
        let margin = L::Real::splat(margin.fixed) + L::Real::splat(margin.per_origin) * world.greatest();
        let origin = narrow::<L>(here - Vector::splat(bvh.origin()));
        let farthest = origin[0].abs().max(origin[1].abs()).max(origin[2].abs());
        // as if the coordinates were so great that their rounding is the margin
        let margin = L::narrow(margin) * L::Single::splat(2.0 / WIDER);
        let coordinates = farthest + L::Single::splat(bvh.extent()) + margin;
        Start { origin, coordinates, wider: coordinates * L::Single::splat(WIDER) }
    }
}

/// The f32 shadow of a packet's rays, relative to a hierarchy's origin.
#[derive(Clone, Copy)]
pub(crate) struct Shadow<L: Lanes> {
    pub(crate) origin: [L::Single; 3],
    pub(crate) direction: [L::Single; 3],
    /// The greatest component of the direction times the sum of the greatest coordinates of start and hierarchy: what
    /// errors of products grow with.
    pub(crate) spread: L::Single,
    pub(super) inverse: [L::Single; 3],
    /// `(origin + w)/direction` and `(origin - w)/direction`, where `w` is what the boxes are wider by.
    pub(super) above: [L::Single; 3],
    pub(super) below: [L::Single; 3],
    /// What the boxes are wider by: 2⁻²² of the greatest coordinates of start and hierarchy.
    pub(crate) wider: L::Single,
    /// The lanes that hold a ray.
    pub(crate) mask: u8,
}

impl<L: Lanes> Shadow<L> {
    /// No rays.
    #[inline(always)]
    pub(crate) fn none() -> Shadow<L> {
        let zero = L::Single::splat(0.0);
        let none = [zero; 3];
        Shadow {
            origin: none,
            direction: none,
            spread: zero,
            inverse: none,
            above: none,
            below: none,
            wider: zero,
            mask: 0,
        }
    }

    /// Rays from a start in a direction of the hierarchy's space.
    #[inline(always)]
    pub(crate) fn new(start: &Start<L>, direction: Vector<L::Real>, mask: u8) -> Shadow<L> {
        let Start { origin, coordinates, wider } = *start;
        let direction = narrow::<L>(direction);
        let greatest = direction[0].abs().max(direction[1].abs()).max(direction[2].abs());
        let flat = greatest * L::Single::splat(FLAT);
        let zero = L::Single::splat(0.0);
        let (mut inverse, mut above, mut below) = ([zero; 3], [zero; 3], [zero; 3]);
        for axis in 0..3 {
            let along = direction[axis];
            let size = along.abs().max(flat);
            let along = L::Single::select(along.lt(zero), -size, size);
            inverse[axis] = L::Single::splat(1.0) / along;
            above[axis] = (origin[axis] + wider) * inverse[axis];
            below[axis] = (origin[axis] - wider) * inverse[axis];
        }
        Shadow { origin, direction, spread: greatest * coordinates, inverse, above, below, wider, mask }
    }

    /// The rays of which all coordinates are numbers: the others would meet every box.
    #[inline(always)]
    pub(super) fn that_are_numbers(&self) -> u8 {
        let zero = L::Single::splat(0.0);
        let are = self.above[0].abs().ge(zero) & self.above[1].abs().ge(zero) & self.above[2].abs().ge(zero);
        are.bits() & self.mask
    }
}
