//! Measures live views: from an edit to the first complete coarse picture and to the finished one, with 1, 2, 4 and 8
//! views of the course scene at 640×480; the frames of the window meanwhile; the memory.
//!
//! ```text
//! cargo run --release -p lancer-studio --example live                 the sessions alone, no display
//! cargo run --release -p lancer-studio --example live -- --window     the window too, on the display at hand
//! xvfb-run -s "-screen 0 1280x800x24" cargo run --release -p lancer-studio --example live -- --window
//! ```
//!
//! Numbers among the arguments are the numbers of views instead of 1, 2, 4 and 8, at most 8; `--edits 3` measures fewer
//! edits.
#![allow(clippy::print_stdout, clippy::unwrap_used, clippy::expect_used, reason = "a program that measures and prints")]

use lancer_document::{StepName, attribute};
use lancer_formats::load::{LoadOptions, load_scene, load_views};
use lancer_render::Tracing;
use lancer_render::live::{Job, Renderer, Session};
use lancer_scene::{DVec3, Edit, Scene, ScreenSpec, Shape, Stage, View};
use lancer_studio::dialogs::{Dialogs, Reply, Request};
use lancer_studio::settings::Settings;
use lancer_studio::{Action, Start, Studio, ViewAction};
use lancer_words::Lang;
use std::path::Path;
use std::sync::mpsc::channel;
use std::time::{Duration, Instant};

/// How long the window is dragged in for its frames.
const DRAG: Duration = Duration::from_secs(5);
/// The scene's ball that is moved.
const MOVED: f64 = 0.02;

/// What is measured.
#[derive(Clone)]
struct Plan {
    /// How many views there are in each row of the table.
    views: Vec<usize>,
    /// How many edits a figure is the median of.
    edits: usize,
    /// Whether the window is measured too.
    window: bool,
}

impl Plan {
    fn of_arguments() -> Plan {
        let mut plan = Plan { views: Vec::new(), edits: 15, window: false };
        let mut arguments = std::env::args().skip(1);
        while let Some(argument) = arguments.next() {
            match (argument.as_str(), argument.parse()) {
                ("--window", _) => plan.window = true,
                ("--edits", _) => plan.edits = arguments.next().and_then(|count| count.parse().ok()).unwrap_or(15),
                (_, Ok(count)) => plan.views.push(usize::clamp(count, 1, 8)),
                (_, Err(_)) => println!("not known: {argument}"),
            }
        }
        if plan.views.is_empty() {
            plan.views = vec![1, 2, 4, 8];
        }
        plan
    }
}

fn main() {
    let (stage, plan) = (stage(8), Plan::of_arguments());
    println!("threads {}", std::thread::available_parallelism().map_or(1, usize::from));
    println!("sessions alone, ms: median (worst) of {} edits", plan.edits);
    println!("views   first complete        all finished");
    for &count in &plan.views {
        let (first, finished) = sessions(&stage, count, plan.edits);
        println!("{count:>5}   {:>20}  {:>18}", told(first), told(finished));
    }
    println!("memory after the sessions: {}", memory());
    if plan.window {
        window(stage, plan);
    }
}

/// The course scene with so many views at 640×480, around the one of its file.
fn stage(views: usize) -> Stage {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/course");
    let options = LoadOptions::default();
    let scene = load_scene(&folder.join("course.xml"), &options).unwrap().value.unwrap();
    let view = load_views(&folder.join("course.view.xml"), &options).unwrap().value.unwrap()[0].clone();
    let around = |number: usize| {
        let angle = number as f64 * 0.35;
        let turn =
            |p: DVec3| DVec3::new(p.x * angle.cos() + p.z * angle.sin(), p.y, p.z * angle.cos() - p.x * angle.sin());
        let screen = ScreenSpec::LookAt { look_at: DVec3::new(0.0, 0.5, 0.0), up: DVec3::Y, fov: 45.0 };
        let name = format!("view {}", number + 1).as_str().into();
        View { name, width: 640, height: 480, eye: turn(view.eye), screen, samples: 1, ..View::clone(&view) }
    };
    Stage { scene, views: (0..views).map(around).collect() }
}

