//! A window without a display, and what tests do with it.
#![allow(
    dead_code,
    unreachable_pub,
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests; not every test needs each of them"
)]

use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use lancer_document::Item;
use lancer_render::Tracing;
use lancer_scene::{
    DVec3, Environment, List, MaterialRef, Object, PointLight, Rgb, Scene, ScreenSpec, Shape, Stage, Steps, Surface,
    View,
};
use lancer_studio::dialogs::{Dialogs, Reply, Request};
use lancer_studio::settings::Settings;
use lancer_studio::{Start, Studio};
use lancer_words::Lang;
use std::cell::RefCell;
use std::collections::VecDeque;
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Dialogs that answer what the test says.
#[derive(Clone, Default)]
pub struct Scripted {
    pub replies: Rc<RefCell<VecDeque<Reply>>>,
    pub asked: Rc<RefCell<Vec<Request>>>,
}

impl Dialogs for Scripted {
    fn ask(&mut self, request: &Request) {
        self.asked.borrow_mut().push(request.clone());
    }
    fn poll(&mut self) -> Option<Reply> {
        if self.asked.borrow().is_empty() { None } else { self.replies.borrow_mut().pop_front() }
    }
}

/// The window under test.
pub struct Window {
    pub harness: Harness<'static, Studio>,
    pub dialogs: Scripted,
}

/// A red ball and a blue one on a floor, seen from the front and from above.
pub fn stage() -> Stage {
    let color = |r, g, b| {
        let kd = Rgb::new(r, g, b);
        MaterialRef::Inline(Arc::new(Surface { ka: kd, kd, ..Surface::default() }))
    };
    let ball = |x: f64| Shape::Sphere { center: DVec3::new(x, 0.5, 0.0), radius: 0.5 };
    let scene = Scene {
        world: Environment { background: Rgb::splat(0.3), ..Environment::default() },
        objects: [
            Object { material: color(0.8, 0.1, 0.1), ..Object::new("red", ball(-0.8)) },
            Object { material: color(0.1, 0.1, 0.8), ..Object::new("blue", ball(0.8)) },
            Object::new("floor", Shape::Plane { p0: DVec3::ZERO, p1: DVec3::Z, p2: DVec3::X }),
        ]
        .into_iter()
        .collect::<List<Object>>(),
        lights: [PointLight::new("lamp", DVec3::new(1.0, 4.0, 3.0))].into_iter().collect::<List<PointLight>>(),
        ..Scene::default()
    };
    Stage {
        scene,
        views: [view("front", DVec3::new(0.0, 1.0, 5.0)), view("high", DVec3::new(0.0, 5.0, 2.0))]
            .into_iter()
            .collect(),
    }
}

