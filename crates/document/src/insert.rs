//! Adding things: each kind arrives in front of the active view, at a size that suits it, under a name of its own.

use crate::navigate::said_vertical;
use crate::sight::Sight;
use crate::{Command, Item, StepName, decimal, focus, naming};
use lancer_scene::{
    DVec3, Edit, ListEdit, Material, Mesh, MeshGeometry, Object, Placement, PointLight, Scene, ScreenSpec, Shape,
    Stage, Steps, Surface, View, limits,
};
use lancer_trace::World;
use std::sync::Arc;

/// What can be added.
#[derive(Clone, Debug, PartialEq)]
pub enum NewItem {
    /// A sphere.
    Sphere,
    /// A level plane.
    Plane,
    /// A facet that faces the eye.
    Facet,
    /// A cube.
    Cube,
    /// A box, half as high as it is wide.
    Parallelepiped,
    /// A cone that stands upright, as high as it is wide.
    Cone,
    /// A mesh that was loaded.
    Mesh {
        /// The name that it brings with it: its file's, without the extension. Empty for none.
        stem: String,
        /// Its geometry.
        geometry: Arc<MeshGeometry>,
        /// The file as the document shall name it; `None` keeps the geometry in the document.
        source: Option<Arc<str>>,
    },
    /// A white lamp.
    Light,
    /// A material.
    Material {
        /// The name that it brings with it, as a preset does. Empty for none.
        stem: String,
        /// Its coefficients.
        surface: Surface,
    },
    /// A view: a copy of that one, or one that sees the whole scene.
    View(Option<View>),
}

/// Where new things stand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standpoint {
    /// The point that they stand on.
    pub point: DVec3,
    /// Unit vector: the direction in which they rise from it.
    pub normal: DVec3,
    /// What is up: y or z.
    pub up: DVec3,
    /// Unit vector to the right of the active view, level.
    pub right: DVec3,
    /// Their width and height.
    pub size: f64,
}

impl Default for Standpoint {
    fn default() -> Standpoint {
        Standpoint { point: DVec3::ZERO, normal: DVec3::Y, up: DVec3::Y, right: DVec3::X, size: 1.0 }
    }
}

/// The greatest coordinate of a standpoint: what stands there is still within the range of coordinates.
const FARTHEST: f64 = limits::COORDINATE / 10.0;
/// A new thing takes this part of the picture's height.
const PART_OF_HEIGHT: f64 = 0.2;

impl Standpoint {
    /// The standpoint in front of a view: on what its middle shows, at a fifth of its height there.
    ///
    /// Without a compiled world it is the point that the view is about.
    pub fn of(view: &View, scene: &Scene, world: Option<&World>) -> Standpoint {
        let focus = focus(view, scene, world);
        let Some(sight) = Sight::of(view) else { return Standpoint::default() };
        let (width, height) = sight.extent(focus.point).unwrap_or((1.0, 1.0));
        let limit = DVec3::splat(FARTHEST);
        let point = focus.point.clamp(-limit, limit);
        // far out, what is smaller than this has no shape of its own in f64
        let least = (point.abs().max_element() * 1e-6).max(limits::LEAST * 1e3);
        let size = decimal::round_length((PART_OF_HEIGHT * width.min(height)).clamp(least, FARTHEST / 10.0));
        let up = said_vertical(view).unwrap_or(DVec3::Y);
        let right = (sight.right - up * sight.right.dot(up)).normalize_or(DVec3::X);
        Standpoint {
            point: decimal::rounded_point(point, decimal::places(size) + 2),
            normal: focus.hit.map_or(up, |hit| hit.normal),
            up,
            right: decimal::rounded_point(right, 3).normalize_or(DVec3::X),
            size,
        }
    }

    /// The middle of a new thing that reaches `half` above and below it.
    fn above(&self, half: f64) -> DVec3 {
        self.rounded(self.point + self.normal * half)
    }

    /// The edges of a level square, so that their cross product points upwards.
    fn level(&self) -> [DVec3; 2] {
        if self.up == DVec3::Z { [DVec3::X, DVec3::Y] } else { [DVec3::Z, DVec3::X] }
    }

    /// A point with as many decimals as are worth reading at this size.
    fn rounded(&self, point: DVec3) -> DVec3 {
        decimal::rounded_point(point, decimal::places(self.size) + 3)
    }
}

/// Things with a flat foot stand by this part of their size in the floor, so that no two faces coincide.
const SUNK: f64 = 1.0 / 500.0;

