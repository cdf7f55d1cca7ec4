//! How much memory finding what a ray meets takes.

use super::{Geometry, World};

impl World {
    /// The bytes of all hierarchies of boxes and of what is packed into their leaves. Vertices, facets and surfaces are
    /// not among them.
    pub fn hierarchy_bytes(&self) -> usize {
        let of_facets = |geometry: &Geometry| match geometry {
            Geometry::Facets(facets) => facets.hierarchy().bytes(),
            Geometry::Sphere { .. } | Geometry::Plane { .. } => 0,
        };
        self.hierarchy.bytes() + self.bodies.iter().map(|body| of_facets(&body.geometry)).sum::<usize>()
    }
}
