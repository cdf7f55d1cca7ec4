//! Gestures, undo and redo, and a selection that follows.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

#[path = "../../scene/tests/arbitrary/mod.rs"]
mod arbitrary;

use arbitrary::stage;
use lancer_document::gizmo::{moved, place_of, translated};
use lancer_document::insert::{NewItem, Standpoint};
use lancer_document::{Document, Item, StepName, attribute};
use lancer_scene::{DVec3, EditError, Invalid, Object, PointLight, Rgb, Shape, Stage, Surface};
use lancer_words::Lang;
use proptest::prelude::*;

fn sphere(name: &str) -> Object {
    Object::new(name, Shape::Sphere { center: DVec3::ZERO, radius: 1.0 })
}

fn small() -> Stage {
    let mut stage = Stage::default();
    stage.scene.objects = ["ball", "egg", "pea"].into_iter().map(sphere).collect();
    stage.scene.lights = [PointLight::new("lamp", DVec3::Y)].into_iter().collect();
    stage
}

fn document() -> Document {
    Document::new(StepName::Opened, small())
}

fn ball() -> Item {
    Item::Object("ball".into())
}

fn place(document: &Document) -> DVec3 {
    place_of(document.stage(), &Item::Object(document.stage().scene.objects[0].name.clone())).unwrap()
}

#[test]
fn one_drag_is_one_step() {
    let mut document = document();
    document.begin(StepName::Moved("ball".into()));
    for step in 1..=10 {
        let (_, edit) = moved(document.base(), [&ball()], DVec3::X * f64::from(step)).unwrap();
        document.preview(&edit).unwrap();
    }
    assert!(document.in_gesture());
    assert_eq!(document.history().names().len(), 1);
    document.commit();
    assert_eq!(place(&document), DVec3::X * 10.0);
    assert_eq!(document.history().names().len(), 2);
    assert!(document.undo());
    assert_eq!(document.stage(), &small());
    assert!(document.redo());
    assert_eq!(place(&document), DVec3::X * 10.0);
}

#[test]
fn a_cancelled_drag_leaves_nothing() {
    let mut document = document();
    let (_, edit) = moved(document.stage(), [&ball()], DVec3::X).unwrap();
    document.begin(StepName::Moved("ball".into()));
    document.preview(&edit).unwrap();
    let revision = document.revision();
    document.cancel();
    assert_eq!(document.stage(), &small());
    assert_eq!(document.history().names().len(), 1);
    assert!(document.revision() > revision, "whoever shows the drag must hear of its end");
    assert!(!document.in_gesture());
}

#[test]
fn a_drag_that_comes_back_is_no_step_and_an_impossible_preview_changes_nothing() {
    let mut document = document();
    document.begin(StepName::Moved("ball".into()));
    let (_, there) = moved(document.base(), [&ball()], DVec3::X).unwrap();
    document.preview(&there).unwrap();
    let (_, outside) = moved(document.base(), [&ball()], DVec3::X * 2e9).unwrap();
    assert!(matches!(document.preview(&outside), Err(EditError::Invalid(Invalid::OutOfRange { .. }))));
    assert_eq!(place(&document), DVec3::X);
    let (_, back) = moved(document.base(), [&ball()], DVec3::ZERO).unwrap();
    document.preview(&back).unwrap();
    document.commit();
    assert_eq!(document.history().names().len(), 1);
}

#[test]
fn another_edit_ends_a_gesture_first() {
    let mut document = document();
    document.begin(StepName::Moved("ball".into()));
    let (_, edit) = moved(document.base(), [&ball()], DVec3::X).unwrap();
    document.preview(&edit).unwrap();
    document.rename(&ball(), "sun").unwrap();
    let names: Vec<String> = document.history().names().map(|name| name.text(Lang::English)).collect();
    assert_eq!(names, ["Open", "Move ball", "Rename ball to sun"]);
    assert_eq!(place(&document), DVec3::X);
    document.begin(StepName::Moved("sun".into()));
    assert!(document.undo(), "a gesture without movement is no step");
    assert_eq!(&*document.stage().scene.objects[0].name, "ball");
}

