//! Picking against brute force: the nearest hit of every shape, by formulas of its own.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use lancer_scene::{DVec3, Mesh, MeshGeometry, Object, Placement, Scene, ScreenSpec, Shape, Steps, View, box_facets};
use lancer_trace::{Camera, Ray, World};
use proptest::prelude::*;
use std::sync::Arc;

fn point(reach: f64) -> impl Strategy<Value = DVec3> {
    [-reach..reach, -reach..reach, -reach..reach].prop_map(DVec3::from)
}

fn shape() -> impl Strategy<Value = Shape> {
    let mesh = (prop::collection::vec(point(1.0), 4..8), point(3.0), point(180.0), 0.2..2.0_f64).prop_map(
        |(positions, position, rotation, scale)| {
            let count = positions.len() as u32;
            let facets = (0..count).map(|number| [number, (number + 1) % count, (number + 2) % count]).collect();
            let geometry = Arc::new(MeshGeometry { positions, facets, ..MeshGeometry::default() });
            let placement = Placement { scale: DVec3::splat(scale), rotation, position };
            Shape::Mesh(Mesh { geometry, source: None, placement, smooth: true })
        },
    );
    prop_oneof![
        (point(3.0), 0.1..1.5_f64).prop_map(|(center, radius)| Shape::Sphere { center, radius }),
        [point(3.0), point(3.0), point(3.0)].prop_map(|[p0, p1, p2]| Shape::Plane { p0, p1, p2 }),
        [point(3.0), point(3.0), point(3.0)].prop_map(|[p0, p1, p2]| Shape::Facet { p0, p1, p2 }),
        (point(3.0), 0.1..2.0_f64, point(180.0)).prop_map(|(center, edge, rotation)| Shape::Cube {
            center,
            edge,
            rotation
        }),
        (point(3.0), [point(1.0), point(1.0), point(1.0)])
            .prop_map(|(origin, edges)| Shape::Parallelepiped { origin, edges }),
        (point(3.0), point(3.0), 0.0..1.5_f64, 0.1..1.5_f64, any::<bool>()).prop_map(
            |(base, top, base_radius, top_radius, capped)| Shape::Cone { base, top, base_radius, top_radius, capped }
        ),
        mesh,
    ]
    .prop_filter("a degenerate figure", |shape| shape.check().is_ok())
}

/// How far along the ray a facet is hit (Möller and Trumbore 1997), and how far inside of its edges.
fn facet(ray: &Ray, [a, b, c]: [DVec3; 3]) -> Option<(f64, f64)> {
    let (u, v) = (b - a, c - a);
    let across = ray.direction.cross(v);
    let determinant = u.dot(across);
    let from = ray.origin - a;
    let alpha = from.dot(across) / determinant;
    let beta = ray.direction.dot(from.cross(u)) / determinant;
    let distance = v.dot(from.cross(u)) / determinant;
    let inside = alpha.min(beta).min(1.0 - alpha - beta);
    (determinant != 0.0 && distance > 0.0).then_some((distance, inside))
}

/// Every hit of a cone, and how clear of where its side ends and of being grazed: the signs of `|P-B-z·a| - R(z)` along
/// the ray are bisected.
fn cone_hits(ray: &Ray, [base, top]: [DVec3; 2], radii: [f64; 2], capped: bool) -> Vec<(f64, f64)> {
    let height = (top - base).length();
    let axis = (top - base) / height;
    let gap = |t: f64| {
        let from_base = ray.origin + ray.direction * t - base;
        let z = from_base.dot(axis);
        ((from_base - axis * z).length() - (radii[0] + (radii[1] - radii[0]) * z / height), z)
    };
    let mut hits = Vec::new();
    let steps: Vec<f64> = (0..4000).map(|step| f64::from(step) * 0.01).collect();
    for pair in steps.windows(2) {
        let (mut from, mut to) = (pair[0], pair[1]);
        // a step across which the gap nearly vanishes without a change of sign is in doubt
        let (first, last) = (gap(from), gap(to));
        if first.0.signum() == last.0.signum() {
            if first.0.abs().min(last.0.abs()) < 0.02 && (-0.05..=height + 0.05).contains(&first.1) {
                hits.push((from, 0.0));
            }
            continue;
        }
        for _ in 0..60 {
            let middle = (from + to) / 2.0;
            if gap(middle).0.signum() == first.0.signum() { from = middle } else { to = middle }
        }
        let z = gap(from).1;
        hits.extend((from > 0.0 && z > -DOUBT && z < height + DOUBT).then_some((from, z.min(height - z))));
    }
    if capped {
        for (level, radius) in [(0.0, radii[0]), (height, radii[1])] {
            let t = ((base + axis * level) - ray.origin).dot(axis) / ray.direction.dot(axis);
            let beside = (ray.origin + ray.direction * t - base - axis * level).length();
            hits.extend((t > 0.0 && beside < radius + DOUBT).then_some((t, radius - beside)));
        }
    }
    hits
}