/// The step that adds a thing; it is selected then.
pub fn added(stage: &Stage, item: NewItem, at: &Standpoint) -> Command {
    let taken = naming::taken(stage);
    let (scene, size) = (&stage.scene, at.size);
    let half = size / 2.0;
    let sunk = half - size * SUNK;
    let object = |stem: &str, shape: Shape| {
        let object = Object::new(naming::numbered(stem, &taken), shape);
        insert_object(scene, object)
    };
    match item {
        NewItem::Sphere => object("sphere", Shape::Sphere { center: at.above(half), radius: half }),
        NewItem::Plane => {
            let p0 = at.above(half);
            let [u, v] = at.level();
            object("plane", Shape::Plane { p0, p1: p0 + u * size, p2: p0 + v * size })
        }
        NewItem::Facet => {
            let (foot, side) = (at.point, at.right * half);
            let [p0, p1, p2] = [foot - side, foot + side, foot + at.up * size].map(|point| at.rounded(point));
            object("facet", Shape::Facet { p0, p1, p2 })
        }
        NewItem::Cube => object("cube", Shape::Cube { center: at.above(sunk), edge: size, rotation: DVec3::ZERO }),
        NewItem::Parallelepiped => {
            let edges = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| axis * if axis == at.up { half } else { size });
            let middle = at.above(half / 2.0 - size * SUNK);
            let origin = at.rounded(middle - (edges[0] + edges[1] + edges[2]) * 0.5);
            object("box", Shape::Parallelepiped { origin, edges })
        }
        NewItem::Cone => {
            // from its foot in the floor to a tip above it
            let base = at.rounded(at.point - at.up * (size * SUNK));
            let top = at.rounded(base + at.up * size);
            object("cone", Shape::Cone { base, top, base_radius: half, top_radius: 0.0, capped: true })
        }
        NewItem::Mesh { stem, geometry, source } => {
            let name = if stem.trim().is_empty() {
                naming::numbered("mesh", &taken)
            } else {
                naming::distinct(stem.trim(), &taken)
            };
            let placement = placed(&geometry, at);
            let mesh = Mesh { geometry, source, placement, smooth: false };
            insert_object(scene, Object::new(name, Shape::Mesh(mesh)))
        }
        NewItem::Light => {
            let name = naming::numbered("light", &taken);
            // beside and above what it shall light, within the picture
            let position = at.rounded(at.point + at.up * (1.75 * size) - at.right * size);
            let index = scene.lights.len();
            let item = Arc::new(PointLight::new(name.clone(), position));
            let edit = Edit::Lights(ListEdit::Insert { index, item });
            Command::new(StepName::Added(name.clone()), edit).selecting(vec![Item::Light(name)])
        }
        NewItem::Material { stem, surface } => {
            let name = if stem.trim().is_empty() {
                naming::numbered("material", &taken)
            } else {
                naming::distinct(stem.trim(), &taken)
            };
            let index = scene.materials.len();
            let item = Arc::new(Material { name: name.clone(), surface });
            let edit = Edit::Materials(ListEdit::Insert { index, item });
            Command::new(StepName::Added(name.clone()), edit).selecting(vec![Item::Material(name)])
        }
        NewItem::View(like) => {
            let name = naming::numbered("view", &taken);
            let view = View { name: name.clone(), ..like.unwrap_or_else(|| overview(scene)) };
            let edit = Edit::Views(ListEdit::Insert { index: stage.views.len(), item: Arc::new(view) });
            Command::new(StepName::Added(name.clone()), edit).selecting(vec![Item::View(name)])
        }
    }
}

fn insert_object(scene: &Scene, object: Object) -> Command {
    let name = object.name.clone();
    let edit = Edit::Objects(ListEdit::Insert { index: scene.objects.len(), item: Arc::new(object) });
    Command::new(StepName::Added(name.clone()), edit).selecting(vec![Item::Object(name)])
}

/// Stands a mesh with its foot on the point. It keeps the size of its file unless that is far from what suits the view.
fn placed(geometry: &MeshGeometry, at: &Standpoint) -> Placement {
    let corners = geometry.positions.iter().fold(None, |corners: Option<(DVec3, DVec3)>, &position| {
        Some(corners.map_or((position, position), |(low, high)| (low.min(position), high.max(position))))
    });
    let Some((low, high)) = corners else { return Placement { position: at.point, ..Placement::default() } };
    let extent = (high - low).max_element();
    let fits = extent <= 0.0 || (0.25..=2.0).contains(&(extent / at.size));
    let factor = if fits { 1.0 } else { decimal::round_length(at.size / extent).clamp(limits::LEAST, 1e9) };
    let middle = (low + high) * 0.5;
    let foot = middle + at.up * (low - middle).dot(at.up);
    let position = at.rounded(at.point - foot * factor - at.up * (at.size * SUNK));
    let far = DVec3::splat(limits::COORDINATE);
    Placement { scale: DVec3::splat(factor), rotation: DVec3::ZERO, position: position.clamp(-far, far) }
}

/// A view of the whole scene, from the front and a little above.
pub(crate) fn overview(scene: &Scene) -> View {
    let bounds = scene.objects.iter().filter_map(|object| object.shape.bounds());
    let hull = bounds.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
    let (low, high) = hull.unwrap_or((DVec3::splat(-1.0), DVec3::ONE));
    let limit = DVec3::splat(FARTHEST);
    let middle = ((low + high) * 0.5).clamp(-limit, limit);
    let least = (middle.abs().max_element() * 1e-6).max(limits::LEAST * 1e3);
    let size = decimal::round_length((high - low).length().clamp(least, FARTHEST));
    let target = decimal::rounded_point(middle, decimal::places(size) + 2);
    View {
        name: "view 1".into(),
        width: 640,
        height: 480,
        eye: target + DVec3::new(0.5, 0.7, 2.0) * size,
        screen: ScreenSpec::LookAt { look_at: target, up: DVec3::Y, fov: 45.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    }
}
