//! Moving the eye: orbit, pan, dolly, framing, and looking along an axis.
//!
//! Each function gives the view as it is afterwards. A screen that is given in space moves rigidly with the eye; a view
//! that looks at a point goes on looking at a point. A movement that would break a rule of views is not made: the view
//! comes back as it was. A drag should always start from the view as it was when the button went down.

use crate::sight::Sight;
use crate::{Item, decimal};
use lancer_scene::{DVec3, Screen, ScreenSpec, Shape, Stage, View, limits};

/// From where a scene is looked at along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// From the front: x to the right, the vertical upwards.
    Front,
    /// From the back.
    Back,
    /// From the right.
    Right,
    /// From the left.
    Left,
    /// From above: x to the right.
    Top,
    /// From below: x to the right.
    Bottom,
}

impl Side {
    /// The six sides in the order in which menus show them.
    pub const ALL: [Side; 6] = [Side::Front, Side::Back, Side::Right, Side::Left, Side::Top, Side::Bottom];
}

/// The direction that is up in a scene: z if more of its views that say what is up say so, else y.
pub fn vertical(stage: &Stage) -> DVec3 {
    let said: Vec<DVec3> = stage.views.iter().filter_map(|view| said_vertical(view)).collect();
    let z = said.iter().filter(|up| **up == DVec3::Z).count();
    if 2 * z > said.len() { DVec3::Z } else { DVec3::Y }
}

/// The direction, y or z, that a view says is up; `None` if it says nothing of the kind. Looking straight along the
/// other of the two, any direction may be up in the picture.
pub(crate) fn said_vertical(view: &View) -> Option<DVec3> {
    let (up, target) = match &view.screen {
        ScreenSpec::LookAt { look_at, up, .. } => (*up, *look_at),
        ScreenSpec::Centered { center, up, .. } => (*up, *center),
        ScreenSpec::Frame(_) | ScreenSpec::Corners(_) => return None,
    };
    let sight = (target - view.eye).try_normalize()?;
    let largest = up.abs().max_element();
    if sight.y.abs() > 0.99 || largest == up.x.abs() {
        None
    } else if largest == up.y.abs() {
        Some(DVec3::Y)
    } else {
        Some(DVec3::Z)
    }
}

/// A view turned around `pivot`: what is in front of the pivot moves by `right` degrees to the right and by `down`
/// degrees downwards in the picture. The eye does not go over the poles of `vertical`.
#[must_use]
pub fn orbit(view: &View, vertical: DVec3, pivot: DVec3, right: f64, down: f64) -> View {
    let Some(sight) = Sight::of(view) else { return view.clone() };
    // where the eye is on a pole, the picture's own right is the horizontal
    let level = sight.forward.cross(vertical);
    let level = if level.length() < NEAR_POLE { sight.right } else { level.normalize() };
    // a picture that is mirrored or upside down turns the other way in space
    let rightwards = right * sight.right.dot(level).signum();
    let downwards = down * sight.top.dot(level.cross(sight.forward)).signum();
    let elevation = libm::asin((-sight.forward.dot(vertical)).clamp(-1.0, 1.0)).to_degrees();
    let upwards = (elevation + downwards).clamp(-90.0, 90.0) - elevation;
    let yaw = Rotation::about(vertical, -rightwards);
    let pitch = Rotation::about(yaw.apply(level), -upwards);
    moved(view, vertical, pivot, &|vector| pitch.apply(yaw.apply(vector)), DVec3::ZERO)
}

/// A view moved in its own plane, so that the point `pivot` goes `right` and `down` pixels in the picture.
#[must_use]
pub fn pan(view: &View, pivot: DVec3, right: f64, down: f64) -> View {
    let Some((sight, factor)) = Sight::of(view).and_then(|sight| Some((sight, sight.magnification(pivot)?))) else {
        return view.clone();
    };
    let (u, v) = (sight.screen.u / f64::from(view.width), sight.screen.v / f64::from(view.height));
    translated(view, (u * right + v * down) * -factor)
}

/// A view whose eye is `factor` times as far from `pivot`; the pivot keeps its place in the picture.
#[must_use]
pub fn dolly(view: &View, pivot: DVec3, factor: f64) -> View {
    if !(factor.is_finite() && factor > 0.0) {
        return view.clone();
    }
    let by = (view.eye - pivot) * (factor - 1.0);
    match &view.screen {
        ScreenSpec::LookAt { look_at, up, fov } => {
            let look_at = pivot + (*look_at - pivot) * factor;
            let screen = ScreenSpec::LookAt { look_at, up: *up, fov: *fov };
            legal(view, View { eye: view.eye + by, screen, ..view.clone() })
        }
        ScreenSpec::Frame(_) | ScreenSpec::Centered { .. } | ScreenSpec::Corners(_) => translated(view, by),
    }
}

