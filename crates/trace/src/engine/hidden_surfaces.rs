//! The nearest hits of a block of rays (subject §1.1).

use super::dispatch::{Backend, Step};
use super::few::{Aimed, Start};
use super::intersect::{SeenFacets, facet, may_meet, plane, slack, sphere};
use super::lanes::{Lanes, Mask, Real, Single};
use super::packet::{Block, Hits, NOTHING, PACKETS, Packet, PerPacket};
use super::vector::{Vector, lanes, mask};
use crate::bvh::{Beam, Block as Facets4, LeafBox, Visit};
use crate::precision::lies_in_plane;
use crate::reference::intersect::intersect_facet;
use crate::world::{Facets, Geometry};
use crate::{Ray, World};
use glam::{DMat3, DVec3};
use std::ops::Range;

/// An f32 that is not less than a distance.
pub(super) const UPWARDS: f32 = 1.0 + 1.0 / 4_194_304.0;

/// Finds what every ray meets first, leaving out the surface that it starts on.
pub(super) struct Nearest<'s, B: Backend> {
    pub(super) world: &'s World,
    /// The spheres and planes that primary rays start on.
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
                let start = Start::at(few, packet.origin);
                aimed.aim::<L>((few, few.all()), place, (&start, packet.direction), hits.t, packet.mask);
            }
        }
        for (&body, rays) in few.numbers().iter().zip(&aimed.lanes) {
            try_body(world, eye_lies_on, block, hits, body, rays);
        }
        return;
    }
    let (bvh, bodies) = world.bounded();
    let mut beam = Beam::new(bvh, bvh.margin());
    for (packet, hits) in block.packets.iter().zip(hits.iter()) {
        beam.push(packet.origin, (packet.origin, packet.direction), packet.mask, hits.farthest(packet.mask));
    }
    beam.traverse(&mut Bodies { world, bodies, eye_lies_on, block, hits });
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
        let mut taken = met & t.lt(self.t).bits();
        for lane in lanes(met & t.eq(self.t).bits()) {
            taken |= u8::from((body, facet) < (self.body[lane], self.facet[lane])) << lane;
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
            self.facet[lane] = if new { facet } else { self.facet[lane] };
        }
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
    fn leaf(&mut self, beam: &mut Beam<'_, L>, _: LeafBox<'_>, first: u32, count: u32, packets: u8) {
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

/// Tries a set of facets with some rays of each packet.
struct OnFacets<'s, B: Backend> {
    facets: &'s Facets,
    body: u32,
    block: &'s Block<B>,
    hits: &'s mut PerPacket<Hits<B>>,
    rays: &'s [u8; PACKETS],
}

impl<B: Backend> Step<B> for OnFacets<'_, B> {
    #[inline(always)]
    fn run(self) {
        let OnFacets { facets, body, block, hits, rays } = self;
        let mut within = Beam::new(facets.bvh(), facets.margin());
        for (place, packet) in block.packets.iter().enumerate() {
            let mask = rays[place];
            let limit = if mask == 0 { -1.0 } else { hits[place].farthest(mask) };
            send(&mut within, facets, (packet.origin, packet.direction), mask, limit);
        }
        within.traverse(&mut FacetLeaves { facets, body, block, hits });
    }
}

/// Adds a packet to a beam in the space of a set of facets. Those without rays keep their places.
#[inline(always)]
pub(super) fn send<L: Lanes>(
    beam: &mut Beam<'_, L>,
    facets: &Facets,
    (start, direction): (Vector<L::Real>, Vector<L::Real>),
    mask: u8,
    limit: f32,
) {
    if mask == 0 {
        beam.skip();
    } else if let Some((linear, position)) = facets.to_local() {
        let origin = product(linear, start - Vector::splat(*position));
        beam.push(start, (origin, product(linear, direction)), mask, limit);
    } else {
        beam.push(start, (start, direction), mask, limit);
    }
}

/// A matrix times vectors.
#[inline(always)]
fn product<R: Real>(matrix: &DMat3, vector: Vector<R>) -> Vector<R> {
    let [x, y, z] = [Vector::splat(matrix.x_axis), Vector::splat(matrix.y_axis), Vector::splat(matrix.z_axis)];
    x * vector.x + y * vector.y + z * vector.z
}

/// Tries the facets of leaves.
struct FacetLeaves<'v, L: Lanes> {
    facets: &'v Facets,
    body: u32,
    block: &'v Block<L>,
    hits: &'v mut PerPacket<Hits<L>>,
}

impl<L: Backend> Visit<L> for FacetLeaves<'_, L> {
    #[inline(always)]
    fn limit(&self, packet: usize, lanes: u8) -> f32 {
        self.hits[packet].farthest(lanes)
    }

    #[inline(always)]
    fn leaf(&mut self, beam: &mut Beam<'_, L>, place: LeafBox<'_>, first: u32, count: u32, packets: u8) {
        L::enter(TryFacets { leaves: self, beam, place, blocks: first..first + count, packets });
    }
}

/// Tries the facets of a leaf with some packets.
struct TryFacets<'s, 'v, 'b, 'n, B: Backend> {
    leaves: &'s mut FacetLeaves<'v, B>,
    beam: &'s mut Beam<'b, B>,
    place: LeafBox<'n>,
    blocks: Range<u32>,
    packets: u8,
}

