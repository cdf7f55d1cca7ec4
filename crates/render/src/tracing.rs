//! What follows the rays of a picture: the engine, or the reference that it is held to.

use crate::blocks::BLOCK;
use lancer_scene::Color;
use lancer_trace::{Camera, Cancel, Engine, RayCounts, Settings, Simd, TraceError, Tracer, World};
use std::borrow::Borrow;

/// What follows the rays. The picture is the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Tracing {
    /// The engine: many rays at a time, with these instructions, or the best there are where the machine lacks them.
    Engine(Simd),
    /// The subject's formulas, one ray at a time: slow, and the truth that the engine is held to.
    Reference,
}

impl Default for Tracing {
    fn default() -> Tracing {
        Tracing::Engine(Simd::best())
    }
}

/// Why an engine cannot be had with the instructions that were asked for.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SimdError {
    /// There are none of that name.
    #[error("there are no instructions called {name}")]
    Unknown {
        /// The name.
        name: String,
    },
    /// This machine does not have them.
    #[error("this machine cannot run {}", simd.name())]
    Missing {
        /// The instructions.
        simd: Simd,
    },
}

impl Tracing {
    /// The environment variable by which a user of the programs chooses the engine's instructions.
    pub const VARIABLE: &str = "LANCER_SIMD";

    /// The instructions of a name (see [`Simd::name`]); an empty name stands for the best that this machine has.
    ///
    /// # Errors
    /// If there are none of that name, or this machine does not have them.
    pub fn simd_named(name: &str) -> Result<Simd, SimdError> {
        if name.is_empty() {
            return Ok(Simd::best());
        }
        match Simd::ALL.into_iter().find(|simd| simd.name() == name) {
            None => Err(SimdError::Unknown { name: name.to_owned() }),
            Some(simd) if !simd.is_available() => Err(SimdError::Missing { simd }),
            Some(simd) => Ok(simd),
        }
    }
}

/// Either of them at work on one picture.
#[derive(Clone, Debug)]
pub(crate) enum PixelTracer<W> {
    Engine(Engine<W>),
    Reference(Tracer<W>, Cancel),
}

impl<W: Borrow<World>> PixelTracer<W> {
    /// How much stack a thread needs to follow rays down to the greatest depth.
    pub(crate) const STACK: usize = 16 << 20;

    pub(crate) fn new(
        tracing: Tracing,
        world: W,
        camera: &Camera,
        settings: Settings,
        cancel: &Cancel,
    ) -> PixelTracer<W> {
        match tracing {
            Tracing::Engine(simd) => PixelTracer::Engine(Engine::new(world, camera, settings, cancel, simd)),
            Tracing::Reference => PixelTracer::Reference(Tracer::new(world, camera, settings, cancel), cancel.clone()),
        }
    }

    /// How many pixels should be asked for at a time, where somebody may want to stop in between.
    pub(crate) fn batch(&self) -> usize {
        match self {
            PixelTracer::Engine(_) => BLOCK,
            PixelTracer::Reference(..) => 1,
        }
    }

    /// The colours of pixels in their order.
    pub(crate) fn pixels(
        &self,
        pixels: &[(u32, u32)],
        colors: &mut Vec<Result<Color, TraceError>>,
        counts: &mut RayCounts,
    ) {
        match self {
            PixelTracer::Engine(engine) => engine.pixels(pixels, colors, counts),
            PixelTracer::Reference(tracer, cancel) => {
                colors.clear();
                colors.extend(pixels.iter().map(|&(x, y)| match cancel.is_cancelled() {
                    // the tracer itself looks at the flag only within a pixel of many rays
                    true => Err(TraceError::Cancelled),
                    false => tracer.pixel(x, y, counts),
                }));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_are_chosen_by_name() {
        assert_eq!(Tracing::simd_named(""), Ok(Simd::best()));
        assert_eq!(Tracing::simd_named("portable"), Ok(Simd::Portable));
        for name in ["AVX2", "sse", " "] {
            assert_eq!(Tracing::simd_named(name), Err(SimdError::Unknown { name: name.to_owned() }));
        }
        for simd in Simd::ALL {
            let due = if simd.is_available() { Ok(simd) } else { Err(SimdError::Missing { simd }) };
            assert_eq!(Tracing::simd_named(simd.name()), due);
        }
    }
}
