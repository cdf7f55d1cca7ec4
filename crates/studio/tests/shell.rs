//! The window around the views: menus, keys, languages, questions, files.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test")]

mod window;

use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use lancer_document::Item;
use lancer_render::{RenderOptions, render_still};
use lancer_scene::Stage;
use lancer_studio::dialogs::Reply;
use lancer_studio::entry::Entry;
use lancer_studio::menus::MENUS;
use lancer_studio::toasts::Mood;
use lancer_trace::{Cancel, World};
use lancer_words::Lang;
use std::collections::HashMap;
use std::path::Path;
use window::{Window, stage};

fn text_of(window: &Window) -> Vec<String> {
    let root = window.harness.root();
    let text = |node: &egui_kittest::Node<'_>| {
        let node = node.accesskit_node();
        node.label().or_else(|| node.value())
    };
    root.children_recursive().filter_map(|node| text(&node)).collect()
}

/// A scene from nothing: every kind is added from the menu, renamed and deleted by keys, all of it undone and redone.
#[test]
fn a_scene_from_nothing() {
    let mut window = Window::new(lancer_studio::welcome::empty(), Lang::English);
    let empty = window.stage().clone();
    for kind in ["Sphere", "Plane", "Cube", "Box", "Facet", "Lamp", "Material", "View"] {
        window.menu("Add", kind);
    }
    let names = |window: &Window| -> Vec<String> {
        let scene = &window.stage().scene;
        let objects = scene.objects.iter().map(|object| object.name.to_string());
        objects.chain(scene.lights.iter().map(|light| light.name.to_string())).collect()
    };
    assert_eq!(names(&window), ["sphere 1", "plane 1", "cube 1", "box 1", "facet 1", "light 1", "light 2"]);
    assert_eq!((window.stage().scene.materials.len(), window.stage().views.len()), (1, 2));
    assert_eq!(window.studio().shown().len(), 2, "the new view is shown");
    assert_eq!(window.steps(), 8);
    window.press(Modifiers::COMMAND, Key::A);
    assert_eq!(window.selected().len(), 7);
    window.press(Modifiers::NONE, Key::Delete);
    assert_eq!(names(&window), Vec::<String>::new());
    for _ in 0..9 {
        window.press(Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(*window.stage(), empty);
    for _ in 0..9 {
        window.press(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    }
    assert_eq!(names(&window), Vec::<String>::new());
    assert_eq!(window.steps(), 9);
}

#[test]
fn an_object_is_renamed_by_keys() {
    let mut window = Window::new(stage(), Lang::English);
    window.click("red");
    assert_eq!(window.selected(), [Item::Object("red".into())]);
    window.press(Modifiers::NONE, Key::F2);
    window.press(Modifiers::COMMAND, Key::A);
    window.harness.event(egui::Event::Text("ruby".into()));
    window.settle();
    window.press(Modifiers::NONE, Key::Enter);
    assert!(window.object("ruby").is_some() && window.object("red").is_none());
    assert_eq!(window.last_step(), "Rename red to ruby");
}

/// Keys that delete or undo do nothing to the scene while a name is typed.
#[test]
fn typing_is_no_command() {
    let mut window = Window::new(stage(), Lang::English);
    window.click("red");
    window.press(Modifiers::NONE, Key::F2);
    for key in [Key::Delete, Key::H, Key::F, Key::P, Key::G] {
        window.press(Modifiers::NONE, key);
    }
    assert!(window.object("red").is_some());
    assert_eq!(window.steps(), 0);
}

/// No two entries have the same keys, and every entry is named in both languages.
#[test]
fn keys_are_distinct() {
    let mut known = HashMap::new();
    for entry in Entry::with_keys() {
        for keys in entry.keys() {
            let text = format!("{:?} {:?}", keys.modifiers, keys.logical_key);
            assert_eq!(known.insert(text, entry).filter(|other| *other != entry), None, "{entry:?}");
        }
        assert!(Lang::ALL.into_iter().all(|lang| !entry.name(lang).is_empty()));
    }
}

/// On a French keyboard the key of 7 gives è: its place counts.
#[test]
fn digits_are_known_by_their_place() {
    let mut window = Window::new(stage(), Lang::French);
    let physical_key = Some(Key::Num7);
    let (pressed, repeat, modifiers) = (true, false, Modifiers::NONE);
    window.event(egui::Event::Key { key: Key::Questionmark, physical_key, pressed, repeat, modifiers });
    assert_eq!(window.last_step(), "Move the eye of front");
}

/// Every menu and every menu of a pane opens, with everything in it named.
#[test]
fn everything_in_the_menus_is_named() {
    let mut window = Window::new(stage(), Lang::English);
    for (name, _, _) in MENUS {
        window.click(&name(Lang::English));
        window.press(Modifiers::NONE, Key::Escape);
    }
    for menu in ["Steps of the algorithm", "Size, depth, samples", "Save the picture", "More"] {
        window.click(&format!("{menu} · front"));
        window.press(Modifiers::NONE, Key::Escape);
    }
    window.press(Modifiers::NONE, Key::F1);
    assert!(text_of(&window).iter().any(|text| text == "Keyboard and mouse"));
    window.press(Modifiers::NONE, Key::Escape);
    assert!(!text_of(&window).iter().any(|text| text == "Keyboard and mouse"));
}

#[test]
fn the_language_changes_while_it_runs() {
    let mut window = Window::new(stage(), Lang::English);
    let english = text_of(&window);
    assert!(english.contains(&"File".to_owned()) && english.contains(&"Properties".to_owned()));
    window.click("Passer en français");
    let french = text_of(&window);
    for text in ["Fichier", "Édition", "Ajouter", "Affichage", "Rendu", "Aide", "Propriétés", "Historique", "Problèmes"]
    {
        assert!(french.contains(&text.to_owned()), "{text}");
    }
    for text in ["File", "Edit", "Properties", "History", "Scene"] {
        assert!(!french.contains(&text.to_owned()), "{text}");
    }
    window.menu("Ajouter", "Sphère");
    assert!(window.object("sphere 1").is_some());
    window.click("Switch to English");
    assert!(text_of(&window).contains(&"File".to_owned()));
}

#[test]
fn the_steps_of_the_subject_are_switches_of_a_view() {
    let mut window = Window::new(stage(), Lang::English);
    window.click("Steps of the algorithm · front");
    window.click("+ Shadows");
    assert!(!window.stage().views[0].steps.shadows && window.stage().views[1].steps.shadows);
    assert_eq!(window.steps(), 1);
    window.click("+ Shadows");
    assert!(window.stage().views[0].steps.shadows);
}

#[test]
fn size_depth_and_samples_of_a_view() {
    let mut window = Window::new(stage(), Lang::English);
    window.click("Size, depth, samples · front");
    window.click("320 × 240");
    window.click("Fit the pane");
    assert_eq!(window.studio().live("front").unwrap().size(), [320, 240]);
    window.click("More: Samples per pixel");
    window.click("As the world (6)");
    window.click("Less: Depth limit");
    let view = &window.stage().views[0];
    assert_eq!((view.width, view.height, view.samples, view.depth), (320, 240, 2, Some(5)));
}

/// The picture that is saved is the view's own, whatever the pane shows: the command line's byte for byte.
#[test]
fn a_saved_picture_is_the_still_picture() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = Window::new(stage(), Lang::English);
    let path = folder.path().join("front.ppm");
    window.dialogs.replies.borrow_mut().push_back(Reply::Chosen(path.clone()));
    window.press(Modifiers::COMMAND, Key::E);
    window.until("the message", |studio| studio.toasts().iter().any(|toast| toast.mood == Mood::Done));
    assert_eq!(window.dialogs.asked.borrow()[0].name, "scene-front.ppm");
    let Stage { scene, views } = window.stage();
    let options = RenderOptions::default();
    let still = render_still(&World::compile(scene), &views[0], &options, &Cancel::default(), |_, _| ()).unwrap();
    let mut due = Vec::new();
    lancer_formats::ppm::write_plain(&still.picture, &mut due).unwrap();
    assert!(std::fs::read(&path).unwrap() == due);
}

fn write(path: &Path, text: &str) {
    std::fs::write(path, text).unwrap();
}

const SCENE: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<!-- kept -->
<scene version="1" name="One ball">
  <light name="lamp" position="2 4 3"/>
  <sphere name="ball" center="0 0.5 0" radius="0.5"/>
</scene>
"#;
const VIEWS: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<views version="1">
  <view name="near" width="64" height="48"><eye at="0 1 3" look-at="0 0.5 0"/></view>
</views>
"#;

/// Opened with the views beside it, edited, saved with its comment, reopened equal.
#[test]
fn a_scene_is_opened_edited_and_saved() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("one.xml");
    write(&path, SCENE);
    write(&folder.path().join("one.view.xml"), VIEWS);
    let mut window = Window::opening(stage(), Lang::English, vec![path.clone()]);
    window.until("the scene", |studio| studio.document().stage().scene.name == "One ball");
    window.settle();
    assert_eq!(window.studio().shown(), ["near"]);
    window.menu("Add", "Cube");
    window.press(Modifiers::COMMAND, Key::S);
    window.until("saved", |studio| !studio.document().is_modified());
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains("<!-- kept -->") && text.contains("cube 1"), "{text}");
    let saved = window.stage().clone();
    let mut again = Window::opening(stage(), Lang::English, vec![path]);
    again.until("the scene", |studio| studio.document().stage().scene.name == "One ball");
    assert_eq!(*again.stage(), saved);
}

