//! The picture that a session shows while it grows.

use crate::Unit;
use lancer_scene::Picture;

/// What a pixel holds that belongs to an earlier picture.
const STALE: u8 = u8::MAX;

/// A picture in which every pixel knows how coarse it is. The pixels of the last good picture stay until they are
/// replaced.
#[derive(Clone, Debug, Default)]
pub struct LiveImage {
    width: u32,
    height: u32,
    bytes: Vec<[u8; 3]>,
    /// The step of the pass that gave each pixel its colour.
    steps: Vec<u8>,
    exact: u64,
    stale: u64,
}

impl LiveImage {
    /// Pixels per row.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The pixels in row order from the top.
    pub fn bytes(&self) -> &[[u8; 3]] {
        &self.bytes
    }

    /// How many pixels have the colour that they keep.
    pub fn exact(&self) -> u64 {
        self.exact
    }

    /// Whether some pixels still show an earlier picture.
    pub fn is_stale(&self) -> bool {
        self.stale > 0
    }

    /// Whether every pixel has the colour that it keeps.
    pub fn is_finished(&self) -> bool {
        self.exact == self.bytes.len() as u64 && self.exact > 0
    }

    /// The finished picture.
    pub fn picture(&self) -> Option<Picture> {
        self.is_finished().then(|| Picture {
            width: self.width,
            height: self.height,
            bytes: self.bytes.clone(),
            linear: None,
        })
    }

    /// Begins a new picture of that size. What is shown stays, stretched if the size is another one.
    pub(super) fn restart(&mut self, width: u32, height: u32) {
        if (width, height) != (self.width, self.height) {
            self.bytes = stretched(&self.bytes, (self.width, self.height), (width, height));
            (self.width, self.height) = (width, height);
        }
        self.steps.clear();
        self.steps.resize(self.bytes.len(), STALE);
        self.exact = 0;
        self.stale = self.bytes.len() as u64;
    }

    /// Takes the colours of a unit's pixels, in their order. Each fills the square up to its neighbours on the pass's
    /// grid, as far as nothing finer stands there.
    pub(super) fn take(&mut self, unit: &Unit, colors: &[[u8; 3]]) {
        let step = unit.pass.step();
        for ((x, y), color) in unit.pixels().zip(colors) {
            if step > 1 {
                self.fill((x, y), step, *color);
            }
            // the pixel itself is exact, whatever its pass
            let place = y as usize * self.width as usize + x as usize;
            if self.steps[place] != 0 {
                self.stale -= u64::from(self.steps[place] == STALE);
                self.steps[place] = 0;
                self.bytes[place] = *color;
                self.exact += 1;
            }
        }
    }

    /// Fills the square of a pixel where an earlier picture or a coarser pass is seen.
    fn fill(&mut self, (x, y): (u32, u32), step: u32, color: [u8; 3]) {
        let (first, end) = (x as usize, (x + step).min(self.width) as usize);
        for row in y..(y + step).min(self.height) {
            let begin = row as usize * self.width as usize;
            let places = begin + first..begin + end;
            let (steps, bytes) = (&mut self.steps[places.clone()], &mut self.bytes[places]);
            for (known, byte) in steps.iter_mut().zip(bytes).filter(|(known, _)| u32::from(**known) > step) {
                self.stale -= u64::from(*known == STALE);
                (*known, *byte) = (step as u8, color);
            }
        }
    }
}

/// The nearest pixels of a picture of another size; black where there was none.
fn stretched(bytes: &[[u8; 3]], from: (u32, u32), to: (u32, u32)) -> Vec<[u8; 3]> {
    if bytes.is_empty() {
        return vec![[0; 3]; to.0 as usize * to.1 as usize];
    }
    let scaled = |place: u32, from: u32, to: u32| (u64::from(place) * u64::from(from) / u64::from(to)) as usize;
    (0..to.1)
        .flat_map(|y| {
            let row = scaled(y, from.1, to.1) * from.0 as usize;
            (0..to.0).map(move |x| bytes[row + scaled(x, from.0, to.0)])
        })
        .collect()
}
