//! A closed, dented body of nearly equal facets, as scanned models are: an icosahedron whose faces are divided, blown up
//! to a sphere and dented by noise.

use super::noise::octaves;
use super::{lamp, list, material, matte, mesh, object, single, view};
use crate::{Environment, Rgb, Scene, View};
use glam::DVec3;

/// How deep the dents are, how many the largest ones, and in how many octaves.
const DENT: f64 = 0.16;
const DENTS: f64 = 1.7;
const OCTAVES: u32 = 7;

/// The faces of an icosahedron, facing outwards: five around each end, and ten between them.
const FACES: [[u32; 3]; 20] = faces();

const fn faces() -> [[u32; 3]; 20] {
    let mut faces = [[0; 3]; 20];
    let mut k = 0;
    while k < 5 {
        let next = (k + 1) % 5;
        let number = k as usize;
        faces[number] = [0, 1 + k, 1 + next];
        faces[5 + number] = [11, 6 + next, 6 + k];
        faces[10 + number] = [1 + k, 6 + k, 1 + next];
        faces[15 + number] = [6 + k, 6 + next, 1 + next];
        k += 1;
    }
    faces
}

/// The pebble of `20·n²` facets, where `n` is the size.
pub(super) fn pebble(size: u32) -> (Scene, View) {
    let (directions, facets) = sphere(size);
    let positions = directions
        .into_iter()
        .map(|direction| single(direction * (1.0 + DENT * octaves(direction * DENTS, OCTAVES, 7))))
        .collect();
    let scene = Scene {
        name: format!("Pebble of 20·{size}² facets"),
        world: Environment {
            ambient: Rgb::splat(0.2),
            background: Rgb::new(0.42, 0.5, 0.6),
            depth: 1,
            ..Environment::default()
        },
        materials: list([material("stone", matte(Rgb::new(0.6, 0.57, 0.52)))]),
        lights: list([lamp("lamp", DVec3::new(-6.0, 8.0, 5.0), Rgb::splat(0.95))]),
        objects: list([object("pebble", "stone", mesh(positions, facets))]),
    };
    (scene, view([640, 480], DVec3::new(0.8, 1.2, 5.2), DVec3::ZERO, DVec3::Y, 42.0))
}

/// The corners of an icosahedron of radius 1: the ends of an axis, and two rings of five.
fn corners() -> [DVec3; 12] {
    let mut corners = [DVec3::Y; 12];
    corners[11] = DVec3::NEG_Y;
    // the rings stand at the height 1/√5
    let height = 1.0 / 5.0_f64.sqrt();
    for k in 0..5 {
        let ring = |turn: f64, height: f64| {
            let (sin, cos) = libm::sincos(turn * std::f64::consts::TAU / 5.0);
            DVec3::new(2.0 * height.abs() * sin, height, 2.0 * height.abs() * cos)
        };
        corners[1 + k] = ring(k as f64, height);
        corners[6 + k] = ring(k as f64 + 0.5, -height);
    }
    corners
}

/// Points on the unit sphere and the facets between them. Faces that meet share the points of their edge.
fn sphere(size: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let corners = corners();
    let mut points = corners.to_vec();
    let between = |weights: [u32; 3], ends: [u32; 3]| {
        let sum: DVec3 = (0..3).map(|k| corners[ends[k] as usize] * f64::from(weights[k])).sum();
        sum.normalize()
    };
    // the inner points of each edge, from its lower corner to its higher one
    let mut edges: Vec<[u32; 2]> = FACES.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    edges.retain(|[from, to]| from < to);
    edges.sort_unstable();
    for &[from, to] in &edges {
        points.extend((1..size).map(|step| between([size - step, step, 0], [from, to, from])));
    }
    let on_edge = |from: u32, to: u32, step: u32| {
        let step = if from < to { step } else { size - step };
        let edge = edges.partition_point(|edge| *edge < [from.min(to), from.max(to)]) as u32;
        12 + edge * (size - 1) + step - 1
    };
    let mut facets = Vec::new();
    for face in FACES {
        let [a, b, c] = face;
        let inner = points.len() as u32;
        points.extend(
            (1..size)
                .flat_map(|row| (1..size - row).map(move |column| between([size - row - column, column, row], face))),
        );
        // rows run from the edge a–b to the corner c, columns from the edge a–c to the edge b–c
        let vertex = |column: u32, row: u32| match (size - row - column, column, row) {
            (_, 0, 0) => a,
            (0, _, 0) => b,
            (0, 0, _) => c,
            (_, column, 0) => on_edge(a, b, column),
            (_, 0, row) => on_edge(a, c, row),
            (0, _, row) => on_edge(b, c, row),
            // row r has size - r - 1 inner points
            (_, column, row) => inner + (row - 1) * (size - 1) - row * (row - 1) / 2 + column - 1,
        };
        for row in 0..size {
            for column in 0..size - row {
                facets.push([vertex(column, row), vertex(column + 1, row), vertex(column, row + 1)]);
                if column + row + 1 < size {
                    facets.push([vertex(column + 1, row), vertex(column + 1, row + 1), vertex(column, row + 1)]);
                }
            }
        }
    }
    (points, facets)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_icosahedron_is_regular_and_faces_outwards() {
        let corners = corners();
        // of radius 1, its edge is 4/√(10 + 2√5)
        let edge = 4.0 / (10.0 + 2.0 * 5.0_f64.sqrt()).sqrt();
        for facet in FACES {
            let [a, b, c] = facet.map(|corner| corners[corner as usize]);
            for length in [(b - a).length(), (c - b).length(), (a - c).length()] {
                assert!((length - edge).abs() < 1e-12, "{facet:?}: {length}");
            }
            assert!((b - a).cross(c - a).dot(a) > 0.0, "{facet:?}");
        }
    }

    /// Euler: a sphere of 20n² facets has 10n² + 2 points, none of them twice.
    #[test]
    fn the_sphere_has_the_points_of_euler() {
        for size in [1, 2, 3, 8] {
            let (points, facets) = sphere(size);
            assert_eq!((points.len() as u32, facets.len() as u32), (10 * size * size + 2, 20 * size * size));
            for (place, point) in points.iter().enumerate() {
                assert!((point.length() - 1.0).abs() < 1e-12);
                assert!(points[..place].iter().all(|other| (*other - *point).length() > 0.5 / f64::from(size)));
            }
        }
    }
}
