//! Files: opened, saved, saved elsewhere, reloaded; comments stay, a broken file changes nothing.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use lancer_document::insert::{NewItem, Standpoint};
use lancer_document::open::{self, Content, FileKind, OpenError};
use lancer_document::{Document, Item, StepName, attribute};
use lancer_formats::load::LoadOptions;
use lancer_formats::save::SceneFormat;
use lancer_formats::{Describe, Severity};
use lancer_scene::{DVec3, Shape, Stage};
use lancer_words::Lang;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

const SCENE: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<!-- What the teacher wrote -->
<scene version="1" name="Ball">
  <material name="red"   kd="0.7 0.1 0.1"/>   <!-- the only one -->
  <light name="lamp" position="-2 3 2"/>
  <sphere name="ball" center="0 0.5 0" radius="0.5" material="red"/>
</scene>
"#;

const VIEWS: &str = r#"<views version="1">
  <!-- from the front -->
  <view name="front" width="64" height="48"><eye at="0 1 5" look-at="0 0.5 0"/></view>
</views>
"#;

const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";

/// A folder with `ball.xml`, `ball.view.xml` and `models/tetra.obj`.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("ball.xml"), SCENE).unwrap();
    fs::write(folder.path().join("ball.view.xml"), VIEWS).unwrap();
    fs::create_dir(folder.path().join("models")).unwrap();
    fs::write(folder.path().join("models/tetra.obj"), TETRAHEDRON).unwrap();
    folder
}

fn options() -> LoadOptions {
    LoadOptions::default()
}

fn opened(folder: &Path) -> Document {
    let path = folder.join("ball.xml");
    let scene = open::read_scene(&path, &options()).unwrap();
    let views = open::read_views(&open::views_beside(&path), &options()).unwrap();
    Document::open(scene, Some(views), options())
}

fn move_ball(document: &mut Document, x: f64) {
    let edit = attribute::edit_object(document.stage(), "ball", |object| {
        object.shape = Shape::Sphere { center: DVec3::new(x, 0.5, 0.0), radius: 0.5 };
    });
    document.apply(StepName::Moved("ball".into()), &edit.unwrap()).unwrap();
}

fn save(document: &mut Document, path: &Path, format: SceneFormat) {
    let saved = document.saving_scene(path, format).write().unwrap();
    document.saved_scene(saved);
}

#[test]
fn an_opened_document_knows_its_files_and_is_clean() {
    let folder = folder();
    let document = opened(folder.path());
    assert!(!document.is_modified());
    assert_eq!(document.scene_path(), Some(&*folder.path().join("ball.xml")));
    assert_eq!(document.views_path(), Some(&*folder.path().join("ball.view.xml")));
    assert_eq!(&*document.stage().views[0].name, "front");
    assert_eq!(document.history().names().collect::<Vec<_>>(), [&StepName::Opened]);
    assert_eq!(String::from_utf8(document.scene_text()).unwrap(), SCENE);
    assert_eq!(String::from_utf8(document.views_text()).unwrap(), VIEWS);
}

#[test]
fn without_views_the_whole_scene_is_seen() {
    let folder = folder();
    let scene = open::read_scene(&folder.path().join("ball.xml"), &options()).unwrap();
    let document = Document::open(scene, None, options());
    assert!(!document.is_modified(), "nobody has to save a view that nobody made");
    assert_eq!(document.views_path(), None);
    assert_eq!(document.stage().views.len(), 1);
    assert_eq!(document.stage().views[0].check(), Ok(()));
}

/// Saving keeps what stood in the document, and an undo to what was saved is clean again.
#[test]
fn saving_keeps_comments_and_the_way_back() {
    let folder = folder();
    let path = folder.path().join("ball.xml");
    let mut document = opened(folder.path());
    move_ball(&mut document, 2.0);
    assert!(document.scene_is_modified() && !document.views_are_modified());
    save(&mut document, &path, SceneFormat::Xml);
    assert!(!document.is_modified());
    let text = fs::read_to_string(&path).unwrap();
    assert_eq!(text, SCENE.replace("0 0.5 0\" radius", "2 0.5 0\" radius"));
    document.undo();
    assert!(document.scene_is_modified());
    document.redo();
    assert!(!document.scene_is_modified());
    // and again, from what was written
    move_ball(&mut document, 3.0);
    save(&mut document, &path, SceneFormat::Xml);
    assert_eq!(fs::read_to_string(&path).unwrap(), SCENE.replace("0 0.5 0\" radius", "3 0.5 0\" radius"));
    move_ball(&mut document, 0.0);
    save(&mut document, &path, SceneFormat::Xml);
    assert_eq!(fs::read_to_string(&path).unwrap(), SCENE);
}

#[test]
fn views_are_saved_apart() {
    let folder = folder();
    let mut document = opened(folder.path());
    let edit = attribute::edit_view(document.stage(), "front", |view| view.width = 80).unwrap();
    document.apply(attribute::set(&Item::View("front".into()), "width"), &edit).unwrap();
    assert!(document.views_are_modified() && !document.scene_is_modified());
    let path = document.views_path().unwrap().to_owned();
    let saved = document.saving_views(&path).write().unwrap();
    document.saved_views(saved);
    assert!(!document.is_modified());
    assert_eq!(fs::read_to_string(&path).unwrap(), VIEWS.replace("\"64\"", "\"80\""));
}

