//! The pixel that is explained: which one, and the tree of its rays, traced beside the window by the reference tracer,
//! again whenever its view has changed.

use crate::beside::Beside;
use lancer_scene::{Invalid, Name, Scene, View};
use lancer_trace::{Camera, Cancel, PixelTree, Settings, TraceError, World, explain};
use std::sync::Arc;

/// The most rays of a pixel: nobody reads more, and each of them takes memory.
pub const MAX_RAYS: u64 = 20_000;

/// A place in the picture of a view.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// The view's name.
    pub view: Name,
    /// From the left and from the top, 0..1, so that the place stays where it is when the picture's size changes.
    pub at: (f64, f64),
}

impl Target {
    /// The middle of a pixel of a picture of that size.
    pub fn of_pixel(view: Name, (x, y): (u32, u32), [width, height]: [u32; 2]) -> Target {
        let middle = |place: u32, whole: u32| (f64::from(place) + 0.5) / f64::from(whole.max(1));
        Target { view, at: (middle(x, width), middle(y, height)) }
    }

    /// The pixel of a picture of that size.
    pub fn pixel(&self, [width, height]: [u32; 2]) -> (u32, u32) {
        let place = |at: f64, whole: u32| ((at * f64::from(whole)) as u32).min(whole.saturating_sub(1));
        (place(self.at.0, width), place(self.at.1, height))
    }
}

/// Why a pixel has no explanation.
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// The view breaks a rule.
    View(Invalid),
    /// The pixel has no colour, or costs too many rays.
    Trace(TraceError),
}

/// A pixel and all that it depends on.
#[derive(Debug)]
pub struct Explanation {
    /// The scene.
    pub scene: Scene,
    /// The view at the size of the picture that is shown.
    pub view: View,
    /// The pixel, from the top left.
    pub pixel: (u32, u32),
    /// Its rays.
    pub outcome: Result<PixelTree, Failure>,
}

/// What an explanation is made of.
#[derive(Clone, Debug)]
struct Subject {
    world: Arc<World>,
    view: View,
    pixel: (u32, u32),
}

impl PartialEq for Subject {
    fn eq(&self, other: &Subject) -> bool {
        Arc::ptr_eq(&self.world, &other.world) && self.view == other.view && self.pixel == other.pixel
    }
}

/// The pixel that is explained.
#[derive(Debug, Default)]
pub struct Explainer {
    target: Option<Target>,
    beside: Beside<Subject, Arc<Explanation>>,
}

impl Explainer {
    /// Which pixel.
    pub fn target(&self) -> Option<&Target> {
        self.target.as_ref()
    }

    /// Explains another pixel from now on.
    pub fn aim(&mut self, target: Target) {
        self.target = Some(target);
    }

    /// Explains the pixel in the picture that its view shows now.
    pub fn follow(&mut self, ctx: &egui::Context, world: &Arc<World>, scene: &Scene, view: &View) {
        let Some(target) = &self.target else { return };
        let subject =
            Subject { world: Arc::clone(world), view: view.clone(), pixel: target.pixel([view.width, view.height]) };
        let (of, scene) = (subject.clone(), scene.clone());
        self.beside.follow(ctx, &subject, move || {
            let outcome = traced(&of);
            Arc::new(Explanation { scene, view: of.view, pixel: of.pixel, outcome })
        });
    }

    /// The explanation, as soon as there is one of the view of the pixel.
    pub fn explanation(&self) -> Option<&Arc<Explanation>> {
        let target = self.target.as_ref()?;
        self.beside.get().filter(|explanation| explanation.view.name == target.view)
    }
}

fn traced(subject: &Subject) -> Result<PixelTree, Failure> {
    let Subject { world, view, pixel } = subject;
    let camera = Camera::new(view).map_err(Failure::View)?;
    let settings = Settings { max_rays: MAX_RAYS, ..Settings::of(world, view) };
    explain(world, &camera, settings, *pixel, &Cancel::default()).map_err(Failure::Trace)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_stays_where_it_is_at_another_size() {
        let target = Target::of_pixel("front".into(), (320, 120), [640, 480]);
        assert_eq!(target.pixel([640, 480]), (320, 120));
        assert_eq!(target.pixel([320, 240]), (160, 60));
        let edge = Target { view: "front".into(), at: (1.0, 1.0) };
        assert_eq!(edge.pixel([64, 48]), (63, 47));
        assert_eq!(edge.pixel([0, 0]), (0, 0));
    }
}
