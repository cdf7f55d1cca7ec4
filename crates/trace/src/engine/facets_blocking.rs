//! Whether a facet of a mesh stands between points and a lamp (subject §1.2): what `shadows` hands a mesh to.

use super::dispatch::{Backend, Step};
use super::facets_nearest::{Candidates, not_started_on, send, try_leaf};
use super::intersect::facet;
use super::lanes::{Lanes, Mask, Real};
use super::packet::PerPacket;
use super::shadows::ToLamp;
use super::vector::Vector;
use crate::bvh::{Beam, LeafBox, Visit};
use crate::precision::lies_in_plane;
use crate::world::Facets;
use glam::DVec3;
use std::ops::Range;

/// Tries a set of facets with some packets of a beam.
pub(super) struct OnFacets<'s, 'b, B: Backend> {
    pub(super) facets: &'s Facets,
    pub(super) body: u32,
    pub(super) lamp: DVec3,
    pub(super) rays: &'s PerPacket<ToLamp<B>>,
    pub(super) blocked: &'s mut PerPacket<u8>,
    pub(super) beam: &'s Beam<'b, B>,
    pub(super) packets: u8,
}

impl<B: Backend> Step<B> for OnFacets<'_, '_, B> {
    #[inline(always)]
    fn run(self) {
        let OnFacets { facets, body, lamp, rays, blocked, beam, packets } = self;
        let mut within = Beam::new(facets.bvh(), facets.margin());
        for (place, ToLamp { packet, .. }) in rays.iter().enumerate() {
            let mask = if packets >> place & 1 == 1 { beam.packets[place].mask & !blocked[place] } else { 0 };
            send(&mut within, facets, (Vector::splat(lamp), -packet.direction), mask, beam.limit(place));
        }
        within.traverse(&mut FacetLeaves { facets, body, lamp, rays, blocked });
    }
}

/// Tries the facets of leaves.
struct FacetLeaves<'v, L: Lanes> {
    facets: &'v Facets,
    body: u32,
    lamp: DVec3,
    rays: &'v PerPacket<ToLamp<L>>,
    blocked: &'v mut PerPacket<u8>,
}

impl<L: Backend> Visit<L> for FacetLeaves<'_, L> {
    #[inline(always)]
    fn limit(&self, packet: usize, lanes: u8) -> f32 {
        self.rays[packet].limit(lanes & !self.blocked[packet])
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
        // for culling all rays start at the lamp
        try_leaf(self.beam, self.place, blocks, self.packets, true, leaves);
    }
}

impl<L: Backend> Candidates<L> for FacetLeaves<'_, L> {
    #[inline(always)]
    fn try_facet(&mut self, place: usize, may: u8, number: u32) -> bool {
        let ToLamp { packet, distance } = &self.rays[place];
        let may = may & !self.blocked[place];
        if may == 0 {
            return false;
        }
        let corners = self.facets.corners(number);
        let found = facet::<L>(packet.origin, packet.direction, corners);
        let met = found.lanes & may & found.t.lt(*distance).bits();
        if met == 0 || lies_in_plane(self.lamp, corners[0], corners[1], corners[2]) {
            return false;
        }
        let hidden = not_started_on(packet, met, corners, self.body);
        self.blocked[place] |= hidden;
        hidden != 0
    }
}
