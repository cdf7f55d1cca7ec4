//! How many rays of each kind were cast.

use super::{Observer, SeenRay, SeenSurface};
use crate::RayKind;
use std::iter::Sum;
use std::ops::{Add, AddAssign};

/// Counts by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounts {
    /// From the eye.
    pub primary: u64,
    /// Primary rays that met an object.
    pub primary_hits: u64,
    /// Mirrored and totally reflected.
    pub reflected: u64,
    /// Refracted.
    pub refracted: u64,
    /// To a lamp in front.
    pub shadow: u64,
}

impl RayCounts {
    /// Rays of all kinds.
    pub fn total(&self) -> u64 {
        self.primary + self.reflected + self.refracted + self.shadow
    }
}

impl Observer for RayCounts {
    fn enter(&mut self, ray: &SeenRay<'_>) {
        match ray.kind {
            RayKind::Primary => self.primary += 1,
            RayKind::Reflected => self.reflected += 1,
            RayKind::Refracted => self.refracted += 1,
        }
    }

    fn surface(&mut self, surface: &SeenSurface<'_>) {
        self.primary_hits += u64::from(surface.level == 0);
    }

    fn shadow_ray(&mut self) {
        self.shadow += 1;
    }
}

impl Add for RayCounts {
    type Output = RayCounts;
    fn add(self, other: RayCounts) -> RayCounts {
        RayCounts {
            primary: self.primary + other.primary,
            primary_hits: self.primary_hits + other.primary_hits,
            reflected: self.reflected + other.reflected,
            refracted: self.refracted + other.refracted,
            shadow: self.shadow + other.shadow,
        }
    }
}

impl AddAssign for RayCounts {
    fn add_assign(&mut self, other: RayCounts) {
        *self = *self + other;
    }
}

impl Sum for RayCounts {
    fn sum<I: Iterator<Item = RayCounts>>(counts: I) -> RayCounts {
        counts.fold(RayCounts::default(), Add::add)
    }
}