/// In both formats, reopened equal.
#[test]
fn a_new_document_is_saved_in_both_formats_and_reopened() {
    let folder = folder();
    let mut document = Document::new(StepName::New, Stage::default());
    assert!(!document.is_modified());
    for kind in [NewItem::Sphere, NewItem::Light, NewItem::Cube] {
        document.add(kind, &Standpoint::default()).unwrap();
    }
    assert!(document.is_modified());
    assert_eq!(document.scene_path(), None);
    for (name, format, kind) in
        [("new.xml", SceneFormat::Xml, FileKind::Native), ("new.lancer", SceneFormat::Binary, FileKind::Binary)]
    {
        let path = folder.path().join(name);
        save(&mut document, &path, format);
        assert!(!document.scene_is_modified());
        assert_eq!(document.scene_path(), Some(&*path));
        let read = open::read_scene(&path, &options()).unwrap();
        assert_eq!(read.on_disk.kind, kind);
        assert_eq!(read.scene, document.stage().scene);
    }
}

/// A gesture that goes on while the user saves is part of what is saved.
#[test]
fn saving_ends_a_gesture() {
    let folder = folder();
    let mut document = opened(folder.path());
    document.begin(StepName::Moved("ball".into()));
    let edit = attribute::edit_object(document.base(), "ball", |object| object.visible = false).unwrap();
    document.preview(&edit).unwrap();
    save(&mut document, &folder.path().join("ball.xml"), SceneFormat::Xml);
    assert!(!document.in_gesture() && !document.is_modified());
    assert_eq!(document.history().names().len(), 2);
}

#[test]
fn a_failed_save_leaves_the_file_and_the_changes() {
    let folder = folder();
    let mut document = opened(folder.path());
    move_ball(&mut document, 2.0);
    let error = document.saving_scene(&folder.path().join("no/such/ball.xml"), SceneFormat::Xml).write().unwrap_err();
    assert_eq!(error.code(), "save::missing-folder");
    assert!(document.is_modified());
    assert_eq!(fs::read_to_string(folder.path().join("ball.xml")).unwrap(), SCENE);
}

#[test]
fn a_broken_file_says_everything_and_changes_nothing() {
    let folder = folder();
    let document = opened(folder.path());
    let path = folder.path().join("broken.xml");
    fs::write(&path, SCENE.replace("radius=\"0.5\"", "radius=\"-1\"").replace("0.1 0.1", "0,1 0,1 0,1")).unwrap();
    let Err(OpenError::Broken { diagnostics, source }) = open::read(&path, &options()) else { panic!("broken") };
    assert_eq!(diagnostics.iter().filter(|found| found.severity == Severity::Error).count(), 2);
    let lines: Vec<usize> =
        diagnostics.iter().filter_map(|found| found.span).map(|span| source.position(span.start).0).collect();
    assert_eq!(lines, [4, 6]);
    assert!(!document.is_modified());
    let missing = open::read(&folder.path().join("none.xml"), &options());
    let Err(OpenError::Unreadable(error)) = missing else { panic!("{missing:?}") };
    assert_eq!(error.code(), "load::missing");
}

/// Dropped on the window: told by content, meshes by their extension.
#[test]
fn every_kind_of_file_is_recognised() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    assert!(matches!(open::read(&at("ball.xml"), &options()), Ok(Content::Scene(_))));
    assert!(matches!(open::read(&at("ball.view.xml"), &options()), Ok(Content::Views(_))));
    assert!(matches!(open::read(&at("models/tetra.obj"), &options()), Ok(Content::Mesh(_))));
    fs::write(at("scene.2009"), "<Scene><Couleur r=\"0\" v=\"0\" b=\"0\"/></Scene>").unwrap();
    let Ok(Content::Scene(scene)) = open::read(&at("scene.2009"), &options()) else { panic!("a scene of 2009") };
    assert_eq!(scene.on_disk.kind, FileKind::Foreign);
    assert_eq!(Document::open(*scene, None, options()).scene_path(), None, "it is not written over");
    let point = |name: &str, x: f64, y: f64, z: f64| format!("<{name} x=\"{x}\" y=\"{y}\" z=\"{z}\"/>");
    let corners: String =
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| point("Point", x, y, 3.0)).concat();
    let vue = format!(
        "<Rendu><Vue largeur=\"2\" hauteur=\"2\"><PointVue>{}</PointVue>{corners}</Vue></Rendu>",
        point("Point", 0.0, 0.0, 5.0)
    );
    fs::write(at("vue.2009"), vue).unwrap();
    let Ok(Content::Views(views)) = open::read(&at("vue.2009"), &options()) else { panic!("views of 2009") };
    assert_eq!((views.views.len(), views.on_disk.kind), (1, FileKind::Foreign));
    fs::write(at("note.txt"), "hello").unwrap();
    assert!(matches!(open::read(&at("note.txt"), &options()), Err(OpenError::Broken { .. })));
    fs::write(at("empty.obj"), "f 1 2 3\n").unwrap();
    assert!(matches!(open::read(&at("empty.obj"), &options()), Err(OpenError::Broken { .. })));
}

