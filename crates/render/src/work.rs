//! The threads that compute pixels of one picture, tile by tile from the top left. They send what is finished to the
//! calling thread, which alone knows what becomes of it.

use crate::tile::tile;
use crate::tracing::PixelTracer;
use crate::{Region, RenderError};
use lancer_scene::Color;
use lancer_trace::{Cancel, RayCounts, World};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc;
use std::thread;

/// What all threads share while the pixels of a region are computed.
#[derive(Debug)]
pub(crate) struct Work<'a, Wanted> {
    tracer: PixelTracer<&'a World>,
    region: Region,
    /// The pixels that must have a colour: the region, or the part of it that a picture is made of.
    needed: Region,
    /// Which pixels of the region are computed.
    wanted: Wanted,
    cancel: &'a Cancel,
    /// The number of the tile that is next.
    next: AtomicU64,
    /// The number, in row order, of the first pixel known to have no colour. Nothing after it is computed any more,
    /// everything before it is: that makes the reported pixel the same for every number of threads.
    failed: AtomicU64,
}

/// A finished tile.
#[derive(Debug)]
pub(crate) struct Done {
    /// How many pixels the tile has.
    pub(crate) size: u64,
    /// The columns and rows, in the view, of those that were computed.
    pub(crate) pixels: Vec<(u32, u32)>,
    /// Their colours, in the same order; NaN for one that has none and needs none.
    pub(crate) colors: Vec<Color>,
    /// Their bytes, in the same order.
    pub(crate) bytes: Vec<[u8; 3]>,
    /// What they cost.
    pub(crate) counts: RayCounts,
}

/// A pixel without a colour.
struct Failure {
    /// Its number in row order within the region.
    pixel: u64,
    error: RenderError,
}

impl<'a, Wanted: Fn(u32, u32) -> bool + Sync> Work<'a, Wanted> {
    /// The pixels of a region of a view for which `wanted` holds, by their columns and rows in the view.
    pub(crate) fn new(
        tracer: PixelTracer<&'a World>,
        region: Region,
        wanted: Wanted,
        cancel: &'a Cancel,
    ) -> Work<'a, Wanted> {
        let (next, failed) = (AtomicU64::new(0), AtomicU64::new(u64::MAX));
        Work { tracer, region, needed: region, wanted, cancel, next, failed }
    }

    /// The same, but pixels outside of a smaller region may do without a colour.
    pub(crate) fn needing(self, needed: Region) -> Work<'a, Wanted> {
        Work { needed, ..self }
    }

    /// Computes the pixels on so many threads; `take` gets them as they are finished, in any order.
    ///
    /// # Errors
    /// [`RenderError::Pixel`] names the first pixel, in row order, that has no colour, whatever the number of threads;
    /// [`RenderError::Threads`] and [`RenderError::Cancelled`].
    pub(crate) fn carry_out(&self, threads: usize, mut take: impl FnMut(Done)) -> Result<(), RenderError> {
        let (sender, finished) = mpsc::sync_channel::<Result<Done, Failure>>(2 * threads);
        let mut failure = None::<Failure>;
        thread::scope(|scope| {
            for number in 0..threads {
                let sender = sender.clone();
                let worker =
                    thread::Builder::new().name(format!("tile {number}")).stack_size(PixelTracer::<&World>::STACK);
                let worker = worker.spawn_scoped(scope, move || self.compute(|outcome| sender.send(outcome).is_ok()));
                if let Err(error) = worker {
                    // those that have begun find nothing more to do
                    self.next.store(u64::MAX / 2, Ordering::Relaxed);
                    failure = Some(Failure { pixel: 0, error: RenderError::Threads { reason: error.to_string() } });
                    break;
                }
            }
            drop(sender);
            for outcome in finished {
                match outcome {
                    Ok(done) => take(done),
                    Err(found) => {
                        failure = Some(match failure.take() {
                            Some(earlier) if earlier.pixel <= found.pixel => earlier,
                            Some(_) | None => found,
                        });
                    }
                }
            }
        });
        match failure {
            _ if self.cancel.is_cancelled() => Err(RenderError::Cancelled),
            Some(failure) => Err(failure.error),
            None => Ok(()),
        }
    }

    /// A thread's work: tiles, until there are no more or `send` says that nobody wants them.
    fn compute(&self, send: impl Fn(Result<Done, Failure>) -> bool) {
        let Region { width, height, .. } = self.region;
        while let Some(tile) = tile(width, height, self.next.fetch_add(1, Ordering::Relaxed)) {
            let first = self.number((self.region.x + tile.x, self.region.y + tile.y));
            // the pixels of later tiles come later
            if self.cancel.is_cancelled() || self.is_beyond(first) {
                break;
            }
            let mut pixels = Vec::with_capacity((tile.width * tile.height) as usize);
            tile.pixels().for_each(|(x, y)| {
                let (x, y) = (self.region.x + x, self.region.y + y);
                if (self.wanted)(x, y) {
                    pixels.push((x, y));
                }
            });
            let size = u64::from(tile.width) * u64::from(tile.height);
            if let Some(outcome) = self.trace(size, pixels)
                && !send(outcome)
            {
                break;
            }
        }
    }

    /// The colours of a tile's pixels; `None` if it is left unfinished because nobody wants it any more.
    fn trace(&self, size: u64, pixels: Vec<(u32, u32)>) -> Option<Result<Done, Failure>> {
        let (mut counts, mut colors) = (RayCounts::default(), Vec::with_capacity(pixels.len()));
        let mut failure = None::<Failure>;
        let wanted = |pixels: &[(u32, u32)]| {
            if self.failed.load(Ordering::Relaxed) == u64::MAX {
                return true;
            }
            let first = pixels.iter().map(|&pixel| self.number(pixel)).min();
            first.is_some_and(|first| !self.is_beyond(first))
        };
        self.tracer.pixels(&pixels, &mut counts, wanted, |pixel, color| match color {
            Ok(color) => colors.push(color),
            Err(_) if !self.needed.contains(pixel.0, pixel.1) => colors.push(Color::splat(f64::NAN)),
            Err(error) => {
                let number = self.number(pixel);
                self.failed.fetch_min(number, Ordering::Relaxed);
                if failure.as_ref().is_none_or(|earlier| number < earlier.pixel) {
                    failure = Some(Failure { pixel: number, error: RenderError::at(pixel, error) });
                }
            }
        })?;
        if let Some(failure) = failure {
            return Some(Err(failure));
        }
        // some may have been left out, beyond a pixel of another tile
        (colors.len() == pixels.len()).then(|| {
            let bytes = colors.iter().map(|color| color.to_bytes()).collect();
            Ok(Done { size, pixels, colors, bytes, counts })
        })
    }

    /// Whether a pixel comes after one that has no colour.
    fn is_beyond(&self, number: u64) -> bool {
        number > self.failed.load(Ordering::Relaxed)
    }

    /// A pixel's number in row order within the region.
    fn number(&self, (x, y): (u32, u32)) -> u64 {
        u64::from(y - self.region.y) * u64::from(self.region.width) + u64::from(x - self.region.x)
    }
}
