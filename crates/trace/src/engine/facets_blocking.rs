//! Whether a facet of a mesh stands between points and a lamp (subject §1.2): what `shadows` hands a mesh to.

use super::blocking_alone::BlockedAlone;
use super::dispatch::{Backend, Step};
use super::facet_filter::{Eye, Fan, Seen};
use super::facets_nearest::{not_started_on, shadow, start};
use super::intersect::facet;
use super::lanes::{Lanes, Mask, Real};
use super::packet::PACKETS;
use super::shadows::{Segments, ToLamp};
use super::vector::{Vector, lanes};
use crate::bvh::{Beam, Shadow, Visit};
use crate::precision::lies_in_plane;
use crate::world::Facets;
use std::ops::Range;

/// Tries a set of facets with some rays of each packet.
pub(super) struct OnFacets<'s, B: Backend> {
    pub(super) facets: &'s Facets,
    pub(super) body: u32,
    pub(super) segments: Segments<'s, B>,
    pub(super) blocked: &'s mut [u8; PACKETS],
    pub(super) asked: &'s [u8; PACKETS],
}

impl<B: Backend> Step<B> for OnFacets<'_, B> {
    #[inline(always)]
    fn run(self) {
        let OnFacets { facets, body, segments, blocked, asked } = self;
        let Segments { lamp, rays, .. } = segments;
        let mut within = Beam::new(facets.bvh(), true);
        let from_lamp = start(facets, Vector::splat(lamp));
        for (place, ray) in rays.iter().enumerate() {
            let open = asked[place] & !blocked[place];
            if open == 0 {
                within.push(Shadow::none(), -1.0);
            } else {
                within.push(shadow(facets, &from_lamp, -ray.packet.direction, open), ray.limit(open));
            }
        }
        let mut left = within.scattered();
        for place in lanes(left) {
            within.shorten(place, -1.0);
        }
        let together = within.looking();
        if together != 0 {
            let eye = Eye::of(&within.packets[together.trailing_zeros() as usize], facets.bvh().extent());
            let (fans, patience) = ([None; PACKETS], PATIENCE * together.count_ones());
            let mut leaves = FacetLeaves { facets, body, segments, blocked: &mut *blocked, eye, fans, patience, left };
            within.traverse(&mut leaves);
            left = leaves.left;
        }
        if left != 0 {
            B::enter(BlockedAlone { facets, body, segments, asked, blocked, packets: left });
        }
    }
}

/// To how many leaves each packet may come before its rays had better go alone: where facets are so small, and the light
/// so grazing, that a beam touches more of them than it has rays.
const PATIENCE: u32 = 24;

/// Tries the facets of leaves.
struct FacetLeaves<'v, L: Lanes> {
    facets: &'v Facets,
    body: u32,
    segments: Segments<'v, L>,
    blocked: &'v mut [u8; PACKETS],
    /// The lamp, where all rays start for culling.
    eye: Eye,
    /// The directions of each packet, once they are needed; none loses rays on the way.
    fans: [Option<Fan>; PACKETS],
    /// How many more leaves all packets together may come to.
    patience: u32,
    /// The packets of which the rays go alone: they are scattered, or had come to no end by then.
    left: u8,
}

impl<L: Backend> Visit<L> for FacetLeaves<'_, L> {
    #[inline(always)]
    fn limit(&self, packet: usize, lanes: u8) -> f32 {
        self.segments.rays[packet].limit(lanes & !self.blocked[packet])
    }

    #[inline(always)]
    fn leaf(&mut self, beam: &mut Beam<'_, L>, first: u32, count: u32, packets: u8) {
        if self.patience < packets.count_ones() {
            self.left |= beam.looking();
            for place in 0..PACKETS {
                beam.shorten(place, -1.0);
            }
            return;
        }
        self.patience -= packets.count_ones();
        L::enter(TryFacets { leaves: self, beam, blocks: first..first + count, packets });
    }
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
        for blocks in leaves.facets.blocks()[blocks.start as usize..blocks.end as usize].chunks(2) {
            let there = if blocks.len() == 1 { 0x0f } else { 0xff };
            let seen = Seen::of::<B>(&leaves.eye, blocks);
            for place in lanes(packets) {
                let rays = &beam.packets[place];
                let fan = match leaves.fans[place] {
                    Some(fan) => fan,
                    None => *leaves.fans[place].insert(Fan::of(rays)),
                };
                let before = leaves.blocked[place];
                for facet in lanes(there & seen.within::<B>(&fan)) {
                    let distance = B::narrow(leaves.segments.rays[place].distance);
                    let sighted = seen.before(rays, facet, distance);
                    let unsure = sighted.may & !sighted.sure & !leaves.blocked[place];
                    leaves.blocked[place] |= sighted.sure;
                    if unsure != 0 {
                        let number = blocks[facet / 4 % blocks.len()].facets[facet % 4];
                        let FacetLeaves { facets, body, segments, blocked, .. } = leaves;
                        B::enter(TryNow {
                            facets,
                            body: *body,
                            segments: *segments,
                            blocked,
                            place,
                            number,
                            may: unsure,
                        });
                    }
                }
                if leaves.blocked[place] != before {
                    let limit = leaves.limit(place, rays.mask);
                    beam.shorten(place, limit);
                }
            }
        }
    }
}

/// Tries one facet with some rays of a packet, as the reference does.
pub(super) struct TryNow<'s, B: Backend> {
    pub(super) facets: &'s Facets,
    pub(super) body: u32,
    pub(super) segments: Segments<'s, B>,
    pub(super) blocked: &'s mut [u8; PACKETS],
    pub(super) place: usize,
    pub(super) number: u32,
    pub(super) may: u8,
}

impl<B: Backend> Step<B> for TryNow<'_, B> {
    #[inline(always)]
    fn run(self) {
        let TryNow { facets, body, segments: Segments { lamp, rays, .. }, blocked, place, number, may } = self;
        let ToLamp { packet, distance, .. } = &rays[place];
        let corners = facets.corners(number);
        let found = facet::<B>(packet.origin, packet.direction, corners);
        let met = found.lanes & may & found.t.lt(*distance).bits();
        if met != 0 && !lies_in_plane(lamp, corners[0], corners[1], corners[2]) {
            blocked[place] |= not_started_on(packet, met, corners, body);
        }
    }
}
