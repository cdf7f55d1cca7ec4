//! What stands under the pointer: asked of a thread, so that the window traces no ray.

use lancer_scene::{Name, View};
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

/// What was found.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The view's name.
    pub view: Name,
    /// The point of the picture, in pixels of the view from the top left.
    pub point: (f64, f64),
    /// Why it was asked.
    pub purpose: Purpose,
    /// What the ray meets.
    pub picked: Option<Picked>,
}

struct Question {
    world: Arc<World>,
    view: Arc<View>,
    point: (f64, f64),
    purpose: Purpose,
}

/// The thread that answers.
#[derive(Debug)]
pub struct Picker {
    questions: Sender<Question>,
    answers: Receiver<Answer>,
}

impl Picker {
    /// A thread that wakes the window when there is an answer.
    pub fn new(ctx: egui::Context) -> Picker {
        let (questions, inbox) = channel::<Question>();
        let (results, answers) = channel();
        std::thread::spawn(move || {
            while let Ok(first) = inbox.recv() {
                let waiting: Vec<Question> = std::iter::once(first).chain(inbox.try_iter()).collect();
                let last = waiting.len() - 1;
                for (place, Question { world, view, point, purpose }) in waiting.into_iter().enumerate() {
                    if purpose == Purpose::Hover && place != last {
                        continue;
                    }
                    let picked = Camera::new(&view).ok().and_then(|camera| world.pick(&camera.ray(point.0, point.1)));
                    if results.send(Answer { view: view.name.clone(), point, purpose, picked }).is_err() {
                        return;
                    }
                }
                ctx.request_repaint_of(egui::ViewportId::ROOT);
            }
        });
        Picker { questions, answers }
    }

    /// Asks what stands at a point of a picture, in pixels of the view from the top left.
    pub fn ask(&self, world: &Arc<World>, view: &Arc<View>, point: (f64, f64), purpose: Purpose) {
        let question = Question { world: Arc::clone(world), view: Arc::clone(view), point, purpose };
        // the thread lives as long as this
        let _ = self.questions.send(question);
    }

    /// What was answered since the last call.
    pub fn answers(&self) -> impl Iterator<Item = Answer> {
        self.answers.try_iter()
    }
}
