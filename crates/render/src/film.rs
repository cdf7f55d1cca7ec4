//! Where finished tiles are put together to a picture.

use crate::{RenderError, Tile};
use lancer_scene::{Color, Picture};

/// A picture that is being put together from tiles.
///
/// Its memory is reserved at once, so that too large a picture is refused before the first ray; it is touched only as
/// far down as tiles have arrived, so an interrupted render of a huge picture costs little.
#[derive(Debug)]
pub struct Film {
    width: u32,
    height: u32,
    bytes: Vec<[u8; 3]>,
    linear: Option<Vec<[f32; 3]>>,
}

impl Film {
    /// A film for a picture of that size, which keeps the linear colours beside the bytes if asked to.
    ///
    /// # Errors
    /// [`RenderError::Memory`] if there is no room for it.
    pub fn new(width: u32, height: u32, keep_linear: bool) -> Result<Film, RenderError> {
        let refused = |()| RenderError::Memory { width, height };
        let pixels = usize::try_from(u64::from(width) * u64::from(height)).map_err(|_| refused(()))?;
        let bytes = reserve(pixels).map_err(refused)?;
        let linear = keep_linear.then(|| reserve(pixels)).transpose().map_err(refused)?;
        Ok(Film { width, height, bytes, linear })
    }

    /// Puts the colours of a tile, in row order, at its place. The colours become bytes here (SPEC §1, "pixel").
    pub fn place(&mut self, tile: Tile, colors: &[Color]) {
        let width = self.width as usize;
        let end = (tile.y + tile.height) as usize * width;
        grow(&mut self.bytes, end);
        if let Some(linear) = &mut self.linear {
            grow(linear, end);
        }
        for (row, colors) in (tile.y as usize..).zip(colors.chunks(tile.width as usize)) {
            let first = row * width + tile.x as usize;
            for (byte, color) in self.bytes.iter_mut().skip(first).zip(colors) {
                *byte = color.to_bytes();
            }
            if let Some(linear) = &mut self.linear {
                for (value, color) in linear.iter_mut().skip(first).zip(colors) {
                    *value = color.to_array().map(|channel| channel as f32);
                }
            }
        }
    }

    /// The picture, once every tile is placed.
    pub fn into_picture(self) -> Picture {
        Picture { width: self.width, height: self.height, bytes: self.bytes, linear: self.linear }
    }
}

/// An empty list with room for `count` items, or nothing where there is none.
fn reserve<T>(count: usize) -> Result<Vec<T>, ()> {
    let mut items = Vec::new();
    items.try_reserve_exact(count).map(|()| items).map_err(|_| ())
}

/// Black down to `end`, within the room that was reserved.
fn grow<T: Copy + Default>(items: &mut Vec<T>, end: usize) {
    if items.len() < end {
        items.resize(end, T::default());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tiles;
    use lancer_scene::Rgb;

    /// Any order of the tiles gives the same picture.
    #[test]
    fn tiles_are_put_at_their_place() {
        let color = |x: u32, y: u32| Rgb::new(f64::from(x) / 255.0, f64::from(y) / 255.0, 0.0);
        let mut film = Film::new(40, 33, true).unwrap();
        let mut all: Vec<Tile> = tiles(40, 33).collect();
        all.reverse();
        for tile in all {
            film.place(tile, &tile.pixels().map(|(x, y)| color(x, y)).collect::<Vec<_>>());
        }
        let picture = film.into_picture();
        assert_eq!(picture.bytes.len(), 40 * 33);
        for y in 0..33 {
            for x in 0..40 {
                assert_eq!(picture.pixel(x, y), Some([x as u8, y as u8, 0]));
                let linear = picture.linear.as_ref().unwrap()[(y * 40 + x) as usize];
                assert_eq!(linear, color(x, y).to_array().map(|channel| channel as f32));
            }
        }
    }
}
