//! The canonical layout: what is written reads back as the same model, and is written again as the same text.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test")]

#[path = "../../scene/tests/arbitrary/mod.rs"]
mod arbitrary;

use arbitrary::{Extent, scene, views};
use lancer_formats::mesh::{MeshFile, MeshFiles, MeshProblem};
use lancer_formats::xml::{Document, read_scene, read_views, write_scene, write_views};
use lancer_scene::{
    DVec3, Material, MaterialRef, Mesh, MeshGeometry, Name, Object, PointLight, Rgb, Scene, Shape, Surface, View,
};
use proptest::prelude::*;
use std::sync::Arc;

struct NoFiles;

impl MeshFiles for NoFiles {
    fn read(&mut self, path: &str) -> Result<MeshFile, MeshProblem> {
        panic!("{path} is not to be read")
    }
}

fn read(text: &str) -> Scene {
    let document = Document::read("written.xml", text.as_bytes()).expect("well-formed");
    let outcome = read_scene(&document, &mut NoFiles);
    assert_eq!(outcome.diagnostics, [], "{text}");
    outcome.value.expect("a scene")
}

/// The example of the specification, as it is written.
#[test]
fn the_layout() {
    let material = |name: &str, surface| Material { name: name.into(), surface };
    let red = Surface { ka: Rgb::new(0.4, 0.05, 0.05), kd: Rgb::new(0.7, 0.1, 0.1), ..Surface::default() };
    let named = |name: &str| MaterialRef::Named(name.into());
    let pyramid = MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Z, DVec3::Y],
        facets: vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]],
        ..MeshGeometry::default()
    };
    let mesh = |geometry, source: Option<&str>| {
        let source = source.map(Into::into);
        Shape::Mesh(Mesh { geometry: Arc::new(geometry), source, placement: Default::default(), smooth: true })
    };
    let object = |name: &str, material, shape| Object { material, ..Object::new(Name::from(name), shape) };
    let glass = Surface { kt: Rgb::splat(0.95), index: Rgb::splat(1.5), ..Surface::default() };
    let mut scene = Scene { name: "Mirror \"ball\"".into(), ..Scene::default() };
    scene.world.depth = 12;
    scene.materials = [material("red", red), material("grey", Surface::default())].into_iter().collect();
    scene.lights = [PointLight::new("lamp", DVec3::new(-2.0, 3.5, 1e-7))].into_iter().collect();
    let p = [DVec3::ZERO, DVec3::Z, DVec3::X];
    scene.objects = [
        object("ball", named("red"), Shape::Sphere { center: DVec3::Y, radius: 0.5 }),
        object("floor", named("grey"), Shape::Plane { p0: p[0], p1: p[1], p2: p[2] }),
        object("lens", MaterialRef::Inline(Arc::new(glass)), Shape::Sphere { center: DVec3::ZERO, radius: 1.0 }),
        object("pyramid", named("red"), mesh(pyramid, None)),
        object("rabbit", MaterialRef::Default, mesh(MeshGeometry::default(), Some("rabbit.obj"))),
    ]
    .into_iter()
    .collect();
    assert_eq!(
        write_scene(&scene),
        r#"<?xml version="1.0" encoding="UTF-8"?>
<scene version="1" name="Mirror &quot;ball&quot;">
  <world depth="12"/>

  <material name="red"  ka="0.4 0.05 0.05" kd="0.7 0.1 0.1"/>
  <material name="grey"/>

  <light name="lamp" position="-2 3.5 1e-7"/>

  <sphere name="ball"    center="0 1 0" radius="0.5" material="red"/>
  <plane  name="floor"   p0="0 0 0" p1="0 0 1" p2="1 0 0" material="grey"/>
  <sphere name="lens"    center="0 0 0" radius="1">
    <material kt="0.95" index="1.5"/>
  </sphere>
  <mesh   name="pyramid" material="red" smooth="true">
    <vertices>0 0 0  1 0 0  0 0 1  0 1 0</vertices>
    <facets>0 1 2  0 3 1  1 3 2  2 3 0</facets>
  </mesh>
  <mesh   name="rabbit"  src="rabbit.obj" smooth="true"/>
</scene>
"#
    );
    assert_eq!(
        write_scene(&Scene::default()),
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<scene version=\"1\">\n</scene>\n"
    );
}

