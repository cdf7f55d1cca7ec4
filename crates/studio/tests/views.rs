//! Views: every edit is seen in all of them, and what pointer and keys do in one.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test")]

mod window;

use egui::{Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, TouchPhase, Vec2};
use egui_kittest::kittest::Queryable;
use lancer_document::Item;
use lancer_scene::generate::Family;
use lancer_scene::{DVec3, PointLight, Stage};
use lancer_studio::{Action, ViewAction};
use lancer_words::Lang;
use std::hash::{Hash, Hasher};
use window::{Window, stage};

fn window() -> Window {
    Window::new(stage(), Lang::English)
}

/// The picture of a view, such that two are compared without printing them.
fn bytes(window: &Window, view: &str) -> u64 {
    let mut hasher = std::hash::DefaultHasher::new();
    window.studio().live(view).unwrap().session().image().bytes().hash(&mut hasher);
    hasher.finish()
}

#[test]
fn two_views_are_rendered_at_the_size_of_their_panes() {
    let window = window();
    for view in ["front", "high"] {
        let [width, height] = window.studio().live(view).unwrap().size();
        assert!(width > 200 && height > 150, "{width}×{height}");

        assert!(window.studio().live(view).unwrap().session().is_finished());
    }
}

#[test]
fn a_click_selects_and_one_edit_repaints_both_views() {
    let mut window = window();
    let (front, high) = (bytes(&window, "front"), bytes(&window, "high"));
    let place = window.place("front", DVec3::new(-0.8, 0.5, 0.5));
    window.click_at(place, Modifiers::NONE);
    assert_eq!(window.selected(), [Item::Object("red".into())]);
    window.press(Modifiers::NONE, Key::Delete);
    assert!(window.object("red").is_none());
    assert_ne!(bytes(&window, "front"), front);
    assert_ne!(bytes(&window, "high"), high);
    window.press(Modifiers::COMMAND, Key::Z);
    assert_eq!(bytes(&window, "front"), front);
    assert_eq!(bytes(&window, "high"), high);
}

/// A click on a scene that takes long to compile is answered as soon as it is.
#[test]
fn the_first_click_is_not_lost() {
    let (scene, view) = Family::Field.generate(400).unwrap();
    let (name, view, views) = (scene.objects[0].name.clone(), view.name.to_string(), std::iter::once(view).collect());
    let stage = Stage { scene, views };
    let mut window = Window::just_begun(stage);
    let place = window.picture(&view).center() + Vec2::new(0.0, 40.0);
    window.event(Event::PointerMoved(place));
    window.button(place, PointerButton::Primary, true, Modifiers::NONE);
    window.button(place, PointerButton::Primary, false, Modifiers::NONE);
    window
        .until("the selection", |studio| studio.document().selection().primary() == Some(&Item::Object(name.clone())));
}

#[test]
fn shift_and_click_adds_to_the_selection_and_the_background_clears_it() {
    let mut window = window();
    let [red, blue] = [-0.8, 0.8].map(|x| window.place("front", DVec3::new(x, 0.5, 0.5)));
    window.click_at(red, Modifiers::NONE);
    window.click_at(blue, Modifiers::SHIFT);
    assert_eq!(window.selected(), [Item::Object("red".into()), Item::Object("blue".into())]);
    window.click_at(red, Modifiers::SHIFT);
    assert_eq!(window.selected(), [Item::Object("blue".into())]);
    let sky = window.picture("front").center_top() + Vec2::new(0.0, 4.0);
    window.click_at(sky, Modifiers::NONE);
    assert_eq!(window.selected(), []);
}

#[test]
fn dragging_a_selected_object_moves_it_in_the_views_plane_as_one_step() {
    let mut window = window();
    let red = window.place("front", DVec3::new(-0.8, 0.5, 0.5));
    window.click_at(red, Modifiers::NONE);
    let steps = window.steps();
    let to = red + Vec2::new(60.0, -30.0);
    window.drag(red, to, PointerButton::Primary, Modifiers::NONE);
    assert_ne!(window.center("red"), DVec3::new(-0.8, 0.5, 0.0), "it moves while it is dragged");
    window.drop_at(to, PointerButton::Primary);
    assert_eq!((window.steps(), window.last_step().as_str()), (steps + 1, "Move red"));
    let by = window.center("red") - DVec3::new(-0.8, 0.5, 0.0);
    assert!(by.x > 0.3 && by.y > 0.1, "{by}");
    // the front view looks a little down, so its plane leans
    assert!(by.z.abs() < 0.1, "{by}");
    window.press(Modifiers::COMMAND, Key::Z);
    assert_eq!(window.center("red"), DVec3::new(-0.8, 0.5, 0.0));
}

