//! Whether a facet of a mesh stands between points and a lamp, for packets that go each its own way: from their points,
//! where what hides the lamp from a surface of small facets under grazing light mostly is.

use super::dispatch::{Backend, Step};
use super::facet_filter::{FEW_RAYS, Looking};
use super::facets_blocking::TryNow;
use super::facets_nearest::{shadow, start};
use super::hidden_surfaces::UPWARDS;
use super::lanes::{Lanes, Mask, Single};
use super::packet::{PACKETS, PerPacket};
use super::shadows::{Segments, ToLamp};
use super::vector::lanes;
use crate::bvh::{self, Follow, NO_FACET, Shadow};
use crate::world::Facets;

/// Tries a set of facets with the rays of some packets that are not blocked yet, each packet by itself.
pub(super) struct BlockedAlone<'s, B: Backend> {
    pub(super) facets: &'s Facets,
    pub(super) body: u32,
    pub(super) segments: Segments<'s, B>,
    /// The rays of each packet that ask.
    pub(super) asked: &'s [u8; PACKETS],
    pub(super) blocked: &'s mut [u8; PACKETS],
    pub(super) packets: u8,
}

impl<B: Backend> Step<B> for BlockedAlone<'_, B> {
    #[inline(always)]
    fn run(self) {
        let BlockedAlone { facets, body, segments, asked, blocked, packets } = self;
        let mut shadows: PerPacket<Shadow<B>> = PerPacket::new();
        for (place, ToLamp { packet, .. }) in segments.rays.iter().enumerate() {
            let mask = asked[place] & !blocked[place];
            shadows.push(if packets >> place & 1 == 0 || mask == 0 {
                Shadow::none()
            } else {
                shadow(facets, &start(facets, packet.origin), packet.direction, mask)
            });
        }
        let extent = facets.bvh().extent();
        let nothing = Asking { looking: Looking::NONE, limits: [-1.0; 8] };
        let mut leaves = Leaves { facets, body, segments, blocked, asking: [nothing; PACKETS] };
        for place in lanes(packets) {
            let limits = B::narrow(segments.rays[place].distance) * B::Single::splat(UPWARDS);
            leaves.asking[place] = Asking { looking: Looking::of(&shadows[place], extent), limits: limits.store() };
        }
        facets.bvh().follow::<B>(&shadows, packets, &mut leaves);
    }
}

/// A packet that asks.
#[derive(Clone, Copy)]
struct Asking {
    looking: Looking,
    /// How far it is to the lamp, at most.
    limits: [f32; 8],
}

/// Tries the facets of leaves.
struct Leaves<'v, L: Lanes> {
    facets: &'v Facets,
    body: u32,
    segments: Segments<'v, L>,
    blocked: &'v mut [u8; PACKETS],
    asking: [Asking; PACKETS],
}

impl<L: Backend> Follow<L> for Leaves<'_, L> {
    #[inline(always)]
    fn limits(&self, packet: usize) -> [f32; 8] {
        self.asking[packet].limits
    }

    #[inline(always)]
    fn leaf(&mut self, packet: usize, rays: u8, (first, count): (u32, u32), limits: &mut [f32; 8]) {
        for blocks in self.facets.blocks()[first as usize..(first + count) as usize].chunks(2) {
            let open = rays & !self.blocked[packet];
            if open.count_ones() <= FEW_RAYS {
                for lane in lanes(open) {
                    self.one(packet, lane, blocks);
                }
            } else {
                for block in blocks {
                    for (facet, &number) in block.facets.iter().enumerate() {
                        if number != NO_FACET {
                            self.all(packet, open, (block, facet));
                        }
                    }
                }
            }
        }
        for lane in lanes(rays & self.blocked[packet]) {
            limits[lane] = -1.0;
        }
    }

    #[inline(always)]
    fn soon(&self, first: u32) {
        if let Some(block) = self.facets.blocks().get(first as usize) {
            L::prefetch(block);
        }
    }
}

/// The limit is rounded upwards, by less than this takes away.
const LESS: f32 = 1.0 - 1.0 / 524_288.0;

impl<L: Backend> Leaves<'_, L> {
    /// One ray and the facets of one or two blocks.
    #[inline(always)]
    fn one(&mut self, packet: usize, lane: usize, blocks: &[bvh::Block]) {
        let Asking { looking, limits } = &self.asking[packet];
        let limit = limits[lane];
        let sighted = looking.at_facets::<L>(lane, blocks, limit);
        if sighted.may == 0 {
            return;
        }
        // as far from the lamp as it is surely from the start: four times the half of what is between the bounds
        let most = sighted.high + (sighted.high - sighted.low) * L::Single::splat(2.0);
        if sighted.sure & most.lt(L::Single::splat(limit * LESS)).bits() != 0 {
            self.blocked[packet] |= 1 << lane;
            return;
        }
        for facet in lanes(sighted.may) {
            let number = blocks[facet / 4 % blocks.len()].facets[facet % 4];
            self.exactly(packet, number, 1 << lane);
            if self.blocked[packet] & 1 << lane != 0 {
                return;
            }
        }
    }

    /// Some rays of a packet and one facet.
    #[inline(always)]
    fn all(&mut self, packet: usize, rays: u8, (block, facet): (&bvh::Block, usize)) {
        let Asking { looking, limits } = &self.asking[packet];
        let limit = L::Single::load(limits);
        let sighted = looking.at_facet::<L>(rays, block, facet, limit);
        if sighted.may == 0 {
            return;
        }
        let most = sighted.high + (sighted.high - sighted.low) * L::Single::splat(2.0);
        self.blocked[packet] |= sighted.sure & most.lt(limit * L::Single::splat(LESS)).bits();
        let unknown = sighted.may & !self.blocked[packet];
        if unknown != 0 {
            self.exactly(packet, block.facets[facet], unknown);
        }
    }

    #[inline(always)]
    fn exactly(&mut self, place: usize, number: u32, may: u8) {
        let Leaves { facets, body, segments, blocked, .. } = self;
        L::enter(TryNow { facets, body: *body, segments: *segments, blocked, place, number, may });
    }
}
