//! Ray and facet (subject §3.2): the plane's system, hit if `α ≥ 0`, `β ≥ 0`, `α+β ≤ 1`.

use crate::Ray;
use glam::DVec3;

/// Where a ray meets a facet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacetHit {
    /// The distance `γ`.
    pub t: f64,
    /// The share of `P0P1`.
    pub alpha: f64,
    /// The share of `P0P2`.
    pub beta: f64,
}

/// The hit of a ray and a facet, if there is one in front of the start.
///
/// `α`, `β` and `1-α-β` are the volumes that the ray's line spans with the facet's edges, over their sum: the same
/// solution of the subject's system, but an edge's volume is exactly the opposite for the facet on its other side, so
/// no ray passes between two facets that share an edge (the edge test of Plücker coordinates, Shoemake 1998).
pub fn intersect_facet(ray: &Ray, p0: DVec3, p1: DVec3, p2: DVec3) -> Option<FacetHit> {
    let normal = (p1 - p0).cross(p2 - p0);
    let determinant = ray.direction.dot(normal);
    if determinant == 0.0 {
        return None;
    }
    let [a, b, c] = [p0, p1, p2].map(|corner| corner - ray.origin);
    let (rest, alpha, beta) = (edge(ray, b, c), edge(ray, c, a), edge(ray, a, b));
    let inside = (rest >= 0.0 && alpha >= 0.0 && beta >= 0.0) || (rest <= 0.0 && alpha <= 0.0 && beta <= 0.0);
    let sum = rest + alpha + beta;
    if !inside || sum == 0.0 {
        return None;
    }
    let t = a.dot(normal) / determinant;
    (t > 0.0).then(|| FacetHit { t, alpha: alpha / sum, beta: beta / sum })
}

/// `2·I·(a × b)` for the edge from `a` to `b`, seen from the ray's start. Exchanging `a` and `b` changes the sign of
/// every intermediate result and nothing else.
fn edge(ray: &Ray, a: DVec3, b: DVec3) -> f64 {
    ray.direction.dot((a - b).cross(a + b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn hit(origin: DVec3, direction: DVec3) -> Option<FacetHit> {
        intersect_facet(&Ray { origin, direction }, DVec3::ZERO, DVec3::X * 2.0, DVec3::Y * 4.0)
    }

    #[test]
    fn a_facet_is_met_within_its_edges_from_both_sides() {
        let expected = Some(FacetHit { t: 3.0, alpha: 0.25, beta: 0.5 });
        assert_eq!(hit(DVec3::new(0.5, 2.0, 3.0), DVec3::NEG_Z), expected);
        assert_eq!(hit(DVec3::new(0.5, 2.0, -3.0), DVec3::Z), expected);
        assert_eq!(hit(DVec3::new(0.5, 2.0, 3.0), DVec3::Z), None, "behind");
        assert_eq!(hit(DVec3::new(1.5, 2.0, 3.0), DVec3::NEG_Z), None, "beyond the slanting edge");
        assert_eq!(hit(DVec3::new(-0.1, 2.0, 3.0), DVec3::NEG_Z), None, "left of it");
        assert_eq!(hit(DVec3::new(0.5, -0.1, 3.0), DVec3::NEG_Z), None, "below it");
        assert_eq!(hit(DVec3::new(-1.0, 1.0, 0.0), DVec3::X), None, "within its plane");
        for corner in [DVec3::ZERO, DVec3::X * 2.0, DVec3::Y * 4.0, DVec3::new(1.0, 2.0, 0.0)] {
            assert!(hit(corner + DVec3::Z, DVec3::NEG_Z).is_some(), "edges and corners belong to it: {corner}");
        }
    }

    fn point() -> impl Strategy<Value = DVec3> {
        [-10.0..10.0, -10.0..10.0, -10.0..10.0].prop_map(DVec3::from)
    }

    proptest! {
        /// A ray aimed at the shared edge of two facets meets one of them at least.
        #[test]
        fn nothing_passes_a_shared_edge(
            (a, b, c, d, origin) in (point(), point(), point(), point(), point()),
            along in 0.01..0.99_f64,
        ) {
            let target: DVec3 = a + (b - a) * along;
            let ray = Ray { origin, direction: (target - origin).normalize() };
            let normal_side = |p: DVec3| (b - a).cross(origin - a).dot(p - a);
            // c and d must lie on the two sides of the plane through the edge and the eye
            let d = if normal_side(c) * normal_side(d) > 0.0 { a + b - d } else { d };
            prop_assume!(normal_side(c).abs() > 1e-3 && normal_side(d).abs() > 1e-3);
            let first = intersect_facet(&ray, a, b, c);
            let second = intersect_facet(&ray, b, a, d);
            let (n1, n2) = ((b - a).cross(c - a), (a - b).cross(d - b));
            prop_assume!(ray.direction.dot(n1).abs() > 1e-3 && ray.direction.dot(n2).abs() > 1e-3);
            prop_assert!(first.is_some() || second.is_some());
        }
    }
}
