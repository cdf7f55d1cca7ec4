//! The sponge of K. Menger (1926): a cube from which the middle of each face and of itself is taken, and again from
//! each of the twenty cubes that are left. One closed mesh: only the faces that show are in it.

use super::{lamp, list, material, matte, mesh, object, single, view};
use crate::{Environment, Rgb, Scene, Surface, View};
use glam::DVec3;
use std::collections::HashMap;

/// The sponge of `2·20ⁿ + 4·8ⁿ` squares of two facets each, where `n` is the size.
pub(super) fn sponge(size: u32) -> (Scene, View) {
    let (positions, facets) = faces(size);
    let stone = Surface { ks: Rgb::splat(0.25), shininess: Rgb::splat(30.0), ..matte(Rgb::new(0.78, 0.66, 0.5)) };
    let scene = Scene {
        name: format!("Sponge of size {size}"),
        world: Environment {
            ambient: Rgb::splat(0.22),
            background: Rgb::new(0.16, 0.19, 0.25),
            depth: 1,
            ..Environment::default()
        },
        materials: list([material("sandstone", stone)]),
        lights: list([
            lamp("key", DVec3::new(3.0, 6.0, 4.5), Rgb::new(0.85, 0.8, 0.7)),
            lamp("fill", DVec3::new(-6.0, 2.0, 3.0), Rgb::new(0.15, 0.2, 0.3)),
        ]),
        objects: list([object("sponge", "sandstone", mesh(positions, facets))]),
    };
    (scene, view([640, 480], DVec3::new(2.9, 2.3, 4.2), DVec3::new(0.0, -0.04, 0.0), DVec3::Y, 42.0))
}

/// Whether a cell of the grid of `3ⁿ` cells is left: in no digit to the base 3 are two of its coordinates 1.
fn is_left(mut cell: [u32; 3], size: u32) -> bool {
    for _ in 0..size {
        if cell.iter().filter(|coordinate| **coordinate % 3 == 1).count() > 1 {
            return false;
        }
        cell = cell.map(|coordinate| coordinate / 3);
    }
    true
}

/// The faces between cells that are left and all else, over the cube from -1 to 1.
fn faces(size: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let cells = 3_u32.pow(size);
    let at = |corner: [u32; 3]| {
        single(DVec3::from(corner.map(|coordinate| 2.0 * f64::from(coordinate) / f64::from(cells) - 1.0)))
    };
    let (mut positions, mut facets, mut known) = (Vec::new(), Vec::new(), HashMap::new());
    let mut vertex = |corner: [u32; 3]| {
        *known.entry(corner).or_insert_with(|| {
            positions.push(at(corner));
            positions.len() as u32 - 1
        })
    };
    let all = (0..cells).flat_map(|x| (0..cells).flat_map(move |y| (0..cells).map(move |z| [x, y, z])));
    for cell in all.filter(|cell| is_left(*cell, size)) {
        for axis in 0..3 {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            for upper in [false, true] {
                let mut beyond = cell;
                beyond[axis] = if upper { cell[axis] + 1 } else { cell[axis].wrapping_sub(1) };
                if beyond[axis] < cells && is_left(beyond, size) {
                    continue;
                }
                let corner = |along: u32, across: u32| {
                    let mut corner = cell;
                    corner[axis] += u32::from(upper);
                    corner[u] += along;
                    corner[v] += across;
                    corner
                };
                // anticlockwise seen from outside
                let around = if upper { [(0, 0), (1, 0), (1, 1), (0, 1)] } else { [(0, 0), (0, 1), (1, 1), (1, 0)] };
                let [a, b, c, d] = around.map(|(along, across)| vertex(corner(along, across)));
                facets.extend([[a, b, c], [c, d, a]]);
            }
        }
    }
    (positions, facets)
}