#[test]
fn with_the_grid_a_lamp_can_be_clicked_and_dragged() {
    let mut stage = stage();
    stage.scene.lights = [PointLight::new("lamp", DVec3::new(1.0, 2.0, 0.0))].into_iter().collect();
    let mut window = Window::new(stage, Lang::English);
    window.press(Modifiers::NONE, Key::G);
    let lamp = window.place("front", DVec3::new(1.0, 2.0, 0.0));
    window.click_at(lamp, Modifiers::NONE);
    assert_eq!(window.selected(), [Item::Light("lamp".into())]);
    let to = lamp + Vec2::new(-40.0, 0.0);
    window.drag(lamp, to, PointerButton::Primary, Modifiers::NONE);
    window.drop_at(to, PointerButton::Primary);
    assert_eq!(window.last_step(), "Move lamp");
    assert!(window.stage().scene.lights[0].position.x < 0.8);
}

/// The pointer need not rest on an object before the button goes down.
#[test]
fn a_quick_press_grabs_what_is_under_it() {
    let mut window = window();
    window.click("red");
    let red = window.place("front", DVec3::new(-0.6, 0.7, 0.4));
    window.event(Event::PointerMoved(red));
    window.button(red, PointerButton::Primary, true, Modifiers::NONE);
    for step in 1..=8 {
        window.event(Event::PointerMoved(red + Vec2::new(8.0, 0.0) * step as f32));
        window.wait();
    }
    window.drop_at(red + Vec2::new(64.0, 0.0), PointerButton::Primary);
    assert_eq!(window.last_step(), "Move red");
}

#[test]
fn a_held_axis_holds_and_escape_takes_the_drag_back() {
    let mut window = window();
    let red = window.place("front", DVec3::new(-0.8, 0.5, 0.5));
    window.click_at(red, Modifiers::NONE);
    let to = red + Vec2::new(60.0, -40.0);
    window.drag(red, to, PointerButton::Primary, Modifiers::NONE);
    window.harness.key_press(Key::X);
    window.wait();
    let by = window.center("red") - DVec3::new(-0.8, 0.5, 0.0);
    assert!(by.x > 0.3 && by.y == 0.0 && by.z == 0.0, "{by}");
    window.harness.key_press(Key::Escape);
    window.wait();
    assert_eq!(window.center("red"), DVec3::new(-0.8, 0.5, 0.0));
    window.drop_at(to, PointerButton::Primary);
    assert_eq!((window.center("red"), window.steps()), (DVec3::new(-0.8, 0.5, 0.0), 0));
}

#[test]
fn the_right_button_turns_and_the_middle_one_shifts() {
    let mut window = window();
    let (eye, place) = (window.eye("front"), window.picture("front").center());
    window.drag(place, place + Vec2::new(80.0, 0.0), PointerButton::Secondary, Modifiers::NONE);
    window.drop_at(place + Vec2::new(80.0, 0.0), PointerButton::Secondary);
    let turned = window.eye("front");
    assert!((turned.y - eye.y).abs() < 1e-6 && (turned.x - eye.x).abs() > 0.5, "{eye} {turned}");
    assert_eq!((window.steps(), window.last_step().as_str()), (1, "Move the eye of front"));
    window.drag(place, place + Vec2::new(0.0, 40.0), PointerButton::Middle, Modifiers::NONE);
    window.drop_at(place + Vec2::new(0.0, 40.0), PointerButton::Middle);
    assert!(window.eye("front").y > turned.y, "what is seen goes down, so the eye goes up");
    assert_eq!(window.steps(), 2);
}

#[test]
fn a_drag_beside_what_is_selected_turns_the_view() {
    let mut window = window();
    let sky = window.picture("front").center_top() + Vec2::new(0.0, 4.0);
    let eye = window.eye("front");
    window.drag(sky, sky + Vec2::new(60.0, 0.0), PointerButton::Primary, Modifiers::NONE);
    window.drop_at(sky + Vec2::new(60.0, 0.0), PointerButton::Primary);
    assert_ne!(window.eye("front"), eye);
    assert_eq!(window.steps(), 1);
}

