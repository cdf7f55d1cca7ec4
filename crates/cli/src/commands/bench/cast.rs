//! Casting sets of rays on all threads, and nothing else: what is timed.

use lancer_scene::DVec3;
use lancer_trace::{Caster, Ray, Simd, World};
use rayon::ThreadPool;
use rayon::prelude::*;

/// Rays that one thread takes at a time: sixteen tiles of 16×16 pixels.
const PIECE: usize = 4096;

/// The distance of the nearest hit of each ray, infinite where it meets nothing.
pub(super) fn distances(world: &World, rays: &[Ray], pool: &ThreadPool) -> Vec<f64> {
    pool.install(|| {
        let pieces = rays.par_chunks(PIECE).map(|piece| {
            let mut distances = Vec::new();
            Caster::new(world, Simd::best()).nearest(piece, &mut distances);
            distances
        });
        pieces.flatten_iter().collect()
    })
}

/// Whether something stands between a lamp and each of the points.
pub(super) fn blocked(world: &World, lamp: DVec3, points: &[DVec3], pool: &ThreadPool) -> Vec<bool> {
    pool.install(|| {
        let pieces = points.par_chunks(PIECE).map(|piece| {
            let mut blocked = Vec::new();
            Caster::new(world, Simd::best()).blocked(lamp, piece, &mut blocked);
            blocked
        });
        pieces.flatten_iter().collect()
    })
}

/// How many of the rays meet something. What each meets is computed, and forgotten at once.
pub(super) fn count_hits(world: &World, rays: &[Ray], pool: &ThreadPool, simd: Simd) -> u64 {
    pool.install(|| {
        let count = |distances: &mut Vec<f64>, piece: &[Ray]| {
            Caster::new(world, simd).nearest(piece, distances);
            distances.iter().filter(|distance| distance.is_finite()).count() as u64
        };
        rays.par_chunks(PIECE).map_init(Vec::new, count).sum()
    })
}

/// How many of the points a lamp does not reach.
pub(super) fn count_blocked(world: &World, lamp: DVec3, points: &[DVec3], pool: &ThreadPool, simd: Simd) -> u64 {
    pool.install(|| {
        let count = |blocked: &mut Vec<bool>, piece: &[DVec3]| {
            Caster::new(world, simd).blocked(lamp, piece, blocked);
            blocked.iter().filter(|blocked| **blocked).count() as u64
        };
        points.par_chunks(PIECE).map_init(Vec::new, count).sum()
    })
}
