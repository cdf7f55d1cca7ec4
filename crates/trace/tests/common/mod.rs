//! Small scenes and the one pixel that is looked at, for the tests of the whole recursion.
#![allow(clippy::unwrap_used, clippy::panic, dead_code, reason = "helpers of tests, of which each file uses some")]

use lancer_scene::{DVec3, Environment, MaterialRef, Object, Rgb, Scene, ScreenSpec, Shape, Steps, Surface, View};
use lancer_trace::observe::{RayNode, Seen, SurfaceNode, Term};
use lancer_trace::{Camera, Cancel, PixelTree, Settings, World, explain};
use std::sync::Arc;

/// One pixel that looks from `eye` towards `target`.
pub(crate) fn pixel(eye: DVec3, target: DVec3) -> View {
    let up = if (target - eye).cross(DVec3::Y).length() > 1e-6 { DVec3::Y } else { DVec3::Z };
    View {
        name: "pixel".into(),
        width: 1,
        height: 1,
        eye,
        screen: ScreenSpec::LookAt { look_at: target, up, fov: 10.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    }
}

/// A surface that does nothing with light.
pub(crate) fn black() -> Surface {
    Surface { ka: Rgb::BLACK, kd: Rgb::BLACK, ..Surface::default() }
}

pub(crate) fn glass(index: f64) -> Surface {
    Surface { kt: Rgb::WHITE, index: Rgb::splat(index), ..black() }
}

pub(crate) fn object(name: &str, shape: Shape, surface: Surface) -> Object {
    Object { material: MaterialRef::Inline(Arc::new(surface)), ..Object::new(name, shape) }
}

pub(crate) fn sphere(name: &str, center: DVec3, radius: f64, surface: Surface) -> Object {
    object(name, Shape::Sphere { center, radius }, surface)
}

pub(crate) fn cone([base, top]: [DVec3; 2], [base_radius, top_radius]: [f64; 2], capped: bool) -> Shape {
    Shape::Cone { base, top, base_radius, top_radius, capped }
}

/// A plane through `p0` with that normal.
pub(crate) fn plane(name: &str, p0: DVec3, normal: DVec3, surface: Surface) -> Object {
    let (u, v) = normal.any_orthonormal_pair();
    let shape = Shape::Plane { p0, p1: p0 + u, p2: p0 + v };
    assert!(u.cross(v).dot(normal) > 0.0);
    object(name, shape, surface)
}

pub(crate) fn scene(objects: Vec<Object>, environment: Environment) -> Scene {
    Scene { world: environment, objects: objects.into_iter().collect(), ..Scene::default() }
}

pub(crate) fn open(scene: &Scene, view: &View) -> PixelTree {
    assert_eq!(scene.check(), Ok(()));
    let world = World::compile(scene);
    explain(&world, &Camera::new(view).unwrap(), Settings::of(&world, view), (0, 0), &Cancel::default()).unwrap()
}

pub(crate) fn surface(node: &RayNode) -> &SurfaceNode {
    match &node.seen {
        Seen::Surface(surface) => surface,
        Seen::Background(_) => panic!("the ray meets nothing"),
    }
}

/// Every `n → n'` in the order of the rays.
pub(crate) fn crossings(tree: &PixelTree) -> Vec<(f64, f64)> {
    let nodes = &tree.samples[0].tree.nodes;
    nodes
        .iter()
        .filter_map(|node| match &node.seen {
            Seen::Surface(surface) => surface.terms.iter().find_map(|composed| match &composed.term {
                Term::Glass(glass) => glass.paths.first().map(|path| (path.n, path.n_prime)),
                Term::Ambient { .. } | Term::Mirror(_) | Term::Lamp { .. } => None,
            }),
            Seen::Background(_) => None,
        })
        .collect()
}
