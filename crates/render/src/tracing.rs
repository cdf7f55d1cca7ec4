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
    /// One for each of [`STAGES`], up to the one that allows as many rays as the settings do.
    Engine(Vec<Stage<W>>),
    Reference(Tracer<W>),
}

/// An engine, and how many pixels it is given together.
#[derive(Clone, Debug)]
struct Stage<W> {
    together: usize,
    engine: Engine<W>,
}

/// How many pixels are traced together, and how many rays each of them may cost then.
///
/// Rays that are traced together go down together, so where no pixel ever ends, all of them would cost their budgets
/// before the first is known to exceed it, and where their ways part, each costs as much time as if it were alone. So
/// pixels of which one costs too much are traced again fewer at a time: a block, a packet, one by one.
const STAGES: [(usize, u64); 3] = [(BLOCK, 1 << 14), (8, 1 << 17), (1, u64::MAX)];

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
                let enough = STAGES.iter().position(|(_, rays)| *rays >= settings.max_rays).unwrap_or(STAGES.len() - 1);
                let engine = Engine::new(world, camera, settings, cancel, simd);
                let stage = |&(together, rays): &(usize, u64)| Stage {
                    together,
                    engine: engine.clone().with_budget(settings.max_rays.min(rays)),
                };
                Kind::Engine(STAGES[..=enough].iter().map(stage).collect())
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
        match &self.kind {
            Kind::Engine(stages) => descend(stages, pixels, counts, &wanted, &mut take),
            Kind::Reference(tracer) => {
                for &(x, y) in pixels {
                    if wanted(&[(x, y)])? {
                        take(&[(x, y)], &[tracer.pixel(x, y, counts)])?;
                    }
                }
                Some(())
            }
        }
    }
}

/// Traces pixels as many at a time as the first stage says, and those that cost too much for it by the next ones.
fn descend<W: Borrow<World>>(
    stages: &[Stage<W>],
    pixels: &[(u32, u32)],
    counts: &mut RayCounts,
    wanted: &impl Fn(&[(u32, u32)]) -> Option<bool>,
    take: &mut impl FnMut(&[(u32, u32)], &[Result<Color, TraceError>]) -> Option<()>,
) -> Option<()> {
    let [Stage { together, engine }, later @ ..] = stages else { return Some(()) };
    let mut colors = Vec::new();
    for group in pixels.chunks(*together) {
        if !wanted(group)? {
            continue;
        }
        let mut cost = RayCounts::default();
        engine.pixels(group, &mut colors, &mut cost);
        if !later.is_empty() && colors.iter().any(|color| matches!(color, Err(TraceError::Budget { .. }))) {
            descend(later, group, counts, wanted, take)?;
        } else {
            *counts += cost;
            take(group, &colors)?;
        }
    }
    Some(())
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
