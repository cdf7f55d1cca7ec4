//! One pixel by itself, for whoever wants to know more of it than its bytes.

use crate::tracing::PixelTracer;
use crate::{RenderError, Tracing};
use lancer_scene::Color;
use lancer_trace::{Camera, Cancel, RayCounts, Settings, TraceError, World};

/// The colour of pixel `(x, y)`, counted from the top left, as a picture has it before it becomes bytes.
///
/// # Errors
/// [`RenderError::Pixel`], [`RenderError::Cancelled`], or [`RenderError::Threads`]: it is computed on a thread of its
/// own, whose stack is large enough.
pub fn render_pixel(
    world: &World,
    camera: &Camera,
    settings: Settings,
    tracing: Tracing,
    place: (u32, u32),
    cancel: &Cancel,
) -> Result<Color, RenderError> {
    let tracer = PixelTracer::new(tracing, world, camera, settings, cancel);
    let trace = || {
        let mut found = Err(TraceError::Cancelled);
        // without an answer the end was asked for
        let _ = tracer.pixels(&[place], &mut RayCounts::default(), |_| true, |_, color| found = color);
        found
    };
    let color = std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(PixelTracer::<&World>::STACK).spawn_scoped(scope, trace);
        let thread = thread.map_err(|error| RenderError::Threads { reason: error.to_string() })?;
        // a panic there is one here
        Ok::<_, RenderError>(thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
    })?;
    color.map_err(|error| RenderError::at(place, error))
}
