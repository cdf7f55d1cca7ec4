//! Whether a closed set of facets contains a point: the winding number, which needs no ray and so meets no edge.

use super::Facets;
use crate::precision::lies_in_plane;
use glam::DVec3;

/// Whether the facets go around the point. A point on a facet is outside.
///
/// The solid angle of a facet seen from the point is Van Oosterom and Strackee's (1983); the angles of a closed mesh
/// add up to ±4π inside and 0 outside, whatever its orientation.
pub(crate) fn closed(facets: &Facets, point: DVec3) -> bool {
    let mut half_angles = 0.0;
    for number in 0..facets.len() {
        let [p0, p1, p2] = facets.corners(number);
        let [a, b, c] = [p0 - point, p1 - point, p2 - point];
        let volume = a.dot(b.cross(c));
        let (la, lb, lc) = (a.length(), b.length(), c.length());
        let base = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        if base <= 0.0 && lies_in_plane(point, p0, p1, p2) {
            return false; // the point lies on the facet
        }
        half_angles += libm::atan2(volume, base);
    }
    // 2π inside and 0 outside; a point that is on an edge by rounding sees something between
    half_angles.abs() > 1.9 * std::f64::consts::PI
}

#[cfg(test)]
mod tests {
    use super::*;
    use lancer_scene::box_facets;

    #[test]
    fn a_box_contains_its_inside_and_not_its_surface() {
        let facets = Facets::separate(&box_facets(DVec3::ZERO, [DVec3::X, DVec3::Y, DVec3::Z]));
        for (x, inside) in
            [(-0.1, false), (0.0, false), (0.01, true), (0.5, true), (0.99, true), (1.0, false), (1.1, false)]
        {
            assert_eq!(closed(&facets, DVec3::new(x, 0.5, 0.5)), inside, "{x}");
            assert_eq!(closed(&facets, DVec3::new(x, 0.25, 0.5)), inside, "{x}");
        }
        assert!(!closed(&facets, DVec3::ZERO), "a corner");
        assert!(!closed(&facets, DVec3::new(0.0, 0.0, 0.5)), "an edge");
    }
}
