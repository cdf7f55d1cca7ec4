//! One object of the scene as rays meet it.

use super::contains;
use super::facets::Facets;
use super::packs::Packs;
use super::surfaces::Surfaces;
use crate::bvh::Bounds;
use crate::precision::{lies_in_plane, lies_on_sphere};
use crate::reference::intersect::Cone;
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

/// The kinds of geometry that rays are tried against.
#[derive(Clone, Debug)]
pub(crate) enum Geometry {
    Sphere { center: DVec3, radius: f64 },
    Plane { p0: DVec3, p1: DVec3, p2: DVec3, normal: DVec3 },
    Facets(Facets),
    Cone(Cone),
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

impl Geometry {
    /// The geometry of a shape; the packed geometry of a mesh is taken from `packs`. The facets have no parts yet.
    pub(crate) fn of(shape: &Shape, packs: &Packs) -> Geometry {
        match shape {
            Shape::Sphere { center, radius } => Geometry::Sphere { center: *center, radius: *radius },
            Shape::Plane { p0, p1, p2 } => {
                let normal = (p1 - p0).cross(p2 - p0).normalize();
                Geometry::Plane { p0: *p0, p1: *p1, p2: *p2, normal }
            }
            Shape::Facet { p0, p1, p2 } => Geometry::Facets(Facets::separate(&[[*p0, *p1, *p2]])),
            Shape::Cube { .. } | Shape::Parallelepiped { .. } => {
                let facets = shape.frame().map(|(origin, edges)| box_facets(origin, edges));
                Geometry::Facets(Facets::separate(facets.as_ref().map_or(&[], |facets| facets)))
            }
            Shape::Cone { base, top, base_radius, top_radius, capped } => {
                Geometry::Cone(Cone::new([*base, *top], [*base_radius, *top_radius], *capped))
            }
            Shape::Mesh(mesh) => Geometry::Facets(Facets::of_mesh(mesh, packs)),
        }
    }

    /// The box around it, a little wider than the points that rays can hit; `None` for a plane.
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        match self {
            Geometry::Sphere { center, radius } => {
                Some(Bounds { low: *center - DVec3::splat(*radius), high: *center + DVec3::splat(*radius) }.widened())
            }
            Geometry::Plane { .. } => None,
            Geometry::Facets(facets) => facets.bounds().map(Bounds::widened),
            Geometry::Cone(cone) => {
                let (low, high) = cone.bounds();
                Some(Bounds { low, high }.widened())
            }
        }
    }
}

impl Body {
    /// The body of an object, whose geometry is given.
    pub(crate) fn new(object: &Object, geometry: Geometry, surfaces: &mut Surfaces) -> Body {
        let surface = surfaces.number(&object.material);
        let own = surfaces.is_transparent(surface).then_some(surface);
        let solid = Extent::Volume { inverted: false };
        let (geometry, medium, extent) = match (geometry, &object.shape) {
            (Geometry::Facets(facets), Shape::Mesh(mesh)) => {
                let facets = facets.with_parts(&mesh.geometry.parts, surfaces);
                let medium = facets.surfaces(surface).find(|surface| surfaces.is_transparent(*surface));
                // only a medium needs to know what it encloses
                let enclosure = if medium.is_some() { facets.packed().enclosure() } else { Enclosure::Sheet };
                let extent = match enclosure.placed(&mesh.placement) {
                    Enclosure::Volume { inverted } => Extent::Volume { inverted },
                    Enclosure::Sheet => Extent::Sheet,
                };
                (Geometry::Facets(facets), medium, extent)
            }
            (geometry, Shape::Plane { .. }) => (geometry, own, Extent::HalfSpace),
            (geometry, Shape::Facet { .. } | Shape::Cone { capped: false, .. }) => (geometry, own, Extent::Sheet),
            (
                geometry,
                Shape::Sphere { .. }
                | Shape::Cube { .. }
                | Shape::Parallelepiped { .. }
                | Shape::Cone { capped: true, .. }
                | Shape::Mesh(_),
            ) => (geometry, own, solid),
        };
        Body { name: object.name.clone(), geometry, surface, medium, extent }
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
            (Geometry::Cone(cone), _) => cone.contains(point),
            (Geometry::Facets(facets), _) => {
                facets.bounds().is_some_and(|bounds| bounds.contains(point)) && contains::closed(facets, point)
            }
        }
    }
}
