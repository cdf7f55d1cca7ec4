//! Rays by themselves, without light: distances and shadows of many rays at once.

use super::dispatch::{Backend, Simd, Step, enter};
use super::hidden_surfaces::Nearest;
use super::lanes::{Mask, Real};
use super::packet::{Block, Hits, NOTHING, PACKETS, Packet, PerPacket};
use super::shadows::{Blocked, Segments, ToLamp};
use super::vector::Vector;
use crate::{Ray, RayKind, World};
use glam::DVec3;

/// Casts rays that start in free space.
#[derive(Clone, Copy, Debug)]
pub struct Caster<'w> {
    world: &'w World,
    simd: Simd,
}

impl Caster<'_> {
    /// A caster of rays into a world. `simd` should be available; else the best that is takes its place.
    pub fn new(world: &World, simd: Simd) -> Caster<'_> {
        Caster { world, simd }
    }

    /// The distance of the nearest hit of each ray, infinite where it meets nothing.
    pub fn nearest(&self, rays: &[Ray], distances: &mut Vec<f64>) {
        distances.clear();
        distances.resize(rays.len(), f64::INFINITY);
        for (rays, distances) in rays.chunks(8 * PACKETS).zip(distances.chunks_mut(8 * PACKETS)) {
            cast(self.simd, Cast { world: self.world, rays, distances });
        }
    }

    /// Whether something stands between a lamp and each of the points.
    pub fn blocked(&self, lamp: DVec3, points: &[DVec3], blocked: &mut Vec<bool>) {
        blocked.clear();
        blocked.resize(points.len(), false);
        for (points, blocked) in points.chunks(8 * PACKETS).zip(blocked.chunks_mut(8 * PACKETS)) {
            ask(self.simd, Ask { world: self.world, lamp, points, blocked });
        }
    }
}

/// Not inlined elsewhere, so that the backends are compiled here and once; so is the next one.
#[inline(never)]
fn cast(simd: Simd, cast: Cast<'_>) {
    enter(simd, cast);
}

#[inline(never)]
fn ask(simd: Simd, ask: Ask<'_>) {
    enter(simd, ask);
}

/// Eight rays as a packet.
#[inline(always)]
fn packet<B: Backend>(place: usize, origins: &[[f64; 8]; 3], directions: &[[f64; 8]; 3], count: usize) -> Packet<B> {
    Packet {
        origin: Vector::load(origins),
        direction: Vector::load(directions),
        mask: 0xff >> (8 - count),
        channels: [0xff; 3],
        place,
        start: [NOTHING; 8],
        media: [0; 8],
    }
}

/// At most sixty-four rays.
struct Cast<'s> {
    world: &'s World,
    rays: &'s [Ray],
    distances: &'s mut [f64],
}

impl<B: Backend> Step<B> for Cast<'_> {
    #[inline(always)]
    fn run(self) {
        let from_one_point = self.rays.iter().all(|ray| ray.origin == self.rays[0].origin);
        let mut block: Block<B> = Block::new(RayKind::Primary, 0, from_one_point);
        for (place, rays) in self.rays.chunks(8).enumerate() {
            let (mut origins, mut directions) = ([[0.0; 8]; 3], [[1.0; 8]; 3]);
            for (lane, ray) in rays.iter().enumerate() {
                for axis in 0..3 {
                    origins[axis][lane] = ray.origin[axis];
                    directions[axis][lane] = ray.direction[axis];
                }
            }
            block.packets.push(packet(place, &origins, &directions, rays.len()));
        }
        let mut hits: PerPacket<Hits<B>> = PerPacket::new();
        B::enter(Nearest { world: self.world, eye_lies_on: &[], block: &block, hits: &mut hits });
        for (hits, distances) in hits.iter().zip(self.distances.chunks_mut(8)) {
            distances.iter_mut().zip(hits.t.store()).for_each(|(distance, t)| *distance = t);
        }
    }
}

/// At most sixty-four points.
struct Ask<'s> {
    world: &'s World,
    lamp: DVec3,
    points: &'s [DVec3],
    blocked: &'s mut [bool],
}

impl<B: Backend> Step<B> for Ask<'_> {
    #[inline(always)]
    fn run(self) {
        let mut rays: PerPacket<ToLamp<B>> = PerPacket::new();
        for points in self.points.chunks(8) {
            let mut origins = [[0.0; 8]; 3];
            for (lane, point) in points.iter().enumerate() {
                for axis in 0..3 {
                    origins[axis][lane] = point[axis];
                }
            }
            let mut ray = ToLamp::<B>::none();
            ray.start_at(self.world, Vector::load(&origins), &[NOTHING; 8]);
            let segment = Vector::splat(self.lamp) - ray.packet.origin;
            ray.distance = segment.length();
            ray.packet.direction = segment.divided(ray.distance);
            ray.packet.mask = (0xff >> (8 - points.len())) & ray.distance.gt(B::Real::splat(0.0)).bits();
            rays.push(ray);
        }
        let mut bits = [0; PACKETS];
        let segments = Segments { lamp: self.lamp, rays: &rays, of_neighbours: true };
        B::enter(Blocked { world: self.world, segments, blocked: &mut bits });
        for (bits, blocked) in bits.iter().zip(self.blocked.chunks_mut(8)) {
            blocked.iter_mut().enumerate().for_each(|(lane, blocked)| *blocked = bits >> lane & 1 == 1);
        }
    }
}
