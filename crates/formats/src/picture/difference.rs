//! How two pictures differ: how many pixels, where, and by how much.

use lancer_scene::Picture;
use lancer_words::{Lang, picture as words};

/// How many of the differing pixels are listed one by one.
const LISTED: usize = 10;

/// What tells two pictures of one size apart. A pixel differs where some channel differs by more than the tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// How many pixels there are.
    pub pixels: usize,
    /// How many of them differ.
    pub differing: usize,
    /// The greatest difference of a channel, 0..255, whatever the tolerance.
    pub max: u8,
    /// The mean difference over all channels of all pixels, whatever the tolerance.
    pub mean: f64,
    /// The smallest rectangle that holds every differing pixel.
    pub bounds: Option<Rectangle>,
    /// The first differing pixels in row order, at most ten.
    pub first: Vec<Place>,
}

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rectangle {
    /// The leftmost column.
    pub x: u32,
    /// The topmost row.
    pub y: u32,
    /// How many columns.
    pub width: u32,
    /// How many rows.
    pub height: u32,
}

/// A pixel that differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The column, from 0 at the left.
    pub x: u32,
    /// The row, from 0 at the top.
    pub y: u32,
    /// Its bytes in the first picture.
    pub first: [u8; 3],
    /// Its bytes in the second picture.
    pub second: [u8; 3],
}

/// Pictures of different sizes cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("pictures of {} by {} and {} by {} pixels cannot be compared", first.0, first.1, second.0, second.1)]
pub struct DifferentSizes {
    /// Width and height of the first picture.
    pub first: (u32, u32),
    /// Width and height of the second picture.
    pub second: (u32, u32),
}

impl DifferentSizes {
    /// The sentence for a person.
    pub fn message(&self, lang: Lang) -> String {
        words::different_sizes(lang, self.first.0, self.first.1, self.second.0, self.second.1)
    }
}

/// The difference of two pictures, and a picture of it: the first picture darkened to grey, with every differing pixel
/// between red (by one level) and yellow (by 255).
///
/// # Errors
/// Pictures of different sizes.
pub fn compare(first: &Picture, second: &Picture, tolerance: u8) -> Result<(Difference, Picture), DifferentSizes> {
    let sizes = DifferentSizes { first: (first.width, first.height), second: (second.width, second.height) };
    if sizes.first != sizes.second || first.bytes.len() != second.bytes.len() {
        return Err(sizes);
    }
    let mut difference =
        Difference { pixels: first.bytes.len(), differing: 0, max: 0, mean: 0.0, bounds: None, first: Vec::new() };
    let mut sum = 0_u64;
    let mut bytes = Vec::with_capacity(first.bytes.len());
    let columns = (0..first.height).flat_map(|y| (0..first.width).map(move |x| (x, y)));
    for ((x, y), (&a, &b)) in columns.zip(first.bytes.iter().zip(&second.bytes)) {
        let by = [a[0].abs_diff(b[0]), a[1].abs_diff(b[1]), a[2].abs_diff(b[2])];
        let most = by[0].max(by[1]).max(by[2]);
        sum += by.iter().map(|&by| u64::from(by)).sum::<u64>();
        difference.max = difference.max.max(most);
        if most <= tolerance {
            let grey = (a.iter().map(|&value| u16::from(value)).sum::<u16>() / 12) as u8;
            bytes.push([grey; 3]);
            continue;
        }
        difference.differing += 1;
        difference.bounds =
            Some(difference.bounds.map_or(Rectangle { x, y, width: 1, height: 1 }, |old| old.with(x, y)));
        if difference.first.len() < LISTED {
            difference.first.push(Place { x, y, first: a, second: b });
        }
        bytes.push([255, most, 0]);
    }
    difference.mean = sum as f64 / (3 * difference.pixels.max(1)) as f64;
    Ok((difference, Picture { width: first.width, height: first.height, bytes, linear: None }))
}

impl Rectangle {
    /// The smallest rectangle that also holds a pixel at or below its top row.
    fn with(self, x: u32, y: u32) -> Rectangle {
        let (left, right) = (self.x.min(x), (self.x + self.width).max(x + 1));
        let bottom = (self.y + self.height).max(y + 1);
        Rectangle { x: left, width: right - left, y: self.y, height: bottom - self.y }
    }
}
