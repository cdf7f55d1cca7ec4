//! What stands under the pointer: asked of a thread that keeps a compiled world, so that the window traces no ray.

use lancer_scene::{Name, Scene, View};
use lancer_trace::{Camera, Picked, World};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

/// Why it is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The pointer is there; only the last such question is answered.
    Hover,
    /// The object is selected, alone or besides what is selected.
    Select {
        /// Besides.
        more: bool,
    },
}

struct Question {
    scene: Scene,
    view: View,
    point: [f64; 2],
    purpose: Purpose,
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The view's name.
    pub view: Name,
    /// The point of the picture, in pixels from the top left.
    pub point: [f64; 2],
    /// Why it was asked.
    pub purpose: Purpose,
    /// What the ray meets.
    pub picked: Option<Picked>,
}

/// The thread that answers.
#[derive(Debug)]
pub struct Picker {
    questions: Sender<Question>,
    answers: Receiver<(Answer, Scene, Arc<World>)>,
    world: Option<(Scene, Arc<World>)>,
}

impl Picker {
    /// A thread that wakes the window when there is an answer.
    pub fn new(ctx: egui::Context) -> Picker {
        let (questions, inbox) = channel::<Question>();
        let (results, answers) = channel();
        std::thread::spawn(move || {
            let mut world: Option<(Scene, Arc<World>)> = None;
            while let Ok(first) = inbox.recv() {
                let mut waiting: Vec<Question> = std::iter::once(first).chain(inbox.try_iter()).collect();
                let last = waiting.len() - 1;
                let mut place = 0;
                waiting.retain(|question| {
                    place += 1;
                    question.purpose != Purpose::Hover || place - 1 == last
                });
                for question in waiting {
                    let compiled = match world.take() {
                        Some((scene, compiled)) if shares(&scene, &question.scene) => compiled,
                        Some(_) | None => Arc::new(World::compile(&question.scene)),
                    };
                    world = Some((question.scene.clone(), Arc::clone(&compiled)));
                    let [x, y] = question.point;
                    let picked = Camera::new(&question.view).ok().and_then(|camera| compiled.pick(&camera.ray(x, y)));
                    let (view, purpose) = (question.view.name.clone(), question.purpose);
                    let answer = Answer { view, point: question.point, purpose, picked };
                    if results.send((answer, question.scene, compiled)).is_err() {
                        return;
                    }
                }
                ctx.request_repaint();
            }
        });
        Picker { questions, answers, world: None }
    }

    /// Asks what stands at a point of a picture, in pixels from the top left.
    pub fn ask(&self, scene: &Scene, view: &View, point: [f64; 2], purpose: Purpose) {
        // the thread lives as long as this
        let _ = self.questions.send(Question { scene: scene.clone(), view: view.clone(), point, purpose });
    }

    /// What was answered since the last call.
    pub fn answers(&mut self) -> Vec<Answer> {
        let mut answers = Vec::new();
        for (answer, scene, world) in self.answers.try_iter() {
            self.world = Some((scene, world));
            answers.push(answer);
        }
        answers
    }

    /// The compiled world of a scene, if it was asked about last.
    pub fn world(&self, scene: &Scene) -> Option<&World> {
        self.world.as_ref().filter(|(known, _)| shares(known, scene)).map(|(_, world)| &**world)
    }
}

/// Whether the same objects are seen in both.
fn shares(a: &Scene, b: &Scene) -> bool {
    a.objects.same_items(&b.objects)
}
