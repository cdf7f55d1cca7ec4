//! Objects made of facets: vertices, facets, parts of several materials, and whether they enclose a volume.

use crate::{MaterialRef, Placement};
use glam::DVec3;
use std::borrow::Cow;
use std::sync::Arc;

/// A mesh as it stands in a scene: shared geometry and a placement.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// Vertices and facets, shared by every snapshot and every instance.
    pub geometry: Arc<MeshGeometry>,
    /// The file that the geometry was read from, relative to the document; `None` for inline vertices.
    pub source: Option<Arc<str>>,
    /// Scale, rotation, translation.
    pub placement: Placement,
    /// Whether lamp terms and mirrored rays use smooth normals.
    pub smooth: bool,
}

/// Shared geometry is not looked into, so that a large mesh can be moved without comparing its vertices.
impl PartialEq for Mesh {
    fn eq(&self, other: &Mesh) -> bool {
        self.placement == other.placement
            && self.smooth == other.smooth
            && self.source == other.source
            && (Arc::ptr_eq(&self.geometry, &other.geometry) || self.geometry == other.geometry)
    }
}

/// Vertices and facets.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshGeometry {
    /// The vertices, before placement.
    pub positions: Vec<DVec3>,
    /// One normal per vertex as the file gave it, or empty: then smooth normals are computed.
    pub normals: Vec<DVec3>,
    /// Three vertex numbers a facet, from 0.
    pub facets: Vec<[u32; 3]>,
    /// Runs of facets with materials of their own, ascending and disjoint; the other facets have the object's.
    pub parts: Vec<Part>,
}

/// A run of facets with a material of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The material.
    pub material: MaterialRef,
    /// The first facet.
    pub first: u32,
    /// How many facets, at least 1.
    pub count: u32,
}

/// What a mesh is to a ray that passes through it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Enclosure {
    /// A closed mesh encloses a volume.
    Volume {
        /// Whether the facets' normals `P0P1 × P0P2` point inwards, so that they must be turned.
        inverted: bool,
    },
    /// Sheets without thickness.
    Sheet,
}

impl Mesh {
    /// The vertices that some facet uses, where the placement brings them.
    pub(crate) fn used_positions(&self) -> impl Iterator<Item = DVec3> {
        let linear = self.placement.linear();
        self.geometry.used_positions().map(move |position| linear * position + self.placement.position)
    }

    /// Whether the mesh encloses a volume, with the orientation it has after placement: a mirroring scale turns it.
    pub fn enclosure(&self) -> Enclosure {
        self.geometry.enclosure().placed(&self.placement)
    }
}

impl Enclosure {
    /// What a placement makes of it: a mirroring scale turns a volume.
    #[must_use]
    pub fn placed(self, placement: &Placement) -> Enclosure {
        match self {
            Enclosure::Volume { inverted } => {
                let mirrored = placement.scale.to_array().into_iter().filter(|s| *s < 0.0).count() % 2 == 1;
                Enclosure::Volume { inverted: inverted != mirrored }
            }
            Enclosure::Sheet => Enclosure::Sheet,
        }
    }
}

impl MeshGeometry {
    /// The vertices that some facet uses.
    pub(crate) fn used_positions(&self) -> impl Iterator<Item = DVec3> {
        let mut used = vec![false; self.positions.len()];
        for &vertex in self.facets.iter().flatten() {
            if let Some(used) = used.get_mut(vertex as usize) {
                *used = true;
            }
        }
        self.positions.iter().zip(used).filter(|(_, used)| *used).map(|(&position, _)| position)
    }

    /// For each vertex the number of the first vertex at the same place.
    pub fn merged_vertices(&self) -> Vec<u32> {
        // Adding zero makes -0 and 0 the same place.
        let key = |position: &DVec3| position.to_array().map(|coordinate| (coordinate + 0.0).to_bits());
        let mut places: Vec<([u64; 3], u32)> = self.positions.iter().map(key).zip(0..).collect();
        places.sort_unstable();
        let mut merged = vec![0; places.len()];
        let mut first = 0;
        for (index, (place, vertex)) in places.iter().enumerate() {
            if index == 0 || *place != places[index - 1].0 {
                first = *vertex;
            }
            merged[*vertex as usize] = first;
        }
        merged
    }

