//! What keeps a picture from being rendered.

use crate::Region;
use lancer_scene::Invalid;
use lancer_trace::TraceError;

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RenderError {
    /// It was asked to stop.
    #[error("the rendering was stopped")]
    Cancelled,
    /// Eye and screen break a rule.
    #[error("the view cannot be rendered: {0}")]
    View(#[from] Invalid),
    /// The region has no pixel or leaves the picture.
    #[error("the region does not lie in the picture of {width}×{height} pixels")]
    Region {
        /// The region.
        region: Region,
        /// Pixels per row of the picture.
        width: u32,
        /// Rows of the picture.
        height: u32,
    },
    /// There is no memory for the picture.
    #[error("there is no memory for {width}×{height} pixels")]
    Memory {
        /// Pixels per row.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// The threads could not be started.
    #[error("no threads could be started: {reason}")]
    Threads {
        /// What the system says.
        reason: String,
    },
    /// The first pixel, in row order, that has no colour.
    #[error("pixel {x}, {y} has no colour: {fault}")]
    Pixel {
        /// Its column in the view, from the left.
        x: u32,
        /// Its row in the view, from the top.
        y: u32,
        /// What is wrong with it.
        fault: PixelFault,
    },
}

impl RenderError {
    /// What a tracer says of a pixel of the view, with its place.
    pub fn at((x, y): (u32, u32), error: TraceError) -> RenderError {
        let fault = match error {
            TraceError::Cancelled => return RenderError::Cancelled,
            TraceError::Budget { limit } => PixelFault::Budget { limit },
            TraceError::NotFinite => PixelFault::NotFinite,
        };
        RenderError::Pixel { x, y, fault }
    }
}

/// Why a pixel has no colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PixelFault {
    /// It needs more rays than a pixel may cost.
    #[error("it needs more than {limit} rays")]
    Budget {
        /// The budget.
        limit: u64,
    },
    /// A term is not a finite number.
    #[error("a term is not a number")]
    NotFinite,
}
