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
pub(crate) struct PixelTracer<W> {
    kind: Kind<W>,
    cancel: Cancel,
}

#[derive(Clone, Debug)]
enum Kind<W> {
    Engine {
        /// Whose pixels may cost no more than [`TOGETHER`].
        engine: Engine<W>,
        /// Whose pixels may cost as much as the settings say, where that is more.
        patient: Option<Box<Engine<W>>>,
    },
    Reference(Tracer<W>),
}

/// How many rays each pixel of a block may cost while the whole block is traced together.
///
/// The rays of a block go down together, so where no pixel ever ends, all of them would cost their budgets before the
/// first is known to exceed it. A block with a pixel that costs more than this is traced again packet by packet.
const TOGETHER: u64 = 1 << 16;

/// The pixels of a packet.
const PACKET: usize = 8;

impl<W: Borrow<World> + Clone> PixelTracer<W> {
    /// How much stack a thread needs to follow rays down to the greatest depth.
    pub(crate) const STACK: usize = 16 << 20;

    pub(crate) fn new(
        tracing: Tracing,
        world: W,
        camera: &Camera,
        settings: Settings,
        cancel: &Cancel,
    ) -> PixelTracer<W> {
        let kind = match tracing {
            Tracing::Engine(simd) => {
                let engine = |max_rays| {
                    let settings = Settings { max_rays, ..settings };
                    Engine::new(world.clone(), camera, settings, cancel, simd)
                };
                let patient = (settings.max_rays > TOGETHER).then(|| Box::new(engine(settings.max_rays)));
                Kind::Engine { engine: engine(settings.max_rays.min(TOGETHER)), patient }
            }
            Tracing::Reference => Kind::Reference(Tracer::new(world, camera, settings, cancel)),
        };
        PixelTracer { kind, cancel: cancel.clone() }
    }

    /// Hands the colours of pixels to `take`, in their order, and counts their rays. `wanted` is asked for some pixels
    /// at a time before they are traced; those that are not wanted are left out.
    ///
    /// Gives `None` as soon as the end is asked for.
    pub(crate) fn pixels(
        &self,
        pixels: &[(u32, u32)],
        counts: &mut RayCounts,
        wanted: impl Fn(&[(u32, u32)]) -> bool,
        mut take: impl FnMut((u32, u32), Result<Color, TraceError>),
    ) -> Option<()> {
        let mut take = |pixels: &[(u32, u32)], colors: &[Result<Color, TraceError>]| {
            // what is cancelled stays so
            let finished = colors.last() != Some(&Err(TraceError::Cancelled));
            finished.then(|| pixels.iter().zip(colors).for_each(|(&pixel, &color)| take(pixel, color)))
        };
        let wanted = |pixels: &[(u32, u32)]| (!self.cancel.is_cancelled()).then(|| wanted(pixels));
        let mut colors = Vec::new();
        match &self.kind {
            Kind::Engine { engine, patient } => {
                for block in pixels.chunks(BLOCK) {
                    if !wanted(block)? {
                        continue;
                    }
                    let mut cost = RayCounts::default();
                    engine.pixels(block, &mut colors, &mut cost);
                    let spent = colors.iter().any(|color| matches!(color, Err(TraceError::Budget { .. })));
                    let Some(patient) = patient.as_ref().filter(|_| spent) else {
                        *counts += cost;
                        take(block, &colors)?;
                        continue;
                    };
                    for packet in block.chunks(PACKET) {
                        if wanted(packet)? {
                            patient.pixels(packet, &mut colors, counts);
                            take(packet, &colors)?;
                        }
                    }
                }
            }
            Kind::Reference(tracer) => {
                for pixel in pixels.chunks(1) {
                    if wanted(pixel)? {
                        colors.clear();
                        colors.extend(pixel.iter().map(|&(x, y)| tracer.pixel(x, y, counts)));
                        take(pixel, &colors)?;
                    }
                }
            }
        }
        Some(())
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
