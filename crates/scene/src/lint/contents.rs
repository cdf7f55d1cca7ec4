//! Rules about what is in the scene, and what of it any picture can show.

use super::Finding;
use super::scenery::Scenery;
use crate::{Enclosure, Shape};

/// Nothing is there to be seen.
pub(super) fn no_object(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    if scenery.visible.is_empty() {
        findings.push(Finding::NoObject { hidden: scenery.scene.objects.len() });
    }
}

/// A mesh without facets is never met.
pub(super) fn empty_mesh(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    for visible in &scenery.visible {
        if visible.object.shape.geometry().is_some_and(|geometry| geometry.facets.is_empty()) {
            findings.push(Finding::EmptyMesh { object: visible.object.name.clone() });
        }
    }
}

/// A ray that is on one side of an opaque plane stays there: mirrors keep it, and nothing lets it through.
pub(super) fn hidden_behind_plane(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    for (object, plane) in scenery.opaque_planes() {
        let mut sides = scenery.views.iter().map(|view| plane.side(view.eye));
        let Some(eyes) = sides.next().filter(|&side| side != 0 && sides.all(|other| other == side)) else { continue };
        if !scenery.afford(scenery.visible.len()) {
            return;
        }
        let (mut hidden, mut count, mut all) = (None, 0, 0);
        for visible in scenery.bounded() {
            all += 1;
            if scenery.side(&plane, &visible.object.shape) == -eyes {
                count += 1;
                hidden = hidden.or(Some(&visible.object.name));
            }
        }
        // Where the plane hides everything, it is rather the eyes that are on the wrong side: another rule says so.
        if let Some(first) = hidden.filter(|_| count < all) {
            findings.push(Finding::HiddenBehindPlane { plane: object.name.clone(), object: first.clone(), count });
        }
    }
}

/// An open mesh is a sheet without thickness: light passes it straight on.
pub(super) fn open_glass(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    for visible in scenery.visible.iter().filter(|visible| visible.is_transparent()) {
        let Some(geometry) = visible.object.shape.geometry().filter(|geometry| !geometry.facets.is_empty()) else {
            continue;
        };
        if scenery.enclosure(geometry) == Enclosure::Sheet {
            findings.push(Finding::OpenGlass { object: visible.object.name.clone() });
        }
    }
}

/// A facet and an open cone are sheets, too: their refraction index counts for nothing. A plain pane of the world's index is as expected.
pub(super) fn sheet_glass(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    for visible in scenery.visible.iter().filter(|visible| visible.is_transparent()) {
        let refracts = visible.surfaces.iter().any(|surface| surface.index != scenery.scene.world.index);
        let sheet = matches!(visible.object.shape, Shape::Facet { .. } | Shape::Cone { capped: false, .. });
        if sheet && refracts {
            findings.push(Finding::SheetGlass { object: visible.object.name.clone() });
        }
    }
}
