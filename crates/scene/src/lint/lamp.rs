//! Rules about lamps that give no light to any picture.

use super::Finding;
use super::scenery::{Scenery, Visible};
use crate::{Rgb, View};

/// Ambient light alone shows no shape.
pub(super) fn no_lamp(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    if scenery.lamps().next().is_none() && !scenery.visible.is_empty() {
        findings.push(Finding::NoLamp { hidden: scenery.scene.lights.len() });
    }
}

/// A black lamp changes nothing.
pub(super) fn dark_lamp(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    let dark = scenery.lamps().filter(|lamp| lamp.color == Rgb::BLACK);
    findings.extend(dark.map(|lamp| Finding::DarkLamp { lamp: lamp.name.clone() }));
}

/// The views in which there are shadows; `None` if there are views, but none with shadows.
fn shadowed_views<'a>(scenery: &Scenery<'a>) -> Option<Vec<&'a View>> {
    let shadowed: Vec<&View> = scenery.views.iter().map(|view| &**view).filter(|view| view.steps.shadows).collect();
    (scenery.views.is_empty() || !shadowed.is_empty()).then_some(shadowed)
}

/// Objects shadow fully, transparent ones too: a lamp inside one lights nothing outside. A room with the eye in it is
/// as it should be; without views, a room is what has another object in it.
pub(super) fn lamp_inside(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    let Some(views) = shadowed_views(scenery) else { return };
    for lamp in scenery.lamps() {
        let is_room = |room: &Visible<'_>| {
            let shape = &room.object.shape;
            views.iter().any(|view| scenery.encloses(shape, view.eye))
                || views.is_empty() && is_furnished(scenery, room)
        };
        let around = scenery
            .visible
            .iter()
            .find(|visible| scenery.encloses(&visible.object.shape, lamp.position) && !is_room(visible));
        if let Some(visible) = around {
            findings.push(Finding::LampInside { lamp: lamp.name.clone(), object: visible.object.name.clone() });
        }
    }
}

/// Whether the middle of another object is inside this one.
pub(super) fn is_furnished(scenery: &Scenery<'_>, room: &Visible<'_>) -> bool {
    scenery.bounded().any(|visible| {
        let middle = scenery.middle(&visible.object.shape);
        !std::ptr::eq(visible.object, room.object)
            && middle.is_some_and(|middle| scenery.encloses(&room.object.shape, middle))
    })
}

/// Light does not pass an opaque plane, and neither does the sight. Without views, what is seen are the objects.
pub(super) fn lamp_behind_plane(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    let Some(views) = shadowed_views(scenery) else { return };
    for lamp in scenery.lamps() {
        let parted = scenery.opaque_planes().find(|(_, plane)| {
            let side = plane.side(lamp.position);
            if side == 0 || !scenery.afford(scenery.visible.len()) {
                return false;
            }
            if views.is_empty() {
                let mut sides = scenery.bounded().map(|visible| scenery.side(plane, &visible.object.shape)).peekable();
                sides.peek().is_some() && sides.all(|other| other == -side)
            } else {
                views.iter().all(|view| plane.side(view.eye) == -side)
            }
        });
        if let Some((plane, _)) = parted {
            findings.push(Finding::LampBehindPlane { lamp: lamp.name.clone(), plane: plane.name.clone() });
        }
    }
}
