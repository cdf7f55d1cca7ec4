//! The shapes of objects: a closed enum, so that a new shape makes the compiler list the work.

use crate::cone::circle_extent;
use crate::{Mesh, MeshGeometry, placement};
use glam::DVec3;
use std::sync::Arc;

/// The geometry of an object (subject §3).
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// All points at `radius` from `center` (subject §3.1.1).
    Sphere {
        /// Centre `C`.
        center: DVec3,
        /// Radius `R`, greater than 0.
        radius: f64,
    },
    /// The infinite plane through three points (subject §3.1.2). It bounds the half-space behind its normal.
    Plane {
        /// `P0`.
        p0: DVec3,
        /// `P1`.
        p1: DVec3,
        /// `P2`, not on the line through the others.
        p2: DVec3,
    },
    /// One triangle, a sheet without thickness (subject §3.2).
    Facet {
        /// `P0`.
        p0: DVec3,
        /// `P1`.
        p1: DVec3,
        /// `P2`, not on the line through the others.
        p2: DVec3,
    },
    /// A cube of twelve facets.
    Cube {
        /// Its centre.
        center: DVec3,
        /// The length of its edges, greater than 0.
        edge: f64,
        /// Degrees about the fixed axes x, y, z in turn, around its centre.
        rotation: DVec3,
    },
    /// The `box` of the documents: twelve facets spanned by three edges.
    Parallelepiped {
        /// One corner.
        origin: DVec3,
        /// The three edges that leave it, not in one plane.
        edges: [DVec3; 3],
    },
    /// A right circular cone, truncated where its second radius is not 0; a cylinder where both radii are equal.
    Cone {
        /// The centre of its first circle.
        base: DVec3,
        /// The centre of its second circle, elsewhere than the first.
        top: DVec3,
        /// The radius at `base`, at least 0.
        base_radius: f64,
        /// The radius at `top`, at least 0 and not 0 where the other one is.
        top_radius: f64,
        /// Whether discs close its ends, so that it encloses a volume; an open one is a sheet without thickness.
        capped: bool,
    },
    /// Any other object made of facets.
    Mesh(Mesh),
}

impl Shape {
    /// The name of the shape's element in a scene document.
    pub fn element(&self) -> &'static str {
        match self {
            Shape::Sphere { .. } => "sphere",
            Shape::Plane { .. } => "plane",
            Shape::Facet { .. } => "facet",
            Shape::Cube { .. } => "cube",
            Shape::Parallelepiped { .. } => "box",
            Shape::Cone { .. } => "cone",
            Shape::Mesh(_) => "mesh",
        }
    }

    /// The geometry of a mesh.
    pub fn geometry(&self) -> Option<&Arc<MeshGeometry>> {
        self.mesh().map(|mesh| &mesh.geometry)
    }

    /// The mesh, if it is one.
    pub fn mesh(&self) -> Option<&Mesh> {
        match self {
            Shape::Mesh(mesh) => Some(mesh),
            Shape::Sphere { .. }
            | Shape::Plane { .. }
            | Shape::Facet { .. }
            | Shape::Cube { .. }
            | Shape::Parallelepiped { .. }
            | Shape::Cone { .. } => None,
        }
    }

    /// The corner and the three edges of a cube or a box.
    pub fn frame(&self) -> Option<(DVec3, [DVec3; 3])> {
        match self {
            Shape::Cube { center, edge, rotation } => {
                let edges = placement::rotation(*rotation);
                let edges = [edges.x_axis * *edge, edges.y_axis * *edge, edges.z_axis * *edge];
                Some((*center - (edges[0] + edges[1] + edges[2]) * 0.5, edges))
            }
            Shape::Parallelepiped { origin, edges } => Some((*origin, *edges)),
            Shape::Sphere { .. } | Shape::Plane { .. } | Shape::Facet { .. } | Shape::Cone { .. } | Shape::Mesh(_) => {
                None
            }
        }
    }

    /// The smallest box along the axes that holds the shape, as its least and greatest corner; `None` for a plane and
    /// for a mesh without vertices.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        match self {
            Shape::Sphere { center, radius } => {
                Some((*center - DVec3::splat(*radius), *center + DVec3::splat(*radius)))
            }
            Shape::Plane { .. } => None,
            Shape::Facet { p0, p1, p2 } => hull([*p0, *p1, *p2]),
            Shape::Cube { .. } | Shape::Parallelepiped { .. } => {
                self.frame().and_then(|(origin, edges)| hull(corners(origin, edges)))
            }
            Shape::Cone { base, top, base_radius, top_radius, .. } => {
                let across = circle_extent(*top - *base);
                let ends = [(*base, *base_radius), (*top, *top_radius)];
                hull(ends.into_iter().flat_map(|(center, radius)| [center - across * radius, center + across * radius]))
            }
            Shape::Mesh(mesh) => hull(mesh.used_positions()),
        }
    }
}

