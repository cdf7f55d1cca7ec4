//! What a view looks at: the directions of its picture, and the point that new things stand at and the eye turns around.

use lancer_scene::{DVec3, Extents, Scene, Screen, ScreenSpec, View};
use lancer_trace::{Camera, Picked, World};

/// The directions of a view's picture in space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sight {
    pub(crate) eye: DVec3,
    pub(crate) screen: Screen,
    /// Unit vector to the right of the picture.
    pub(crate) right: DVec3,
    /// Unit vector to the top, perpendicular to `right`.
    pub(crate) top: DVec3,
    /// Unit vector perpendicular to the screen, from the eye to it.
    pub(crate) forward: DVec3,
    /// Unit vector through the middle of the picture; not `forward` where the screen stands aside.
    pub(crate) middle: DVec3,
}

impl Sight {
    /// The directions of a view; `None` where it is not valid.
    pub(crate) fn of(view: &View) -> Option<Sight> {
        let screen = view.resolved_screen().ok()?;
        let right = screen.u.try_normalize()?;
        let normal = screen.u.cross(screen.v).try_normalize()?;
        let to_screen = screen.point(0.5, 0.5) - view.eye;
        let forward = if normal.dot(to_screen) < 0.0 { -normal } else { normal };
        let top = (-screen.v + right * screen.v.dot(right)).try_normalize()?;
        Some(Sight { eye: view.eye, screen, right, top, forward, middle: to_screen.try_normalize()? })
    }

    /// The distance between the eye and the screen's plane.
    pub(crate) fn screen_depth(&self) -> f64 {
        (self.screen.origin - self.eye).dot(self.forward)
    }

    /// How many times larger than the screen's the picture of a plane through the point is, parallel to the screen;
    /// `None` behind the eye.
    pub(crate) fn magnification(&self, point: DVec3) -> Option<f64> {
        let factor = (point - self.eye).dot(self.forward) / self.screen_depth();
        (factor.is_finite() && factor > 0.0).then_some(factor)
    }

    /// The width and height of the picture in the plane through the point.
    pub(crate) fn extent(&self, point: DVec3) -> Option<(f64, f64)> {
        let factor = self.magnification(point)?;
        Some((self.screen.u.length() * factor, self.screen.v.length() * factor))
    }
}

/// The point that a view is about.
#[derive(Clone, Debug, PartialEq)]
pub struct Focus {
    /// The point.
    pub point: DVec3,
    /// What the ray through the middle of the picture meets there.
    pub hit: Option<Picked>,
}

/// A hit more than so many times farther than what the view is about is the horizon.
const HORIZON: f64 = 3.0;

/// The point that a view is about: what the ray through the middle meets, unless that is far behind the point that the
/// view looks at; else that point; else the middle of the scene's depth; else a point behind the screen.
///
/// Without a compiled world nothing is met.
pub fn focus(view: &View, scene: &Scene, world: Option<&World>) -> Focus {
    let Some(sight) = Sight::of(view) else { return Focus { point: DVec3::ZERO, hit: None } };
    let usual = match &view.screen {
        ScreenSpec::LookAt { look_at, .. } => Some((*look_at - sight.eye).length()),
        ScreenSpec::Frame(_) | ScreenSpec::Centered { .. } | ScreenSpec::Corners(_) => depth_of(scene, &sight),
    };
    let hit = world
        .zip(Camera::new(view).ok())
        .and_then(|(world, camera)| world.pick(&camera.ray(f64::from(view.width) / 2.0, f64::from(view.height) / 2.0)));
    match hit.filter(|hit| usual.is_none_or(|usual| hit.distance <= HORIZON * usual)) {
        Some(hit) => Focus { point: hit.point, hit: Some(hit) },
        None => {
            let distance = usual.unwrap_or(HORIZON * sight.screen_depth());
            Focus { point: sight.eye + sight.middle * distance, hit: None }
        }
    }
}

/// The distance along the middle ray to the middle of all bounded objects in front of the eye.
fn depth_of(scene: &Scene, sight: &Sight) -> Option<f64> {
    let mut extents = Extents::default();
    let visible = scene.objects.iter().filter(|object| object.visible);
    let bounds = visible.filter_map(|object| extents.of(&object.shape));
    let (low, high) = bounds.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))?;
    let distance = ((low + high) * 0.5 - sight.eye).dot(sight.middle);
    (distance > 0.0).then_some(distance)
}
