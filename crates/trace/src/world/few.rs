//! The balls around the bodies of a world that has few, for [`engine::few`](crate::engine).

use super::body::{Body, Geometry};
use crate::bvh::{Bounds, Margin};
use glam::DVec3;

/// So many bodies are few: trying the balls of all costs less than going down a hierarchy.
pub(crate) const FEW: usize = 8;

/// The bounded bodies of a world that has few.
#[derive(Clone, Debug)]
pub(crate) struct Few {
    origin: DVec3,
    extent: f32,
    margin: f32,
    /// The bodies' numbers, spheres first: they cost least and shorten the rays for the others.
    numbers: Vec<u32>,
    balls: Vec<Ball>,
}

/// A ball around a body, relative to the origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball {
    pub(crate) center: [f32; 3],
    pub(crate) radius: f32,
    /// The radius times itself.
    pub(crate) square: f32,
}

impl Few {
    /// The bodies of these numbers and boxes; `None` if they are not few, or too far apart for f32.
    pub(super) fn of(bodies: &[Body], bounds: &[(u32, Bounds)]) -> Option<Few> {
        if bounds.len() > FEW {
            return None;
        }
        let hull = bounds.iter().fold(Bounds::EMPTY, |hull, (_, bounds)| hull.union(*bounds));
        let origin = if bounds.is_empty() { DVec3::ZERO } else { hull.low + (hull.high - hull.low) / 2.0 };
        let is_sphere = |number: u32| matches!(bodies[number as usize].geometry, Geometry::Sphere { .. });
        let (spheres, others): (Vec<_>, Vec<_>) = bounds.iter().partition(|(number, _)| is_sphere(*number));
        let (mut numbers, mut balls) = (Vec::new(), Vec::new());
        for (number, bounds) in spheres.into_iter().chain(others) {
            let (center, radius) = match &bodies[number as usize].geometry {
                Geometry::Sphere { center, radius } => (*center, *radius),
                Geometry::Plane { .. } | Geometry::Cone(_) | Geometry::Facets(_) => {
                    let half = (bounds.high - bounds.low) / 2.0;
                    (bounds.low + half, half.length())
                }
            };
            let radius = (radius * 1.000_001) as f32;
            numbers.push(number);
            balls.push(Ball {
                center: (center - origin).as_vec3().to_array(),
                radius,
                square: radius * radius * 1.000_001,
            });
        }
        let reach = hull.low.abs().max(hull.high.abs()).max_element();
        let extent = (hull.low - origin).abs().max((hull.high - origin).abs()).max_element() * 1.000_001;
        let (extent, margin) = if bounds.is_empty() { (0.0, 0.0) } else { (extent, 2.0 * Margin::ROUNDINGS * reach) };
        let few = Few { origin, extent: extent as f32, margin: margin as f32, numbers, balls };
        let is_finite = few.extent.is_finite() && few.balls.iter().all(|ball| ball.square.is_finite());
        is_finite.then_some(few)
    }

    /// What the balls are relative to.
    pub(crate) fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The greatest coordinate of a body, relative to the origin.
    pub(crate) fn extent(&self) -> f32 {
        self.extent
    }

    /// What a body's hits can be off in f64.
    pub(crate) fn margin(&self) -> f32 {
        self.margin
    }

    /// The bodies' numbers.
    pub(crate) fn numbers(&self) -> &[u32] {
        &self.numbers
    }

    /// All of them, one bit each.
    pub(crate) fn all(&self) -> u8 {
        ((1_u32 << self.balls.len()) - 1) as u8
    }

    /// The balls around them.
    pub(crate) fn balls(&self) -> &[Ball] {
        &self.balls
    }
}
