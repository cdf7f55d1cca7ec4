//! Mirrored and refracted rays of a block (subject §1.3), and what they see.

use super::dispatch::{Backend, Step};
use super::lanes::{Mask, Real};
use super::light::select;
use super::packet::{Block, Colors, PACKETS, Packet, PerPacket};
use super::path::{Groups, Path, Trace};
use super::surface_point::Points;
use super::vector::{Vector, mask, put_value};
use crate::RayKind;
use arrayvec::ArrayVec;
use lancer_scene::Rgb;

/// A way that refracted light goes from the points of a packet: each lane has its indices and channels.
#[derive(Clone, Copy)]
struct Way {
    n: [f64; 8],
    n_prime: [f64; 8],
    /// The lanes that go this way, for each channel.
    channels: [u8; 3],
}

impl Way {
    const NONE: Way = Way { n: [1.0; 8], n_prime: [1.0; 8], channels: [0; 3] };
}

/// Three channels have three ways at most.
const WAYS: usize = 3;

/// The rays that leave the points of a packet along `R`.
#[derive(Clone, Copy)]
struct Leaving {
    /// The lanes that are mirrored, and those that are totally reflected, for each channel: one ray serves both.
    mirrored: [u8; 3],
    total: [u8; 3],
}

/// The rays that pass through the points of a packet.
#[derive(Clone, Copy)]
struct Passing {
    /// The packet's place in its block.
    place: usize,
    ways: [Way; WAYS],
    /// The stack of media beyond the surface.
    beyond: [u32; 8],
}

impl Path<'_> {
    /// What is seen along the mirrored rays, `Ir`, and through the surfaces, `It`.
    #[inline(always)]
    pub(super) fn secondary<B: Backend>(
        &mut self,
        block: &Block<B>,
        points: &[Points<B>],
        groups: &PerPacket<Groups>,
        mirrored: &mut [Colors<B>; PACKETS],
        refracted: &mut [Colors<B>; PACKETS],
    ) {
        let steps = self.settings.steps;
        if block.level >= self.settings.depth || !(steps.reflection || steps.transparency) {
            return;
        }
        let mut leaving: PerPacket<Leaving> = PerPacket::new();
        let mut passing: PerPacket<Passing> = PerPacket::new();
        for (place, at) in points.iter().enumerate() {
            leaving.push(self.leaving(place, &block.packets[place], at, &groups[place], &mut passing));
        }
        if leaving.iter().any(|leaving| any(&leaving.mirrored) | any(&leaving.total) != 0) {
            B::enter(Reflect { path: self, block, points, leaving: &leaving, mirrored, refracted });
        }
        for way in 0..WAYS {
            if passing.iter().any(|passing| any(&passing.ways[way].channels) != 0) {
                B::enter(Refract { path: self, block, points, passing: &passing, way, refracted });
            }
        }
    }

    /// Which rays leave the points of a packet.
    #[inline(always)]
    fn leaving<B: Backend>(
        &mut self,
        place: usize,
        packet: &Packet<B>,
        at: &Points<B>,
        groups: &Groups,
        passing: &mut PerPacket<Passing>,
    ) -> Leaving {
        let steps = self.settings.steps;
        let (mut mirrored, mut glass) = ([0_u8; 3], [0_u8; 3]);
        let open = !self.spent[packet.place];
        for &(surface, group) in groups {
            let surface = self.world.surface(surface);
            if steps.reflection && surface.is_mirror() {
                carry(&mut mirrored, packet, group & open, surface.kr);
            }
            if steps.transparency && surface.is_transparent() {
                carry(&mut glass, packet, group & open, surface.kt);
            }
        }
        let mut leaving = Leaving { mirrored, total: [0; 3] };
        if any(&glass) != 0 {
            let mut found = Passing { place, ways: [Way::NONE; WAYS], beyond: packet.media };
            self.find_ways(packet, at, glass, &mut found);
            for way in &mut found.ways {
                if any(&way.channels) != 0 {
                    let (reflected, _) = refract::<B>(packet, at, way);
                    for channel in 0..3 {
                        leaving.total[channel] |= way.channels[channel] & reflected;
                        way.channels[channel] &= !reflected;
                    }
                }
            }
            passing.push(found);
        }
        leaving
    }

    /// Where the refracted channels go: those with equal `n/n'` share a way. Light goes straight on through sheets.
    #[inline(always)]
    fn find_ways<B: Backend>(&mut self, packet: &Packet<B>, at: &Points<B>, channels: [u8; 3], found: &mut Passing) {
        let mut left = any(&channels);
        while left != 0 {
            let first = left.trailing_zeros() as usize;
            // the lanes that cross the same surface from the same media with the same channels do the same
            let (media, body, surface) = (packet.media[first], at.body[first], at.surface[first]);
            let mut group = B::equal(&packet.media, media) & B::equal(&at.body, body);
            group &= B::equal(&at.surface, surface) & left;
            for bits in [at.enters, at.leaves, channels[0], channels[1], channels[2]] {
                group &= if bits >> first & 1 == 1 { bits } else { !bits };
            }
            left &= !group;
            let (enters, leaves) = (at.enters >> first & 1 == 1, at.leaves >> first & 1 == 1);
            let beyond = if enters {
                self.stacks.entered(media, body, self.world.surface(surface).index)
            } else if leaves {
                self.stacks.left(media, body)
            } else {
                media
            };
            put_value(&mut found.beyond, group, beyond);
            let (n, n_prime) = (self.stacks.index(media), self.stacks.index(beyond));
            let sheet = !(enters || leaves);
            // the channels that begin a way
            let mut ways: ArrayVec<usize, WAYS> = ArrayVec::new();
            for channel in 0..3 {
                if channels[channel] & group == 0 {
                    continue;
                }
                let mut way = 0;
                while way < ways.len() && !sheet {
                    let begun = ways[way];
                    if n[begun] / n_prime[begun] == n[channel] / n_prime[channel] {
                        break;
                    }
                    way += 1;
                }
                if way == ways.len() {
                    ways.push(channel);
                    put_value(&mut found.ways[way].n, group, n[channel]);
                    put_value(&mut found.ways[way].n_prime, group, n_prime[channel]);
                }
                found.ways[way].channels[channel] |= group;
            }
        }
    }
}

