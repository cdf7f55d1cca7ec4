//! Random scenes and views for the property tests of the XML writer and patcher.

use lancer_scene::{
    Color, Compose, DVec3, Environment, Highlight, Material, MaterialRef, Mesh, MeshGeometry, Name, Object, Part,
    Placement, PointLight, Reflectance, Rgb, Scene, Screen, ScreenSpec, Shape, Steps, Surface, View, Views,
};
use proptest::prelude::*;
use std::collections::HashSet;
use std::sync::Arc;

/// A number within a range: a round one, or any double.
fn number(min: f64, max: f64) -> BoxedStrategy<f64> {
    let round = (0..=1000_i32).prop_map(move |part| {
        let value = min + (max - min) * f64::from(part) / 1000.0;
        let rounded = (value * 1000.0).round() / 1000.0;
        rounded.clamp(min, max)
    });
    prop_oneof![3 => round, 1 => min..=max].boxed()
}

pub(crate) fn coordinate() -> BoxedStrategy<f64> {
    prop_oneof![4 => number(-10.0, 10.0), 1 => number(-1e9, 1e9), 1 => Just(0.0), 1 => Just(-0.0), 1 => Just(1e-300)]
        .boxed()
}

pub(crate) fn point() -> impl Strategy<Value = DVec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from)
}

fn channels(min: f64, max: f64) -> BoxedStrategy<Rgb> {
    prop_oneof![
        number(min, max).prop_map(Rgb::splat),
        [number(min, max), number(min, max), number(min, max)].prop_map(Rgb::from),
        any::<[u8; 3]>().prop_map(Rgb::from_bytes).prop_filter("range", move |color| {
            color.to_array().into_iter().all(|value| (min..=max).contains(&value))
        }),
    ]
    .boxed()
}

pub(crate) fn color() -> BoxedStrategy<Color> {
    channels(0.0, 1.0).boxed()
}

/// Names of every alphabet, with characters that XML escapes, and some that look like automatic ones.
pub(crate) fn name() -> BoxedStrategy<Name> {
    prop_oneof![
        2 => "[a-z]{1,6}",
        1 => "[a-zé<>&\"' 漢😀.-]{1,12}",
        1 => "(sphere|light|cube|view|mesh) [0-9]",
    ]
    .prop_map(|name| Name::from(name.trim()))
    .prop_filter("empty", |name| !name.is_empty())
    .boxed()
}

pub(crate) fn surface() -> BoxedStrategy<Surface> {
    let law = prop::sample::select(&Reflectance::ALL[..]);
    let highlight = prop::sample::select(&Highlight::ALL[..]);
    let numbers = (color(), color(), color(), channels(0.0, 10_000.0), color(), color(), channels(1e-9, 3.0));
    let any = (numbers, law, highlight).prop_map(|((ka, kd, ks, shininess, kr, kt, index), w, highlight)| Surface {
        ka,
        kd,
        ks,
        w,
        shininess,
        kr,
        kt,
        index,
        highlight,
    });
    prop_oneof![any, Just(Surface::default())].boxed()
}

pub(crate) fn environment() -> BoxedStrategy<Environment> {
    let compose = prop::sample::select(&Compose::ALL[..]);
    let any = (color(), color(), channels(1e-9, 3.0), 0..=64_u32, compose).prop_map(
        |(ambient, background, index, depth, compose)| Environment { ambient, background, index, depth, compose },
    );
    prop_oneof![any, Just(Environment::default())].boxed()
}

fn geometry() -> BoxedStrategy<MeshGeometry> {
    let material = prop::collection::vec(material_ref(), 0..3);
    (prop::collection::vec(point(), 3..40), any::<bool>(), prop::collection::vec(any::<[u8; 3]>(), 1..40), material)
        .prop_map(|(positions, has_normals, facets, materials)| {
            let vertices = positions.len() as u32;
            let facets: Vec<[u32; 3]> = facets.iter().map(|facet| facet.map(|v| u32::from(v) % vertices)).collect();
            let normals = if has_normals { positions.iter().rev().copied().collect() } else { Vec::new() };
            let parts = materials.into_iter().enumerate().map(|(number, material)| Part {
                material,
                first: number as u32,
                count: 1,
            });
            let parts = parts.filter(|part| (part.first as usize) < facets.len()).collect();
            MeshGeometry { positions, normals, facets, parts }
        })
        .boxed()
}

/// A reference to one of the first materials, whatever they will be called: its place as a name.
fn material_ref() -> BoxedStrategy<MaterialRef> {
    prop_oneof![
        Just(MaterialRef::Default),
        (0..4_u8).prop_map(|place| MaterialRef::Named(place.to_string().into())),
        surface().prop_map(|surface| MaterialRef::Inline(Arc::new(surface))),
    ]
    .boxed()
}

