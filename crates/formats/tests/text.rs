//! The text display, compared with whole expected texts in `tests/text/`; `UPDATE_REFS=1` rewrites them.

#![allow(clippy::unwrap_used, reason = "the helpers of tests may panic")]

#[path = "../../scene/tests/arbitrary/mod.rs"]
mod arbitrary;

use arbitrary::stage;
use lancer_formats::text::{describe, describe_views};
use lancer_scene::{
    Compose, DVec3, Environment, Highlight, Material, MaterialRef, Mesh, MeshGeometry, Object, Part, Placement,
    PointLight, Reflectance, Rgb, Scene, Screen, ScreenSpec, Shape, Steps, Surface, View, Views,
};
use lancer_words::Lang;
use proptest::prelude::*;
use std::path::Path;
use std::sync::Arc;

fn check(name: &str, shown: impl Fn(Lang) -> String) {
    for lang in Lang::ALL {
        let shown = shown(lang);
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/text").join(format!("{name}.{}.txt", lang.code()));
        if std::env::var_os("UPDATE_REFS").is_some() {
            std::fs::write(&path, &shown).unwrap();
        }
        let expected = std::fs::read_to_string(&path).unwrap();
        assert_eq!(shown, expected, "{}", path.display());
        for line in shown.lines() {
            assert!(line.chars().count() <= 100, "longer than 100 columns: {line}");
            assert_eq!(line, line.trim_end(), "blanks at the end");
        }
    }
}

fn tetrahedron() -> MeshGeometry {
    MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Z, DVec3::Y],
        facets: vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]],
        ..MeshGeometry::default()
    }
}

/// One of everything that a scene can hold.
fn everything() -> Scene {
    let paint = |name: &str, surface| Material { name: name.into(), surface };
    let glass = Surface {
        ka: Rgb::splat(0.05),
        kd: Rgb::from_bytes([51, 52, 53]),
        ks: Rgb::splat(0.2),
        w: Reflectance::Schlick,
        shininess: Rgb::new(125.0, 60.5, 8.0),
        kr: Rgb::splat(0.15),
        kt: Rgb::splat(0.95),
        index: Rgb::new(1.5, 1.51, 1.53),
        highlight: Highlight::Blinn,
    };
    let own = Arc::new(Surface { w: Reflectance::Grazing, kr: Rgb::splat(1.0 / 3.0), ..Surface::default() });
    let red = || MaterialRef::Named("red".into());
    let inline = || MaterialRef::Inline(Arc::clone(&own));
    let parts = vec![Part { material: red(), first: 0, count: 1 }, Part { material: inline(), first: 2, count: 2 }];
    let pyramid = Mesh {
        geometry: Arc::new(MeshGeometry { parts, ..tetrahedron() }),
        source: None,
        placement: Placement { scale: DVec3::new(1.0, -2.0, 1.0), ..Placement::default() },
        smooth: false,
    };
    let mut open = tetrahedron();
    open.facets.pop();
    let rabbit = Mesh {
        geometry: Arc::new(MeshGeometry { normals: vec![DVec3::Y; 4], ..open }),
        source: Some("models/rabbit.obj".into()),
        placement: Placement {
            scale: DVec3::splat(10.0),
            rotation: DVec3::new(0.0, 180.0, 0.0),
            position: DVec3::new(0.0, 0.0, 2.0),
        },
        smooth: true,
    };
    let object = |name: &str, material, shape| Object { material, ..Object::new(name, shape) };
    let (p0, p1, p2) = (DVec3::ZERO, DVec3::Z, DVec3::X);
    Scene {
        name: "One of each".into(),
        world: Environment {
            ambient: Rgb::new(0.12, 0.12, 0.16),
            index: Rgb::splat(1.000_3),
            compose: Compose::ScreenEach,
            ..Environment::default()
        },
        materials: [paint("red", Surface { kd: Rgb::splat(0.7), ..Surface::default() }), paint("glass", glass)]
            .into_iter()
            .collect(),
        lights: [
            PointLight { color: Rgb::new(1.0, 1.0, 0.9), ..PointLight::new("lamp", DVec3::new(-2.0, 3.25, 20.0)) },
            PointLight { visible: false, ..PointLight::new("filling lamp", DVec3::new(2.0, 3.0, 2e9 / 3.0)) },
        ]
        .into_iter()
        .collect(),
        objects: [
            object("ball", MaterialRef::Named("glass".into()), Shape::Sphere { center: DVec3::ZERO, radius: 0.5 }),
            object("floor", red(), Shape::Plane { p0, p1, p2 }),
            object(
                "die",
                MaterialRef::Default,
                Shape::Cube { center: DVec3::new(1.0, 0.25, -1.0), edge: 0.5, rotation: DVec3::new(0.0, 30.0, 0.0) },
            ),
            object(
                "slab",
                inline(),
                Shape::Parallelepiped {
                    origin: DVec3::new(2.0, 0.0, 0.0),
                    edges: [DVec3::X, DVec3::Y * 0.2, DVec3::Z * 3.0],
                },
            ),
            object(
                "tower",
                red(),
                Shape::Cone { base: DVec3::ZERO, top: DVec3::Y * 2.5, base_radius: 0.5, top_radius: 0.0, capped: true },
            ),
            object(
                "pipe",
                red(),
                Shape::Cone { base: p1, top: p2, base_radius: 12.0, top_radius: 0.25, capped: false },
            ),
            object("flag", red(), Shape::Facet { p0, p1: DVec3::Y / 3.0, p2 }),
            object("球", red(), Shape::Sphere { center: DVec3::new(-10.5, 0.125, 1.0), radius: 12.0 }),
            object("pyramid", red(), Shape::Mesh(pyramid)),
            Object { visible: false, ..object("rabbit", red(), Shape::Mesh(rabbit)) },
        ]
        .into_iter()
        .collect(),
    }
}

