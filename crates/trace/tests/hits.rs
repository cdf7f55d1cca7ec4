//! Where rays meet cubes, boxes and meshes: analytic distances from outside and from inside, through the whole tracer.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that fails says so by panicking")]

mod common;

use common::{black, object, open, pixel, scene, surface};
use lancer_scene::{DVec3, Environment, MaterialRef, Mesh, MeshGeometry, Object, Part, Placement, Rgb, Shape, Surface};
use lancer_trace::observe::Seen;
use std::sync::Arc;

/// What a ray from `eye` along `direction` meets of one object: distance, normal, whether it enters.
fn met(object: &Object, eye: [f64; 3], direction: [f64; 3]) -> Option<(f64, DVec3, bool)> {
    let (eye, direction) = (DVec3::from(eye), DVec3::from(direction).normalize());
    let tree = open(&scene(vec![object.clone()], Environment::default()), &pixel(eye, eye + direction));
    let node = &tree.samples[0].tree.nodes[0];
    match &node.seen {
        Seen::Background(_) => None,
        Seen::Surface(surface) => Some((surface.distance, surface.geometric_normal, surface.entering)),
    }
}

fn assert_met(object: &Object, eye: [f64; 3], direction: [f64; 3], due: Option<(f64, [f64; 3], bool)>) {
    let found = met(object, eye, direction);
    let near = match (found, due) {
        (None, None) => true,
        (Some((t, normal, entering)), Some((due_t, due_normal, due_entering))) => {
            (t - due_t).abs() < 1e-12 && (normal - DVec3::from(due_normal)).length() < 1e-12 && entering == due_entering
        }
        (Some(_), None) | (None, Some(_)) => false,
    };
    assert!(near, "{} from {eye:?} along {direction:?}: {found:?}, not {due:?}", object.name);
}

#[test]
fn a_cube_is_met_from_outside_and_inside() {
    let cube = |rotation: DVec3| object("cube", Shape::Cube { center: DVec3::ZERO, edge: 2.0, rotation }, black());
    let straight = cube(DVec3::ZERO);
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            let along = |length: f64, aside: [f64; 2]| {
                let mut point = [aside[0], aside[0], aside[0]];
                point[axis] = length * side;
                point[(axis + 1) % 3] = aside[1];
                point
            };
            let (towards, normal) = (along(-1.0, [0.0, 0.0]), along(1.0, [0.0, 0.0]));
            assert_met(&straight, along(5.0, [0.3, 0.4]), towards, Some((4.0, normal, true)));
            assert_met(&straight, along(0.25, [0.3, 0.4]), towards, Some((1.25, normal, false)));
            assert_met(&straight, along(-5.0, [0.3, 0.4]), towards, None);
            assert_met(&straight, along(5.0, [0.3, 1.01]), towards, None);
        }
    }
    // turned by 45° about y, its faces are x + z = ±√2 and x - z = ±√2
    let (turned, root) = (cube(DVec3::new(0.0, 45.0, 0.0)), 2.0_f64.sqrt());
    let half = 0.5_f64.sqrt();
    assert_met(&turned, [5.0, 0.1, 0.2], [-1.0, 0.0, 0.0], Some((5.0 - (root - 0.2), [half, 0.0, half], true)));
    assert_met(&turned, [0.0, 0.1, 0.2], [1.0, 0.0, 0.0], Some((root - 0.2, [-half, 0.0, -half], false)));
    assert_met(&turned, [5.0, 0.1, 1.42], [-1.0, 0.0, 0.0], None);
}

/// A skewed box between the planes x = y/2 and x = y/2 + 2, whichever way its edges are given.
#[test]
fn a_box_is_met_from_outside_and_inside() {
    let edges = [DVec3::X * 2.0, DVec3::new(1.0, 2.0, 0.0), DVec3::Z * 2.0];
    let normal = DVec3::new(2.0, -1.0, 0.0).normalize();
    for order in [[0, 1, 2], [1, 0, 2], [2, 1, 0]] {
        let shape = Shape::Parallelepiped { origin: DVec3::ZERO, edges: order.map(|edge| edges[edge]) };
        let skewed = object("box", shape, black());
        assert_met(&skewed, [-5.0, 1.0, 1.0], [1.0, 0.0, 0.0], Some((5.5, (-normal).to_array(), true)));
        assert_met(&skewed, [1.5, 1.0, 1.0], [1.0, 0.0, 0.0], Some((1.0, (-normal).to_array(), false)));
        assert_met(&skewed, [9.0, 1.0, 1.0], [-1.0, 0.0, 0.0], Some((6.5, normal.to_array(), true)));
        assert_met(&skewed, [1.5, 1.0, 1.0], [0.0, 1.0, 0.0], Some((1.0, [0.0, -1.0, 0.0], false)));
        assert_met(&skewed, [1.5, 1.0, 1.0], [0.0, 0.0, -1.0], Some((1.0, [0.0, 0.0, 1.0], false)));
        assert_met(&skewed, [0.2, 1.0, 9.0], [0.0, 0.0, -1.0], None);
    }
}

/// Of two facets of a mesh in one place the first is seen, from both sides.
#[test]
fn the_first_of_equal_facets_is_seen() {
    let own = |value: f64| MaterialRef::Inline(Arc::new(Surface { ka: Rgb::splat(value), ..black() }));
    let positions = vec![DVec3::new(-1.0, -1.0, 0.0), DVec3::new(1.0, -1.0, 0.0), DVec3::new(0.0, 1.0, 0.0)];
    let part = |first: u32, value: f64| Part { material: own(value), first, count: 1 };
    for facets in [vec![[0, 1, 2], [1, 2, 0]], vec![[2, 1, 0], [0, 1, 2]]] {
        let parts = vec![part(0, 0.25), part(1, 0.75)];
        let geometry =
            Arc::new(MeshGeometry { positions: positions.clone(), facets, parts, ..MeshGeometry::default() });
        let mesh = Shape::Mesh(Mesh { geometry, source: None, placement: Placement::default(), smooth: false });
        let scene =
            scene(vec![object("twice", mesh, black())], Environment { ambient: Rgb::WHITE, ..Environment::default() });
        for z in [4.0, -4.0] {
            let tree = open(&scene, &pixel(DVec3::Z * z, DVec3::ZERO));
            assert_eq!(surface(&tree.samples[0].tree.nodes[0]).facet, 0);
            assert_eq!(tree.color, Rgb::splat(0.25));
        }
    }
}