/// The edit that moves the first ball, further each time.
fn edit(stage: &Stage, time: usize) -> Edit {
    let ball = stage.scene.objects.iter().find(|object| matches!(object.shape, Shape::Sphere { .. })).unwrap();
    attribute::edit_object(stage, &ball.name, |object| {
        if let Shape::Sphere { center, .. } = &mut object.shape {
            center.x += MOVED * (1.0 + (time % 20) as f64);
        }
    })
    .unwrap()
}

/// Edits with so many sessions: the times to the first complete picture of all, and to the last pixel of all.
fn sessions(stage: &Stage, count: usize, edits: usize) -> (Vec<f64>, Vec<f64>) {
    let (wake, news) = channel();
    let mut renderer = Renderer::new(None, Tracing::default(), move || {
        // nobody waits any more
        let _ = wake.send(());
    });
    let mut sessions: Vec<Session> = (0..count).map(|_| renderer.open()).collect();
    let (mut first, mut finished) = (Vec::new(), Vec::new());
    // the first picture is not measured: memory is taken for it
    for time in 0..=edits {
        let (edited, _) = stage.apply(&edit(stage, time)).unwrap();
        let begun = Instant::now();
        start(&mut sessions, &edited.scene, stage);
        let mut complete = None;
        while !sessions.iter().all(Session::is_finished) {
            news.recv().unwrap();
            for session in &mut sessions {
                session.poll();
            }
            if complete.is_none() && sessions.iter().all(|session| session.status().first_complete.is_some()) {
                complete = Some(begun.elapsed());
            }
        }
        if time > 0 {
            first.push(complete.unwrap_or_else(|| begun.elapsed()).as_secs_f64() * 1e3);
            finished.push(begun.elapsed().as_secs_f64() * 1e3);
        }
    }
    (first, finished)
}

fn start(sessions: &mut [Session], scene: &Scene, stage: &Stage) {
    for (session, view) in sessions.iter_mut().zip(stage.views.iter()) {
        let max_rays = lancer_trace::Settings::MAX_RAYS;
        session.start(Job { scene: scene.clone(), view: View::clone(view), max_rays });
    }
}

/// The median and the worst of times.
fn told(mut times: Vec<f64>) -> String {
    times.sort_by(f64::total_cmp);
    let worst = times.last().copied().unwrap_or_default();
    format!("{:.1} ({worst:.1})", times.get(times.len() / 2).copied().unwrap_or_default())
}

/// What the process holds now and has held at most.
fn memory() -> String {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let of = |key: &str| {
        let line = status.lines().find_map(|line| line.strip_prefix(key)).unwrap_or_default();
        line.split_whitespace().next().and_then(|kilobytes| kilobytes.parse::<u64>().ok()).unwrap_or_default() / 1024
    };
    format!("{} MB (at most {} MB)", of("VmRSS:"), of("VmHWM:"))
}

struct NoDialogs;

impl Dialogs for NoDialogs {
    fn ask(&mut self, _: &Request) {}
    fn poll(&mut self) -> Option<Reply> {
        None
    }
}

fn window(stage: Stage, plan: Plan) {
    let (edits, drag) = (plan.edits, DRAG.as_secs());
    println!("the window, ms: median (worst) of {edits} edits; then {drag} s of dragging, an edit a frame");
    println!("views   first complete        all finished   frames/s  worst frame");
    let viewport = egui::ViewportBuilder::default().with_inner_size([1280.0, 800.0]).with_title("live");
    let options = eframe::NativeOptions { viewport, dithering: false, ..eframe::NativeOptions::default() };
    let begin = move |creation: &eframe::CreationContext<'_>| -> Box<dyn eframe::App> {
        let dialogs = Box::new(NoDialogs);
        let (settings, lang) = (Settings::default(), Some(Lang::English));
        let start =
            Start { settings, lang, stage, open: Vec::new(), dialogs, journals: None, tracing: Tracing::default() };
        let studio = Studio::new(&creation.egui_ctx, start);
        Box::new(Measured { studio, plan, row: 0, phase: Phase::Begin, times: (Vec::new(), Vec::new()) })
    };
    eframe::run_native("live", options, Box::new(move |creation| Ok(begin(creation)))).unwrap();
}

/// What the window does just now.
enum Phase {
    /// Opens the views of a row.
    Begin,
    /// Waits for the pictures after an edit.
    Edited { begun: Instant, complete: Option<Duration> },
    /// An edit each frame.
    Dragged { begun: Instant, frames: u32, last: Instant, worst: Duration },
}