/// The least and greatest corner over all points.
pub(crate) fn hull(points: impl IntoIterator<Item = DVec3>) -> Option<(DVec3, DVec3)> {
    points.into_iter().fold(None, |hull, point| match hull {
        None => Some((point, point)),
        Some((low, high)) => Some((low.min(point), high.max(point))),
    })
}

/// The eight corners of a box: bit 0 of the number adds the first edge, bit 1 the second, bit 2 the third.
fn corners(origin: DVec3, [u, v, w]: [DVec3; 3]) -> [DVec3; 8] {
    let (ou, ov) = (origin + u, origin + v);
    let ouv = ou + v;
    [origin, ou, ov, ouv, origin + w, ou + w, ov + w, ouv + w]
}

/// The twelve facets of a box in their order: the faces without and with each edge in turn, two facets a face, with
/// normals `P0P1 × P0P2` that point outwards. Facets that meet share their corners to the last bit.
pub fn box_facets(origin: DVec3, edges: [DVec3; 3]) -> [[DVec3; 3]; 12] {
    // Corner numbers of each face, anticlockwise seen from outside for a right-handed box.
    const FACES: [[usize; 4]; 6] = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let corners = corners(origin, edges);
    let right_handed = edges[0].cross(edges[1]).dot(edges[2]) > 0.0;
    let mut facets = [[DVec3::ZERO; 3]; 12];
    for (face, numbers) in FACES.into_iter().enumerate() {
        let [a, b, c, d] = if right_handed { numbers } else { [numbers[0], numbers[3], numbers[2], numbers[1]] };
        facets[2 * face] = [a, b, c].map(|number| corners[number]);
        facets[2 * face + 1] = [a, c, d].map(|number| corners[number]);
    }
    facets
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Normals point away from the middle, and the facets' areas add up to the surface.
    #[test]
    fn box_facets_face_outwards() {
        let u = DVec3::new(2.0, 0.0, 0.0);
        let v = DVec3::new(0.5, 3.0, 0.0);
        let w = DVec3::new(0.0, 0.0, 1.0);
        for edges in [[u, v, w], [v, u, w], [u, w, v], [w, u, v]] {
            let origin = DVec3::new(1.0, -2.0, 5.0);
            let middle = origin + (u + v + w) * 0.5;
            let mut area = 0.0;
            for [a, b, c] in box_facets(origin, edges) {
                let normal = (b - a).cross(c - a);
                assert!(normal.dot(a - middle) > 0.0, "{edges:?}");
                area += normal.length() / 2.0;
            }
            let expected = 2.0 * (u.cross(v).length() + v.cross(w).length() + w.cross(u).length());
            assert!((area - expected).abs() < 1e-12);
        }
    }

    /// Circles around a coordinate axis reach their radius across it and nothing along it; one around (1 1 0)/√2 reaches
    /// r/√2 along x and y and r along z.
    #[test]
    fn a_cone_reaches_as_far_as_its_circles() {
        let bounds = |top: DVec3| {
            Shape::Cone { base: DVec3::ONE, top, base_radius: 2.0, top_radius: 0.5, capped: false }.bounds().unwrap()
        };
        assert_eq!(bounds(DVec3::new(1.0, 4.0, 1.0)), (DVec3::new(-1.0, 1.0, -1.0), DVec3::new(3.0, 4.0, 3.0)));
        let (low, high) = bounds(DVec3::new(9.0, 9.0, 1.0));
        let (base, top) = (2.0_f64.sqrt(), 0.5_f64.sqrt() / 2.0);
        assert!((low - DVec3::new(1.0 - base, 1.0 - base, -1.0)).length() < 1e-12, "{low}");
        assert!((high - DVec3::new(9.0 + top, 9.0 + top, 3.0)).length() < 1e-12, "{high}");
    }

    #[test]
    fn a_cube_is_centred_and_turned() {
        let cube = Shape::Cube { center: DVec3::new(1.0, 2.0, 3.0), edge: 2.0, rotation: DVec3::new(0.0, 45.0, 0.0) };
        let (low, high) = cube.bounds().unwrap();
        let half = 2.0_f64.sqrt();
        assert!((high - DVec3::new(1.0 + half, 3.0, 3.0 + half)).length() < 1e-12, "{high}");
        assert!((low - DVec3::new(1.0 - half, 1.0, 3.0 - half)).length() < 1e-12, "{low}");
    }
}