#[test]
fn long_lists_stand_on_lines_of_their_own() {
    let points: Vec<DVec3> = (0..20).map(|number| DVec3::splat(f64::from(number) + 0.5)).collect();
    let geometry = MeshGeometry { positions: points, facets: vec![[0, 1, 2]; 30], ..MeshGeometry::default() };
    let mesh = Mesh { geometry: Arc::new(geometry), source: None, placement: Default::default(), smooth: false };
    let objects = [Object::new("mesh", Shape::Mesh(mesh))].into_iter().collect();
    let scene = Scene { objects, ..Scene::default() };
    let text = write_scene(&scene);
    assert!(text.contains("    <vertices>\n      0.5 0.5 0.5\n      1.5 1.5 1.5\n"), "{text}");
    assert!(text.contains("      0 1 2\n    </facets>\n  </mesh>\n"), "{text}");
    assert_eq!(read(&text), scene);
}

/// A title is any text; what XML cannot hold is not written.
#[test]
fn hostile_titles_make_no_broken_document() {
    let scene = Scene { name: "a\u{0}b\u{FFFF}c".into(), ..Scene::default() };
    assert_eq!(read(&write_scene(&scene)).name, "a\u{FFFD}b\u{FFFD}c");
}

/// The defaults of the vocabulary are those of the model.
#[test]
fn an_empty_document_is_the_default_scene() {
    assert_eq!(read("<scene version='1'><world/></scene>"), Scene::default());
    let scene = read("<scene version='1'><material name='m'/><light position='0 0 0'/></scene>");
    assert_eq!(scene.materials[0].surface, Surface::default());
    assert_eq!(*scene.lights[0], PointLight::new("light 1", DVec3::ZERO));
    let scene = read("<scene version='1'><cube center='0 0 0' edge='1'/><mesh><vertices/><facets/></mesh></scene>");
    assert_eq!(
        *scene.objects[0],
        Object::new("cube 1", Shape::Cube { center: DVec3::ZERO, edge: 1.0, rotation: DVec3::ZERO })
    );
    let mesh = Mesh { geometry: Default::default(), source: None, placement: Default::default(), smooth: false };
    assert_eq!(*scene.objects[1], Object::new("mesh 1", Shape::Mesh(mesh)));
    let document = Document::read("a.xml", b"<view version='1'><eye at='0 0 1' look-at='0 0 0'/></view>").unwrap();
    let views = read_views(&document).value.unwrap();
    let expected = View {
        name: "view 1".into(),
        width: 640,
        height: 480,
        eye: DVec3::Z,
        screen: lancer_scene::ScreenSpec::LookAt { look_at: DVec3::ZERO, up: DVec3::Y, fov: 45.0 },
        samples: 1,
        depth: None,
        steps: Default::default(),
    };
    assert_eq!(*views[0], expected);
}

/// Equality does not tell 0 from -0, but the writer keeps them apart.
fn same_bits(scene: &Scene) -> String {
    format!("{scene:?}")
}

proptest! {
    #[test]
    fn a_written_scene_reads_back_as_itself(scene in scene(Extent::SelfContained)) {
        let text = write_scene(&scene);
        let again = read(&text);
        prop_assert_eq!(same_bits(&again), same_bits(&scene), "{}", text);
        prop_assert_eq!(write_scene(&again), text);
    }

    #[test]
    fn written_views_read_back_as_themselves(views in views()) {
        let text = write_views(&views);
        let document = Document::read("written.view.xml", text.as_bytes()).unwrap();
        let again = read_views(&document).value.expect(&text);
        prop_assert_eq!(format!("{again:?}"), format!("{views:?}"), "{}", text);
        prop_assert_eq!(write_views(&again), text);
    }
}
