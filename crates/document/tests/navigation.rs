//! Moving the eye: laws that hold for every way to give a screen, and never an invalid view.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

#[path = "../../scene/tests/arbitrary/mod.rs"]
mod arbitrary;

use lancer_document::navigate::{Side, ball_around, dolly, frame, look_along, orbit, pan, vertical};
use lancer_document::{Item, focus};
use lancer_scene::{DVec3, Object, PointLight, Scene, Screen, ScreenSpec, Shape, Stage, Steps, View};
use lancer_trace::Camera;
use proptest::prelude::*;

const EYE: DVec3 = DVec3::new(3.0, 2.0, 5.0);
const TARGET: DVec3 = DVec3::new(0.0, 0.5, 0.0);

fn look_at(eye: DVec3, look_at: DVec3, up: DVec3) -> View {
    View {
        name: "front".into(),
        width: 640,
        height: 480,
        eye,
        screen: ScreenSpec::LookAt { look_at, up, fov: 45.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    }
}

/// The same picture with its screen given in each of the four ways.
fn four_ways() -> [View; 4] {
    let by_look_at = look_at(EYE, TARGET, DVec3::Y);
    let screen = by_look_at.resolved_screen().unwrap();
    let Screen { origin, u, v } = screen;
    let with = |screen| View { screen, ..by_look_at.clone() };
    let center = screen.point(0.5, 0.5);
    [
        by_look_at.clone(),
        with(ScreenSpec::Frame(screen)),
        with(ScreenSpec::Corners([origin + v, origin + v + u, origin + u, origin])),
        with(ScreenSpec::Centered { center, size: [u.length(), v.length()], up: DVec3::Y }),
    ]
}

fn near(a: DVec3, b: DVec3, tolerance: f64) -> bool {
    (a - b).length() <= tolerance
}

fn pixel(view: &View, point: DVec3) -> (f64, f64) {
    Camera::new(view).unwrap().project(point).unwrap()
}

/// Whether two views show the same picture.
fn same_picture(a: &View, b: &View) -> bool {
    [(0.0, 0.0), (640.0, 0.0), (0.0, 480.0), (320.0, 240.0)].into_iter().all(|(x, y)| {
        let (a, b) = (Camera::new(a).unwrap().ray(x, y), Camera::new(b).unwrap().ray(x, y));
        near(a.origin, b.origin, 1e-4) && near(a.direction, b.direction, 1e-5)
    })
}

#[test]
fn an_orbit_to_the_right_shows_the_left_side() {
    let front = look_at(DVec3::Z * 5.0, DVec3::ZERO, DVec3::Y);
    let turned = orbit(&front, DVec3::Y, DVec3::ZERO, 90.0, 0.0);
    // what was before the middle has gone to the right of it: the eye stands on the left
    assert!(near(turned.eye, DVec3::NEG_X * 5.0, 1e-4), "{turned:?}");
    assert!(pixel(&turned, DVec3::Z).0 > 400.0);
    let above = orbit(&front, DVec3::Y, DVec3::ZERO, 0.0, 30.0);
    assert!(near(above.eye, DVec3::new(0.0, 2.5, 5.0 * 0.75_f64.sqrt()), 1e-4), "{above:?}");
    assert_eq!(above.screen, front.screen, "up stays 0 1 0 and the target stays");
}

/// Also in a picture that is mirrored, upside down, or both, what is in front follows the pointer.
#[test]
fn what_is_in_front_follows_the_pointer_in_every_picture() {
    let upright = four_ways()[1].resolved_screen().unwrap();
    let Screen { origin, u, v } = upright;
    let flipped = [
        upright,
        Screen { origin: origin + u, u: -u, v },
        Screen { origin: origin + v, u, v: -v },
        Screen { origin: origin + u + v, u: -u, v: -v },
    ];
    for screen in flipped {
        let view = View { screen: ScreenSpec::Frame(screen), ..four_ways()[0].clone() };
        let before = TARGET + (EYE - TARGET).normalize() * 0.5;
        let (x0, y0) = pixel(&view, before);
        let (x1, y1) = pixel(&orbit(&view, DVec3::Y, TARGET, 5.0, 0.0), before);
        assert!(x1 > x0 + 5.0 && (y1 - y0).abs() < 5.0, "{screen:?}: {x0} {y0} {x1} {y1}");
        let (x1, y1) = pixel(&orbit(&view, DVec3::Y, TARGET, 0.0, 5.0), before);
        assert!(y1 > y0 + 5.0 && (x1 - x0).abs() < 5.0, "{screen:?}: {x0} {y0} {x1} {y1}");
    }
}

/// Every way to give a screen moves alike, and keeps its way.
#[test]
fn the_four_ways_of_a_screen_move_alike() {
    let pivot = TARGET;
    type Move<'a> = (&'a str, &'a dyn Fn(&View) -> View);
    let moves: [Move<'_>; 8] = [
        ("orbit", &|view| orbit(view, DVec3::Y, pivot, 33.0, -12.0)),
        ("over the pole", &|view| orbit(view, DVec3::Y, pivot, -70.0, 500.0)),
        ("pan", &|view| pan(view, pivot, 31.0, -17.0)),
        ("nearer", &|view| dolly(view, pivot, 0.4)),
        ("frame", &|view| frame(view, DVec3::new(1.0, 1.0, -2.0), 0.5)),
        ("front", &|view| look_along(view, DVec3::Y, pivot, Side::Front)),
        ("top", &|view| look_along(view, DVec3::Y, pivot, Side::Top)),
        ("right", &|view| look_along(view, DVec3::Y, pivot, Side::Right)),
    ];
    for (name, move_eye) in moves {
        let [first, rest @ ..] = four_ways().map(|view| {
            let moved = move_eye(&view);
            assert_eq!(moved.check(), Ok(()));
            assert_eq!(std::mem::discriminant(&moved.screen), std::mem::discriminant(&view.screen), "{name}");
            assert!(moved != view, "{name} moves");
            moved
        });
        for other in rest {
            assert!(same_picture(&first, &other), "{name}: {first:?} {other:?}");
        }
    }
}

#[test]
fn a_panned_point_follows_the_pointer() {
    for view in four_ways() {
        let point = DVec3::new(0.3, 0.2, 1.0);
        let before = pixel(&view, point);
        let after = pixel(&pan(&view, point, 50.0, -20.0), point);
        assert!((after.0 - before.0 - 50.0).abs() < 0.01 && (after.1 - before.1 + 20.0).abs() < 0.01, "{after:?}");
    }
}

#[test]
fn a_dolly_keeps_the_pivot_in_its_pixel() {
    for view in four_ways() {
        let point = DVec3::new(-0.4, 0.9, 0.3);
        let nearer = dolly(&view, point, 0.25);
        let distance = (nearer.eye - point).length() / (view.eye - point).length();
        assert!((distance - 0.25).abs() < 1e-4, "{distance}");
        let (before, after) = (pixel(&view, point), pixel(&nearer, point));
        assert!((after.0 - before.0).abs() < 0.05 && (after.1 - before.1).abs() < 0.05, "{before:?} {after:?}");
        assert_eq!(dolly(&view, point, 0.0), view);
        assert_eq!(dolly(&view, point, f64::NAN), view);
    }
}

/// A framed ball touches no edge of the picture and is not lost in it, whatever the picture's shape.
#[test]
fn a_framed_ball_fills_the_picture_with_a_margin() {
    let (center, radius) = (DVec3::new(4.0, -1.0, 2.0), 0.7);
    for view in four_ways() {
        for (width, height) in [(640, 480), (480, 640), (1000, 100)] {
            let view = View { width, height, ..view.clone() };
            let framed = frame(&view, center, radius);
            let camera = Camera::new(&framed).unwrap();
            let (x, y) = camera.project(center).unwrap();
            assert!((x - f64::from(width) / 2.0).abs() < 0.1 && (y - f64::from(height) / 2.0).abs() < 0.1);
            let misses = |x: f64, y: f64| {
                let ray = camera.ray(x, y);
                let along = (center - ray.origin).dot(ray.direction);
                (center - ray.at(along)).length() / radius
            };
            let edges = (0..=100).flat_map(|step| {
                let part = f64::from(step) / 100.0;
                let (w, h) = (f64::from(width), f64::from(height));
                [(part * w, 0.0), (part * w, h), (0.0, part * h), (w, part * h)]
            });
            let closest = edges.map(|(x, y)| misses(x, y)).fold(f64::INFINITY, f64::min);
            assert!((1.1..1.2).contains(&closest), "{width}x{height}: {closest}");
        }
    }
}

#[test]
fn each_side_shows_the_axes_as_drawings_do() {
    let point = DVec3::new(1.0, 2.0, 3.0);
    for view in four_ways() {
        let seen = |side: Side| {
            let side = look_along(&view, DVec3::Y, point, side);
            let (x, y) = pixel(&side, point);
            assert!((x - 320.0).abs() < 0.01 && (y - 240.0).abs() < 0.01, "the pivot comes to the middle");
            let camera = Camera::new(&side).unwrap();
            let dx = |to: DVec3| camera.project(point + to).unwrap().0 - x;
            let dy = |to: DVec3| y - camera.project(point + to).unwrap().1;
            let axis = |f: &dyn Fn(DVec3) -> f64| {
                let along = [DVec3::X, DVec3::Y, DVec3::Z].map(f);
                along.map(|value| if value.abs() < 0.5 { 0 } else { value.signum() as i32 })
            };
            (axis(&dx), axis(&dy))
        };
        assert_eq!(seen(Side::Front), ([1, 0, 0], [0, 1, 0]));
        assert_eq!(seen(Side::Back), ([-1, 0, 0], [0, 1, 0]));
        assert_eq!(seen(Side::Right), ([0, 0, -1], [0, 1, 0]));
        assert_eq!(seen(Side::Left), ([0, 0, 1], [0, 1, 0]));
        assert_eq!(seen(Side::Top), ([1, 0, 0], [0, 0, -1]));
        assert_eq!(seen(Side::Bottom), ([1, 0, 0], [0, 0, 1]));
    }
}

/// From a top view the eye comes down to the front, and `up` is 0 1 0 again.
#[test]
fn an_orbit_leaves_the_pole_upright() {
    let top = look_along(&four_ways()[0], DVec3::Y, TARGET, Side::Top);
    let ScreenSpec::LookAt { up, .. } = top.screen else { panic!("{top:?}") };
    assert_eq!(up, DVec3::NEG_Z);
    let down = orbit(&top, DVec3::Y, TARGET, 0.0, -40.0);
    let ScreenSpec::LookAt { up, .. } = down.screen else { panic!("{down:?}") };
    assert_eq!(up, DVec3::Y);
    assert!(down.eye.z > 1.0 && down.eye.x.abs() < 1e-4 && down.eye.y > TARGET.y, "{down:?}");
    // and back: it stops at the pole
    let back = orbit(&down, DVec3::Y, TARGET, 0.0, 400.0);
    assert!(same_picture(&top, &back), "{top:?} {back:?}");
}

/// Documents keep short numbers.
#[test]
fn a_moved_eye_has_short_coordinates() {
    let turned = orbit(&four_ways()[0], DVec3::Y, TARGET, 17.3, 3.1);
    for coordinate in turned.eye.to_array() {
        assert!(coordinate.to_string().len() <= 8, "{coordinate}");
    }
}

#[test]
fn a_scene_whose_views_have_z_up_turns_about_z() {
    let mut stage = Stage::default();
    assert_eq!(vertical(&stage), DVec3::Y);
    let z = look_at(DVec3::new(3.0, -4.0, 2.0), DVec3::ZERO, DVec3::Z);
    stage.views = [z.clone()].into_iter().collect();
    assert_eq!(vertical(&stage), DVec3::Z);
    let turned = orbit(&z, DVec3::Z, DVec3::ZERO, 25.0, 0.0);
    assert!((turned.eye.z - 2.0).abs() < 1e-4);
    let front = look_along(&z, DVec3::Z, DVec3::ZERO, Side::Front);
    assert!(front.eye.y < -5.0 && front.eye.z.abs() < 1e-4, "{front:?}");
    // a view straight down says nothing of what is up
    stage.views = [look_at(DVec3::Y, DVec3::ZERO, DVec3::NEG_Z)].into_iter().collect();
    assert_eq!(vertical(&stage), DVec3::Y);
}

/// A picture that leans goes on leaning while it is turned.
#[test]
fn a_leaning_picture_keeps_its_lean() {
    let leaning = look_at(DVec3::Z * 5.0, DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0));
    let turned = orbit(&leaning, DVec3::Y, DVec3::ZERO, 40.0, 0.0);
    let slope = |view: &View| {
        let ((x0, y0), (x1, y1)) = (pixel(view, DVec3::ZERO), pixel(view, DVec3::Y * 0.1));
        (y1 - y0) / (x1 - x0)
    };
    assert!((slope(&leaning) - slope(&turned)).abs() < 1e-3, "{} {}", slope(&leaning), slope(&turned));
}

