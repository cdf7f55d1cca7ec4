//! A set of facets: corners, surfaces of parts, smooth normals and a hierarchy of boxes.

use super::Surfaces;
use super::hierarchy::{Bounds, Hierarchy};
use glam::DVec3;
use lancer_scene::Mesh;

/// Facets in the order of the document, with shared corners.
#[derive(Clone, Debug)]
pub(crate) struct Facets {
    positions: Vec<DVec3>,
    corners: Vec<[u32; 3]>,
    /// One per position, or empty: the facets are flat.
    normals: Vec<DVec3>,
    /// Runs of facets with surfaces of their own: `(first, end, surface)`, ascending.
    parts: Vec<(u32, u32, u32)>,
    hierarchy: Hierarchy,
}

impl Facets {
    /// Facets that are given by their corners.
    pub(crate) fn separate(facets: &[[DVec3; 3]]) -> Facets {
        let corners = (0..facets.len() as u32).map(|facet| [3 * facet, 3 * facet + 1, 3 * facet + 2]).collect();
        Facets::new(facets.concat(), corners, Vec::new(), Vec::new())
    }

    /// The facets of a mesh where its placement brings them. Facets that name no vertex are left out by emptying them.
    pub(crate) fn of_mesh(mesh: &Mesh, surfaces: &mut Surfaces) -> Facets {
        let linear = mesh.placement.linear();
        let geometry = &mesh.geometry;
        let positions: Vec<DVec3> =
            geometry.positions.iter().map(|position| linear * *position + mesh.placement.position).collect();
        let exists = |facet: &&[u32; 3]| facet.iter().all(|&vertex| (vertex as usize) < positions.len());
        let corners: Vec<[u32; 3]> = geometry.facets.iter().take_while(exists).copied().collect();
        let parts = geometry
            .parts
            .iter()
            .map(|part| (part.first, part.first.saturating_add(part.count), surfaces.number(&part.material)))
            .collect();
        let normals = if !mesh.smooth {
            Vec::new()
        } else if geometry.normals.len() == positions.len() {
            // normals go by the inverse transpose, whose columns are the cross products of the linear part's
            let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
            let sign = x.dot(y.cross(z)).signum();
            let (nx, ny, nz) = (y.cross(z) * sign, z.cross(x) * sign, x.cross(y) * sign);
            geometry.normals.iter().map(|normal| nx * normal.x + ny * normal.y + nz * normal.z).collect()
        } else {
            area_weighted_normals(&positions, &corners, &geometry.merged_vertices())
        };
        Facets::new(positions, corners, normals, parts)
    }

    fn new(positions: Vec<DVec3>, corners: Vec<[u32; 3]>, normals: Vec<DVec3>, parts: Vec<(u32, u32, u32)>) -> Facets {
        let bounds: Vec<Bounds> =
            corners.iter().map(|facet| Bounds::of(facet.map(|vertex| positions[vertex as usize])).widened()).collect();
        Facets { hierarchy: Hierarchy::build(&bounds), positions, corners, normals, parts }
    }

    /// How many facets there are.
    pub(crate) fn len(&self) -> u32 {
        self.corners.len() as u32
    }

    /// `P0 P1 P2` of a facet.
    pub(crate) fn corners(&self, facet: u32) -> [DVec3; 3] {
        self.corners[facet as usize].map(|vertex| self.positions[vertex as usize])
    }

    /// The smooth normals at the corners of a facet, not of unit length; `None` where the facets are flat.
    pub(crate) fn normals(&self, facet: u32) -> Option<[DVec3; 3]> {
        (!self.normals.is_empty())
            .then(|| self.corners[facet as usize].map(|vertex| self.normals[vertex as usize].normalize_or_zero()))
    }

    /// The surface of the part that a facet belongs to, if it belongs to one.
    pub(crate) fn surface(&self, facet: u32) -> Option<u32> {
        let next = self.parts.partition_point(|&(first, _, _)| first <= facet);
        let &(_, end, surface) = self.parts.get(next.checked_sub(1)?)?;
        (facet < end).then_some(surface)
    }

    /// The surface of each facet in order, where `otherwise` is the one of facets that belong to no part.
    pub(crate) fn surfaces(&self, otherwise: u32) -> impl Iterator<Item = u32> + '_ {
        (0..self.len()).map(move |facet| self.surface(facet).unwrap_or(otherwise))
    }

    /// The hierarchy over the facets; an item is a facet's number.
    pub(crate) fn hierarchy(&self) -> &Hierarchy {
        &self.hierarchy
    }
}

/// The normals of a smooth mesh: at each place the sum of `P0P1 × P0P2` of the facets there, so that each counts by
/// its area.
fn area_weighted_normals(positions: &[DVec3], corners: &[[u32; 3]], merged: &[u32]) -> Vec<DVec3> {
    let mut sums = vec![DVec3::ZERO; positions.len()];
    for facet in corners {
        let [a, b, c] = facet.map(|vertex| positions[vertex as usize]);
        let normal = (b - a).cross(c - a);
        for vertex in facet {
            sums[merged[*vertex as usize] as usize] += normal;
        }
    }
    merged.iter().map(|&place| sums[place as usize]).collect()
}
