//! Vectors over lanes: every operation is glam's on each lane, in its order, so that the results are its very bits.

use super::lanes::{Lanes, Mask, Real, Single};
use glam::DVec3;
use std::ops::{Add, Mul, Neg, Sub};

/// Eight vectors.
#[derive(Clone, Copy)]
pub(crate) struct Vector<R> {
    pub(crate) x: R,
    pub(crate) y: R,
    pub(crate) z: R,
}

impl<R: Real> Vector<R> {
    /// The same vector in every lane.
    #[inline(always)]
    pub(crate) fn splat(vector: DVec3) -> Vector<R> {
        Vector { x: R::splat(vector.x), y: R::splat(vector.y), z: R::splat(vector.z) }
    }

    /// One vector a lane, by coordinate.
    #[inline(always)]
    pub(crate) fn load(coordinates: &[[f64; 8]; 3]) -> Vector<R> {
        Vector { x: R::load(&coordinates[0]), y: R::load(&coordinates[1]), z: R::load(&coordinates[2]) }
    }

    /// The vector of one lane; for work that is done lane by lane.
    #[inline(always)]
    pub(crate) fn lane(self, lane: usize) -> DVec3 {
        DVec3::new(self.x.store()[lane], self.y.store()[lane], self.z.store()[lane])
    }

    /// `self·other`.
    #[inline(always)]
    pub(crate) fn dot(self, other: Vector<R>) -> R {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// `self × other`.
    #[inline(always)]
    pub(crate) fn cross(self, other: Vector<R>) -> Vector<R> {
        Vector {
            x: self.y * other.z - other.y * self.z,
            y: self.z * other.x - other.z * self.x,
            z: self.x * other.y - other.x * self.y,
        }
    }

    /// The length.
    #[inline(always)]
    pub(crate) fn length(self) -> R {
        self.dot(self).sqrt()
    }

    /// The unit vector; what is too short for one is not finite.
    #[inline(always)]
    pub(crate) fn normalize(self) -> Vector<R> {
        self * (R::splat(1.0) / self.length())
    }

    /// Each coordinate divided.
    #[inline(always)]
    pub(crate) fn divided(self, divisor: R) -> Vector<R> {
        Vector { x: self.x / divisor, y: self.y / divisor, z: self.z / divisor }
    }

    /// The greatest of the absolute coordinates.
    #[inline(always)]
    pub(crate) fn greatest(self) -> R {
        self.x.abs().max(self.y.abs()).max(self.z.abs())
    }

    /// `yes` in the lanes of the mask, `no` in the others.
    #[inline(always)]
    pub(crate) fn select(mask: R::Mask, yes: Vector<R>, no: Vector<R>) -> Vector<R> {
        Vector { x: R::select(mask, yes.x, no.x), y: R::select(mask, yes.y, no.y), z: R::select(mask, yes.z, no.z) }
    }

    /// The vectors turned against others: negated where the scalar product is positive.
    #[inline(always)]
    pub(crate) fn against(self, direction: Vector<R>) -> Vector<R> {
        Vector::select(self.dot(direction).gt(R::splat(0.0)), -self, self)
    }
}

impl<R: Real> Add for Vector<R> {
    type Output = Vector<R>;
    #[inline(always)]
    fn add(self, other: Vector<R>) -> Vector<R> {
        Vector { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<R: Real> Sub for Vector<R> {
    type Output = Vector<R>;
    #[inline(always)]
    fn sub(self, other: Vector<R>) -> Vector<R> {
        Vector { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

impl<R: Real> Neg for Vector<R> {
    type Output = Vector<R>;
    #[inline(always)]
    fn neg(self) -> Vector<R> {
        Vector { x: -self.x, y: -self.y, z: -self.z }
    }
}

impl<R: Real> Mul<R> for Vector<R> {
    type Output = Vector<R>;
    #[inline(always)]
    fn mul(self, factor: R) -> Vector<R> {
        Vector { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }
}

/// The lanes of a mask, least first.
#[inline(always)]
pub(crate) fn lanes(bits: u8) -> LaneNumbers {
    LaneNumbers(bits)
}

/// See [`lanes`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct LaneNumbers(u8);

impl Iterator for LaneNumbers {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        if self.0 == 0 {
            return None;
        }
        let lane = self.0.trailing_zeros() as usize;
        self.0 &= self.0 - 1;
        Some(lane)
    }
}

/// Vectors in f32.
#[inline(always)]
pub(crate) fn narrow<L: Lanes>(vector: Vector<L::Real>) -> [L::Single; 3] {
    [L::narrow(vector.x), L::narrow(vector.y), L::narrow(vector.z)]
}

/// The scalar product of vectors in f32.
#[inline(always)]
pub(crate) fn dot<L: Lanes>(a: &[L::Single; 3], b: &[L::Single; 3]) -> L::Single {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

/// Puts a value into some lanes of a list.
#[inline(always)]
pub(crate) fn put_value<T: Copy>(list: &mut [T; 8], lanes: u8, value: T) {
    for lane in 0..8 {
        list[lane] = if lanes >> lane & 1 == 1 { value } else { list[lane] };
    }
}

/// A mask of lanes for [`Real::select`].
#[inline(always)]
pub(crate) fn mask<R: Real>(bits: u8) -> R::Mask {
    R::Mask::from_bits(bits)
}
