//! The outline of a mesh: the edges between a facet that faces the eye and one that does not, and the edges that bound
//! the mesh. A fine mesh that showed all its edges would be nothing but edges; its outline leaves it to be seen.

use lancer_scene::{DVec3, MeshGeometry};
use std::collections::HashMap;

/// A mesh of so few edges shows all of them: its creases are its shape.
const ALL_SHOWN: usize = 60;

/// The edges of a mesh, each once, with the planes of the facets beside it.
#[derive(Clone, Debug)]
pub(crate) struct Edges(Vec<Edge>);

#[derive(Clone, Debug)]
struct Edge {
    ends: [DVec3; 2],
    /// Normal and distance from the origin, of any length.
    planes: [(DVec3, f64); 2],
    facets: usize,
}

impl Edges {
    /// The edges of a mesh. Vertices at one place are one and facets without area are none, as where the mesh is asked
    /// whether it is closed.
    pub(crate) fn of(geometry: &MeshGeometry) -> Edges {
        let merged = geometry.merged_vertices();
        let mut edges: Vec<Edge> = Vec::new();
        let mut known = HashMap::new();
        for facet in &geometry.facets {
            let corners = facet.map(|vertex| geometry.positions.get(vertex as usize).copied().unwrap_or_default());
            let [a, b, c] = corners;
            let normal = (b - a).cross(c - a);
            if normal == DVec3::ZERO {
                continue;
            }
            let plane = (normal, normal.dot(a));
            for (from, to) in [(0, 1), (1, 2), (2, 0)] {
                let [low, high] = [facet[from], facet[to]].map(|vertex| merged.get(vertex as usize).copied());
                let place = *known.entry((low.min(high), low.max(high))).or_insert(edges.len());
                match edges.get_mut(place) {
                    Some(edge) => {
                        edge.planes[1] = plane;
                        edge.facets += 1;
                    }
                    None => edges.push(Edge { ends: [corners[from], corners[to]], planes: [plane; 2], facets: 1 }),
                }
            }
        }
        Edges(edges)
    }

    /// The edges that an eye sees as the outline; both in the space of the vertices.
    pub(crate) fn outline(&self, eye: DVec3) -> impl Iterator<Item = [DVec3; 2]> {
        let all = self.0.len() <= ALL_SHOWN;
        let faces = move |(normal, distance): (DVec3, f64)| normal.dot(eye) > distance;
        let is_seen = move |edge: &&Edge| all || edge.facets != 2 || faces(edge.planes[0]) != faces(edge.planes[1]);
        self.0.iter().filter(is_seen).map(|edge| edge.ends)
    }
}
