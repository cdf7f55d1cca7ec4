//! The nearest facets of a mesh for rays that go each its own way: one after the other through the hierarchy, with eight
//! boxes and eight facets at a time, and the exact tests of all of them together at the end.
//!
//! Where the filter knows that a ray meets a facet, and between which distances, everything farther is out of the race
//! without an exact test. Most rays so have one facet left at the end.

use super::dispatch::{Backend, Step};
use super::facet_filter::Looking;
use super::facets_nearest::not_started_on;
use super::hidden_surfaces::UPWARDS;
use super::intersect::facet_each;
use super::lanes::{Lanes, Real, Single};
use super::packet::{Block, Hits, Packet, PerPacket};
use super::vector::{Vector, lanes};
use crate::Ray;
use crate::bvh::{Beam, Follow, NO_FACET, Scattered};
use crate::reference::intersect::intersect_facet;
use crate::world::Facets;
use arrayvec::ArrayVec;

/// Tries a set of facets with each ray of some packets.
pub(super) struct Alone<'s, 'b, B: Backend> {
    pub(super) facets: &'s Facets,
    pub(super) body: u32,
    pub(super) block: &'s Block<B>,
    /// The rays in the space of the hierarchy.
    pub(super) beam: &'s Beam<'b, B>,
    pub(super) packets: u8,
    pub(super) hits: &'s mut PerPacket<Hits<B>>,
}

impl<B: Backend> Step<B> for Alone<'_, '_, B> {
    #[inline(always)]
    fn run(self) {
        let Alone { facets, body, block, beam, packets, hits } = self;
        let extent = facets.bvh().extent();
        let mut rest = packets;
        while rest != 0 {
            let mut turns = Scattered::new();
            let mut leaves = Leaves { facets, body, block, hits, lanes: ArrayVec::new() };
            while rest != 0 && !leaves.lanes.is_full() {
                let place = rest.trailing_zeros() as usize;
                rest &= rest - 1;
                let rays = &beam.packets[place];
                turns.push(rays);
                let limits = leaves.hits[place].limits().store();
                let (nearest, low) = ([NO_FACET; 8], [f32::INFINITY; 8]);
                leaves.lanes.push(Found { place, looking: Looking::of(rays, extent), limits, nearest, low });
            }
            facets.bvh().follow::<B>(&turns, &mut leaves);
            let Leaves { lanes: found, hits, .. } = leaves;
            for Found { place, nearest, .. } in &found {
                let left = !B::equal(nearest, NO_FACET);
                if left != 0 {
                    take_each(facets, body, &block.packets[*place], nearest, left, &mut hits[*place]);
                }
            }
        }
    }
}

/// Tries the facet of each ray that is left, eight at a time. Those are sure hits, no ray starts on them.
#[inline(always)]
pub(super) fn take_each<L: Lanes>(
    facets: &Facets,
    body: u32,
    packet: &Packet<L>,
    numbers: &[u32; 8],
    left: u8,
    hits: &mut Hits<L>,
) {
    let mut corners = [[[0.0; 8]; 3]; 3];
    for lane in lanes(left) {
        let points = facets.corners(numbers[lane]);
        for corner in 0..3 {
            for axis in 0..3 {
                corners[corner][axis][lane] = points[corner][axis];
            }
        }
    }
    let corners = [Vector::load(&corners[0]), Vector::load(&corners[1]), Vector::load(&corners[2])];
    let found = facet_each::<L>(packet.origin, packet.direction, corners);
    hits.take_each(found.lanes & left, found.t, Some((found.alpha, found.beta)), body, numbers);
}

/// What the rays of a packet have found so far.
struct Found {
    place: usize,
    looking: Looking,
    limits: [f32; 8],
    /// A facet that each ray surely meets, not nearer than `low`, and that is not tried yet.
    nearest: [u32; 8],
    low: [f32; 8],
}

/// Tries the facets of leaves.
struct Leaves<'v, L: Lanes> {
    facets: &'v Facets,
    body: u32,
    block: &'v Block<L>,
    hits: &'v mut PerPacket<Hits<L>>,
    lanes: ArrayVec<Found, { Scattered::PACKETS }>,
}

impl<L: Backend> Follow for Leaves<'_, L> {
    #[inline(always)]
    fn limit(&self, ray: usize) -> f32 {
        self.lanes[ray / 8].limits[ray % 8]
    }

    #[inline(always)]
    fn leaf(&mut self, ray: usize, first: u32, count: u32, mut limit: f32) -> f32 {
        let (packet, lane) = (ray / 8, ray % 8);
        for blocks in self.facets.blocks()[first as usize..(first + count) as usize].chunks(2) {
            let found = &mut self.lanes[packet];
            let sighted = found.looking.at_facets::<L>(lane, blocks, limit);
            if sighted.may == 0 {
                continue;
            }
            let (low, high) = (sighted.low.store(), sighted.high.store());
            for place in lanes(sighted.may) {
                let number = blocks[place / 4 % blocks.len()].facets[place % 4];
                let sure = sighted.sure >> place & 1 == 1;
                let found = &mut self.lanes[packet];
                if sure && high[place] < found.low[lane] {
                    (found.nearest[lane], found.low[lane]) = (number, low[place]);
                    limit = if high[place] < limit { high[place] } else { limit };
                } else if low[place] > limit {
                    // something surely nearer is known
                } else {
                    let mut met = limit;
                    let place = found.place;
                    L::enter(TryRay { leaves: self, place, lane, number, met: &mut met });
                    limit = if met < limit { met } else { limit };
                }
            }
        }
        limit
    }

    #[inline(always)]
    fn soon(&self, first: u32) {
        if let Some(block) = self.facets.blocks().get(first as usize) {
            L::prefetch(block);
        }
    }
}

/// One ray and one facet, as the reference does it; gives an f32 bound of the distance where it meets.
struct TryRay<'s, 'v, L: Lanes> {
    leaves: &'s mut Leaves<'v, L>,
    place: usize,
    lane: usize,
    number: u32,
    met: &'s mut f32,
}

impl<B: Backend> Step<B> for TryRay<'_, '_, B> {
    #[inline(always)]
    fn run(self) {
        let (lane, Leaves { facets, body, block, hits, .. }) = (self.lane, self.leaves);
        let packet = &block.packets[self.place];
        let [p0, p1, p2] = facets.corners(self.number);
        let ray = Ray { origin: packet.origin.lane(lane), direction: packet.direction.lane(lane) };
        let Some(hit) = intersect_facet(&ray, p0, p1, p2) else { return };
        if not_started_on(packet, 1 << lane, [p0, p1, p2], *body) == 0 {
            return;
        }
        let shares = Some((B::Real::splat(hit.alpha), B::Real::splat(hit.beta)));
        hits[self.place].take(1 << lane, B::Real::splat(hit.t), shares, *body, self.number);
        *self.met = hit.t as f32 * UPWARDS;
    }
}