/// Every hit of a shape: how far, and how clear of its borders (infinite where it has none).
fn hits(ray: &Ray, shape: &Shape) -> Vec<(f64, f64)> {
    match shape {
        Shape::Sphere { center, radius } => {
            let to_center = *center - ray.origin;
            let along = to_center.dot(ray.direction);
            let under_root = radius * radius - (to_center - ray.direction * along).length_squared();
            if under_root < 0.0 {
                return Vec::new();
            }
            let half = under_root.sqrt();
            [along - half, along + half].into_iter().filter(|t| *t > 0.0).map(|t| (t, half / radius)).collect()
        }
        Shape::Plane { p0, p1, p2 } => {
            let normal = (*p1 - *p0).cross(*p2 - *p0);
            let distance = (*p0 - ray.origin).dot(normal) / ray.direction.dot(normal);
            if distance > 0.0 { vec![(distance, f64::INFINITY)] } else { Vec::new() }
        }
        Shape::Facet { p0, p1, p2 } => facet(ray, [*p0, *p1, *p2]).into_iter().collect(),
        Shape::Cube { .. } | Shape::Parallelepiped { .. } => {
            let (origin, edges) = shape.frame().unwrap();
            box_facets(origin, edges).into_iter().filter_map(|corners| facet(ray, corners)).collect()
        }
        Shape::Cone { base, top, base_radius, top_radius, capped } => {
            cone_hits(ray, [*base, *top], [*base_radius, *top_radius], *capped)
        }
        Shape::Mesh(mesh) => {
            let place = |vertex: u32| mesh.placement.apply(mesh.geometry.positions[vertex as usize]);
            mesh.geometry.facets.iter().filter_map(|corners| facet(ray, corners.map(place))).collect()
        }
    }
}

/// Closer to a border than this, rounding decides.
const DOUBT: f64 = 1e-6;

proptest! {
    #[test]
    fn the_picked_object_is_the_nearest(
        shapes in prop::collection::vec((shape(), prop::bool::weighted(0.85)), 0..12),
        eye in point(8.0),
        look_at in point(2.0),
        pixels in prop::collection::vec((0.0..64.0_f64, 0.0..48.0_f64), 40),
    ) {
        let objects: Vec<Object> = shapes
            .into_iter()
            .enumerate()
            .map(|(number, (shape, visible))| Object { visible, ..Object::new(format!("{number}"), shape) })
            .collect();
        let scene = Scene { objects: objects.iter().cloned().collect(), ..Scene::default() };
        let world = World::compile(&scene);
        let view = View {
            name: "it".into(),
            width: 64,
            height: 48,
            eye,
            screen: ScreenSpec::LookAt { look_at, up: DVec3::new(0.1, 1.0, 0.2), fov: 60.0 },
            samples: 1,
            depth: None,
            steps: Steps::default(),
        };
        let Ok(camera) = Camera::new(&view) else { return Ok(()) };
        for (x, y) in pixels {
            let ray = camera.ray(x, y);
            let mut all: Vec<(f64, f64, &Object)> = objects
                .iter()
                .filter(|object| object.visible)
                .flat_map(|object| hits(&ray, &object.shape).into_iter().map(move |(t, inside)| (t, inside, object)))
                .collect();
            if all.iter().any(|(_, inside, _)| inside.abs() < DOUBT) {
                continue;
            }
            all.retain(|(_, inside, _)| *inside > 0.0);
            all.sort_by(|a, b| a.0.total_cmp(&b.0));
            if all.windows(2).any(|pair| pair[1].0 - pair[0].0 < DOUBT && pair[0].2.name != pair[1].2.name) {
                continue;
            }
            let picked = world.pick(&ray);
            match (picked, all.first()) {
                (None, None) => {}
                (Some(picked), Some((distance, _, object))) => {
                    prop_assert_eq!(&picked.object, &object.name);
                    prop_assert!((picked.distance - distance).abs() < 1e-6 * distance.max(1.0));
                    prop_assert!((picked.point - ray.at(*distance)).length() < 1e-6 * distance.max(1.0));
                    prop_assert!(picked.normal.dot(ray.direction) < 0.0 && (picked.normal.length() - 1.0).abs() < 1e-9);
                    // and the point that is picked projects to the pixel
                    let (px, py) = camera.project(picked.point).unwrap();
                    prop_assert!((px - x).abs() < 1e-3 && (py - y).abs() < 1e-3);
                }
                (picked, expected) => prop_assert!(false, "{:?} {:?}", picked, expected.map(|(t, _, o)| (t, &o.name))),
            }
        }
    }
}
