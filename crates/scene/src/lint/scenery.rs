//! What the rules of lint look at: the visible objects with their surfaces, and a limit to the effort.

use crate::{
    DVec3, Enclosure, MaterialRef, Mesh, MeshGeometry, Object, Placement, PointLight, Scene, Shape, Surface, View,
};
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::sync::Arc;

/// How many items lint looks at in all before it becomes silent: well under a second of work.
const EFFORT: u64 = 50_000_000;

/// A scene and its views, prepared for the rules.
pub(super) struct Scenery<'a> {
    pub(super) scene: &'a Scene,
    pub(super) views: &'a [Arc<View>],
    /// In document order.
    pub(super) visible: Vec<Visible<'a>>,
    effort: Cell<u64>,
    /// Bounds of geometries before placement; many objects may share one.
    bounds: RefCell<HashMap<*const MeshGeometry, Option<(DVec3, DVec3)>>>,
    /// What geometries enclose before placement.
    enclosures: RefCell<HashMap<*const MeshGeometry, Enclosure>>,
}

/// A visible object.
pub(super) struct Visible<'a> {
    pub(super) object: &'a Object,
    /// The surfaces that its facets have: one, or several on a mesh with parts.
    pub(super) surfaces: Vec<Cow<'a, Surface>>,
}

impl Visible<'_> {
    /// Whether some surface of it lets light through.
    pub(super) fn is_transparent(&self) -> bool {
        self.surfaces.iter().any(|surface| surface.is_transparent())
    }

    /// Whether some surface of it mirrors.
    pub(super) fn is_mirror(&self) -> bool {
        self.surfaces.iter().any(|surface| surface.is_mirror())
    }
}

/// A plane: one of its points and its unit normal.
#[derive(Clone, Copy)]
pub(super) struct Halves {
    pub(super) point: DVec3,
    pub(super) normal: DVec3,
}

impl Halves {
    pub(super) fn of(shape: &Shape) -> Option<Halves> {
        match shape {
            Shape::Plane { p0, p1, p2 } => {
                (*p1 - *p0).cross(*p2 - *p0).try_normalize().map(|normal| Halves { point: *p0, normal })
            }
            Shape::Sphere { .. }
            | Shape::Facet { .. }
            | Shape::Cube { .. }
            | Shape::Parallelepiped { .. }
            | Shape::Cone { .. }
            | Shape::Mesh(_) => None,
        }
    }

    /// On which side a point is: 1 in front, -1 behind, 0 in the plane as far as rounding lets tell.
    pub(super) fn side(&self, point: DVec3) -> i8 {
        self.side_of(self.distance(point), self.distance(point), point.length())
    }

    fn distance(&self, point: DVec3) -> f64 {
        (point - self.point).dot(self.normal)
    }

    /// The side of something whose distances lie between two numbers. What stands on the plane is on one side; what
    /// crosses it or lies in it is on none.
    fn side_of(&self, least: f64, greatest: f64, magnitude: f64) -> i8 {
        let rounding = 1e-9 * (magnitude + self.point.length());
        let (in_front, behind) = (greatest > rounding, least < -rounding);
        i8::from(in_front && !behind) - i8::from(behind && !in_front)
    }
}

