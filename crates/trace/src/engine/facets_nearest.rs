//! The nearest facet of a mesh along each ray (subject §1.1): what `hidden_surfaces` hands a mesh to.

use super::dispatch::{Backend, Step};
use super::facet_filter::{Eye, Fan, Seen, Sighted, sight};
use super::facets_alone::{Alone, take_each};
use super::intersect::facet;
use super::lanes::{Lanes, Mask, Real, Single};
use super::packet::{Block, Hits, NOTHING, PACKETS, Packet, PerPacket};
use super::vector::{Vector, lanes};
use crate::bvh::{Beam, NO_FACET, Shadow, Start, Visit};
use crate::precision::lies_in_plane;
use crate::world::Facets;
use glam::{DMat3, DVec3};
use std::ops::Range;

/// Tries a set of facets with some rays of each packet.
pub(super) struct OnFacets<'s, B: Backend> {
    pub(super) facets: &'s Facets,
    pub(super) body: u32,
    pub(super) block: &'s Block<B>,
    pub(super) hits: &'s mut PerPacket<Hits<B>>,
    pub(super) rays: &'s [u8; PACKETS],
}

impl<B: Backend> Step<B> for OnFacets<'_, B> {
    #[inline(always)]
    fn run(self) {
        let OnFacets { facets, body, block, hits, rays } = self;
        let mut packets = 0;
        for place in 0..block.packets.len() {
            packets |= u8::from(rays[place] != 0) << place;
        }
        // rays from several points keep together where all boxes are tried anyway
        if !block.from_one_point && facets.bvh().nodes().len() > 1 {
            let mut shadows: PerPacket<Shadow<B>> = PerPacket::new();
            for (place, packet) in block.packets.iter().enumerate() {
                if rays[place] == 0 {
                    shadows.push(Shadow::none());
                } else {
                    shadows.push(shadow(facets, &start(facets, packet.origin), packet.direction, rays[place]));
                }
            }
            return B::enter(Alone { facets, body, block, rays: &shadows, packets, hits });
        }
        #[allow(clippy::manual_map, reason = "closures are not compiled for a backend")]
        let eye = match block.eye() {
            Some(eye) => Some(start(facets, eye)),
            None => None,
        };
        let mut within = Beam::new(facets.bvh(), eye.is_some());
        for (place, packet) in block.packets.iter().enumerate() {
            let mask = rays[place];
            if mask == 0 {
                within.push(Shadow::none(), -1.0);
            } else {
                let start = match &eye {
                    Some(eye) => *eye,
                    None => start(facets, packet.origin),
                };
                within.push(shadow(facets, &start, packet.direction, mask), hits[place].farthest(mask));
            }
        }
        let scattered = within.scattered();
        if scattered != 0 {
            B::enter(Alone { facets, body, block, rays: &within.packets, packets: scattered, hits });
            for place in lanes(scattered) {
                within.shorten(place, -1.0);
            }
        }
        let together = packets & !scattered;
        if together != 0 {
            let mut leaves = FacetLeaves::of(facets, body, block, hits, &within, together);
            within.traverse(&mut leaves);
            let FacetLeaves { hits, found, .. } = leaves;
            for place in lanes(together) {
                let nearest = &found[place].nearest;
                let left = !B::equal(nearest, NO_FACET);
                if left != 0 {
                    take_each(facets, body, &block.packets[place], nearest, left, &mut hits[place]);
                }
            }
        }
    }
}

/// Where rays start, as the hierarchy of a set of facets sees it.
#[inline(always)]
pub(super) fn start<L: Lanes>(facets: &Facets, world: Vector<L::Real>) -> Start<L> {
    let here = match facets.to_local() {
        Some((linear, position)) => product(linear, world - Vector::splat(*position)),
        None => world,
    };
    Start::new(facets.bvh(), facets.margin(), world, here)
}

/// Rays from there, as the hierarchy sees them.
#[inline(always)]
pub(super) fn shadow<L: Lanes>(facets: &Facets, start: &Start<L>, direction: Vector<L::Real>, mask: u8) -> Shadow<L> {
    match facets.to_local() {
        Some((linear, _)) => Shadow::new(start, product(linear, direction), mask),
        None => Shadow::new(start, direction, mask),
    }
}

/// A matrix times vectors.
#[inline(always)]
fn product<R: Real>(matrix: &DMat3, vector: Vector<R>) -> Vector<R> {
    let [x, y, z] = [Vector::splat(matrix.x_axis), Vector::splat(matrix.y_axis), Vector::splat(matrix.z_axis)];
    x * vector.x + y * vector.y + z * vector.z
}

/// What a packet has found so far.
struct Found<L: Lanes> {
    /// How far each ray still looks.
    limit: L::Single,
    /// A facet that each ray surely meets, not nearer than `low`, and that is not tried yet.
    nearest: [u32; 8],
    low: L::Single,
    /// Its directions, once they are needed.
    fan: Option<Fan>,
}

/// Tries the facets of leaves.
struct FacetLeaves<'v, L: Lanes> {
    facets: &'v Facets,
    body: u32,
    block: &'v Block<L>,
    hits: &'v mut PerPacket<Hits<L>>,
    /// Where all rays start, if that is one point.
    eye: Option<Eye>,
    found: PerPacket<Found<L>>,
}

