//! The panels: every attribute of every kind of thing, the documents, the explanation of a pixel, exports.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test")]

mod window;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use lancer_document::{Item, Selection};
use lancer_formats::xml::vocabulary::{self, ElementRule, FLAG, Kind};
use lancer_scene::{
    DVec3, List, Material, MaterialRef, Mesh, MeshGeometry, Object, Part, Placement, PointLight, Shape, Stage, Surface,
};
use lancer_studio::dialogs::Reply;
use lancer_studio::fields::ScreenKind;
use lancer_studio::{Action, Tab, ViewAction};
use lancer_words::{Lang, attribute};
use std::sync::Arc;
use window::{Window, stage, view};

/// A scene with one thing of every kind, and a view for each way to give a screen.
fn everything() -> Stage {
    let [p0, p1, p2] = [DVec3::ZERO, DVec3::Z, DVec3::X];
    let geometry = MeshGeometry { positions: vec![p0, p1, p2], facets: vec![[0, 1, 2]], ..MeshGeometry::default() };
    let mesh = Mesh { geometry: Arc::new(geometry), source: None, placement: Placement::default(), smooth: false };
    let shapes = [
        Shape::Sphere { center: DVec3::ONE, radius: 1.0 },
        Shape::Plane { p0, p1, p2 },
        Shape::Facet { p0, p1, p2 },
        Shape::Cube { center: DVec3::ONE, edge: 1.0, rotation: DVec3::ZERO },
        Shape::Parallelepiped { origin: DVec3::ZERO, edges: [DVec3::X, DVec3::Y, DVec3::Z] },
        Shape::Cone { base: DVec3::ZERO, top: DVec3::Y, base_radius: 0.5, top_radius: 0.0, capped: true },
        Shape::Mesh(mesh),
    ];
    let mut stage = Stage::default();
    stage.scene.objects = shapes.into_iter().map(|shape| Object::new(shape.element(), shape)).collect::<List<Object>>();
    stage.scene.lights = std::iter::once(PointLight::new("lamp", DVec3::Y)).collect();
    stage.scene.materials = std::iter::once(Material { name: "red".into(), surface: Surface::default() }).collect();
    let views = ScreenKind::ALL.into_iter().zip(["by look-at", "by center", "by frame", "by corners"]);
    stage.views = views
        .map(|(kind, name)| {
            let mut view = view(name, DVec3::new(0.0, 1.0, 5.0));
            view.depth = Some(3);
            view.screen = kind.convert(&view).unwrap();
            view
        })
        .collect();
    stage
}

fn select(window: &mut Window, item: &Item) {
    let ctx = window.harness.ctx.clone();
    window.harness.state_mut().perform(&ctx, Action::Select(Selection::only(item.clone())));
    window.settle();
}

/// Types over what stands in a field for a number.
fn type_into(window: &mut Window, label: &str, text: &str) {
    type_as(window, Role::SpinButton, label, text);
}

fn type_as(window: &mut Window, role: Role, label: &str, text: &str) {
    window.harness.get_by_role_and_label(role, label).focus();
    window.harness.step();
    window.harness.step();
    window.press(Modifiers::COMMAND, Key::A);
    window.harness.event(Event::Text(text.to_owned()));
    window.harness.step();
    window.press(Modifiers::NONE, Key::Enter);
}

/// What an edit by a widget must be: one step, with a name of its own, that changes the scene.
fn one_step(window: &mut Window, what: &str, names: &[String], edit: impl Fn(&mut Window)) {
    let before = (window.steps(), window.stage().clone());
    edit(window);
    assert_eq!(window.steps(), before.0 + 1, "{what}");
    assert_ne!(*window.stage(), before.1, "{what}");
    let named = window.last_step();
    assert!(names.iter().any(|name| named.ends_with(name.as_str())), "{what}: {named}");
}

/// Presses a control as a screen reader does, wherever the panel is scrolled to.
fn press(window: &mut Window, role: Role, label: &str) {
    window.harness.get_by_role_and_label(role, label).click_accesskit();
    window.settle();
}

