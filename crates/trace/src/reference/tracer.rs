//! The recursion: a ray's colour is the sum of the terms of the point that it sees, and two of them are again rays.

use super::bounce::{keep_outside, reflect, refract};
use super::compose::Sum;
use super::light;
use super::surface_point::{Crossing, SurfacePoint};
use crate::observe::{GlassPath, GlassTerm, LampState, LampTerm, MirrorTerm, Observer, Omitted, SeenRay, SeenSurface};
use crate::precision::roundings;
use crate::world::{Media, World};
use crate::{Camera, Cancel, Channels, Ray, RayKind, Settings};
use glam::DVec3;
use lancer_scene::{Name, Rgb, Surface};
use std::borrow::Borrow;

/// Why a pixel has no colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TraceError {
    /// The end was asked for.
    #[error("cancelled")]
    Cancelled,
    /// The pixel costs more rays than its budget.
    #[error("the pixel needs more than {limit} rays")]
    Budget {
        /// The budget.
        limit: u64,
    },
    /// The colour is not a number.
    #[error("the colour is not a number")]
    NotFinite,
}

/// How many rays pass between two looks at the cancel flag.
const POLL: u64 = 1024;

/// Follows the rays of one picture of a world that it borrows or shares.
#[derive(Clone, Debug)]
pub struct Tracer<W> {
    world: W,
    camera: Camera,
    settings: Settings,
    cancel: Cancel,
    /// The stack of every primary ray: the eye may be inside transparent objects.
    media_of_eye: Media,
}

impl<W: Borrow<World>> Tracer<W> {
    /// A tracer of a camera's picture of a world.
    pub fn new(world: W, camera: &Camera, settings: Settings, cancel: &Cancel) -> Tracer<W> {
        let media_of_eye = Media::around(world.borrow(), camera.eye());
        Tracer { world, camera: *camera, settings, cancel: cancel.clone(), media_of_eye }
    }

    /// The colour of pixel `(i, j)`, counted from the top left: the mean of its clamped samples in row order.
    ///
    /// # Errors
    /// If the pixel's rays exceed the budget, its colour is not a number, or the end was asked for.
    pub fn pixel(&self, i: u32, j: u32, observer: &mut impl Observer) -> Result<Rgb, TraceError> {
        let mut path = self.path(observer);
        let mut sum = Rgb::BLACK;
        let mut samples = 0.0;
        for (x, y) in self.camera.sample_positions(i, j) {
            sum = sum + path.primary(x, y)?;
            samples += 1.0;
        }
        Ok(sum.map(|channel| channel / samples))
    }

    /// The clamped colour seen at `x` pixels from the left and `y` from the top.
    ///
    /// # Errors
    /// As [`Tracer::pixel`].
    pub fn sample(&self, x: f64, y: f64, observer: &mut impl Observer) -> Result<Rgb, TraceError> {
        self.path(observer).primary(x, y)
    }

    fn path<'t, O: Observer>(&'t self, observer: &'t mut O) -> Path<'t, O> {
        Path {
            world: self.world.borrow(),
            camera: &self.camera,
            settings: self.settings,
            cancel: &self.cancel,
            media_of_eye: &self.media_of_eye,
            observer,
            rays: 0,
        }
    }
}

/// The rays of one pixel.
struct Path<'t, O> {
    world: &'t World,
    camera: &'t Camera,
    settings: Settings,
    cancel: &'t Cancel,
    media_of_eye: &'t Media,
    observer: &'t mut O,
    rays: u64,
}

/// A ray and what it carries along.
struct Traveller<'m> {
    ray: Ray,
    kind: RayKind,
    level: u32,
    channels: Channels,
    media: &'m Media,
    /// The body that the ray starts on.
    start: Option<u32>,
}

impl<'t, O: Observer> Path<'t, O> {
    fn primary(&mut self, x: f64, y: f64) -> Result<Rgb, TraceError> {
        let (ray, media) = (self.camera.ray(x, y), self.media_of_eye);
        let color = self.color(&Traveller {
            ray,
            kind: RayKind::Primary,
            level: 0,
            channels: Channels::ALL,
            media,
            start: None,
        })?;
        if color.is_finite() { Ok(color.clamp01()) } else { Err(TraceError::NotFinite) }
    }

    /// Counts a ray against the pixel's budget.
    fn spend(&mut self) -> Result<(), TraceError> {
        let limit = self.settings.max_rays;
        if self.rays >= limit {
            return Err(TraceError::Budget { limit });
        }
        self.rays += 1;
        if self.rays.is_multiple_of(POLL) && self.cancel.is_cancelled() {
            return Err(TraceError::Cancelled);
        }
        Ok(())
    }

