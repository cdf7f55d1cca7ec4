//! Adaptive samples: many only where a pixel is not like its neighbours.
//!
//! Every pixel is sampled once, at its centre. A pixel whose colour differs from that of one of its eight neighbours by
//! more than a threshold, in some channel, gets all its samples instead (Whitted 1980, §3, in the plane of the picture).
//! A pixel's neighbours are those of the view, not of the region that is rendered, so regions join without seams. What
//! is smaller than a pixel and meets no centre stays unseen: that is the price.

use crate::film::reserve;
use crate::work::Done;
use crate::{Region, RenderError};

/// The colours at the centres of the pixels of a region.
#[derive(Debug)]
pub(crate) struct Centres {
    region: Region,
    colors: Vec<[f32; 3]>,
}

impl Centres {
    /// Room for the colours of a region.
    ///
    /// # Errors
    /// [`RenderError::Memory`] if there is none.
    pub(crate) fn new(region: Region) -> Result<Centres, RenderError> {
        let mut colors = reserve(region)?;
        colors.resize(colors.capacity(), [0.0; 3]);
        Ok(Centres { region, colors })
    }

    /// Takes the colours of a tile.
    pub(crate) fn take(&mut self, done: &Done) {
        for (&(x, y), color) in done.pixels.iter().zip(&done.colors) {
            let place = self.place(x, y);
            self.colors[place] = color.to_array().map(|channel| channel as f32);
        }
    }

    /// Whether a pixel differs from a neighbour by more than a threshold. From one without a colour every pixel does.
    pub(crate) fn differs(&self, x: u32, y: u32, threshold: f64) -> bool {
        let own = self.colors[self.place(x, y)];
        let alike = |other: [f32; 3]| {
            own.iter().zip(other).all(|(own, other)| (f64::from(*own) - f64::from(other)).abs() <= threshold)
        };
        let around = |at: u32| at.saturating_sub(1)..=at.saturating_add(1);
        let mut neighbours = around(y).flat_map(|y| around(x).map(move |x| (x, y)));
        neighbours.any(|(x, y)| self.region.contains(x, y) && !alike(self.colors[self.place(x, y)]))
    }

    fn place(&self, x: u32, y: u32) -> usize {
        (y - self.region.y) as usize * self.region.width as usize + (x - self.region.x) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lancer_scene::Rgb;
    use lancer_trace::RayCounts;

    /// One grey pixel among black ones: it and its eight neighbours differ, and nobody does by more than its grey.
    #[test]
    fn a_pixel_differs_from_its_eight_neighbours() {
        let region = Region { x: 10, y: 20, width: 6, height: 5 };
        let mut centres = Centres::new(region).unwrap();
        let gray = Done {
            size: 1,
            pixels: vec![(12, 22)],
            colors: vec![Rgb::new(0.0, 0.25, 0.0)],
            bytes: vec![[0, 64, 0]],
            counts: RayCounts::default(),
        };
        centres.take(&gray);
        for y in 20..25 {
            for x in 10..16 {
                let next_to = (11..=13).contains(&x) && (21..=23).contains(&y);
                assert_eq!(centres.differs(x, y, 0.24), next_to, "{x} {y}");
                assert!(!centres.differs(x, y, 0.25));
            }
        }
    }
}
