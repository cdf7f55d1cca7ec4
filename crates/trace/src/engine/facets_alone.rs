//! The nearest facets of a mesh for packets that go each its own way: with eight boxes at a time through the hierarchy,
//! at a leaf with eight facets and one ray, or eight rays and one facet, whichever is less, and with the exact tests of
//! each packet together at the end.
//!
//! Where the filter knows that a ray meets a facet, and between which distances, everything farther is out of the race
//! without an exact test. Most rays so have one facet left at the end.

use super::dispatch::{Backend, Step};
use super::facet_filter::{FEW_RAYS, Looking};
use super::facets_nearest::not_started_on;
use super::hidden_surfaces::UPWARDS;
use super::intersect::facet_each;
use super::lanes::{Lanes, Mask, Real, Single};
use super::packet::{Block, Hits, PACKETS, Packet, PerPacket};
use super::vector::{Vector, lanes, put_value};
use crate::Ray;
use crate::bvh::{self, Follow, NO_FACET, Shadow};
use crate::reference::intersect::intersect_facet;
use crate::world::Facets;

/// Tries a set of facets with some packets, each by itself.
pub(super) struct Alone<'s, B: Backend> {
    pub(super) facets: &'s Facets,
    pub(super) body: u32,
    pub(super) block: &'s Block<B>,
    /// The rays in the space of the hierarchy.
    pub(super) rays: &'s [Shadow<B>],
    pub(super) packets: u8,
    pub(super) hits: &'s mut PerPacket<Hits<B>>,
}

impl<B: Backend> Step<B> for Alone<'_, B> {
    #[inline(always)]
    fn run(self) {
        let Alone { facets, body, block, rays, packets, hits } = self;
        let extent = facets.bvh().extent();
        let nothing = Found { looking: Looking::NONE, nearest: [NO_FACET; 8], low: [f32::INFINITY; 8] };
        let mut leaves = Leaves { facets, body, block, hits, found: [nothing; PACKETS] };
        for place in lanes(packets) {
            leaves.found[place].looking = Looking::of(&rays[place], extent);
        }
        facets.bvh().follow::<B>(rays, packets, &mut leaves);
        let Leaves { found, hits, .. } = leaves;
        for place in lanes(packets) {
            let nearest = &found[place].nearest;
            let left = !B::equal(nearest, NO_FACET);
            if left != 0 {
                take_each(facets, body, &block.packets[place], nearest, left, &mut hits[place]);
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
#[derive(Clone, Copy)]
struct Found {
    looking: Looking,
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
    found: [Found; PACKETS],
}

impl<L: Backend> Follow<L> for Leaves<'_, L> {
    #[inline(always)]
    fn limits(&self, packet: usize) -> [f32; 8] {
        self.hits[packet].limits().store()
    }

    #[inline(always)]
    fn leaf(&mut self, packet: usize, rays: u8, (first, count): (u32, u32), limits: &mut [f32; 8]) {
        for blocks in self.facets.blocks()[first as usize..(first + count) as usize].chunks(2) {
            if rays.count_ones() <= FEW_RAYS {
                for lane in lanes(rays) {
                    self.one(packet, lane, blocks, &mut limits[lane]);
                }
            } else {
                for block in blocks {
                    for (facet, &number) in block.facets.iter().enumerate() {
                        if number != NO_FACET {
                            self.all(packet, rays, (block, facet), limits);
                        }
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn soon(&self, first: u32) {
        if let Some(block) = self.facets.blocks().get(first as usize) {
            L::prefetch(block);
        }
    }
}

impl<L: Backend> Leaves<'_, L> {
    /// One ray and the facets of one or two blocks.
    #[inline(always)]
    fn one(&mut self, packet: usize, lane: usize, blocks: &[bvh::Block], limit: &mut f32) {
        let found = &mut self.found[packet];
        let sighted = found.looking.at_facets::<L>(lane, blocks, *limit);
        if sighted.may == 0 {
            return;
        }
        let (low, high) = (sighted.low.store(), sighted.high.store());
        for place in lanes(sighted.may) {
            let number = blocks[place / 4 % blocks.len()].facets[place % 4];
            let sure = sighted.sure >> place & 1 == 1;
            let found = &mut self.found[packet];
            if sure && high[place] < found.low[lane] {
                (found.nearest[lane], found.low[lane]) = (number, low[place]);
                *limit = if high[place] < *limit { high[place] } else { *limit };
            } else if low[place] > *limit {
                // something surely nearer is known
            } else {
                let mut met = *limit;
                L::enter(TryRay { leaves: self, place: packet, lane, number, met: &mut met });
                *limit = if met < *limit { met } else { *limit };
            }
        }
    }

    /// Some rays of a packet and one facet: keeps what is surely nearer than all before, and tries what nobody knows.
    #[inline(always)]
    fn all(&mut self, packet: usize, rays: u8, (block, facet): (&bvh::Block, usize), limits: &mut [f32; 8]) {
        let found = &mut self.found[packet];
        let limit = L::Single::load(limits);
        let sighted = found.looking.at_facet::<L>(rays, block, facet, limit);
        if sighted.may == 0 {
            return;
        }
        let number = block.facets[facet];
        let low = L::Single::load(&found.low);
        let kept = sighted.sure & sighted.high.lt(low).bits();
        let mask = L::SingleMask::from_bits(kept);
        found.low = L::Single::select(mask, sighted.low, low).store();
        let limit = L::Single::select(mask, sighted.high.min(limit), limit);
        put_value(&mut found.nearest, kept, number);
        *limits = limit.store();
        let unknown = sighted.may & !kept & !sighted.low.gt(limit).bits();
        for lane in lanes(unknown) {
            let mut met = limits[lane];
            L::enter(TryRay { leaves: self, place: packet, lane, number, met: &mut met });
            limits[lane] = if met < limits[lane] { met } else { limits[lane] };
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
