//! A lattice in space: a ball at every point, and struts that narrow towards their middle from each ball to the next.

use super::{lamp, list, material, matte, object, view};
use crate::{Environment, Rgb, Scene, Shape, Surface, View};
use glam::DVec3;

/// The radii of the balls, of the struts at their ends and in their middle, where neighbours are 1 apart.
const BALL: f64 = 0.2;
const ENDS: f64 = 0.1;
const WAIST: f64 = 0.035;

/// The lattice of `n³` cells, where `n` is the size: `(n+1)³` balls, and two cones for each of `3·n·(n+1)²` struts.
pub(super) fn lattice(size: u32) -> (Scene, View) {
    let points = size + 1;
    let half = f64::from(size) / 2.0;
    let at = |place: [u32; 3]| DVec3::from(place.map(|coordinate| f64::from(coordinate) - half));
    let places = || (0..points).flat_map(move |z| (0..points).flat_map(move |y| (0..points).map(move |x| [x, y, z])));
    let balls = (1..).zip(places()).map(|(number, place)| {
        object(format!("ball {number}"), "brass", Shape::Sphere { center: at(place), radius: BALL })
    });
    let struts = places().flat_map(|place| (0..3).map(move |axis| (place, axis)));
    let halves = struts.filter(|(place, axis)| place[*axis] < size).flat_map(|(place, axis)| {
        let mut next = place;
        next[axis] += 1;
        let middle = (at(place) + at(next)) / 2.0;
        [(at(place), middle), (at(next), middle)]
    });
    let cones = (1..).zip(halves).map(|(number, (base, top))| {
        let cone = Shape::Cone { base, top, base_radius: ENDS, top_radius: WAIST, capped: false };
        object(format!("strut {number}"), "steel", cone)
    });
    let brass = Surface {
        ks: Rgb::new(0.9, 0.75, 0.45),
        shininess: Rgb::splat(90.0),
        kr: Rgb::new(0.38, 0.3, 0.16),
        ..matte(Rgb::new(0.52, 0.38, 0.14))
    };
    let steel = Surface { ks: Rgb::splat(0.4), shininess: Rgb::splat(40.0), ..matte(Rgb::new(0.36, 0.4, 0.46)) };
    let scene = Scene {
        name: format!("Lattice of {size} by {size} by {size} cells"),
        world: Environment {
            ambient: Rgb::splat(0.25),
            background: Rgb::new(0.8, 0.84, 0.88),
            depth: 4,
            ..Environment::default()
        },
        materials: list([material("brass", brass), material("steel", steel)]),
        lights: list([
            lamp("key", DVec3::new(0.9, 2.0, 1.6) * f64::from(size + 1), Rgb::new(0.8, 0.77, 0.7)),
            lamp("fill", DVec3::new(-1.8, 0.8, 1.2) * f64::from(size + 1), Rgb::new(0.22, 0.26, 0.32)),
        ]),
        objects: list(balls.chain(cones)),
    };
    let eye = DVec3::new(0.62, 0.52, 1.32) * (f64::from(size) + 0.6);
    (scene, view([640, 480], eye, DVec3::ZERO, DVec3::Y, 44.0))
}
