//! The recursion over blocks of rays: as the reference's, term by term, with the rays of all lanes that have one.

use super::dispatch::{Backend, Step};
use super::hidden_surfaces::Nearest;
use super::lanes::{Mask, Real};
use super::light::{add, add_lamp, clamp01, select, splat};
use super::media::Stacks;
use super::packet::{Block, Colors, Hits, PACKETS, PerPacket};
use super::shadows::{Blocked, Segments, ToLamp};
use super::surface_point::Points;
use super::vector::{Vector, mask};
use crate::{Cancel, RayCounts, RayKind, Settings, World};
use arrayvec::ArrayVec;
use lancer_scene::Rgb;

/// What all rays of one block of pixels share.
#[derive(Debug)]
pub(super) struct Path<'t> {
    pub(super) world: &'t World,
    pub(super) settings: Settings,
    pub(super) cancel: &'t Cancel,
    /// The spheres and planes that the eye lies on.
    pub(super) eye_lies_on: &'t [u32],
    pub(super) stacks: Stacks,
    pub(super) counts: RayCounts,
    /// The rays that each pixel has cost.
    pub(super) rays: [[f64; 8]; PACKETS],
    /// The pixels, by packet, that have cost too much: nothing more is traced for them.
    pub(super) spent: [u8; PACKETS],
    pub(super) cancelled: bool,
    /// Blocks since the flag was looked at.
    pub(super) blocks: u32,
}

/// How many blocks of rays pass between two looks at the flag.
const POLL: u32 = 16;

/// The lanes of one packet that have one surface.
pub(super) type Groups = ArrayVec<(u32, u8), 8>;

impl Path<'_> {
    /// Counts rays against the budgets of their pixels; gives those that may be traced.
    #[inline(always)]
    fn spend<B: Backend>(&mut self, place: usize, wanted: u8) -> u8 {
        let wanted = wanted & !self.spent[place];
        let (zero, one) = (B::Real::splat(0.0), B::Real::splat(1.0));
        let rays = B::Real::load(&self.rays[place]) + B::Real::select(mask::<B::Real>(wanted), one, zero);
        self.rays[place] = rays.store();
        let over = rays.gt(B::Real::splat(self.settings.max_rays as f64)).bits() & wanted;
        self.spent[place] |= over;
        wanted & !over
    }

    /// Looks at the flag now and then.
    #[inline(always)]
    fn poll(&mut self) {
        self.blocks += 1;
        if self.blocks >= POLL {
            self.blocks = 0;
            self.cancelled |= self.cancel.is_cancelled();
        }
    }

    /// The colours that the rays of a block see, in their channels.
    #[inline(always)]
    pub(super) fn colors<B: Backend>(&mut self, block: &mut Block<B>, colors: &mut [Colors<B>; PACKETS]) {
        let world = self.world;
        self.poll();
        let mut cast = 0;
        for packet in &mut block.packets {
            packet.mask = if self.cancelled { 0 } else { self.spend::<B>(packet.place, packet.mask) };
            cast += u64::from(packet.mask.count_ones());
        }
        match block.kind {
            RayKind::Primary => self.counts.primary += cast,
            RayKind::Reflected => self.counts.reflected += cast,
            RayKind::Refracted => self.counts.refracted += cast,
        }
        let mut points = [Points::<B>::none(); PACKETS];
        let points = &mut points[..block.packets.len()];
        B::enter(See { world, eye_lies_on: self.eye_lies_on, block, points: &mut *points });
        let points = &*points;
        if block.level == 0 {
            self.counts.primary_hits += points.iter().map(|points| u64::from(points.mask.count_ones())).sum::<u64>();
        }
        let mut groups: PerPacket<Groups> = PerPacket::new();
        for points in points {
            groups.push(grouped(points));
        }

        let mark = self.stacks.mark();
        let zero = [B::Real::splat(0.0); 3];
        let (mut mirrored, mut refracted) = ([zero; PACKETS], [zero; PACKETS]);
        self.secondary(block, points, &groups, &mut mirrored, &mut refracted);
        self.stacks.forget(mark);

        let environment = world.environment();
        let mut sums = [zero; PACKETS];
        for (place, points) in points.iter().enumerate() {
            let mut sum = zero;
            for &(surface, group) in &groups[place] {
                let surface = world.surface(surface);
                let mut own = add::<B>(environment.compose, &zero, &splat::<B>(surface.ka * environment.ambient));
                // a term of 0 changes no bit of a sum
                if surface.is_mirror() {
                    own = add::<B>(environment.compose, &own, &scaled::<B>(surface.kr, &mirrored[place]));
                }
                if surface.is_transparent() {
                    own = add::<B>(environment.compose, &own, &scaled::<B>(surface.kt, &refracted[place]));
                }
                sum = if group == points.mask { own } else { select::<B>(mask::<B::Real>(group), &own, &sum) };
            }
            sums[place] = sum;
        }
        if !world.lamps().is_empty() {
            B::enter(Lamps { path: self, block, points, groups: &groups, sums: &mut sums });
        }

        let background = splat::<B>(environment.background);
        for (((packet, points), sum), seen_color) in block.packets.iter().zip(points).zip(&sums).zip(colors) {
            let seen = [clamp01(sum[0]), clamp01(sum[1]), clamp01(sum[2])];
            let mut color = select::<B>(mask::<B::Real>(points.mask), &seen, &background);
            for channel in 0..3 {
                let carried = packet.channels[channel];
                if packet.mask & !carried != 0 {
                    color[channel] = B::Real::select(mask::<B::Real>(carried), color[channel], zero[channel]);
                }
            }
            *seen_color = color;
        }
    }

    /// Adds what the lamps give (subject §1.2, §2.2, §2.3).
    #[inline(always)]
    fn lamps<B: Backend>(
        &mut self,
        block: &Block<B>,
        points: &[Points<B>],
        groups: &PerPacket<Groups>,
        sums: &mut [Colors<B>; PACKETS],
    ) {
        let world = self.world;
        let compose = world.environment().compose;
        let zero = B::Real::splat(0.0);
        // in place, and what all lamps have in common once: packets are large
        let mut rays = [ToLamp::<B>::none(); PACKETS];
        let rays = &mut rays[..points.len()];
        for (ray, at) in rays.iter_mut().zip(points) {
            if at.mask != 0 {
                ray.start_at(world, at.point, &at.body);
            }
        }
        for lamp in world.lamps() {
            let position = Vector::splat(lamp.position);
            let farthest = B::Real::splat(lamp.position.abs().max_element());
            let mut any = 0;
            for ((packet, at), ray) in block.packets.iter().zip(points).zip(rays.iter_mut()) {
                ray.packet.mask = 0;
                if at.mask == 0 {
                    continue;
                }
                let segment = position - at.point;
                // a lamp in the surface's own plane is not in front of it, however N·L rounds
                let roundings = B::Real::splat(16.0 * f64::EPSILON) * farthest.max(at.point.greatest());
                let in_front = at.geometric.dot(segment).gt(roundings).bits() & at.mask & !self.spent[packet.place];
                if in_front == 0 {
                    continue;
                }
                let distance = segment.length();
                let to_lamp = segment.divided(distance);
                let mut lit = in_front & at.normal.dot(to_lamp).gt(zero).bits() & !distance.eq(zero).bits();
                if self.settings.steps.shadows {
                    lit = self.spend::<B>(packet.place, lit);
                    self.counts.shadow += u64::from(lit.count_ones());
                }
                (ray.packet.direction, ray.packet.mask, ray.distance) = (to_lamp, lit, distance);
                any |= lit;
            }
            if any == 0 {
                continue;
            }
            let mut blocked = [0; PACKETS];
            if self.settings.steps.shadows {
                let of_neighbours = block.from_one_point;
                let segments = Segments { lamp: lamp.position, rays: &*rays, of_neighbours };
                B::enter(Blocked { world, segments, blocked: &mut blocked });
            }
            for (place, (ray, blocked)) in rays.iter().zip(&blocked).enumerate() {
                let lit = ray.packet.mask & !blocked;
                if lit == 0 {
                    continue;
                }
                for &(surface, group) in &groups[place] {
                    if lit & group == 0 {
                        continue;
                    }
                    let directions = [points[place].normal, ray.packet.direction, -block.packets[place].direction];
                    let surface = world.surface(surface);
                    let sum = add_lamp::<B>(compose, &sums[place], surface, directions, lamp.color);
                    sums[place] = select::<B>(mask::<B::Real>(lit & group), &sum, &sums[place]);
                }
            }
        }
    }
}