/// Opens a list and chooses a word of it.
fn choose(window: &mut Window, list: &str, word: &str) {
    press(window, Role::ComboBox, list);
    choose_entry(window, word);
}

/// Chooses a word of the list that is open.
fn choose_entry(window: &mut Window, word: &str) {
    // what was there before the list opened may be called alike
    let entries: Vec<_> = window.harness.query_all_by_role_and_label(Role::Button, word).collect();
    entries.last().unwrap_or_else(|| panic!("no entry {word}")).click_accesskit();
    window.settle();
}

/// Edits each attribute of a thing by its widget, a choice to each of its words; gives how many steps that took.
fn edit_all(window: &mut Window, item: &Item, rules: &[&'static ElementRule]) -> usize {
    let begin = window.steps();
    for rule in rules {
        for known in rule.attributes {
            if rule.name == "screen" && known.name == "up" {
                // one field with the eye's
                continue;
            }
            select(window, item);
            let label = attribute::label(Lang::English, rule.name, known.name);
            let what = format!("{item:?} {} {label}", rule.name);
            let names = [format!(": set {label}"), format!(": set {}", known.name)];
            let (role, field, text) = match known.kind {
                Kind::Color | Kind::Channels(..) | Kind::Length => (Role::SpinButton, label.to_owned(), "0.25 + 1/8"),
                Kind::Number(..) => (Role::SpinButton, label.to_owned(), "60"),
                Kind::Integer(..) => (Role::SpinButton, label.to_owned(), "5"),
                // in one line with the others it would be refused
                Kind::Point if known.name == "p2" => (Role::SpinButton, format!("{label} x"), "2"),
                Kind::Point | Kind::Factors => (Role::SpinButton, format!("{label} x"), "0.375"),
                Kind::Size => (Role::SpinButton, format!("{label} w"), "0.375"),
                Kind::Corners => (Role::SpinButton, format!("{label} BL x"), "-0.375"),
                FLAG => (Role::CheckBox, label.to_owned(), ""),
                Kind::Choice(_) => (Role::ComboBox, label.to_owned(), ""),
                Kind::Steps => (Role::CheckBox, "+ Shadows".to_owned(), ""),
                Kind::MaterialName => (Role::ComboBox, "Material".to_owned(), "red"),
                Kind::Name => (Role::TextInput, "name".to_owned(), ""),
                // the document's own matter: its version, its files, the facets of a part
                Kind::Version | Kind::Text | Kind::Path | Kind::Run => continue,
            };
            if window.harness.query_by_role_and_label(role, &field).is_none() {
                // attributes of another way to give a screen
                assert!(matches!(item, Item::View(_)) && ["eye", "screen"].contains(&rule.name), "no field for {what}");
                continue;
            }
            let mut edit = |what: &str, edit: &dyn Fn(&mut Window)| one_step(window, what, &names, edit);
            if let (Kind::Choice(words), Role::ComboBox) = (known.kind, role) {
                // all words, and the one that stands there last
                let shown = |word: &&str| attribute::choice(Lang::English, word).to_owned();
                let words: Vec<String> = words.iter().map(shown).collect();
                for word in words.iter().skip(1).chain(words.first()) {
                    edit(&format!("{what} {word}"), &|window| choose(window, &field, word));
                }
            } else if known.kind == Kind::Steps {
                for step in ["+ Shadows", "+ Reflection", "+ Transparency"] {
                    edit(step, &|window| press(window, role, step));
                }
            } else if known.kind == Kind::Name {
                let old = item.name().unwrap().to_string();
                let new = format!("{old} 2");
                for (from, to) in [(&old, &new), (&new, &old)] {
                    let names = [format!("Rename {from} to {to}")];
                    one_step(window, &what, &names, |window| type_as(window, role, &field, to));
                }
            } else if role == Role::CheckBox {
                edit(&what, &|window| press(window, role, &field));
            } else if role == Role::ComboBox {
                edit(&what, &|window| choose(window, &field, text));
            } else {
                edit(&what, &|window| type_into(window, &field, text));
            }
        }
    }
    window.steps() - begin
}

/// No attribute keeps its English name in a French window, but for those that are French too or signs.
#[test]
fn every_attribute_has_a_french_label() {
    const SAME: [&str; 16] = [
        "p0", "p1", "p2", "u", "v", "w", "ka", "kd", "ks", "kr", "kt", "base", "position", "rotation", "visible",
        "index",
    ];
    // what no field is labelled with: the editor has words of its own for it
    const WITHOUT_FIELD: [&str; 4] = ["version", "name", "first", "facets"];
    for rule in vocabulary::ELEMENTS {
        for known in rule.attributes {
            let [english, french] =
                [Lang::English, Lang::French].map(|lang| attribute::label(lang, rule.name, known.name));
            let is_same = SAME.contains(&known.name) || WITHOUT_FIELD.contains(&known.name);
            assert!(english != french || is_same, "{} @{}: {english}", rule.name, known.name);
        }
    }
}

#[test]
fn every_attribute_of_every_kind_is_edited() {
    let mut window = Window::new(everything(), Lang::English);
    // without panes nothing is rendered, which is another test's matter
    let ctx = window.harness.ctx.clone();
    for view in window.studio().shown() {
        window.harness.state_mut().perform(&ctx, Action::View(view.as_str().into(), ViewAction::Close));
    }
    // nor are the other panels needed
    window.press(Modifiers::NONE, Key::F9);
    window.press(Modifiers::NONE, Key::F10);
    assert!(window.harness.query_by_label("Filter by name").is_none(), "the outliner is hidden");
    let begin = window.stage().clone();
    let mut edited = edit_all(&mut window, &Item::World, &[&vocabulary::WORLD]);
    one_step(&mut window, "title", &["Set the title".to_owned()], |window| {
        type_as(window, Role::TextInput, "title", "Everything");
    });
    edited += 1 + edit_all(&mut window, &Item::Light("lamp".into()), &[&vocabulary::LIGHT]);
    edited += edit_all(&mut window, &Item::Material("red".into()), &[&vocabulary::MATERIAL]);
    let shapes = [
        &vocabulary::SPHERE,
        &vocabulary::PLANE,
        &vocabulary::FACET,
        &vocabulary::CUBE,
        &vocabulary::BOX,
        &vocabulary::MESH,
    ];
    for rule in shapes {
        edited += edit_all(&mut window, &Item::Object(rule.name.into()), &[rule]);
    }
    for name in ["by look-at", "by center", "by frame", "by corners"] {
        let rules = [&vocabulary::EYE, &vocabulary::SCREEN, &vocabulary::VIEW];
        edited += edit_all(&mut window, &Item::View(name.into()), &rules);
    }
    assert!(edited > 100, "{edited}");
    // undo to the start and redo to the end give the same
    let end = window.stage().clone();
    while window.steps() > 0 {
        window.harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        window.harness.step();
    }
    assert_eq!(*window.stage(), begin);
    for _ in 0..edited {
        window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
        window.harness.step();
    }
    assert_eq!(*window.stage(), end);
}

/// A view has the world's depth limit, or one of its own that begins there.
#[test]
fn a_view_takes_a_depth_of_its_own_and_gives_it_back() {
    let mut window = Window::new(stage(), Lang::English);
    select(&mut window, &Item::View("front".into()));
    press(&mut window, Role::CheckBox, "the world's");
    assert_eq!(window.stage().views[0].depth, Some(window.stage().scene.world.depth));
    type_into(&mut window, "depth", "2");
    press(&mut window, Role::Button, "Set depth to its default");
    assert_eq!(window.stage().views[0].depth, None);
    assert_eq!(window.steps(), 3);
}

/// An object's own surface, and the parts of a mesh.
#[test]
fn materials_are_chosen_where_they_are_used() {
    let mut stage = everything();
    let parts = lancer_document::attribute::edit_object(&stage, "mesh", |object| {
        if let Shape::Mesh(mesh) = &mut object.shape {
            let part = Part { material: MaterialRef::Default, first: 0, count: 1 };
            Arc::make_mut(&mut mesh.geometry).parts = vec![part];
        }
    });
    (stage, _) = stage.apply(&parts.unwrap()).unwrap();
    let mut window = Window::new(stage, Lang::English);
    select(&mut window, &Item::Object("sphere".into()));
    choose(&mut window, "Material", "its own");
    let inline = |window: &Window| match &window.object("sphere").unwrap().material {
        MaterialRef::Inline(surface) => Surface::clone(surface),
        MaterialRef::Default | MaterialRef::Named(_) => panic!("the sphere has no surface of its own"),
    };
    assert_eq!(inline(&window), Surface::default());
    type_into(&mut window, "Kr", "1/4");
    assert_eq!(inline(&window).kr, lancer_scene::Rgb::splat(0.25));
    choose(&mut window, "Material", "New material");
    assert_eq!(window.object("sphere").unwrap().material, MaterialRef::Named("material 1".into()));
    assert_eq!(window.stage().scene.materials[1].surface.kr, lancer_scene::Rgb::splat(0.25), "it begins as what was");

    select(&mut window, &Item::Object("mesh".into()));
    let lists: Vec<_> = window.harness.query_all_by_role_and_label(Role::ComboBox, "Material").collect();
    assert_eq!(lists.len(), 2, "the mesh's and its part's");
    lists[0].click_accesskit();
    window.settle();
    choose_entry(&mut window, "red");
    let Shape::Mesh(mesh) = &window.object("mesh").unwrap().shape.clone() else { panic!("no mesh") };
    assert_eq!(mesh.geometry.parts[0].material, MaterialRef::Named("red".into()));
}

fn text_of(window: &Window) -> String {
    let root = window.harness.root();
    let text = |node: &egui_kittest::Node<'_>| {
        let node = node.accesskit_node();
        node.label().or_else(|| node.value())
    };
    root.children_recursive().filter_map(|node| text(&node)).collect::<Vec<_>>().join("\n")
}

