//! One picture from beginning to end: what the command line renders.
//!
//! The work is handed out tile by tile, from the top left, to the threads of a pool of its own; they send finished
//! tiles to the calling thread, which alone touches the film.

use crate::tile::tile;
use crate::{Film, Region, RenderError, Tile};
use lancer_scene::{Color, Picture, View};
use lancer_trace::{Camera, Cancel, RayCounts, Settings, Tracer, World};
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc;

/// How a picture is rendered; nothing here changes the bytes of a pixel.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RenderOptions {
    /// How many threads compute; `None`: as many as the machine offers.
    pub threads: Option<NonZeroUsize>,
    /// The part of the view that is rendered; `None`: all of it. The picture has the part's size.
    pub region: Option<Region>,
    /// How many rays a pixel may cost; `None`: [`Settings::MAX_RAYS`].
    pub max_rays: Option<u64>,
    /// Whether the picture keeps the linear colours beside the bytes.
    pub keep_linear: bool,
}

/// A finished picture and what it cost.
#[derive(Clone, Debug)]
pub struct Still {
    /// The picture.
    pub picture: Picture,
    /// The rays that were cast, by kind.
    pub counts: RayCounts,
    /// How many threads computed.
    pub threads: usize,
}

/// Renders a view.
///
/// `progress` is called on this thread with the pixels that are done and all pixels, in rising order.
///
/// # Errors
/// Anything of [`RenderError`]. Where several pixels have no colour, the first in row order is named, whatever the
/// number of threads.
pub fn render_still(
    world: &World,
    view: &View,
    options: &RenderOptions,
    cancel: &Cancel,
    mut progress: impl FnMut(u64, u64),
) -> Result<Still, RenderError> {
    let camera = Camera::new(view)?;
    let mut settings = Settings::of(world, view);
    settings.max_rays = options.max_rays.unwrap_or(settings.max_rays);
    let region = options.region.unwrap_or(Region::whole(view.width, view.height));
    if !region.lies_within(view.width, view.height) {
        return Err(RenderError::Region { region, width: view.width, height: view.height });
    }
    let mut film = Film::new(region.width, region.height, options.keep_linear)?;
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(options.threads.map_or_else(available_threads, NonZeroUsize::get))
        .thread_name(|number| format!("tile {number}"))
        .build()
        .map_err(|error| RenderError::Threads { reason: error.to_string() })?;

    let tracer = Tracer::new(world, &camera, settings, cancel);
    let job = Job { tracer, region, cancel, failed: AtomicU64::new(u64::MAX) };
    let next = AtomicU64::new(0);
    let (sender, finished) = mpsc::sync_channel::<Result<Done, Failure>>(2 * pool.current_num_threads());
    let (mut counts, mut pixels, mut failure) = (RayCounts::default(), 0, None::<Failure>);
    pool.in_place_scope(|scope| {
        for _ in 0..pool.current_num_threads() {
            let (sender, job, next) = (sender.clone(), &job, &next);
            scope.spawn(move |_| {
                while let Some(tile) = tile(region.width, region.height, next.fetch_add(1, Ordering::Relaxed)) {
                    let Some(outcome) = job.trace(tile) else { break };
                    if sender.send(outcome).is_err() {
                        break;
                    }
                }
            });
        }
        drop(sender);
        for outcome in finished {
            match outcome {
                Ok(done) => {
                    film.place(done.tile, &done.colors);
                    counts += done.counts;
                    pixels += done.colors.len() as u64;
                    progress(pixels, region.pixels());
                }
                Err(found) => {
                    failure = Some(match failure.take() {
                        Some(earlier) if earlier.pixel <= found.pixel => earlier,
                        Some(_) | None => found,
                    });
                }
            }
        }
    });
    if cancel.is_cancelled() {
        return Err(RenderError::Cancelled);
    }
    match failure {
        Some(failure) => Err(failure.error),
        None => Ok(Still { picture: film.into_picture(), counts, threads: pool.current_num_threads() }),
    }
}

/// As many threads as the machine offers to this program.
fn available_threads() -> usize {
    std::thread::available_parallelism().map_or(1, NonZeroUsize::get)
}

/// What all threads share while a picture is computed.
struct Job<'a> {
    tracer: Tracer<&'a World>,
    region: Region,
    cancel: &'a Cancel,
    /// The number, in row order, of the first pixel known to have no colour. Nothing after it is computed any more,
    /// everything before it is: that makes the reported pixel the same for every number of threads.
    failed: AtomicU64,
}

/// A finished tile.
struct Done {
    tile: Tile,
    colors: Vec<Color>,
    counts: RayCounts,
}

/// A pixel without a colour.
struct Failure {
    /// Its number in row order within the region.
    pixel: u64,
    error: RenderError,
}

impl Job<'_> {
    /// The colours of a tile; `None` if it lies behind a failed pixel or the end was asked for, so that it and all later
    /// ones are not wanted.
    fn trace(&self, tile: Tile) -> Option<Result<Done, Failure>> {
        let number = |(x, y)| u64::from(y) * u64::from(self.region.width) + u64::from(x);
        // the tracer itself looks at the flag only within a pixel of many rays
        let unwanted = |pixel| self.cancel.is_cancelled() || number(pixel) > self.failed.load(Ordering::Relaxed);
        if unwanted((tile.x, tile.y)) {
            return None;
        }
        let mut counts = RayCounts::default();
        let mut colors = Vec::with_capacity((tile.width * tile.height) as usize);
        for (x, y) in tile.pixels() {
            if unwanted((x, y)) {
                // the tile stays unfinished; no picture comes of it
                break;
            }
            let place = (self.region.x + x, self.region.y + y);
            match self.tracer.pixel(place.0, place.1, &mut counts) {
                Ok(color) => colors.push(color),
                Err(error) => {
                    let pixel = number((x, y));
                    self.failed.fetch_min(pixel, Ordering::Relaxed);
                    return Some(Err(Failure { pixel, error: RenderError::at(place, error) }));
                }
            }
        }
        Some(Ok(Done { tile, colors, counts }))
    }
}
