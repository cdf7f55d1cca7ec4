//! One object of the scene as rays meet it.

use super::facets::Facets;
use super::packs::Packs;
use super::{Surfaces, contains};
use crate::bvh::Bounds;
use crate::precision::{lies_in_plane, lies_on_sphere};
use glam::DVec3;
use lancer_scene::{Enclosure, Name, Object, Shape, box_facets};

/// A visible object. Its place in the world's list is its order in the document.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) name: Name,
    pub(crate) geometry: Geometry,
    /// The number of its surface; parts of a mesh have their own.
    pub(crate) surface: u32,
    /// The surface whose index an eye inside finds itself in: that of the first facet that lets light through. `None`:
    /// the object is no medium.
    pub(crate) medium: Option<u32>,
    pub(crate) extent: Extent,
}

/// The three kinds of geometry that rays are tried against.
#[derive(Clone, Debug)]
pub(crate) enum Geometry {
    Sphere { center: DVec3, radius: f64 },
    Plane { p0: DVec3, p1: DVec3, p2: DVec3, normal: DVec3 },
    Facets(Facets),
}

/// What an object encloses (SPEC §1, media).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extent {
    /// A volume; the outward normal is the geometry's, turned if `inverted`.
    Volume { inverted: bool },
    /// The half-space behind a plane's normal.
    HalfSpace,
    /// Nothing: a sheet without thickness.
    Sheet,
}

impl Body {
    pub(crate) fn compile(object: &Object, surfaces: &mut Surfaces, packs: &mut Packs) -> Body {
        let surface = surfaces.number(&object.material);
        let mut medium = surfaces.is_transparent(surface).then_some(surface);
        let solid = Extent::Volume { inverted: false };
        let (geometry, extent) = match &object.shape {
            Shape::Sphere { center, radius } => (Geometry::Sphere { center: *center, radius: *radius }, solid),
            Shape::Plane { p0, p1, p2 } => {
                let normal = (p1 - p0).cross(p2 - p0).normalize();
                (Geometry::Plane { p0: *p0, p1: *p1, p2: *p2, normal }, Extent::HalfSpace)
            }
            Shape::Facet { p0, p1, p2 } => (Geometry::Facets(Facets::separate(&[[*p0, *p1, *p2]])), Extent::Sheet),
            Shape::Cube { .. } | Shape::Parallelepiped { .. } => {
                let facets = object.shape.frame().map(|(origin, edges)| box_facets(origin, edges));
                (Geometry::Facets(Facets::separate(facets.as_ref().map_or(&[], |facets| facets))), solid)
            }
            Shape::Mesh(mesh) => {
                let facets = Facets::of_mesh(mesh, surfaces, packs);
                medium = facets.surfaces(surface).find(|surface| surfaces.is_transparent(*surface));
                // only a medium needs to know what it encloses
                let enclosure = if medium.is_some() { facets.packed().enclosure() } else { Enclosure::Sheet };
                let extent = match enclosure.placed(&mesh.placement) {
                    Enclosure::Volume { inverted } => Extent::Volume { inverted },
                    Enclosure::Sheet => Extent::Sheet,
                };
                (Geometry::Facets(facets), extent)
            }
        };
        Body { name: object.name.clone(), geometry, surface, medium, extent }
    }

    /// The box around it, a little wider than the points that rays can hit; `None` for a plane.
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        match &self.geometry {
            Geometry::Sphere { center, radius } => {
                Some(Bounds { low: *center - DVec3::splat(*radius), high: *center + DVec3::splat(*radius) }.widened())
            }
            Geometry::Plane { .. } => None,
            Geometry::Facets(facets) => facets.bounds().map(Bounds::widened),
        }
    }

    /// Whether a point is inside of what the body encloses; a point of the surface is outside.
    pub(crate) fn contains(&self, point: DVec3) -> bool {
        match (&self.geometry, self.extent) {
            (_, Extent::Sheet) => false,
            (Geometry::Sphere { center, radius }, _) => {
                (point - *center).length() < *radius && !lies_on_sphere(point, *center, *radius)
            }
            (Geometry::Plane { p0, p1, p2, normal }, _) => {
                normal.dot(point - *p0) < 0.0 && !lies_in_plane(point, *p0, *p1, *p2)
            }
            (Geometry::Facets(facets), _) => {
                facets.bounds().is_some_and(|bounds| bounds.contains(point)) && contains::closed(facets, point)
            }
        }
    }
}