#[test]
fn the_wheel_goes_nearer_and_is_one_step_once_it_rests() {
    let mut window = window();
    let (eye, place) = (window.eye("front"), window.picture("front").center());
    window.event(Event::PointerMoved(place));
    for _ in 0..5 {
        let delta = Vec2::new(0.0, 20.0);
        let (unit, phase, source, modifiers) =
            (MouseWheelUnit::Point, TouchPhase::Move, MouseWheelSource::Wheel, Modifiers::NONE);
        window.event(Event::MouseWheel { unit, delta, phase, source, modifiers });
    }
    window.until("the end of the wheel", |studio| {
        !studio.document().in_gesture() && studio.document().history().current() > 0
    });
    assert!(window.eye("front").length() < eye.length());
    assert_eq!(window.steps(), 1);
}

#[test]
fn the_arrow_keys_turn_the_view_that_has_the_focus() {
    let mut window = window();
    let eye = window.eye("high");
    window.harness.get_by_label("Picture of high").focus();
    window.wait();
    window.press(Modifiers::NONE, Key::ArrowRight);
    window.until("the step", |studio| studio.document().history().current() == 1);
    assert_ne!(window.eye("high"), eye);
}

#[test]
fn a_marked_rectangle_is_kept_and_the_picture_is_the_same_in_the_end() {
    let mut window = window();
    let whole = bytes(&window, "front");
    let rect = window.picture("front");
    window.drag(rect.center(), rect.center() + Vec2::new(50.0, 30.0), PointerButton::Primary, Modifiers::COMMAND);
    window.drop_at(rect.center() + Vec2::new(50.0, 30.0), PointerButton::Primary);
    let region = window.studio().live("front").unwrap().region().unwrap();
    assert!((48..=53).contains(&region.width) && (28..=33).contains(&region.height), "{region:?}");
    assert_eq!(bytes(&window, "front"), whole);
    assert_eq!(window.steps(), 0);
}

#[test]
fn sides_and_framing_are_steps() {
    let mut window = window();
    window.press(Modifiers::NONE, Key::Num7);
    let eye = window.eye("front");
    assert!(eye.y > 3.0 && eye.x.abs() < 1e-6, "{eye}");
    window.menu("View", "Frame the selection");
    assert_eq!(window.steps(), 2);
}

#[test]
fn panes_split_close_and_come_back() {
    let mut window = window();
    window.menu("View", "New view on the right");
    assert_eq!(window.stage().views.len(), 3);
    assert_eq!(window.studio().shown(), ["front", "view 1", "high"]);
    window.click("Close view pane · high");
    assert_eq!(window.studio().shown(), ["front", "view 1"]);
    assert_eq!(window.stage().views.len(), 3, "the view stays in the document");
    window.press(Modifiers::COMMAND, Key::Z);
    assert_eq!(window.studio().shown(), ["front"], "the split is taken back");
}

/// Four views that are shown one after the other stand in two rows and two columns.
#[test]
fn a_view_is_shown_where_there_is_most_room() {
    let mut stage = stage();
    let more = ["third", "fourth"].map(|name| window::view(name, DVec3::new(1.0, 1.0, 5.0)));
    stage.views = stage.views.iter().map(|view| lancer_scene::View::clone(view)).chain(more).collect();
    let mut window = Window::new(stage, Lang::English);
    // without panels the panes are wide
    window.press(Modifiers::NONE, Key::F10);
    let ctx = window.harness.ctx.clone();
    for name in ["high", "third", "fourth"] {
        window.harness.state_mut().perform(&ctx, Action::View(name.into(), ViewAction::Show));
        window.settle();
    }
    let rects = ["front", "high", "third", "fourth"]
        .map(|name| window.harness.get_by_label(&format!("Picture of {name}")).rect());
    assert!(rects.iter().all(|rect| (rect.area() / rects[0].area() - 1.0).abs() < 0.2), "{rects:?}");
    // of two equal panes the first is cut first
    let [front, high, third, fourth] = rects.map(|rect| rect.center());
    assert!(
        third.distance(front) < third.distance(high) && fourth.distance(high) < fourth.distance(front),
        "{rects:?}"
    );
}

#[test]
fn a_renamed_view_keeps_its_pane() {
    let mut window = window();
    window.press(Modifiers::COMMAND, Key::D);
    assert_eq!(window.steps(), 0, "nothing is selected");
    assert_eq!(window.studio().shown(), ["front", "high"]);
}

#[test]
fn paused_views_wait() {
    let mut window = window();
    window.menu("Render", "Pause");
    window.harness.key_press_modifiers(Modifiers::NONE, Key::F5);
    window.wait();
    let session = window.studio().live("front").unwrap().session();
    assert!(session.status().paused && !session.is_finished());
    window.harness.key_press(Key::P);
    window.settle();
}
