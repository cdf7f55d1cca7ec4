//! What smooth normals decide and what they do not: lamp terms and `R`, but neither side, medium nor `T`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that fails says so by panicking")]

mod common;

use common::{black, glass, object, open, pixel, scene, surface};
use lancer_scene::{DVec3, Environment, List, Mesh, MeshGeometry, Placement, PointLight, Rgb, Shape, Surface};
use lancer_trace::observe::{LampLight, Term};
use std::sync::Arc;

fn smooth(geometry: MeshGeometry) -> Shape {
    Shape::Mesh(Mesh { geometry: Arc::new(geometry), source: None, placement: Placement::default(), smooth: true })
}

/// A facet in the plane y = 0 whose smooth normals all lean away from a viewer at +x.
fn leaning(surface: Surface) -> lancer_scene::Object {
    let positions = vec![DVec3::new(-9.0, 0.0, -9.0), DVec3::new(0.0, 0.0, 9.0), DVec3::new(9.0, 0.0, -9.0)];
    let normals = vec![DVec3::new(-0.6, 0.8, 0.0); 3];
    let shape = smooth(MeshGeometry { positions, normals, facets: vec![[0, 1, 2]], ..MeshGeometry::default() });
    object("sheet", shape, surface)
}

/// `I = (-0.96, -0.28, 0)`: `I·N = 0.352`, so `R = I - 2(I·N)N = (-0.5376, -0.8432, 0)` would enter the sheet.
#[test]
fn a_mirrored_ray_that_would_enter_is_mirrored_out() {
    let mirror = Surface { kr: Rgb::WHITE, ..black() };
    let tree =
        open(&scene(vec![leaning(mirror)], Environment::default()), &pixel(DVec3::new(1.92, 0.56, 0.0), DVec3::ZERO));
    let nodes = &tree.samples[0].tree.nodes;
    assert_eq!(nodes.len(), 2, "what leaves does not meet the sheet again");
    let r = nodes[1].ray.direction;
    assert!((r - DVec3::new(-0.5376, 0.8432, 0.0)).length() < 1e-12, "{r}");
}

/// The smooth normal stands on the side of the geometric one, though it leans away from the viewer: `N·L = 0.8` for a
/// lamp overhead. A lamp that is in front of the facet but behind the smooth normal gives nothing.
#[test]
fn lamps_are_judged_by_both_normals() {
    let chalk = Surface { kd: Rgb::WHITE, ks: Rgb::WHITE, shininess: Rgb::BLACK, ..black() };
    let mut scene = scene(vec![leaning(Surface { ks: Rgb::BLACK, ..chalk.clone() })], Environment::default());
    let lamp = |name: &str, x: f64, y: f64| PointLight::new(name, DVec3::new(x, y, 0.0));
    scene.lights = [lamp("overhead", 0.0, 2.0), lamp("low", 0.96, 0.28), lamp("under", -0.96, -0.28)]
        .into_iter()
        .collect::<List<PointLight>>();
    let tree = open(&scene, &pixel(DVec3::new(1.92, 0.56, 0.0), DVec3::ZERO));
    let told: Vec<Option<f64>> = surface(&tree.samples[0].tree.nodes[0])
        .terms
        .iter()
        .filter_map(|composed| match &composed.term {
            Term::Lamp { light: LampLight::Lit(lit), .. } => Some(Some(lit.cos_l)),
            Term::Lamp { .. } => Some(None),
            Term::Ambient { .. } | Term::Mirror(_) | Term::Glass(_) => None,
        })
        .collect();
    let [Some(overhead), None, None] = told[..] else { panic!("{told:?}") };
    assert!((overhead - 0.8).abs() < 1e-12 && (tree.color.r - 0.8).abs() < 1e-12, "{told:?} {}", tree.color.r);
}

/// A tetrahedron of glass is entered through its lowest facet at 30°: 19.4712206° by that facet's own normal.
#[test]
fn the_geometric_normal_bends_light() {
    let tetrahedron = MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Z, DVec3::Y],
        facets: vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]],
        ..MeshGeometry::default()
    };
    let (target, incident) = (DVec3::new(0.2, 0.0, 0.2), DVec3::new(0.5, 0.75_f64.sqrt(), 0.0));
    let objects = vec![object("tetrahedron", smooth(tetrahedron), glass(1.5))];
    let tree = open(&scene(objects, Environment::default()), &pixel(target - incident * 2.0, target));
    let nodes = &tree.samples[0].tree.nodes;
    let seen = surface(&nodes[0]);
    assert!(seen.entering && (seen.normal - seen.geometric_normal).length() > 0.1, "it is smooth there");
    let t = nodes[1].ray.direction;
    assert!((t.x.atan2(t.y).to_degrees() - 19.4712206).abs() < 1e-7 && t.z.abs() < 1e-12, "{t}");
}
