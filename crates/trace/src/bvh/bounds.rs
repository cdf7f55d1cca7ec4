//! A box along the axes, in double precision.

use glam::DVec3;

/// A box along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) low: DVec3,
    pub(crate) high: DVec3,
}

impl Bounds {
    /// The box around nothing.
    pub(crate) const EMPTY: Bounds = Bounds { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// The box around points.
    pub(crate) fn of(points: impl IntoIterator<Item = DVec3>) -> Bounds {
        points
            .into_iter()
            .fold(Bounds::EMPTY, |bounds, point| Bounds { low: bounds.low.min(point), high: bounds.high.max(point) })
    }

    /// The box moved outwards by a few roundings of its greatest coordinate, so that a hit that is computed at its
    /// face lies inside of it.
    pub(crate) fn widened(self) -> Bounds {
        let slack = DVec3::splat(8.0 * f64::EPSILON * self.reach());
        Bounds { low: self.low - slack, high: self.high + slack }
    }

    /// Whether a point lies in the box or on its face.
    pub(crate) fn contains(&self, point: DVec3) -> bool {
        self.low.cmple(point).all() && self.high.cmpge(point).all()
    }

    /// The box around both.
    pub(crate) fn union(self, other: Bounds) -> Bounds {
        Bounds { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The middle.
    pub(crate) fn center(&self) -> DVec3 {
        self.low * 0.5 + self.high * 0.5
    }

    /// Half of its surface.
    pub(crate) fn half_area(&self) -> f64 {
        let DVec3 { x, y, z } = self.high - self.low;
        x * (y + z) + y * z
    }

    /// The greatest coordinate, by its amount.
    pub(crate) fn reach(&self) -> f64 {
        self.low.abs().max(self.high.abs()).max_element()
    }

    /// The length from the least to the greatest corner.
    pub(crate) fn diagonal(&self) -> f64 {
        (self.high - self.low).length()
    }
}
