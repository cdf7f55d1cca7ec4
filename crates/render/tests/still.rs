//! What must hold of every rendered picture: threads and regions change nothing, errors are the same for all threads.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use lancer_render::{PixelFault, Region, RenderError, RenderOptions, Still, Tracing, render_pixel, render_still};
use lancer_scene::{
    DVec3, Environment, MaterialRef, Object, PointLight, Rgb, Scene, ScreenSpec, Shape, Steps, Surface, View,
};
use lancer_trace::{Camera, Cancel, Settings, Simd, World};
use proptest::prelude::*;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::time::{Duration, Instant};

fn view(width: u32, height: u32) -> View {
    View {
        name: "front".into(),
        width,
        height,
        eye: DVec3::new(0.0, 1.0, 6.0),
        screen: ScreenSpec::LookAt { look_at: DVec3::ZERO, up: DVec3::Y, fov: 50.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    }
}

fn threads(count: usize) -> RenderOptions {
    RenderOptions { threads: NonZeroUsize::new(count), ..RenderOptions::default() }
}

fn render(scene: &Scene, view: &View, options: &RenderOptions) -> Result<Still, RenderError> {
    render_still(&World::compile(scene), view, options, &Cancel::default(), |_, _| ())
}

fn surface() -> impl Strategy<Value = Surface> {
    ((0.0..0.5, 0.0..1.0, 0.0..1.0), prop::option::of(0.1..0.9), prop::option::of((0.1..0.9, 1.0..2.0))).prop_map(
        |((ka, kd, ks), mirror, glass)| Surface {
            ka: Rgb::splat(ka),
            kd: Rgb::new(kd, 1.0 - kd, 0.5),
            ks: Rgb::splat(ks),
            kr: Rgb::splat(mirror.unwrap_or(0.0)),
            kt: Rgb::splat(glass.map_or(0.0, |(kt, _)| kt)),
            index: Rgb::splat(glass.map_or(1.0, |(_, index)| index)),
            ..Surface::default()
        },
    )
}

fn shape() -> impl Strategy<Value = Shape> {
    let point = || [-2.0..2.0, -2.0..2.0, -2.0..2.0].prop_map(DVec3::from);
    prop_oneof![
        (point(), 0.1..1.5).prop_map(|(center, radius)| Shape::Sphere { center, radius }),
        (point(), 0.1..2.0, 0.0..90.0).prop_map(|(center, edge, turn)| Shape::Cube {
            center,
            edge,
            rotation: DVec3::splat(turn),
        }),
        (-3.0..-1.0).prop_map(|y: f64| Shape::Plane {
            p0: DVec3::Y * y,
            p1: DVec3::Y * y + DVec3::Z,
            p2: DVec3::Y * y + DVec3::X,
        }),
    ]
}

fn scene() -> impl Strategy<Value = Scene> {
    (prop::collection::vec((shape(), surface()), 1..6), prop::collection::vec([-5.0..5.0, 1.0..5.0, 1.0..5.0], 1..3))
        .prop_map(|(objects, lamps)| Scene {
            world: Environment { depth: 3, background: Rgb::new(0.1, 0.2, 0.3), ..Environment::default() },
            lights: lamps
                .into_iter()
                .enumerate()
                .map(|(number, at)| PointLight::new(format!("lamp {number}"), DVec3::from(at)))
                .collect(),
            objects: objects
                .into_iter()
                .enumerate()
                .map(|(number, (shape, surface))| {
                    let mut object = Object::new(format!("object {number}"), shape);
                    object.material = MaterialRef::Inline(surface.into());
                    object
                })
                .collect(),
            ..Scene::default()
        })
}

/// Every way of following rays that this machine has.
fn tracings() -> impl Iterator<Item = Tracing> {
    let engines = Simd::ALL.into_iter().filter(|simd| simd.is_available()).map(Tracing::Engine);
    engines.chain([Tracing::Reference])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::default() })]

    #[test]
    fn any_number_of_threads_gives_the_same_bytes_and_counts(
        scene in scene(), count in 2..9_usize, width in 1..70_u32, height in 1..50_u32, samples in 1..3_u32,
    ) {
        let view = View { samples, ..view(width, height) };
        let one = render(&scene, &view, &threads(1)).unwrap();
        let many = render(&scene, &view, &threads(count)).unwrap();
        prop_assert_eq!(one.picture, many.picture);
        prop_assert_eq!(one.counts, many.counts);
        prop_assert_eq!(many.threads, count);
    }

    #[test]
    fn the_engine_gives_the_references_bytes_and_counts(scene in scene(), samples in 1..3_u32) {
        let view = View { samples, ..view(45, 31) };
        let still = |tracing| render(&scene, &view, &RenderOptions { tracing, ..threads(2) }).unwrap();
        let reference = still(Tracing::Reference);
        for tracing in tracings() {
            let still = still(tracing);
            prop_assert_eq!(&still.picture, &reference.picture, "{:?}", tracing);
            prop_assert_eq!(still.counts, reference.counts, "{:?}", tracing);
        }
    }

    #[test]
    fn adaptive_samples_are_taken_where_neighbours_differ(
        scene in scene(), samples in 2..4_u32, threshold in 0.0..0.3, count in 1..5_usize,
    ) {
        let view = |samples| View { samples, ..view(40, 30) };
        let options = RenderOptions { keep_linear: true, ..threads(count) };
        let once = render(&scene, &view(1), &options).unwrap();
        let fully = render(&scene, &view(samples), &options).unwrap();
        let adaptive = RenderOptions { adaptive: Some(threshold), ..options };
        let still = render(&scene, &view(samples), &adaptive).unwrap();
        let colors = once.picture.linear.as_ref().unwrap();
        let differs = |x: i32, y: i32| {
            (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (x + dx, y + dy))).any(|(i, j)| {
                (0..40).contains(&i) && (0..30).contains(&j) && (0..3).any(|channel| {
                    let at = |x: i32, y: i32| f64::from(colors[(y * 40 + x) as usize][channel]);
                    (at(x, y) - at(i, j)).abs() > threshold
                })
            })
        };
        let mut refined = 0;
        for y in 0..30 {
            for x in 0..40 {
                let source = if differs(x, y) { &fully } else { &once };
                refined += u64::from(differs(x, y));
                let (x, y) = (x as u32, y as u32);
                prop_assert_eq!(still.picture.pixel(x, y), source.picture.pixel(x, y), "{} {}", x, y);
            }
        }
        prop_assert_eq!(still.refined, Some(refined));
        prop_assert_eq!(still.counts.primary, 40 * 30 + refined * u64::from(samples * samples));
    }

    /// Also where the seam runs along an edge, and the neighbour beyond it decides.
    #[test]
    fn adaptive_regions_join_without_seams(scene in scene(), seam in 1..40_u32, threshold in 0.0..0.1) {
        let view = View { samples: 2, ..view(40, 30) };
        let options = RenderOptions { adaptive: Some(threshold), ..threads(2) };
        let part = |x, width| {
            let region = Some(Region { x, y: 0, width, height: 30 });
            render(&scene, &view, &RenderOptions { region, ..options.clone() }).unwrap().picture
        };
        let (whole, left, right) = (part(0, 40), part(0, seam), part(seam, 40 - seam));
        for y in 0..30 {
            for x in 0..40 {
                let joined = if x < seam { left.pixel(x, y) } else { right.pixel(x - seam, y) };
                prop_assert_eq!(joined, whole.pixel(x, y), "{} {}", x, y);
            }
        }
    }

    #[test]
    fn a_region_is_a_crop_of_the_whole(
        scene in scene(), (x, width) in (0..40_u32).prop_flat_map(|x| (Just(x), 1..=40 - x)),
        (y, height) in (0..30_u32).prop_flat_map(|y| (Just(y), 1..=30 - y)),
    ) {
        let whole = render(&scene, &view(40, 30), &threads(2)).unwrap().picture;
        let region = Region { x, y, width, height };
        let options = RenderOptions { region: Some(region), ..threads(2) };
        let part = render(&scene, &view(40, 30), &options).unwrap().picture;
        prop_assert_eq!((part.width, part.height), (width, height));
        for row in 0..height {
            for column in 0..width {
                prop_assert_eq!(part.pixel(column, row), whole.pixel(x + column, y + row));
            }
        }
    }
}

