//! A fractal mountain behind a pyramid of four glass spheres. E. Haines, Standard Procedural Databases, «mount» (IEEE
//! CG&A 7(11), 1987), with its lamp and its view: Carpenter's displaced midpoints on a square.
//!
//! The published displacements are those of the database up to its size 7, where its hash of places ends; what is finer
//! gets random numbers of our own. So a mountain of any size is the published one, seen more closely.

use super::grid::{Ends, grid};
use super::{Random, SKY, lamp, list, material, matte, mesh, object, view};
use crate::{Environment, Rgb, Scene, Shape, Surface, View};
use glam::DVec3;
use std::f64::consts::{LN_2, SQRT_2, TAU};

/// Between 2 and 3: how rough the mountain is.
const FRACTAL_DIMENSION: f64 = 2.2;
/// The published mountain.
const NUMBER: u64 = 21;
/// The least coordinate of the square, and its width.
const CORNER: f64 = -1.0;
const WIDTH: f64 = 2.0;
/// The size up to which every point has a displacement in the database.
const PUBLISHED: u32 = 7;
/// The pyramid of spheres: its centre, and the radius of each.
const PYRAMID: DVec3 = DVec3::new(-0.8, 0.8, 1.0);
const RADIUS: f64 = 0.17;

/// The mountain of `2·4ⁿ` facets, where `n` is the size: 8192 for the published size 6.
pub(super) fn mountain(size: u32) -> (Scene, View) {
    let cells = 1 << size;
    let heights = heights(size);
    let place = |number: u32| CORNER + f64::from(number) * WIDTH / f64::from(cells);
    let (positions, facets) = grid(cells, cells, Ends::Open, |column, row| {
        DVec3::new(place(column), place(row), heights[(row * (cells + 1) + column) as usize])
    });
    let crystal = Surface {
        ks: Rgb::splat(0.1),
        shininess: Rgb::splat(101.148),
        kr: Rgb::splat(0.1),
        kt: Rgb::splat(0.9),
        index: Rgb::splat(1.5),
        ..matte(Rgb::splat(0.1))
    };
    let rock = Rgb::new(0.5, 0.45, 0.35);
    let spheres = (1..)
        .zip(pyramid())
        .map(|(number, center)| object(format!("ball {number}"), "crystal", Shape::Sphere { center, radius: RADIUS }));
    let scene = Scene {
        name: format!("Mountain of size {size}"),
        world: Environment { ambient: Rgb::splat(0.1), background: SKY, depth: 4, ..Environment::default() },
        materials: list([material("crystal", crystal), material("rock", matte(rock))]),
        lights: list([lamp("lamp", DVec3::new(-100.0, -100.0, 100.0), Rgb::WHITE)]),
        objects: list(spheres.chain([object("mountain", "rock", mesh(positions, facets))])),
    };
    (scene, view([512, 512], DVec3::new(-1.6, 1.6, 1.7), DVec3::ZERO, DVec3::Z, 45.0))
}

/// The centres of four spheres that touch one another: one at the top, three below it.
fn pyramid() -> [DVec3; 4] {
    let top = DVec3::new(0.0, 0.0, RADIUS * 1.5_f64.sqrt());
    // turned about (1 1 0)/√2 by the angle of a tetrahedron, whose cosine is -1/3
    let (sin, cos) = ((8.0_f64).sqrt() / 3.0, -1.0 / 3.0);
    let aside = top.z * sin / 2.0_f64.sqrt();
    let below = DVec3::new(aside, -aside, top.z * cos);
    let turned = |third: f64| {
        let (sin, cos) = libm::sincos(third * TAU / 3.0);
        DVec3::new(below.x * cos - below.y * sin, below.x * sin + below.y * cos, below.z)
    };
    [top, turned(0.0), turned(1.0), turned(2.0)].map(|center| PYRAMID + center)
}