/// A view that shows a ball whole and in the middle, from the direction that it looks in.
#[must_use]
pub fn frame(view: &View, center: DVec3, radius: f64) -> View {
    let Some(sight) = Sight::of(view) else { return view.clone() };
    let Some(distance) = fitting(&sight, radius) else { return view.clone() };
    let eye = center - sight.middle * distance;
    match &view.screen {
        ScreenSpec::LookAt { up, fov, .. } => {
            let screen = ScreenSpec::LookAt { look_at: center, up: *up, fov: *fov };
            legal(view, View { eye, screen, ..view.clone() })
        }
        ScreenSpec::Frame(_) | ScreenSpec::Centered { .. } | ScreenSpec::Corners(_) => translated(view, eye - view.eye),
    }
}

/// A view that looks along an axis at `pivot`, from the distance that it has.
#[must_use]
pub fn look_along(view: &View, vertical: DVec3, pivot: DVec3, side: Side) -> View {
    let Some(sight) = Sight::of(view) else { return view.clone() };
    // the horizontal that a front view looks along: -z for the vertical y, y for z
    let front = DVec3::X.cross(vertical) * -1.0;
    let (forward, top) = match side {
        Side::Front => (front, vertical),
        Side::Back => (-front, vertical),
        Side::Right => (DVec3::NEG_X, vertical),
        Side::Left => (DVec3::X, vertical),
        Side::Top => (-vertical, front),
        Side::Bottom => (vertical, -front),
    };
    let right = if sight.screen.is_mirrored(view.eye) { top.cross(forward) } else { forward.cross(top) };
    // from the picture's own directions to those
    let turn = |vector: DVec3| {
        right * vector.dot(sight.right) + top * vector.dot(sight.top) + forward * vector.dot(sight.forward)
    };
    // what is in the middle of the picture at the pivot's distance turns on the spot and goes to the pivot
    let middle = sight.eye + sight.middle * (pivot - view.eye).length();
    moved(view, vertical, middle, &turn, pivot - middle)
}

/// A ball around things: its centre and radius. Objects by their bounds, a plane by its three points, a lamp and an eye
/// as points. `None` where nothing of it stands in space.
pub fn ball_around<'a>(stage: &Stage, items: impl IntoIterator<Item = &'a Item>) -> Option<(DVec3, f64)> {
    let bounds = items.into_iter().filter_map(|item| bounds(stage, item));
    let (low, high) = bounds.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))?;
    Some(((low + high) * 0.5, (high - low).length() * 0.5))
}

fn bounds(stage: &Stage, item: &Item) -> Option<(DVec3, DVec3)> {
    let index = item.place(stage)?;
    match item {
        Item::World | Item::Material(_) => None,
        Item::Light(_) => stage.scene.lights.get(index).map(|light| (light.position, light.position)),
        Item::View(_) => stage.views.get(index).map(|view| (view.eye, view.eye)),
        Item::Object(_) => {
            let shape = &stage.scene.objects.get(index)?.shape;
            match shape {
                Shape::Plane { p0, p1, p2 } => {
                    let far = *p1 + *p2 - *p0;
                    Some((p0.min(*p1).min(*p2).min(far), p0.max(*p1).max(*p2).max(far)))
                }
                Shape::Sphere { .. }
                | Shape::Facet { .. }
                | Shape::Cube { .. }
                | Shape::Parallelepiped { .. }
                | Shape::Cone { .. }
                | Shape::Mesh(_) => shape.bounds(),
            }
        }
    }
}

/// A framed thing leaves this part of its radius free on every side.
const MARGIN: f64 = 1.15;
/// Sines of angles smaller than this, half a degree, count as looking along the vertical.
const NEAR_POLE: f64 = 0.0087;

/// How far from a ball's centre, along the middle ray, the eye sees it whole: its distance to each of the four planes
/// through the eye and an edge of the screen must exceed the radius.
fn fitting(sight: &Sight, radius: f64) -> Option<f64> {
    let screen = &sight.screen;
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| screen.point(x, y) - sight.eye);
    let mut narrowest = f64::INFINITY;
    for edge in 0..4 {
        let normal = corners[edge].cross(corners[(edge + 1) % 4]).try_normalize()?;
        narrowest = narrowest.min(normal.dot(sight.middle).abs());
    }
    // a point has no size: the eye comes near, not into it
    let radius = if radius > 0.0 { radius } else { sight.screen_depth() * 0.25 };
    let distance = (radius * MARGIN / narrowest).max(limits::LEAST);
    distance.is_finite().then_some(distance)
}

