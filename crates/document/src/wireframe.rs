//! Outlines: what is drawn over a picture to show what is selected, where the ground is and how the axes run.
//!
//! Lines of space are clipped a little in front of the eye and projected; a sphere is shown by its true silhouette, the
//! circle in which the cone of its tangents from the eye touches it.

use crate::silhouette::Edges;
use crate::{Axis, Item, decimal};
use lancer_scene::{DVec3, Mesh, MeshGeometry, Object, Shape, Stage, View};
use lancer_trace::Camera;
use std::sync::Arc;

/// A line through points of a picture, in pixels from the top left.
pub type Polyline = Vec<(f64, f64)>;

/// A mesh with more facets than these is shown by the box around it.
const MOST_FACETS: usize = 20_000;
/// Segments of a circle.
const SEGMENTS: u32 = 96;
/// Cells along each side of a plane's patch.
const PATCH: i32 = 4;
/// Half the size of a lamp's star, in pixels.
const STAR: f64 = 9.0;

/// Edges of meshes that were worked out, kept while their geometry is in use.
#[derive(Clone, Debug, Default)]
pub struct Wireframes {
    meshes: Vec<(Arc<MeshGeometry>, Shown)>,
}

impl Wireframes {
    /// The outline of a thing in a picture: an object, a lamp's star, another view's eye and screen. A material is shown
    /// by the objects that have it, the world by nothing. What lies outside of the picture by more than its own size is
    /// cut off.
    pub fn outline(&mut self, stage: &Stage, item: &Item, camera: &Camera) -> Vec<Polyline> {
        let Some(place) = item.place(stage) else { return Vec::new() };
        let scene = &stage.scene;
        match item {
            Item::World => Vec::new(),
            Item::Light(_) => scene.lights.get(place).map_or_else(Vec::new, |light| star(light.position, camera)),
            Item::Object(_) => scene.objects.get(place).map_or_else(Vec::new, |object| self.object(object, camera)),
            Item::Material(name) => {
                let users = scene
                    .objects
                    .iter()
                    .filter(|object| object.visible)
                    .filter(|object| object.material_refs().any(|material| material.name() == Some(name)));
                users.flat_map(|object| self.object(object, camera)).collect()
            }
            Item::View(_) => stage.views.get(place).map_or_else(Vec::new, |view| pyramid(view, camera)),
        }
    }

    /// The outline of an object.
    pub fn object(&mut self, object: &Object, camera: &Camera) -> Vec<Polyline> {
        match &object.shape {
            Shape::Sphere { center, radius } => sphere(*center, *radius, camera),
            Shape::Plane { p0, p1, p2 } => patch(*p0, *p1 - *p0, *p2 - *p0, camera),
            Shape::Facet { p0, p1, p2 } => projected(&[*p0, *p1, *p2, *p0], camera),
            Shape::Cube { .. } | Shape::Parallelepiped { .. } => object
                .shape
                .frame()
                .map_or_else(Vec::new, |(origin, edges)| segments(&box_edges(origin, edges), camera)),
            Shape::Cone { base, top, base_radius, top_radius, .. } => {
                cone([*base, *top], [*base_radius, *top_radius], camera)
            }
            Shape::Mesh(mesh) => self.mesh(mesh, camera),
        }
    }

    fn mesh(&mut self, mesh: &Mesh, camera: &Camera) -> Vec<Polyline> {
        // edges that only this cache still knows are of geometries that are gone
        self.meshes.retain(|(geometry, _)| Arc::strong_count(geometry) > 1);
        let known = self.meshes.iter().find(|(geometry, _)| Arc::ptr_eq(geometry, &mesh.geometry));
        let shown = match known {
            Some((_, shown)) => shown.clone(),
            None => {
                let shown = Shown::of(&mesh.geometry);
                self.meshes.push((Arc::clone(&mesh.geometry), shown.clone()));
                shown
            }
        };
        let (linear, position) = (mesh.placement.linear(), mesh.placement.position);
        let placed = |line: [DVec3; 2]| line.map(|point| linear * point + position);
        let placed: Vec<[DVec3; 2]> = match &shown {
            Shown::Edges(edges) => {
                let eye = linear.inverse() * (camera.eye() - position);
                edges.outline(eye).map(placed).collect()
            }
            Shown::Box(lines) => lines.iter().copied().map(placed).collect(),
        };
        segments(&placed, camera)
    }
}