    /// The names of a stack's objects, which only an explanation needs.
    fn names_of(&self, media: &Media) -> Vec<Name> {
        let world = self.world;
        if O::EXPLAINS { media.bodies().map(|body| world.body(body).name.clone()).collect() } else { Vec::new() }
    }

    /// The colour that a ray sees, in its channels.
    fn color(&mut self, traveller: &Traveller<'_>) -> Result<Rgb, TraceError> {
        self.spend()?;
        let world = self.world;
        self.observer.enter(&SeenRay {
            kind: traveller.kind,
            level: traveller.level,
            channels: traveller.channels,
            ray: traveller.ray,
            index: traveller.media.index(world),
            media: &self.names_of(traveller.media),
        });
        let color = match world.nearest(&traveller.ray, traveller.start) {
            None => {
                let background = world.environment().background;
                self.observer.background(background);
                background
            }
            Some(hit) => {
                let at = world.surface_point(&traveller.ray, &hit);
                self.observer.surface(&SeenSurface {
                    level: traveller.level,
                    object: &world.body(hit.body).name,
                    facet: hit.facet,
                    distance: hit.t,
                    point: at.point,
                    geometric_normal: at.geometric,
                    normal: at.normal,
                    entering: at.crossing == Crossing::Enters,
                    sheet: at.crossing == Crossing::Sheet,
                    surface: world.surface(at.surface),
                });
                self.surface_color(traveller, &at)?
            }
        };
        let mut seen = Rgb::BLACK;
        traveller.channels.iter().for_each(|channel| seen[channel] = color[channel]);
        self.observer.leave(seen);
        Ok(seen)
    }

    /// `E = Ka·Ia ⊕ Kr·Ir ⊕ Kt·It ⊕ lamps` (subject §2.6).
    fn surface_color(&mut self, traveller: &Traveller<'_>, at: &SurfacePoint) -> Result<Rgb, TraceError> {
        let world = self.world;
        let environment = world.environment();
        let surface = world.surface(at.surface);
        let mut sum = Sum::new(environment.compose);

        let ambient = light::ambient(surface.ka, environment.ambient);
        sum.add(ambient);
        self.observer.ambient(surface.ka, environment.ambient, ambient, sum.so_far());

        let (mirror, glass) = self.secondary(traveller, at, surface)?;
        sum.add(mirror.value);
        self.observer.mirror(&mirror, sum.so_far());
        sum.add(glass.value);
        self.observer.glass(&glass, sum.so_far());

        for number in 0..world.lamps().len() {
            let term = self.lamp(traveller, at, surface, number)?;
            if let LampState::Lit(lit) = &term.state {
                sum.add_lamp(lit.diffuse, lit.highlight);
            }
            self.observer.lamp(&term, sum.so_far());
        }
        Ok(sum.color())
    }

    /// The mirror and the glass term, `Kr·Ir` and `Kt·It`.
    fn secondary(
        &mut self,
        traveller: &Traveller<'_>,
        at: &SurfacePoint,
        surface: &Surface,
    ) -> Result<(MirrorTerm, GlassTerm), TraceError> {
        let Settings { depth, steps, .. } = self.settings;
        let mut mirror = MirrorTerm::none(surface.kr);
        let mut glass = GlassTerm::none(surface.kt);
        let mirrored = traveller.channels.where_positive(surface.kr);
        let refracted = traveller.channels.where_positive(surface.kt);
        mirror.omitted = omitted(mirrored, traveller.level >= depth, steps.reflection);
        glass.omitted = omitted(refracted, traveller.level >= depth, steps.transparency);

        let direction = traveller.ray.direction;
        let mut ways = Vec::new();
        let mut beyond = None;
        if glass.omitted.is_none() {
            let media = self.media_beyond(traveller, at, surface);
            ways = self.ways(traveller, at, refracted, media.as_ref().unwrap_or(traveller.media));
            beyond = media;
        }
        glass.paths = ways.iter().map(|way| way.path).collect();

        // one ray along R serves the mirror and every channel that is totally reflected
        let total: Channels =
            ways.iter().filter(|way| way.direction.is_none()).flat_map(|way| way.path.channels.iter()).collect();
        let for_mirror = if mirror.omitted.is_none() { mirrored } else { Channels::NONE };
        let along_r = for_mirror.union(total);
        if !along_r.is_empty() {
            let r = keep_outside(reflect(direction, at.normal), at.geometric);
            let seen = self.onward(traveller, at, RayKind::Reflected, r, along_r, traveller.media)?;
            for_mirror.iter().for_each(|channel| mirror.ir[channel] = seen[channel]);
            total.iter().for_each(|channel| glass.it[channel] = seen[channel]);
        }
        for way in ways {
            if let Some(t) = way.direction {
                let media = beyond.as_ref().unwrap_or(traveller.media);
                let seen = self.onward(traveller, at, RayKind::Refracted, t, way.path.channels, media)?;
                way.path.channels.iter().for_each(|channel| glass.it[channel] = seen[channel]);
            }
        }
        mirror.value = surface.kr * mirror.ir;
        glass.value = surface.kt * glass.it;
        Ok((mirror, glass))
    }

