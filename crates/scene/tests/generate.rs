//! The generated scenes: how much is in them, where it is, that meshes enclose what they should, and that they are the
//! same on every machine.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use lancer_scene::generate::Family;
use lancer_scene::{DVec3, Enclosure, Invalid, Mesh, Object, Scene, Shape, Weight, lint};
use std::sync::Arc;

fn scene(family: Family, size: u32) -> Scene {
    family.generate(size).unwrap().0
}

fn meshes(scene: &Scene) -> impl Iterator<Item = (&Object, &Mesh)> {
    scene.objects.iter().filter_map(|object| match &object.shape {
        Shape::Mesh(mesh) => Some((object.as_ref(), mesh)),
        Shape::Sphere { .. }
        | Shape::Plane { .. }
        | Shape::Facet { .. }
        | Shape::Cube { .. }
        | Shape::Parallelepiped { .. }
        | Shape::Cone { .. } => None,
    })
}

/// Spheres and facets of meshes.
fn counts(scene: &Scene) -> (usize, usize) {
    let spheres = scene.objects.iter().filter(|object| matches!(object.shape, Shape::Sphere { .. })).count();
    (spheres, meshes(scene).map(|(_, mesh)| mesh.geometry.facets.len()).sum())
}

/// The box around all that is bounded.
fn bounds(scene: &Scene) -> (DVec3, DVec3) {
    let boxes = scene.objects.iter().filter_map(|object| object.shape.bounds());
    boxes.reduce(|(low, high), (l, h)| (low.min(l), high.max(h))).unwrap()
}

#[test]
fn every_size_at_the_ends_and_the_usual_one_is_a_legal_scene_with_a_legal_view() {
    for family in Family::ALL {
        let least = *family.sizes().start();
        for size in [least, least + 1, family.usual_size()] {
            let Ok((scene, view)) = family.generate(size) else { continue };
            scene.check().unwrap_or_else(|broken| panic!("{family:?} {size}: {broken:?}"));
            view.check().unwrap();
            assert!(!scene.name.is_empty() && !scene.lights.is_empty());
        }
    }
}

#[test]
fn sizes_that_there_are_not_are_refused() {
    for family in Family::ALL {
        let (least, greatest) = (*family.sizes().start(), *family.sizes().end());
        assert!(family.sizes().contains(&family.usual_size()));
        let wrong = [least.checked_sub(1), Some(greatest + 1), Some(u32::MAX)];
        for size in wrong.into_iter().flatten() {
            let (min, max) = (f64::from(least), f64::from(greatest));
            let refused = Invalid::OutOfRange { field: "size", value: f64::from(size), min, max };
            assert_eq!(family.generate(size).unwrap_err(), refused, "{family:?}");
        }
    }
}

#[test]
fn there_is_as_much_as_the_size_says() {
    for (size, spheres) in [(0, 1), (1, 10), (2, 91), (3, 820), (4, 7381), (5, 66_430)] {
        assert_eq!(counts(&scene(Family::Sphereflake, size)), (spheres, 2));
    }
    for size in 1..=8 {
        assert_eq!(counts(&scene(Family::Tetrahedron, size)), (0, 4_usize.pow(size)));
        assert_eq!(counts(&scene(Family::Mountain, size)), (4, 2 * 4_usize.pow(size)));
    }
    for size in [1, 71, 100] {
        assert_eq!(counts(&scene(Family::Field, size)), (0, 2 * (size * size) as usize));
    }
    for size in [3, 10, 100] {
        assert_eq!(counts(&scene(Family::Knot, size)), (0, 20 * (size * size) as usize));
    }
    for size in [1, 2, 59] {
        assert_eq!(counts(&scene(Family::Pebble, size)), (0, 20 * (size * size) as usize));
    }
    assert_eq!(counts(&scene(Family::Course, 1)), (3, 0));
    assert_eq!(scene(Family::Nest, 7).objects.len(), 1 + 7 + 3);
    for size in [1, 2, 4] {
        let points = size as usize + 1;
        let lattice = scene(Family::Lattice, size);
        assert_eq!(counts(&lattice).0, points.pow(3));
        assert_eq!(lattice.objects.len(), points.pow(3) + 6 * size as usize * points.pow(2));
    }
    for (size, squares) in [(0, 6), (1, 72), (2, 1056), (3, 18_048)] {
        assert_eq!(counts(&scene(Family::Sponge, size)), (0, 2 * squares));
    }
}