/// A corridor of glass panes and mirrors, in the lower right part of the picture only: its pixels cost more than the
/// budget, the others do not.
fn costly_corner() -> Scene {
    let pane = |number: i32| {
        let z = f64::from(number);
        let corner = DVec3::new(0.4, -4.0, z);
        let mut object = Object::new(
            format!("pane {number}"),
            Shape::Parallelepiped { origin: corner, edges: [DVec3::X * 4.0, DVec3::Y * 3.7, DVec3::Z * 0.3] },
        );
        let surface =
            Surface { kr: Rgb::splat(0.5), kt: Rgb::splat(0.5), index: Rgb::splat(1.1), ..Surface::default() };
        object.material = MaterialRef::Inline(surface.into());
        object
    };
    Scene {
        world: Environment { depth: 12, ..Environment::default() },
        objects: (-3..1).map(pane).collect(),
        ..Scene::default()
    }
}

#[test]
fn the_first_costly_pixel_in_row_order_is_named_whatever_the_threads() {
    let scene = costly_corner();
    let view = view(90, 60);
    let options = |count| RenderOptions { max_rays: Some(500), ..threads(count) };
    let expected = render(&scene, &view, &options(1)).unwrap_err();
    // the truth, pixel by pixel
    let first = (0..60)
        .flat_map(|y| (0..90).map(move |x| (x, y)))
        .find(|&(x, y)| {
            let region = Region { x, y, width: 1, height: 1 };
            render(&scene, &view, &RenderOptions { region: Some(region), ..options(1) }).is_err()
        })
        .unwrap();
    assert_eq!(
        expected,
        RenderError::Pixel { x: first.0, y: first.1, fault: PixelFault::Budget { limit: 500 } },
        "one thread"
    );
    assert!(first.0 % 16 != 0 && first.1 > 16, "the example should not be a trivial one: {first:?}");
    for tracing in tracings() {
        for count in [2, 3, 4, 8] {
            let options = RenderOptions { tracing, ..options(count) };
            assert_eq!(render(&scene, &view, &options).unwrap_err(), expected, "{count} threads, {tracing:?}");
            let adaptive = RenderOptions { adaptive: Some(0.1), ..options };
            let view = View { samples: 2, ..view.clone() };
            assert_eq!(render(&scene, &view, &adaptive).unwrap_err(), expected, "{count} threads, adaptive");
        }
    }
}