/// A click with the tab open explains the pixel; an edit changes what is told.
#[test]
fn a_click_explains_a_pixel() {
    let mut window = Window::new(stage(), Lang::English);
    window.press(Modifiers::COMMAND, Key::Num3);
    let place = window.place("front", DVec3::new(-0.8, 0.5, 0.5));
    window.click_at(place, Modifiers::NONE);
    window.harness.step();
    window.settle();
    let told = text_of(&window);
    assert!(told.contains("primary ray → `red`") && told.contains("meets sphere `red`"), "{told}");
    // the arithmetic can be read in French as well
    window.click("Passer en français");
    let told = text_of(&window);
    assert!(told.contains("rayon primaire → « red »") && told.contains("rencontre la sphère"), "{told}");
    // an edit is followed
    let ctx = window.harness.ctx.clone();
    let hidden = lancer_document::arrange::shown(window.stage(), [&Item::Object("red".into())], false).unwrap();
    window.harness.state_mut().perform(&ctx, Action::Run(hidden));
    window.settle();
    let told = text_of(&window);
    assert!(!told.contains("rayon primaire → « red »") && told.contains("rayon primaire"), "{told}");
}

/// The document is shown as it would be saved: with its comment, and with what has changed.
#[test]
fn the_document_is_shown_as_it_would_be_saved() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("one.xml");
    let text = "<!-- kept -->\n<scene version=\"1\" name=\"One\">\n  <light position=\"0 5 0\"/>\n</scene>\n";
    std::fs::write(&path, text).unwrap();
    let mut window = Window::opening(stage(), Lang::English, vec![path]);
    window.until("the scene", |studio| studio.document().stage().scene.name == "One");
    window.menu("Add", "Sphere");
    let ctx = window.harness.ctx.clone();
    window.harness.state_mut().perform(&ctx, Action::ShowTab(Tab::Xml));
    window.settle();
    let shown = text_of(&window);
    assert!(shown.contains("<!-- kept -->") && shown.contains("<sphere name=\"sphere 1\""), "{shown}");
    let due = String::from_utf8(window.studio().document().scene_text()).unwrap();
    assert!(due.lines().filter(|line| !line.trim().is_empty()).all(|line| shown.contains(line)), "{shown}");
}

