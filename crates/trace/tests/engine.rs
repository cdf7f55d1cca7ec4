//! The engine is the reference: on random scenes of everything there is, wherever they lie, whatever it computes with.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use lancer_scene::{
    Compose, DVec3, Environment, Highlight, List, MaterialRef, Mesh, MeshGeometry, Object, Placement, PointLight,
    Reflectance, Rgb, Scene, ScreenSpec, Shape, Steps, Surface, View,
};
use lancer_trace::{Camera, Cancel, Engine, RayCounts, Settings, Simd, TraceError, Tracer, World};
use proptest::prelude::*;
use std::sync::Arc;

fn point(reach: f64) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-reach..reach).prop_map(DVec3::from)
}

/// Also the very coordinates at which things touch.
fn lattice(reach: i32) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-2 * reach..=2 * reach).prop_map(|twice| DVec3::from(twice.map(f64::from)) * 0.5)
}

fn place() -> impl Strategy<Value = DVec3> {
    prop_oneof![3 => point(3.0), 1 => lattice(2)]
}

fn color() -> impl Strategy<Value = Rgb> {
    prop_oneof![
        2 => prop::array::uniform3(0.0..1.0_f64).prop_map(|[r, g, b]| Rgb::new(r, g, b)),
        1 => Just(Rgb::BLACK),
        1 => (0.0..1.0_f64).prop_map(Rgb::splat),
    ]
}

/// A surface; without a highlight nothing is left in which engine and reference may differ.
fn surface(highlights: bool) -> impl Strategy<Value = Surface> {
    let index = prop_oneof![
        2 => (0.5..2.5_f64).prop_map(Rgb::splat),
        1 => prop::array::uniform3(1.0..2.0_f64).prop_map(|[r, g, b]| Rgb::new(r, g, b)),
        1 => (1.0..2.0_f64, 1.0..2.0_f64).prop_map(|(n, other)| Rgb::new(n, other, n)),
    ];
    let law = prop_oneof![Just(Reflectance::Constant), Just(Reflectance::Schlick), Just(Reflectance::Grazing)];
    let shininess = prop_oneof![
        1 => Just(Rgb::splat(0.0)),
        2 => (0.0..300.0_f64).prop_map(Rgb::splat),
        1 => prop::array::uniform3(0.0..10_000.0_f64).prop_map(|[r, g, b]| Rgb::new(r, g, b)),
    ];
    let highlight = prop_oneof![Just(Highlight::Phong), Just(Highlight::Blinn)];
    ((color(), color(), color()), (color(), color()), (index, law, shininess, highlight)).prop_map(
        move |((ka, kd, ks), (kr, kt), (index, w, shininess, highlight))| Surface {
            ka,
            kd,
            ks: if highlights { ks } else { Rgb::BLACK },
            // `schlick` and `grazing` would bring a highlight back
            w: if highlights { w } else { Reflectance::Constant },
            kr,
            kt,
            index,
            shininess,
            highlight,
        },
    )
}

/// A tetrahedron, closed or with a facet missing, or a strip of facets, somewhere and of some size.
fn mesh() -> impl Strategy<Value = Shape> {
    let tetrahedron = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].to_vec();
    let solid =
        prop_oneof![Just(4_usize), Just(3)].prop_map(move |count| (corners.clone(), tetrahedron[..count].to_vec()));
    let strip = prop::collection::vec(point(1.0), 3..40).prop_map(|positions| {
        let facets = (0..positions.len() as u32 - 2).map(|first| [first, first + 1, first + 2]).collect();
        (positions, facets)
    });
    let scale = prop_oneof![Just(DVec3::ONE), point(2.0).prop_map(|scale| scale + DVec3::splat(0.1).copysign(scale))];
    let rotation = prop_oneof![Just(DVec3::ZERO), point(180.0), Just(DVec3::new(0.0, 90.0, 0.0))];
    (prop_oneof![solid, strip], scale, rotation, place(), any::<bool>()).prop_map(
        |((positions, facets), scale, rotation, position, smooth)| {
            let geometry = MeshGeometry { positions, facets, ..MeshGeometry::default() };
            let placement = Placement { scale, rotation, position };
            Shape::Mesh(Mesh { geometry: Arc::new(geometry), source: None, placement, smooth })
        },
    )
}

