//! Where a ray meets each kind of geometry, and the normal there (subject §3).

mod facet;
mod plane;
mod sphere;

use glam::DVec3;

pub use facet::{FacetHit, intersect_facet, lies_in_plane};
pub use plane::intersect_plane;
pub use sphere::{Start, intersect_sphere, lies_on_sphere};

/// How far computed points may be from where they should be: a few roundings of the greatest coordinate among them.
pub fn roundings(points: &[DVec3]) -> f64 {
    16.0 * f64::EPSILON * points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max)
}