    /// The stack of a ray that passes through the surface; `None` where it does not change.
    fn media_beyond(&self, traveller: &Traveller<'_>, at: &SurfacePoint, surface: &Surface) -> Option<Media> {
        match at.crossing {
            Crossing::Enters => Some(traveller.media.entered(at.body, surface.index)),
            Crossing::Leaves => Some(traveller.media.left(at.body)),
            Crossing::Sheet => None,
        }
    }

    /// Where the refracted channels go: channels with equal `n/n'` share a way.
    fn ways(&self, traveller: &Traveller<'_>, at: &SurfacePoint, channels: Channels, beyond: &Media) -> Vec<Way> {
        let world = self.world;
        let (n, n_prime) = (traveller.media.index(world), beyond.index(world));
        let sheet = at.crossing == Crossing::Sheet;
        let mut ways: Vec<Way> = Vec::with_capacity(1);
        for channel in channels.iter() {
            let (n, n_prime) = (n[channel], n_prime[channel]);
            match ways.iter_mut().find(|way| sheet || way.path.n / way.path.n_prime == n / n_prime) {
                Some(way) => way.path.channels.insert(channel),
                None => {
                    let incident = traveller.ray.direction;
                    let direction = if sheet { Some(incident) } else { refract(incident, at.geometric, n, n_prime) };
                    let channels = [channel].into_iter().collect();
                    let path = GlassPath { channels, n, n_prime, total_reflection: direction.is_none() };
                    ways.push(Way { path, direction });
                }
            }
        }
        ways
    }

    /// What a ray that leaves the point sees.
    fn onward(
        &mut self,
        from: &Traveller<'_>,
        at: &SurfacePoint,
        kind: RayKind,
        direction: DVec3,
        channels: Channels,
        media: &Media,
    ) -> Result<Rgb, TraceError> {
        let ray = Ray { origin: at.point, direction: direction.normalize() };
        self.color(&Traveller { ray, kind, level: from.level + 1, channels, media, start: Some(at.body) })
    }

    /// What a lamp gives to the point (subject §1.2, §2.2, §2.3).
    fn lamp(
        &mut self,
        traveller: &Traveller<'_>,
        at: &SurfacePoint,
        surface: &Surface,
        number: usize,
    ) -> Result<LampTerm<'t>, TraceError> {
        let world = self.world;
        let lamp = &world.lamps()[number];
        let segment = lamp.position - at.point;
        let distance = segment.length();
        let to_lamp = segment / distance;
        let state = if distance == 0.0 {
            LampState::AtPoint
        } else if !(at.geometric.dot(segment) > roundings(&[at.point, lamp.position]) && at.normal.dot(to_lamp) > 0.0) {
            // a lamp in the surface's own plane is not in front of it, however N·L rounds
            LampState::Behind { cos_l: at.normal.dot(to_lamp) }
        } else {
            let mut blocker = None;
            if self.settings.steps.shadows {
                self.spend()?;
                self.observer.shadow_ray();
                let ray = Ray { origin: at.point, direction: to_lamp };
                blocker = world.blocker(&ray, Some(at.body), lamp.position, distance);
            }
            match blocker {
                Some(body) => LampState::Blocked { by: &world.body(body).name, cos_l: at.normal.dot(to_lamp) },
                None => LampState::Lit(light::lamp(surface, at.normal, to_lamp, -traveller.ray.direction, lamp.color)),
            }
        };
        Ok(LampTerm { name: &lamp.name, color: lamp.color, distance, to_lamp, state })
    }
}

/// A way that refracted light goes: its channels and indices, and where to, unless it is totally reflected.
struct Way {
    path: GlassPath,
    direction: Option<DVec3>,
}

/// Why a term is 0 without a ray.
fn omitted(channels: Channels, too_deep: bool, carried_out: bool) -> Option<Omitted> {
    if channels.is_empty() {
        Some(Omitted::NoCoefficient)
    } else if !carried_out {
        Some(Omitted::StepLeftOut)
    } else if too_deep {
        Some(Omitted::DepthReached)
    } else {
        None
    }
}
