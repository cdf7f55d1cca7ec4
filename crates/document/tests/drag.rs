//! Dragging: the grabbed point stays under the pointer, or on its axis as near to the pointer as it can be.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

#[path = "../../scene/tests/arbitrary/mod.rs"]
mod arbitrary;

use lancer_document::gizmo::{Constraint, Drag, moved, place_of, snapped, translated};
use lancer_document::{Axis, Item};
use lancer_scene::{DVec3, Mesh, MeshGeometry, Object, Placement, PointLight, ScreenSpec, Shape, Stage, Steps, View};
use lancer_trace::Camera;
use proptest::prelude::*;
use std::sync::Arc;

fn camera(eye: DVec3, look_at: DVec3) -> Camera {
    Camera::new(&View {
        name: "front".into(),
        width: 640,
        height: 480,
        eye,
        screen: ScreenSpec::LookAt { look_at, up: DVec3::Y, fov: 45.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    })
    .unwrap()
}

fn drag(grabbed: DVec3) -> Drag {
    let camera = camera(DVec3::new(3.0, 2.0, 5.0), DVec3::new(0.0, 0.5, 0.0));
    Drag { camera, start: camera.project(grabbed).unwrap(), grabbed }
}

#[test]
fn the_grabbed_point_stays_under_the_pointer() {
    let drag = drag(DVec3::new(0.2, 0.7, -0.3));
    let to = (drag.start.0 + 40.0, drag.start.1 - 25.0);
    let by = drag.translation(to, Constraint::ViewPlane).unwrap();
    let (x, y) = drag.camera.project(drag.grabbed + by).unwrap();
    assert!((x - to.0).abs() < 0.05 && (y - to.1).abs() < 0.05, "{x} {y}");
    // in the plane parallel to the screen
    let screen = drag.camera.screen();
    assert!(screen.u.cross(screen.v).normalize().dot(by).abs() < 1e-3, "{by}");
    assert_eq!(drag.translation(drag.start, Constraint::ViewPlane), Some(DVec3::ZERO));
}

#[test]
fn an_axis_is_held() {
    let drag = drag(DVec3::new(0.2, 0.7, -0.3));
    for axis in Axis::ALL {
        // a pointer that follows the axis in the picture drags the point along
        let there = drag.grabbed + axis.direction() * 0.8;
        let by = drag.translation(drag.camera.project(there).unwrap(), Constraint::Along(axis)).unwrap();
        assert!((drag.grabbed + by - there).length() < 1e-3, "{axis:?} {by}");
        // and beside the axis the others do not move at all
        let beside = drag.translation((drag.start.0 + 13.0, drag.start.1 + 90.0), Constraint::Along(axis)).unwrap();
        assert_eq!(beside - axis.direction() * beside.dot(axis.direction()), DVec3::ZERO, "{axis:?}");
    }
}

/// Seen end-on, up in the picture is away from the eye.
#[test]
fn an_axis_seen_end_on_moves_with_up_and_down() {
    let front = camera(DVec3::Z * 5.0, DVec3::ZERO);
    let drag = Drag { camera: front, start: (320.0, 240.0), grabbed: DVec3::ZERO };
    let away = drag.translation((320.0, 140.0), Constraint::Along(Axis::Z)).unwrap();
    let across = drag.translation((420.0, 240.0), Constraint::Along(Axis::X)).unwrap();
    assert!(away.z < 0.0 && away.x == 0.0 && away.y == 0.0);
    assert!((away.z.abs() - across.x).abs() < 1e-3, "as far as across the picture: {away} {across}");
    let behind = Drag { camera: camera(DVec3::NEG_Z * 5.0, DVec3::ZERO), ..drag };
    assert!(behind.translation((320.0, 140.0), Constraint::Along(Axis::Z)).unwrap().z > 0.0);
}

#[test]
fn what_is_not_before_the_eye_does_not_move() {
    let front = camera(DVec3::Z * 5.0, DVec3::ZERO);
    let behind = Drag { camera: front, start: (320.0, 240.0), grabbed: DVec3::Z * 9.0 };
    assert_eq!(behind.translation((300.0, 240.0), Constraint::ViewPlane), None);
    // above the horizon of the plane through a level axis
    let level = Drag { camera: front, start: (320.0, 300.0), grabbed: DVec3::new(0.0, -0.5, 0.0) };
    assert_eq!(level.translation((320.0, 200.0), Constraint::Along(Axis::Z)), None);
}

#[test]
fn snapping_brings_the_place_to_the_grid() {
    let anchor = DVec3::new(0.3, 0.7, 1.1);
    assert_eq!(anchor + snapped(DVec3::new(0.4, 0.0, 0.0), anchor, 0.5), DVec3::new(0.5, 0.7, 1.1));
    let by = snapped(DVec3::new(0.4, 0.1, -0.3), anchor, 0.5);
    assert!((anchor + by - DVec3::new(0.5, 1.0, 1.0)).length() < 1e-12);
    assert_eq!(snapped(DVec3::X, anchor, 0.0), DVec3::X);
    assert_eq!(snapped(DVec3::X, anchor, f64::NAN), DVec3::X);
}

/// Coordinates stay short: 0.3 and 0.12 give 0.42, not 0.42000000000000004.
#[test]
fn every_shape_is_translated() {
    let by = DVec3::new(0.12, 0.0, -1.0);
    let mesh = Mesh {
        geometry: Arc::new(MeshGeometry::default()),
        source: None,
        placement: Placement::default(),
        smooth: false,
    };
    let p = |x: f64| DVec3::new(x, 1.0 / 3.0, 2.0);
    let q = |x: f64| DVec3::new(x, 1.0 / 3.0, 1.0);
    let after = |shape: Shape| translated(&Object::new("it", shape), by).shape;
    assert_eq!(after(Shape::Sphere { center: p(0.3), radius: 1.0 }), Shape::Sphere { center: q(0.42), radius: 1.0 });
    let cube = |center| Shape::Cube { center, edge: 1.0, rotation: DVec3::X };
    assert_eq!(after(cube(p(0.3))), cube(q(0.42)));
    let edges = [DVec3::X, DVec3::Y, DVec3::Z];
    assert_eq!(
        after(Shape::Parallelepiped { origin: p(0.3), edges }),
        Shape::Parallelepiped { origin: q(0.42), edges }
    );
    let cone = |base, top| Shape::Cone { base, top, base_radius: 1.0, top_radius: 0.0, capped: false };
    assert_eq!(after(cone(p(0.3), p(0.4))), cone(q(0.42), q(0.52)));
    let facet = |f: &dyn Fn(f64) -> DVec3, x: [f64; 3]| Shape::Facet { p0: f(x[0]), p1: f(x[1]), p2: f(x[2]) };
    assert_eq!(after(facet(&p, [0.3, 0.4, 0.5])), facet(&q, [0.42, 0.52, 0.62]));
    let plane = |f: &dyn Fn(f64) -> DVec3, x: [f64; 3]| Shape::Plane { p0: f(x[0]), p1: f(x[1]), p2: f(x[2]) };
    assert_eq!(after(plane(&p, [0.3, 0.4, 0.5])), plane(&q, [0.42, 0.52, 0.62]));
    let Shape::Mesh(moved) = after(Shape::Mesh(mesh)) else { panic!("a mesh") };
    assert_eq!(moved.placement.position, by);
}

#[test]
fn several_things_move_as_one_step() {
    let mut stage = Stage::default();
    let ball = Object::new("ball", Shape::Sphere { center: DVec3::X, radius: 1.0 });
    stage.scene.objects = [ball].into_iter().collect();
    stage.scene.lights = [PointLight::new("lamp", DVec3::Y)].into_iter().collect();
    let items = [Item::World, Item::Object("ball".into()), Item::Light("lamp".into()), Item::Object("gone".into())];
    let (name, edit) = moved(&stage, &items, DVec3::Z).unwrap();
    assert_eq!(name.text(lancer_words::Lang::English), "Move 2 items");
    let (stage, _) = stage.apply(&edit).unwrap();
    assert_eq!(place_of(&stage, &items[1]), Some(DVec3::X + DVec3::Z));
    assert_eq!(place_of(&stage, &items[2]), Some(DVec3::Y + DVec3::Z));
    assert_eq!(place_of(&stage, &items[0]), None);
    assert_eq!(moved(&stage, [&Item::World], DVec3::X), None);
}

proptest! {
    /// Whatever the view and the pointer, a translation is finite and brings the point to the pointer.
    #[test]
    fn projection_and_drag_are_inverse(
        view in arbitrary::view(),
        start in (0.0..1.0_f64, 0.0..1.0_f64),
        to in (0.0..1.0_f64, 0.0..1.0_f64),
        depth in 0.1..50.0_f64,
    ) {
        let camera = Camera::new(&view).unwrap();
        let pixel = |(x, y): (f64, f64)| (x * f64::from(view.width), y * f64::from(view.height));
        let (start, to) = (pixel(start), pixel(to));
        let drag = Drag { camera, start, grabbed: camera.ray(start.0, start.1).at(depth) };
        if let Some(by) = drag.translation(to, Constraint::ViewPlane) {
            prop_assert!(by.is_finite());
            let (x, y) = camera.project(drag.grabbed + by).unwrap();
            // a translation is rounded to a hundredth of a pixel's width: how much that is in the picture depends on the
            // shape of the pixels and on how slanting they are seen
            let screen = camera.screen();
            let (w, h) = (screen.u / f64::from(view.width), screen.v / f64::from(view.height));
            let skewed = w.cross(h).length() / w.length().max(h.length()).powi(2);
            let normal = screen.u.cross(screen.v).normalize();
            let slant = 1.0 / camera.ray(to.0, to.1).direction.dot(normal).abs();
            let allowed = 0.05 * slant * (w.length() / h.length()).max(1.0) / skewed;
            prop_assert!((x - to.0).abs() < allowed && (y - to.1).abs() < allowed, "{} {} {:?} {}", x, y, to, allowed);
        }
        for axis in Axis::ALL {
            if let Some(by) = drag.translation(to, Constraint::Along(axis)) {
                prop_assert!(by.is_finite());
                prop_assert_eq!(by, axis.direction() * by.dot(axis.direction()));
            }
        }
    }
}
