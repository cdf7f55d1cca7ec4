//! The rule about faces of two objects in one place, where rounding decides which of them a ray meets.
//!
//! Faces are sorted by direction and distance from the origin, so only those in one plane are compared, and of those
//! only the ones whose extents overlap. Faces that merely touch along an edge share no area. Two opaque volumes that
//! stand on each other are as they should be: where their faces meet, nobody looks.

use super::Finding;
use super::scenery::{Halves, Scenery, Visible};
use crate::{DVec3, Enclosure, Shape, circle};
use std::collections::{BTreeSet, HashSet};

/// Larger meshes are compared as a whole only.
const MESH_FACETS: usize = 512;
/// Discs are taken for polygons of so many corners.
const DISC_CORNERS: u32 = 32;
/// When so many pairs are known, no more are looked for.
const PAIRS: usize = 100;
/// How far apart faces may be, in proportion to their coordinates, and still be in one place by rounding.
const ROUNDING: f64 = 1e-9;

/// A piece of a plane.
struct Face {
    /// The number of its object among the visible ones.
    object: usize,
    /// Its unit normal; outwards if it bounds a volume.
    normal: DVec3,
    /// What it is part of.
    body: Body,
    /// Its corners in turn; none if it is infinite.
    corners: Vec<DVec3>,
    /// A point of it.
    point: DVec3,
    /// The normal or its opposite, in parts of 10⁻⁶, and the distance from the origin along that.
    direction: [i64; 3],
    distance: f64,
    /// How large its coordinates are.
    magnitude: f64,
}