struct Measured {
    studio: Studio,
    plan: Plan,
    row: usize,
    phase: Phase,
    times: (Vec<f64>, Vec<f64>),
}

impl Measured {
    fn edit(&mut self, ctx: &egui::Context, time: usize) {
        let edit = edit(self.studio.document().base(), time);
        self.studio.perform(ctx, Action::Preview(edit));
    }

    /// Opens or closes one more view; whether there are as many as the row wants.
    fn arrange(&mut self, ctx: &egui::Context) -> bool {
        let (wanted, shown) = (self.plan.views[self.row], self.studio.shown());
        let views: Vec<_> = self.studio.document().stage().views.iter().map(|view| view.name.clone()).collect();
        let is_shown = |view: &lancer_scene::Name| shown.iter().any(|name| **name == **view);
        if let Some(view) = views.iter().take(wanted).find(|view| !is_shown(view)) {
            self.studio.perform(ctx, Action::View(view.clone(), ViewAction::Show));
        } else if let Some(view) = views.iter().skip(wanted).find(|view| is_shown(view)) {
            self.studio.perform(ctx, Action::View(view.clone(), ViewAction::Close));
        } else {
            return true;
        }
        false
    }

    fn next(&mut self, ctx: &egui::Context) -> Phase {
        self.edit(ctx, self.times.0.len() + 1);
        Phase::Edited { begun: Instant::now(), complete: None }
    }
}

impl eframe::App for Measured {
    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        let ctx = ui.ctx().clone();
        eframe::App::ui(&mut self.studio, ui, frame);
        let shown = self.studio.shown();
        for view in &shown {
            // every picture has the size of its view
            self.studio.perform(&ctx, Action::View(view.as_str().into(), ViewAction::Fit(false)));
        }
        let sessions: Vec<&Session> =
            shown.iter().filter_map(|view| self.studio.live(view)).map(|live| live.session()).collect();
        let finished = !sessions.is_empty() && sessions.iter().all(|session| session.is_finished());
        let complete = sessions.iter().all(|session| session.status().first_complete.is_some());
        match std::mem::replace(&mut self.phase, Phase::Begin) {
            Phase::Begin => {
                if self.arrange(&ctx) {
                    self.studio.perform(&ctx, Action::Begin(StepName::New));
                    self.phase = self.next(&ctx);
                }
                ctx.request_repaint();
            }
            Phase::Edited { begun, complete: before } => {
                let before = before.or_else(|| complete.then(|| begun.elapsed()));
                if !finished {
                    self.phase = Phase::Edited { begun, complete: before };
                    return;
                }
                self.times.0.push(before.unwrap_or_else(|| begun.elapsed()).as_secs_f64() * 1e3);
                self.times.1.push(begun.elapsed().as_secs_f64() * 1e3);
                ctx.request_repaint();
                self.phase = if self.times.0.len() <= self.plan.edits {
                    self.next(&ctx)
                } else {
                    let now = Instant::now();
                    Phase::Dragged { begun: now, frames: 0, last: now, worst: Duration::ZERO }
                };
            }
            Phase::Dragged { begun, frames, last, worst } => {
                let worst = worst.max(last.elapsed());
                ctx.request_repaint();
                if begun.elapsed() < DRAG {
                    self.edit(&ctx, frames as usize);
                    self.phase = Phase::Dragged { begun, frames: frames + 1, last: Instant::now(), worst };
                    return;
                }
                // the first edit is not counted: the views were just opened
                let (first, all) = (self.times.0.split_off(1), self.times.1.split_off(1));
                self.times = (Vec::new(), Vec::new());
                let rate = f64::from(frames) / begun.elapsed().as_secs_f64();
                let worst = worst.as_secs_f64() * 1e3;
                let count = self.plan.views[self.row];
                println!("{count:>5}   {:>20}  {:>18}  {rate:>8.1}  {worst:>8.1} ms", told(first), told(all));
                self.studio.perform(&ctx, Action::Cancel);
                self.row += 1;
                if self.row == self.plan.views.len() {
                    println!("memory with the window: {}", memory());
                    // a demonstration has nothing to save
                    std::process::exit(0);
                }
            }
        }
    }
}