fn cone_radius() -> impl Strategy<Value = f64> {
    prop_oneof![2 => 0.05..2.0_f64, 1 => Just(1.0), 1 => Just(0.0)]
}

fn shape() -> impl Strategy<Value = Shape> {
    let turn = || prop_oneof![Just(DVec3::ZERO), point(180.0)];
    let radius = || prop_oneof![0.05..2.0_f64, Just(1.0)];
    prop_oneof![
        3 => (place(), radius()).prop_map(|(center, radius)| Shape::Sphere { center, radius }),
        1 => (place(), place(), place()).prop_map(|(p0, p1, p2)| Shape::Plane { p0, p1, p2 }),
        1 => (place(), place(), place()).prop_map(|(p0, p1, p2)| Shape::Facet { p0, p1, p2 }),
        2 => (place(), radius(), turn()).prop_map(|(center, edge, rotation)| Shape::Cube { center, edge, rotation }),
        1 => (place(), [place(), place(), place()]).prop_map(|(origin, edges)| Shape::Parallelepiped { origin, edges }),
        2 => (place(), place(), cone_radius(), cone_radius(), any::<bool>())
            .prop_map(|(base, top, base_radius, top_radius, capped)| Shape::Cone { base, top, base_radius, top_radius, capped }),
        2 => mesh(),
    ]
}

/// A scene, the point that it lies around, and an eye: in the open, on a lattice point, on a sphere, a plane or a cone.
#[derive(Clone, Debug)]
struct Stage {
    scene: Scene,
    center: DVec3,
    eye: DVec3,
}

fn stage() -> impl Strategy<Value = Stage> {
    let highlights = prop_oneof![3 => Just(true), 1 => Just(false)];
    let objects = highlights.prop_flat_map(|highlights| prop::collection::vec((shape(), surface(highlights)), 1..9));
    let compose = prop_oneof![Just(Compose::Screen), Just(Compose::ScreenEach), Just(Compose::Add)];
    let world =
        (color(), color(), 0.5..2.0_f64, 0..5_u32, compose).prop_map(|(ambient, background, index, depth, compose)| {
            Environment { ambient, background, index: Rgb::splat(index), depth, compose }
        });
    let lamps = prop::collection::vec((prop_oneof![place(), point(20.0)], color()), 0..4);
    let offset = prop_oneof![2 => Just(DVec3::ZERO), 1 => point(1e4), 1 => Just(DVec3::new(1e4, 1e4, -1e4))];
    let eye = (prop_oneof![3 => point(8.0), 1 => lattice(3)], prop::option::of(point(1.0)));
    (objects, world, lamps, offset, eye).prop_map(|(objects, world, lamps, center, (eye, on))| {
        let mut eye = eye + center;
        let mut scene = Scene { world, ..Scene::default() };
        let mut list = Vec::new();
        for (number, (shape, surface)) in objects.into_iter().enumerate() {
            let shape = moved(shape, center);
            if let (Some(on), 0) = (on, number) {
                eye = on_surface(&shape, on).unwrap_or(eye);
            }
            let material = MaterialRef::Inline(Arc::new(surface));
            list.push(Object { material, ..Object::new(format!("object {number}"), shape) });
        }
        let mut lights = Vec::new();
        for (number, (at, color)) in lamps.into_iter().enumerate() {
            lights.push(PointLight { color, ..PointLight::new(format!("lamp {number}"), at + center) });
        }
        scene.objects = list.into_iter().collect::<List<Object>>();
        scene.lights = lights.into_iter().collect::<List<PointLight>>();
        Stage { scene, center, eye }
    })
}

fn moved(mut shape: Shape, by: DVec3) -> Shape {
    match &mut shape {
        Shape::Sphere { center, .. } | Shape::Cube { center, .. } => *center += by,
        Shape::Plane { p0, p1, p2 } | Shape::Facet { p0, p1, p2 } => [p0, p1, p2].into_iter().for_each(|p| *p += by),
        Shape::Parallelepiped { origin, .. } => *origin += by,
        Shape::Cone { base, top, .. } => [base, top].into_iter().for_each(|p| *p += by),
        Shape::Mesh(mesh) => mesh.placement.position += by,
    }
    shape
}