#[test]
fn an_edit_that_changes_nothing_is_no_step() {
    let mut document = document();
    let revision = document.revision();
    let edit = attribute::edit_object(document.stage(), "ball", |_| {}).unwrap();
    document.apply(attribute::set(&ball(), "radius"), &edit).unwrap();
    assert_eq!(document.history().names().len(), 1);
    assert_eq!(document.revision(), revision);
    assert_eq!(attribute::edit_object(document.stage(), "moon", |_| {}), None);
}

#[test]
fn a_new_step_forgets_what_was_undone() {
    let mut document = document();
    document.rename(&ball(), "a").unwrap();
    document.undo();
    document.rename(&ball(), "b").unwrap();
    assert!(!document.redo());
    assert_eq!(document.history().undoable().unwrap().text(Lang::French), "Renommage de ball en b");
    assert_eq!(document.history().redoable(), None);
}

#[test]
fn the_selection_follows_names_back_and_forth() {
    let mut document = document();
    document.select(|selection| selection.set([ball(), Item::Light("lamp".into())]));
    document.rename(&ball(), "sun").unwrap();
    document.rename(&Item::Object("sun".into()), "star").unwrap();
    document.rename(&Item::Light("lamp".into()), "bulb").unwrap();
    let selected = |document: &Document| {
        document.selection().iter().map(|item| item.name().unwrap().to_string()).collect::<Vec<_>>()
    };
    assert_eq!(selected(&document), ["star", "bulb"]);
    document.jump(0);
    assert_eq!(selected(&document), ["ball", "lamp"]);
    document.jump(3);
    assert_eq!(selected(&document), ["star", "bulb"]);
}

#[test]
fn the_selection_forgets_what_is_gone() {
    let mut document = document();
    document.select(|selection| selection.set([ball(), Item::Object("pea".into()), Item::World]));
    assert!(document.delete_selected().unwrap());
    assert_eq!(document.selection().iter().collect::<Vec<_>>(), [&Item::World]);
    assert_eq!(document.stage().scene.objects.len(), 1);
    // its name in the same place of a longer list is another thing
    document.select(|selection| selection.set([Item::Object("egg".into())]));
    document.undo();
    assert_eq!(document.selection().primary(), Some(&Item::Object("egg".into())));
}

#[test]
fn a_taken_or_empty_name_is_refused_and_says_why() {
    let mut document = document();
    let taken = document.rename(&ball(), " lamp ").unwrap_err();
    assert_eq!(taken.to_string(), "the name `lamp` is taken");
    assert!(document.rename(&ball(), "  ").is_err());
    assert!(!document.rename(&ball(), " ball ").unwrap(), "its own name is nothing new");
    assert_eq!(document.history().names().len(), 1);
}

/// What a user does, by numbers.
#[derive(Clone, Debug)]
enum Act {
    Add(u8),
    Select(Vec<prop::sample::Index>),
    Delete,
    Duplicate,
    Rename(prop::sample::Index, String),
    Reorder(prop::sample::Index, usize),
    Show(bool),
    Move(i8, bool),
    Undo,
    Redo,
    Jump(prop::sample::Index),
}

fn act() -> impl Strategy<Value = Act> {
    use prop::sample::Index;
    prop_oneof![
        3 => (0..9_u8).prop_map(Act::Add),
        4 => prop::collection::vec(any::<Index>(), 0..4).prop_map(Act::Select),
        1 => Just(Act::Delete),
        2 => Just(Act::Duplicate),
        2 => (any::<Index>(), "[a-c ]{0,2}").prop_map(|(item, name)| Act::Rename(item, name)),
        1 => (any::<Index>(), 0..9_usize).prop_map(|(item, to)| Act::Reorder(item, to)),
        1 => any::<bool>().prop_map(Act::Show),
        2 => (any::<i8>(), any::<bool>()).prop_map(|(by, keep)| Act::Move(by, keep)),
        1 => Just(Act::Undo),
        1 => Just(Act::Redo),
        1 => any::<Index>().prop_map(Act::Jump),
    ]
}

/// Everything that can be selected.
fn items(stage: &Stage) -> Vec<Item> {
    let scene = &stage.scene;
    let objects = scene.objects.iter().map(|object| Item::Object(object.name.clone()));
    let lights = scene.lights.iter().map(|light| Item::Light(light.name.clone()));
    let materials = scene.materials.iter().map(|material| Item::Material(material.name.clone()));
    let views = stage.views.iter().map(|view| Item::View(view.name.clone()));
    std::iter::once(Item::World).chain(objects).chain(lights).chain(materials).chain(views).collect()
}

