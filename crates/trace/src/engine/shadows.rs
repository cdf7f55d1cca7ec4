//! Whether anything stands between points and a lamp (subject §1.2), for a block of points at once.
//!
//! Boxes are culled for rays from the lamp: they have their start in common, so a beam of them is narrow where it begins.
//! What is left is decided for the rays from the points, as the reference does.

use super::cone::BlockedByCone;
use super::dispatch::{Backend, Step};
use super::facets_blocking::OnFacets;
use super::few::{Aimed, Hull, Start};
use super::hidden_surfaces::{MANY_NODES, UPWARDS};
use super::intersect::{plane, sphere};
use super::lanes::{Lanes, Mask, Real, Single};
use super::packet::{PACKETS, Packet, PerPacket};
use super::vector::{Vector, lanes};
use crate::World;
use crate::bvh::{self, Beam, Follow, Shadow, Visit};
use crate::precision::{lies_in_plane, lies_on_sphere};
use crate::world::Geometry;
use glam::DVec3;

/// Rays from points to a lamp: `packet.mask` are the points that ask.
#[derive(Clone, Copy)]
pub(super) struct ToLamp<L: Lanes> {
    pub(super) packet: Packet<L>,
    pub(super) distance: L::Real,
    /// The points in f32, in a world of few bodies.
    start: Start<L>,
}

impl<L: Lanes> ToLamp<L> {
    /// No rays.
    #[inline(always)]
    pub(super) fn none() -> ToLamp<L> {
        ToLamp { packet: Packet::none(), distance: L::Real::splat(0.0), start: Start::none() }
    }

    /// Starts at points of bodies, to look for lamps from there.
    #[inline(always)]
    pub(super) fn start_at(&mut self, world: &World, points: Vector<L::Real>, bodies: &[u32; 8]) {
        (self.packet.origin, self.packet.start) = (points, *bodies);
        if let Some(few) = world.few() {
            self.start = Start::at(few, points);
        }
    }
}

/// The rays from points to one lamp.
#[derive(Clone, Copy)]
pub(super) struct Segments<'s, L: Lanes> {
    pub(super) lamp: DVec3,
    /// At most [`PACKETS`].
    pub(super) rays: &'s [ToLamp<L>],
    /// Whether the points are what neighbouring pixels see from one point: then a beam from the lamp is narrow.
    pub(super) of_neighbours: bool,
}

/// Finds the lanes of each packet whose rays meet a body before the lamp.
pub(super) struct Blocked<'s, B: Backend> {
    pub(super) world: &'s World,
    pub(super) segments: Segments<'s, B>,
    /// What is found.
    pub(super) blocked: &'s mut [u8; PACKETS],
}

impl<B: Backend> Step<B> for Blocked<'_, B> {
    #[inline(always)]
    fn run(self) {
        blocked(self.world, self.segments, self.blocked);
    }
}

#[inline(always)]
fn blocked<L: Backend>(world: &World, segments: Segments<'_, L>, blocked: &mut [u8; PACKETS]) {
    let Segments { lamp, rays, of_neighbours } = segments;
    *blocked = [0; PACKETS];
    for &number in world.unbounded() {
        if let Geometry::Plane { p0, p1, p2, .. } = &world.body(number).geometry {
            if lies_in_plane(lamp, *p0, *p1, *p2) {
                continue;
            }
            let normal = (p1 - p0).cross(p2 - p0);
            for (ray, blocked) in rays.iter().zip(blocked.iter_mut()) {
                if ray.packet.mask & !*blocked == 0 {
                    continue;
                }
                let tried = ray.packet.mask & !*blocked & !ray.packet.starts_on(number, &[]);
                if tried != 0 {
                    let (met, t) = plane::<L>(ray.packet.origin, ray.packet.direction, *p0, normal);
                    *blocked |= met & tried & t.lt(ray.distance).bits();
                }
            }
        }
    }
    if let Some(few) = world.few() {
        let mut hull = Hull::empty();
        for (ray, blocked) in rays.iter().zip(blocked.iter()) {
            hull.add(&ray.start, ray.packet.mask & !blocked);
        }
        let between = hull.between(few, lamp);
        if between == 0 {
            return;
        }
        let mut aimed = Aimed::NONE;
        for (place, (ray, blocked)) in rays.iter().zip(blocked.iter()).enumerate() {
            let open = ray.packet.mask & !blocked;
            if open != 0 {
                aimed.aim::<L>((few, between), place, (&ray.start, ray.packet.direction), ray.distance, open);
            }
        }
        for (&body, asked) in few.numbers().iter().zip(&aimed.lanes) {
            try_body(world, segments, blocked, body, asked);
        }
        return;
    }
    let (bvh, bodies) = world.bounded();
    if bvh.nodes().len() > MANY_NODES && !of_neighbours {
        let mut shadows: PerPacket<Shadow<L>> = PerPacket::new();
        let mut packets = 0;
        for (place, (ToLamp { packet, .. }, blocked)) in rays.iter().zip(blocked.iter()).enumerate() {
            let open = packet.mask & !blocked;
            packets |= u8::from(open != 0) << place;
            let start = bvh::Start::new(bvh, bvh.margin(), packet.origin, packet.origin);
            shadows.push(Shadow::new(&start, packet.direction, open));
        }
        return bvh.follow(&shadows, packets, &mut Bodies { world, bodies, segments, blocked });
    }
    let mut beam = Beam::new(bvh, true);
    let from_lamp = bvh::Start::new(bvh, bvh.margin(), Vector::splat(lamp), Vector::splat(lamp));
    for (ray, blocked) in rays.iter().zip(blocked.iter()) {
        let open = ray.packet.mask & !blocked;
        beam.push(Shadow::new(&from_lamp, -ray.packet.direction, open), ray.farthest(open));
    }
    beam.traverse(&mut Bodies { world, bodies, segments, blocked });
}

