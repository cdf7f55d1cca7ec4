//! The explanation of a pixel: the trees of its samples and the mean that becomes its bytes.

mod account;
mod names;

pub use account::{Course, Entry, Factor, Part, Way, account};
pub use names::RayNames;

use crate::{Camera, Cancel, RayTree, Settings, TraceError, Tracer, World};
use lancer_scene::Color;

/// A pixel opened.
#[derive(Clone, Debug, PartialEq)]
pub struct PixelTree {
    /// Its samples in row order.
    pub samples: Vec<SampleTree>,
    /// The mean of the clamped samples: the pixel's colour.
    pub color: Color,
    /// The bytes that stand in the picture.
    pub bytes: [u8; 3],
}

/// One sample of a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct SampleTree {
    /// Pixels from the left.
    pub x: f64,
    /// Pixels from the top.
    pub y: f64,
    /// The clamped colour.
    pub color: Color,
    /// Every ray and every term.
    pub tree: RayTree,
}

/// Traces pixel `(i, j)` exactly as a picture's pixel and records everything.
///
/// # Errors
/// As [`Tracer::pixel`].
pub fn explain(
    world: &World,
    camera: &Camera,
    settings: Settings,
    (i, j): (u32, u32),
    cancel: &Cancel,
) -> Result<PixelTree, TraceError> {
    let tracer = Tracer::new(world, camera, settings, cancel);
    // first, so that the budget of the whole pixel bounds what is recorded
    let color = tracer.pixel(i, j, &mut ())?;
    let samples = camera
        .sample_positions(i, j)
        .map(|(x, y)| {
            let mut tree = RayTree::default();
            let color = tracer.sample(x, y, &mut tree)?;
            Ok(SampleTree { x, y, color, tree })
        })
        .collect::<Result<Vec<_>, TraceError>>()?;
    Ok(PixelTree { samples, color, bytes: color.to_bytes() })
}
