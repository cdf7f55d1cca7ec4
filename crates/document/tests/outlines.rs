//! Outlines against what the rays see.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

#[path = "../../scene/tests/arbitrary/mod.rs"]
mod arbitrary;

use lancer_document::Item;
use lancer_document::wireframe::{Polyline, Wireframes, grid};
use lancer_scene::{
    DVec3, Material, MaterialRef, Mesh, MeshGeometry, Object, Placement, PointLight, ScreenSpec, Shape, Stage, Steps,
    Surface, View,
};
use lancer_trace::Camera;
use proptest::prelude::*;
use std::sync::Arc;

fn view(eye: DVec3, look_at: DVec3) -> View {
    View {
        name: "front".into(),
        width: 640,
        height: 480,
        eye,
        screen: ScreenSpec::LookAt { look_at, up: DVec3::Y, fov: 60.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    }
}

fn camera(eye: DVec3, look_at: DVec3) -> Camera {
    Camera::new(&view(eye, look_at)).unwrap()
}

fn near(a: (f64, f64), b: (f64, f64)) {
    assert!((a.0 - b.0).hypot(a.1 - b.1) < 1e-9, "{a:?} {b:?}");
}

fn outline(shape: Shape, camera: &Camera) -> Vec<Polyline> {
    Wireframes::default().object(&Object::new("it", shape), camera)
}

/// The silhouette is where rays graze the sphere, also far from the middle of the picture, where it is an ellipse.
#[test]
fn a_spheres_outline_is_its_silhouette() {
    let (center, radius) = (DVec3::new(2.0, 1.0, -1.0), 0.8);
    let camera = camera(DVec3::Z * 4.0, DVec3::ZERO);
    let lines = outline(Shape::Sphere { center, radius }, &camera);
    assert_eq!(lines.len(), 1);
    assert_eq!(lines[0].first(), lines[0].last(), "closed");
    for &(x, y) in &lines[0] {
        let ray = camera.ray(x, y);
        let passes = (center - ray.at((center - ray.origin).dot(ray.direction))).length();
        assert!((passes - radius).abs() < 1e-9, "{passes}");
    }
}

/// Of a cone the two circles, and the two lines of its side that the eye's rays touch: they lie in planes through the eye
/// that are tangent to it, so rays through their points pass the side at no depth. From inside there are four lines.
#[test]
fn a_cones_outline_is_its_circles_and_its_silhouette() {
    let (base, top) = (DVec3::new(0.5, -0.6, 0.0), DVec3::new(0.7, 0.8, -1.0));
    let camera = camera(DVec3::Z * 4.0, DVec3::ZERO);
    let lines = outline(Shape::Cone { base, top, base_radius: 0.7, top_radius: 0.2, capped: true }, &camera);
    assert_eq!(lines.len(), 4);
    let (axis, height) = ((top - base).normalize(), (top - base).length());
    for line in &lines[2..] {
        let [from, to] = [line[0], line[1]];
        for part in [0.1, 0.5, 0.9] {
            let ray = camera.ray(from.0 + (to.0 - from.0) * part, from.1 + (to.1 - from.1) * part);
            let gap = |t: f64| {
                let z = (ray.at(t) - base).dot(axis);
                (ray.at(t) - base - axis * z).length() - (0.7 - 0.5 * z / height)
            };
            let least = (0..400_000).map(|step| gap(2.0 + f64::from(step) * 1e-5)).fold(f64::INFINITY, f64::min);
            assert!(least.abs() < 1e-9, "{least}");
        }
    }
    let pointed = outline(Shape::Cone { base, top, base_radius: 0.0, top_radius: 0.2, capped: false }, &camera);
    assert_eq!(pointed.len(), 3, "one circle");
    let around = Shape::Cone { base: DVec3::Z * 9.0, top: DVec3::Z, base_radius: 3.0, top_radius: 3.0, capped: false };
    assert_eq!(outline(around, &camera).len(), 5, "the far circle is seen, and four lines");
}

/// A sphere that reaches behind the eye, and one around it.
#[test]
fn a_sphere_beside_or_around_the_eye_is_cut() {
    let camera = camera(DVec3::ZERO, DVec3::NEG_Z);
    let beside = outline(Shape::Sphere { center: DVec3::new(1.5, 0.0, 0.3), radius: 1.4 }, &camera);
    assert!(!beside.is_empty());
    let around = outline(Shape::Sphere { center: DVec3::ZERO, radius: 1.0 }, &camera);
    assert!(!around.is_empty());
    assert_eq!(outline(Shape::Sphere { center: DVec3::Z * 9.0, radius: 1.0 }, &camera), Vec::<Polyline>::new());
    for (x, y) in beside.into_iter().chain(around).flatten() {
        assert!((-641.0..1921.0).contains(&x) && (-481.0..1441.0).contains(&y), "{x} {y}");
    }
}

#[test]
fn boxes_facets_and_planes_have_their_edges() {
    let camera = camera(DVec3::new(1.0, 2.0, 5.0), DVec3::ZERO);
    let edges = [DVec3::X, DVec3::Y, DVec3::Z];
    let lines = outline(Shape::Parallelepiped { origin: DVec3::ZERO, edges }, &camera);
    assert_eq!(lines.len(), 12);
    // every edge of the box once: each corner is the end of three
    let ends: Vec<(f64, f64)> = lines.iter().flatten().copied().collect();
    for corner in 0..8 {
        let bit = |bit: usize| f64::from(u8::from(corner & bit != 0));
        let (x, y) = camera.project(DVec3::new(bit(1), bit(2), bit(4))).unwrap();
        assert_eq!(ends.iter().filter(|end| (end.0 - x).hypot(end.1 - y) < 1e-9).count(), 3);
    }
    assert_eq!(outline(Shape::Cube { center: DVec3::ZERO, edge: 1.0, rotation: DVec3::Y }, &camera).len(), 12);
    let facet = outline(Shape::Facet { p0: DVec3::ZERO, p1: DVec3::X, p2: DVec3::Y }, &camera);
    assert_eq!(facet.iter().map(Vec::len).collect::<Vec<_>>(), [4]);
    near(facet[0][0], camera.project(DVec3::ZERO).unwrap());
    let plane = outline(Shape::Plane { p0: DVec3::ZERO, p1: DVec3::Z, p2: DVec3::X }, &camera);
    assert_eq!(plane.len(), 10, "four by four cells");
}

fn fan(facets: u32) -> MeshGeometry {
    let mut positions = vec![DVec3::ZERO];
    positions.extend((0..=facets).map(|step| DVec3::new(1.0, f64::from(step) * 1e-4, 0.0)));
    MeshGeometry {
        positions,
        facets: (0..facets).map(|facet| [0, facet + 1, facet + 2]).collect(),
        ..MeshGeometry::default()
    }
}

fn mesh(geometry: Arc<MeshGeometry>, placement: Placement) -> Shape {
    Shape::Mesh(Mesh { geometry, source: None, placement, smooth: false })
}

#[test]
fn a_small_mesh_shows_each_edge_once_and_a_large_one_its_box() {
    let camera = camera(DVec3::new(0.5, 0.5, 5.0), DVec3::new(0.5, 0.0, 0.0));
    let placement = Placement { position: DVec3::Y, ..Placement::default() };
    let small = outline(mesh(Arc::new(fan(10)), placement.clone()), &camera);
    assert_eq!(small.len(), 21);
    near(small[0][0], camera.project(DVec3::Y).unwrap());
    assert_eq!(outline(mesh(Arc::new(fan(30_000)), placement.clone()), &camera).len(), 12);
    assert_eq!(outline(mesh(Arc::default(), placement), &camera), Vec::<Polyline>::new());
}

/// A fine mesh is outlined as the body is that it stands for: a ball of many facets by a circle, from wherever it is
/// seen, also where it is turned, stretched or mirrored, and where each facet has vertices of its own.
#[test]
fn a_fine_mesh_shows_its_silhouette() {
    const ROWS: u32 = 24;
    const COLUMNS: u32 = 48;
    let place = |row: u32, column: u32| {
        if row == 0 || row == ROWS {
            return if row == 0 { DVec3::Y } else { DVec3::NEG_Y };
        }
        let (up, around) = (f64::from(row) / f64::from(ROWS), f64::from(column % COLUMNS) / f64::from(COLUMNS));
        let ((sin, cos), (east, north)) =
            ((up * std::f64::consts::PI).sin_cos(), (around * std::f64::consts::TAU).sin_cos());
        DVec3::new(sin * east, cos, sin * north)
    };
    let cells = (0..ROWS).flat_map(|row| (0..COLUMNS).map(move |column| (row, column)));
    let corners = cells.flat_map(|(row, column)| {
        [(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)].map(|(down, right)| place(row + down, column + right))
    });
    let positions: Vec<DVec3> = corners.collect();
    let facets = (0..positions.len() as u32 / 3).map(|facet| [3 * facet, 3 * facet + 1, 3 * facet + 2]).collect();
    let ball = Arc::new(MeshGeometry { positions, facets, ..MeshGeometry::default() });
    for scale in [DVec3::ONE, DVec3::new(-1.0, 1.0, 1.0)] {
        for eye in [DVec3::new(3.0, 4.0, 12.0), DVec3::new(-13.0, 0.5, 0.3), DVec3::new(1.0, -12.0, 5.0)] {
            let placement = Placement { scale, position: DVec3::X, rotation: DVec3::new(10.0, 20.0, 30.0) };
            let camera = camera(eye + DVec3::X, DVec3::X);
            let lines = outline(mesh(Arc::clone(&ball), placement), &camera);
            // a circle of the radius that a ball has there, but for the length of a facet, and nothing within it
            let middle = camera.project(DVec3::X).unwrap();
            let due = 320.0 / 30_f64.to_radians().tan() / (eye.length_squared() - 1.0).sqrt();
            for point in lines.iter().flatten() {
                let radius = (point.0 - middle.0).hypot(point.1 - middle.1);
                assert!((radius / due - 1.0).abs() < 0.06, "{eye}: {radius} for {due}");
            }
            let length: f64 = lines.iter().map(|line| (line[0].0 - line[1].0).hypot(line[0].1 - line[1].1)).sum();
            assert!((0.9..1.5).contains(&(length / due / std::f64::consts::TAU)), "{eye}: {length} around {due}");
        }
    }
}

/// The lines of a mesh are worked out once, however often it is moved, and forgotten with it.
#[test]
fn the_lines_of_a_mesh_are_kept_while_it_is() {
    let camera = camera(DVec3::Z * 5.0, DVec3::ZERO);
    let geometry = Arc::new(fan(10));
    let mut wireframes = Wireframes::default();
    for step in 0..3 {
        let placement = Placement { position: DVec3::X * f64::from(step), ..Placement::default() };
        let object = Object::new("it", mesh(Arc::clone(&geometry), placement));
        assert_eq!(wireframes.object(&object, &camera).len(), 21);
    }
    assert_eq!(Arc::strong_count(&geometry), 2, "one here, one in the cache");
    let other = Object::new("other", mesh(Arc::new(fan(3)), Placement::default()));
    let weak = Arc::downgrade(&geometry);
    drop(geometry);
    wireframes.object(&other, &camera);
    assert!(weak.upgrade().is_none());
}

#[test]
fn every_kind_of_thing_has_an_outline_but_the_world() {
    let mut stage = Stage::default();
    let red = |name: &str, x: f64| Object {
        material: MaterialRef::Named("red".into()),
        ..Object::new(name, Shape::Sphere { center: DVec3::X * x, radius: 0.2 })
    };
    stage.scene.materials = [Material { name: "red".into(), surface: Surface::default() }].into_iter().collect();
    stage.scene.objects = [red("a", 0.0), red("b", 1.0)].into_iter().collect();
    stage.scene.lights =
        [PointLight::new("lamp", DVec3::Y), PointLight::new("behind", DVec3::Z * 9.0)].into_iter().collect();
    stage.views = [view(DVec3::X * 3.0, DVec3::ZERO)].into_iter().collect();
    let camera = camera(DVec3::Z * 5.0, DVec3::ZERO);
    let mut wireframes = Wireframes::default();
    let mut lines = |item: Item| wireframes.outline(&stage, &item, &camera);
    assert_eq!(lines(Item::World), Vec::<Polyline>::new());
    assert_eq!(lines(Item::Object("nobody".into())), Vec::<Polyline>::new());
    assert_eq!(lines(Item::Object("a".into())).len(), 1);
    assert_eq!(lines(Item::Material("red".into())).len(), 2, "the objects that have it");
    assert_eq!(lines(Item::View("front".into())).len(), 5, "its screen, and lines from its eye");
    assert_eq!(lines(Item::Light("behind".into())), Vec::<Polyline>::new());
    let star = lines(Item::Light("lamp".into()));
    assert_eq!(star.len(), 8);
    let (x, y) = camera.project(DVec3::Y).unwrap();
    for (px, py) in star.into_iter().flatten() {
        assert!((px - x).hypot(py - y) < 9.01, "of one size on every picture");
    }
}

#[test]
fn the_grid_lies_where_round_coordinates_are() {
    let camera = camera(DVec3::new(3.0, 2.0, 5.0), DVec3::ZERO);
    let ground = grid(&camera, DVec3::Y, DVec3::ZERO);
    assert_eq!(ground.step, 1.0);
    assert!(ground.axes.iter().all(|axis| axis.len() == 1));
    assert!(ground.minor.len() > 40 && ground.major.len() >= 4, "{} {}", ground.minor.len(), ground.major.len());
    // the line z = -1: every point of it is level and a whole number of steps away
    for line in ground.minor.iter().chain(&ground.major) {
        let at = |(x, y): (f64, f64)| {
            let ray = camera.ray(x, y);
            ray.at(-ray.origin.y / ray.direction.y)
        };
        let (a, b) = (at(line[0]), at(line[1]));
        let whole = |value: f64| (value - value.round()).abs() < 1e-3;
        assert!((a.x - b.x).abs() < 1e-3 && whole(a.x) || (a.z - b.z).abs() < 1e-3 && whole(a.z), "{a} {b}");
    }
    assert_eq!(grid(&camera, DVec3::Y, DVec3::ZERO), ground);
    let far = Camera::new(&view(DVec3::new(0.0, 900.0, 900.0), DVec3::ZERO)).unwrap();
    assert_eq!(grid(&far, DVec3::Z, DVec3::ZERO).step, 100.0);
}

proptest! {
    /// Whatever the scene and the view, every outline is finite and near the picture.
    #[test]
    fn outlines_are_finite(stage in arbitrary::stage(), view in arbitrary::view()) {
        let camera = Camera::new(&view).unwrap();
        let mut wireframes = Wireframes::default();
        let scene = &stage.scene;
        let objects = scene.objects.iter().map(|object| Item::Object(object.name.clone()));
        let lights = scene.lights.iter().map(|light| Item::Light(light.name.clone()));
        let views = stage.views.iter().map(|view| Item::View(view.name.clone()));
        let mut lines: Vec<Polyline> =
            objects.chain(lights).chain(views).flat_map(|item| wireframes.outline(&stage, &item, &camera)).collect();
        let ground = grid(&camera, DVec3::Y, DVec3::ZERO);
        lines.extend(ground.minor.into_iter().chain(ground.major).chain(ground.axes.into_iter().flatten()));
        let (w, h) = (f64::from(view.width), f64::from(view.height));
        for (x, y) in lines.into_iter().flatten() {
            prop_assert!(x >= -w - 20.0 && x <= 2.0 * w + 20.0 && y >= -h - 20.0 && y <= 2.0 * h + 20.0, "{} {}", x, y);
        }
    }
}