/// The volume of the sponge is `8·(20/27)ⁿ`, by the divergence theorem over its facets.
#[test]
fn the_sponge_has_the_volume_of_the_sponge() {
    for size in 0..=3 {
        let sponge = scene(Family::Sponge, size);
        let (_, mesh) = meshes(&sponge).next().unwrap();
        let corner = |vertex: u32| mesh.geometry.positions[vertex as usize];
        let of = |&[a, b, c]: &[u32; 3]| corner(a).cross(corner(b)).dot(corner(c)) / 6.0;
        let volume: f64 = mesh.geometry.facets.iter().map(of).sum();
        let expected = 8.0 * (20.0_f64 / 27.0).powi(size as i32);
        assert!((volume - expected).abs() < 1e-5, "{size}: {volume} {expected}");
    }
}

/// The sizes that measurements speak of.
#[test]
fn the_sizes_of_the_measurements() {
    assert_eq!(2 * 708_u32.pow(2), 1_002_528);
    assert_eq!(2 * 1415_u32.pow(2), 4_004_450);
    assert_eq!(counts(&scene(Family::Knot, Family::Knot.usual_size())).1, 200_000);
    assert_eq!(counts(&scene(Family::Pebble, Family::Pebble.usual_size())).1, 69_620);
    assert_eq!(counts(&scene(Family::Sphereflake, 6)).0, 597_871);
}

#[test]
fn scenes_lie_where_their_views_look() {
    let near = |found: DVec3, expected: [f64; 3], slack: f64| {
        assert!((found - DVec3::from(expected)).abs().max_element() <= slack, "{found} {expected:?}");
    };
    let (low, high) = bounds(&scene(Family::Tetrahedron, 6));
    near(low, [-1.0; 3], 0.0);
    near(high, [1.0; 3], 0.0);
    // the knot: between 1 - 0.45 - 0.2 and 1 + 0.45 + 0.2 from its axis, 0.45 + 0.2 high
    let knot = scene(Family::Knot, 40);
    let (_, mesh) = meshes(&knot).next().unwrap();
    let distances = mesh.geometry.positions.iter().map(|at| at.truncate().length());
    let (least, greatest) = distances.fold((f64::INFINITY, 0.0_f64), |(l, g), d| (l.min(d), g.max(d)));
    assert!((0.3499..0.36).contains(&least) && (1.64..1.6501).contains(&greatest), "{least} {greatest}");
    let (low, high) = bounds(&knot);
    assert!(low.z > -0.6501 && low.z < -0.64 && high.z < 0.6501 && high.z > 0.64, "{low} {high}");
    let (low, high) = bounds(&scene(Family::Field, 100));
    assert_eq!((low.x, low.z, high.x, high.z), (-1.0, -1.0, 1.0, 1.0));
    assert!(low.y > -0.44 && high.y < 0.44 && high.y - low.y > 0.2, "{low} {high}");
    let (low, high) = bounds(&scene(Family::Pebble, 20));
    assert!(low.min_element() > -1.33 && high.max_element() < 1.33, "{low} {high}");
    assert!(low.max_element() < -0.7 && high.min_element() > 0.7, "{low} {high}");
}

#[test]
fn closed_bodies_are_closed_and_face_outwards_and_landscapes_are_sheets() {
    let solid = Enclosure::Volume { inverted: false };
    for (family, size, enclosure) in [
        (Family::Knot, 3, solid),
        (Family::Knot, 20, solid),
        (Family::Pebble, 1, solid),
        (Family::Pebble, 2, solid),
        (Family::Pebble, 31, solid),
        (Family::Sponge, 0, solid),
        (Family::Sponge, 1, solid),
        (Family::Sponge, 3, solid),
        (Family::Tetrahedron, 1, solid),
        (Family::Tetrahedron, 5, solid),
        (Family::Field, 20, Enclosure::Sheet),
        (Family::Mountain, 4, Enclosure::Sheet),
    ] {
        let scene = scene(family, size);
        for (object, mesh) in meshes(&scene) {
            assert_eq!(mesh.enclosure(), enclosure, "{family:?} {size}: {}", object.name);
        }
    }
}

