//! A rough landscape over a square: one surface, cut into as many facets as are wanted.

use super::grid::{Ends, grid};
use super::noise::octaves;
use super::{lamp, list, material, matte, mesh, object, view};
use crate::{Environment, Rgb, Scene, View};
use glam::DVec3;

/// Octaves of noise; the finest hill is 1/256 of the square wide.
const OCTAVES: u32 = 8;
/// How many of the largest hills stand in a row.
const HILLS: f64 = 4.0;
/// The height of the largest hills, where the square is 2 wide.
const HEIGHT: f64 = 0.22;

/// The field of `2n²` facets, where `n` is the size. The surface is the same for every size, so pictures differ in
/// detail alone.
pub(super) fn field(size: u32) -> (Scene, View) {
    let cells = f64::from(size);
    let (positions, facets) = grid(size, size, Ends::Open, |column, row| {
        let (x, z) = (f64::from(column) / cells, f64::from(row) / cells);
        let height = HEIGHT * octaves(DVec3::new(x * HILLS, z * HILLS, 0.0), OCTAVES, 2009);
        DVec3::new(2.0 * x - 1.0, height, 1.0 - 2.0 * z)
    });
    let scene = Scene {
        name: format!("Field of {size} by {size} cells"),
        world: Environment {
            ambient: Rgb::splat(0.2),
            background: Rgb::new(0.55, 0.68, 0.85),
            depth: 1,
            ..Environment::default()
        },
        materials: list([material("earth", matte(Rgb::new(0.62, 0.5, 0.36)))]),
        lights: list([lamp("sun", DVec3::new(-40.0, 30.0, 20.0), Rgb::new(1.0, 0.96, 0.88))]),
        objects: list([object("field", "earth", mesh(positions, facets))]),
    };
    (scene, view([640, 480], DVec3::new(0.25, 1.0, 1.7), DVec3::new(0.0, -0.1, 0.1), DVec3::Y, 46.0))
}
