//! Worlds of few bodies: which rays may meet which of them, told by the balls around them. That costs less than sending
//! beams down a hierarchy of one node.
//!
//! All of it is f32 and conservative. With `u = 2⁻²⁴` and `S` the sum of the greatest coordinates of a ray's start and of
//! the bodies, relative to the balls' origin: a coordinate of `SC` is off by `2uS`, so `SC²` by `24uS²`, `q = D·SC` by `11uS`
//! and `q²` by `38uS²`. What f64 may be off itself counts as if `S` were so great that its 2⁻¹⁸ is that much.

use super::lanes::{Lanes, Mask, Single};
use super::packet::PACKETS;
use super::vector::{Vector, dot, narrow};
use crate::world::{FEW, Few};
use glam::DVec3;

/// Of `S` a length may be off, and of `S²` a square.
const LENGTH: f32 = 1.0 / 262_144.0;
const SQUARE: f32 = 1.0 / 65_536.0;

/// Where the rays of a packet start, in f32 and relative to the balls' origin.
#[derive(Clone, Copy)]
pub(super) struct Start<L: Lanes> {
    origin: [L::Single; 3],
    /// What a length may be off, and a square.
    length: L::Single,
    square: L::Single,
}

impl<L: Lanes> Start<L> {
    /// Nowhere in particular.
    #[inline(always)]
    pub(super) fn none() -> Start<L> {
        let zero = L::Single::splat(0.0);
        Start { origin: [zero; 3], length: zero, square: zero }
    }

    /// In f32 what is given in f64.
    #[inline(always)]
    pub(super) fn at(few: &Few, origin: Vector<L::Real>) -> Start<L> {
        let origin = narrow::<L>(origin - Vector::splat(few.origin()));
        let greatest = origin[0].abs().max(origin[1].abs()).max(origin[2].abs());
        let s = greatest + L::Single::splat(spread(few));
        Start { origin, length: s * L::Single::splat(LENGTH), square: s * s * L::Single::splat(SQUARE) }
    }
}

/// What a ball adds to `S`.
#[inline(always)]
fn spread(few: &Few) -> f32 {
    few.extent() + few.margin() * (1.0 / LENGTH)
}

/// A box around the starts of many rays, lane by lane.
pub(super) struct Hull<L: Lanes> {
    low: [L::Single; 3],
    high: [L::Single; 3],
}

impl<L: Lanes> Hull<L> {
    /// The box around nothing.
    #[inline(always)]
    pub(super) fn empty() -> Hull<L> {
        let most = L::Single::splat(f32::INFINITY);
        Hull { low: [most; 3], high: [-most; 3] }
    }

    /// Takes in the starts of some lanes.
    #[inline(always)]
    pub(super) fn add(&mut self, start: &Start<L>, lanes: u8) {
        let lanes = <L::Single as Single>::Mask::from_bits(lanes);
        for axis in 0..3 {
            let (low, high) = (self.low[axis], self.high[axis]);
            self.low[axis] = L::Single::select(lanes, start.origin[axis].min(low), low);
            self.high[axis] = L::Single::select(lanes, start.origin[axis].max(high), high);
        }
    }

    /// The balls that segments between the starts and a lamp may meet: those near the segment to the middle of a ball
    /// around all starts.
    #[inline(always)]
    pub(super) fn between(&self, few: &Few, lamp: DVec3) -> u8 {
        let (mut low, mut high) = (DVec3::ZERO, DVec3::ZERO);
        for axis in 0..3 {
            (low[axis], high[axis]) = (f64::from(self.low[axis].least()), f64::from(self.high[axis].greatest()));
        }
        let s = low.abs().max(high.abs()).max_element() + f64::from(spread(few));
        let around = (high - low).length() / 2.0 + s * f64::from(LENGTH);
        let lamp = lamp - few.origin();
        let way = (low + high) / 2.0 - lamp;
        let squared = way.length_squared();
        let mut between = 0;
        for (number, ball) in few.balls().iter().enumerate() {
            let [x, y, z] = ball.center;
            let center = DVec3::new(f64::from(x), f64::from(y), f64::from(z)) - lamp;
            let share = if squared > 0.0 { (center.dot(way) / squared).clamp(0.0, 1.0) } else { 0.0 };
            let reach = f64::from(ball.radius) + around;
            // asked so that numbers that overflow leave nothing out
            let beside = (center - way * share).length_squared() > reach * reach;
            between |= u8::from(!beside) << number;
        }
        between
    }
}

/// The rays of each packet that may meet each body.
pub(super) struct Aimed {
    pub(super) lanes: [[u8; PACKETS]; FEW],
}

impl Aimed {
    /// No ray at any body.
    pub(super) const NONE: Aimed = Aimed { lanes: [[0; PACKETS]; FEW] };

    /// Aims the rays `mask` of a packet, which look as far as `limit`, at some balls.
    #[inline(always)]
    pub(super) fn aim<L: Lanes>(
        &mut self,
        (few, balls): (&Few, u8),
        packet: usize,
        (start, direction): (&Start<L>, Vector<L::Real>),
        limit: L::Real,
        mask: u8,
    ) {
        let Start { origin, length, square } = *start;
        let direction = narrow::<L>(direction);
        let limit = L::narrow(limit) + length;
        for (number, (ball, lanes)) in few.balls().iter().zip(&mut self.lanes).enumerate() {
            if balls >> number & 1 == 0 {
                continue;
            }
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
