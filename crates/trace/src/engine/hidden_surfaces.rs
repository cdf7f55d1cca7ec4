//! The nearest hits of a block of rays (subject §1.1).

use super::cone::NearestOnCone;
use super::dispatch::{Backend, Step};
use super::facets_nearest::OnFacets;
use super::few::{self, Aimed};
use super::intersect::{plane, sphere};
use super::lanes::{Lanes, Mask, Real, Single};
use super::packet::{Block, Hits, NOTHING, PACKETS, Packet, PerPacket};
use super::vector::{lanes, mask};
use crate::World;
use crate::bvh::{Beam, Follow, Shadow, Start, Visit};
use crate::world::Geometry;

/// In a hierarchy of more nodes a packet whose rays start at several points goes down by itself; else all boxes are tried
/// anyway, and packets keep together.
pub(super) const MANY_NODES: usize = 8;

/// An f32 that is not less than a distance.
pub(super) const UPWARDS: f32 = 1.0 + 1.0 / 4_194_304.0;

/// Finds what every ray meets first, leaving out the surface that it starts on.
pub(super) struct Nearest<'s, B: Backend> {
    pub(super) world: &'s World,
    /// The spheres, planes and cones that primary rays start on.
    pub(super) eye_lies_on: &'s [u32],
    pub(super) block: &'s Block<B>,
    /// One for each packet.
    pub(super) hits: &'s mut PerPacket<Hits<B>>,
}

impl<B: Backend> Step<B> for Nearest<'_, B> {
    #[inline(always)]
    fn run(self) {
        nearest(self.world, self.eye_lies_on, self.block, self.hits);
    }
}

#[inline(always)]
fn nearest<L: Backend>(world: &World, eye_lies_on: &[u32], block: &Block<L>, hits: &mut PerPacket<Hits<L>>) {
    let nowhere = Hits {
        t: L::Real::splat(f64::INFINITY),
        alpha: L::Real::splat(0.0),
        beta: L::Real::splat(0.0),
        body: [NOTHING; 8],
        facet: [0; 8],
    };
    hits.clear();
    for _ in &block.packets {
        hits.push(nowhere);
    }
    for &number in world.unbounded() {
        if let Geometry::Plane { p0, p1, p2, .. } = &world.body(number).geometry {
            let normal = (p1 - p0).cross(p2 - p0);
            for (packet, hits) in block.packets.iter().zip(hits.iter_mut()) {
                let tried = packet.mask & !packet.starts_on(number, eye_lies_on);
                if tried != 0 {
                    let (met, t) = plane::<L>(packet.origin, packet.direction, *p0, normal);
                    hits.take(met & tried, t, None, number, 0);
                }
            }
        }
    }
    if let Some(few) = world.few() {
        let mut aimed = Aimed::NONE;
        for (place, (packet, hits)) in block.packets.iter().zip(hits.iter()).enumerate() {
            if packet.mask != 0 {
                let start = few::Start::at(few, packet.origin);
                aimed.aim::<L>((few, few.all()), place, (&start, packet.direction), hits.t, packet.mask);
            }
        }
        for (&body, rays) in few.numbers().iter().zip(&aimed.lanes) {
            try_body(world, eye_lies_on, block, hits, body, rays);
        }
        return;
    }
    let (bvh, bodies) = world.bounded();
    let mut visitor = Bodies { world, bodies, eye_lies_on, block, hits };
    if !block.from_one_point && bvh.nodes().len() > MANY_NODES {
        let mut shadows: PerPacket<Shadow<L>> = PerPacket::new();
        for packet in &block.packets {
            let start = Start::new(bvh, bvh.margin(), packet.origin, packet.origin);
            shadows.push(Shadow::new(&start, packet.direction, packet.mask));
        }
        return bvh.follow(&shadows, every(block.packets.len()), &mut visitor);
    }
    #[allow(clippy::manual_map, reason = "closures are not compiled for a backend")]
    let eye = match block.eye() {
        Some(eye) => Some(Start::new(bvh, bvh.margin(), eye, eye)),
        None => None,
    };
    let mut beam = Beam::new(bvh, eye.is_some());
    for (packet, hits) in block.packets.iter().zip(visitor.hits.iter()) {
        let start = match &eye {
            Some(eye) => *eye,
            None => Start::new(bvh, bvh.margin(), packet.origin, packet.origin),
        };
        beam.push(Shadow::new(&start, packet.direction, packet.mask), hits.farthest(packet.mask));
    }
    beam.traverse(&mut visitor);
}

/// The first so many packets.
#[inline(always)]
fn every(packets: usize) -> u8 {
    (0xff_u32 >> (PACKETS - packets.min(PACKETS))) as u8
}

