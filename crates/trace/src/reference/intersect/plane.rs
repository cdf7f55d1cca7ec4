//! Ray and infinite plane (subject §3.1.2): `α·P0P1 + β·P0P2 - γ·d = P0S`; a null determinant is no hit, `γ` is the
//! distance, the normal is `P0P1 × P0P2`.

use crate::Ray;
use glam::DVec3;

/// The distance `γ` of the hit, if it is in front of the start.
///
/// By Cramer's rule `γ = (SP0·N)/(d·N)` with `N = P0P1 × P0P2`: only `γ` of the three unknowns is needed.
pub fn intersect_plane(ray: &Ray, p0: DVec3, p1: DVec3, p2: DVec3) -> Option<f64> {
    let normal = (p1 - p0).cross(p2 - p0);
    let determinant = ray.direction.dot(normal);
    if determinant == 0.0 {
        return None;
    }
    let gamma = (p0 - ray.origin).dot(normal) / determinant;
    (gamma > 0.0).then_some(gamma)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn floor(origin: DVec3, direction: DVec3) -> Option<f64> {
        intersect_plane(&Ray { origin, direction }, DVec3::ZERO, DVec3::Z, DVec3::X)
    }

    #[test]
    fn a_plane_is_met_from_both_sides() {
        let down = DVec3::new(0.0, -0.6, 0.8);
        assert_eq!(floor(DVec3::new(7.0, 3.0, -2.0), down), Some(5.0));
        assert_eq!(floor(DVec3::new(7.0, -3.0, -2.0), -down), Some(5.0));
        assert_eq!(floor(DVec3::new(7.0, 3.0, -2.0), -down), None, "behind");
        assert_eq!(floor(DVec3::new(0.0, 1.0, 0.0), DVec3::X), None, "parallel, above");
        assert_eq!(floor(DVec3::new(0.0, -1.0, 0.0), DVec3::X), None, "parallel, below");
        assert_eq!(floor(DVec3::ZERO, DVec3::X), None, "within the plane");
    }
}
