//! Where finished tiles are put together to a picture.

use crate::work::Done;
use crate::{Region, RenderError};
use lancer_scene::Picture;

/// A picture that is being put together from finished tiles.
///
/// Its memory is reserved at once, so that too large a picture is refused before the first ray; it is touched only as
/// far down as tiles have arrived, so an interrupted render of a huge picture costs little.
#[derive(Debug)]
pub(crate) struct Film {
    region: Region,
    bytes: Vec<[u8; 3]>,
    linear: Option<Vec<[f32; 3]>>,
}

impl Film {
    /// A film for the picture of a region, which keeps the linear colours beside the bytes if asked to.
    ///
    /// # Errors
    /// [`RenderError::Memory`] if there is no room for it.
    pub(crate) fn new(region: Region, keep_linear: bool) -> Result<Film, RenderError> {
        let bytes = reserve(region)?;
        let linear = keep_linear.then(|| reserve(region)).transpose()?;
        Ok(Film { region, bytes, linear })
    }

    /// Puts the pixels of a tile at their places; those outside of the region are left out.
    pub(crate) fn place(&mut self, done: &Done) {
        put(&mut self.bytes, self.region, done.pixels.iter().zip(&done.bytes), |&bytes| bytes);
        if let Some(linear) = &mut self.linear {
            put(linear, self.region, done.pixels.iter().zip(&done.colors), |color| {
                color.to_array().map(|channel| channel as f32)
            });
        }
    }

    /// The picture, once every tile is placed.
    pub(crate) fn into_picture(self) -> Picture {
        let Region { width, height, .. } = self.region;
        Picture { width, height, bytes: self.bytes, linear: self.linear }
    }
}

/// An empty list with room for an item for each pixel of a region.
///
/// # Errors
/// [`RenderError::Memory`] if there is no room for it.
pub(crate) fn reserve<T>(region: Region) -> Result<Vec<T>, RenderError> {
    let refused = || RenderError::Memory { width: region.width, height: region.height };
    let mut items = Vec::new();
    let pixels = usize::try_from(region.pixels()).map_err(|_| refused())?;
    items.try_reserve_exact(pixels).map_err(|_| refused())?;
    Ok(items)
}

/// Puts the pixels that lie in a region at their places among its items, which are black as far down as they go.
fn put<'d, T: Copy + Default, C: 'd>(
    items: &mut Vec<T>,
    region: Region,
    pixels: impl Iterator<Item = (&'d (u32, u32), &'d C)>,
    item: impl Fn(&C) -> T,
) {
    let Region { x: left, y: top, width, .. } = region;
    for (&(x, y), color) in pixels {
        if region.contains(x, y) {
            let row = (y - top) as usize * width as usize;
            if items.len() <= row {
                // within the room that was reserved
                items.resize(row + width as usize, T::default());
            }
            items[row + (x - left) as usize] = item(color);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Tile, tiles};
    use lancer_scene::Rgb;
    use lancer_trace::RayCounts;

    /// Any order of the tiles gives the same picture, and pixels around the region are no part of it.
    #[test]
    fn tiles_are_put_at_their_place() {
        let color = |x: u32, y: u32| Rgb::new(f64::from(x) / 255.0, f64::from(y) / 255.0, 0.0);
        let region = Region { x: 3, y: 7, width: 40, height: 33 };
        let mut film = Film::new(region, true).unwrap();
        let mut all: Vec<Tile> = tiles(50, 50).collect();
        all.reverse();
        for tile in all {
            let pixels: Vec<(u32, u32)> = tile.pixels().collect();
            let colors: Vec<Rgb> = pixels.iter().map(|&(x, y)| color(x, y)).collect();
            let bytes = colors.iter().map(|color| color.to_bytes()).collect();
            film.place(&Done { size: 0, pixels, colors, bytes, counts: RayCounts::default() });
        }
        let picture = film.into_picture();
        assert_eq!((picture.width, picture.height, picture.bytes.len()), (40, 33, 40 * 33));
        for y in 0..33 {
            for x in 0..40 {
                assert_eq!(picture.pixel(x, y), Some([x as u8 + 3, y as u8 + 7, 0]));
                let linear = picture.linear.as_ref().unwrap()[(y * 40 + x) as usize];
                assert_eq!(linear, color(x + 3, y + 7).to_array().map(|channel| channel as f32));
            }
        }
    }
}
