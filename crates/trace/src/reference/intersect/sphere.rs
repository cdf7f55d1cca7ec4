//! Ray and sphere (subject §3.1.1): `Δ = R² + (d·SC)² - |SC|²`, `t = (d·SC) ± √Δ`, the smallest positive `t`.

use crate::Ray;
use glam::DVec3;

/// Whether a ray starts on the very surface that it is tried against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// It starts on this surface: the hit there is left out.
    OnSurface,
    /// It starts anywhere else.
    Elsewhere,
}

/// The distance of the nearest hit, if there is one.
///
/// `Δ` is computed as `R² - |SC - q·I|²` with `q = I·SC`: the same number without the cancellation that would eat the
/// digits of a small sphere far away. `Δ = 0` touches the sphere where `I·N = 0`, which is no hit. A ray that starts on
/// the sphere has one root at its start; the other one is ahead if the ray goes inwards.
pub fn intersect_sphere(ray: &Ray, center: DVec3, radius: f64, start: Start) -> Option<f64> {
    let sc = center - ray.origin;
    let q = ray.direction.dot(sc);
    let delta = radius * radius - (sc - ray.direction * q).length_squared();
    match start {
        // by rounding alone the start can seem to lie outside of the grazed sphere: then both roots are the start
        Start::OnSurface => (q > 0.0 && delta > 0.0).then(|| q + delta.sqrt()),
        Start::Elsewhere if delta > 0.0 => {
            let root = delta.sqrt();
            [q - root, q + root].into_iter().find(|t| *t > 0.0)
        }
        Start::Elsewhere => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hit(origin: DVec3, direction: DVec3, center: DVec3, radius: f64) -> Option<f64> {
        intersect_sphere(&Ray { origin, direction }, center, radius, Start::Elsewhere)
    }

    /// Analytic distances: from outside, from inside, behind, beside, touching.
    #[test]
    fn the_smallest_positive_root_is_seen() {
        let from = |z: f64, y: f64| hit(DVec3::new(0.0, y, z), DVec3::Z, DVec3::ZERO, 1.0);
        assert_eq!(from(-5.0, 0.0), Some(4.0));
        assert_eq!(from(-5.0, 1.0), None, "touching");
        assert_eq!(from(-5.0, 2.0), None, "beside");
        assert_eq!(from(0.0, 0.0), Some(1.0), "inside");
        assert_eq!(from(5.0, 0.0), None, "behind");
        assert_eq!(from(-5.0, 0.6).map(|t| (t - 4.2).abs() < 1e-15), Some(true));
        assert_eq!(hit(DVec3::new(0.0, 0.0, -5.0), DVec3::Z, DVec3::ZERO, 2.0), Some(3.0));
        assert_eq!(hit(DVec3::new(0.0, 0.0, -5.0), DVec3::Z, DVec3::X * 5.0, 1.0), None);
    }

    #[test]
    fn a_ray_from_the_surface_sees_the_other_side_only() {
        let from = |direction: DVec3| {
            intersect_sphere(&Ray { origin: DVec3::X, direction }, DVec3::ZERO, 1.0, Start::OnSurface)
        };
        assert_eq!(from(DVec3::NEG_X), Some(2.0));
        assert_eq!(from(DVec3::X), None);
        assert_eq!(from(DVec3::Y), None);
    }

    /// The naive `Δ` has no correct digit here: `|SC|²` is 10²⁴ and `R²` is 1.
    #[test]
    fn a_small_sphere_far_away_keeps_its_digits() {
        let t = hit(DVec3::new(-1e12, 0.5, 0.0), DVec3::X, DVec3::ZERO, 1.0).unwrap();
        assert!((t - (1e12 - 0.75_f64.sqrt())).abs() <= 1e12 * f64::EPSILON, "{t}");
    }
}