/// Tries a body with some rays of each packet.
#[inline(always)]
fn try_body<L: Backend>(
    world: &World,
    eye_lies_on: &[u32],
    block: &Block<L>,
    hits: &mut PerPacket<Hits<L>>,
    number: u32,
    rays: &[u8; PACKETS],
) {
    match &world.body(number).geometry {
        Geometry::Sphere { center, radius } => {
            for (place, packet) in block.packets.iter().enumerate() {
                if rays[place] != 0 {
                    let here = packet.starts_on(number, eye_lies_on);
                    let (met, t) = sphere::<L>(packet.origin, packet.direction, *center, *radius, here);
                    hits[place].take(met & rays[place], t, None, number, 0);
                }
            }
        }
        Geometry::Facets(facets) => {
            if *rays != [0; PACKETS] {
                L::enter(OnFacets { facets, body: number, block, hits, rays });
            }
        }
        Geometry::Cone(cone) => {
            if *rays != [0; PACKETS] {
                L::enter(NearestOnCone { cone, body: number, eye_lies_on, block, hits, rays });
            }
        }
        // planes have no bounds
        Geometry::Plane { .. } => {}
    }
}

impl<L: Lanes> Packet<L> {
    /// The lanes whose rays start on a body.
    #[inline(always)]
    pub(super) fn starts_on(&self, body: u32, eye_lies_on: &[u32]) -> u8 {
        let here = L::equal(&self.start, body);
        if eye_lies_on.is_empty() || eye_lies_on.binary_search(&body).is_err() {
            here
        } else {
            here | L::equal(&self.start, NOTHING)
        }
    }
}

impl<L: Lanes> Hits<L> {
    /// Takes the hits that precede what is known: nearer first; at equal distance document order, then facet order.
    #[inline(always)]
    pub(super) fn take(&mut self, met: u8, t: L::Real, shares: Option<(L::Real, L::Real)>, body: u32, facet: u32) {
        self.take_each(met, t, shares, body, &[facet; 8]);
    }

    /// The same, with a facet for each lane.
    #[inline(always)]
    pub(super) fn take_each(
        &mut self,
        met: u8,
        t: L::Real,
        shares: Option<(L::Real, L::Real)>,
        body: u32,
        facets: &[u32; 8],
    ) {
        let mut taken = met & t.lt(self.t).bits();
        for lane in lanes(met & t.eq(self.t).bits()) {
            taken |= u8::from((body, facets[lane]) < (self.body[lane], self.facet[lane])) << lane;
        }
        if taken == 0 {
            return;
        }
        let chosen = mask::<L::Real>(taken);
        self.t = L::Real::select(chosen, t, self.t);
        if let Some((alpha, beta)) = shares {
            self.alpha = L::Real::select(chosen, alpha, self.alpha);
            self.beta = L::Real::select(chosen, beta, self.beta);
        }
        for lane in 0..8 {
            let new = taken >> lane & 1 == 1;
            self.body[lane] = if new { body } else { self.body[lane] };
            self.facet[lane] = if new { facets[lane] } else { self.facet[lane] };
        }
    }

    /// An f32 bound of the distance of each lane.
    #[inline(always)]
    pub(super) fn limits(&self) -> L::Single {
        L::narrow(self.t) * L::Single::splat(UPWARDS)
    }

    /// An f32 bound of the distances of some lanes.
    #[inline(always)]
    pub(super) fn farthest(&self, lanes: u8) -> f32 {
        let wanted = <L::Single as Single>::Mask::from_bits(lanes);
        L::Single::select(wanted, L::narrow(self.t), L::Single::splat(0.0)).greatest() * UPWARDS
    }
}

/// Tries the bodies of leaves.
struct Bodies<'v, L: Lanes> {
    world: &'v World,
    bodies: &'v [u32],
    eye_lies_on: &'v [u32],
    block: &'v Block<L>,
    hits: &'v mut PerPacket<Hits<L>>,
}

impl<L: Backend> Visit<L> for Bodies<'_, L> {
    #[inline(always)]
    fn limit(&self, packet: usize, lanes: u8) -> f32 {
        self.hits[packet].farthest(lanes)
    }

    #[inline(always)]
    fn leaf(&mut self, beam: &mut Beam<'_, L>, first: u32, count: u32, packets: u8) {
        let mut rays = [0; PACKETS];
        for place in lanes(packets) {
            rays[place] = beam.packets[place].mask;
        }
        for &number in &self.bodies[first as usize..(first + count) as usize] {
            try_body(self.world, self.eye_lies_on, self.block, self.hits, number, &rays);
        }
        for place in lanes(packets) {
            beam.shorten(place, self.hits[place].farthest(rays[place]));
        }
    }
}

impl<L: Backend> Follow<L> for Bodies<'_, L> {
    #[inline(always)]
    fn limits(&self, packet: usize) -> [f32; 8] {
        self.hits[packet].limits().store()
    }

    #[inline(always)]
    fn leaf(&mut self, packet: usize, rays: u8, (first, count): (u32, u32), limits: &mut [f32; 8]) {
        let mut asked = [0; PACKETS];
        asked[packet] = rays;
        for &number in &self.bodies[first as usize..(first + count) as usize] {
            try_body(self.world, self.eye_lies_on, self.block, self.hits, number, &asked);
        }
        *limits = self.hits[packet].limits().store();
    }

    #[inline(always)]
    fn soon(&self, first: u32) {
        if let Some(&number) = self.bodies.get(first as usize) {
            L::prefetch(self.world.body(number));
        }
    }
}

const _: () = assert!(PACKETS == 8, "sets of packets are bytes");