/// A point of a shape, as near as f64 comes.
fn on_surface(shape: &Shape, towards: DVec3) -> Option<DVec3> {
    match shape {
        Shape::Sphere { center, radius } => Some(*center + towards.try_normalize()? * *radius),
        Shape::Plane { p0, p1, p2 } | Shape::Facet { p0, p1, p2 } => {
            let (a, b) = (towards.x.abs() * 0.5, towards.y.abs() * 0.5);
            Some(*p0 + (*p1 - *p0) * a + (*p2 - *p0) * b)
        }
        Shape::Cone { base, top, base_radius, .. } => {
            let axis = (*top - *base).try_normalize()?;
            // on the base's circle or, in a capped cone, on the disc
            Some(
                *base + (towards - axis * towards.dot(axis)).try_normalize()? * *base_radius * towards.x.abs().min(1.0),
            )
        }
        Shape::Cube { .. } | Shape::Parallelepiped { .. } | Shape::Mesh(_) => None,
    }
}

/// What a tracer says of pixels.
type Told = (Vec<Result<Rgb, TraceError>>, RayCounts);

const WIDTH: u32 = 14;
const HEIGHT: u32 = 10;

fn pixels() -> Vec<(u32, u32)> {
    (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))).collect()
}

struct Picture {
    world: World,
    camera: Camera,
    settings: Settings,
}

impl Picture {
    /// `None` for what is no legal scene or view.
    fn new(Stage { scene, center, eye }: &Stage, look_at: DVec3, samples: u32, max_rays: u64) -> Option<Picture> {
        scene.check().ok()?;
        let view = View {
            name: "front".into(),
            width: WIDTH,
            height: HEIGHT,
            eye: *eye,
            screen: ScreenSpec::LookAt { look_at: *center + look_at, up: DVec3::new(0.1, 1.0, 0.05), fov: 70.0 },
            samples,
            depth: None,
            steps: Steps::default(),
        };
        let camera = Camera::new(&view).ok()?;
        let world = World::compile(scene);
        let settings = Settings { max_rays, ..Settings::of(&world, &view) };
        Some(Picture { world, camera, settings })
    }

    fn reference(&self) -> Told {
        let tracer = Tracer::new(&self.world, &self.camera, self.settings, &Cancel::default());
        let mut counts = RayCounts::default();
        (pixels().into_iter().map(|(x, y)| tracer.pixel(x, y, &mut counts)).collect(), counts)
    }

    fn engine(&self, simd: Simd, pixels: &[(u32, u32)]) -> Told {
        let engine = Engine::new(&self.world, &self.camera, self.settings, &Cancel::default(), simd);
        let (mut colors, mut counts) = (Vec::new(), RayCounts::default());
        engine.pixels(pixels, &mut colors, &mut counts);
        (colors, counts)
    }
}

fn available() -> impl Iterator<Item = Simd> {
    Simd::ALL.into_iter().filter(|simd| simd.is_available())
}

