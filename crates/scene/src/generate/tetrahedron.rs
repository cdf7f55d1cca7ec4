//! Tetrahedra of tetrahedra (Sierpiński's). E. Haines, Standard Procedural Databases, «tetra» (IEEE CG&A 7(11), 1987),
//! after a scene of Glassner (1984) and Kay and Kajiya (1986), with its lamp and its view.

use super::{SKY, lamp, list, material, matte, mesh, object, single, view};
use crate::{Environment, Rgb, Scene, View};
use glam::DVec3;

/// Every second corner of a cube: the corners of a tetrahedron, and where the four smaller ones stand.
const CORNERS: [DVec3; 4] =
    [DVec3::new(-1.0, -1.0, 1.0), DVec3::new(-1.0, 1.0, -1.0), DVec3::new(1.0, -1.0, -1.0), DVec3::new(1.0, 1.0, 1.0)];

/// The facets of a tetrahedron, facing outwards.
const FACETS: [[u32; 3]; 4] = [[0, 1, 2], [3, 2, 1], [2, 3, 0], [1, 0, 3]];

/// The pyramid of `4ⁿ` facets, where `n` is the size: 4096 for the published size 6.
pub(super) fn tetrahedron(size: u32) -> (Scene, View) {
    let (mut positions, mut facets) = (Vec::new(), Vec::new());
    grow(&mut positions, &mut facets, size, DVec3::ZERO, 1.0);
    let scene = Scene {
        name: format!("Tetrahedron of size {size}"),
        world: Environment { ambient: Rgb::splat(0.1), background: SKY, depth: 4, ..Environment::default() },
        materials: list([material("red", matte(Rgb::new(1.0, 0.2, 0.2)))]),
        lights: list([lamp("lamp", DVec3::new(2.0, -18.0, -5.0), Rgb::WHITE)]),
        objects: list([object("tetrahedron", "red", mesh(positions, facets))]),
    };
    let eye = DVec3::new(1.022846, -3.177154, -2.174512);
    let look_at = DVec3::new(-0.004103, -0.004103, 0.216539);
    (scene, view([512, 512], eye, look_at, DVec3::new(-0.816497, -0.816497, 0.816497), 45.0))
}

/// Adds a tetrahedron within the cube of that centre and half edge, or `levels` deep the smaller ones in its corners.
fn grow(positions: &mut Vec<DVec3>, facets: &mut Vec<[u32; 3]>, levels: u32, center: DVec3, half_edge: f64) {
    if levels <= 1 {
        let first = positions.len() as u32;
        positions.extend(CORNERS.map(|corner| single(center + corner * half_edge)));
        facets.extend(FACETS.map(|facet| facet.map(|vertex| first + vertex)));
        return;
    }
    for corner in CORNERS {
        grow(positions, facets, levels - 1, center + corner * (half_edge / 2.0), half_edge / 2.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first facet of the published file `tetra.nff`, and its last.
    #[test]
    fn the_facets_stand_where_the_database_has_them() {
        let (mut positions, mut facets) = (Vec::new(), Vec::new());
        grow(&mut positions, &mut facets, 6, DVec3::ZERO, 1.0);
        assert_eq!(facets.len(), 4096);
        let corners = |facet: [u32; 3]| {
            let mut corners = facet.map(|vertex| positions[vertex as usize].to_array());
            corners.sort_by(|a, b| a.partial_cmp(b).unwrap());
            corners
        };
        assert_eq!(corners(facets[0]), [[-1.0, -1.0, 1.0], [-1.0, -0.9375, 0.9375], [-0.9375, -1.0, 0.9375]]);
        assert_eq!(corners(facets[4095]), [[0.9375, 0.9375, 1.0], [0.9375, 1.0, 0.9375], [1.0, 1.0, 1.0]]);
    }
}