/// Casts the mirrored and totally reflected rays of a block.
struct Reflect<'s, 'p, B: Backend> {
    path: &'s mut Path<'p>,
    block: &'s Block<B>,
    points: &'s [Points<B>],
    leaving: &'s PerPacket<Leaving>,
    mirrored: &'s mut [Colors<B>; PACKETS],
    refracted: &'s mut [Colors<B>; PACKETS],
}

impl<B: Backend> Step<B> for Reflect<'_, '_, B> {
    #[inline(always)]
    fn run(self) {
        let mut onward = Onward::<B>::new(RayKind::Reflected, self.block.level + 1);
        for (place, (packet, at)) in self.block.packets.iter().zip(self.points).enumerate() {
            let Leaving { mirrored, total, .. } = self.leaving[place];
            let either = [0, 1, 2].map(|channel: usize| mirrored[channel] | total[channel]);
            if any(&either) != 0 {
                onward.push(place, at, packet, mirrored_direction(packet, at), either, packet.media);
            }
        }
        let mut seen = [[B::Real::splat(0.0); 3]; PACKETS];
        onward.cast(self.path, &mut seen);
        for (&place, seen) in onward.from.iter().zip(&seen) {
            let Leaving { mirrored, total, .. } = &self.leaving[place];
            self.mirrored[place] = taken::<B>(mirrored, seen, &self.mirrored[place]);
            self.refracted[place] = taken::<B>(total, seen, &self.refracted[place]);
        }
    }
}

/// Casts the refracted rays of a block that go one way.
struct Refract<'s, 'p, B: Backend> {
    path: &'s mut Path<'p>,
    block: &'s Block<B>,
    points: &'s [Points<B>],
    passing: &'s PerPacket<Passing>,
    way: usize,
    refracted: &'s mut [Colors<B>; PACKETS],
}

impl<B: Backend> Step<B> for Refract<'_, '_, B> {
    #[inline(always)]
    fn run(self) {
        let mut onward = Onward::<B>::new(RayKind::Refracted, self.block.level + 1);
        for passing in self.passing {
            let way = &passing.ways[self.way];
            if any(&way.channels) != 0 {
                let (packet, at) = (&self.block.packets[passing.place], &self.points[passing.place]);
                let (_, direction) = refract::<B>(packet, at, way);
                onward.push(passing.place, at, packet, direction, way.channels, passing.beyond);
            }
        }
        let mut seen = [[B::Real::splat(0.0); 3]; PACKETS];
        onward.cast(self.path, &mut seen);
        for ((&place, seen), packet) in onward.from.iter().zip(&seen).zip(&onward.block.packets) {
            self.refracted[place] = taken::<B>(&packet.channels, seen, &self.refracted[place]);
        }
    }
}

