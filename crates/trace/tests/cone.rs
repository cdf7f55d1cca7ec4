//! Laws of the cone, against analytic values and against fine facets.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use glam::DVec3;
use lancer_scene::ConeFace;
use lancer_scene::{Object, Scene, Shape, cone_facets};
use lancer_trace::reference::intersect::{Cone, Start, intersect_cone, intersect_facet};
use lancer_trace::{Caster, Ray, Simd, World};
use proptest::prelude::*;

const TIP: f64 = 0.0;

fn cone(base_radius: f64, top_radius: f64, capped: bool) -> Cone {
    // along y, from -1 to 3
    Cone::new([DVec3::NEG_Y, DVec3::Y * 3.0], [base_radius, top_radius], capped)
}

fn hit(cone: &Cone, origin: [f64; 3], direction: [f64; 3]) -> Option<(f64, ConeFace)> {
    let ray = Ray { origin: origin.into(), direction: DVec3::from(direction).normalize() };
    intersect_cone(&ray, cone, Start::Elsewhere)
}

fn at(t: f64, face: ConeFace, found: Option<(f64, ConeFace)>) {
    let (found, found_face) = found.unwrap();
    assert!((found - t).abs() < 1e-14 * t.max(1.0), "{found}, not {t}");
    assert_eq!(found_face, face);
}

#[test]
fn a_cylinder_is_met_from_all_sides() {
    let (capped, open) = (cone(2.0, 2.0, true), cone(2.0, 2.0, false));
    for cylinder in [&capped, &open] {
        at(3.0, ConeFace::Side, hit(cylinder, [5.0, 0.0, 0.0], [-1.0, 0.0, 0.0]));
        at(2.0, ConeFace::Side, hit(cylinder, [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]));
        // 3-4-5: at z = 1.6 beside the axis the side is 1.2 away from the middle
        at(3.8, ConeFace::Side, hit(cylinder, [-5.0, 2.9, 1.6], [1.0, 0.0, 0.0]));
        assert_eq!(hit(cylinder, [5.0, 3.1, 0.0], [-1.0, 0.0, 0.0]), None, "above it");
        assert_eq!(hit(cylinder, [5.0, 0.0, 2.0], [-1.0, 0.0, 0.0]), None, "touching");
        assert_eq!(hit(cylinder, [5.0, 0.0, 0.0], [1.0, 0.0, 0.0]), None, "behind");
    }
    at(2.0, ConeFace::Top, hit(&capped, [1.0, 5.0, 1.0], [0.0, -1.0, 0.0]));
    at(1.0, ConeFace::Base, hit(&capped, [1.0, 0.0, 1.0], [0.0, -1.0, 0.0]));
    assert_eq!(hit(&open, [1.0, 5.0, 1.0], [0.0, -1.0, 0.0]), None, "through the tube");
    // down into the open tube at 45°: past the rim, onto the far side
    at(4.0 * 2.0_f64.sqrt(), ConeFace::Side, hit(&open, [-2.0, 4.5, 0.0], [1.0, -1.0, 0.0]));
    at(1.5 * 2.0_f64.sqrt(), ConeFace::Top, hit(&capped, [-2.0, 4.5, 0.0], [1.0, -1.0, 0.0]));
    assert_eq!(hit(&capped, [0.0, 3.0, 0.0], [1.0, 0.0, 0.0]), None, "along a cap: I·N = 0");
}

#[test]
fn a_tip_is_met_and_the_other_cone_is_not() {
    // at height y the radius is (3 - y)/2
    let (capped, open) = (cone(2.0, TIP, true), cone(2.0, TIP, false));
    for cone in [&capped, &open] {
        at(3.5, ConeFace::Side, hit(cone, [5.0, 0.0, 0.0], [-1.0, 0.0, 0.0]));
        at(4.0, ConeFace::Side, hit(cone, [0.0, 7.0, 0.0], [0.0, -1.0, 0.0]));
        at(1.0, ConeFace::Side, hit(cone, [1.0, 2.0, 0.0], [0.0, -1.0, 0.0]));
        assert_eq!(hit(cone, [5.0, 4.0, 0.0], [-1.0, 0.0, 0.0]), None, "where the other cone would be");
        assert_eq!(hit(cone, [0.0, 7.0, 0.0], [0.0, 1.0, 0.0]), None);
        // parallel to a generatrix, half a unit above it: the opposite side is the only hit
        let along = [1.0, -2.0, 0.0];
        let (t, face) = hit(cone, [-2.0, 4.0, 0.0], along).unwrap();
        let point = DVec3::new(-2.0, 4.0, 0.0) + DVec3::from(along).normalize() * t;
        assert_eq!(face, ConeFace::Side);
        assert!((point - DVec3::new(-0.75, 1.5, 0.0)).length() < 1e-14, "{point}");
    }
    at(2.0, ConeFace::Base, hit(&capped, [0.0, -3.0, 0.0], [0.0, 1.0, 0.0]));
    at(6.0, ConeFace::Side, hit(&open, [0.0, -3.0, 0.0], [0.0, 1.0, 0.0]));
}

