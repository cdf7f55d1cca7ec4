//! What each command gives, by example.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use lancer_document::insert::{NewItem, Standpoint};
use lancer_document::{Document, Item, StepName, arrange};
use lancer_scene::{
    DVec3, Material, MaterialRef, Mesh, MeshGeometry, Object, Part, Placement, PointLight, Rgb, Scene, Screen,
    ScreenSpec, Shape, Stage, Steps, Surface, View,
};
use lancer_trace::World;
use lancer_words::Lang;
use std::sync::Arc;

fn view() -> View {
    View {
        name: "front".into(),
        width: 640,
        height: 480,
        eye: DVec3::new(0.0, 2.0, 6.0),
        screen: ScreenSpec::LookAt { look_at: DVec3::ZERO, up: DVec3::Y, fov: 45.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    }
}

fn floor() -> Object {
    Object::new("floor", Shape::Plane { p0: DVec3::ZERO, p1: DVec3::Z, p2: DVec3::X })
}

fn stage() -> Stage {
    let mut stage = Stage::default();
    stage.scene.objects = [floor()].into_iter().collect();
    stage.views = [view()].into_iter().collect();
    stage
}

fn at(stage: &Stage) -> Standpoint {
    Standpoint::of(&view(), &stage.scene, Some(&World::compile(&stage.scene)))
}

fn add(document: &mut Document, item: NewItem) -> Item {
    let at = at(document.stage());
    document.add(item, &at).unwrap();
    document.selection().primary().unwrap().clone()
}

fn pyramid() -> Arc<MeshGeometry> {
    Arc::new(MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X * 10.0, DVec3::Z * 10.0, DVec3::Y * 10.0],
        facets: vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]],
        ..MeshGeometry::default()
    })
}

/// New things stand on what the middle of the view shows, a fifth of the picture high, in round numbers.
#[test]
fn new_things_stand_on_the_floor_before_the_view() {
    let stage = stage();
    let at = at(&stage);
    assert_eq!(at, Standpoint { point: DVec3::ZERO, normal: DVec3::Y, up: DVec3::Y, right: DVec3::X, size: 0.5 });
    let mut document = Document::new(StepName::New, stage);
    let shape = |document: &Document, name: &str| {
        let object = document.stage().scene.objects.iter().find(|object| &*object.name == name);
        object.unwrap_or_else(|| panic!("no {name}")).shape.clone()
    };
    add(&mut document, NewItem::Sphere);
    let ball = Shape::Sphere { center: DVec3::new(0.0, 0.25, 0.0), radius: 0.25 };
    assert_eq!(shape(&document, "sphere 1"), ball);
    let mut document = Document::new(StepName::New, crate::stage());
    add(&mut document, NewItem::Cube);
    let cube = Shape::Cube { center: DVec3::new(0.0, 0.249, 0.0), edge: 0.5, rotation: DVec3::ZERO };
    assert_eq!(shape(&document, "cube 1"), cube);
    let mut document = Document::new(StepName::New, crate::stage());
    add(&mut document, NewItem::Cone);
    let (base, top) = (DVec3::new(0.0, -0.001, 0.0), DVec3::new(0.0, 0.499, 0.0));
    let cone = Shape::Cone { base, top, base_radius: 0.25, top_radius: 0.0, capped: true };
    assert_eq!(shape(&document, "cone 1"), cone);
}

/// Where z is up, things stand upright along z.
#[test]
fn new_things_stand_upright_where_z_is_up() {
    let screen = ScreenSpec::LookAt { look_at: DVec3::ZERO, up: DVec3::Z, fov: 45.0 };
    let z_up = View { eye: DVec3::new(1.0, -6.0, 2.0), screen, ..view() };
    let mut document = Document::new(StepName::New, Stage::default());
    let at = Standpoint::of(&z_up, &Scene::default(), None);
    assert_eq!((at.up, at.normal), (DVec3::Z, DVec3::Z));
    for item in [NewItem::Plane, NewItem::Parallelepiped, NewItem::Facet] {
        document.add(item, &at).unwrap();
    }
    let scene = &document.stage().scene;
    let Shape::Plane { p0, p1, p2 } = scene.objects[0].shape else { panic!("a plane") };
    assert_eq!((p1 - p0).cross(p2 - p0).normalize(), DVec3::Z);
    let (low, high) = scene.objects[1].shape.bounds().unwrap();
    assert!(((high - low) - DVec3::new(0.5, 0.5, 0.25)).length() < 1e-12, "{low} {high}");
    let (low, high) = scene.objects[2].shape.bounds().unwrap();
    assert!((high.z - low.z - 0.5).abs() < 1e-12);
}

