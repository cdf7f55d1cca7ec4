//! Where a ray meets each kind of geometry, and the normal there (subject §3).

mod facet;
mod plane;
mod sphere;

pub use facet::{FacetHit, intersect_facet};
pub use plane::intersect_plane;
pub use sphere::{Start, intersect_sphere};