/// Tries a body with some rays of each packet.
#[inline(always)]
fn try_body<L: Backend>(
    world: &World,
    segments: Segments<'_, L>,
    blocked: &mut [u8; PACKETS],
    number: u32,
    asked: &[u8; PACKETS],
) {
    let Segments { lamp, rays, .. } = segments;
    match &world.body(number).geometry {
        Geometry::Sphere { center, radius } => {
            for (place, ToLamp { packet, distance, .. }) in rays.iter().enumerate() {
                let open = asked[place] & !blocked[place];
                if open == 0 {
                    continue;
                }
                let here = packet.starts_on(number, &[]);
                let (met, t) = sphere::<L>(packet.origin, packet.direction, *center, *radius, here);
                let mut met = met & open & t.lt(*distance).bits();
                if met != 0 && lies_on_sphere(lamp, *center, *radius) {
                    // the lamp's own place on the sphere is no hit: which of the two is nearer?
                    let between = packet.direction.dot(Vector::splat(*center - lamp)).abs();
                    met &= !(*distance - t).le(between).bits();
                }
                blocked[place] |= met;
            }
        }
        Geometry::Facets(facets) => {
            if *asked != [0; PACKETS] {
                L::enter(OnFacets { facets, body: number, segments, blocked, asked });
            }
        }
        Geometry::Cone(cone) => {
            if *asked != [0; PACKETS] {
                L::enter(BlockedByCone { cone, body: number, segments, blocked, asked });
            }
        }
        // planes have no bounds
        Geometry::Plane { .. } => {}
    }
}

impl<L: Lanes> ToLamp<L> {
    /// How far some rays look: no more if there are none.
    #[inline(always)]
    pub(super) fn limit(&self, lanes: u8) -> f32 {
        if lanes == 0 { -1.0 } else { self.farthest(lanes) }
    }

    /// An f32 bound of the distances of some lanes.
    #[inline(always)]
    fn farthest(&self, lanes: u8) -> f32 {
        let wanted = <L::Single as Single>::Mask::from_bits(lanes);
        L::Single::select(wanted, L::narrow(self.distance), L::Single::splat(0.0)).greatest() * UPWARDS
    }
}

/// Tries the bodies of leaves.
struct Bodies<'v, L: Lanes> {
    world: &'v World,
    bodies: &'v [u32],
    segments: Segments<'v, L>,
    blocked: &'v mut [u8; PACKETS],
}

impl<L: Backend> Visit<L> for Bodies<'_, L> {
    #[inline(always)]
    fn limit(&self, packet: usize, lanes: u8) -> f32 {
        self.segments.rays[packet].limit(lanes & !self.blocked[packet])
    }

    #[inline(always)]
    fn leaf(&mut self, beam: &mut Beam<'_, L>, first: u32, count: u32, packets: u8) {
        let mut asked = [0; PACKETS];
        for place in lanes(packets) {
            asked[place] = beam.packets[place].mask;
        }
        for &number in &self.bodies[first as usize..(first + count) as usize] {
            try_body(self.world, self.segments, self.blocked, number, &asked);
        }
        for place in lanes(packets) {
            beam.shorten(place, self.limit(place, asked[place]));
        }
    }
}

impl<L: Backend> Follow<L> for Bodies<'_, L> {
    #[inline(always)]
    fn limits(&self, packet: usize) -> [f32; 8] {
        (L::narrow(self.segments.rays[packet].distance) * L::Single::splat(UPWARDS)).store()
    }

    #[inline(always)]
    fn leaf(&mut self, packet: usize, rays: u8, (first, count): (u32, u32), limits: &mut [f32; 8]) {
        let mut asked = [0; PACKETS];
        asked[packet] = rays;
        for &number in &self.bodies[first as usize..(first + count) as usize] {
            try_body(self.world, self.segments, self.blocked, number, &asked);
        }
        for lane in lanes(rays & self.blocked[packet]) {
            limits[lane] = -1.0;
        }
    }

    #[inline(always)]
    fn soon(&self, first: u32) {
        if let Some(&number) = self.bodies.get(first as usize) {
            L::prefetch(self.world.body(number));
        }
    }
}
