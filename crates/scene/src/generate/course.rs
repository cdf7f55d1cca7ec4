//! All that the subject asks for at once: an infinite plane, spheres of mirror, glass and copper, two cubes of facets,
//! three lamps, depth 5. It is `scenes/course/course.xml` as a function.

use super::{lamp, list, material, object, view};
use crate::{Environment, Rgb, Scene, Shape, Surface, View};
use glam::DVec3;

/// The scene, and its first view.
pub(super) fn course() -> (Scene, View) {
    let world = Environment {
        ambient: Rgb::new(0.62, 0.66, 0.76),
        background: Rgb::new(0.34, 0.42, 0.56),
        depth: 5,
        ..Environment::default()
    };
    let slate = Surface {
        ka: Rgb::new(0.4623, 0.5469, 0.6555),
        kd: Rgb::new(0.42, 0.40, 0.38),
        kr: Rgb::splat(0.22),
        ..Surface::default()
    };
    let mirror = Surface {
        ka: Rgb::splat(0.03),
        kd: Rgb::splat(0.06),
        kr: Rgb::new(0.85, 0.87, 0.9),
        ks: Rgb::splat(0.9),
        shininess: Rgb::splat(160.0),
        ..Surface::default()
    };
    let glass = Surface {
        ka: Rgb::BLACK,
        kd: Rgb::splat(0.02),
        kr: Rgb::splat(0.15),
        ks: Rgb::splat(0.9),
        shininess: Rgb::splat(200.0),
        kt: Rgb::new(0.88, 0.94, 0.92),
        index: Rgb::splat(1.5),
        ..Surface::default()
    };
    let copper = Surface {
        ka: Rgb::new(0.3, 0.13, 0.06),
        kd: Rgb::new(0.6, 0.28, 0.14),
        kr: Rgb::new(0.45, 0.26, 0.16),
        ks: Rgb::new(1.0, 0.7, 0.5),
        shininess: Rgb::splat(45.0),
        ..Surface::default()
    };
    let ivory = Surface {
        ka: Rgb::new(0.3, 0.28, 0.22),
        kd: Rgb::new(0.85, 0.8, 0.68),
        ks: Rgb::splat(0.2),
        shininess: Rgb::splat(25.0),
        ..Surface::default()
    };
    let jade = Surface {
        ka: Rgb::new(0.05, 0.2, 0.14),
        kd: Rgb::new(0.14, 0.66, 0.46),
        kr: Rgb::splat(0.08),
        ks: Rgb::splat(0.5),
        shininess: Rgb::splat(60.0),
        ..Surface::default()
    };
    let materials =
        [("slate", slate), ("mirror", mirror), ("glass", glass), ("copper", copper), ("ivory", ivory), ("jade", jade)];
    let lights = [
        lamp("key", DVec3::new(-5.0, 7.0, 5.0), Rgb::new(0.8, 0.74, 0.62)),
        lamp("fill", DVec3::new(6.0, 5.0, 5.0), Rgb::new(0.3, 0.36, 0.48)),
        lamp("rim", DVec3::new(1.0, 6.0, -6.0), Rgb::new(0.35, 0.3, 0.28)),
    ];
    let ball =
        |name, x, y, z, radius, material| object(name, material, Shape::Sphere { center: DVec3::new(x, y, z), radius });
    let cube = |name, center, edge, turn, material| {
        object(name, material, Shape::Cube { center, edge, rotation: DVec3::new(0.0, turn, 0.0) })
    };
    let objects = [
        object("ground", "slate", Shape::Plane { p0: DVec3::ZERO, p1: DVec3::Z, p2: DVec3::X }),
        ball("mirror ball", 0.0, 1.0, -0.7, 1.0, "mirror"),
        ball("glass ball", -0.85, 0.5, 1.15, 0.5, "glass"),
        ball("copper ball", 1.25, 0.42, 0.85, 0.42, "copper"),
        cube("ivory cube", DVec3::new(-2.0, 0.54, -0.3), 1.1, 32.0, "ivory"),
        cube("jade cube", DVec3::new(2.15, 0.39, -0.35), 0.8, -24.0, "jade"),
    ];
    let scene = Scene {
        name: "The course scene: plane, three spheres, two cubes, three lamps".to_owned(),
        world,
        materials: list(materials.map(|(name, surface)| material(name, surface))),
        lights: list(lights),
        objects: list(objects),
    };
    (scene, view([800, 600], DVec3::new(0.0, 2.0, 6.6), DVec3::new(0.0, 0.66, 0.0), DVec3::Y, 44.0))
}
