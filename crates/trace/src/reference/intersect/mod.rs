//! Where a ray meets each kind of geometry, and the normal there (subject §3).

mod cone;
mod facet;
mod plane;
mod sphere;

pub use cone::{Cone, intersect_cone};
pub use facet::{FacetHit, intersect_facet};
pub use plane::intersect_plane;
pub use sphere::{Start, intersect_sphere};
