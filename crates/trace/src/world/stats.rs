//! What hierarchies cost: their size and the time that they took.

use super::World;
use std::time::Duration;

/// The cost of a world's hierarchies over facets, each geometry counted once, and of its top level.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BuildStats {
    /// Facets in the hierarchies.
    pub facets: u64,
    /// Bytes of their nodes.
    pub node_bytes: u64,
    /// Bytes of their packed leaves.
    pub leaf_bytes: u64,
    /// Time to build them, from the geometry to nodes and leaves; hierarchies that were built side by side all count.
    pub build: Duration,
    /// Nodes and packed leaves that a ray through a mesh's bounds meets on average, by the heuristic of their areas
    /// (Goldsmith and Salmon 1987); the mean over the facets.
    pub cost: f64,
    /// Bytes of the top level's nodes.
    pub top_bytes: u64,
}

impl World {
    /// What the hierarchies of the facets that take part cost.
    pub fn build_stats(&self) -> BuildStats {
        let mut stats = BuildStats { top_bytes: size_of_val(self.bounded().0.nodes()) as u64, ..BuildStats::default() };
        let mut packs = self.packs_in_use();
        // each geometry once
        packs.sort_unstable_by_key(|packed| std::ptr::from_ref(*packed));
        packs.dedup_by_key(|packed| std::ptr::from_ref(*packed));
        for packed in packs {
            stats.facets += u64::from(packed.len());
            stats.node_bytes += size_of_val(packed.bvh().nodes()) as u64;
            stats.leaf_bytes += size_of_val(packed.blocks()) as u64;
            stats.build += packed.build_time();
            stats.cost += packed.bvh().cost() * f64::from(packed.len());
        }
        stats.cost /= (stats.facets as f64).max(1.0);
        stats
    }
}
