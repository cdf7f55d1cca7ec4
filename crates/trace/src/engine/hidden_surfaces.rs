//! The nearest hits of a block of rays (subject §1.1).

use super::dispatch::{Backend, Step};
use super::intersect::{facet, may_meet, plane, sphere};
use super::lanes::{Lanes, Mask, Real, Single};
use super::packet::{Block, Hits, NOTHING, PACKETS, Packet, PerPacket};
use super::vector::{Vector, equal, lanes, mask};
use crate::World;
use crate::bvh::{Beam, Block as Facets4, LeafBox, Visit};
use crate::precision::lies_in_plane;
use crate::world::{Facets, Geometry};
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
    let (bvh, bodies) = world.bounded();
    let mut beam = Beam::new(bvh, bvh.margin());
    for (packet, hits) in block.packets.iter().zip(hits.iter()) {
        beam.push(packet.origin, (packet.origin, packet.direction), packet.mask, hits.farthest(packet.mask));
    }
    beam.traverse(&mut Bodies { world, bodies, eye_lies_on, block, hits });
}

impl<L: Lanes> Packet<L> {
    /// The lanes whose rays start on a body.
    #[inline(always)]
    pub(super) fn starts_on(&self, body: u32, eye_lies_on: &[u32]) -> u8 {
        let here = equal(&self.start, body);
        if eye_lies_on.is_empty() || eye_lies_on.binary_search(&body).is_err() {
            here
        } else {
            here | equal(&self.start, NOTHING)
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
    fn leaf(&mut self, beam: &mut Beam<'_, L>, _: LeafBox<'_>, first: u32, count: u32, packets: u8) {
        for &number in &self.bodies[first as usize..(first + count) as usize] {
            match &self.world.body(number).geometry {
                Geometry::Sphere { center, radius } => {
                    for place in lanes(packets) {
                        let packet = &self.block.packets[place];
                        let here = packet.starts_on(number, self.eye_lies_on);
                        let (met, t) = sphere::<L>(packet.origin, packet.direction, *center, *radius, here);
                        let met = met & packet.mask;
                        if met != 0 {
                            self.hits[place].take(met, t, None, number, 0);
                            beam.shorten(place, self.hits[place].farthest(packet.mask));
                        }
                    }
                }
                Geometry::Facets(facets) => {
                    L::enter(OnFacets { facets, body: number, block: self.block, hits: self.hits, beam, packets });
                }
                // planes have no bounds
                Geometry::Plane { .. } => {}
            }
        }
    }
}

/// Tries a set of facets with some packets of a beam.
struct OnFacets<'s, 'b, B: Backend> {
    facets: &'s Facets,
    body: u32,
    block: &'s Block<B>,
    hits: &'s mut PerPacket<Hits<B>>,
    beam: &'s mut Beam<'b, B>,
    packets: u8,
}

impl<B: Backend> Step<B> for OnFacets<'_, '_, B> {
    #[inline(always)]
    fn run(self) {
        let OnFacets { facets, body, block, hits, beam, packets } = self;
        let mut within = Beam::new(facets.bvh(), facets.margin());
        for (place, packet) in block.packets.iter().enumerate() {
            let mask = if packets >> place & 1 == 1 { packet.mask } else { 0 };
            send(&mut within, facets, (packet.origin, packet.direction), mask, beam.limit(place));
        }
        within.traverse(&mut FacetLeaves { facets, body, block, hits });
        for place in lanes(packets) {
            beam.shorten(place, within.limit(place));
        }
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
        let FacetLeaves { facets, body, block, hits } = self.leaves;
        let blocks = &facets.blocks()[self.blocks.start as usize..self.blocks.end as usize];
        for place in lanes(self.packets) {
            let (rays, packet) = (&self.beam.packets[place], &block.packets[place]);
            let reach = self.place.reach(rays);
            let mut better = false;
            for (block, lane) in Facets4::lanes(blocks) {
                let number = block.facets[lane];
                let may = may_meet(rays, reach, block, lane);
                if may == 0 {
                    continue;
                }
                let corners = facets.corners(number);
                let found = facet::<B>(packet.origin, packet.direction, corners);
                let met = not_started_on(packet, found.lanes & may, corners, *body);
                if met != 0 {
                    hits[place].take(met, found.t, Some((found.alpha, found.beta)), *body, number);
                    better = true;
                }
            }
            if better {
                self.beam.shorten(place, hits[place].farthest(packet.mask));
            }
        }
    }
}

/// The hits without those of rays that start on the very facet: on the body, or as primary rays, in the facet's plane.
#[inline(always)]
pub(super) fn not_started_on<L: Lanes>(packet: &Packet<L>, met: u8, [p0, p1, p2]: [DVec3; 3], body: u32) -> u8 {
    let starts_in_plane = |lane| lies_in_plane(packet.origin.lane(lane), p0, p1, p2);
    let mut kept = met;
    for lane in lanes(met & equal(&packet.start, body)) {
        if starts_in_plane(lane) {
            kept &= !(1 << lane);
        }
    }
    // primary rays all start at the eye
    let primary = met & equal(&packet.start, NOTHING);
    if primary != 0 && starts_in_plane(primary.trailing_zeros() as usize) {
        kept &= !primary;
    }
    kept
}

const _: () = assert!(PACKETS == 8, "sets of packets are bytes");