/// What shows a mesh, before placement.
#[derive(Clone, Debug)]
enum Shown {
    /// Its outline.
    Edges(Arc<Edges>),
    /// The box around its vertices.
    Box(Arc<[[DVec3; 2]]>),
}

impl Shown {
    fn of(geometry: &MeshGeometry) -> Shown {
        if geometry.facets.len() <= MOST_FACETS {
            return Shown::Edges(Arc::new(Edges::of(geometry)));
        }
        let corners = geometry.positions.iter().fold(None, |corners: Option<(DVec3, DVec3)>, &position| {
            Some(corners.map_or((position, position), |(low, high)| (low.min(position), high.max(position))))
        });
        let (low, high) = corners.unwrap_or_default();
        let size = high - low;
        Shown::Box(box_edges(low, [DVec3::X * size.x, DVec3::Y * size.y, DVec3::Z * size.z]).into())
    }
}

/// The twelve edges of a box.
fn box_edges(origin: DVec3, [u, v, w]: [DVec3; 3]) -> [[DVec3; 2]; 12] {
    let edge = |from: DVec3, along: DVec3| [origin + from, origin + from + along];
    let zero = DVec3::ZERO;
    [
        edge(zero, u),
        edge(v, u),
        edge(w, u),
        edge(v + w, u),
        edge(zero, v),
        edge(u, v),
        edge(w, v),
        edge(u + w, v),
        edge(zero, w),
        edge(u, w),
        edge(v, w),
        edge(u + v, w),
    ]
}

/// The silhouette of a sphere; from inside of it, its three great circles.
fn sphere(center: DVec3, radius: f64, camera: &Camera) -> Vec<Polyline> {
    let to_eye = camera.eye() - center;
    let distance = to_eye.length();
    if distance <= radius {
        return Axis::ALL.into_iter().flat_map(|axis| circle(center, axis.direction(), radius, camera)).collect();
    }
    // tangents touch the sphere in the circle at r²/d from its centre, whose radius is r·√(1 - r²/d²)
    let along = to_eye / distance;
    let ratio = radius / distance;
    let touching = radius * ((1.0 - ratio) * (1.0 + ratio)).sqrt();
    circle(center + along * (radius * ratio), along, touching, camera)
}

/// The two circles of a cone, and the two lines of its side along which the eye's rays touch it; from inside of it four
/// lines of its side.
fn cone([base, top]: [DVec3; 2], radii: [f64; 2], camera: &Camera) -> Vec<Polyline> {
    let (axis, height) = ((top - base).normalize_or_zero(), (top - base).length());
    let circles = [(base, radii[0]), (top, radii[1])].into_iter().filter(|(_, radius)| *radius > 0.0);
    let mut lines: Vec<Polyline> = circles.flat_map(|(center, radius)| circle(center, axis, radius, camera)).collect();
    // the normal at the angle φ is cos φ·u + sin φ·v - m·a; it is perpendicular to the sight from the eye where
    // cos φ = (R₀ + m·z)/ρ, with the eye at z along the axis and ρ beside it, in the direction u
    let to_eye = camera.eye() - base;
    let (z, slope) = (to_eye.dot(axis), (radii[1] - radii[0]) / height);
    let beside = to_eye - axis * z;
    let cosine = (radii[0] + slope * z) / beside.length();
    let u = beside.try_normalize().unwrap_or_else(|| axis.any_orthonormal_vector());
    let v = axis.cross(u);
    let directions = if cosine.abs() < 1.0 {
        let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
        vec![u * cosine + v * sine, u * cosine - v * sine]
    } else {
        vec![u, v, -u, -v]
    };
    let side: Vec<[DVec3; 2]> =
        directions.into_iter().map(|way| [base + way * radii[0], top + way * radii[1]]).collect();
    lines.extend(segments(&side, camera));
    lines
}