/// The surfaces of a packet's points.
#[inline(always)]
fn grouped<B: Backend>(points: &Points<B>) -> Groups {
    let mut groups = Groups::new();
    let mut left = points.mask;
    while left != 0 {
        let surface = points.surface[left.trailing_zeros() as usize];
        let group = left & B::equal(&points.surface, surface);
        groups.push((surface, group));
        left &= !group;
    }
    groups
}

/// A coefficient times a colour.
#[inline(always)]
fn scaled<B: Backend>(coefficient: Rgb, color: &Colors<B>) -> Colors<B> {
    let mut product = *color;
    for channel in 0..3 {
        product[channel] = B::Real::splat(coefficient[channel]) * color[channel];
    }
    product
}

/// [`Path::colors`].
pub(super) struct Trace<'s, 'p, B: Backend> {
    pub(super) path: &'s mut Path<'p>,
    pub(super) block: &'s mut Block<B>,
    pub(super) colors: &'s mut [Colors<B>; PACKETS],
}

impl<B: Backend> Step<B> for Trace<'_, '_, B> {
    #[inline(always)]
    fn run(self) {
        self.path.colors(self.block, self.colors);
    }
}

/// [`Path::lamps`].
struct Lamps<'s, 'p, B: Backend> {
    path: &'s mut Path<'p>,
    block: &'s Block<B>,
    points: &'s [Points<B>],
    groups: &'s PerPacket<Groups>,
    sums: &'s mut [Colors<B>; PACKETS],
}

impl<B: Backend> Step<B> for Lamps<'_, '_, B> {
    #[inline(always)]
    fn run(self) {
        self.path.lamps(self.block, self.points, self.groups, self.sums);
    }
}

/// The points that a block of rays sees.
struct See<'s, B: Backend> {
    world: &'s World,
    eye_lies_on: &'s [u32],
    block: &'s Block<B>,
    points: &'s mut [Points<B>],
}

impl<B: Backend> Step<B> for See<'_, B> {
    #[inline(always)]
    fn run(self) {
        let mut hits: PerPacket<Hits<B>> = PerPacket::new();
        let See { world, eye_lies_on, block, points } = self;
        B::enter(Nearest { world, eye_lies_on, block, hits: &mut hits });
        for ((packet, hits), points) in block.packets.iter().zip(&hits).zip(points) {
            let met = hits.t.lt(B::Real::splat(f64::INFINITY)).bits() & packet.mask;
            points.find(world, packet, hits, met);
        }
    }
}
