//! Moving things with the pointer: from where it went to a translation in space.
//!
//! A drag holds the point that was grabbed. Free, that point stays under the pointer in the plane through it that is
//! parallel to the screen. Held to an axis, it moves to the point of that axis nearest to the pointer.

use crate::decimal;
use crate::selection::Places;
use crate::{Item, StepName};
use lancer_scene::{DVec3, Edit, ListEdit, Object, PointLight, Shape, Stage};
use lancer_trace::Camera;
use std::sync::Arc;

/// One of the axes of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// x.
    X,
    /// y.
    Y,
    /// z.
    Z,
}

impl Axis {
    /// The three axes in their order.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    /// The unit vector.
    pub fn direction(self) -> DVec3 {
        match self {
            Axis::X => DVec3::X,
            Axis::Y => DVec3::Y,
            Axis::Z => DVec3::Z,
        }
    }
}

/// Where a dragged thing may go.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Constraint {
    /// In the plane parallel to the screen.
    #[default]
    ViewPlane,
    /// Along an axis.
    Along(Axis),
}

/// A drag in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    /// The picture that the pointer is in.
    pub camera: Camera,
    /// Where the pointer was pressed, in pixels from the top left.
    pub start: (f64, f64),
    /// The point of space that was grabbed: under the pointer, or a thing's own place.
    pub grabbed: DVec3,
}

/// Below this sine of the angle between an axis and the ray, the axis is seen end-on and up and down move along it.
const END_ON: f64 = 0.05;

impl Drag {
    /// How far the pointer at `(x, y)` moves the thing. `None` where no point of the plane or the axis is under it.
    pub fn translation(&self, to: (f64, f64), constraint: Constraint) -> Option<DVec3> {
        let camera = &self.camera;
        let screen = camera.screen();
        let normal = screen.u.cross(screen.v).try_normalize()?;
        let pixel = self.pixel_length(normal)?;
        let by = match constraint {
            Constraint::ViewPlane => self.on_plane(to, normal)? - self.on_plane(self.start, normal)?,
            Constraint::Along(axis) => {
                let along = axis.direction();
                let sight = (self.grabbed - camera.eye()).try_normalize()?;
                let across = sight - along * sight.dot(along);
                let distance = if across.length() < END_ON {
                    // away from the eye for upwards, as far as that would be across the picture
                    (self.start.1 - to.1) * pixel * sight.dot(along).signum()
                } else {
                    // in the plane through the axis that faces the eye most
                    let facing = across.normalize();
                    (self.on_plane(to, facing)? - self.on_plane(self.start, facing)?).dot(along)
                };
                along * distance
            }
        };
        // a hundredth of a pixel is nothing to see
        let rounded = decimal::rounded_point(by, decimal::places(pixel * 0.01));
        rounded.is_finite().then_some(rounded)
    }

    /// The length of a pixel in the plane of the grabbed point.
    fn pixel_length(&self, normal: DVec3) -> Option<f64> {
        let (camera, screen) = (&self.camera, self.camera.screen());
        let factor = (self.grabbed - camera.eye()).dot(normal) / (screen.origin - camera.eye()).dot(normal);
        let pixel = screen.u.length() / f64::from(camera.width()) * factor;
        (pixel.is_finite() && pixel > 0.0).then_some(pixel)
    }

    /// The point under the pointer in the plane through the grabbed point; `None` behind the eye.
    fn on_plane(&self, (x, y): (f64, f64), normal: DVec3) -> Option<DVec3> {
        let ray = self.camera.ray(x, y);
        let distance = (self.grabbed - ray.origin).dot(normal) / ray.direction.dot(normal);
        (distance.is_finite() && distance > 0.0).then(|| ray.at(distance))
    }
}

/// The translation that brings `anchor` to the nearest point of a grid, in the directions in which it moves.
pub fn snapped(by: DVec3, anchor: DVec3, step: f64) -> DVec3 {
    if !(step.is_finite() && step > 0.0) {
        return by;
    }
    let snap = |by: f64, anchor: f64| {
        if by == 0.0 { 0.0 } else { ((anchor + by) / step).round() * step - anchor }
    };
    let snapped = DVec3::new(snap(by.x, anchor.x), snap(by.y, anchor.y), snap(by.z, anchor.z));
    if snapped.is_finite() { snapped } else { by }
}

/// The object elsewhere.
#[must_use]
pub fn translated(object: &Object, by: DVec3) -> Object {
    let mut object = Object::clone(object);
    let move_point = |point: &mut DVec3| *point = decimal::sum_point(*point, by);
    match &mut object.shape {
        Shape::Sphere { center, .. } | Shape::Cube { center, .. } => move_point(center),
        Shape::Plane { p0, p1, p2 } | Shape::Facet { p0, p1, p2 } => [p0, p1, p2].into_iter().for_each(move_point),
        Shape::Parallelepiped { origin, .. } => move_point(origin),
        Shape::Cone { base, top, .. } => [base, top].into_iter().for_each(move_point),
        Shape::Mesh(mesh) => move_point(&mut mesh.placement.position),
    }
    object
}

/// The lamp elsewhere.
#[must_use]
pub fn translated_light(light: &PointLight, by: DVec3) -> PointLight {
    PointLight { position: decimal::sum_point(light.position, by), ..PointLight::clone(light) }
}

/// The edit that moves objects and lamps, and the name of its step. Other things do not move; `None` if none does.
pub fn moved<'a>(stage: &Stage, items: impl IntoIterator<Item = &'a Item>, by: DVec3) -> Option<(StepName, Edit)> {
    let (scene, places) = (&stage.scene, Places::of(stage));
    let (mut edits, mut names) = (Vec::new(), Vec::new());
    for item in items {
        let Some(index) = places.place(item) else { continue };
        let edit = match item {
            Item::Object(_) => scene
                .objects
                .get(index)
                .map(|object| Edit::Objects(ListEdit::Set { index, item: Arc::new(translated(object, by)) })),
            Item::Light(_) => scene
                .lights
                .get(index)
                .map(|light| Edit::Lights(ListEdit::Set { index, item: Arc::new(translated_light(light, by)) })),
            Item::World | Item::Material(_) | Item::View(_) => None,
        };
        if edit.is_some() {
            names.extend(item.name().cloned());
        }
        edits.extend(edit);
    }
    let name = match names.as_slice() {
        [] => return None,
        [name] => StepName::Moved(name.clone()),
        several => StepName::MovedMany(several.len()),
    };
    Some((name, Edit::Batch(edits)))
}

/// The place of a thing that a drag with the keyboard grabs: the middle of an object, a lamp's position.
pub fn place_of(stage: &Stage, item: &Item) -> Option<DVec3> {
    let index = item.place(stage)?;
    match item {
        Item::Object(_) => stage.scene.objects.get(index).map(|object| match &object.shape {
            Shape::Plane { p0, .. } => *p0,
            shape @ (Shape::Sphere { .. }
            | Shape::Facet { .. }
            | Shape::Cube { .. }
            | Shape::Parallelepiped { .. }
            | Shape::Cone { .. }
            | Shape::Mesh(_)) => shape.bounds().map_or(DVec3::ZERO, |(low, high)| (low + high) * 0.5),
        }),
        Item::Light(_) => stage.scene.lights.get(index).map(|light| light.position),
        Item::View(_) => stage.views.get(index).map(|view| view.eye),
        Item::World | Item::Material(_) => None,
    }
}