pub fn view(name: &str, eye: DVec3) -> View {
    View {
        name: name.into(),
        width: 64,
        height: 48,
        eye,
        screen: ScreenSpec::LookAt { look_at: DVec3::new(0.0, 0.5, 0.0), up: DVec3::Y, fov: 50.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    }
}

impl Window {
    pub fn new(stage: Stage, lang: Lang) -> Window {
        Window::opening(stage, lang, Vec::new())
    }

    pub fn opening(stage: Stage, lang: Lang, open: Vec<PathBuf>) -> Window {
        Window::starting(stage, lang, open, None)
    }

    /// A window that keeps a journal in a folder.
    pub fn kept_in(stage: Stage, folder: &std::path::Path) -> Window {
        Window::starting(stage, Lang::English, Vec::new(), Some(folder.to_owned()))
    }

    /// A window after its first frame, when nothing is compiled yet.
    pub fn just_begun(stage: Stage) -> Window {
        Window::begun(stage, Lang::English, Vec::new(), None)
    }

    fn starting(stage: Stage, lang: Lang, open: Vec<PathBuf>, journals: Option<PathBuf>) -> Window {
        let mut window = Window::begun(stage, lang, open, journals);
        window.settle();
        window
    }

    fn begun(stage: Stage, lang: Lang, open: Vec<PathBuf>, journals: Option<PathBuf>) -> Window {
        let dialogs = Scripted::default();
        let scripted = dialogs.clone();
        let mut harness = Harness::builder().with_size(Vec2::new(1000.0, 640.0)).build_eframe(move |creation| {
            let settings = Settings::default();
            let dialogs = Box::new(scripted);
            let tracing = Tracing::default();
            let start = Start { settings, lang: Some(lang), tracing, stage, open, dialogs, journals };
            Studio::new(&creation.egui_ctx, start)
        });
        harness.step();
        Window { harness, dialogs }
    }

    /// Goes on until the pictures are finished and nothing moves any more, and looks whether everything has a name.
    pub fn settle(&mut self) {
        let begun = Instant::now();
        let mut quiet = 0;
        while quiet < 4 {
            assert!(begun.elapsed() < Duration::from_secs(60), "the window does not come to rest");
            self.harness.step();
            let studio = self.harness.state();
            let shown = studio.shown();
            let finished = shown.iter().filter_map(|view| studio.live(view)).all(|live| live.session().is_finished());
            quiet = if finished { quiet + 1 } else { 0 };
            std::thread::sleep(Duration::from_millis(1));
        }
        self.harness.check_accessibility();
    }

    /// Goes on until something is so.
    pub fn until(&mut self, what: &str, holds: impl Fn(&Studio) -> bool) {
        let begun = Instant::now();
        while !holds(self.harness.state()) {
            assert!(begun.elapsed() < Duration::from_secs(60), "{what} never comes");
            self.harness.step();
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    pub fn studio(&self) -> &Studio {
        self.harness.state()
    }

    pub fn stage(&self) -> &Stage {
        self.studio().document().stage()
    }

    pub fn steps(&self) -> usize {
        self.studio().document().history().current()
    }

    pub fn last_step(&self) -> String {
        let document = self.studio().document();
        document.history().names().nth(document.history().current()).unwrap().text(Lang::English)
    }

    pub fn object(&self, name: &str) -> Option<Arc<Object>> {
        self.stage().scene.objects.iter().find(|object| &*object.name == name).cloned()
    }

    pub fn center(&self, name: &str) -> DVec3 {
        let Shape::Sphere { center, .. } = self.object(name).unwrap().shape else { panic!("{name} is no sphere") };
        center
    }

    pub fn eye(&self, name: &str) -> DVec3 {
        self.stage().views.iter().find(|view| &*view.name == name).unwrap().eye
    }

    pub fn selected(&self) -> Vec<Item> {
        self.studio().document().selection().iter().cloned().collect()
    }

    /// Clicks what has that name.
    pub fn click(&mut self, name: &str) {
        self.harness.get_by_label(name).click();
        self.settle();
    }

    /// Opens a menu of the bar and clicks an entry.
    pub fn menu(&mut self, menu: &str, entry: &str) {
        self.click(menu);
        let nodes: Vec<_> = self.harness.query_all_by_label(entry).collect();
        let is_entry = |node: &&egui_kittest::Node<'_>| {
            matches!(node.accesskit_node().role(), egui::Role::MenuItem | egui::Role::MenuItemCheckBox)
        };
        nodes.iter().find(is_entry).unwrap_or_else(|| panic!("no entry {entry}")).click();
        self.settle();
    }

    pub fn press(&mut self, modifiers: Modifiers, key: Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.settle();
    }

    /// Where the picture of a view stands.
    pub fn picture(&self, view: &str) -> Rect {
        let studio = self.studio();
        let pane = self.harness.get_by_label(&format!("Picture of {view}")).rect();
        let [width, height] = studio.live(view).unwrap().size();
        Rect::from_center_size(pane.center(), Vec2::new(width as f32, height as f32))
    }

    /// The place on the screen of a point of space.
    pub fn place(&self, view: &str, point: DVec3) -> Pos2 {
        let shown = self.stage().views.iter().find(|known| &*known.name == view).unwrap();
        let (x, y) = lancer_trace::Camera::new(shown).unwrap().project(point).unwrap();
        let rect = self.picture(view);
        rect.min + Vec2::new(x as f32 / shown.width as f32, y as f32 / shown.height as f32) * rect.size()
    }

    pub fn event(&mut self, event: Event) {
        self.harness.event(event);
        self.harness.step();
    }

    pub fn button(&mut self, place: Pos2, button: PointerButton, pressed: bool, modifiers: Modifiers) {
        self.harness.event(Event::ModifiersChanged(modifiers));
        self.event(Event::PointerButton { pos: place, button, pressed, modifiers });
    }

    /// Presses a button and moves in steps, without letting go.
    pub fn drag(&mut self, from: Pos2, to: Pos2, button: PointerButton, modifiers: Modifiers) {
        self.harness.event(Event::ModifiersChanged(modifiers));
        self.event(Event::PointerMoved(from));
        self.wait();
        self.button(from, button, true, modifiers);
        for part in 1..=8 {
            self.event(Event::PointerMoved(from.lerp(to, part as f32 / 8.0)));
            self.wait();
        }
    }

    /// Lets threads answer.
    pub fn wait(&mut self) {
        for _ in 0..4 {
            std::thread::sleep(Duration::from_millis(3));
            self.harness.step();
        }
    }

    /// Lets go.
    pub fn drop_at(&mut self, place: Pos2, button: PointerButton) {
        self.button(place, button, false, Modifiers::NONE);
        self.harness.event(Event::ModifiersChanged(Modifiers::NONE));
        self.settle();
    }

    pub fn click_at(&mut self, place: Pos2, modifiers: Modifiers) {
        self.harness.event(Event::ModifiersChanged(modifiers));
        self.event(Event::PointerMoved(place));
        self.button(place, PointerButton::Primary, true, modifiers);
        self.button(place, PointerButton::Primary, false, modifiers);
        self.harness.event(Event::ModifiersChanged(Modifiers::NONE));
        self.wait();
        self.settle();
    }
}
