//! Arbitrary legal scenes and views, for the property tests of every crate that takes one.
//!
//! A test elsewhere includes this file with `#[path]`; it is no crate of its own because only tests want it.

#![allow(dead_code, reason = "each test binary uses the strategies that it needs")]

use glam::DVec3;
use lancer_scene::{
    Compose, Environment, Highlight, Material, MaterialRef, Mesh, MeshGeometry, Name, Object, Part, Placement,
    PointLight, Reflectance, Rgb, Scene, Screen, ScreenSpec, Shape, Stage, Steps, Surface, View,
};
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::collections::HashSet;
use std::sync::Arc;

/// What a scene may hold beyond what a document of XML can write down by itself.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Extent {
    /// Everything in the model.
    Whole,
    /// No mesh from a file.
    SelfContained,
}

/// Numbers in a range: friendly decimals, the ends, zero of both signs, and any.
pub(crate) fn number(low: f64, high: f64) -> BoxedStrategy<f64> {
    let decimal = (0..=1000_i32).prop_map(move |step| {
        let value: f64 = low.max(-10.0) + f64::from(step) / 100.0;
        value.min(high)
    });
    let mut ends = vec![low, high];
    ends.extend([0.0, -0.0, 1.0, 1e-300].into_iter().filter(|end| (low..=high).contains(end)));
    prop_oneof![4 => decimal, 1 => select(ends), 2 => low..=high].boxed()
}

fn point() -> impl Strategy<Value = DVec3> {
    [number(-1e9, 1e9), number(-1e9, 1e9), number(-1e9, 1e9)].prop_map(DVec3::from)
}

/// A point near the origin, so that figures made of several are seldom degenerate.
fn near() -> impl Strategy<Value = DVec3> {
    [-10.0..=10.0, -10.0..=10.0, -10.0..=10.0].prop_map(DVec3::from)
}

/// One number for all channels, three, or the bytes of a colour.
fn channels(low: f64, high: f64) -> impl Strategy<Value = Rgb> {
    prop_oneof![
        number(low, high).prop_map(Rgb::splat),
        [number(low, high), number(low, high), number(low, high)].prop_map(Rgb::from),
        any::<[u8; 3]>().prop_map(move |bytes| {
            Rgb::from(Rgb::from_bytes(bytes).to_array().map(|channel| channel.clamp(low, high)))
        }),
    ]
}

/// A legal name: letters, signs that XML must escape and blanks within; or one such as things without a name get.
pub(crate) fn name() -> impl Strategy<Value = String> {
    prop_oneof![4 => any_name(), 1 => "(sphere|light|cube|mesh|view) [0-9]"]
}

fn any_name() -> impl Strategy<Value = String> {
    let letter = || select(vec!['a', 'B', '7', 'é', '球', '<', '&', '"', '\'', '-', '🔺']);
    let inner = prop_oneof![3 => letter(), 1 => Just(' ')];
    (letter(), vec(inner, 0..5), letter()).prop_map(|(first, inner, last)| {
        let mut name = String::from(first);
        name.extend(inner);
        name.push(last);
        name
    })
}

/// Makes every name its own by a number behind the later ones.
fn distinct(names: &mut [&mut Name]) {
    let mut taken = HashSet::new();
    for name in names {
        let mut number = 2;
        let stem = Name::clone(name);
        while !taken.insert(Name::clone(name)) {
            **name = format!("{stem} {number}").into();
            number += 1;
        }
    }
}

pub(crate) fn world() -> impl Strategy<Value = Environment> {
    let any = (channels(0.0, 1.0), channels(0.0, 1.0), channels(1e-9, 1e9), 0..=64_u32, select(Compose::ALL.to_vec()))
        .prop_map(|(ambient, background, index, depth, compose)| Environment {
            ambient,
            background,
            index,
            depth,
            compose,
        });
    prop_oneof![3 => any, 1 => Just(Environment::default())]
}

pub(crate) fn surface() -> impl Strategy<Value = Surface> {
    let share = || channels(0.0, 1.0);
    let laws = (select(Reflectance::ALL.to_vec()), select(Highlight::ALL.to_vec()));
    let coefficients = (share(), share(), share(), share(), share());
    let any = (coefficients, channels(0.0, 1e4), channels(1e-9, 1e9), laws).prop_map(
        |((ka, kd, ks, kr, kt), shininess, index, (w, highlight))| Surface {
            ka,
            kd,
            ks,
            w,
            shininess,
            kr,
            kt,
            index,
            highlight,
        },
    );
    prop_oneof![3 => any, 1 => Just(Surface::default())]
}

