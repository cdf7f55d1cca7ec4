//! Four facets of one leaf side by side, in single precision: what a filter before the exact test looks at.

use super::{Bounds, Frame, Source};
use bytemuck::Zeroable;
use glam::DVec3;
use rayon::prelude::*;

/// What stands where a block has no facet.
pub(crate) const NO_FACET: u32 = u32::MAX;

/// The corners of four facets, relative to the hierarchy's origin and rounded to the nearest `f32`; by corner, axis and
/// lane. Lanes without a facet are NaN.
#[repr(C, align(16))]
#[derive(Clone, Debug, Zeroable)]
pub(crate) struct Block {
    pub(crate) corners: [[[f32; Block::FACETS]; 3]; 3],
    /// The numbers of the facets, [`NO_FACET`] where there is none.
    pub(crate) facets: [u32; Block::FACETS],
}

impl Block {
    /// How many facets a block has place for.
    pub(crate) const FACETS: usize = 4;

    /// A block without facets.
    pub(crate) const EMPTY: Block =
        Block { corners: [[[f32::NAN; Block::FACETS]; 3]; 3], facets: [NO_FACET; Block::FACETS] };

    /// The facets that are there.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = u32> + '_ {
        self.facets.iter().copied().filter(|&facet| facet != NO_FACET)
    }
}

/// Facets over shared corners.
pub(crate) struct Triangles<'a> {
    pub(crate) positions: &'a [DVec3],
    /// Three numbers of positions a facet; all of them exist.
    pub(crate) facets: &'a [[u32; 3]],
}

impl Triangles<'_> {
    #[inline(always)]
    fn corners(&self, number: u32) -> [DVec3; 3] {
        let [a, b, c] = self.facets[number as usize];
        [self.positions[a as usize], self.positions[b as usize], self.positions[c as usize]]
    }
}

impl Source for Triangles<'_> {
    type Pack = Block;
    const PACK: usize = Block::FACETS;

    fn len(&self) -> usize {
        self.facets.len()
    }

    fn hull(&self) -> Bounds {
        let runs = self.positions.par_chunks(1 << 14).map(|run| Bounds::of(run.iter().copied()));
        runs.reduce(|| Bounds::EMPTY, Bounds::union)
    }

    #[inline(always)]
    fn bounds(&self, number: u32) -> Bounds {
        let [a, b, c] = self.corners(number);
        Bounds { low: a.min(b).min(c), high: a.max(b).max(c) }
    }

    fn cost(blocks: usize) -> f32 {
        // two are tried at once; by measurement
        0.75 * blocks.div_ceil(2) as f32
    }

    fn pack(&self, numbers: &[u32], frame: &Frame, block: &mut Block) -> Bounds {
        *block = Block::EMPTY;
        let mut around = Bounds::EMPTY;
        for (lane, &facet) in numbers.iter().take(Block::FACETS).enumerate() {
            block.facets[lane] = facet;
            for (corner, at) in self.corners(facet).into_iter().enumerate() {
                around = Bounds { low: around.low.min(at), high: around.high.max(at) };
                for (axis, coordinate) in (at - frame.origin()).to_array().into_iter().enumerate() {
                    block.corners[corner][axis][lane] = coordinate as f32;
                }
            }
        }
        around
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_holds_corners_lane_by_lane() {
        let positions: Vec<DVec3> = (0..3)
            .flat_map(|facet| {
                let at = DVec3::splat(f64::from(facet));
                [at, at + DVec3::X, at + DVec3::Y]
            })
            .collect();
        let facets = [[0, 1, 2], [3, 4, 5], [6, 7, 8]];
        let (bvh, blocks) = super::super::Bvh::over(&Triangles { positions: &positions, facets: &facets });
        assert_eq!(bvh.origin(), DVec3::new(1.5, 1.5, 1.0));
        let [block] = &blocks[..] else { panic!("one block") };
        let mut numbers: Vec<u32> = block.numbers().collect();
        numbers.sort_unstable();
        assert_eq!((numbers, block.facets[3]), (vec![0, 1, 2], NO_FACET));
        for lane in 0..3 {
            let at = block.facets[lane] as f32;
            assert_eq!(block.corners[0].map(|axis| axis[lane]), [at - 1.5, at - 1.5, at - 1.0]);
            assert_eq!(block.corners[1].map(|axis| axis[lane]), [at - 0.5, at - 1.5, at - 1.0]);
            assert_eq!(block.corners[2].map(|axis| axis[lane]), [at - 1.5, at - 0.5, at - 1.0]);
        }
        assert!(block.corners.iter().flatten().all(|axis| axis[3].is_nan()));
        assert_eq!(size_of::<Block>(), 160);
    }
}