fn circle(center: DVec3, normal: DVec3, radius: f64, camera: &Camera) -> Vec<Polyline> {
    let mut points = lancer_scene::circle(center, normal, radius, SEGMENTS);
    points.extend(points.first().copied());
    projected(&points, camera)
}

/// The parallelogram of a plane's three points as a grid.
fn patch(p0: DVec3, u: DVec3, v: DVec3, camera: &Camera) -> Vec<Polyline> {
    let lines = (0..=PATCH).flat_map(|step| {
        let part = f64::from(step) / f64::from(PATCH);
        [[p0 + u * part, p0 + u * part + v], [p0 + v * part, p0 + v * part + u]]
    });
    segments(&lines.collect::<Vec<_>>(), camera)
}

/// A star of one size on every picture where a lamp is.
fn star(position: DVec3, camera: &Camera) -> Vec<Polyline> {
    let (width, height) = (f64::from(camera.width()), f64::from(camera.height()));
    let Some((x, y)) = camera.project(position) else { return Vec::new() };
    if !((-STAR..=width + STAR).contains(&x) && (-STAR..=height + STAR).contains(&y)) {
        return Vec::new();
    }
    let ray = |dx: f64, dy: f64| vec![(x + dx * 0.4, y + dy * 0.4), (x + dx, y + dy)];
    let slant = STAR * std::f64::consts::FRAC_1_SQRT_2;
    let around = [(STAR, 0.0), (slant, slant), (0.0, STAR), (-slant, slant)];
    around.into_iter().flat_map(|(dx, dy)| [ray(dx, dy), ray(-dx, -dy)]).collect()
}

/// Another view's screen and the lines from its eye to the screen's corners.
fn pyramid(view: &View, camera: &Camera) -> Vec<Polyline> {
    let Ok(screen) = view.resolved_screen() else { return Vec::new() };
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)].map(|(x, y)| screen.point(x, y));
    let mut lines = projected(&corners, camera);
    let sight = corners.iter().take(4).map(|&corner| [view.eye, corner]).collect::<Vec<_>>();
    lines.extend(segments(&sight, camera));
    lines
}

/// The ground and the axes of space in a picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Grid {
    /// Lines one step apart.
    pub minor: Vec<Polyline>,
    /// Every tenth line.
    pub major: Vec<Polyline>,
    /// The axes x, y, z through the origin.
    pub axes: [Vec<Polyline>; 3],
    /// How far apart the lines are, in scene units.
    pub step: f64,
}

/// Lines of the ground on each side of the point below the eye's focus.
const GRID_LINES: i32 = 30;

/// The grid of the plane through the origin that is perpendicular to `vertical` (y or z), around the place below
/// `focus`, in steps that suit its distance.
pub fn grid(camera: &Camera, vertical: DVec3, focus: DVec3) -> Grid {
    let distance = (focus - camera.eye()).length();
    let step = decimal_step(distance);
    let other = if vertical == DVec3::Z { DVec3::Y } else { DVec3::Z };
    // whole numbers of steps, so that the lines stand where round coordinates are
    let place = |along: DVec3| (focus.dot(along) / (step * 10.0)).round() as i64 * 10;
    let (across, deep) = (place(DVec3::X), place(other));
    let reach = step * f64::from(GRID_LINES);
    let (mut minor, mut major) = (Vec::new(), Vec::new());
    for number in -GRID_LINES..=GRID_LINES {
        let number = i64::from(number);
        for (along, base, fixed, middle) in [(DVec3::X, across, other, deep), (other, deep, DVec3::X, across)] {
            let line = middle + number;
            if line == 0 {
                continue; // an axis
            }
            let offset = fixed * (line as f64 * step);
            let from = offset + along * (base as f64 * step - reach);
            let lines = if line % 10 == 0 { &mut major } else { &mut minor };
            lines.extend(segments(&[[from, from + along * (2.0 * reach)]], camera));
        }
    }
    let axes = Axis::ALL.map(|axis| {
        let along = axis.direction();
        let tens = if along == vertical {
            0
        } else if axis == Axis::X {
            across
        } else {
            deep
        };
        let middle = tens as f64 * step;
        segments(&[[along * (middle - reach), along * (middle + reach)]], camera)
    });
    Grid { minor, major, axes, step }
}

