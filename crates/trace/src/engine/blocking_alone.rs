//! Whether a facet of a mesh stands between points and a lamp, for rays that go each alone: from their points, where what
//! hides the lamp from a surface of small facets under grazing light mostly is.

use super::dispatch::{Backend, Step};
use super::facet_filter::Looking;
use super::facets_blocking::TryNow;
use super::facets_nearest::send;
use super::hidden_surfaces::UPWARDS;
use super::lanes::{Lanes, Mask, Single};
use super::packet::PACKETS;
use super::shadows::ToLamp;
use super::vector::lanes;
use crate::bvh::{Beam, Follow, Scattered};
use crate::world::Facets;
use arrayvec::ArrayVec;
use glam::DVec3;

/// Tries a set of facets with each ray of some packets that is not blocked yet.
pub(super) struct BlockedAlone<'s, B: Backend> {
    pub(super) facets: &'s Facets,
    pub(super) body: u32,
    pub(super) lamp: DVec3,
    pub(super) rays: &'s [ToLamp<B>],
    /// The rays of each packet that ask.
    pub(super) asked: &'s [u8; PACKETS],
    pub(super) blocked: &'s mut [u8; PACKETS],
    pub(super) packets: u8,
}

impl<B: Backend> Step<B> for BlockedAlone<'_, B> {
    #[inline(always)]
    fn run(self) {
        let BlockedAlone { facets, body, lamp, rays, asked, blocked, packets } = self;
        let mut beam: Beam<'_, B> = Beam::new(facets.bvh(), facets.margin());
        for (place, ToLamp { packet, .. }) in rays.iter().enumerate() {
            let mask = if packets >> place & 1 == 1 { asked[place] & !blocked[place] } else { 0 };
            send(&mut beam, facets, (packet.origin, packet.direction), mask, f32::INFINITY);
        }
        let extent = facets.bvh().extent();
        let mut rest = packets;
        while rest != 0 {
            let mut turns = Scattered::new();
            let mut leaves = Leaves { facets, body, lamp, rays, blocked, asking: ArrayVec::new() };
            while rest != 0 && !leaves.asking.is_full() {
                let place = rest.trailing_zeros() as usize;
                rest &= rest - 1;
                let asking = &beam.packets[place];
                turns.push(asking);
                let limits = B::narrow(rays[place].distance) * B::Single::splat(UPWARDS);
                leaves.asking.push(Asking { place, looking: Looking::of(asking, extent), limits: limits.store() });
            }
            facets.bvh().follow::<B>(&turns, &mut leaves);
        }
    }
}

/// A packet that asks.
struct Asking {
    place: usize,
    looking: Looking,
    /// How far it is to the lamp, at most.
    limits: [f32; 8],
}

/// Tries the facets of leaves.
struct Leaves<'v, L: Lanes> {
    facets: &'v Facets,
    body: u32,
    lamp: DVec3,
    rays: &'v [ToLamp<L>],
    blocked: &'v mut [u8; PACKETS],
    asking: ArrayVec<Asking, { Scattered::PACKETS }>,
}

impl<L: Backend> Follow for Leaves<'_, L> {
    #[inline(always)]
    fn limit(&self, ray: usize) -> f32 {
        self.asking[ray / 8].limits[ray % 8]
    }

    #[inline(always)]
    fn leaf(&mut self, ray: usize, first: u32, count: u32, limit: f32) -> f32 {
        /// The limit is rounded upwards, by less than this takes away.
        const LESS: f32 = 1.0 - 1.0 / 524_288.0;
        let lane = ray % 8;
        for blocks in self.facets.blocks()[first as usize..(first + count) as usize].chunks(2) {
            let Asking { place, looking, .. } = &self.asking[ray / 8];
            let (place, sighted) = (*place, looking.at_facets::<L>(lane, blocks, limit));
            if sighted.may == 0 {
                continue;
            }
            // as far from the lamp as it is surely from the start: four times the half of what is between the bounds
            let most = sighted.high + (sighted.high - sighted.low) * L::Single::splat(2.0);
            if sighted.sure & most.lt(L::Single::splat(limit * LESS)).bits() != 0 {
                self.blocked[place] |= 1 << lane;
                return -1.0;
            }
            for facet in lanes(sighted.may) {
                let number = blocks[facet / 4 % blocks.len()].facets[facet % 4];
                let Leaves { facets, body, lamp, rays, blocked, .. } = self;
                let may = 1 << lane;
                L::enter(TryNow { facets, body: *body, lamp: *lamp, rays, blocked, place, number, may });
                if self.blocked[place] & may != 0 {
                    return -1.0;
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
