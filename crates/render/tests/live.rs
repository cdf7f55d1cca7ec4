//! Live sessions: the same bytes as a still picture, restarts, cancellation, rest.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use lancer_render::live::{Job, Renderer, Session};
use lancer_render::{RenderOptions, Tracing, render_still};
use lancer_scene::{
    DVec3, Environment, List, MaterialRef, Object, PointLight, Rgb, Scene, ScreenSpec, Shape, Steps, Surface, View,
};
use lancer_trace::{Camera, Cancel, Settings, World};
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

fn scene(gray: f64) -> Scene {
    let surface = |surface: Surface| MaterialRef::Inline(Arc::new(surface));
    let sphere = |x: f64| Shape::Sphere { center: DVec3::new(x, 0.5, 0.0), radius: 0.5 };
    let floor = Shape::Plane { p0: DVec3::ZERO, p1: DVec3::Z, p2: DVec3::X };
    let glass = Surface { kt: Rgb::splat(0.9), index: Rgb::splat(1.5), ..Surface::default() };
    let mirror = Surface { kr: Rgb::splat(0.8), ..Surface::default() };
    Scene {
        world: Environment { background: Rgb::splat(gray), ..Environment::default() },
        objects: [
            Object { material: surface(glass), ..Object::new("glass", sphere(-0.6)) },
            Object { material: surface(mirror), ..Object::new("mirror", sphere(0.6)) },
            Object::new("floor", floor),
        ]
        .into_iter()
        .collect::<List<Object>>(),
        lights: [PointLight::new("lamp", DVec3::new(1.0, 3.0, 2.0))].into_iter().collect::<List<PointLight>>(),
        ..Scene::default()
    }
}

