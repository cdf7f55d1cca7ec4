//! The point that a ray sees: its place on the primitive, its normals, its surface.

use super::hidden_surfaces::Hit;
use crate::Ray;
use crate::world::{Extent, Geometry, World};
use glam::DVec3;
use lancer_scene::ConeFace;

/// A point of a surface as a ray meets it. Both normals are turned against the ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SurfacePoint {
    pub(crate) body: u32,
    pub(crate) point: DVec3,
    /// The geometric normal: side, medium, `T`, and whether a lamp is in front.
    pub(crate) geometric: DVec3,
    /// The normal of the lamp terms and of `R`: smooth where the mesh is.
    pub(crate) normal: DVec3,
    /// The number of the surface.
    pub(crate) surface: u32,
    pub(crate) crossing: Crossing,
}

/// What passing through the surface does to the stack of media.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Crossing {
    /// Into the body.
    Enters,
    /// Out of the body.
    Leaves,
    /// Through a sheet without thickness.
    Sheet,
}

impl World {
    /// The point of a hit. It is recomputed from the primitive, so that it lies on it as well as f64 can say.
    pub(crate) fn surface_point(&self, ray: &Ray, hit: &Hit) -> SurfacePoint {
        let body = self.body(hit.body);
        let seen = ray.at(hit.t);
        let (point, outward, smooth, part) = match &body.geometry {
            Geometry::Sphere { center, radius } => {
                // N = CP/R
                let normal = (seen - *center).normalize();
                (*center + normal * *radius, normal, None, None)
            }
            Geometry::Plane { p0, normal, .. } => (seen - *normal * normal.dot(seen - *p0), *normal, None, None),
            Geometry::Cone(cone) => {
                let (point, normal) = cone.surface_point(seen, ConeFace::of(hit.facet));
                (point, normal, None, None)
            }
            Geometry::Facets(facets) => {
                let [p0, p1, p2] = facets.corners(hit.facet);
                let smooth = facets.normals(hit.facet).and_then(|[n0, n1, n2]| {
                    (n0 * (1.0 - hit.alpha - hit.beta) + n1 * hit.alpha + n2 * hit.beta).try_normalize()
                });
                let point = p0 + (p1 - p0) * hit.alpha + (p2 - p0) * hit.beta;
                (point, (p1 - p0).cross(p2 - p0).normalize(), smooth, facets.surface(hit.facet))
            }
        };
        let against = |normal: DVec3, direction: DVec3| if normal.dot(direction) > 0.0 { -normal } else { normal };
        let geometric = against(outward, ray.direction);
        let inward = outward.dot(ray.direction) < 0.0;
        let crossing = match body.extent {
            Extent::Sheet => Crossing::Sheet,
            Extent::HalfSpace if inward => Crossing::Enters,
            Extent::Volume { inverted } if inward != inverted => Crossing::Enters,
            Extent::HalfSpace | Extent::Volume { .. } => Crossing::Leaves,
        };
        SurfacePoint {
            body: hit.body,
            point,
            geometric,
            normal: smooth.map_or(geometric, |normal| against(normal, -geometric)),
            surface: part.unwrap_or(body.surface),
            crossing,
        }
    }
}
