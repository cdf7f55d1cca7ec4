//! A tube along a trefoil, the torus knot (2, 3): closed, curved everywhere, and in its own way.

use super::grid::{Ends, grid};
use super::{lamp, list, material, matte, mesh, object, view};
use crate::{Environment, Rgb, Scene, Surface, View};
use glam::DVec3;
use std::f64::consts::TAU;

/// The radii of the torus that the knot winds around, and of the tube.
const TORUS: [f64; 2] = [1.0, 0.45];
const TUBE: f64 = 0.2;
/// Cells along the tube for each one around it: nearly square ones.
const LENGTH: u32 = 10;

/// The knot of `20·n²` facets, where `n` is the size.
pub(super) fn knot(size: u32) -> (Scene, View) {
    let (positions, facets) = grid(LENGTH * size, size, Ends::Joined, |column, row| {
        let [center, out, across] = frame(f64::from(column) / f64::from(LENGTH * size) * TAU);
        let (sin, cos) = libm::sincos(f64::from(row) / f64::from(size) * TAU);
        center + (out * cos - across * sin) * TUBE
    });
    let copper = Rgb::new(0.66, 0.33, 0.18);
    let copper = Surface { ks: Rgb::splat(0.6), kr: Rgb::new(0.4, 0.3, 0.25), ..matte(copper) };
    let scene = Scene {
        name: format!("Knot of {LENGTH}·{size} by {size} cells"),
        world: Environment {
            ambient: Rgb::splat(0.25),
            background: Rgb::new(0.3, 0.36, 0.46),
            depth: 3,
            ..Environment::default()
        },
        materials: list([material("copper", copper)]),
        lights: list([lamp("lamp", DVec3::new(-4.0, 6.0, 8.0), Rgb::splat(0.9))]),
        objects: list([object("knot", "copper", mesh(positions, facets))]),
    };
    (scene, view([640, 480], DVec3::new(0.6, -2.2, 6.2), DVec3::ZERO, DVec3::Y, 42.0))
}

/// The point of the knot at an angle, the unit vector out of the torus there, and the one across both it and the knot.
fn frame(angle: f64) -> [DVec3; 3] {
    let [ring, radius] = TORUS;
    let (sin_long, cos_long) = libm::sincos(2.0 * angle);
    let (sin_short, cos_short) = libm::sincos(3.0 * angle);
    let distance = ring + radius * cos_short;
    let growth = -3.0 * radius * sin_short;
    let center = DVec3::new(distance * cos_long, distance * sin_long, radius * sin_short);
    let along = DVec3::new(
        growth * cos_long - 2.0 * distance * sin_long,
        growth * sin_long + 2.0 * distance * cos_long,
        3.0 * radius * cos_short,
    );
    let out = DVec3::new(cos_short * cos_long, cos_short * sin_long, sin_short);
    [center, out, along.normalize().cross(out)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_frame_is_rectangular_and_closes() {
        for step in 0..100 {
            let angle = f64::from(step) / 100.0 * TAU;
            let [center, out, across] = frame(angle);
            let [ahead, ..] = frame(angle + 1e-6);
            let along = (ahead - center).normalize();
            assert!(out.dot(across).abs() < 1e-12 && along.dot(across).abs() < 1e-5 && along.dot(out).abs() < 1e-5);
            assert!((out.length() - 1.0).abs() < 1e-12 && (across.length() - 1.0).abs() < 1e-12);
        }
        let gap = (frame(0.0)[0] - frame(TAU)[0]).length();
        assert!(gap < 1e-12, "{gap}");
    }
}