#[test]
fn every_kind_gets_a_name_of_its_own_and_is_selected() {
    let mut document = Document::new(StepName::New, stage());
    let kinds = || {
        [
            NewItem::Sphere,
            NewItem::Plane,
            NewItem::Facet,
            NewItem::Cube,
            NewItem::Parallelepiped,
            NewItem::Mesh { stem: "rabbit".into(), geometry: pyramid(), source: None },
            NewItem::Light,
            NewItem::Material { stem: String::new(), surface: Surface::default() },
            NewItem::Material { stem: "chrome".into(), surface: Surface::default() },
            NewItem::View(Some(view())),
        ]
    };
    let names: Vec<String> =
        kinds().into_iter().chain(kinds()).map(|kind| add(&mut document, kind).name().unwrap().to_string()).collect();
    let once =
        ["sphere 1", "plane 1", "facet 1", "cube 1", "box 1", "rabbit", "light 1", "material 1", "chrome", "view 1"];
    let twice = [
        "sphere 2",
        "plane 2",
        "facet 2",
        "cube 2",
        "box 2",
        "rabbit 2",
        "light 2",
        "material 2",
        "chrome 2",
        "view 2",
    ];
    assert_eq!(names, [once, twice].concat());
    assert_eq!(document.stage().scene.check(), Ok(()));
    assert_eq!(document.history().undoable().unwrap().text(Lang::French), "Ajout de view 2");
}

/// A mesh that is far from the size that suits the view is scaled by a round factor; its foot stands on the point.
#[test]
fn a_large_mesh_is_brought_to_size() {
    let mut document = Document::new(StepName::New, stage());
    add(&mut document, NewItem::Mesh { stem: String::new(), geometry: pyramid(), source: None });
    let object = &document.stage().scene.objects[1];
    assert_eq!(&*object.name, "mesh 1");
    let (low, high) = object.shape.bounds().unwrap();
    assert!((high - low - DVec3::splat(0.5)).length() < 1e-12, "{low} {high}");
    assert!(low.y < 0.0 && low.y > -0.01, "a hair into the floor");
    assert!(((low + high) * 0.5).x.abs() < 1e-12);
}

#[test]
fn without_anything_to_stand_on_it_is_the_point_looked_at() {
    let scene = Scene::default();
    let far = View { screen: ScreenSpec::LookAt { look_at: DVec3::Y, up: DVec3::Y, fov: 45.0 }, ..view() };
    assert_eq!(Standpoint::of(&far, &scene, Some(&World::compile(&scene))).point, DVec3::Y);
    // a screen given in space: three times as far as the screen
    let screen = Screen { origin: DVec3::new(-1.0, 2.75, 4.0), u: DVec3::X * 2.0, v: DVec3::NEG_Y * 1.5 };
    let framed = View { screen: ScreenSpec::Frame(screen), ..view() };
    assert_eq!(Standpoint::of(&framed, &scene, None).point, DVec3::new(0.0, 2.0, 0.0));
    // a hit on the horizon is not where things are to stand
    let flat = View { eye: DVec3::new(0.0, 1.0, 10.0), ..far };
    let grazing =
        View { screen: ScreenSpec::LookAt { look_at: DVec3::new(0.0, 0.9, 0.0), up: DVec3::Y, fov: 45.0 }, ..flat };
    let at = Standpoint::of(&grazing, &stage().scene, Some(&World::compile(&stage().scene)));
    assert!((at.point - DVec3::new(0.0, 0.9, 0.0)).length() < 0.01, "{at:?}");
}

fn material(name: &str) -> Material {
    Material { name: name.into(), surface: Surface { kd: Rgb::splat(0.1), ..Surface::default() } }
}

/// Two meshes that share a geometry with a part of `red`, a ball of `red`, and `blue` that is not deleted.
fn painted() -> Stage {
    let named = |name: &str| MaterialRef::Named(name.into());
    let part = |material, first| Part { material, first, count: 1 };
    let geometry =
        Arc::new(MeshGeometry { parts: vec![part(named("red"), 0), part(named("blue"), 1)], ..(*pyramid()).clone() });
    let mesh = |name: &str| {
        let geometry = Arc::clone(&geometry);
        let mesh = Mesh { geometry, source: None, placement: Placement::default(), smooth: false };
        Object { material: named("blue"), ..Object::new(name, Shape::Mesh(mesh)) }
    };
    let ball = Object {
        material: named("red"),
        ..Object::new("ball", Shape::Sphere { center: DVec3::splat(50.0), radius: 1.0 })
    };
    let mut stage = Stage::default();
    stage.scene.materials = [material("red"), material("blue")].into_iter().collect();
    stage.scene.objects = [mesh("a"), ball, mesh("b")].into_iter().collect();
    stage.scene.lights = [PointLight::new("lamp", DVec3::Y)].into_iter().collect();
    stage.views = [view()].into_iter().collect();
    stage
}