impl<'a> Scenery<'a> {
    pub(super) fn new(scene: &'a Scene, views: &'a [Arc<View>]) -> Scenery<'a> {
        let materials: HashMap<&str, &Surface> =
            scene.materials.iter().map(|material| (&*material.name, &material.surface)).collect();
        let surface = |material: &'a MaterialRef| match material {
            MaterialRef::Default => Cow::Owned(Surface::default()),
            MaterialRef::Named(name) => materials.get(&**name).map_or_else(Cow::default, |found| Cow::Borrowed(*found)),
            MaterialRef::Inline(surface) => Cow::Borrowed(&**surface),
        };
        let visible = scene
            .objects
            .iter()
            .filter(|object| object.visible)
            .map(|object| {
                let geometry = object.shape.geometry();
                let of_parts: u64 =
                    geometry.map_or(0, |geometry| geometry.parts.iter().map(|part| u64::from(part.count)).sum());
                // Where parts cover all facets, the object's own material is on none.
                let covered = of_parts > 0 && geometry.is_some_and(|geometry| of_parts == geometry.facets.len() as u64);
                let surfaces = object.material_refs().skip(usize::from(covered)).map(surface).collect();
                Visible { object, surfaces }
            })
            .collect();
        let effort = Cell::new(EFFORT);
        Scenery { scene, views, visible, effort, bounds: RefCell::default(), enclosures: RefCell::default() }
    }

    /// The visible lamps.
    pub(super) fn lamps(&self) -> impl Iterator<Item = &'a PointLight> {
        self.scene.lights.iter().map(|light| &**light).filter(|light| light.visible)
    }

    /// The visible planes that let no light through.
    pub(super) fn opaque_planes(&self) -> impl Iterator<Item = (&'a Object, Halves)> {
        self.visible
            .iter()
            .filter(|visible| !visible.is_transparent())
            .filter_map(|visible| Some((visible.object, Halves::of(&visible.object.shape)?)))
    }

    /// The visible objects that end somewhere.
    pub(super) fn bounded(&self) -> impl Iterator<Item = &Visible<'a>> {
        self.visible.iter().filter(|visible| self.reach(&visible.object.shape, DVec3::X).is_some())
    }

    /// Whether there is effort left for looking at that many items; takes it.
    pub(super) fn afford(&self, items: usize) -> bool {
        let left = self.effort.get().checked_sub(items as u64);
        self.effort.set(left.unwrap_or(0));
        left.is_some()
    }

    /// On which side of a plane all of a shape is; 0 if it crosses the plane, lies in it or has no end.
    pub(super) fn side(&self, plane: &Halves, shape: &Shape) -> i8 {
        match self.reach(shape, plane.normal) {
            Some((least, greatest, magnitude)) => {
                let origin = plane.point.dot(plane.normal);
                plane.side_of(least - origin, greatest - origin, magnitude)
            }
            None => 0,
        }
    }

    /// The least and the greatest product of a direction with the points of a shape, and how far out it lies; `None`
    /// for a plane and an empty mesh. A mesh stands for the box around it before placement, which holds more.
    fn reach(&self, shape: &Shape, direction: DVec3) -> Option<(f64, f64, f64)> {
        let hull = |points: &[DVec3]| {
            points.iter().fold((f64::INFINITY, f64::NEG_INFINITY, 0.0_f64), |(low, high, magnitude), point| {
                let along = point.dot(direction);
                (low.min(along), high.max(along), magnitude.max(point.length()))
            })
        };
        match shape {
            Shape::Sphere { center, radius } => {
                let along = center.dot(direction);
                Some((along - radius, along + radius, center.length() + radius))
            }
            Shape::Plane { .. } => None,
            Shape::Facet { p0, p1, p2 } => Some(hull(&[*p0, *p1, *p2])),
            Shape::Cube { .. } | Shape::Parallelepiped { .. } => {
                shape.frame().map(|(origin, edges)| hull(&super::inside::corners(origin, edges)))
            }
            Shape::Cone { base, top, base_radius, top_radius, .. } => {
                // a circle reaches its radius times the sine of the angle between its axis and the direction
                let axis = (*top - *base).normalize_or_zero();
                let sine = axis.cross(direction).length();
                let ends = [(*base, base_radius * sine), (*top, top_radius * sine)];
                let least =
                    ends.iter().map(|(center, reach)| center.dot(direction) - reach).fold(f64::INFINITY, f64::min);
                let greatest =
                    ends.iter().map(|(center, reach)| center.dot(direction) + reach).fold(f64::NEG_INFINITY, f64::max);
                Some((least, greatest, (base.length() + base_radius).max(top.length() + top_radius)))
            }
            Shape::Mesh(mesh) => {
                let (low, high) = self.bounds_before_placement(mesh)?;
                let size = high - low;
                let edges = [DVec3::X * size.x, DVec3::Y * size.y, DVec3::Z * size.z];
                let linear = mesh.placement.linear();
                let placed = super::inside::corners(low, edges).map(|corner| linear * corner + mesh.placement.position);
                Some(hull(&placed))
            }
        }
    }

    /// The middle of the box around a shape.
    pub(super) fn middle(&self, shape: &Shape) -> Option<DVec3> {
        let along = |axis| self.reach(shape, axis).map(|(least, greatest, _)| (least + greatest) * 0.5);
        Some(DVec3::new(along(DVec3::X)?, along(DVec3::Y)?, along(DVec3::Z)?))
    }

    /// The bounds of a mesh's vertices as the file has them; `None` if no facet uses one.
    pub(super) fn bounds_before_placement(&self, mesh: &Mesh) -> Option<(DVec3, DVec3)> {
        *self
            .bounds
            .borrow_mut()
            .entry(Arc::as_ptr(&mesh.geometry))
            .or_insert_with(|| Shape::Mesh(Mesh { placement: Placement::default(), ..mesh.clone() }).bounds())
    }

    /// What a geometry encloses before placement.
    pub(super) fn enclosure(&self, geometry: &Arc<MeshGeometry>) -> Enclosure {
        *self.enclosures.borrow_mut().entry(Arc::as_ptr(geometry)).or_insert_with(|| geometry.enclosure())
    }
}