/// Rays that are to be cast, and the packets of the block that they come from.
struct Onward<B: Backend> {
    block: Block<B>,
    from: PerPacket<usize>,
}

impl<B: Backend> Onward<B> {
    fn new(kind: RayKind, level: u32) -> Onward<B> {
        Onward { block: Block::new(kind, level, false), from: PerPacket::new() }
    }

    /// Adds the rays of a packet's points.
    #[inline(always)]
    fn push(
        &mut self,
        place: usize,
        at: &Points<B>,
        of: &Packet<B>,
        direction: Vector<B::Real>,
        channels: [u8; 3],
        media: [u32; 8],
    ) {
        self.block.packets.push(Packet {
            origin: at.point,
            direction: direction.normalize(),
            mask: any(&channels),
            channels,
            place: of.place,
            start: at.body,
            media,
        });
        self.from.push(place);
    }

    /// What the rays see.
    #[inline(always)]
    fn cast(&mut self, path: &mut Path<'_>, seen: &mut [Colors<B>; PACKETS]) {
        B::enter(Trace { path, block: &mut self.block, colors: seen });
    }
}

/// Adds the lanes whose rays carry a channel to those channels in which the coefficient is not 0.
#[inline(always)]
fn carry<B: Backend>(channels: &mut [u8; 3], packet: &Packet<B>, lanes: u8, coefficient: Rgb) {
    for channel in 0..3 {
        let counts = if coefficient[channel] > 0.0 { lanes } else { 0 };
        channels[channel] |= packet.channels[channel] & counts;
    }
}

/// The lanes of any channel.
#[inline(always)]
fn any(channels: &[u8; 3]) -> u8 {
    channels[0] | channels[1] | channels[2]
}

/// `R = I - 2(I·N)N`, mirrored out of a surface that it would enter.
#[inline(always)]
fn mirrored_direction<B: Backend>(packet: &Packet<B>, at: &Points<B>) -> Vector<B::Real> {
    let two = B::Real::splat(2.0);
    let incident = packet.direction;
    let direction = incident - at.normal * (two * incident.dot(at.normal));
    let inward = direction.dot(at.geometric).lt(B::Real::splat(0.0));
    if inward.bits() == 0 {
        return direction;
    }
    let outward = direction - at.geometric * (two * direction.dot(at.geometric));
    Vector::select(inward, outward, direction)
}

/// `T` and the lanes whose light is totally reflected (`reference::refract`).
#[inline(always)]
fn refract<B: Backend>(packet: &Packet<B>, at: &Points<B>, way: &Way) -> (u8, Vector<B::Real>) {
    let zero = B::Real::splat(0.0);
    let sheets = !(at.enters | at.leaves);
    let (n, n_prime) = (B::Real::load(&way.n), B::Real::load(&way.n_prime));
    let (incident, normal) = (packet.direction, at.geometric);
    let cosine = incident.dot(normal);
    let ratio = n_prime / n;
    let under_root = ratio * ratio + cosine * cosine - B::Real::splat(1.0);
    let reflected = under_root.lt(zero).bits() & !sheets;
    let refracted = (incident - normal * (cosine + under_root.sqrt())) * (n / n_prime);
    let straight = mask::<B::Real>(n.eq(n_prime).bits() | sheets);
    (reflected, Vector::select(straight, incident, refracted))
}

/// `seen` in the lanes of each channel, `otherwise` in the others.
#[inline(always)]
fn taken<B: Backend>(channels: &[u8; 3], seen: &Colors<B>, otherwise: &Colors<B>) -> Colors<B> {
    if channels[0] == channels[1] && channels[1] == channels[2] {
        return select::<B>(mask::<B::Real>(channels[0]), seen, otherwise);
    }
    let mut taken = *otherwise;
    for channel in 0..3 {
        taken[channel] = B::Real::select(mask::<B::Real>(channels[channel]), seen[channel], otherwise[channel]);
    }
    taken
}