impl Face {
    /// The box around it, a little larger than it is; without end if it is infinite.
    fn extent(&self) -> (DVec3, DVec3) {
        if self.corners.is_empty() {
            return (DVec3::NEG_INFINITY, DVec3::INFINITY);
        }
        let rounding = DVec3::splat(ROUNDING * self.magnitude);
        let low = self.corners.iter().fold(DVec3::INFINITY, |low, corner| low.min(*corner));
        let high = self.corners.iter().fold(DVec3::NEG_INFINITY, |high, corner| high.max(*corner));
        (low - rounding, high + rounding)
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Body {
    Volume,
    Plane,
    Sheet,
}

/// Reports each pair of objects once.
pub(super) fn coincident_faces(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    let mut pairs = BTreeSet::new();
    equal_spheres(scenery, &mut pairs);
    equal_cones(scenery, &mut pairs);
    equal_meshes(scenery, &mut pairs);
    equal_planes(scenery, &mut pairs);
    for (first, second) in pairs.into_iter().take(PAIRS) {
        let name = |number: usize| scenery.visible[number].object.name.clone();
        findings.push(Finding::CoincidentFaces { first: name(first), second: name(second) });
    }
}

/// Spheres of one centre and radius.
fn equal_spheres(scenery: &Scenery<'_>, pairs: &mut BTreeSet<(usize, usize)>) {
    let mut spheres: Vec<([u64; 4], usize)> = Vec::new();
    for (number, visible) in scenery.visible.iter().enumerate() {
        if let Shape::Sphere { center, radius } = visible.object.shape {
            // Adding zero makes -0 and 0 the same place.
            spheres.push(([center.x, center.y, center.z, radius].map(|number| (number + 0.0).to_bits()), number));
        }
    }
    pair_equals(spheres, pairs);
}

/// Cones with the same two circles, whichever of them comes first.
fn equal_cones(scenery: &Scenery<'_>, pairs: &mut BTreeSet<(usize, usize)>) {
    let mut cones: Vec<([[u64; 4]; 2], usize)> = Vec::new();
    for (number, visible) in scenery.visible.iter().enumerate() {
        if let Shape::Cone { base, top, base_radius, top_radius, .. } = visible.object.shape {
            let circle = |center: DVec3, radius: f64| {
                [center.x, center.y, center.z, radius].map(|number| (number + 0.0).to_bits())
            };
            let mut circles = [circle(base, base_radius), circle(top, top_radius)];
            circles.sort_unstable();
            cones.push((circles, number));
        }
    }
    pair_equals(cones, pairs);
}

/// Meshes of one geometry in one placement, whatever their size.
fn equal_meshes(scenery: &Scenery<'_>, pairs: &mut BTreeSet<(usize, usize)>) {
    let mut meshes = Vec::new();
    for (number, visible) in scenery.visible.iter().enumerate() {
        if let Shape::Mesh(mesh) = &visible.object.shape
            && !mesh.geometry.facets.is_empty()
        {
            let placement = &mesh.placement;
            let placed = [placement.scale, placement.rotation, placement.position];
            let placed = placed.map(|vector| vector.to_array().map(|number| (number + 0.0).to_bits()));
            meshes.push(((std::sync::Arc::as_ptr(&mesh.geometry), placed), number));
        }
    }
    pair_equals(meshes, pairs);
}

/// Pairs the neighbours among equals: three equals make two pairs.
fn pair_equals<K: Ord>(mut items: Vec<(K, usize)>, pairs: &mut BTreeSet<(usize, usize)>) {
    items.sort();
    pairs.extend(items.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| (pair[0].1, pair[1].1)));
}

/// Faces in one plane.
fn equal_planes(scenery: &Scenery<'_>, pairs: &mut BTreeSet<(usize, usize)>) {
    let mut faces = Vec::new();
    for (number, visible) in scenery.visible.iter().enumerate() {
        if scenery.afford(10) {
            push_faces(number, visible, &mut faces);
        }
    }
    faces.sort_by(|a, b| a.direction.cmp(&b.direction).then(a.distance.total_cmp(&b.distance)));
    let mut rest = faces.as_slice();
    while let Some(first) = rest.first() {
        // A run of parallel faces, each as near to the one before it as rounding leaves equal ones.
        let run = rest
            .windows(2)
            .position(|pair| {
                let near = ROUNDING * pair[0].magnitude.max(pair[1].magnitude);
                pair[1].direction != first.direction || pair[1].distance - pair[0].distance > near
            })
            .map_or(rest.len(), |last| last + 1);
        let (in_one_plane, others) = rest.split_at(run);
        rest = others;
        overlaps(scenery, in_one_plane, pairs);
    }
}

/// Pairs the faces of one plane that share some of its area. They are swept along the axis that the plane is least
/// perpendicular to.
fn overlaps(scenery: &Scenery<'_>, faces: &[Face], pairs: &mut BTreeSet<(usize, usize)>) {
    let Some(normal) = faces.first().map(|face| face.normal.abs()).filter(|_| faces.len() > 1) else { return };
    let axis = (0..3).min_by(|&a, &b| normal[a].total_cmp(&normal[b])).unwrap_or(0);
    let mut swept: Vec<(DVec3, DVec3, &Face)> = faces
        .iter()
        .map(|face| {
            let (low, high) = face.extent();
            (low, high, face)
        })
        .collect();
    swept.sort_by(|a, b| a.0[axis].total_cmp(&b.0[axis]).then(a.2.object.cmp(&b.2.object)));
    for (place, (low, high, face)) in swept.iter().enumerate() {
        for (other_low, other_high, other) in &swept[place + 1..] {
            if pairs.len() >= PAIRS {
                return;
            }
            if other_low[axis] >= high[axis] || !scenery.afford(1) {
                break;
            }
            let beside = other_low.cmpgt(*high).any() || low.cmpgt(*other_high).any();
            if !beside && face.object != other.object && is_seen(scenery, face, other) && share_area(face, other) {
                pairs.insert((face.object.min(other.object), face.object.max(other.object)));
            }
        }
    }
}

/// Whether rays meet two faces in one place, or opaque volumes hide it.
fn is_seen(scenery: &Scenery<'_>, a: &Face, b: &Face) -> bool {
    let transparent = |face: &Face| scenery.visible[face.object].is_transparent();
    if transparent(a) || transparent(b) {
        return true;
    }
    match (a.body, b.body) {
        (Body::Volume, Body::Volume) => a.normal.dot(b.normal) > 0.0,
        // A volume stands on a plane: both faces are seen only from the plane's other side.
        (Body::Volume, Body::Plane) | (Body::Plane, Body::Volume) => {
            let volume = if a.body == Body::Volume { a } else { b };
            let outside = Halves { point: volume.point, normal: volume.normal };
            scenery.views.iter().any(|view| outside.side(view.eye) > 0)
        }
        (Body::Sheet, _) | (_, Body::Sheet) | (Body::Plane, Body::Plane) => true,
    }
}

/// Whether two faces, known to be nearly in one plane, are so and overlap by more than an edge: no line parts them
/// (the theorem of separating axes, for convex polygons).
fn share_area(a: &Face, b: &Face) -> bool {
    let tolerance = ROUNDING * a.magnitude.max(b.magnitude);
    let apart = |face: &Face, other: &Face| {
        face.corners.iter().any(|corner| (*corner - other.point).dot(other.normal).abs() > tolerance)
    };
    if apart(a, b) || apart(b, a) || a.normal.cross(b.normal).length() > ROUNDING {
        return false;
    }
    if a.corners.is_empty() || b.corners.is_empty() {
        return true;
    }
    let parts = |face: &Face, other: &Face| {
        (0..face.corners.len()).any(|corner| {
            let from = face.corners[corner];
            let to = face.corners[(corner + 1) % face.corners.len()];
            let Some(across) = (to - from).cross(face.normal).try_normalize() else { return false };
            let range = |face: &Face| {
                face.corners
                    .iter()
                    .map(|corner| (*corner - from).dot(across))
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), along| (low.min(along), high.max(along)))
            };
            let ((low, high), (other_low, other_high)) = (range(face), range(other));
            high <= other_low + tolerance || other_high <= low + tolerance
        })
    };
    !parts(a, b) && !parts(b, a)
}