pub(crate) fn shape() -> BoxedStrategy<Shape> {
    let length = || number(1e-9, 100.0);
    let factor = || number(-10.0, 10.0).prop_map(|factor| if factor.abs() < 0.01 { 1.0 } else { factor });
    let scale = prop_oneof![factor().prop_map(DVec3::splat), [factor(), factor(), factor()].prop_map(DVec3::from)];
    let placement = prop_oneof![
        Just(Placement::default()),
        (scale, point(), point()).prop_map(|(scale, rotation, position)| Placement { scale, rotation, position })
    ];
    let mesh = (geometry(), placement, any::<bool>()).prop_map(|(geometry, placement, smooth)| {
        Shape::Mesh(Mesh { geometry: Arc::new(geometry), source: None, placement, smooth })
    });
    prop_oneof![
        (point(), length()).prop_map(|(center, radius)| Shape::Sphere { center, radius }),
        (point(), point(), point()).prop_map(|(p0, p1, p2)| Shape::Plane { p0, p1, p2 }),
        (point(), point(), point()).prop_map(|(p0, p1, p2)| Shape::Facet { p0, p1, p2 }),
        (point(), length(), prop_oneof![Just(DVec3::ZERO), point()]).prop_map(|(center, edge, rotation)| Shape::Cube {
            center,
            edge,
            rotation
        }),
        (point(), [point(), point(), point()]).prop_map(|(origin, edges)| Shape::Parallelepiped { origin, edges }),
        (point(), point(), number(0.0, 100.0), length(), any::<bool>()).prop_map(
            |(base, top, base_radius, top_radius, capped)| Shape::Cone { base, top, base_radius, top_radius, capped }
        ),
        mesh,
    ]
    .prop_filter("a rule", |shape| shape.check().is_ok())
    .boxed()
}

pub(crate) fn object() -> BoxedStrategy<Object> {
    (name(), material_ref(), any::<bool>(), shape())
        .prop_map(|(name, material, visible, shape)| Object { name, material, visible, shape })
        .boxed()
}

pub(crate) fn light() -> BoxedStrategy<PointLight> {
    (name(), point(), prop_oneof![color(), Just(Rgb::WHITE)], any::<bool>())
        .prop_map(|(name, position, color, visible)| PointLight { name, position, color, visible })
        .boxed()
}

pub(crate) fn material() -> BoxedStrategy<Material> {
    (name(), surface()).prop_map(|(name, surface)| Material { name, surface }).boxed()
}

/// A legal scene.
pub(crate) fn scene() -> BoxedStrategy<Scene> {
    let parts = (
        "[a-zé<&\"\\t\\n\\r ]{0,12}",
        environment(),
        prop::collection::vec(material(), 0..5),
        prop::collection::vec(light(), 0..4),
        prop::collection::vec(object(), 0..7),
    );
    parts
        .prop_map(|(name, world, materials, lights, objects)| {
            let materials = distinct(materials, |material| &material.name);
            let mut taken = HashSet::new();
            let lights: Vec<_> = lights.into_iter().filter(|light| taken.insert(light.name.clone())).collect();
            let objects = objects.into_iter().filter(|object| taken.insert(object.name.clone()));
            let objects = objects.map(|object| with_materials(object, &materials)).collect();
            Scene {
                name,
                world,
                materials: materials.into_iter().collect(),
                lights: lights.into_iter().collect(),
                objects,
            }
        })
        .boxed()
}

fn distinct<T>(items: Vec<T>, name: impl Fn(&T) -> &Name) -> Vec<T> {
    let mut taken = HashSet::new();
    items.into_iter().filter(|item| taken.insert(name(item).clone())).collect()
}

/// The object with references that the materials satisfy.
pub(crate) fn with_materials(mut object: Object, materials: &[Material]) -> Object {
    let satisfy = |reference: &mut MaterialRef| {
        if let Some(place) = reference.name() {
            let place = place.parse::<usize>().unwrap_or_default();
            *reference = match materials.get(place) {
                Some(material) => MaterialRef::Named(material.name.clone()),
                None => MaterialRef::Default,
            };
        }
    };
    satisfy(&mut object.material);
    if let Shape::Mesh(mesh) = &mut object.shape {
        Arc::make_mut(&mut mesh.geometry).parts.iter_mut().for_each(|part| satisfy(&mut part.material));
    }
    object
}

pub(crate) fn view() -> BoxedStrategy<View> {
    let screen = prop_oneof![
        (point(), point(), point()).prop_map(|(origin, u, v)| ScreenSpec::Frame(Screen { origin, u, v })),
        (point(), [number(1e-9, 10.0), number(1e-9, 10.0)], prop_oneof![Just(DVec3::Y), point()])
            .prop_map(|(center, size, up)| ScreenSpec::Centered { center, size, up }),
        (point(), point(), point()).prop_map(|(a, u, v)| ScreenSpec::Corners([a, a + u, a + u + v, a + v])),
        (point(), prop_oneof![Just(DVec3::Y), point()], prop_oneof![Just(45.0), number(1.0, 179.0)])
            .prop_map(|(look_at, up, fov)| ScreenSpec::LookAt { look_at, up, fov }),
    ];
    let steps =
        any::<[bool; 3]>().prop_map(|[shadows, reflection, transparency]| Steps { shadows, reflection, transparency });
    let sizes = prop_oneof![Just((640, 480)), (1..=65_535_u32, 1..=65_535_u32)];
    (name(), sizes, point(), screen, 1..=64_u32, prop::option::of(0..=64_u32), steps)
        .prop_map(|(name, (width, height), eye, screen, samples, depth, steps)| View {
            name,
            width,
            height,
            eye,
            screen,
            samples,
            depth,
            steps,
        })
        .prop_filter("a rule", |view| view.check().is_ok())
        .boxed()
}

pub(crate) fn views() -> BoxedStrategy<Views> {
    prop::collection::vec(view(), 0..4)
        .prop_map(|views| distinct(views, |view| &view.name).into_iter().collect())
        .boxed()
}
