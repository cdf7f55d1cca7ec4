//! Whether a point lies inside an object.

use super::scenery::Scenery;
use crate::{DMat3, DVec3, Enclosure, Mesh, Shape};

/// The eight corners of a box.
pub(super) fn corners(origin: DVec3, [u, v, w]: [DVec3; 3]) -> [DVec3; 8] {
    [0_u8, 1, 2, 3, 4, 5, 6, 7].map(|number| {
        let edge = |bit: u8, edge: DVec3| if number & (1 << bit) == 0 { DVec3::ZERO } else { edge };
        origin + edge(0, u) + edge(1, v) + edge(2, w)
    })
}

impl Scenery<'_> {
    /// Whether the point is inside the volume that a shape encloses, not on its surface. Planes and sheets enclose
    /// none.
    pub(super) fn encloses(&self, shape: &Shape, point: DVec3) -> bool {
        match shape {
            Shape::Sphere { center, radius } => self.afford(1) && point.distance(*center) < radius * (1.0 - 1e-9),
            Shape::Cube { .. } | Shape::Parallelepiped { .. } => {
                self.afford(1)
                    && shape.frame().is_some_and(|(origin, [u, v, w])| {
                        let along = DMat3::from_cols(u, v, w).inverse() * (point - origin);
                        along.to_array().into_iter().all(|share| share > 1e-9 && share < 1.0 - 1e-9)
                    })
            }
            Shape::Cone { base, top, base_radius, top_radius, capped: true } => {
                let axis = *top - *base;
                let along = (point - *base).dot(axis) / axis.length_squared();
                let beside = (point - *base - axis * along).length();
                let radius = base_radius + (top_radius - base_radius) * along;
                let (least, greatest) = (1e-9, 1.0 - 1e-9);
                self.afford(1) && along > least && along < greatest && beside < radius * greatest
            }
            Shape::Mesh(mesh) => self.mesh_encloses(mesh, point),
            Shape::Plane { .. } | Shape::Facet { .. } | Shape::Cone { capped: false, .. } => false,
        }
    }

    /// By the winding number: the solid angles under which the point sees the facets add up to a whole sphere
    /// (Van Oosterom and Strackee 1983).
    fn mesh_encloses(&self, mesh: &Mesh, point: DVec3) -> bool {
        let geometry = &mesh.geometry;
        let inverse = mesh.placement.linear().inverse();
        let point = inverse * (point - mesh.placement.position);
        let Some((low, high)) = self.bounds_before_placement(mesh) else { return false };
        let within = low.cmplt(point).all() && point.cmplt(high).all();
        if !self.afford(1) || !within {
            return false;
        }
        // An angle costs some times what a look at a sphere does.
        if !self.afford(10 * geometry.facets.len()) || self.enclosure(geometry) == Enclosure::Sheet {
            return false;
        }
        let solid_angle = |facet: &[u32; 3]| {
            let [a, b, c] = facet.map(|vertex| geometry.positions[vertex as usize] - point);
            let (la, lb, lc) = (a.length(), b.length(), c.length());
            let volume = a.cross(b).dot(c);
            let scale = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
            2.0 * libm::atan2(volume, scale)
        };
        let winding = geometry.facets.iter().map(solid_angle).sum::<f64>() / (4.0 * std::f64::consts::PI);
        winding.abs() > 0.5
    }
}