/// A tenth of the distance, rounded down to a power of ten.
fn decimal_step(distance: f64) -> f64 {
    let places = decimal::places((distance * 0.2).clamp(1e-9, 1e9));
    decimal::rounded(10.0_f64.powi(-places), places)
}

/// Polylines of lines of space, each clipped and projected.
fn segments(lines: &[[DVec3; 2]], camera: &Camera) -> Vec<Polyline> {
    let picture = Picture::of(camera);
    lines.iter().filter_map(|&[a, b]| picture.segment(a, b)).map(|(a, b)| vec![a, b]).collect()
}

/// A line through points of space, projected, in as many pieces as clipping leaves.
fn projected(points: &[DVec3], camera: &Camera) -> Vec<Polyline> {
    let picture = Picture::of(camera);
    let mut pieces: Vec<Polyline> = Vec::new();
    for pair in points.windows(2) {
        let &[a, b] = pair else { continue };
        let Some((a, b)) = picture.segment(a, b) else { continue };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&a) => piece.push(b),
            _ => pieces.push(vec![a, b]),
        }
    }
    pieces
}

/// What is nearer to the eye's plane than this part of the screen's distance is cut off.
const NEAR: f64 = 1e-4;

/// A camera as lines are clipped by it: a point of space becomes `(X, Y, D)` with `D` = 0 at the eye and 1 on the
/// screen, its pixel is `(X/D, Y/D)`. All three are linear in the point, so that clipping is exact before the division.
struct Picture {
    eye: DVec3,
    /// The rows of the projection.
    rows: [DVec3; 3],
    width: f64,
    height: f64,
}

impl Picture {
    fn of(camera: &Camera) -> Picture {
        let (eye, screen) = (camera.eye(), camera.screen());
        let (width, height) = (f64::from(camera.width()), f64::from(camera.height()));
        let normal = screen.u.cross(screen.v);
        let to_origin = screen.origin - eye;
        let depth = normal / normal.dot(to_origin);
        // the coordinates of a vector along u and v
        let along_u = screen.v.cross(normal) / normal.length_squared();
        let along_v = normal.cross(screen.u) / normal.length_squared();
        let row = |along: DVec3, pixels: f64| (along - depth * along.dot(to_origin)) * pixels;
        Picture { eye, rows: [row(along_u, width), row(along_v, height), depth], width, height }
    }

    /// A line of space in the picture, without what is behind the eye or outside of three by three pictures around this
    /// one (Liang and Barsky 1984, in homogeneous coordinates).
    fn segment(&self, a: DVec3, b: DVec3) -> Option<((f64, f64), (f64, f64))> {
        let at = |point: DVec3| DVec3::from(self.rows.map(|row| row.dot(point - self.eye)));
        let (a, b) = (at(a), at(b));
        let (w, h) = (self.width, self.height);
        let room = |p: DVec3| [p.z - NEAR, p.x + w * p.z, 2.0 * w * p.z - p.x, p.y + h * p.z, 2.0 * h * p.z - p.y];
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (before, after) in room(a).into_iter().zip(room(b)) {
            let crossing = before / (before - after);
            match (before >= 0.0, after >= 0.0) {
                (true, true) => {}
                (false, true) => from = from.max(crossing),
                (true, false) => to = to.min(crossing),
                (false, false) => return None,
            }
        }
        let pixel = |part: f64| {
            let point = if part == 0.0 {
                a
            } else if part == 1.0 {
                b
            } else {
                a + (b - a) * part
            };
            let (x, y) = (point.x / point.z, point.y / point.z);
            // rounding may leave a hair outside
            (x.is_finite() && y.is_finite()).then(|| (x.clamp(-w, 2.0 * w), y.clamp(-h, 2.0 * h)))
        };
        (from < to).then(|| Some((pixel(from)?, pixel(to)?))).flatten()
    }
}
