//! Rectangles of pixels: the part of a view that is rendered, and the pieces in which the work is handed out.

use crate::blocks::in_blocks;

/// A rectangle of a view's pixels, counted from the top left.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Region {
    /// The first column.
    pub x: u32,
    /// The first row.
    pub y: u32,
    /// Columns, at least 1 in a region that can be rendered.
    pub width: u32,
    /// Rows, at least 1 in a region that can be rendered.
    pub height: u32,
}

impl Region {
    /// The whole of a picture.
    pub fn whole(width: u32, height: u32) -> Region {
        Region { x: 0, y: 0, width, height }
    }

    /// Whether the region has pixels and all of them lie in a picture of that size.
    pub fn lies_within(&self, width: u32, height: u32) -> bool {
        let fits =
            |first: u32, count: u32, all: u32| count > 0 && first.checked_add(count).is_some_and(|end| end <= all);
        fits(self.x, self.width, width) && fits(self.y, self.height, height)
    }

    /// Whether the pixel lies in the region.
    pub fn contains(&self, x: u32, y: u32) -> bool {
        x.checked_sub(self.x).is_some_and(|x| x < self.width) && y.checked_sub(self.y).is_some_and(|y| y < self.height)
    }

    /// The pixels that both regions have.
    pub fn overlap(&self, other: &Region) -> Option<Region> {
        let shared = |a: u32, la: u32, b: u32, lb: u32| {
            let (first, end) = (a.max(b), a.saturating_add(la).min(b.saturating_add(lb)));
            (end > first).then(|| (first, end - first))
        };
        let (x, width) = shared(self.x, self.width, other.x, other.width)?;
        let (y, height) = shared(self.y, self.height, other.y, other.height)?;
        Some(Region { x, y, width, height })
    }

    /// The region and the pixels next to it, as far as they lie in a picture of that size.
    pub fn with_margin(&self, width: u32, height: u32) -> Region {
        let widened = |first: u32, count: u32, all: u32| {
            let (begin, end) = (first.saturating_sub(1), first.saturating_add(count).saturating_add(1).min(all));
            (begin, end.saturating_sub(begin))
        };
        let ((x, width), (y, height)) = (widened(self.x, self.width, width), widened(self.y, self.height, height));
        Region { x, y, width, height }
    }

    /// How many pixels the region has.
    pub fn pixels(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height)
    }
}

/// A rectangle that one thread computes at a time, counted from the top left of the rendered region.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Tile {
    /// The first column.
    pub x: u32,
    /// The first row.
    pub y: u32,
    /// Columns, 1..=[`Tile::SIDE`].
    pub width: u32,
    /// Rows, 1..=[`Tile::SIDE`].
    pub height: u32,
}

impl Tile {
    /// Columns and rows of a tile that no edge cuts: small enough that an expensive corner of the picture is spread
    /// over all threads, large enough that handing it out costs nothing.
    pub const SIDE: u32 = 16;

    /// The tile's pixels, neighbours together, as columns and rows of the region.
    pub fn pixels(self) -> impl Iterator<Item = (u32, u32)> {
        in_blocks(self.width, self.height).map(move |(x, y)| (self.x + x, self.y + y))
    }
}

/// The tile of that number, row by row from the top left, in a region of that size; `None` after the last.
pub(crate) fn tile(width: u32, height: u32, number: u64) -> Option<Tile> {
    let columns = u64::from(width.div_ceil(Tile::SIDE));
    let rows = u64::from(height.div_ceil(Tile::SIDE));
    if number >= columns * rows {
        return None;
    }
    // Both factors are below 2^16 here, so neither the conversion nor the product can lose anything.
    let x = u32::try_from(number % columns).ok()? * Tile::SIDE;
    let y = u32::try_from(number / columns).ok()? * Tile::SIDE;
    Some(Tile { x, y, width: Tile::SIDE.min(width - x), height: Tile::SIDE.min(height - y) })
}

/// The tiles of a region of that size, row by row from the top left.
pub fn tiles(width: u32, height: u32) -> impl Iterator<Item = Tile> {
    (0..).map_while(move |number| tile(width, height, number))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn tiles_cover_every_pixel_once() {
        for (width, height) in [(1, 1), (16, 16), (17, 15), (640, 1), (33, 50), (65_535, 1)] {
            let mut seen = HashSet::new();
            for (x, y) in tiles(width, height).flat_map(Tile::pixels) {
                assert!(x < width && y < height, "{x} {y} in {width}×{height}");
                assert!(seen.insert((x, y)), "{x} {y} twice in {width}×{height}");
            }
            assert_eq!(seen.len(), width as usize * height as usize);
        }
    }

    #[test]
    fn regions_lie_within_or_not() {
        let region = |x, y, width, height| Region { x, y, width, height };
        assert!(region(0, 0, 640, 480).lies_within(640, 480));
        assert!(region(639, 479, 1, 1).lies_within(640, 480));
        assert!(!region(639, 479, 2, 1).lies_within(640, 480));
        assert!(!region(0, 0, 0, 1).lies_within(640, 480));
        assert!(!region(u32::MAX, 0, 2, 1).lies_within(640, 480));
    }

    #[test]
    fn regions_overlap_or_not() {
        let region = |x, y, width, height| Region { x, y, width, height };
        let first = region(2, 3, 10, 10);
        assert_eq!(first.overlap(&region(5, 1, 20, 4)), Some(region(5, 3, 7, 2)));
        assert_eq!(first.overlap(&region(12, 3, 5, 5)), None);
        assert_eq!(first.overlap(&region(2, 13, 5, 5)), None);
        assert_eq!(first.overlap(&region(4, 4, 0, 5)), None);
        assert_eq!(region(7, 7, u32::MAX, 1).overlap(&region(0, 0, 9, 9)), Some(region(7, 7, 2, 1)));
    }

    #[test]
    fn a_margin_is_one_pixel_wide_and_stays_in_the_picture() {
        let region = |x, y, width, height| Region { x, y, width, height };
        assert_eq!(region(5, 6, 7, 8).with_margin(640, 480), region(4, 5, 9, 10));
        assert_eq!(region(0, 479, 640, 1).with_margin(640, 480), region(0, 478, 640, 2));
    }
}