/// A mesh that the program is started with is a scene of its own, and seen whole.
#[test]
fn a_mesh_is_opened_as_a_scene_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tetra.obj");
    write(&path, "v 0 0 0\nv 900 0 0\nv 0 900 0\nv 0 0 900\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    let mut window = Window::opening(stage(), Lang::English, vec![path]);
    window.until("the mesh", |studio| studio.document().stage().scene.objects.len() == 1);
    window.settle();
    assert_eq!(window.selected(), [Item::Object("tetra".into())]);
    let view = window.stage().views[0].clone();
    let camera = lancer_trace::Camera::new(&view).unwrap();
    let geometry = window.object("tetra").unwrap();
    let (low, high) = geometry.shape.bounds().unwrap();
    for corner in [low, high] {
        let (x, y) = camera.project(corner).unwrap();
        assert!(x > 0.0 && y > 0.0 && x < f64::from(view.width) && y < f64::from(view.height), "{x} {y}");
    }
}

/// Saved in the binary format, the scene and its views come back as they were.
#[test]
fn a_scene_saved_as_binary_is_reopened_equal() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("kept.lancer");
    let mut window = Window::new(stage(), Lang::English);
    window.menu("Add", "Cube");
    window.dialogs.replies.borrow_mut().push_back(Reply::Chosen(path.clone()));
    window.press(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    window.until("saved", |studio| !studio.document().is_modified());
    let saved = window.stage().clone();
    let mut again = Window::opening(lancer_studio::welcome::empty(), Lang::English, vec![path]);
    again.until("the scene", |studio| studio.document().stage().scene.objects.len() == 4);
    assert_eq!(*again.stage(), saved);
}