fn mesh(path: &Path) -> open::MeshFile {
    open::read_mesh(path, &options()).unwrap()
}

fn sources(document: &Document) -> Vec<Option<String>> {
    let objects = document.stage().scene.objects.iter();
    let shapes = objects.filter_map(|object| if let Shape::Mesh(mesh) = &object.shape { Some(mesh) } else { None });
    shapes.map(|mesh| mesh.source.as_deref().map(str::to_owned)).collect()
}

/// A mesh below the scene's folder is named, any other one is taken in; both survive being saved and opened, also from
/// another folder.
#[test]
fn a_mesh_is_named_if_it_stands_below_the_scene() {
    let folder = folder();
    let elsewhere = tempfile::tempdir().unwrap();
    fs::write(elsewhere.path().join("tetra.obj"), TETRAHEDRON).unwrap();
    let mut document = opened(folder.path());
    for path in [folder.path().join("models/tetra.obj"), elsewhere.path().join("tetra.obj")] {
        let item = document.new_mesh(mesh(&path));
        document.add(item, &Standpoint::default()).unwrap();
    }
    assert_eq!(sources(&document), [Some("models/tetra.obj".to_owned()), None]);
    assert_eq!(&*document.stage().scene.objects[2].name, "tetra 2");
    // beside the models, above them, and where they are not
    let places: [(PathBuf, Option<&str>); 3] = [
        (folder.path().join("ball.xml"), Some("models/tetra.obj")),
        (folder.path().join("models/below.xml"), Some("tetra.obj")),
        (elsewhere.path().join("away.xml"), None),
    ];
    for (path, name) in places {
        save(&mut document, &path, SceneFormat::Xml);
        assert!(!document.scene_is_modified());
        let read = Document::open(open::read_scene(&path, &options()).unwrap(), None, options());
        assert_eq!(sources(&read), [name.map(str::to_owned), None], "{path:?}");
        for (read, kept) in read.stage().scene.objects.iter().zip(document.stage().scene.objects.iter()) {
            assert_eq!(read.shape.bounds(), kept.shape.bounds());
        }
        assert!(fs::read_to_string(&path).unwrap().contains("<!-- the only one -->"));
    }
}

#[test]
fn a_document_without_a_file_takes_every_mesh_in() {
    let folder = folder();
    let document = Document::new(StepName::New, Stage::default());
    let item = document.new_mesh(mesh(&folder.path().join("models/tetra.obj")));
    assert!(matches!(item, NewItem::Mesh { source: None, ref stem, .. } if stem == "tetra"));
}

/// A file that another program wrote is taken in as a step that can be undone.
#[test]
fn a_file_that_changed_outside_is_reloaded_as_a_step() {
    let folder = folder();
    let path = folder.path().join("ball.xml");
    let mut document = opened(folder.path());
    assert!(!document.scene_file().unwrap().changed_outside());
    move_ball(&mut document, 2.0);
    fs::write(&path, SCENE.replace("name=\"Ball\"", "name=\"Written elsewhere\"")).unwrap();
    assert!(document.scene_file().unwrap().changed_outside());
    document.reload_scene(open::read_scene(&path, &options()).unwrap());
    assert!(!document.scene_file().unwrap().changed_outside());
    assert_eq!(document.stage().scene.name, "Written elsewhere");
    assert!(!document.is_modified());
    let names: Vec<String> = document.history().names().map(|name| name.text(Lang::French)).collect();
    assert_eq!(names, ["Ouverture", "Déplacement de ball", "Relecture du fichier"]);
    document.undo();
    assert_eq!(document.stage().scene.name, "Ball");
    assert!(document.is_modified());
    fs::remove_file(&path).unwrap();
    assert!(!document.scene_file().unwrap().changed_outside(), "nothing is there to be read");
}

#[test]
fn views_are_loaded_in_place_of_the_others_or_beside_them() {
    let folder = folder();
    let other = folder.path().join("other.view.xml");
    fs::write(&other, VIEWS.replace("\"64\"", "\"32\"")).unwrap();
    let mut document = opened(folder.path());
    document.add_views(&open::read_views(&other, &options()).unwrap().views);
    let names: Vec<&str> = document.stage().views.iter().map(|view| &*view.name).collect();
    assert_eq!(names, ["front", "front 2"]);
    assert!(document.views_are_modified());
    document.load_views(open::read_views(&other, &options()).unwrap());
    assert_eq!(document.stage().views.len(), 1);
    assert_eq!(document.stage().views[0].width, 32);
    assert_eq!(document.views_path(), Some(&*other));
    assert!(!document.is_modified());
    document.undo();
    assert_eq!(document.stage().views.len(), 2);
}