/// Appends the faces of an object; a mesh of many facets has none here.
fn push_faces(object: usize, visible: &Visible<'_>, faces: &mut Vec<Face>) {
    let mut push = |body, normal: DVec3, corners: Vec<DVec3>, point: DVec3| {
        let Some(normal) = normal.try_normalize() else { return };
        let rounded = (normal * 1e6).to_array().map(|number| libm::round(number) as i64);
        let turned = rounded.into_iter().find(|&number| number != 0).is_some_and(|number| number < 0);
        let (direction, forward) = if turned { (rounded.map(|number| -number), -normal) } else { (rounded, normal) };
        let magnitude = corners.iter().fold(point.length(), |magnitude, corner| magnitude.max(corner.length()));
        let distance = point.dot(forward);
        faces.push(Face { object, normal, body, corners, point, direction, distance, magnitude });
    };
    match &visible.object.shape {
        Shape::Sphere { .. } => {}
        Shape::Plane { p0, p1, p2 } => push(Body::Plane, (*p1 - *p0).cross(*p2 - *p0), vec![], *p0),
        Shape::Facet { p0, p1, p2 } => {
            push(Body::Sheet, (*p1 - *p0).cross(*p2 - *p0), vec![*p0, *p1, *p2], *p0);
        }
        Shape::Cube { .. } | Shape::Parallelepiped { .. } => {
            let Some((origin, edges)) = visible.object.shape.frame() else { return };
            for across in 0..3 {
                let (u, v, w) = (edges[(across + 1) % 3], edges[(across + 2) % 3], edges[across]);
                let normal = u.cross(v);
                let outwards = if normal.dot(w) > 0.0 { normal } else { -normal };
                for (corner, normal) in [(origin, -outwards), (origin + w, outwards)] {
                    push(Body::Volume, normal, vec![corner, corner + u, corner + u + v, corner + v], corner);
                }
            }
        }
        Shape::Cone { base, top, base_radius, top_radius, capped: true } => {
            let axis = *top - *base;
            for (center, radius, normal) in [(*base, *base_radius, -axis), (*top, *top_radius, axis)] {
                if radius > 0.0 {
                    push(Body::Volume, normal, circle(center, axis, radius, DISC_CORNERS), center);
                }
            }
        }
        Shape::Cone { capped: false, .. } => {}
        Shape::Mesh(mesh) => {
            let geometry = &mesh.geometry;
            if geometry.facets.len() > MESH_FACETS {
                return;
            }
            let (body, outwards) = match mesh.enclosure() {
                Enclosure::Volume { inverted } => (Body::Volume, if inverted { -1.0 } else { 1.0 }),
                Enclosure::Sheet => (Body::Sheet, 1.0),
            };
            let linear = mesh.placement.linear();
            // A facet that stands twice in one mesh is one face here.
            let mut seen = HashSet::new();
            for facet in geometry.facets.iter().filter(|facet| seen.insert(**facet)) {
                let [a, b, c] =
                    facet.map(|vertex| linear * geometry.positions[vertex as usize] + mesh.placement.position);
                push(body, (b - a).cross(c - a) * outwards, vec![a, b, c], a);
            }
        }
    }
}