/// A region's picture reads the pixels next to it, but does not fail because of them.
#[test]
fn a_costly_pixel_beside_an_adaptive_region_is_taken_for_different() {
    let scene = costly_corner();
    let view = View { samples: 2, ..view(90, 60) };
    let cheap = |x, y| {
        let region = Some(Region { x, y, width: 1, height: 1 });
        render(&scene, &view, &RenderOptions { max_rays: Some(500), region, ..threads(1) }).is_ok()
    };
    let (x, y) = (1..90).flat_map(|x| (1..60).map(move |y| (x, y))).find(|&(x, y)| !cheap(x, y)).unwrap();
    assert!(cheap(x - 1, y), "the costly pixels begin at column {x}");
    let options = RenderOptions {
        max_rays: Some(500),
        adaptive: Some(1.0),
        region: Some(Region { x: x - 1, y, width: 1, height: 1 }),
        ..threads(1)
    };
    assert_eq!(render(&scene, &view, &options).unwrap().refined, Some(1), "although no colour differs by more than 1");
}

/// Pixels that cost more rays than are traced together at first.
#[test]
fn expensive_pixels_have_the_references_colour_and_rays() {
    let mut scene = costly_corner();
    scene.world.depth = 19;
    let options = |tracing| RenderOptions {
        tracing,
        max_rays: Some(u64::MAX),
        region: Some(Region { x: 65, y: 45, width: 2, height: 1 }),
        ..threads(2)
    };
    let still = |tracing| render(&scene, &view(90, 60), &options(tracing)).unwrap();
    let reference = still(Tracing::Reference);
    // more than a packet's pixels may, so each is traced alone at last
    assert!(reference.counts.total() > 2 << 17, "{:?}", reference.counts);
    for tracing in tracings() {
        let still = still(tracing);
        assert_eq!((still.picture, still.counts), (reference.picture.clone(), reference.counts), "{tracing:?}");
    }
}

/// The greatest depth, where a picture's pixels cost as many rays as they may: the stacks of the threads suffice.
#[test]
fn rays_go_down_to_the_greatest_depth() {
    let mut scene = costly_corner();
    scene.world.depth = 64;
    // without mirrors there is one ray a level
    let facing = |object: &Arc<Object>| {
        let surface = Surface { kr: Rgb::splat(1.0), ..Surface::default() };
        Object { material: MaterialRef::Inline(surface.into()), ..Object::clone(object) }
    };
    scene.objects = scene.objects.iter().map(facing).collect();
    let inside = View { eye: DVec3::new(2.0, -2.0, 0.5), ..view(24, 24) };
    let mut reflected = Vec::new();
    for tracing in tracings() {
        let still = render(&scene, &inside, &RenderOptions { tracing, ..threads(2) }).unwrap();
        reflected.push(still.counts.reflected);
    }
    reflected.dedup();
    assert_eq!(reflected.len(), 1, "{reflected:?}");
}

#[test]
fn a_pixel_by_itself_has_the_pictures_colour() {
    let (scene, view) = (costly_corner(), view(90, 60));
    let world = World::compile(&scene);
    let camera = Camera::new(&view).unwrap();
    for tracing in tracings() {
        let options = RenderOptions { tracing, ..threads(1) };
        let picture = render_still(&world, &view, &options, &Cancel::default(), |_, _| ()).unwrap().picture;
        for place in [(0, 0), (50, 40), (89, 59)] {
            let settings = Settings::of(&world, &view);
            let color = render_pixel(&world, &camera, settings, tracing, place, &Cancel::default()).unwrap();
            assert_eq!(Some(color.to_bytes()), picture.pixel(place.0, place.1));
        }
    }
}

