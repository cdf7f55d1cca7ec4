//! Worlds of few bodies: which rays may meet which of them, told by the balls around them. That costs less than sending
//! beams down a hierarchy of one node.
//!
//! All of it is f32 and conservative. With `u = 2⁻²⁴` and `S` the sum of the greatest coordinates of a ray's start and of
//! the bodies, relative to the balls' origin: a coordinate of `SC` is off by `2uS`, so `SC²` by `24uS²`, `q = D·SC` by `11uS`
//! and `q²` by `38uS²`. What f64 may be off itself counts as if `S` were so great that its 2⁻¹⁸ is that much.

use super::lanes::{Lanes, Mask, Single};
use super::packet::PACKETS;
use super::vector::Vector;
use crate::world::{FEW, Few};

/// Of `S` a length may be off, and of `S²` a square.
const LENGTH: f32 = 1.0 / 262_144.0;
const SQUARE: f32 = 1.0 / 65_536.0;

/// The rays of each packet that may meet each body.
pub(super) struct Aimed {
    pub(super) lanes: [[u8; PACKETS]; FEW],
}

impl Aimed {
    /// No ray at any body.
    pub(super) const NONE: Aimed = Aimed { lanes: [[0; PACKETS]; FEW] };

    /// Aims the rays `mask` of a packet, which look as far as `limit`.
    #[inline(always)]
    pub(super) fn aim<L: Lanes>(
        &mut self,
        few: &Few,
        packet: usize,
        (origin, direction): (Vector<L::Real>, Vector<L::Real>),
        limit: L::Real,
        mask: u8,
    ) {
        let origin = narrow::<L>(origin - Vector::splat(few.origin()));
        let direction = narrow::<L>(direction);
        let greatest = origin[0].abs().max(origin[1].abs()).max(origin[2].abs());
        let s = greatest + L::Single::splat(few.extent() + few.margin() * (1.0 / LENGTH));
        let (length, square) = (s * L::Single::splat(LENGTH), s * s * L::Single::splat(SQUARE));
        let limit = L::narrow(limit) + length;
        for (lanes, ball) in self.lanes.iter_mut().zip(few.balls()) {
            let mut sc = [length; 3];
            for axis in 0..3 {
                sc[axis] = L::Single::splat(ball.center[axis]) - origin[axis];
            }
            let q = dot::<L>(&sc, &direction);
            let reach = L::Single::splat(ball.radius) + length;
            // asked so that a ray whose numbers overflow is not culled
            let beside = q.mul_sub(q, dot::<L>(&sc, &sc)).lt(-(L::Single::splat(ball.square) + square));
            let behind = q.lt(-reach);
            let beyond = (q - limit).gt(reach);
            lanes[packet] = !(beside | behind | beyond).bits() & mask;
        }
    }
}

/// A scalar product.
#[inline(always)]
fn dot<L: Lanes>(a: &[L::Single; 3], b: &[L::Single; 3]) -> L::Single {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

/// Vectors in f32.
#[inline(always)]
fn narrow<L: Lanes>(vector: Vector<L::Real>) -> [L::Single; 3] {
    [L::narrow(vector.x), L::narrow(vector.y), L::narrow(vector.z)]
}
