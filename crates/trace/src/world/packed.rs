//! The geometry of a set of facets as rays need it, shared by all objects and all compiled worlds that show it: whatever
//! depends on neither placement nor materials is computed here, once.

use crate::bvh::{Block, Bvh, Child, Triangles};
use glam::DVec3;
use lancer_scene::{Enclosure, MeshGeometry};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// Facets in the order of the document, with their hierarchy.
#[derive(Debug)]
pub(crate) struct Packed {
    geometry: Arc<MeshGeometry>,
    /// The vertices in the world, for a placement that distorts too much to be undone; else those of the geometry.
    baked: Option<Vec<DVec3>>,
    /// Facets from here on name vertices that do not exist, and are left out.
    len: u32,
    bvh: Bvh,
    blocks: Vec<Block>,
    build_time: Duration,
    smooth_normals: OnceLock<Vec<DVec3>>,
    enclosure: OnceLock<Enclosure>,
}

impl Packed {
    /// Packs a geometry where it is, or its vertices where they were `baked` to.
    pub(crate) fn new(geometry: Arc<MeshGeometry>, baked: Option<Vec<DVec3>>) -> Packed {
        let begun = Instant::now();
        let positions = baked.as_ref().unwrap_or(&geometry.positions);
        let exists = |facet: &&[u32; 3]| facet.iter().all(|&vertex| (vertex as usize) < positions.len());
        let len = geometry.facets.iter().take(Child::PLACES).take_while(exists).count();
        let (bvh, blocks) = Bvh::over(&Triangles { positions, facets: &geometry.facets[..len] });
        let len = len as u32;
        let (smooth_normals, enclosure) = (OnceLock::new(), OnceLock::new());
        Packed { len, bvh, blocks, build_time: begun.elapsed(), smooth_normals, enclosure, baked, geometry }
    }

    /// Facets that are given by their corners.
    pub(crate) fn separate(facets: &[[DVec3; 3]]) -> Packed {
        let corners = (0..facets.len() as u32).map(|facet| [3 * facet, 3 * facet + 1, 3 * facet + 2]).collect();
        let geometry = MeshGeometry { positions: facets.concat(), facets: corners, ..MeshGeometry::default() };
        Packed::new(Arc::new(geometry), None)
    }

    /// What was packed.
    pub(crate) fn geometry(&self) -> &Arc<MeshGeometry> {
        &self.geometry
    }

    /// How many facets there are.
    pub(crate) fn len(&self) -> u32 {
        self.len
    }

    /// `P0 P1 P2` of a facet.
    #[inline]
    pub(crate) fn corners(&self, facet: u32) -> [DVec3; 3] {
        let positions = self.baked.as_ref().unwrap_or(&self.geometry.positions);
        let [p0, p1, p2] = self.geometry.facets[facet as usize];
        [positions[p0 as usize], positions[p1 as usize], positions[p2 as usize]]
    }

    /// The hierarchy over the facets; a leaf counts blocks.
    pub(crate) fn bvh(&self) -> &Bvh {
        &self.bvh
    }

    /// The facets in the order of the leaves.
    pub(crate) fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// How long it took to build hierarchy and blocks.
    pub(crate) fn build_time(&self) -> Duration {
        self.build_time
    }

    /// A normal for each vertex before placement, not of unit length.
    pub(crate) fn smooth_normals(&self) -> &[DVec3] {
        if self.geometry.normals.len() == self.geometry.positions.len() {
            return &self.geometry.normals;
        }
        self.smooth_normals.get_or_init(|| self.geometry.smooth_normals().into_owned())
    }

    /// What the facets enclose before placement.
    pub(crate) fn enclosure(&self) -> Enclosure {
        *self.enclosure.get_or_init(|| {
            let whole = self.len as usize == self.geometry.facets.len();
            if whole { self.geometry.enclosure() } else { Enclosure::Sheet }
        })
    }
}
