//! Objects as facets, for formats that hold nothing else. Round shapes become polyhedra, planes are left out.

use super::loss::{Feature, Loss, Losses};
use lancer_scene::{DVec3, MaterialRef, MeshGeometry, Object, Scene, Shape, box_facets, cone_facets};
use std::borrow::Cow;
use std::f64::consts::PI;
use std::sync::Arc;

/// How many facets go around round shapes.
const AROUND: u32 = 64;

/// The facets of an object before its placement.
pub(super) struct Facetted<'a> {
    pub(super) geometry: Cow<'a, MeshGeometry>,
    /// A normal for each vertex, of unit length or 0; empty where facets are flat.
    pub(super) normals: Cow<'a, [DVec3]>,
}

/// The facets of a shape; `None` for a plane, and for a mesh without facets.
pub(super) fn facetted(shape: &Shape) -> Option<Facetted<'_>> {
    let flat = |facets: &[[DVec3; 3]]| Facetted { geometry: Cow::Owned(separate(facets)), normals: Cow::default() };
    match shape {
        Shape::Sphere { center, radius } => {
            let (geometry, normals) = sphere(*center, *radius);
            Some(Facetted { geometry: Cow::Owned(geometry), normals: Cow::Owned(normals) })
        }
        Shape::Plane { .. } => None,
        Shape::Facet { p0, p1, p2 } => Some(flat(&[[*p0, *p1, *p2]])),
        Shape::Cube { .. } | Shape::Parallelepiped { .. } => {
            shape.frame().map(|(origin, edges)| flat(&box_facets(origin, edges)))
        }
        Shape::Cone { base, top, base_radius, top_radius, capped } => {
            Some(flat(&cone_facets([*base, *top], [*base_radius, *top_radius], *capped, AROUND)))
        }
        Shape::Mesh(mesh) => {
            let normals = if mesh.smooth { mesh.geometry.smooth_normals() } else { Cow::default() };
            let unit = normals.iter().map(|normal| normal.normalize_or_zero()).collect();
            let geometry = Cow::Borrowed(&*mesh.geometry);
            Some(Facetted { geometry, normals: Cow::Owned(unit) }).filter(|it| !it.geometry.facets.is_empty())
        }
    }
}

/// Facets that share no corner.
fn separate(facets: &[[DVec3; 3]]) -> MeshGeometry {
    let corners = (0..facets.len() as u32).map(|facet| [3 * facet, 3 * facet + 1, 3 * facet + 2]).collect();
    MeshGeometry { positions: facets.concat(), facets: corners, ..MeshGeometry::default() }
}

/// A sphere by meridians and parallels, with its normals.
fn sphere(center: DVec3, radius: f64) -> (MeshGeometry, Vec<DVec3>) {
    let rows = AROUND / 2;
    let mut normals = vec![DVec3::Y];
    for row in 1..rows {
        let (sin, cos) = libm::sincos(PI * f64::from(row) / f64::from(rows));
        normals.extend((0..AROUND).map(|column| {
            let (x, z) = libm::sincos(2.0 * PI * f64::from(column) / f64::from(AROUND));
            DVec3::new(x * sin, cos, z * sin)
        }));
    }
    normals.push(DVec3::NEG_Y);
    let last = normals.len() as u32 - 1;
    let at = |row: u32, column: u32| match row {
        0 => 0,
        row if row == rows => last,
        row => 1 + (row - 1) * AROUND + column % AROUND,
    };
    let mut facets = Vec::new();
    for row in 0..rows {
        for column in 0..AROUND {
            let [a, b] = [at(row, column), at(row, column + 1)];
            let [c, d] = [at(row + 1, column + 1), at(row + 1, column)];
            facets.extend([[a, d, c], [a, c, b]].into_iter().filter(|[a, b, c]| a != b && b != c && c != a));
        }
    }
    let positions = normals.iter().map(|normal| center + *normal * radius).collect();
    (MeshGeometry { positions, facets, ..MeshGeometry::default() }, normals)
}

/// The runs of facets of one material, in order: `(material, first, end)`.
pub(super) fn runs<'a>(object: &'a Object, geometry: &MeshGeometry) -> Vec<(&'a MaterialRef, usize, usize)> {
    let parts = object.shape.geometry().map_or(&[][..], |geometry| geometry.parts.as_slice());
    let (mut runs, mut at) = (Vec::new(), 0);
    for part in parts {
        let (first, end) = (part.first as usize, part.first as usize + part.count as usize);
        runs.push((&object.material, at, first));
        runs.push((&part.material, first, end));
        at = end;
    }
    runs.push((&object.material, at, geometry.facets.len()));
    runs.retain(|(_, first, end)| first < end);
    runs
}

/// What is lost where objects become facets, and what such formats have no place for.
pub(super) fn losses(scene: &Scene) -> Losses {
    let mut losses = Losses(vec![Loss::Lights]);
    super::loss::hidden(scene, &mut losses);
    for object in scene.objects.iter().filter(|object| object.visible) {
        let (plane, round) = match object.shape {
            Shape::Plane { .. } => (true, false),
            Shape::Sphere { .. } | Shape::Cone { .. } => (false, true),
            Shape::Facet { .. } | Shape::Cube { .. } | Shape::Parallelepiped { .. } | Shape::Mesh(_) => (false, false),
        };
        losses.of_each([(plane, Feature::Plane), (round, Feature::Roundness)], &object.name);
    }
    losses
}

/// The numbers of materials in the order of their first use.
#[derive(Default)]
pub(super) struct Numbering<'a>(pub(super) Vec<&'a MaterialRef>);

impl<'a> Numbering<'a> {
    /// The number of a material.
    pub(super) fn number(&mut self, material: &'a MaterialRef) -> usize {
        let same = |other: &&MaterialRef| match (*other, material) {
            (MaterialRef::Inline(a), MaterialRef::Inline(b)) => Arc::ptr_eq(a, b),
            (a, b) => a == b,
        };
        self.0.iter().position(same).unwrap_or_else(|| {
            self.0.push(material);
            self.0.len() - 1
        })
    }

    /// The name that a material gets: its own, or one of a number.
    pub(super) fn name(&self, number: usize) -> String {
        match self.0.get(number).and_then(|material| material.name()) {
            Some(name) => name.to_string(),
            None => format!("surface {}", number + 1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lancer_scene::Enclosure;

    /// `4/3·π·r³`, less what 64 meridians leave out: under one hundredth.
    #[test]
    fn a_sphere_of_facets_is_closed_and_faces_outwards() {
        let (geometry, normals) = sphere(DVec3::new(1.0, 2.0, 3.0), 2.0);
        assert_eq!(geometry.enclosure(), Enclosure::Volume { inverted: false });
        let corner = |vertex: u32| geometry.positions[vertex as usize] - DVec3::new(1.0, 2.0, 3.0);
        let six: f64 = geometry.facets.iter().map(|&[a, b, c]| corner(a).cross(corner(b)).dot(corner(c))).sum();
        let share = six / 6.0 / (4.0 / 3.0 * PI * 8.0);
        assert!((0.99..1.0).contains(&share), "{share}");
        assert!(normals.iter().all(|normal| (normal.length() - 1.0).abs() < 1e-12));
    }
}