fn view(width: u32, height: u32) -> View {
    View {
        name: "front".into(),
        width,
        height,
        eye: DVec3::new(0.0, 1.0, 4.0),
        screen: ScreenSpec::LookAt { look_at: DVec3::new(0.0, 0.4, 0.0), up: DVec3::Y, fov: 50.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    }
}

fn job(scene: Scene, view: View) -> Job {
    Job { scene, view, max_rays: Settings::MAX_RAYS }
}

fn until(session: &mut Session, done: impl Fn(&Session) -> bool) {
    let begun = Instant::now();
    while !done(session) {
        assert!(begun.elapsed() < Duration::from_secs(60), "no end: {:?}", session.status());
        std::thread::sleep(Duration::from_millis(1));
        session.poll();
    }
}

fn still(scene: &Scene, view: &View) -> lancer_scene::Picture {
    let (options, cancel) = (RenderOptions::default(), Cancel::default());
    render_still(&World::compile(scene), view, &options, &cancel, |_, _| ()).unwrap().picture
}

#[test]
fn the_last_pass_is_the_still_picture() {
    for threads in [1, 3] {
        let mut renderer = Renderer::new(NonZeroUsize::new(threads), Tracing::default(), || ());
        let mut session = renderer.open();
        for (width, height) in [(97, 53), (5, 3), (64, 64)] {
            session.start(job(scene(0.3), view(width, height)));
            until(&mut session, Session::is_finished);
            assert_eq!(session.image().picture(), Some(still(&scene(0.3), &view(width, height))));
            assert_eq!(session.status().counts.primary, u64::from(width * height));
        }
    }
}

#[test]
fn a_priority_rectangle_changes_nothing_in_the_end() {
    let mut renderer = Renderer::new(NonZeroUsize::new(2), Tracing::default(), || ());
    let mut session = renderer.open();
    session.prioritise(Some(lancer_render::Region { x: 13, y: 20, width: 33, height: 9 }));
    session.start(job(scene(0.3), view(80, 60)));
    until(&mut session, Session::is_finished);
    assert_eq!(session.image().picture(), Some(still(&scene(0.3), &view(80, 60))));
}

#[test]
fn eight_sessions_all_finish_and_an_edit_restarts_them() {
    let mut renderer = Renderer::new(NonZeroUsize::new(2), Tracing::default(), || ());
    let mut sessions: Vec<Session> = (0..8).map(|_| renderer.open()).collect();
    sessions[3].activate();
    for gray in [0.1, 0.2, 0.6] {
        let scene = scene(gray);
        for (session, n) in sessions.iter_mut().zip(0..) {
            session.start(job(scene.clone(), view(60 + n, 40)));
        }
    }
    for (session, n) in sessions.iter_mut().zip(0..) {
        until(session, Session::is_finished);
        assert_eq!(session.image().picture(), Some(still(&scene(0.6), &view(60 + n, 40))));
    }
}

#[test]
fn the_old_picture_stays_until_it_is_replaced_and_says_so() {
    let mut renderer = Renderer::new(NonZeroUsize::new(1), Tracing::default(), || ());
    let mut session = renderer.open();
    session.start(job(scene(0.3), view(32, 24)));
    until(&mut session, Session::is_finished);
    let old = session.image().bytes().to_vec();
    session.pause(true);
    session.start(job(scene(0.9), view(32, 24)));
    assert_eq!(session.image().bytes(), old);
    assert!(session.image().is_stale() && !session.is_finished());
    session.pause(false);
    until(&mut session, Session::is_finished);
    assert!(!session.image().is_stale());
    assert_ne!(session.image().bytes(), old);
    assert!(session.status().first_complete.unwrap() <= session.status().elapsed);
}

/// Nothing is sent and nobody is woken once every picture is finished.
#[test]
fn finished_means_no_work() {
    let wakes = Arc::new(AtomicUsize::new(0));
    let counted = Arc::clone(&wakes);
    let mut renderer = Renderer::new(NonZeroUsize::new(2), Tracing::default(), move || {
        counted.fetch_add(1, Ordering::Relaxed);
    });
    let mut session = renderer.open();
    session.start(job(scene(0.3), view(64, 48)));
    until(&mut session, Session::is_finished);
    std::thread::sleep(Duration::from_millis(20));
    let before = wakes.load(Ordering::Relaxed);
    std::thread::sleep(Duration::from_millis(100));
    assert_eq!(wakes.load(Ordering::Relaxed), before);
    assert!(!session.poll());
}

#[test]
fn a_view_that_breaks_a_rule_is_refused() {
    let mut renderer = Renderer::new(NonZeroUsize::new(1), Tracing::default(), || ());
    let mut session = renderer.open();
    let mut broken = view(8, 8);
    broken.screen = ScreenSpec::LookAt { look_at: broken.eye, up: DVec3::Y, fov: 50.0 };
    session.start(job(scene(0.3), broken));
    until(&mut session, |session| session.status().refused.is_some());
    assert!(session.is_finished());
}

/// A pixel over its budget is painted in a colour that cannot be overlooked, and named.
#[test]
fn a_pixel_without_a_colour_is_named() {
    let mut renderer = Renderer::new(NonZeroUsize::new(2), Tracing::default(), || ());
    let mut session = renderer.open();
    session.start(Job { max_rays: 1, ..job(scene(0.3), view(32, 24)) });
    until(&mut session, Session::is_finished);
    let (x, y, _) = session.status().fault.unwrap();
    assert_eq!(session.image().bytes()[(y * 32 + x) as usize], [255, 0, 255]);
    let before = &session.image().bytes()[..(y * 32 + x) as usize];
    assert!(before.iter().all(|pixel| *pixel != [255, 0, 255]), "the first in row order");
}

/// The compiled scene comes with the picture, so that a window can pick in it without compiling it again.
#[test]
fn a_session_lends_its_world_for_picking() {
    let mut renderer = Renderer::new(None, Tracing::default(), || {});
    let mut session = renderer.open();
    assert!(session.world().is_none());
    session.start(job(scene(0.1), view(64, 48)));
    until(&mut session, Session::is_finished);
    let camera = Camera::new(&view(64, 48)).unwrap();
    let picked = session.world().unwrap().pick(&camera.ray(40.0, 26.0)).unwrap();
    assert_eq!(&*picked.object, "mirror");
    assert!((picked.normal.length() - 1.0).abs() < 1e-12 && picked.normal.z > 0.0, "{picked:?}");
}