#[test]
fn a_region_outside_the_picture_is_refused() {
    let region = Region { x: 35, y: 0, width: 6, height: 1 };
    let options = RenderOptions { region: Some(region), ..threads(1) };
    let refused = render(&Scene::default(), &view(40, 30), &options).unwrap_err();
    assert_eq!(refused, RenderError::Region { region, width: 40, height: 30 });
}

#[test]
fn a_broken_view_is_refused() {
    let mut broken = view(40, 30);
    broken.screen = ScreenSpec::LookAt { look_at: broken.eye, up: DVec3::Y, fov: 50.0 };
    assert!(matches!(render(&Scene::default(), &broken, &threads(1)), Err(RenderError::View(_))));
}

#[test]
fn progress_rises_to_the_number_of_pixels() {
    let world = World::compile(&Scene::default());
    let mut seen = Vec::new();
    render_still(&world, &view(50, 40), &threads(3), &Cancel::default(), |done, all| seen.push((done, all))).unwrap();
    assert!(seen.windows(2).all(|pair| pair[0].0 < pair[1].0));
    assert_eq!(seen.last(), Some(&(50 * 40, 50 * 40)));

    // the centres of the region and of the pixels around it, then the region again
    let options = RenderOptions {
        adaptive: Some(0.1),
        region: Some(Region { x: 0, y: 10, width: 50, height: 20 }),
        ..threads(3)
    };
    let view = View { samples: 2, ..view(50, 40) };
    seen.clear();
    render_still(&world, &view, &options, &Cancel::default(), |done, all| seen.push((done, all))).unwrap();
    assert!(seen.windows(2).all(|pair| pair[0].0 < pair[1].0));
    assert_eq!(seen.last(), Some(&(50 * 22 + 50 * 20, 50 * 22 + 50 * 20)));
}

#[test]
fn linear_colours_are_kept_where_asked_for() {
    let scene = Scene {
        world: Environment { background: Rgb::new(0.1, 0.5, 1.0), ..Environment::default() },
        ..Scene::default()
    };
    let options = RenderOptions { keep_linear: true, ..threads(2) };
    let picture = render(&scene, &view(20, 20), &options).unwrap().picture;
    assert_eq!(picture.linear, Some(vec![[0.1, 0.5, 1.0]; 400]));
    assert!(picture.bytes.iter().all(|&bytes| bytes == [26, 128, 255]));
    assert_eq!(render(&scene, &view(20, 20), &threads(2)).unwrap().picture.linear, None);
}

/// Cancelled in the middle of one endless pixel, on every thread.
#[test]
fn a_cancelled_picture_stops_at_once() {
    let mut scene = costly_corner();
    scene.world.depth = 64;
    let world = World::compile(&scene);
    for tracing in tracings() {
        let region = Region { x: 60, y: 30, width: 20, height: 30 };
        let options = RenderOptions { tracing, max_rays: Some(u64::MAX), region: Some(region), ..threads(2) };
        let cancelled_after = || {
            let cancel = Cancel::default();
            let (outcome, waited) = std::thread::scope(|scope| {
                let running = scope.spawn(|| {
                    let outcome = render_still(&world, &view(90, 60), &options, &cancel, |_, _| ());
                    (outcome, Instant::now())
                });
                std::thread::sleep(Duration::from_millis(100));
                assert!(!running.is_finished(), "the pixels should take for ever");
                let asked = Instant::now();
                cancel.cancel();
                let (outcome, ended) = running.join().unwrap();
                (outcome, ended - asked)
            });
            assert_eq!(outcome.unwrap_err(), RenderError::Cancelled);
            waited
        };
        // a busy machine makes one of them late; a tracer that does not listen, all
        let at_once = (0..5).any(|_| cancelled_after() < Duration::from_millis(50));
        assert!(at_once, "{tracing:?}");
    }
}

#[test]
fn a_picture_that_fits_into_no_memory_is_refused() {
    let huge = View { width: 65_535, height: 65_535, ..view(1, 1) };
    let options = RenderOptions { keep_linear: true, ..threads(1) };
    // 64 GB: refused where the system does not promise that much; elsewhere it starts, and is stopped
    let cancel = Cancel::default();
    cancel.cancel();
    let outcome = render_still(&World::compile(&Scene::default()), &huge, &options, &cancel, |_, _| ());
    assert!(matches!(outcome, Err(RenderError::Memory { .. } | RenderError::Cancelled)), "{outcome:?}");
}
