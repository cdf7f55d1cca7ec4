//! As far as f64 can tell: whether a computed point lies on a surface.
//!
//! A ray starts on a surface, an eye or a lamp may lie on one: there the hit at the ray's end is that point itself, be it
//! computed before or behind it. The coordinates of such points carry a few roundings of the greatest coordinate that
//! took part; what is nearer than that is no distance.

use glam::DVec3;

/// How far computed points may be from where they should be: a few roundings of the greatest coordinate among them.
pub(crate) fn roundings(points: &[DVec3]) -> f64 {
    16.0 * f64::EPSILON * points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max)
}

/// Whether a point lies in the plane through three points. A ray meets a plane once, so where its start or its lamp
/// lies in the plane of a facet, the hit is that very point.
pub(crate) fn lies_in_plane(point: DVec3, p0: DVec3, p1: DVec3, p2: DVec3) -> bool {
    let (u, v) = (p1 - p0, p2 - p0);
    let volume = (point - p0).dot(u.cross(v)).abs();
    let bound = roundings(&[point, p0, p1, p2]);
    // no length exceeds the sum of its coordinates: most points are told apart without a root
    volume <= bound * 1.000_001 * (u.abs().element_sum() * v.abs().element_sum())
        && volume <= bound * u.length() * v.length()
}

/// Whether a point lies on a sphere.
pub(crate) fn lies_on_sphere(point: DVec3, center: DVec3, radius: f64) -> bool {
    ((point - center).length() - radius).abs() <= roundings(&[point, center, DVec3::splat(radius)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point(size: f64) -> impl Strategy<Value = DVec3> {
        [-size..size, -size..size, -size..size].prop_map(DVec3::from)
    }

    proptest! {
        #[test]
        fn computed_points_of_a_plane_lie_in_it(
            p0 in point(9.0), u in point(1.0), v in point(1.0), (a, b) in (0.0..1.0, 0.0..1.0), off in 1e-9..1.0_f64,
        ) {
            prop_assume!(u.cross(v).length() > 0.1 * u.length() * v.length());
            let (p1, p2) = (p0 + u, p0 + v);
            let on = p0 + u * a + v * b;
            prop_assert!(lies_in_plane(on, p0, p1, p2));
            prop_assert!(!lies_in_plane(on + u.cross(v).normalize() * off, p0, p1, p2));
        }

        #[test]
        fn computed_points_of_a_sphere_lie_on_it(center in point(9.0), way in point(1.0), radius in 0.01..9.0, off in 1e-9..1.0) {
            prop_assume!(way.length() > 0.1);
            let way = way.normalize();
            prop_assert!(lies_on_sphere(center + way * radius, center, radius));
            prop_assert!(!lies_on_sphere(center + way * (radius + off), center, radius));
        }
    }
}