#[test]
fn a_scene_with_one_of_each() {
    check("everything", |lang| describe(&everything(), lang));
}

/// Names of every width: two columns a character, none at all for an accent, and far wider than a column may be.
#[test]
fn wide_and_long_names_keep_the_columns() {
    let long = "a name longer than any column of a table would like";
    let paint = |name: &str, kr| Material { name: name.into(), surface: Surface { kr, ..Surface::default() } };
    let ball = |name: &str, material: &str| Object {
        material: MaterialRef::Named(material.into()),
        ..Object::new(name, Shape::Sphere { center: DVec3::new(0.0, 0.5, -1.25), radius: 0.5 })
    };
    let scene = Scene {
        name: "漢字の場面".into(),
        materials: [
            paint("金属", Rgb::new(0.8, 0.7, 0.6)),
            paint(long, Rgb::splat(0.1)),
            paint("e\u{301}", Rgb::BLACK),
        ]
        .into_iter()
        .collect(),
        lights: [PointLight::new("太陽", DVec3::Y), PointLight::new(long, DVec3::new(1.0, 2.5, 3.0))]
            .into_iter()
            .collect(),
        objects: [
            ball("球🔺", "金属"),
            ball(long, "e\u{301}"),
            Object { visible: false, ..ball("e\u{301}te\u{301}", long) },
            Object::new(
                "旗",
                Shape::Mesh(Mesh {
                    geometry: Arc::new(tetrahedron()),
                    source: None,
                    placement: Placement::default(),
                    smooth: true,
                }),
            ),
        ]
        .into_iter()
        .collect(),
        ..Scene::default()
    };
    let view = |name: &str| View {
        name: name.into(),
        width: 640,
        height: 480,
        eye: DVec3::Z,
        screen: ScreenSpec::LookAt { look_at: DVec3::ZERO, up: DVec3::Y, fov: 45.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    };
    let views: Views = [view("正面"), view(long)].into_iter().collect();
    check("names", |lang| describe(&scene, lang) + "\n" + &describe_views(&views, lang));
}

#[test]
fn an_empty_scene() {
    check("empty", |lang| describe(&Scene::default(), lang) + "\n" + &describe_views(&Views::default(), lang));
}

#[test]
fn views_of_each_kind() {
    let view = |name: &str, screen| View {
        name: name.into(),
        width: 640,
        height: 480,
        eye: DVec3::new(0.0, 1.0, 5.0),
        screen,
        samples: 1,
        depth: None,
        steps: Steps::default(),
    };
    let (origin, u, v) = (DVec3::new(-1.0, 1.75, 3.5), DVec3::X * 2.0, DVec3::Y * -1.5);
    let centered = ScreenSpec::Centered { center: DVec3::ZERO, size: [2.0, 1.5], up: DVec3::Y };
    let views = [
        view("front", ScreenSpec::Frame(Screen { origin, u, v })),
        View {
            samples: 3,
            steps: Steps { shadows: false, transparency: false, ..Steps::default() },
            ..view("centred", centered)
        },
        view("corners", ScreenSpec::Corners([origin + v, origin + u + v, origin + u, origin])),
        View { depth: Some(2), ..view("wide", ScreenSpec::LookAt { look_at: DVec3::ZERO, up: DVec3::Y, fov: 45.0 }) },
    ];
    let views: Views = views.into_iter().collect();
    check("views", |lang| describe_views(&views, lang));
}

/// A mesh of a million facets is summed up in a few lines, whatever it holds.
#[test]
fn large_meshes_are_summed_up() {
    let geometry = MeshGeometry { facets: vec![[0, 1, 2]; 1_000_000], ..tetrahedron() };
    let mesh = Mesh { geometry: Arc::new(geometry), source: None, placement: Placement::default(), smooth: false };
    let scene = Scene { objects: [Object::new("big", Shape::Mesh(mesh))].into_iter().collect(), ..Scene::default() };
    let text = describe(&scene, Lang::English);
    let expected = "  1  big    mesh    (grey)     4 vertices   1000000 facets   not closed\n                               \
                    x 0 to 1   y 0 to 0   z 0 to 1\n";
    assert!(text.ends_with(expected), "{text}");
}

/// A name cannot send commands to a terminal.
#[test]
fn control_characters_are_not_shown() {
    let scene = Scene { name: "\u{1b}[31mred\u{9b}2J\r\n".into(), ..Scene::default() };
    let text = describe(&scene, Lang::English);
    assert!(text.starts_with("\u{fffd}[31mred\u{fffd}2J\u{fffd}\u{fffd}\n"), "{text}");
}

proptest! {
    /// Every name stands in the text, and no line ends with blanks.
    #[test]
    fn nothing_is_left_out(stage in stage()) {
        for lang in Lang::ALL {
            let (scene, views) = (describe(&stage.scene, lang), describe_views(&stage.views, lang));
            let names = stage.scene.objects.iter().map(|object| &object.name);
            let names = names.chain(stage.scene.lights.iter().map(|light| &light.name));
            for name in names.chain(stage.scene.materials.iter().map(|material| &material.name)) {
                prop_assert!(scene.contains(&**name), "{name} is missing in\n{scene}");
            }
            for view in &stage.views {
                prop_assert!(views.contains(&*view.name), "{} is missing in\n{views}", view.name);
            }
            prop_assert!(scene.lines().chain(views.lines()).all(|line| !line.ends_with(' ')));
        }
    }
}
