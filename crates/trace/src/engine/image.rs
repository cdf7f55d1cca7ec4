//! The pixels of one picture: blocks of sixty-four primary rays, sample by sample.

use super::dispatch::{Backend, Simd, Step, enter};
use super::lanes::{Mask, Real};
use super::light::clamp01;
use super::media::Stacks;
use super::packet::{Block, Colors, NOTHING, PACKETS, Packet, PerPacket};
use super::path::{Path, Trace};
use super::vector::Vector;
use crate::precision::{lies_in_plane, lies_on_sphere};
use crate::world::{Geometry, Media};
use crate::{Camera, Cancel, RayCounts, RayKind, Settings, TraceError, World};
use lancer_scene::Rgb;
use std::borrow::Borrow;

/// Follows the rays of one picture of a world that it borrows or shares, many at a time.
#[derive(Clone, Debug)]
pub struct Engine<W> {
    world: W,
    camera: Camera,
    settings: Settings,
    cancel: Cancel,
    simd: Simd,
    /// The stack of every primary ray: the eye may be inside transparent objects.
    media_of_eye: Media,
    /// The spheres and planes that the eye lies on, ascending.
    eye_lies_on: Vec<u32>,
}

impl<W: Borrow<World>> Engine<W> {
    /// An engine for a camera's picture of a world. `simd` should be available; else the best that is takes its place.
    pub fn new(world: W, camera: &Camera, settings: Settings, cancel: &Cancel, simd: Simd) -> Engine<W> {
        let compiled: &World = world.borrow();
        let eye = camera.eye();
        let media_of_eye = Media::around(compiled, eye);
        let eye_lies_on = (0_u32..)
            .zip(compiled.bodies())
            .filter(|(_, body)| match &body.geometry {
                Geometry::Sphere { center, radius } => lies_on_sphere(eye, *center, *radius),
                Geometry::Plane { p0, p1, p2, .. } => lies_in_plane(eye, *p0, *p1, *p2),
                Geometry::Cone(cone) => cone.lies_on(eye),
                // of facets each is asked when it is hit
                Geometry::Facets(_) => false,
            })
            .map(|(number, _)| number)
            .collect();
        Engine { world, camera: *camera, settings, cancel: cancel.clone(), simd, media_of_eye, eye_lies_on }
    }

    /// The same engine, whose pixels may cost so many rays.
    #[must_use]
    pub fn with_budget(self, max_rays: u64) -> Engine<W> {
        Engine { settings: Settings { max_rays, ..self.settings }, ..self }
    }

    /// The colours of pixels, counted from the top left, in their order: of each the mean of its clamped samples in row
    /// order. Pixels that stand near each other should be near in the list.
    pub fn pixels(&self, pixels: &[(u32, u32)], colors: &mut Vec<Result<Rgb, TraceError>>, counts: &mut RayCounts) {
        let image = Image {
            world: self.world.borrow(),
            camera: &self.camera,
            settings: self.settings,
            cancel: &self.cancel,
            media_of_eye: &self.media_of_eye,
            eye_lies_on: &self.eye_lies_on,
        };
        colors.clear();
        colors.resize(pixels.len(), Err(TraceError::Cancelled));
        trace(self.simd, Pixels { image, pixels, colors, counts });
    }
}

/// Not generic, so that the backends are compiled here and once.
#[inline(never)]
fn trace(simd: Simd, pixels: Pixels<'_>) {
    enter(simd, pixels);
}

/// A picture without its backend.
#[derive(Debug)]
struct Image<'i> {
    world: &'i World,
    camera: &'i Camera,
    settings: Settings,
    cancel: &'i Cancel,
    media_of_eye: &'i Media,
    eye_lies_on: &'i [u32],
}

/// [`Image::pixels`].
struct Pixels<'p> {
    image: Image<'p>,
    pixels: &'p [(u32, u32)],
    colors: &'p mut [Result<Rgb, TraceError>],
    counts: &'p mut RayCounts,
}

impl<B: Backend> Step<B> for Pixels<'_> {
    #[inline(always)]
    fn run(self) {
        self.image.pixels::<B>(self.pixels, self.colors, self.counts);
    }
}