    /// Whether the mesh is closed: after merging equal positions and dropping facets without area, every edge has
    /// exactly two facets, in opposite directions. It is then oriented by its signed volume.
    pub fn enclosure(&self) -> Enclosure {
        let merged = self.merged_vertices();
        let facets: Vec<[u32; 3]> = self
            .facets
            .iter()
            .map(|facet| facet.map(|vertex| merged[vertex as usize]))
            .filter(|facet| self.area_vector(*facet) != DVec3::ZERO)
            .collect();
        if facets.is_empty() || !every_edge_is_met_both_ways(&facets, self.positions.len()) {
            return Enclosure::Sheet;
        }
        let origin = self.positions[facets[0][0] as usize];
        let six_volumes: f64 = facets
            .iter()
            .map(|facet| {
                let [a, b, c] = facet.map(|vertex| self.positions[vertex as usize] - origin);
                a.cross(b).dot(c)
            })
            .sum();
        Enclosure::Volume { inverted: six_volumes < 0.0 }
    }

    /// A normal for each vertex before placement, not of unit length: the file's, or else at each place the sum of
    /// `P0P1 × P0P2` of the facets there, so that each counts by its area. Facets whose vertices do not exist are left
    /// out.
    pub fn smooth_normals(&self) -> Cow<'_, [DVec3]> {
        if self.normals.len() == self.positions.len() {
            return Cow::Borrowed(&self.normals);
        }
        let merged = self.merged_vertices();
        let mut sums = vec![DVec3::ZERO; self.positions.len()];
        let exists = |facet: &&[u32; 3]| facet.iter().all(|&vertex| (vertex as usize) < self.positions.len());
        for facet in self.facets.iter().filter(exists) {
            let normal = self.area_vector(*facet);
            for vertex in facet {
                sums[merged[*vertex as usize] as usize] += normal;
            }
        }
        Cow::Owned(merged.iter().map(|&place| sums[place as usize]).collect())
    }

    /// `P0P1 × P0P2`: twice the facet's area, along its normal. The facet's vertices must exist.
    fn area_vector(&self, facet: [u32; 3]) -> DVec3 {
        let [a, b, c] = facet.map(|vertex| self.positions[vertex as usize]);
        (b - a).cross(c - a)
    }
}