/// What holds 32 bits only traces the same facets.
#[test]
fn vertices_have_32_bits() {
    let families = [Family::Tetrahedron, Family::Mountain, Family::Field, Family::Knot, Family::Pebble, Family::Sponge];
    for family in families {
        for (_, mesh) in meshes(&scene(family, 4)) {
            let coordinates = mesh.geometry.positions.iter().flat_map(|position| position.to_array());
            assert!(coordinates.into_iter().all(|value| f64::from(value as f32) == value), "{family:?}");
            assert!(mesh.geometry.facets.iter().all(|facet| facet[0] != facet[1] && facet[1] != facet[2]));
        }
    }
}

/// A finer field is the same surface: every point of the coarse one is a point of the fine one.
#[test]
fn a_finer_field_is_the_same_surface() {
    let positions = |size| {
        let scene = scene(Family::Field, size);
        let (_, mesh) = meshes(&scene).next().unwrap();
        mesh.geometry.positions.clone()
    };
    let (coarse, fine) = (positions(8), positions(32));
    for row in 0..=8 {
        for column in 0..=8 {
            assert_eq!(coarse[row * 9 + column], fine[4 * row * 33 + 4 * column]);
        }
    }
}

/// Nothing suspicious is in the scenes: shells do not touch, lamps are in the open, the depth suffices.
#[test]
fn lint_finds_nothing_to_warn_of() {
    for family in Family::ALL {
        for size in [*family.sizes().start(), 3] {
            let Ok((scene, view)) = family.generate(size) else { continue };
            let found = lint(&scene, &[Arc::new(view)]);
            let warnings: Vec<_> = found.iter().filter(|finding| finding.weight() == Weight::Warning).collect();
            assert!(warnings.is_empty(), "{family:?} {size}: {warnings:?}");
        }
    }
}

/// FNV-1a over the bits of all coordinates: a machine on which one differs does not compute what the others do.
fn checksum(scene: &Scene) -> u64 {
    let mut sum = 0xcbf2_9ce4_8422_2325_u64;
    let mut add = |value: f64| {
        value.to_bits().to_le_bytes().iter().for_each(|byte| {
            sum = (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        });
    };
    for object in &scene.objects {
        match &object.shape {
            Shape::Sphere { center, radius } => {
                center.to_array().into_iter().chain([*radius]).for_each(&mut add);
            }
            Shape::Mesh(mesh) => {
                mesh.geometry.positions.iter().flat_map(|position| position.to_array()).for_each(&mut add);
                mesh.geometry.facets.iter().flatten().for_each(|vertex| add(f64::from(*vertex)));
            }
            Shape::Cube { center, edge, rotation } => {
                center.to_array().into_iter().chain(rotation.to_array()).chain([*edge]).for_each(&mut add);
            }
            Shape::Cone { base, top, base_radius, top_radius, .. } => {
                base.to_array().into_iter().chain(top.to_array()).chain([*base_radius, *top_radius]).for_each(&mut add);
            }
            Shape::Plane { .. } | Shape::Facet { .. } | Shape::Parallelepiped { .. } => {}
        }
    }
    sum
}

#[test]
fn the_same_size_is_the_same_scene_on_every_machine() {
    let sums = [
        (Family::Course, 1, 0x4ac2_d9b3_867a_6639),
        (Family::Sphereflake, 3, 0x03bc_1d82_db69_5bcc),
        (Family::Tetrahedron, 4, 0xd0db_60ac_92b3_3a20),
        (Family::Mountain, 8, 0x0493_e259_f890_c93e),
        (Family::Field, 64, 0xd1f1_e40d_3f23_ecdd),
        (Family::Knot, 12, 0x777e_9380_c3ae_9907),
        (Family::Pebble, 12, 0xef52_a2bc_a0b1_a809),
        (Family::Nest, 12, 0x32c0_923c_033f_41b6),
        (Family::Lattice, 3, 0x2e36_cff7_9f03_1065),
        (Family::Sponge, 2, 0xc0f4_bfdb_e30f_f379),
    ];
    let found = sums.map(|(family, size, _)| {
        let (first, second) = (scene(family, size), scene(family, size));
        assert_eq!(first, second, "{family:?}");
        (family, size, checksum(&first))
    });
    assert_eq!(found, sums, "{found:#018x?}");
}