fn new_item(kind: u8) -> NewItem {
    match kind {
        0 => NewItem::Sphere,
        1 => NewItem::Plane,
        2 => NewItem::Facet,
        3 => NewItem::Cube,
        4 => NewItem::Parallelepiped,
        5 => NewItem::Light,
        6 => NewItem::Material { stem: String::new(), surface: Surface::default() },
        7 => NewItem::Material { stem: "red".into(), surface: Surface { kd: Rgb::splat(0.1), ..Surface::default() } },
        _ => NewItem::View(None),
    }
}

fn play(document: &mut Document, act: &Act) {
    match act {
        Act::Add(kind) => {
            let view = document.stage().views.first().cloned();
            let at = view.map_or_else(Standpoint::default, |view| Standpoint::of(&view, &document.stage().scene, None));
            document.add(new_item(*kind), &at).unwrap();
            assert!(document.selection().primary().is_some_and(|item| item.exists(document.stage())));
        }
        Act::Select(chosen) => {
            let all = items(document.stage());
            let chosen: Vec<Item> = chosen.iter().map(|index| index.get(&all).clone()).collect();
            document.select(|selection| selection.set(chosen));
        }
        Act::Delete => drop(document.delete_selected().unwrap()),
        Act::Duplicate => drop(document.duplicate_selected().unwrap()),
        Act::Rename(index, name) => {
            let all = items(document.stage());
            // taken and empty names are refused
            let _ = document.rename(index.get(&all), name);
        }
        Act::Reorder(index, to) => {
            let all = items(document.stage());
            document.reorder(index.get(&all), *to).unwrap();
        }
        Act::Show(visible) => drop(document.show_selected(*visible).unwrap()),
        Act::Move(by, keep) => {
            let items: Vec<Item> = document.selection().iter().cloned().collect();
            let Some((name, edit)) = moved(document.stage(), &items, DVec3::splat(f64::from(*by))) else { return };
            document.begin(name);
            // what would leave the range of coordinates is refused
            let _ = document.preview(&edit);
            if *keep { document.commit() } else { document.cancel() }
        }
        Act::Undo => drop(document.undo()),
        Act::Redo => drop(document.redo()),
        Act::Jump(index) => {
            let step = index.index(document.history().names().len());
            assert!(document.jump(step));
        }
    }
}

proptest! {
    /// Whatever is done, the stage stays legal; undo to the start and redo to the end give equal stages; the history
    /// holds every stage as it was.
    #[test]
    fn everything_can_be_undone_and_redone(start in stage(), acts in prop::collection::vec(act(), 0..24)) {
        let mut document = Document::new(StepName::Opened, start.clone());
        for act in &acts {
            play(&mut document, act);
            let stage = document.stage();
            prop_assert_eq!(stage.scene.check(), Ok(()), "{:?}", act);
            for view in &stage.views {
                prop_assert_eq!(view.check(), Ok(()));
            }
            prop_assert!(document.selection().iter().all(|item| item.exists(stage)), "{:?}", act);
            prop_assert_eq!(document.history().stage(document.history().current()), Some(stage));
        }
        while document.redo() {}
        let end = document.stage().clone();
        while document.undo() {}
        prop_assert_eq!(document.stage(), &start);
        while document.redo() {}
        prop_assert_eq!(document.stage(), &end);
    }

    /// Moving there and back gives the object itself, as far as coordinates can say.
    #[test]
    fn a_translation_keeps_the_shape(stage in stage(), by in [-100.0..100.0_f64, -100.0..100.0, -100.0..100.0]) {
        let by = DVec3::from(by);
        for object in &stage.scene.objects {
            let there = translated(object, by);
            let (Some(before), Some(after)) = (object.shape.bounds(), there.shape.bounds()) else { continue };
            let scale = before.0.abs().max(before.1.abs()).max_element().max(100.0);
            prop_assert!((after.0 - before.0 - by).abs().max_element() <= 1e-11 * scale, "{:?}", object);
            prop_assert!((after.1 - before.1 - by).abs().max_element() <= 1e-11 * scale, "{:?}", object);
            prop_assert_eq!(&translated(object, DVec3::ZERO), &**object);
        }
    }
}