/// Whether every edge has exactly two facets, which run along it in opposite directions.
///
/// Edges are sorted by their lesser vertex, which takes no comparisons; what is left at each vertex is a handful.
fn every_edge_is_met_both_ways(facets: &[[u32; 3]], vertices: usize) -> bool {
    let edges = || facets.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let mut ends = vec![0_usize; vertices + 1];
    edges().for_each(|(a, b)| ends[a.min(b) as usize + 1] += 1);
    for vertex in 0..vertices {
        ends[vertex + 1] += ends[vertex];
    }
    // the other vertex of each edge, and whether the edge runs to it
    let mut others = vec![(0_u32, false); ends[vertices]];
    let mut next = ends.clone();
    for (a, b) in edges() {
        let place = &mut next[a.min(b) as usize];
        others[*place] = (a.max(b), a < b);
        *place += 1;
    }
    ends.windows(2).all(|range| {
        let others = &mut others[range[0]..range[1]];
        others.sort_unstable();
        others.len().is_multiple_of(2)
            && others.chunks_exact(2).all(|pair| pair[0].0 == pair[1].0 && !pair[0].1 && pair[1].1)
            && others.chunks_exact(2).zip(others.chunks_exact(2).skip(1)).all(|(pair, next)| pair[0].0 != next[0].0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tetrahedron() -> MeshGeometry {
        MeshGeometry {
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::Z, DVec3::Y],
            facets: vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]],
            ..MeshGeometry::default()
        }
    }

    /// A facet of area 2 in the plane y = 0 and one of area ½ in x = 0 meet along an edge whose vertices each has for
    /// itself: there the normals add up by area, 4 to 1.
    #[test]
    fn smooth_normals_are_sums_by_area_over_equal_positions() {
        let mut pair = MeshGeometry {
            positions: vec![DVec3::ZERO, DVec3::Z, DVec3::X * 4.0, DVec3::ZERO, DVec3::Y, DVec3::Z],
            facets: vec![[0, 1, 2], [3, 4, 5]],
            ..MeshGeometry::default()
        };
        let (up, aside, both) = (DVec3::Y * 4.0, DVec3::X, DVec3::new(1.0, 4.0, 0.0));
        assert_eq!(*pair.smooth_normals(), [both, both, up, both, aside, both]);
        // the file's own normals come first
        pair.normals = vec![DVec3::Z; 6];
        assert_eq!(*pair.smooth_normals(), [DVec3::Z; 6]);
    }

    #[test]
    fn a_tetrahedron_is_closed() {
        assert_eq!(tetrahedron().enclosure(), Enclosure::Volume { inverted: false });
        let mut inside_out = tetrahedron();
        inside_out.facets.iter_mut().for_each(|facet| facet.swap(1, 2));
        assert_eq!(inside_out.enclosure(), Enclosure::Volume { inverted: true });
    }

    #[test]
    fn a_mirroring_placement_turns_it() {
        let mut mesh =
            Mesh { geometry: Arc::new(tetrahedron()), source: None, placement: Placement::default(), smooth: false };
        mesh.placement.scale = DVec3::new(-1.0, 2.0, 1.0);
        assert_eq!(mesh.enclosure(), Enclosure::Volume { inverted: true });
        mesh.placement.scale = DVec3::new(-1.0, -2.0, 1.0);
        assert_eq!(mesh.enclosure(), Enclosure::Volume { inverted: false });
    }

    #[test]
    fn a_hole_a_turned_facet_and_a_doubled_facet_make_a_sheet() {
        let mut open = tetrahedron();
        open.facets.pop();
        assert_eq!(open.enclosure(), Enclosure::Sheet);
        let mut turned = tetrahedron();
        turned.facets[0].swap(1, 2);
        assert_eq!(turned.enclosure(), Enclosure::Sheet);
        let mut doubled = tetrahedron();
        doubled.facets.push([0, 1, 2]);
        assert_eq!(doubled.enclosure(), Enclosure::Sheet);
        assert_eq!(MeshGeometry::default().enclosure(), Enclosure::Sheet);
    }

    #[test]
    fn an_edge_of_four_facets_makes_a_sheet() {
        // two tetrahedra that share an edge: each is closed, together they are not
        let mut both = tetrahedron();
        both.positions.extend([DVec3::NEG_Z, DVec3::NEG_Y]);
        both.facets.extend([[0, 1, 4], [0, 5, 1], [1, 5, 4], [4, 5, 0]].map(|[a, b, c]| [a, c, b]));
        assert_eq!(both.enclosure(), Enclosure::Sheet);
        // apart they are
        both.positions.extend([DVec3::ZERO - DVec3::Y, DVec3::X - DVec3::Y]);
        both.positions[4] -= DVec3::Y;
        both.positions[5] -= DVec3::Y;
        for facet in &mut both.facets[4..] {
            *facet = facet.map(|vertex| if vertex < 2 { vertex + 6 } else { vertex });
        }
        assert_ne!(both.enclosure(), Enclosure::Sheet);
    }

    #[test]
    fn equal_positions_are_one_vertex_and_slivers_do_not_count() {
        let mut split = tetrahedron();
        split.positions.push(DVec3::new(-0.0, 1.0, 0.0));
        split.facets[3] = [2, 4, 0];
        split.facets.push([3, 4, 3]);
        assert_eq!(split.enclosure(), Enclosure::Volume { inverted: false });
    }
}
