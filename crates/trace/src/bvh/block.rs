//! Four facets of one leaf side by side, in single precision: what a filter before the exact test looks at.

use glam::DVec3;

/// What stands where a block has no facet.
pub(crate) const NO_FACET: u32 = u32::MAX;

/// The corners of four facets, relative to the hierarchy's origin and rounded to the nearest `f32`; by corner, axis and
/// lane. Lanes without a facet are NaN.
#[repr(C, align(16))]
#[derive(Clone, Debug)]
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

    /// The block of these facets, whose corners are given by their number.
    pub(crate) fn of(facets: &[u32], origin: DVec3, corners: impl Fn(u32) -> [DVec3; 3]) -> Block {
        let mut block = Block::EMPTY;
        for (lane, &facet) in facets.iter().take(Block::FACETS).enumerate() {
            if facet == NO_FACET {
                continue;
            }
            block.facets[lane] = facet;
            for (corner, at) in corners(facet).into_iter().enumerate() {
                for (axis, coordinate) in (at - origin).to_array().into_iter().enumerate() {
                    block.corners[corner][axis][lane] = coordinate as f32;
                }
            }
        }
        block
    }

    /// The facets of blocks: the lanes that hold one, block by block.
    #[inline(always)]
    pub(crate) fn lanes(blocks: &[Block]) -> impl Iterator<Item = (&Block, usize)> {
        let all = blocks.iter().flat_map(|block| (0..Block::FACETS).map(move |lane| (block, lane)));
        all.filter(|(block, lane)| block.facets[*lane] != NO_FACET)
    }

    /// The facets of one or two blocks: their numbers, and their places among eight.
    #[inline(always)]
    pub(crate) fn places(blocks: &[Block]) -> impl Iterator<Item = (u32, usize)> {
        let all = blocks.iter().enumerate();
        let all =
            all.flat_map(|(half, block)| (0..Block::FACETS).map(move |lane| (block.facets[lane], 4 * half + lane)));
        all.filter(|(number, _)| *number != NO_FACET)
    }

    /// The facets that are there.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = u32> + '_ {
        self.facets.iter().copied().filter(|&facet| facet != NO_FACET)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_holds_corners_lane_by_lane() {
        let corners = |facet: u32| {
            let at = DVec3::splat(f64::from(facet));
            [at, at + DVec3::X, at + DVec3::Y]
        };
        let block = Block::of(&[7, NO_FACET, 3], DVec3::ONE, corners);
        assert_eq!(block.numbers().collect::<Vec<_>>(), [7, 3]);
        assert_eq!([block.corners[0][0][0], block.corners[1][0][0], block.corners[2][1][0]], [6.0, 7.0, 7.0]);
        assert_eq!([block.corners[0][2][2], block.corners[1][0][2]], [2.0, 3.0]);
        assert!(block.corners[0][0][1].is_nan() && block.corners[2][2][3].is_nan());
        assert_eq!(size_of::<Block>(), 160);
    }
}