pub(crate) fn material() -> impl Strategy<Value = Material> {
    (name(), surface()).prop_map(|(name, surface)| Material { name: name.into(), surface })
}

pub(crate) fn light() -> impl Strategy<Value = PointLight> {
    (name(), point(), channels(0.0, 1.0), any::<bool>()).prop_map(|(name, position, color, visible)| PointLight {
        name: name.into(),
        position,
        color,
        visible,
    })
}

/// A reference to one of the named materials, or to none of them.
pub(crate) fn material_ref(names: Vec<Name>) -> BoxedStrategy<MaterialRef> {
    let nameless =
        prop_oneof![Just(MaterialRef::Default), surface().prop_map(|surface| MaterialRef::Inline(Arc::new(surface)))];
    if names.is_empty() {
        return nameless.boxed();
    }
    prop_oneof![1 => nameless, 3 => select(names).prop_map(MaterialRef::Named)].boxed()
}

fn parts(facets: usize, names: Vec<Name>) -> impl Strategy<Value = Vec<Part>> {
    let runs = vec((0..3_u32, 1..4_u32, material_ref(names)), 0..3);
    runs.prop_map(move |runs| {
        let mut free_from = 0;
        let mut parts = Vec::new();
        for (gap, count, material) in runs {
            let first = free_from + gap;
            free_from = first + count;
            if free_from as usize <= facets {
                parts.push(Part { material, first, count });
            }
        }
        parts
    })
}

pub(crate) fn geometry(names: Vec<Name>) -> impl Strategy<Value = MeshGeometry> {
    let positions = prop_oneof![4 => vec(near(), 1..8), 1 => vec(point(), 3..40)];
    let facets = prop_oneof![4 => 0..10_usize, 1 => 10..40_usize];
    let corners = facets.prop_flat_map(|facets| vec(any::<[Index; 3]>(), facets));
    let arrays = (positions, corners, any::<bool>());
    arrays.prop_flat_map(move |(positions, corners, normals)| {
        let vertices = positions.len();
        let facets: Vec<[u32; 3]> =
            corners.into_iter().map(|facet| facet.map(|corner| corner.index(vertices) as u32)).collect();
        parts(facets.len(), names.clone()).prop_map(move |parts| MeshGeometry {
            normals: if normals { positions.iter().map(|at| at.normalize_or(DVec3::Y)).collect() } else { vec![] },
            positions: positions.clone(),
            facets: facets.clone(),
            parts,
        })
    })
}

pub(crate) fn placement() -> impl Strategy<Value = Placement> {
    let factor = || prop_oneof![number(1e-9, 1e9), number(-1e9, -1e-9)];
    let scale = prop_oneof![factor().prop_map(DVec3::splat), [factor(), factor(), factor()].prop_map(DVec3::from)];
    let any = (scale, point(), point()).prop_map(|(scale, rotation, position)| Placement { scale, rotation, position });
    prop_oneof![3 => any, 1 => Just(Placement::default())]
}

/// A legal shape; meshes take one of the given geometries.
pub(crate) fn shape(geometries: Vec<Arc<MeshGeometry>>, extent: Extent) -> impl Strategy<Value = Shape> {
    let sources = match extent {
        Extent::Whole => vec![None, Some(Arc::from("models/rabbit.obj"))],
        Extent::SelfContained => vec![None],
    };
    let mesh = (select(geometries), select(sources), placement(), any::<bool>())
        .prop_map(|(geometry, source, placement, smooth)| Shape::Mesh(Mesh { geometry, source, placement, smooth }));
    let length = || number(1e-9, 1e9);
    prop_oneof![
        (point(), length()).prop_map(|(center, radius)| Shape::Sphere { center, radius }),
        (near(), near(), near()).prop_map(|(p0, p1, p2)| Shape::Plane { p0, p1, p2 }),
        (near(), near(), near()).prop_map(|(p0, p1, p2)| Shape::Facet { p0, p1, p2 }),
        (point(), length(), prop_oneof![1 => Just(DVec3::ZERO), 3 => point()])
            .prop_map(|(center, edge, rotation)| Shape::Cube { center, edge, rotation }),
        (point(), [near(), near(), near()]).prop_map(|(origin, edges)| Shape::Parallelepiped { origin, edges }),
        (near(), near(), number(0.0, 1e9), length(), any::<bool>()).prop_map(
            |(base, top, base_radius, top_radius, capped)| Shape::Cone { base, top, base_radius, top_radius, capped }
        ),
        mesh,
    ]
    .prop_filter("a degenerate figure", |shape| shape.check().is_ok())
}