#[test]
fn a_ray_from_the_surface_sees_the_other_end_only() {
    let (capped, open) = (cone(2.0, 2.0, true), cone(2.0, 2.0, false));
    let from = |cone: &Cone, origin: [f64; 3], direction: [f64; 3]| {
        let ray = Ray { origin: origin.into(), direction: DVec3::from(direction).normalize() };
        intersect_cone(&ray, cone, Start::OnSurface)
    };
    for cylinder in [&capped, &open] {
        at(4.0, ConeFace::Side, from(cylinder, [2.0, 0.0, 0.0], [-1.0, 0.0, 0.0]));
        assert_eq!(from(cylinder, [2.0, 0.0, 0.0], [1.0, 0.0, 0.0]), None);
        assert_eq!(from(cylinder, [2.0, 0.0, 0.0], [1.0, 1.0, 1.0]), None);
    }
    at(4.0, ConeFace::Base, from(&capped, [1.0, 3.0, 0.0], [0.0, -1.0, 0.0]));
    at(5.0, ConeFace::Base, from(&capped, [2.0, 3.0, 0.0], [-3.0, -4.0, 0.0]));
    assert_eq!(from(&capped, [1.0, 3.0, 0.0], [0.0, 1.0, 0.0]), None);
    assert_eq!(from(&open, [2.0, 3.0, 0.0], [-3.0, -4.0, 0.0]), None, "out of the open end");
}

fn point(size: f64) -> impl Strategy<Value = DVec3> {
    [-size..size, -size..size, -size..size].prop_map(DVec3::from)
}

/// Two ends, two radii.
fn any_cone() -> impl Strategy<Value = ([DVec3; 2], [f64; 2])> {
    let radius = || prop_oneof![3 => 0.05..2.0_f64, 1 => Just(TIP), 1 => Just(1.0)];
    (point(2.0), point(2.0), radius(), radius()).prop_filter_map("a cone", |(base, top, r0, r1)| {
        ((top - base).length() > 0.1 && r0 + r1 > 0.0).then_some(([base, top], [r0, r1]))
    })
}

/// The nearest hit of facets.
fn nearest(facets: &[[DVec3; 3]], ray: &Ray) -> Option<f64> {
    facets.iter().filter_map(|[a, b, c]| intersect_facet(ray, *a, *b, *c)).map(|hit| hit.t).min_by(f64::total_cmp)
}

