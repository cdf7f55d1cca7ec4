//! A view while it is shown: its session, and the picture of it on the graphics card.

use super::{Answer, Gesture, Purpose};
use egui::{ColorImage, TextureHandle, TextureOptions};
use lancer_render::Region;
use lancer_render::live::{Job, Session};
use lancer_scene::{Scene, Stage, View};
use lancer_trace::Settings;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A picture that is older than this says so; a change that is seen sooner would only flicker.
const OLD: Duration = Duration::from_millis(150);

/// A view while it is shown.
pub struct LiveView {
    session: Session,
    /// What the session renders.
    rendered: Option<(Scene, View)>,
    texture: Option<TextureHandle>,
    /// The texture shows less than the session has.
    outdated: bool,
    /// How many pixels the pane offers.
    offered: [u32; 2],
    /// Whether the picture is made to fit the pane instead of having the view's own size.
    pub fit: bool,
    /// Whether grid and axes are shown.
    pub grid: bool,
    /// The rectangle that is refined first, in pixels of the picture.
    region: Option<Region>,
    /// What the pointer does in the pane.
    pub gesture: Option<Gesture>,
    /// The next drag marks a rectangle.
    pub marking: bool,
    /// What stands under the pointer, as far as it was asked.
    pub under: Option<Answer>,
    /// A click that cannot be answered yet: its point of the view, and what it is for.
    pub waiting: Option<((f64, f64), Purpose)>,
    started: Instant,
    /// Some picture was complete before.
    complete: bool,
}

impl std::fmt::Debug for LiveView {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("LiveView").field("session", &self.session).finish_non_exhaustive()
    }
}

impl LiveView {
    /// A view that fits its pane.
    pub fn new(session: Session) -> LiveView {
        LiveView {
            session,
            rendered: None,
            texture: None,
            outdated: false,
            offered: [0; 2],
            fit: true,
            grid: false,
            region: None,
            gesture: None,
            marking: false,
            under: None,
            waiting: None,
            started: Instant::now(),
            complete: false,
        }
    }

    /// How far the picture is.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// What is being rendered, at the size of the picture.
    pub fn view(&self) -> Option<&View> {
        self.rendered.as_ref().map(|(_, view)| view)
    }

    /// The scene that is being rendered.
    pub fn scene(&self) -> Option<&Scene> {
        self.rendered.as_ref().map(|(scene, _)| scene)
    }

    /// Tells how many pixels the pane has.
    pub fn offer(&mut self, pixels: [u32; 2]) {
        self.offered = pixels;
    }

    /// Begins the picture again if the scene, the view or its size has changed; whether it did. A view without a pane
    /// to fit waits.
    pub fn follow(&mut self, stage: &Stage, name: &str) -> bool {
        let Some(view) = stage.views.iter().find(|view| &*view.name == name) else { return false };
        let Some(view) = self.sized(view) else { return false };
        let current = self.rendered.as_ref().is_some_and(|(scene, known)| same(scene, &stage.scene) && *known == view);
        if !current {
            self.start(stage.scene.clone(), view);
        }
        !current
    }

    /// Begins the picture again.
    pub fn restart(&mut self) {
        if let Some((scene, view)) = self.rendered.take() {
            self.start(scene, view);
        }
    }

    fn start(&mut self, scene: Scene, view: View) {
        let inside = self.region.filter(|region| region.lies_within(view.width, view.height));
        self.region = inside;
        self.session.prioritise(inside);
        self.session.start(Job { scene: scene.clone(), view: view.clone(), max_rays: Settings::MAX_RAYS });
        self.rendered = Some((scene, view));
        self.outdated = true;
        self.started = Instant::now();
        self.under = None;
    }

    /// The view at the size of its picture; `None` while the pane's size is not known.
    fn sized(&self, view: &View) -> Option<View> {
        if !self.fit {
            return Some(view.clone());
        }
        let [width, height] = fitted([view.width, view.height], self.offered)?;
        Some(View { width, height, ..view.clone() })
    }

    /// Rests or goes on.
    pub fn pause(&mut self, paused: bool) {
        self.session.pause(paused);
    }

    /// Serves this view before the others.
    pub fn activate(&self) {
        self.session.activate();
    }

    /// The rectangle that is refined first.
    pub fn region(&self) -> Option<Region> {
        self.region
    }

    /// Refines a rectangle first, from a new beginning.
    pub fn refine(&mut self, region: Option<Region>) {
        self.region = region;
        self.restart();
    }

    /// Takes the news of the session; whether there were any.
    pub fn poll(&mut self) -> bool {
        let world = |session: &Session| session.world().map(Arc::as_ptr);
        let before = world(&self.session);
        let changed = self.session.poll();
        if world(&self.session) != before {
            self.under = None;
        }
        self.outdated |= changed;
        self.complete |= !self.session.image().bytes().is_empty() && !self.session.image().is_stale();
        changed
    }

    /// Whether an earlier picture is still seen.
    pub fn looks_old(&self) -> bool {
        self.complete && self.session.image().is_stale() && self.started.elapsed() > OLD
    }

    /// The size of the picture in pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.session.image().width(), self.session.image().height()]
    }

    /// The picture on the graphics card, brought up to date; `None` before there is one. Pixels that are larger than
    /// the screen's stay squares, smaller ones are smoothed.
    pub fn texture(&mut self, ctx: &egui::Context) -> Option<&TextureHandle> {
        let image = self.session.image();
        if image.bytes().is_empty() {
            return None;
        }
        let options = TextureOptions { magnification: egui::TextureFilter::Nearest, ..TextureOptions::LINEAR };
        if self.outdated || self.texture.is_none() {
            self.outdated = false;
            let size = [image.width() as usize, image.height() as usize];
            let pixels = ColorImage::from_rgb(size, image.bytes().as_flattened());
            match &mut self.texture {
                Some(texture) => texture.set(pixels, options),
                None => self.texture = Some(ctx.load_texture("view", pixels, options)),
            }
        }
        self.texture.as_ref()
    }
}

/// The largest size of those proportions that fits; `None` where nothing does.
fn fitted(proportions: [u32; 2], offered: [u32; 2]) -> Option<[u32; 2]> {
    let [width, height] = proportions.map(f64::from);
    let [across, down] = offered.map(f64::from);
    let scale = (across / width).min(down / height);
    let fit = |length: f64, most: u32| ((length * scale).round() as u32).clamp(1, most);
    (scale.is_finite() && scale > 0.0).then(|| [fit(width, offered[0]), fit(height, offered[1])])
}

/// Whether two scenes give the same picture because they share everything that it is made of.
fn same(a: &Scene, b: &Scene) -> bool {
    a.world == b.world
        && a.materials.same_items(&b.materials)
        && a.lights.same_items(&b.lights)
        && a.objects.same_items(&b.objects)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_keeps_its_proportions() {
        assert_eq!(fitted([640, 480], [1000, 300]), Some([400, 300]));
        assert_eq!(fitted([960, 600], [400, 400]), Some([400, 250]));
        assert_eq!(fitted([65_535, 1], [300, 300]), Some([300, 1]));
        assert_eq!(fitted([640, 480], [0, 300]), None);
    }
}
