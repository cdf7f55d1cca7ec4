//! One picture from beginning to end: what the command line renders.

use crate::adaptive::Centres;
use crate::film::Film;
use crate::tracing::PixelTracer;
use crate::work::{Done, Work};
use crate::{Region, RenderError, Tracing};
use lancer_scene::{Picture, View};
use lancer_trace::{Camera, Cancel, RayCounts, Settings, World};
use std::num::NonZeroUsize;

/// How a picture is rendered. But for `adaptive`, nothing here changes the bytes of a pixel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RenderOptions {
    /// What follows the rays.
    pub tracing: Tracing,
    /// How many threads compute; `None`: as many as the machine offers.
    pub threads: Option<NonZeroUsize>,
    /// The part of the view that is rendered; `None`: all of it. The picture has the part's size.
    pub region: Option<Region>,
    /// How many rays a pixel may cost; `None`: [`Settings::MAX_RAYS`].
    pub max_rays: Option<u64>,
    /// The view's samples are taken only of pixels whose colour at the centre differs from that of one of the eight
    /// pixels around by more than this, in some channel, 0..=1; the others keep the colour at their centre. The ray
    /// through the centre and the samples are counted apart against the budget. `None`: of every pixel.
    pub adaptive: Option<f64>,
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
    /// How many pixels got all samples, where that was left to the differences between pixels.
    pub refined: Option<u64>,
}

/// Renders a view.
///
/// `progress` is called on this thread with the pixels that are done and all pixels, in rising order. Where samples are
/// adaptive, a pixel counts twice: when its centre is known, and when it needs no more.
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
    let threads = options.threads.or_else(|| std::thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get);
    let tracer = |camera: &Camera| PixelTracer::new(options.tracing, world, camera, settings, cancel);
    let mut film = Film::new(region, options.keep_linear)?;
    let (mut counts, mut pixels) = (RayCounts::default(), 0);
    let mut take = |done: &Done, all: u64| {
        film.place(done);
        counts += done.counts;
        pixels += done.size;
        progress(pixels, all);
    };
    // one sample is the one at the centre
    let refined = match options.adaptive.filter(|_| view.samples > 1) {
        None => {
            let work = Work::new(tracer(&camera), region, |_, _| true, cancel);
            work.carry_out(threads, |done| take(&done, region.pixels()))?;
            options.adaptive.map(|_| 0)
        }
        Some(threshold) => {
            let around = region.with_margin(view.width, view.height);
            let all = around.pixels() + region.pixels();
            let mut centres = Centres::new(around)?;
            let of_centres = Camera::new(&View { samples: 1, ..view.clone() })?;
            // a region's picture does not fail because of a pixel that is not in it
            let work = Work::new(tracer(&of_centres), around, |_, _| true, cancel).needing(region);
            work.carry_out(threads, |done| {
                take(&done, all);
                centres.take(&done);
            })?;
            let mut refined = 0;
            let work = Work::new(tracer(&camera), region, |x, y| centres.differs(x, y, threshold), cancel);
            work.carry_out(threads, |done| {
                take(&done, all);
                refined += done.pixels.len() as u64;
            })?;
            Some(refined)
        }
    };
    Ok(Still { picture: film.into_picture(), counts, threads, refined })
}
