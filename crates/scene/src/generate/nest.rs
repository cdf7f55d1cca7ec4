//! Glass within glass: balls and cubes in turn, each inside the one before it, so that a ray changes its medium at every
//! step and must remember them all.

use super::{lamp, list, material, matte, object, view};
use crate::{Environment, Rgb, Scene, Shape, Surface, View};
use glam::DVec3;

/// The indices of the shells in turn, from the outermost; the second is a bubble.
const INDICES: [f64; 4] = [1.5, 1.0, 1.8, 1.33];
/// Where the shells stand.
const CENTER: DVec3 = DVec3::new(0.0, 1.1, 0.0);

/// The nest of that many shells.
pub(super) fn nest(size: u32) -> (Scene, View) {
    let glass = |number: usize| Surface {
        ka: Rgb::BLACK,
        kd: Rgb::splat(0.02),
        ks: Rgb::splat(0.3),
        shininess: Rgb::splat(120.0),
        // a mirror at every shell would double the rays at each
        kr: Rgb::splat(if number == 0 { 0.12 } else { 0.0 }),
        kt: Rgb::new(0.93, 0.96, 0.95),
        index: Rgb::splat(INDICES[number]),
        ..Surface::default()
    };
    let glasses = (0..INDICES.len()).map(|number| material(&format!("glass {}", number + 1), glass(number)));
    let mut radius = 1.0;
    let shells = (0..size).map(|shell| {
        // the glass of the mirror is the outermost one alone
        let glass = if shell == 0 { 1 } else { 2 + (shell - 1) % 3 };
        let shape = if shell % 2 == 0 {
            Shape::Sphere { center: CENTER, radius }
        } else {
            // corners a little within the ball around it
            let edge = radius * 0.96 * 2.0 / 3.0_f64.sqrt();
            // a ball a little within the cube's faces
            radius = edge * 0.5 * 0.94;
            Shape::Cube { center: CENTER, edge, rotation: DVec3::new(18.0, 31.0, 0.0) }
        };
        object(format!("shell {}", shell + 1), &format!("glass {glass}"), shape)
    });
    let balls = [(-2.4, "coral"), (2.2, "ink"), (0.3, "coral")].into_iter().zip([-1.6, -2.2, -3.4]).zip(1..);
    let balls = balls.map(|(((x, color), z), number)| {
        object(format!("ball {number}"), color, Shape::Sphere { center: DVec3::new(x, 0.6, z), radius: 0.6 })
    });
    let scene = Scene {
        name: format!("Nest of {size} shells"),
        world: Environment {
            ambient: Rgb::splat(0.3),
            background: Rgb::new(0.6, 0.7, 0.82),
            depth: 2 * size + 2,
            ..Environment::default()
        },
        materials: list(glasses.chain([
            material("floor", matte(Rgb::new(0.62, 0.6, 0.56))),
            material("coral", matte(Rgb::new(0.85, 0.32, 0.24))),
            material("ink", matte(Rgb::new(0.12, 0.2, 0.5))),
        ])),
        lights: list([
            lamp("key", DVec3::new(-4.0, 6.0, 4.0), Rgb::splat(0.7)),
            lamp("fill", DVec3::new(5.0, 4.0, 2.0), Rgb::splat(0.3)),
        ]),
        objects: list(
            std::iter::once(object("floor", "floor", Shape::Plane { p0: DVec3::ZERO, p1: DVec3::Z, p2: DVec3::X }))
                .chain(shells)
                .chain(balls),
        ),
    };
    (scene, view([640, 480], DVec3::new(0.4, 1.7, 4.6), DVec3::new(0.0, 0.95, 0.0), DVec3::Y, 42.0))
}