/// What a format cannot hold is said before the file is written.
#[test]
fn an_export_says_what_it_loses() {
    let exports = [
        ("Scene for POV-Ray (.pov)…", "POV-Ray cannot hold everything", "one.pov", "camera"),
        ("Objects as OBJ (.obj)…", "OBJ cannot hold everything", "one.obj", "mtllib one.mtl"),
        ("Objects as glTF (.gltf)…", "glTF cannot hold everything", "one.gltf", "\"asset\""),
        ("Objects as binary glTF (.glb)…", "glTF cannot hold everything", "one.glb", "glTF"),
        ("Scene in the format of 2009 (.xml)…", "The format of 2009 cannot hold everything", "one-2009.xml", "<Scene"),
    ];
    let folder = tempfile::tempdir().unwrap();
    let mut window = Window::new(stage(), Lang::English);
    for (entry, title, name, due) in exports {
        let path = folder.path().join(name);
        window.click("File");
        window.menu("Export", entry);
        window.until("the list", |_| true);
        window.settle();
        let told = text_of(&window);
        assert!(told.contains(title), "{told}");
        window.dialogs.asked.borrow_mut().clear();
        window.dialogs.replies.borrow_mut().push_back(Reply::Chosen(path.clone()));
        window.click("Export…");
        let begun = std::time::Instant::now();
        while !path.is_file() {
            assert!(begun.elapsed().as_secs() < 60, "nothing is written: {}", text_of(&window));
            window.harness.step();
        }
        window.settle();
        let bytes = std::fs::read(&path).unwrap();
        assert!(String::from_utf8_lossy(&bytes).contains(due), "{name}");
    }
    assert!(std::fs::read_to_string(folder.path().join("one.mtl")).unwrap().contains("newmtl"));
    assert_eq!(window.studio().document().scene_path(), None, "an export is no save");
}