#[test]
fn what_is_around_things() {
    let mut stage = Stage::default();
    stage.scene.objects = [
        Object::new("ball", Shape::Sphere { center: DVec3::X, radius: 2.0 }),
        Object::new("floor", Shape::Plane { p0: DVec3::ZERO, p1: DVec3::Z * 2.0, p2: DVec3::X * 2.0 }),
    ]
    .into_iter()
    .collect();
    stage.scene.lights = [PointLight::new("lamp", DVec3::Y * 3.0)].into_iter().collect();
    let item = |name: &str| Item::Object(name.into());
    assert_eq!(ball_around(&stage, [&item("ball")]), Some((DVec3::X, 12.0_f64.sqrt())));
    assert_eq!(ball_around(&stage, [&item("floor")]), Some((DVec3::new(1.0, 0.0, 1.0), 2.0_f64.sqrt())));
    assert_eq!(ball_around(&stage, [&Item::Light("lamp".into())]), Some((DVec3::Y * 3.0, 0.0)));
    assert_eq!(ball_around(&stage, [&Item::World, &item("nobody")]), None);
    // a lamp has no size: the eye comes near it, not into it
    let near_lamp = frame(&four_ways()[0], DVec3::Y * 3.0, 0.0);
    assert!((near_lamp.eye - DVec3::Y * 3.0).length() > 0.1);
}

