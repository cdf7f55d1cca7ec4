//! Whether anything stands between points and a lamp (subject §1.2), for a block of points at once.
//!
//! Boxes are culled for rays from the lamp: they have their start in common, so a beam of them is narrow where it begins.
//! What is left is decided for the rays from the points, as the reference does.

use super::dispatch::{Backend, Step};
use super::facets_blocking::OnFacets;
use super::hidden_surfaces::UPWARDS;
use super::intersect::{plane, sphere};
use super::lanes::{Lanes, Mask, Real, Single};
use super::packet::{Packet, PerPacket};
use super::vector::{Vector, lanes};
use crate::World;
use crate::bvh::{Beam, Visit};
use crate::precision::{lies_in_plane, lies_on_sphere};
use crate::world::Geometry;
use glam::DVec3;

/// Rays from points to a lamp: `packet.mask` are the points that ask.
#[derive(Clone, Copy)]
pub(super) struct ToLamp<L: Lanes> {
    pub(super) packet: Packet<L>,
    pub(super) distance: L::Real,
}

/// Finds the lanes of each packet whose rays meet a body before the lamp.
pub(super) struct Blocked<'s, B: Backend> {
    pub(super) world: &'s World,
    pub(super) lamp: DVec3,
    pub(super) rays: &'s PerPacket<ToLamp<B>>,
    /// One for each packet.
    pub(super) blocked: &'s mut PerPacket<u8>,
}

impl<B: Backend> Step<B> for Blocked<'_, B> {
    #[inline(always)]
    fn run(self) {
        blocked(self.world, self.lamp, self.rays, self.blocked);
    }
}

#[inline(always)]
fn blocked<L: Backend>(world: &World, lamp: DVec3, rays: &PerPacket<ToLamp<L>>, blocked: &mut PerPacket<u8>) {
    blocked.clear();
    for _ in rays {
        blocked.push(0);
    }
    for &number in world.unbounded() {
        if let Geometry::Plane { p0, p1, p2, .. } = &world.body(number).geometry {
            if lies_in_plane(lamp, *p0, *p1, *p2) {
                continue;
            }
            let normal = (p1 - p0).cross(p2 - p0);
            for (ray, blocked) in rays.iter().zip(blocked.iter_mut()) {
                let tried = ray.packet.mask & !*blocked & !ray.packet.starts_on(number, &[]);
                if tried != 0 {
                    let (met, t) = plane::<L>(ray.packet.origin, ray.packet.direction, *p0, normal);
                    *blocked |= met & tried & t.lt(ray.distance).bits();
                }
            }
        }
    }
    let (bvh, bodies) = world.bounded();
    let mut beam = Beam::new(bvh, bvh.margin());
    for (ray, blocked) in rays.iter().zip(blocked.iter()) {
        let open = ray.packet.mask & !blocked;
        let from_lamp = (Vector::splat(lamp), -ray.packet.direction);
        beam.push(from_lamp.0, from_lamp, open, ray.farthest(open));
    }
    beam.traverse(&mut Bodies { world, bodies, lamp, rays, blocked });
}

impl<L: Lanes> ToLamp<L> {
    /// How far some rays look: no more if there are none.
    #[inline(always)]
    pub(super) fn limit(&self, lanes: u8) -> f32 {
        if lanes == 0 { -1.0 } else { self.farthest(lanes) }
    }

    /// An f32 bound of the distances of some lanes.
    #[inline(always)]
    fn farthest(&self, lanes: u8) -> f32 {
        let wanted = <L::Single as Single>::Mask::from_bits(lanes);
        L::Single::select(wanted, L::narrow(self.distance), L::Single::splat(0.0)).greatest() * UPWARDS
    }
}

/// Tries the bodies of leaves.
struct Bodies<'v, L: Lanes> {
    world: &'v World,
    bodies: &'v [u32],
    lamp: DVec3,
    rays: &'v PerPacket<ToLamp<L>>,
    blocked: &'v mut PerPacket<u8>,
}

impl<L: Backend> Visit<L> for Bodies<'_, L> {
    #[inline(always)]
    fn limit(&self, packet: usize, lanes: u8) -> f32 {
        self.rays[packet].limit(lanes & !self.blocked[packet])
    }

    #[inline(always)]
    fn leaf(&mut self, beam: &mut Beam<'_, L>, first: u32, count: u32, packets: u8) {
        for &number in &self.bodies[first as usize..(first + count) as usize] {
            match &self.world.body(number).geometry {
                Geometry::Sphere { center, radius } => {
                    for place in lanes(packets) {
                        let ToLamp { packet, distance } = &self.rays[place];
                        let here = packet.starts_on(number, &[]);
                        let (met, t) = sphere::<L>(packet.origin, packet.direction, *center, *radius, here);
                        let mut met = met & packet.mask & t.lt(*distance).bits();
                        if met != 0 && lies_on_sphere(self.lamp, *center, *radius) {
                            // the lamp's own place on the sphere is no hit: which of the two is nearer?
                            let between = packet.direction.dot(Vector::splat(*center - self.lamp)).abs();
                            met &= !(*distance - t).le(between).bits();
                        }
                        self.blocked[place] |= met;
                        beam.shorten(place, self.limit(place, beam.packets[place].mask));
                    }
                }
                Geometry::Facets(facets) => {
                    let (lamp, rays) = (self.lamp, self.rays);
                    L::enter(OnFacets { facets, body: number, lamp, rays, blocked: self.blocked, beam, packets });
                    for place in lanes(packets) {
                        beam.shorten(place, self.limit(place, beam.packets[place].mask));
                    }
                }
                // planes have no bounds
                Geometry::Plane { .. } => {}
            }
        }
    }
}