fn bits(color: &Result<Rgb, TraceError>) -> Result<[u64; 3], TraceError> {
    // the two zeros are one colour
    color.map(|color| color.to_array().map(|channel| (channel + 0.0).to_bits()))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, max_global_rejects: 20_000, ..ProptestConfig::default() })]

    #[test]
    fn the_engine_is_the_reference(
        stage in stage(), look_at in point(1.5), samples in 1..3_u32,
        max_rays in prop_oneof![4 => Just(100_000_u64), 1 => 1..40_u64],
    ) {
        let Some(picture) = Picture::new(&stage, look_at, samples, max_rays) else {
            return Err(TestCaseError::reject("no legal scene or view"));
        };
        let plain = stage.scene.objects.iter().all(|object| match &object.material {
            MaterialRef::Inline(surface) => surface.ks == Rgb::BLACK && surface.w == Reflectance::Constant,
            MaterialRef::Named(_) | MaterialRef::Default => true,
        });
        let (due, counts) = picture.reference();
        let complete = due.iter().all(Result::is_ok);
        let mut portable = None;
        for simd in available() {
            let (colors, engine_counts) = picture.engine(simd, &pixels());
            for ((color, due), place) in colors.iter().zip(&due).zip(pixels()) {
                match (color, due) {
                    (Ok(color), Ok(due)) => {
                        prop_assert_eq!(color.to_bytes(), due.to_bytes(), "{:?} {:?}: {:?} {:?}", simd, place, color, due);
                        for channel in 0..3 {
                            prop_assert!((color[channel] - due[channel]).abs() < 1e-9, "{:?} {:?}", simd, place);
                        }
                    }
                    (color, due) => prop_assert_eq!(color, due, "{:?} {:?}", simd, place),
                }
                if plain {
                    prop_assert_eq!(bits(color), bits(due), "{:?} {:?}", simd, place);
                }
            }
            // a pixel over its budget ends the reference at once, but not the rays of the pixels beside it
            if complete {
                prop_assert_eq!(engine_counts, counts, "{:?}", simd);
            }
            let told: Vec<_> = colors.iter().map(bits).collect();
            prop_assert_eq!(&told, portable.get_or_insert_with(|| told.clone()), "{:?}", simd);
        }
    }

    /// Alone, backwards, or among all others: a pixel's bits are its own.
    #[test]
    fn companions_do_not_matter(stage in stage(), look_at in point(1.5), samples in 1..3_u32) {
        let Some(picture) = Picture::new(&stage, look_at, samples, 100_000) else {
            return Err(TestCaseError::reject("no legal scene or view"));
        };
        for simd in available() {
            let (together, counts) = picture.engine(simd, &pixels());
            let backwards: Vec<_> = pixels().into_iter().rev().collect();
            let (mut turned, turned_counts) = picture.engine(simd, &backwards);
            turned.reverse();
            prop_assert_eq!(turned.iter().map(bits).collect::<Vec<_>>(), together.iter().map(bits).collect::<Vec<_>>());
            prop_assert_eq!(turned_counts, counts);
            for place in [0, 77, 139] {
                let (alone, _) = picture.engine(simd, &pixels()[place..=place]);
                prop_assert_eq!(bits(&alone[0]), bits(&together[place]));
            }
        }
    }
}

/// Without highlights every backend gives the reference's very bits and counts.
fn to_the_bit(picture: &Picture) -> Result<(), TestCaseError> {
    let (due, counts) = picture.reference();
    for simd in available() {
        let (colors, engine_counts) = picture.engine(simd, &pixels());
        for ((color, due), place) in colors.iter().zip(&due).zip(pixels()) {
            prop_assert_eq!(bits(color), bits(due), "{:?} {:?}", simd, place);
        }
        prop_assert_eq!(engine_counts, counts, "{:?}", simd);
    }
    Ok(())
}

/// A mesh of many facets, whose rays pass a hierarchy of several levels: a mirror of hills with lamps above it, some near
/// its plane, all of it of some size, turned, and anywhere.
fn hills() -> impl Strategy<Value = Stage> {
    let hills = (3..28_u32, 0.0..0.3_f64, -3.0..2.0_f64);
    let place = (point(180.0), prop_oneof![3 => Just(DVec3::ZERO), 1 => point(30.0)]);
    let lamps = prop::collection::vec((point(2.0), prop_oneof![0.02..0.3_f64, 0.5..3.0_f64]), 0..3);
    (hills, place, point(1.5), lamps, any::<bool>()).prop_map(
        |((n, height, size), (rotation, center), eye, lamps, smooth)| {
            let (size, along) = (10_f64.powf(size), |i: u32| f64::from(i) / f64::from(n) * 2.0 - 1.0);
            let height_at =
                |x: f64, z: f64| height * ((x * 5.0).sin() * (z * 4.0).cos() + 0.4 * (x * 17.0 + z * 13.0).sin());
            let positions = (0..=n).flat_map(|j| (0..=n).map(move |i| (along(i), along(j))));
            let positions = positions.map(|(x, z)| DVec3::new(x, height_at(x, z), z) * size).collect();
            let corner = |i: u32, j: u32| j * (n + 1) + i;
            let facets = (0..n * n).map(|cell| (cell % n, cell / n)).flat_map(|(i, j)| {
                let [a, b, c, d] = [corner(i, j), corner(i, j + 1), corner(i + 1, j), corner(i + 1, j + 1)];
                [[a, b, c], [c, b, d]]
            });
            let geometry = MeshGeometry { positions, facets: facets.collect(), ..MeshGeometry::default() };
            let placement = Placement { rotation, position: center * size, ..Placement::default() };
            let mesh = Mesh { geometry: Arc::new(geometry), source: None, placement: placement.clone(), smooth };
            let mirror =
                Surface { kr: Rgb::splat(0.6), ks: Rgb::BLACK, w: Reflectance::Constant, ..Surface::default() };
            let object =
                Object { material: MaterialRef::Inline(Arc::new(mirror)), ..Object::new("hills", Shape::Mesh(mesh)) };
            let there = |at: DVec3| placement.linear() * (at * size) + placement.position;
            let lights = lamps.iter().enumerate().map(|(number, (at, above))| {
                PointLight::new(format!("lamp {number}"), there(DVec3::new(at.x, *above, at.z)))
            });
            let scene = Scene {
                world: Environment { depth: 3, ..Environment::default() },
                objects: [object].into_iter().collect(),
                lights: lights.collect(),
                ..Scene::default()
            };
            Stage { scene, center: placement.position, eye: there(eye + DVec3::Y * 1.6) }
        },
    )
}