#[test]
fn the_focus_of_a_view_is_what_it_looks_at() {
    let scene = Scene::default();
    assert!(near(focus(&four_ways()[0], &scene, None).point, TARGET, 1e-12));
}

fn move_of(kind: u8, pivot: DVec3, a: f64, b: f64) -> impl Fn(&View) -> View {
    move |view| match kind {
        0 => orbit(view, DVec3::Y, pivot, a, b),
        1 => orbit(view, DVec3::Z, pivot, a, b),
        2 => pan(view, pivot, a, b),
        3 => dolly(view, pivot, a / 10.0),
        4 => frame(view, pivot, b),
        number => look_along(view, DVec3::Y, pivot, Side::ALL[usize::from(number - 5) % 6]),
    }
}

proptest! {
    /// Whatever is done to whatever view, it stays legal and keeps its way of giving the screen.
    #[test]
    fn no_movement_makes_a_view_illegal(
        view in arbitrary::view(),
        moves in prop::collection::vec(
            (0..11_u8, [-20.0..20.0_f64, -20.0..20.0, -20.0..20.0],
             prop_oneof![-400.0..400.0_f64, Just(f64::NAN), Just(1e300)], prop_oneof![-400.0..400.0_f64, Just(0.0)]),
            0..12,
        ),
    ) {
        let mut moved = view.clone();
        for (kind, pivot, a, b) in moves {
            moved = move_of(kind, DVec3::from(pivot), a, b)(&moved);
            prop_assert_eq!(moved.check(), Ok(()), "{} {:?} {} {}", kind, pivot, a, b);
            prop_assert_eq!(std::mem::discriminant(&moved.screen), std::mem::discriminant(&view.screen));
            prop_assert_eq!((&moved.name, moved.width, moved.height), (&view.name, view.width, view.height));
        }
    }

    /// An orbit keeps the distance to its pivot and the pivot's pixel; there and back again is where it began.
    #[test]
    fn an_orbit_turns_around_its_pivot(right in -170.0..170.0_f64, down in -20.0..20.0_f64) {
        for view in four_ways() {
            let turned = orbit(&view, DVec3::Y, TARGET, right, down);
            prop_assert!(((turned.eye - TARGET).length() - (view.eye - TARGET).length()).abs() < 1e-3);
            let (before, after) = (pixel(&view, TARGET), pixel(&turned, TARGET));
            prop_assert!((after.0 - before.0).abs() < 0.01 && (after.1 - before.1).abs() < 0.01);
            let back = orbit(&turned, DVec3::Y, TARGET, -right, -down);
            prop_assert!(same_picture(&view, &back), "{:?} {:?}", view, back);
        }
    }
}