impl<'v, L: Lanes> FacetLeaves<'v, L> {
    /// For some packets, one at least.
    #[inline(always)]
    fn of(
        facets: &'v Facets,
        body: u32,
        block: &'v Block<L>,
        hits: &'v mut PerPacket<Hits<L>>,
        beam: &Beam<'_, L>,
        packets: u8,
    ) -> FacetLeaves<'v, L> {
        let first = &beam.packets[packets.trailing_zeros() as usize];
        let eye = if block.from_one_point { Some(Eye::of(first, facets.bvh().extent())) } else { None };
        let mut found = PerPacket::new();
        for hits in hits.iter() {
            let (nearest, low) = ([NO_FACET; 8], L::Single::splat(f32::INFINITY));
            found.push(Found { limit: hits.limits(), nearest, low, fan: None });
        }
        FacetLeaves { facets, body, block, hits, eye, found }
    }
}

impl<L: Backend> Visit<L> for FacetLeaves<'_, L> {
    #[inline(always)]
    fn limit(&self, packet: usize, lanes: u8) -> f32 {
        farthest::<L>(self.found[packet].limit, lanes)
    }

    #[inline(always)]
    fn leaf(&mut self, beam: &mut Beam<'_, L>, first: u32, count: u32, packets: u8) {
        L::enter(TryFacets { leaves: self, beam, blocks: first..first + count, packets });
    }
}

/// The greatest of some lanes.
#[inline(always)]
fn farthest<L: Lanes>(limits: L::Single, lanes: u8) -> f32 {
    L::Single::select(L::SingleMask::from_bits(lanes), limits, L::Single::splat(-1.0)).greatest()
}

/// Tries the facets of a leaf with some packets.
struct TryFacets<'s, 'v, 'b, B: Backend> {
    leaves: &'s mut FacetLeaves<'v, B>,
    beam: &'s mut Beam<'b, B>,
    blocks: Range<u32>,
    packets: u8,
}

impl<B: Backend> Step<B> for TryFacets<'_, '_, '_, B> {
    #[inline(always)]
    fn run(self) {
        let TryFacets { leaves, beam, blocks, packets } = self;
        let extent = leaves.facets.bvh().extent();
        for blocks in leaves.facets.blocks()[blocks.start as usize..blocks.end as usize].chunks(2) {
            let there = if blocks.len() == 1 { 0x0f } else { 0xff };
            #[allow(clippy::manual_map, reason = "closures are not compiled for a backend")]
            let seen = match &leaves.eye {
                Some(eye) => Some(Seen::of::<B>(eye, blocks)),
                None => None,
            };
            for place in lanes(packets) {
                let rays = &beam.packets[place];
                let found = &mut leaves.found[place];
                let may = match &seen {
                    Some(seen) => {
                        let fan = match found.fan {
                            Some(fan) => fan,
                            None => *found.fan.insert(Fan::of(rays)),
                        };
                        there & seen.within::<B>(&fan)
                    }
                    None => there,
                };
                let mut nearer = false;
                for facet in lanes(may) {
                    let block = &blocks[facet / 4 % blocks.len()];
                    let limit = leaves.found[place].limit;
                    let sighted = match &seen {
                        Some(seen) => seen.by(rays, facet, limit),
                        None => sight(rays, extent, block, facet % 4, limit),
                    };
                    if sighted.may != 0 {
                        leaves.weigh(place, block.facets[facet % 4], &sighted);
                        nearer = true;
                    }
                }
                if nearer {
                    let limit = leaves.limit(place, rays.mask);
                    beam.shorten(place, limit);
                }
            }
        }
    }
}

impl<L: Backend> FacetLeaves<'_, L> {
    /// Keeps what is surely nearer than all before, and tries what nobody knows.
    #[inline(always)]
    fn weigh(&mut self, place: usize, number: u32, sighted: &Sighted<L>) {
        let found = &mut self.found[place];
        let kept = sighted.sure & sighted.high.lt(found.low).bits();
        let mask = L::SingleMask::from_bits(kept);
        found.low = L::Single::select(mask, sighted.low, found.low);
        found.limit = L::Single::select(mask, sighted.high.min(found.limit), found.limit);
        for lane in 0..8 {
            found.nearest[lane] = if kept >> lane & 1 == 1 { number } else { found.nearest[lane] };
        }
        let unknown = sighted.may & !kept & !sighted.low.gt(found.limit).bits();
        if unknown != 0 {
            L::enter(TryNow { leaves: self, place, number, may: unknown });
        }
    }
}

/// Tries one facet with some rays of a packet at once.
struct TryNow<'s, 'v, B: Backend> {
    leaves: &'s mut FacetLeaves<'v, B>,
    place: usize,
    number: u32,
    may: u8,
}

impl<B: Backend> Step<B> for TryNow<'_, '_, B> {
    #[inline(always)]
    fn run(self) {
        let TryNow { leaves: FacetLeaves { facets, body, block, hits, found, .. }, place, number, may } = self;
        let packet = &block.packets[place];
        let corners = facets.corners(number);
        let tried = facet::<B>(packet.origin, packet.direction, corners);
        let met = not_started_on(packet, tried.lanes & may, corners, *body);
        if met != 0 {
            hits[place].take(met, tried.t, Some((tried.alpha, tried.beta)), *body, number);
            found[place].limit = found[place].limit.min(hits[place].limits());
        }
    }
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
