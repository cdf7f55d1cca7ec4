//! The panels: every attribute of every kind of thing, the documents, the explanation of a pixel, the export to 2009.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test")]

mod window;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use lancer_document::{Item, Selection};
use lancer_formats::xml::vocabulary::{self, ElementRule, Kind};
use lancer_scene::{
    DVec3, List, Material, MaterialRef, Mesh, MeshGeometry, Object, Placement, PointLight, Shape, Stage, Surface,
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

/// Types over what stands in a field.
fn type_into(window: &mut Window, label: &str, text: &str) {
    window.harness.get_by_role_and_label(Role::SpinButton, label).focus();
    window.harness.step();
    window.harness.step();
    window.press(Modifiers::COMMAND, Key::A);
    window.harness.event(Event::Text(text.to_owned()));
    window.harness.step();
    window.press(Modifiers::NONE, Key::Enter);
}

/// Edits each attribute of a thing by its widget; each is one step with the attribute's name.
fn edit_all(window: &mut Window, item: &Item, rules: &[&'static ElementRule]) -> usize {
    let mut edited = 0;
    for rule in rules {
        for known in rule.attributes {
            if rule.name == "screen" && known.name == "up" {
                // one field with the eye's
                continue;
            }
            select(window, item);
            let label = attribute::label(Lang::English, rule.name, known.name);
            let (field, text) = match known.kind {
                Kind::Color | Kind::Channels(..) | Kind::Length => (label.to_owned(), "0.25 + 1/8"),
                Kind::Number(..) => (label.to_owned(), "60"),
                Kind::Integer(..) => (label.to_owned(), "5"),
                // in one line with the others it would be refused
                Kind::Point if known.name == "p2" => (format!("{label} x"), "2"),
                Kind::Point | Kind::Factors => (format!("{label} x"), "0.375"),
                Kind::Size => (format!("{label} w"), "0.375"),
                Kind::Corners => (format!("{label} BL x"), "-0.375"),
                Kind::Choice(_) | Kind::Steps => continue,
                Kind::Version | Kind::Text | Kind::Name | Kind::MaterialName | Kind::Path | Kind::Run => continue,
            };
            if window.harness.query_by_role_and_label(Role::SpinButton, &field).is_none() {
                // attributes of another way to give a screen, and switches
                assert!(matches!(item, Item::View(_)) || known.name == "visible" || known.name == "smooth", "{field}");
                continue;
            }
            let before = (window.steps(), window.stage().clone());
            type_into(window, &field, text);
            assert_eq!(window.steps(), before.0 + 1, "{item:?} {field}");
            assert_ne!(*window.stage(), before.1, "{item:?} {field}");
            let named = window.last_step();
            assert!(
                named.ends_with(&format!(": set {label}")) || named.ends_with(&format!(": set {}", known.name)),
                "{named}"
            );
            edited += 1;
        }
    }
    edited
}

#[test]
fn every_attribute_of_every_kind_is_edited() {
    let mut window = Window::new(everything(), Lang::English);
    // without panes nothing is rendered, which is another test's matter
    let ctx = window.harness.ctx.clone();
    for view in window.studio().shown() {
        window.harness.state_mut().perform(&ctx, Action::View(view.as_str().into(), ViewAction::Close));
    }
    let begin = window.stage().clone();
    let mut edited = edit_all(&mut window, &Item::World, &[&vocabulary::WORLD]);
    edited += edit_all(&mut window, &Item::Light("lamp".into()), &[&vocabulary::LIGHT]);
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
    assert!(edited > 50, "{edited}");
    // undo to the start and redo to the end give the same
    let end = window.stage().clone();
    while window.steps() > 0 {
        window.press(Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(*window.stage(), begin);
    for _ in 0..edited {
        window.press(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    }
    assert_eq!(*window.stage(), end);
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

/// What the format of 2009 cannot hold is said before the file is written.
#[test]
fn an_export_to_2009_says_what_it_loses() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("old.xml");
    let mut window = Window::new(stage(), Lang::English);
    window.menu("File", "Export the scene (2009)…");
    window.until("the list", |_| true);
    window.settle();
    let told = text_of(&window);
    assert!(told.contains("The format of 2009 cannot hold everything"), "{told}");
    window.dialogs.replies.borrow_mut().push_back(Reply::Chosen(path.clone()));
    window.click("Export…");
    let begun = std::time::Instant::now();
    while !path.is_file() {
        assert!(begun.elapsed().as_secs() < 60, "nothing is written");
        window.harness.step();
    }
    window.settle();
    assert!(std::fs::read_to_string(&path).unwrap().contains("<Scene"));
    assert_eq!(window.studio().document().scene_path(), None, "an export is no save");
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
