//! Rules about the depth limit: a ray of that level casts no further ray.

use super::scenery::{Halves, Scenery};
use super::{Bounce, Finding};
use crate::{DVec3, Enclosure, Name, Shape, Steps, limits};

/// Every depth limit in force, whose it is, and the steps that are carried out under it.
fn limits_in_force(scenery: &Scenery<'_>) -> Vec<(Option<Name>, u32, Steps)> {
    let mut own = Vec::new();
    let mut world = None;
    for view in scenery.views {
        match view.depth {
            Some(depth) => own.push((Some(view.name.clone()), depth, view.steps)),
            None => {
                let steps: &mut Steps = world.get_or_insert(view.steps);
                steps.reflection |= view.steps.reflection;
                steps.transparency |= view.steps.transparency;
            }
        }
    }
    if scenery.views.is_empty() {
        world = Some(Steps::default());
    }
    let world = world.map(|steps| (None, scenery.scene.world.depth, steps));
    world.into_iter().chain(own).collect()
}

/// The least depth with which something shows what it mirrors or lets through: a mirror or a sheet sends one ray; a
/// volume sends one in, which must send another out.
pub(super) fn depth_too_small(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    let mut needs: Vec<(Bounce, u32, &Name)> = Vec::new();
    for visible in &scenery.visible {
        let name = &visible.object.name;
        if visible.is_transparent() {
            let volume = match &visible.object.shape {
                Shape::Sphere { .. } | Shape::Cube { .. } | Shape::Parallelepiped { .. } => true,
                Shape::Cone { capped, .. } => *capped,
                Shape::Plane { .. } | Shape::Facet { .. } => false,
                Shape::Mesh(mesh) => scenery.enclosure(&mesh.geometry) != Enclosure::Sheet,
            };
            needs.push((Bounce::Transparency, if volume { 2 } else { 1 }, name));
        }
        if visible.is_mirror() {
            needs.push((Bounce::Reflection, 1, name));
        }
    }
    for (view, depth, steps) in limits_in_force(scenery) {
        let mut unmet: Vec<_> = needs
            .iter()
            .filter(|(bounce, enough, _)| {
                let done = match bounce {
                    Bounce::Reflection => steps.reflection,
                    Bounce::Transparency => steps.transparency,
                };
                done && depth < *enough
            })
            .collect();
        // The most demanding, and of those the first.
        unmet.sort_by_key(|(_, enough, _)| std::cmp::Reverse(*enough));
        if let Some(&&(bounce, enough, object)) = unmet.first() {
            findings.push(Finding::DepthTooSmall { view, depth, enough, object: object.clone(), bounce });
        }
    }
}

/// A mirror that is a plane.
struct Mirror<'a> {
    plane: Halves,
    /// The plane's direction, equal for those that differ by rounding or by the sign.
    direction: [i64; 3],
    kr: f64,
    name: &'a Name,
}

/// Between two parallel mirrors each bounce leaves the share `Kr`; where more than half is left at the depth limit, the
/// corridor of images visibly ends in the dark.
pub(super) fn facing_mirrors(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    let mut mirrors: Vec<Mirror<'_>> = Vec::new();
    for visible in scenery.visible.iter().filter(|visible| visible.is_mirror()) {
        if let (Some(plane), Some(surface)) = (Halves::of(&visible.object.shape), visible.surfaces.first()) {
            let [x, y, z] = (plane.normal * 1e6).to_array().map(|coordinate| libm::round(coordinate) as i64);
            let turned = x < 0 || x == 0 && (y < 0 || y == 0 && z < 0);
            let direction = if turned { [-x, -y, -z] } else { [x, y, z] };
            mirrors.push(Mirror { plane, direction, kr: surface.kr.max_channel(), name: &visible.object.name });
        }
    }
    // Of each direction the two that mirror most come first; the sort keeps equals in document order.
    mirrors.sort_by(|a, b| a.direction.cmp(&b.direction).then(b.kr.total_cmp(&a.kr)));
    let facing = |a: &Mirror<'_>, b: &Mirror<'_>| {
        // Their distances from the eye along one normal have different signs if it is between them.
        let between =
            |eye: DVec3| (a.plane.point - eye).dot(a.plane.normal) * (b.plane.point - eye).dot(a.plane.normal);
        a.direction == b.direction
            && (scenery.views.is_empty() || scenery.views.iter().any(|view| between(view.eye) < 0.0))
    };
    let pairs = mirrors.windows(2).filter(|pair| facing(&pair[0], &pair[1]));
    let brightest = pairs.max_by(|a, b| (a[0].kr * a[1].kr).total_cmp(&(b[0].kr * b[1].kr)));
    let Some([first, second]) = brightest else { return };
    let bounce = (first.kr * second.kr).sqrt();
    for (view, depth, steps) in limits_in_force(scenery) {
        if steps.reflection && (1..limits::DEPTH).contains(&depth) && libm::pow(bounce, f64::from(depth)) > 0.5 {
            let bounces = libm::ceil(libm::log(0.05) / libm::log(bounce));
            let enough = if bounce < 1.0 { bounces.min(f64::from(limits::DEPTH)) as u32 } else { limits::DEPTH };
            let (first, second) = (first.name.clone(), second.name.clone());
            findings.push(Finding::FacingMirrors { view, depth, enough, first, second });
        }
    }
}