/// Where nothing is lost, nothing is said.
#[test]
fn an_export_without_losses_asks_where_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sum.pov");
    let mut stage = stage();
    stage.scene.world.compose = lancer_scene::Compose::Add;
    let mut window = Window::new(stage, Lang::French);
    window.dialogs.replies.borrow_mut().push_back(Reply::Chosen(path.clone()));
    window.click("Fichier");
    window.menu("Exporter", "Scène pour POV-Ray (.pov)…");
    let begun = std::time::Instant::now();
    while !path.is_file() {
        assert!(begun.elapsed().as_secs() < 60, "nothing is written: {}", text_of(&window));
        window.harness.step();
    }
    window.settle();
    assert!(std::fs::read_to_string(&path).unwrap().contains("camera"));
    assert_eq!(window.dialogs.asked.borrow()[0].title, "Exporter : Scène pour POV-Ray (.pov)");
}

/// The values of a material that is shared stand below each object that has it.
#[test]
fn a_shared_material_is_edited_where_it_is_used() {
    let mut stage = everything();
    for name in ["sphere", "cube"] {
        let edit = lancer_document::attribute::edit_object(&stage, name, |object| {
            object.material = MaterialRef::Named("red".into());
        });
        (stage, _) = stage.apply(&edit.unwrap()).unwrap();
    }
    let mut window = Window::new(stage, Lang::English);
    select(&mut window, &Item::Object("cube".into()));
    assert!(text_of(&window).contains("shared by 2 objects"));
    type_into(&mut window, "Kr", "1/4");
    assert_eq!(window.stage().scene.materials[0].surface.kr, lancer_scene::Rgb::splat(0.25));
    assert_eq!(window.last_step(), "red: set Kr");
}