/// A file that lies on the window.
#[derive(Debug)]
struct Dropped(std::path::PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| error.to_string())
    }
}

#[test]
fn files_dropped_on_the_window_open() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, mesh) = (folder.path().join("one.xml"), folder.path().join("flag.obj"));
    write(&scene, SCENE);
    write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let mut window = Window::new(stage(), Lang::English);
    window.harness.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(scene)));
    window.harness.step();
    window.until("the scene", |studio| studio.document().stage().scene.name == "One ball");
    // a mesh comes into the scene that is shown
    window.harness.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(mesh)));
    window.harness.step();
    window.until("the mesh", |studio| studio.document().stage().scene.objects.len() == 2);
    assert_eq!(window.stage().scene.name, "One ball");
}

#[test]
fn a_broken_file_opens_the_problems_and_the_scene_stays() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("broken.xml");
    write(&path, "<scene version=\"1\">\n  <ball radius=\"1\"/>\n  <world dept=\"3\"/>\n</scene>\n");
    let mut window = Window::opening(stage(), Lang::English, vec![path]);
    window.until("the message", |studio| studio.toasts().iter().any(|toast| toast.mood == Mood::Failed));
    window.settle();
    assert!(window.object("red").is_some());
    assert!(window.harness.query_by_label("Problems").is_some());
    let text = text_of(&window).join("\n");
    assert!(text.contains("ball") && text.contains("did you mean `depth`? · its attributes"), "{text}");
}