proptest! {
    /// Facets through the circle's points are within the cone, facets around it are without: where a ray meets the
    /// inner ones it has met the cone before, and before that the outer ones.
    #[test]
    fn a_capped_cone_lies_between_its_facets((ends, radii) in any_cone(), origin in point(6.0), target in point(2.0)) {
        const AROUND: u32 = 256;
        let cone = Cone::new(ends, radii, true);
        let outer = radii.map(|radius| radius / (std::f64::consts::PI / f64::from(AROUND)).cos());
        let inside = cone_facets(ends, radii, true, AROUND);
        let around = cone_facets(ends, outer, true, AROUND);
        let ray = Ray { origin, direction: (target - origin).normalize() };
        let met = intersect_cone(&ray, &cone, Start::Elsewhere).map(|(t, _)| t);
        // from within, the order would be the other way round
        let contained = |facets: &[[DVec3; 3]]| {
            facets.iter().filter(|[a, b, c]| intersect_facet(&ray, *a, *b, *c).is_some()).count() % 2 == 1
        };
        prop_assume!(!contained(&around));
        if let Some(t) = nearest(&inside, &ray) {
            prop_assert!(met.is_some_and(|met| met <= t + 1e-9), "{met:?} after {t}");
        }
        if let Some(t) = met {
            prop_assert!(nearest(&around, &ray).is_some_and(|outer| outer <= t + 1e-9));
        }
    }

    /// An open cone is the side of the capped one.
    #[test]
    fn an_open_cone_is_the_side_of_the_capped_one((ends, radii) in any_cone(), origin in point(6.0), target in point(2.0)) {
        let [capped, open] = [true, false].map(|capped| Cone::new(ends, radii, capped));
        let ray = Ray { origin, direction: (target - origin).normalize() };
        let first = intersect_cone(&ray, &capped, Start::Elsewhere);
        let second = first.and_then(|(t, _)| {
            let onward = Ray { origin: ray.at(t), ..ray };
            intersect_cone(&onward, &capped, Start::OnSurface).map(|(more, face)| (t + more, face))
        });
        let side = [first, second].into_iter().flatten().find(|(_, face)| *face == ConeFace::Side);
        let met = intersect_cone(&ray, &open, Start::Elsewhere);
        match (side, met) {
            (Some((due, _)), Some((t, ConeFace::Side))) => prop_assert!((due - t).abs() < 1e-9, "{due} {t}"),
            (due, met) => prop_assert_eq!(due, met),
        }
    }

    /// The cylinder around y, by its own equation: x² + z² = R².
    #[test]
    fn equal_radii_are_a_cylinder(radius in 0.1..3.0_f64, origin in point(6.0), target in point(2.0), capped in any::<bool>()) {
        let ray = Ray { origin, direction: (target - origin).normalize() };
        let (o, d) = (ray.origin, ray.direction);
        let (a, b, c) = (d.x * d.x + d.z * d.z, o.x * d.x + o.z * d.z, o.x * o.x + o.z * o.z - radius * radius);
        let delta = b * b - a * c;
        let mut due: Vec<f64> = Vec::new();
        if delta > 0.0 {
            let roots = [(-b - delta.sqrt()) / a, (-b + delta.sqrt()) / a];
            due.extend(roots.into_iter().filter(|t| (-1.0..=3.0).contains(&(o.y + d.y * t))));
        }
        if capped {
            let caps = [-1.0, 3.0].map(|y| (y - o.y) / d.y);
            due.extend(caps.into_iter().filter(|t| (o.x + d.x * t).hypot(o.z + d.z * t) <= radius));
        }
        let due = due.into_iter().filter(|t| *t > 0.0).min_by(f64::total_cmp);
        let met = intersect_cone(&ray, &cone(radius, radius, capped), Start::Elsewhere).map(|(t, _)| t);
        match (due, met) {
            (Some(due), Some(met)) => prop_assert!((due - met).abs() < 1e-9, "{due} {met}"),
            (due, met) => prop_assert_eq!(due, met),
        }
    }

    /// The seen point satisfies the cone's equation, the normal is of unit length and points to where the ray comes from.
    #[test]
    fn what_is_seen_lies_on_the_cone((ends, radii) in any_cone(), origin in point(9.0), target in point(2.0), capped in any::<bool>()) {
        let shape = Shape::Cone { base: ends[0], top: ends[1], base_radius: radii[0], top_radius: radii[1], capped };
        let scene = Scene { objects: [Object::new("cone", shape)].into_iter().collect(), ..Scene::default() };
        let world = World::compile(&scene);
        let ray = Ray { origin, direction: (target - origin).normalize() };
        let due = intersect_cone(&ray, &Cone::new(ends, radii, capped), Start::Elsewhere);
        let seen = world.pick(&ray);
        prop_assert_eq!(seen.as_ref().map(|seen| seen.facet), due.map(|(_, face)| face.number()));
        for simd in Simd::ALL.into_iter().filter(|simd| simd.is_available()) {
            let mut distances = Vec::new();
            Caster::new(&world, simd).nearest(&[ray], &mut distances);
            prop_assert_eq!(distances[0].to_bits(), due.map_or(f64::INFINITY, |(t, _)| t).to_bits());
        }
        let Some(seen) = seen else { return Ok(()) };
        let height = (ends[1] - ends[0]).length();
        let axis = (ends[1] - ends[0]) / height;
        let z = (seen.point - ends[0]).dot(axis);
        let beside = (seen.point - ends[0] - axis * z).length();
        let off = match ConeFace::of(seen.facet) {
            ConeFace::Side => beside - (radii[0] + (radii[1] - radii[0]) * z / height),
            ConeFace::Base => z,
            ConeFace::Top => z - height,
        };
        prop_assert!(off.abs() < 1e-14 * (1.0 + (radii[1] - radii[0]).abs() / height), "{off}");
        prop_assert!((seen.normal.length() - 1.0).abs() < 1e-14);
        prop_assert!(seen.normal.dot(ray.direction) <= 0.0);
        prop_assert!((seen.point - ray.at(seen.distance)).length() < 1e-9);
        // a step along the normal leaves the side's equation as fast as the step is long
        if ConeFace::of(seen.facet) == ConeFace::Side && beside > 1e-3 {
            let step = seen.point + seen.normal * 1e-4;
            let z = (step - ends[0]).dot(axis);
            let gap = (step - ends[0] - axis * z).length() - (radii[0] + (radii[1] - radii[0]) * z / height);
            let cosine = height / (height * height + (radii[1] - radii[0]) * (radii[1] - radii[0])).sqrt();
            prop_assert!(((gap * cosine).abs() - 1e-4).abs() < 1e-6 * (1.0 + 1.0 / beside), "{gap}");
        }
    }
}