pub(crate) fn object(
    names: Vec<Name>,
    geometries: Vec<Arc<MeshGeometry>>,
    extent: Extent,
) -> impl Strategy<Value = Object> {
    (name(), material_ref(names), any::<bool>(), shape(geometries, extent))
        .prop_map(|(name, material, visible, shape)| Object { name: name.into(), material, visible, shape })
}

/// A legal scene.
pub(crate) fn scene(extent: Extent) -> impl Strategy<Value = Scene> {
    let title = prop_oneof![Just(String::new()), name(), "[a-zé<&\"\\t\\n\\r ]{0,12}"];
    (title, world(), vec(material(), 0..4), vec(light(), 0..4)).prop_flat_map(
        move |(name, world, mut materials, lights)| {
            distinct(&mut materials.iter_mut().map(|material| &mut material.name).collect::<Vec<_>>());
            let names: Vec<Name> = materials.iter().map(|material| material.name.clone()).collect();
            let geometries = vec(geometry(names.clone()).prop_map(Arc::new), 1..3);
            let objects =
                geometries.prop_flat_map(move |geometries| vec(object(names.clone(), geometries, extent), 0..7));
            objects.prop_map(move |mut objects| {
                let mut lights = lights.clone();
                let of_lights = lights.iter_mut().map(|light| &mut light.name);
                distinct(&mut of_lights.chain(objects.iter_mut().map(|object| &mut object.name)).collect::<Vec<_>>());
                Scene {
                    name: name.clone(),
                    world: world.clone(),
                    materials: materials.iter().cloned().collect(),
                    lights: lights.into_iter().collect(),
                    objects: objects.into_iter().collect(),
                }
            })
        },
    )
}

/// Upwards, as a view has it that does not say, or anywhere.
fn up() -> impl Strategy<Value = DVec3> {
    prop_oneof![1 => Just(DVec3::Y), 3 => near()]
}

/// A legal view.
pub(crate) fn view() -> impl Strategy<Value = View> {
    let screen = prop_oneof![
        [near(), near(), near()].prop_map(|[origin, u, v]| ScreenSpec::Frame(Screen { origin, u, v })),
        (near(), [0.1..=10.0, 0.1..=10.0], up()).prop_map(|(center, size, up)| ScreenSpec::Centered {
            center,
            size,
            up
        }),
        [near(), near(), near()].prop_map(|[origin, u, v]| ScreenSpec::Corners([
            origin + v,
            origin + u + v,
            origin + u,
            origin
        ])),
        (near(), up(), prop_oneof![1 => Just(45.0), 3 => number(1.0, 179.0)])
            .prop_map(|(look_at, up, fov)| ScreenSpec::LookAt { look_at, up, fov }),
    ];
    let steps =
        any::<[bool; 3]>().prop_map(|[shadows, reflection, transparency]| Steps { shadows, reflection, transparency });
    let pixels = || prop_oneof![1..=64_u32, 1..=65_535_u32, Just(640), Just(480)];
    let rest = (1..=64_u32, option::of(0..=64_u32), steps);
    (name(), pixels(), pixels(), near(), screen, rest)
        .prop_map(|(name, width, height, eye, screen, (samples, depth, steps))| View {
            name: name.into(),
            width,
            height,
            eye,
            screen,
            samples,
            depth,
            steps,
        })
        .prop_filter("a degenerate view", |view| view.check().is_ok())
}

/// Legal views with names of their own.
pub(crate) fn views() -> impl Strategy<Value = lancer_scene::Views> {
    vec(view(), 0..4).prop_map(|mut views| {
        distinct(&mut views.iter_mut().map(|view| &mut view.name).collect::<Vec<_>>());
        views.into_iter().collect()
    })
}

/// A scene and its views.
pub(crate) fn stage() -> impl Strategy<Value = Stage> {
    (scene(Extent::Whole), views()).prop_map(|(scene, views)| Stage { scene, views })
}
