//! The nearest facet of a mesh along each ray (subject §1.1): what `hidden_surfaces` hands a mesh to.

use super::dispatch::{Backend, Step};
use super::facets_alone::Alone;
use super::intersect::{SeenFacets, facet, may_meet, slack};
use super::lanes::{Lanes, Real, Single};
use super::packet::{Block, Hits, NOTHING, Packet, PerPacket};
use super::vector::{Vector, equal, lanes};
use crate::Ray;
use crate::bvh::{Beam, Block as Facets4, LeafBox, Visit};
use crate::precision::lies_in_plane;
use crate::reference::intersect::intersect_facet;
use crate::world::Facets;
use glam::{DMat3, DVec3};
use std::ops::Range;

/// Tries a set of facets with some packets of a beam.
pub(super) struct OnFacets<'s, 'b, B: Backend> {
    pub(super) facets: &'s Facets,
    pub(super) body: u32,
    pub(super) block: &'s Block<B>,
    pub(super) hits: &'s mut PerPacket<Hits<B>>,
    pub(super) beam: &'s mut Beam<'b, B>,
    pub(super) packets: u8,
}

impl<B: Backend> Step<B> for OnFacets<'_, '_, B> {
    #[inline(always)]
    fn run(self) {
        let OnFacets { facets, body, block, hits, beam, packets } = self;
        let mut within = Beam::new(facets.bvh(), facets.margin());
        for (place, packet) in block.packets.iter().enumerate() {
            let mask = if packets >> place & 1 == 1 { beam.packets[place].mask } else { 0 };
            send(&mut within, facets, (packet.origin, packet.direction), mask, beam.limit(place));
        }
        let scattered = if block.from_one_point { within.scattered() } else { packets };
        if scattered != 0 {
            B::enter(Alone { facets, body, block, beam: &within, packets: scattered, hits });
            for place in lanes(scattered) {
                within.shorten(place, -1.0);
            }
        }
        within.traverse(&mut FacetLeaves { facets, body, block, hits });
        for place in lanes(packets) {
            // not the limit within: rays that went one by one have left it at the last one's
            beam.shorten(place, hits[place].farthest(beam.packets[place].mask));
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