/// The heights of the square's points, row by row.
fn heights(size: u32) -> Vec<f64> {
    let cells = 1_u32 << size;
    let side = cells as usize + 1;
    let mut heights = vec![0.0; side * side];
    let ratio = 2.0 / libm::exp(LN_2 / (FRACTAL_DIMENSION - 1.0));
    let roughness = (ratio * ratio - 1.0).sqrt();
    let mut width = cells as usize;
    while width > 1 {
        let half = width / 2;
        let rise = half as f64 * WIDTH / f64::from(cells) * roughness;
        for y in (0..side - 1).step_by(width) {
            for x in (0..side - 1).step_by(width) {
                let at = |x: usize, y: usize| heights[y * side + x];
                let corners = [at(x, y), at(x + width, y), at(x + width, y + width), at(x, y + width)];
                let [ll, lr, ur, ul] = corners;
                let middle = (ll + lr + ur + ul) / 4.0;
                // an edge is moved from both its sides, to the same height
                for (x, y, mean, factor) in [
                    (x + half, y, (ll + lr) / 2.0, 1.0),
                    (x + width, y + half, (lr + ur) / 2.0, 1.0),
                    (x + half, y + width, (ur + ul) / 2.0, 1.0),
                    (x, y + half, (ul + ll) / 2.0, 1.0),
                    (x + half, y + half, middle, SQRT_2),
                ] {
                    heights[y * side + x] = mean + factor * rise * displacement(x as u64, y as u64, size);
                }
            }
        }
        width = half;
    }
    heights
}

/// The normally distributed number of a point.
fn displacement(x: u64, y: u64, size: u32) -> f64 {
    // the place in units of 1/128 of the square, the finest that the database knows
    let (x, y) = ((x << 16) >> size, (y << 16) >> size);
    let unit = 1 << (16 - PUBLISHED);
    if x.is_multiple_of(unit) && y.is_multiple_of(unit) {
        published(NUMBER + ((((y / unit) << 8) + x / unit) & 0xffff))
    } else {
        let mut random = Random::new((x << 32) | y);
        normal(|| random.unit() * 2.0 - 1.0)
    }
}

/// The database's own numbers: `GASDEV` of Numerical Recipes, with its portable congruences.
fn published(seed: u64) -> f64 {
    const MODULUS: u64 = 134_456;
    let mut state = seed;
    normal(|| {
        state = (28_411 + state * 8_121) % MODULUS;
        state as f64 * 2.0 * (1.0 / MODULUS as f64) - 1.0
    })
}

/// A normally distributed number from numbers in -1..1: Box and Muller's, in the polar form.
fn normal(mut next: impl FnMut() -> f64) -> f64 {
    loop {
        let (a, b) = (next(), next());
        let square = a * a + b * b;
        if square > 0.0 && square < 1.0 {
            return a * (-2.0 * libm::log(square) / square).sqrt();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines of the published file `mount.nff`: the spheres, and vertices of the first facets and of the last.
    #[test]
    fn all_stands_where_the_database_has_it() {
        let near = |found: DVec3, published: [f64; 3]| {
            // six digits
            assert!((found - DVec3::from(published)).length() < 6e-6, "{found} {published:?}");
        };
        let published = [
            [-0.8, 0.8, 1.20821],
            [-0.661196, 0.661196, 0.930598],
            [-0.749194, 0.98961, 0.930598],
            [-0.98961, 0.749194, 0.930598],
        ];
        pyramid().into_iter().zip(published).for_each(|(found, published)| near(found, published));

        let heights = heights(6);
        assert_eq!(heights.len(), 65 * 65);
        let height = |x: usize, y: usize| heights[y * 65 + x];
        for (x, y, published) in [
            (0, 0, 0.0),
            (1, 0, -0.0160409),
            (2, 0, -0.057566),
            (1, 1, -0.00732202),
            (0, 1, -0.0724237),
            (2, 1, 0.0317726),
            (0, 63, 0.0514796),
            (1, 63, 0.0439717),
            (1, 64, 0.0324693),
            (0, 64, 0.0),
        ] {
            assert!((height(x, y) - published).abs() < 1e-6, "{x} {y}: {}", height(x, y));
        }
    }

    #[test]
    fn a_larger_mountain_is_the_same_one_seen_more_closely() {
        let (coarse, fine) = (heights(6), heights(9));
        for y in 0..=64 {
            for x in 0..=64 {
                let (a, b) = (coarse[y * 65 + x], fine[8 * y * 513 + 8 * x]);
                assert!((a - b).abs() < 1e-12, "{x} {y}: {a} {b}");
            }
        }
        assert!(fine.iter().all(|height| height.abs() < 2.0));
    }
}
