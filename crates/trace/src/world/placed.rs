//! Where shared facets stand: the way to the world and back.

use crate::bvh::{Bounds, Bvh, Margin};
use glam::{DMat3, DVec3};
use lancer_scene::Placement;

/// A placement whose linear part can be undone well.
#[derive(Clone, Debug)]
pub(crate) struct Placed {
    linear: DMat3,
    /// `(M, position)`: `M·(p - position)` is where a point of the world is before placement.
    pub(crate) to_local: (DMat3, DVec3),
    pub(crate) margin: Margin,
    pub(crate) bounds: Option<Bounds>,
}

/// How a placement is carried out.
pub(crate) enum Carrying {
    /// The facets stand where the geometry says.
    Nothing,
    /// Rays are brought to the geometry.
    Rays { linear: DMat3, inverse: DMat3 },
    /// The facets are brought to the world: it cannot be undone to enough digits.
    Facets { linear: DMat3 },
}

impl Carrying {
    /// The way for a placement.
    pub(crate) fn of(placement: &Placement) -> Carrying {
        /// By how much a linear part may distort, and how great its numbers and those of its inverse may be.
        const WORST: f64 = 1e4;
        const GREATEST: f64 = 1e12;
        let linear = placement.linear();
        if linear == DMat3::IDENTITY && placement.position == DVec3::ZERO {
            return Carrying::Nothing;
        }
        let inverse = linear.inverse();
        let (forth, back) = (norm(&linear), norm(&inverse));
        // not a number is none of these
        if forth * back <= WORST && forth <= GREATEST && back <= GREATEST {
            Carrying::Rays { linear, inverse }
        } else {
            Carrying::Facets { linear }
        }
    }
}

/// The greatest sum of amounts in a row: by how much the greatest coordinate can grow.
fn norm(matrix: &DMat3) -> f64 {
    (matrix.x_axis.abs() + matrix.y_axis.abs() + matrix.z_axis.abs()).max_element()
}

impl Placed {
    /// The placement by `linear` and `position` of what a hierarchy holds; `corners` gives the points of a leaf.
    pub(crate) fn new<I: Iterator<Item = DVec3>>(
        (linear, inverse): (DMat3, DMat3),
        position: DVec3,
        bvh: &Bvh,
        points: impl Fn(u32, u32) -> I,
    ) -> Placed {
        let (forth, back) = (norm(&linear), norm(&inverse));
        let reach = bvh.bounds().map_or(0.0, |bounds| bounds.reach());
        // the numbers in the world that are rounded, brought back, and as often as the inverse has lost digits
        let per_origin = Margin::ROUNDINGS * back * (forth * back);
        let margin = Margin { fixed: per_origin * (position.abs().max_element() + forth * reach), per_origin };
        let mut placed = Placed { linear, to_local: (inverse, position), margin, bounds: None };
        let slack = Margin::ROUNDINGS * (forth * reach + position.abs().max_element());
        placed.bounds = bvh.bounds().map(|_| {
            let extreme = |axis: usize, sign: f64| {
                let along = linear.row(axis) * sign;
                let greatest = bvh.greatest(along, slack, |first, count| {
                    points(first, count).map(|point| (linear * point)[axis] * sign).fold(f64::NEG_INFINITY, f64::max)
                });
                greatest * sign + position[axis]
            };
            Bounds {
                low: DVec3::from([0, 1, 2].map(|axis| extreme(axis, -1.0))),
                high: DVec3::from([0, 1, 2].map(|axis| extreme(axis, 1.0))),
            }
        });
        placed
    }

    /// Where the placement brings a point.
    pub(crate) fn apply(&self, point: DVec3) -> DVec3 {
        self.linear * point + self.to_local.1
    }
}