#[test]
fn unsaved_changes_are_asked_about() {
    let mut window = Window::new(stage(), Lang::English);
    window.menu("Add", "Sphere");
    window.press(Modifiers::COMMAND, Key::N);
    assert!(text_of(&window).iter().any(|text| text == "Save the changes?"));
    window.click("Cancel");
    assert!(window.object("sphere 1").is_some());
    window.press(Modifiers::COMMAND, Key::N);
    window.click("Don't save");
    assert!(window.object("sphere 1").is_none() && window.stage().scene.objects.is_empty());
}

#[test]
fn saving_before_going_on_asks_where_and_then_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("kept.xml");
    let mut window = Window::new(stage(), Lang::English);
    window.menu("Add", "Sphere");
    window.press(Modifiers::COMMAND, Key::N);
    window.dialogs.replies.borrow_mut().push_back(Reply::Chosen(path.clone()));
    window.click("Save");
    window.until("the new scene", |studio| studio.document().stage().scene.objects.is_empty());
    assert!(std::fs::read_to_string(&path).unwrap().contains("sphere 1"));
    assert!(folder.path().join("kept.view.xml").is_file());
}

/// Where the system has no dialog, the program's own one asks.
#[test]
fn the_programs_own_dialog_asks_where_the_system_has_none() {
    let folder = tempfile::tempdir().unwrap();
    write(&folder.path().join("one.xml"), SCENE);
    let mut window = Window::new(stage(), Lang::English);
    window.dialogs.replies.borrow_mut().push_back(Reply::Unavailable);
    window.press(Modifiers::COMMAND, Key::O);
    assert!(text_of(&window).iter().any(|text| text == "Open a scene"));
    let path = folder.path().join("one.xml").to_string_lossy().into_owned();
    window.harness.event(egui::Event::Text(path));
    window.settle();
    window.press(Modifiers::NONE, Key::Enter);
    window.until("the scene", |studio| studio.document().stage().scene.name == "One ball");
}

/// A file that another program has written is read again, and that can be undone.
#[test]
fn a_file_changed_outside_is_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("one.xml");
    write(&path, SCENE);
    let mut window = Window::opening(stage(), Lang::English, vec![path.clone()]);
    window.until("the scene", |studio| studio.document().stage().scene.name == "One ball");
    write(&path, &SCENE.replace("One ball", "Another ball"));
    window.event(egui::Event::WindowFocused(true));
    window.until("the new scene", |studio| studio.document().stage().scene.name == "Another ball");
    window.settle();
    window.press(Modifiers::COMMAND, Key::Z);
    assert_eq!(window.stage().scene.name, "One ball");
}

/// What a program kept that ended without saving is offered by the next one.
#[test]
fn work_is_recovered_after_a_crash() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = Window::kept_in(stage(), folder.path());
    window.menu("Add", "Sphere");
    let due = window.stage().clone();
    // the journal is written while the window is alive; dropping it is no proper end
    drop(window);
    let mut next = Window::kept_in(lancer_studio::welcome::empty(), folder.path());
    assert!(text_of(&next).iter().any(|text| text == "Recover unsaved work?"));
    next.click("Recover");
    assert_eq!(next.stage().scene, due.scene);
    drop(next);
    let mut last = Window::kept_in(stage(), folder.path());
    last.click("Discard");
    drop(last);
    let after = Window::kept_in(stage(), folder.path());
    assert!(!text_of(&after).iter().any(|text| text == "Recover unsaved work?"));
}
