//! The order in which pixels are handed to a tracer: those that stand near each other stay together.
//!
//! The engine traces lists of pixels, eight to a packet and sixty-four to a block. Rays of one packet that see the same
//! things cost little more than one of them, so a packet is 4×2 pixels and a block 8×8. The order decides nothing else.

/// How many pixels are traced together: those of one block.
pub(crate) const BLOCK: usize = 64;

/// The columns and rows of a raster of that size, block by block and packet by packet, from the top left.
pub(crate) fn in_blocks(width: u32, height: u32) -> impl Iterator<Item = (u32, u32)> {
    let blocks = (0..height.div_ceil(8)).flat_map(move |row| (0..width.div_ceil(8)).map(move |column| (column, row)));
    blocks
        .flat_map(|(column, row)| ORDER.iter().map(move |&(x, y)| (8 * column + x, 8 * row + y)))
        .filter(move |&(x, y)| x < width && y < height)
}

/// The order of the pixels of one block.
const ORDER: [(u32, u32); BLOCK] = {
    let mut order = [(0, 0); BLOCK];
    let mut number = 0;
    while number < BLOCK as u32 {
        let (lane, packet) = (number % 8, number / 8);
        order[number as usize] = (packet % 2 * 4 + lane % 4, packet / 2 * 2 + lane / 4);
        number += 1;
    }
    order
};

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn every_pixel_comes_once() {
        for (width, height) in [(1, 1), (8, 8), (16, 16), (17, 15), (3, 100)] {
            let pixels: Vec<_> = in_blocks(width, height).collect();
            assert_eq!(pixels.len(), (width * height) as usize);
            assert_eq!(pixels.iter().collect::<HashSet<_>>().len(), pixels.len());
        }
    }

    /// A block is 8×8 pixels, a packet of it 4×2.
    #[test]
    fn neighbours_stay_together() {
        let pixels: Vec<_> = in_blocks(24, 16).collect();
        let extent = |pixels: &[(u32, u32)]| {
            let span = |of: fn(&(u32, u32)) -> u32| {
                pixels.iter().map(of).max().unwrap() - pixels.iter().map(of).min().unwrap() + 1
            };
            (span(|pixel| pixel.0), span(|pixel| pixel.1))
        };
        assert!(pixels.chunks(8).all(|packet| extent(packet) == (4, 2)));
        assert!(pixels.chunks(BLOCK).all(|block| extent(block) == (8, 8)));
        assert_eq!(pixels[..9], [(0, 0), (1, 0), (2, 0), (3, 0), (0, 1), (1, 1), (2, 1), (3, 1), (4, 0)]);
    }
}
