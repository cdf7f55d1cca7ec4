//! Mirrored and refracted rays (subject §1.3).

use glam::DVec3;

/// The mirrored direction `R = I - 2(I·N)N`.
pub fn reflect(incident: DVec3, normal: DVec3) -> DVec3 {
    incident - normal * (2.0 * incident.dot(normal))
}

/// The refracted direction `T = (n/n')·(I - ((I·N) + √((n'/n)² + (I·N)² - 1))·N)`, or `None` where the root is negative:
/// total internal reflection.
///
/// `normal` is turned against `incident`; both are unit vectors. With equal indices `T` is `I` to the last bit.
pub fn refract(incident: DVec3, normal: DVec3, n: f64, n_prime: f64) -> Option<DVec3> {
    let cosine = incident.dot(normal);
    let ratio = n_prime / n;
    let under_root = ratio * ratio + cosine * cosine - 1.0;
    if under_root < 0.0 {
        return None;
    }
    if n == n_prime {
        return Some(incident);
    }
    Some((incident - normal * (cosine + under_root.sqrt())) * (n / n_prime))
}

/// A mirrored direction of a smooth normal that would enter the surface is mirrored out of it.
pub fn keep_outside(direction: DVec3, geometric_normal: DVec3) -> DVec3 {
    if direction.dot(geometric_normal) < 0.0 { reflect(direction, geometric_normal) } else { direction }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// An incident direction at `degrees` from the normal z.
    fn at(degrees: f64) -> DVec3 {
        let (sin, cos) = degrees.to_radians().sin_cos();
        DVec3::new(sin, 0.0, -cos)
    }

    fn refracted_angle(degrees: f64, n: f64, n_prime: f64) -> Option<f64> {
        refract(at(degrees), DVec3::Z, n, n_prime).map(|t| t.x.atan2(-t.z).to_degrees())
    }

    /// Published angles (Snell's law; the critical angles of tables).
    #[test]
    fn snell() {
        for (degrees, n, n_prime, expected) in [
            (30.0, 1.0, 1.5, 19.4712206),
            (45.0, 1.0, 1.5, 28.1255057),
            (60.0, 1.0, 1.5, 35.2643897),
            (80.0, 1.0, 1.5, 41.0364105),
            (10.0, 1.5, 1.0, 15.0980866),
        ] {
            let angle = refracted_angle(degrees, n, n_prime).unwrap();
            assert!((angle - expected).abs() < 1e-7, "{degrees}: {angle}");
        }
    }

    #[test]
    fn critical_angles() {
        for (index, critical) in [(1.5, 41.8103149), (1.333, 48.6066264), (2.419, 24.4182174)] {
            assert!(refracted_angle(critical - 1e-7, index, 1.0).is_some(), "{index}");
            assert!(refracted_angle(critical + 1e-7, index, 1.0).is_none(), "{index}");
        }
    }

    #[test]
    fn a_mirror_at_45_degrees() {
        let r = reflect(DVec3::new(0.0, -0.5_f64.sqrt(), 0.5_f64.sqrt()), DVec3::Y);
        assert!((r - DVec3::new(0.0, 0.5_f64.sqrt(), 0.5_f64.sqrt())).length() < 1e-15);
    }

    fn unit() -> impl Strategy<Value = DVec3> {
        [-1.0..1.0, -1.0..1.0, -1.0..1.0]
            .prop_map(DVec3::from)
            .prop_filter_map("too short", |v| (v.length() > 0.1).then(|| v.normalize()))
    }

    proptest! {
        #[test]
        fn reflecting_twice_is_the_identity(incident in unit(), normal in unit()) {
            prop_assert!((reflect(reflect(incident, normal), normal) - incident).length() < 1e-14);
        }

        #[test]
        fn refraction_there_and_back_is_the_identity(incident in unit(), normal in unit(), n in 1.0..3.0, m in 1.0..3.0) {
            let normal = if incident.dot(normal) > 0.0 { -normal } else { normal };
            if let Some(there) = refract(incident, normal, n, m) {
                prop_assert!((there.length() - 1.0).abs() < 1e-12);
                // the same path backwards
                let back = refract(-there, -normal, m, n);
                prop_assume!(incident.dot(normal).abs() > 1e-3);
                prop_assert!((back.unwrap() + incident).length() < 1e-9);
                // n·sin i = n'·sin r, in one plane
                prop_assert!((n * incident.cross(normal) - m * there.cross(normal)).length() < 1e-12);
            }
        }

        #[test]
        fn equal_indices_go_straight_on(incident in unit(), normal in unit(), n in 0.5..3.0) {
            let normal = if incident.dot(normal) > 0.0 { -normal } else { normal };
            prop_assert_eq!(refract(incident, normal, n, n), Some(incident));
        }

        #[test]
        fn a_kept_direction_leaves_the_surface(direction in unit(), normal in unit()) {
            prop_assert!(keep_outside(direction, normal).dot(normal) >= -1e-15);
        }
    }
}
