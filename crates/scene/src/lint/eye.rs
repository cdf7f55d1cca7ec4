//! Rules about the eye and the screen of each view.

use super::Finding;
use super::lamp::is_furnished;
use super::scenery::{Halves, Scenery};

/// An eye inside glass starts in its medium; an eye inside something opaque sees only the inside. A room is meant to
/// hold the eye: it has other objects in it.
pub(super) fn eye_inside(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    for view in scenery.views {
        for visible in &scenery.visible {
            let object = visible.object;
            let behind = Halves::of(&object.shape).is_some_and(|plane| plane.side(view.eye) < 0);
            let inside = scenery.encloses(&object.shape, view.eye);
            let (name, transparent) = (object.name.clone(), visible.is_transparent());
            let view = view.name.clone();
            if behind && transparent {
                findings.push(Finding::EyeBehindGlassPlane { view, plane: name });
            } else if inside && transparent {
                findings.push(Finding::EyeInGlass { view, object: name });
            } else if inside && !is_furnished(scenery, visible) {
                findings.push(Finding::EyeInside { view, object: name });
            }
        }
    }
}

/// An opaque plane hides everything behind it.
pub(super) fn eye_behind_plane(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    for view in scenery.views {
        for (object, plane) in scenery.opaque_planes() {
            let side = plane.side(view.eye);
            if side == 0 || !scenery.afford(scenery.visible.len()) {
                continue;
            }
            let mut sides = scenery.bounded().map(|visible| scenery.side(&plane, &visible.object.shape)).peekable();
            if sides.peek().is_some() && sides.all(|other| other == -side) {
                findings.push(Finding::EyeBehindPlane { view: view.name.clone(), plane: object.name.clone() });
            }
        }
    }
}

/// A plane through the eye is seen from its edge, that is, not at all.
pub(super) fn plane_through_eye(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    for view in scenery.views {
        for visible in &scenery.visible {
            if Halves::of(&visible.object.shape).is_some_and(|plane| plane.side(view.eye) == 0) {
                let (view, plane) = (view.name.clone(), visible.object.name.clone());
                findings.push(Finding::PlaneThroughEye { view, plane });
            }
        }
    }
}

/// Left and right are exchanged.
pub(super) fn mirrored_view(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    for view in scenery.views {
        if view.resolved_screen().is_ok_and(|screen| screen.is_mirrored(view.eye)) {
            findings.push(Finding::MirroredView { view: view.name.clone() });
        }
    }
}

/// The screen's sides do not relate as the counts of pixels do. One per cent is not seen.
pub(super) fn pixels_not_square(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    for view in scenery.views {
        let Ok(screen) = view.resolved_screen() else { continue };
        let (width, height) = (f64::from(view.width), f64::from(view.height));
        let ratio = (screen.u.length() / width) / (screen.v.length() / height);
        // A picture of a single row or column is a sample, not something to look at.
        if (ratio - 1.0).abs() > 0.01 && view.width > 1 && view.height > 1 {
            findings.push(Finding::PixelsNotSquare { view: view.name.clone(), ratio });
        }
    }
}