impl Image<'_> {
    #[inline(always)]
    fn pixels<B: Backend>(
        &self,
        pixels: &[(u32, u32)],
        colors: &mut [Result<Rgb, TraceError>],
        counts: &mut RayCounts,
    ) {
        let mut path = Path {
            world: self.world,
            settings: self.settings,
            cancel: self.cancel,
            eye_lies_on: self.eye_lies_on,
            stacks: Stacks::new(self.world, self.media_of_eye),
            counts: RayCounts::default(),
            rays: [[0.0; 8]; PACKETS],
            spent: [0; PACKETS],
            cancelled: false,
            blocks: 0,
        };
        for (pixels, colors) in pixels.chunks(8 * PACKETS).zip(colors.chunks_mut(8 * PACKETS)) {
            self.block::<B>(&mut path, pixels, colors);
        }
        *counts += path.counts;
    }

    /// At most sixty-four pixels.
    #[inline(always)]
    fn block<B: Backend>(&self, path: &mut Path<'_>, pixels: &[(u32, u32)], colors: &mut [Result<Rgb, TraceError>]) {
        path.rays = [[0.0; 8]; PACKETS];
        path.spent = [0; PACKETS];
        let zero = B::Real::splat(0.0);
        let packets = pixels.len().div_ceil(8);
        let mut sums: PerPacket<Colors<B>> = PerPacket::new();
        for _ in 0..packets {
            sums.push([zero; 3]);
        }
        // the pixels that are not numbers
        let mut not_finite = [0_u8; PACKETS];
        let samples = self.camera.samples();
        let mut seen = [[zero; 3]; PACKETS];
        for sample in 0..samples * samples {
            let mut block = Block::new(RayKind::Primary, 0, true);
            for (place, pixels) in pixels.chunks(8).enumerate() {
                let wanted = (0xff_u8 >> (8 - pixels.len())) & !not_finite[place] & !path.spent[place];
                block.packets.push(self.primary::<B>(pixels, sample, place, wanted, path.stacks.primary()));
            }
            B::enter(Trace { path, block: &mut block, colors: &mut seen });
            for (place, seen) in seen.iter().enumerate().take(packets) {
                let infinite = B::Real::splat(f64::INFINITY);
                let finite = seen[0].abs().lt(infinite) & seen[1].abs().lt(infinite) & seen[2].abs().lt(infinite);
                not_finite[place] |= !finite.bits() & block.packets[place].mask & !path.spent[place];
                for channel in 0..3 {
                    sums[place][channel] = sums[place][channel] + clamp01(seen[channel]);
                }
            }
        }
        let count = B::Real::splat(f64::from(samples * samples));
        for (place, colors) in colors.chunks_mut(8).enumerate() {
            let [r, g, b] = &sums[place];
            let (r, g, b) = ((*r / count).store(), (*g / count).store(), (*b / count).store());
            for (lane, color) in colors.iter_mut().enumerate() {
                let has = |mask: u8| mask >> lane & 1 == 1;
                *color = if path.cancelled {
                    Err(TraceError::Cancelled)
                } else if has(not_finite[place]) {
                    Err(TraceError::NotFinite)
                } else if has(path.spent[place]) {
                    Err(TraceError::Budget { limit: self.settings.max_rays })
                } else {
                    Ok(Rgb::new(r[lane], g[lane], b[lane]))
                };
            }
        }
    }

    /// The rays through one sample position of eight pixels.
    #[inline(always)]
    fn primary<B: Backend>(&self, pixels: &[(u32, u32)], sample: u32, place: usize, mask: u8, media: u32) -> Packet<B> {
        let k = self.camera.samples();
        let (row, column) = (sample / k, sample % k);
        let offset = |number: u32| (f64::from(number) + 0.5) / f64::from(k);
        let offset = (offset(column), offset(row));
        let (mut x, mut y) = ([0.5; 8], [0.5; 8]);
        for (lane, &(i, j)) in pixels.iter().enumerate() {
            x[lane] = f64::from(i) + offset.0;
            y[lane] = f64::from(j) + offset.1;
        }
        let x = B::Real::load(&x) / B::Real::splat(f64::from(self.camera.width()));
        let y = B::Real::load(&y) / B::Real::splat(f64::from(self.camera.height()));
        let (screen, eye) = (self.camera.screen(), Vector::splat(self.camera.eye()));
        let point = Vector::splat(screen.origin) + Vector::splat(screen.u) * x + Vector::splat(screen.v) * y;
        Packet {
            origin: eye,
            direction: (point - eye).normalize(),
            mask,
            channels: [mask; 3],
            place,
            start: [NOTHING; 8],
            media: [media; 8],
        }
    }
}