/// A crowd of bodies, so many that the hierarchy over them has several levels: balls, cones and tetrahedra, mirrors and
/// glass, with lamps among and above them.
fn crowd() -> impl Strategy<Value = Stage> {
    let body = (point(2.0), 0.02..0.35_f64, 0..5_u32, point(1.0));
    let lamps = prop::collection::vec(point(4.0), 1..3);
    (prop::collection::vec(body, 80..240), lamps, point(3.0), -2.0..2.0_f64).prop_map(|(bodies, lamps, eye, size)| {
        let size = 10_f64.powf(size);
        let surface = |kr: f64, kt: f64| {
            let index = Rgb::splat(1.0 + kt / 2.0);
            Surface { kr: Rgb::splat(kr), kt: Rgb::splat(kt), index, ..Surface::default() }
        };
        let surfaces = [surface(0.5, 0.0), surface(0.1, 0.8)].map(Arc::new);
        let objects = bodies.into_iter().enumerate().map(|(number, (at, radius, kind, towards))| {
            let (center, radius) = (at * size, radius * size);
            let shape = match kind {
                0..=2 => Shape::Sphere { center, radius },
                3 => {
                    let top = center + towards * size;
                    Shape::Cone { base: center, top, base_radius: radius, top_radius: radius / 2.0, capped: true }
                }
                _ => Shape::Cube { center, edge: radius, rotation: towards * 90.0 },
            };
            let material = MaterialRef::Inline(surfaces[number % 2].clone());
            Object { material, ..Object::new(format!("body {number}"), shape) }
        });
        let lights = lamps.iter().enumerate().map(|(number, at)| PointLight::new(format!("lamp {number}"), *at * size));
        let scene = Scene {
            world: Environment { depth: 4, ..Environment::default() },
            objects: objects.collect(),
            lights: lights.collect(),
            ..Scene::default()
        };
        Stage { scene, center: DVec3::ZERO, eye: eye * size }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, max_global_rejects: 20_000, ..ProptestConfig::default() })]

    #[test]
    fn many_bodies_are_the_references(stage in crowd()) {
        let Some(picture) = Picture::new(&stage, DVec3::ZERO, 1, 100_000) else {
            return Err(TestCaseError::reject("no legal scene or view"));
        };
        to_the_bit(&picture)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, max_global_rejects: 20_000, ..ProptestConfig::default() })]

    #[test]
    fn many_facets_are_the_references(stage in hills()) {
        let Some(picture) = Picture::new(&stage, DVec3::ZERO, 1, 100_000) else {
            return Err(TestCaseError::reject("no legal scene or view"));
        };
        to_the_bit(&picture)?;
    }
}

#[test]
fn a_raised_flag_leaves_no_colour() {
    let ball = Object::new("ball", Shape::Sphere { center: DVec3::ZERO, radius: 1.0 });
    let scene = Scene { objects: [ball].into_iter().collect(), ..Scene::default() };
    let stage = Stage { scene, center: DVec3::ZERO, eye: DVec3::Z * 5.0 };
    let picture = Picture::new(&stage, DVec3::ZERO, 16, 100_000).unwrap();
    let cancel = Cancel::default();
    cancel.cancel();
    for simd in available() {
        let engine = Engine::new(&picture.world, &picture.camera, picture.settings, &cancel, simd);
        let (mut colors, mut counts) = (Vec::new(), RayCounts::default());
        engine.pixels(&pixels(), &mut colors, &mut counts);
        assert!(colors.contains(&Err(TraceError::Cancelled)));
    }
}
