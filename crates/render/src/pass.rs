//! Coarse to fine: a live picture is computed in passes, each of which adds pixels between those of the one before.

use crate::blocks::in_blocks;
use crate::{Region, Tile};

/// A pass computes every `step`-th pixel of every `step`-th row, leaving out what a coarser pass computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Pass {
    step: u32,
}

impl Pass {
    /// The first pass: one pixel of 256. All views wait for it after an edit, so it is as cheap as can be recognised.
    pub const COARSEST: Pass = Pass { step: 16 };
    /// The last pass: whatever is missing.
    pub const FINEST: Pass = Pass { step: 1 };
    /// How many times closer the pixels of the next pass stand. Rays that are neighbours cost least, so few passes are
    /// faster in the end: sixteenfold, the finest one leaves out only what stands in its way.
    const RATIO: u32 = 4;

    /// How far apart the pixels stand that are known after this pass.
    pub fn step(self) -> u32 {
        self.step
    }

    /// The pass after this one; `None` after the last.
    pub fn next(self) -> Option<Pass> {
        (self.step > 1).then_some(Pass { step: self.step / Pass::RATIO })
    }

    /// Whether this pass computes the pixel.
    pub fn computes(self, x: u32, y: u32) -> bool {
        let on_grid = |step: u32| x.is_multiple_of(step) && y.is_multiple_of(step);
        on_grid(self.step) && (self == Pass::COARSEST || !on_grid(Pass::RATIO * self.step))
    }

    /// The pass that computes the pixel.
    pub fn of_pixel(x: u32, y: u32) -> Pass {
        let mut pass = Pass::COARSEST;
        while let Some(finer) = pass.next().filter(|_| !pass.computes(x, y)) {
            pass = finer;
        }
        pass
    }

    /// How many pixels the pass computes in a rectangle: those on its grid without those of coarser ones.
    pub fn count(self, within: Region) -> u64 {
        let multiples = |step: u32, first: u32, length: u32| {
            u64::from(first.saturating_add(length).div_ceil(step)) - u64::from(first.div_ceil(step))
        };
        let on_grid = |step: u32| multiples(step, within.x, within.width) * multiples(step, within.y, within.height);
        let coarser = if self == Pass::COARSEST { 0 } else { on_grid(Pass::RATIO * self.step) };
        on_grid(self.step) - coarser
    }

    /// Columns and rows of a unit of work: at most as many pixels of the pass as a still picture's tile has.
    fn side(self) -> u32 {
        Tile::SIDE * self.step
    }

    /// How many units of work the pass has in a picture of that size.
    pub fn units(self, width: u32, height: u32) -> u64 {
        u64::from(width.div_ceil(self.side())) * u64::from(height.div_ceil(self.side()))
    }

    /// The rectangle of a unit of work, row by row from the top left.
    pub fn unit(self, width: u32, height: u32, number: u64) -> Option<Region> {
        let columns = u64::from(width.div_ceil(self.side()));
        if number >= self.units(width, height) {
            return None;
        }
        let x = u32::try_from(number % columns).ok()? * self.side();
        let y = u32::try_from(number / columns).ok()? * self.side();
        Some(Region { x, y, width: self.side().min(width - x), height: self.side().min(height - y) })
    }

    /// The pixels that the pass computes in a rectangle that begins on its grid, neighbours together.
    pub fn pixels(self, within: Region) -> impl Iterator<Item = (u32, u32)> {
        let step = self.step;
        in_blocks(within.width.div_ceil(step), within.height.div_ceil(step))
            .map(move |(column, row)| (within.x + column * step, within.y + row * step))
            .filter(move |&(x, y)| self.computes(x, y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All passes together compute every pixel once, whatever the size.
    #[test]
    fn passes_compute_every_pixel_once() {
        for (width, height) in [(1, 1), (8, 8), (640, 48), (131, 77), (3, 300)] {
            let mut times = vec![0; (width * height) as usize];
            let mut pass = Some(Pass::COARSEST);
            while let Some(now) = pass {
                for number in 0..now.units(width, height) {
                    let unit = now.unit(width, height, number).unwrap();
                    assert!(unit.lies_within(width, height));
                    let mut computed = 0;
                    for (x, y) in now.pixels(unit) {
                        assert_eq!(Pass::of_pixel(x, y), now);
                        computed += 1;
                        times[(y * width + x) as usize] += 1;
                    }
                    assert_eq!(now.count(unit), computed);
                }
                assert_eq!(now.unit(width, height, now.units(width, height)), None);
                pass = now.next();
            }
            assert!(times.iter().all(|times| *times == 1), "{width}×{height}");
        }
    }

    /// Of a rectangle anywhere.
    #[test]
    fn pixels_are_counted() {
        for within in [(3, 5, 40, 21), (16, 32, 1, 1), (15, 31, 2, 2), (1, 1, 14, 3), (0, 0, 0, 9)] {
            let within = Region { x: within.0, y: within.1, width: within.2, height: within.3 };
            let pixels = |pass: Pass| {
                let rows = within.y..within.y + within.height;
                rows.flat_map(|y| (within.x..within.x + within.width).map(move |x| (x, y)))
                    .filter(|&(x, y)| pass.computes(x, y))
                    .count() as u64
            };
            let mut pass = Some(Pass::COARSEST);
            while let Some(now) = pass {
                assert_eq!(now.count(within), pixels(now), "{now:?} {within:?}");
                pass = now.next();
            }
        }
    }

    #[test]
    fn units_are_no_larger_than_tiles() {
        let unit = Pass::COARSEST.unit(640, 480, 0).unwrap();
        assert_eq!(Pass::COARSEST.pixels(unit).count(), 256);
        assert_eq!(Pass::FINEST.pixels(Pass::FINEST.unit(640, 480, 0).unwrap()).count(), 240);
    }
}