/// The eye and its screen elsewhere.
fn translated(view: &View, by: DVec3) -> View {
    let screen = match &view.screen {
        ScreenSpec::Frame(screen) => ScreenSpec::Frame(Screen { origin: screen.origin + by, ..*screen }),
        ScreenSpec::Centered { center, size, up } => {
            ScreenSpec::Centered { center: *center + by, size: *size, up: *up }
        }
        ScreenSpec::Corners(corners) => ScreenSpec::Corners(corners.map(|corner| corner + by)),
        ScreenSpec::LookAt { look_at, up, fov } => ScreenSpec::LookAt { look_at: *look_at + by, up: *up, fov: *fov },
    };
    legal(view, View { eye: view.eye + by, screen, ..view.clone() })
}

/// The eye and its screen turned about `pivot`, then moved.
fn moved(view: &View, vertical: DVec3, pivot: DVec3, turn: &dyn Fn(DVec3) -> DVec3, by: DVec3) -> View {
    let Some(sight) = Sight::of(view) else { return view.clone() };
    let place = |point: DVec3| pivot + turn(point - pivot) + by;
    let turned_up = |up: DVec3| upright(up, vertical, turn(sight.forward), turn(sight.top), turn(up));
    let screen = match &view.screen {
        ScreenSpec::Frame(Screen { origin, u, v }) => {
            ScreenSpec::Frame(Screen { origin: place(*origin), u: turn(*u), v: turn(*v) })
        }
        ScreenSpec::Centered { center, size, up } => {
            ScreenSpec::Centered { center: place(*center), size: *size, up: turned_up(*up) }
        }
        ScreenSpec::Corners(corners) => ScreenSpec::Corners(corners.map(place)),
        ScreenSpec::LookAt { look_at, up, fov } => {
            ScreenSpec::LookAt { look_at: place(*look_at), up: turned_up(*up), fov: *fov }
        }
    };
    legal(view, View { eye: place(view.eye), screen, ..view.clone() })
}

/// What is up in a turned picture: the vertical itself wherever the picture stands upright, so that documents keep
/// saying `0 1 0`; on a pole the picture's top; for a picture that leans, its own direction turned.
fn upright(up: DVec3, vertical: DVec3, forward: DVec3, top: DVec3, turned: DVec3) -> DVec3 {
    let level = forward.cross(vertical);
    if level.length() < NEAR_POLE {
        decimal::rounded_point(top, 6)
    } else if level.normalize().dot(top).abs() < 1e-6 && top.dot(vertical) > 0.0 {
        if up.normalize_or_zero().abs_diff_eq(vertical, 1e-9) { up } else { vertical }
    } else {
        decimal::rounded_point(turned, 6)
    }
}

/// The view with short decimals if that is legal, else as it is, else the one before.
fn legal(before: &View, after: View) -> View {
    let tidied = tidied(&after);
    if tidied.check().is_ok() {
        tidied
    } else if after.check().is_ok() {
        after
    } else {
        before.clone()
    }
}

/// Eye and point looked at, rounded far below a pixel. A screen given in space is left alone: its edges would not stay
/// what they are to each other.
fn tidied(view: &View) -> View {
    match &view.screen {
        ScreenSpec::LookAt { look_at, up, fov } => {
            let places = decimal::places((*look_at - view.eye).length() * 1e-5);
            let screen = ScreenSpec::LookAt { look_at: decimal::rounded_point(*look_at, places), up: *up, fov: *fov };
            View { eye: decimal::rounded_point(view.eye, places), screen, ..view.clone() }
        }
        ScreenSpec::Frame(_) | ScreenSpec::Centered { .. } | ScreenSpec::Corners(_) => view.clone(),
    }
}

/// A rotation about a unit axis (Rodrigues).
struct Rotation {
    axis: DVec3,
    sin: f64,
    cos: f64,
}

impl Rotation {
    fn about(axis: DVec3, degrees: f64) -> Rotation {
        let (sin, cos) = libm::sincos(libm::fmod(degrees, 360.0).to_radians());
        Rotation { axis, sin, cos }
    }

    fn apply(&self, vector: DVec3) -> DVec3 {
        let axis = self.axis;
        vector * self.cos + axis.cross(vector) * self.sin + axis * (axis.dot(vector) * (1.0 - self.cos))
    }
}