impl<B: Backend> Step<B> for TryFacets<'_, '_, '_, '_, B> {
    #[inline(always)]
    fn run(self) {
        let leaves = self.leaves;
        let blocks = &leaves.facets.blocks()[self.blocks.start as usize..self.blocks.end as usize];
        let (packets, from_one_point) = (self.packets, leaves.block.from_one_point);
        try_leaf(self.beam, self.place, blocks, packets, from_one_point, leaves);
    }
}

impl<L: Backend> Candidates<L> for FacetLeaves<'_, L> {
    #[inline(always)]
    fn try_facet(&mut self, place: usize, may: u8, number: u32) -> bool {
        let packet = &self.block.packets[place];
        let corners = self.facets.corners(number);
        if may.is_power_of_two() {
            return self.try_ray(place, may.trailing_zeros() as usize, number, corners);
        }
        let found = facet::<L>(packet.origin, packet.direction, corners);
        let met = not_started_on(packet, found.lanes & may, corners, self.body);
        if met != 0 {
            self.hits[place].take(met, found.t, Some((found.alpha, found.beta)), self.body, number);
        }
        met != 0
    }
}

impl<L: Lanes> FacetLeaves<'_, L> {
    /// One ray alone, as the reference does it.
    #[inline(always)]
    fn try_ray(&mut self, place: usize, lane: usize, number: u32, [p0, p1, p2]: [DVec3; 3]) -> bool {
        let packet = &self.block.packets[place];
        let ray = Ray { origin: packet.origin.lane(lane), direction: packet.direction.lane(lane) };
        let Some(hit) = intersect_facet(&ray, p0, p1, p2) else { return false };
        if not_started_on(packet, 1 << lane, [p0, p1, p2], self.body) == 0 {
            return false;
        }
        let shares = Some((L::Real::splat(hit.alpha), L::Real::splat(hit.beta)));
        self.hits[place].take(1 << lane, L::Real::splat(hit.t), shares, self.body, number);
        true
    }
}

/// Is shown the facets that rays may meet.
pub(super) trait Candidates<L: Lanes>: Visit<L> {
    /// Tries a facet with some rays of a packet; whether that may have changed how far they look.
    fn try_facet(&mut self, packet: usize, may: u8, number: u32) -> bool;
}

/// Shows the facets of a leaf that rays may meet, and shortens the beam.
#[inline(always)]
pub(super) fn try_leaf<L: Lanes>(
    beam: &mut Beam<'_, L>,
    place: LeafBox<'_>,
    blocks: &[Facets4],
    packets: u8,
    from_one_point: bool,
    candidates: &mut impl Candidates<L>,
) {
    for blocks in blocks.chunks(2) {
        let mut seen = None;
        for packet in lanes(packets) {
            let rays = &beam.packets[packet];
            let slack = slack(rays, place);
            let mut better = false;
            if rays.mask.is_power_of_two() {
                // a single ray is tried with all facets at once
                let lane = rays.mask.trailing_zeros() as usize;
                let facets = SeenFacets::from_point::<L>(scalar::<L>(&rays.origin, lane), blocks);
                let met = facets.met_by::<L>(scalar::<L>(&rays.direction, lane), slack.store()[lane]);
                for (number, facet) in Facets4::places(blocks) {
                    better |= met >> facet & 1 == 1 && candidates.try_facet(packet, rays.mask, number);
                }
            } else if from_one_point {
                let lane = rays.mask.trailing_zeros() as usize & 7;
                let facets = match &seen {
                    Some(facets) => facets,
                    None => seen.insert(SeenFacets::from_point::<L>(scalar::<L>(&rays.origin, lane), blocks)),
                };
                for (number, facet) in Facets4::places(blocks) {
                    let may = facets.may_meet(rays, slack, facet);
                    better |= may != 0 && candidates.try_facet(packet, may, number);
                }
            } else {
                for (block, lane) in Facets4::lanes(blocks) {
                    let may = may_meet(rays, slack, block, lane);
                    better |= may != 0 && candidates.try_facet(packet, may, block.facets[lane]);
                }
            }
            if better {
                let limit = candidates.limit(packet, rays.mask);
                beam.shorten(packet, limit);
            }
        }
    }
}

/// One lane of three coordinates.
#[inline(always)]
fn scalar<L: Lanes>(coordinates: &[L::Single; 3], lane: usize) -> [f32; 3] {
    let [x, y, z] = coordinates;
    [x.store()[lane], y.store()[lane], z.store()[lane]]
}

/// The hits without those of rays that start on the very facet: on the body, or as primary rays, in the facet's plane.
#[inline(always)]
pub(super) fn not_started_on<L: Lanes>(packet: &Packet<L>, met: u8, [p0, p1, p2]: [DVec3; 3], body: u32) -> u8 {
    let starts_in_plane = |lane| lies_in_plane(packet.origin.lane(lane), p0, p1, p2);
    let mut kept = met;
    for lane in lanes(met & L::equal(&packet.start, body)) {
        if starts_in_plane(lane) {
            kept &= !(1 << lane);
        }
    }
    // primary rays all start at the eye
    let primary = met & L::equal(&packet.start, NOTHING);
    if primary != 0 && starts_in_plane(primary.trailing_zeros() as usize) {
        kept &= !primary;
    }
    kept
}

const _: () = assert!(PACKETS == 8, "sets of packets are bytes");
