//! Rays.

use glam::DVec3;

/// A half-line from a point along a unit direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// `S`, where it starts.
    pub origin: DVec3,
    /// `I`, a unit vector.
    pub direction: DVec3,
}

impl Ray {
    /// The point at distance `t`: `S + t·I`.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

/// Where a ray comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RayKind {
    /// From the eye.
    Primary,
    /// Mirrored, or totally reflected.
    Reflected,
    /// Refracted.
    Refracted,
}