/// A material in use is replaced by the built-in grey in the same step, which one undo takes back.
#[test]
fn deleting_a_material_in_use_is_one_step() {
    let mut document = Document::new(StepName::Opened, painted());
    document.select(|selection| selection.set([Item::Material("red".into())]));
    assert!(document.delete_selected().unwrap());
    let scene = &document.stage().scene;
    assert_eq!(scene.check(), Ok(()));
    assert_eq!(scene.materials.len(), 1);
    assert_eq!(scene.objects[1].material, MaterialRef::Default);
    let geometry = |place: usize| {
        let Shape::Mesh(mesh) = &scene.objects[place].shape else { panic!("a mesh") };
        Arc::clone(&mesh.geometry)
    };
    assert_eq!(geometry(0).parts[0].material, MaterialRef::Default);
    assert_eq!(geometry(0).parts[1].material, MaterialRef::Named("blue".into()));
    assert!(Arc::ptr_eq(&geometry(0), &geometry(2)), "meshes that shared their geometry share it again");
    assert!(document.undo());
    assert_eq!(document.stage(), &painted());
}

#[test]
fn several_things_of_every_kind_are_deleted_at_once() {
    let mut document = Document::new(StepName::Opened, painted());
    let all = [
        Item::Material("red".into()),
        Item::Object("a".into()),
        Item::World,
        Item::Object("ball".into()),
        Item::Light("lamp".into()),
        Item::View("front".into()),
        Item::Material("blue".into()),
        Item::Object("ball".into()),
        Item::Object("nobody".into()),
    ];
    document.run(arrange::deleted(document.stage(), &all).unwrap()).unwrap();
    let stage = document.stage();
    assert_eq!(stage.scene.objects.len(), 1);
    assert_eq!(stage.scene.objects[0].material, MaterialRef::Default);
    assert!(stage.scene.materials.is_empty() && stage.scene.lights.is_empty() && stage.views.is_empty());
    assert_eq!(document.history().undoable().unwrap().text(Lang::English), "Delete 6 items");
    assert_eq!(arrange::deleted(stage, &[Item::World]), None);
}

#[test]
fn copies_stand_behind_and_beside_their_originals() {
    let mut document = Document::new(StepName::Opened, painted());
    document.select(|selection| {
        selection.set([Item::Object("ball".into()), Item::Light("lamp".into()), Item::Material("red".into())]);
    });
    assert!(document.duplicate_selected().unwrap());
    let scene = &document.stage().scene;
    let names: Vec<&str> = scene.objects.iter().map(|object| &*object.name).collect();
    assert_eq!(names, ["a", "ball", "ball 2", "b"]);
    assert_eq!(scene.objects[2].shape, Shape::Sphere { center: DVec3::new(52.2, 50.0, 50.0), radius: 1.0 });
    assert_eq!(&*scene.materials[1].name, "red 2");
    assert_eq!(scene.lights[1].position, DVec3::new(0.2, 1.0, 0.0));
    let selected: Vec<&str> = document.selection().iter().map(|item| &**item.name().unwrap()).collect();
    assert_eq!(selected.len(), 3);
    assert!(selected.iter().all(|name| name.ends_with(" 2")));
    assert_eq!(document.history().undoable().unwrap().text(Lang::English), "Duplicate 3 items");
}

#[test]
fn things_are_hidden_shown_and_reordered() {
    let mut document = Document::new(StepName::Opened, painted());
    document.select(|selection| selection.set([Item::Object("a".into()), Item::Light("lamp".into()), Item::World]));
    assert!(document.show_selected(false).unwrap());
    assert!(!document.show_selected(false).unwrap(), "they are hidden already");
    assert!(!document.stage().scene.objects[0].visible && !document.stage().scene.lights[0].visible);
    assert_eq!(document.history().undoable().unwrap().text(Lang::English), "Hide 2 items");
    assert!(document.show_selected(true).unwrap());
    let a = Item::Object("a".into());
    assert!(document.reorder(&a, 99).unwrap());
    assert_eq!(a.place(document.stage()), Some(2));
    assert!(!document.reorder(&a, 2).unwrap());
    assert!(!document.reorder(&Item::World, 0).unwrap());
}

/// A new name is the name in every reference, too.
#[test]
fn a_renamed_material_keeps_its_users() {
    let mut document = Document::new(StepName::Opened, painted());
    assert!(document.rename(&Item::Material("red".into()), "crimson").unwrap());
    let scene = &document.stage().scene;
    assert_eq!(scene.check(), Ok(()));
    assert_eq!(scene.objects[1].material, MaterialRef::Named("crimson".into()));
}
