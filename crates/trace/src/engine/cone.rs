//! Eight rays and a cone: the operations of `reference::intersect::cone` in their order, lane by lane.
//!
//! Each use is a step of its own, so that the loops over bodies, which mostly hold other shapes, stay small.

use super::dispatch::{Backend, Step};
use super::lanes::{Lanes, Mask, Real};
use super::packet::{Block, Hits, PACKETS, Packet, PerPacket};
use super::shadows::{Segments, ToLamp};
use super::vector::{Vector, mask};
use crate::reference::intersect::Cone;
use lancer_scene::ConeFace;

const SIDE: usize = ConeFace::Side.number() as usize;
const BASE: usize = ConeFace::Base.number() as usize;
const TOP: usize = ConeFace::Top.number() as usize;

/// The ends of the chords, and the lanes in which each face is met there.
struct Ends<L: Lanes> {
    enter: L::Real,
    leave: L::Real,
    entered: [u8; 3],
    left: [u8; 3],
}

/// Where rays meet a cone.
struct ConeHits<L: Lanes> {
    /// The lanes that meet each face.
    faces: [u8; 3],
    t: L::Real,
    /// The other end of each chord.
    other: L::Real,
}

/// The hits of a packet's rays, those of `starts_here` starting on the cone (`reference::intersect_cone`).
#[inline(always)]
fn cone_hits<L: Lanes>(packet: &Packet<L>, cone: &Cone, starts_here: u8) -> ConeHits<L> {
    let zero = L::Real::splat(0.0);
    let Ends { enter, leave, entered, left } = ends::<L>(packet.origin, packet.direction, cone);
    let is_entered = entered[SIDE] | entered[BASE] | entered[TOP];
    let here = starts_here & (enter + leave).gt(zero).bits();
    let first = is_entered & enter.gt(zero).bits() & !starts_here;
    let second = leave.gt(zero).bits() & !first & !starts_here | here;
    let mut faces = [0; 3];
    for face in 0..3 {
        faces[face] = entered[face] & first | left[face] & second;
    }
    let takes_first = mask::<L::Real>(first);
    let (t, other) = (L::Real::select(takes_first, enter, leave), L::Real::select(takes_first, leave, enter));
    ConeHits { faces, t, other }
}

/// Tries a cone with some rays of each packet of a block.
pub(super) struct NearestOnCone<'s, B: Backend> {
    pub(super) cone: &'s Cone,
    pub(super) body: u32,
    pub(super) eye_lies_on: &'s [u32],
    pub(super) block: &'s Block<B>,
    pub(super) hits: &'s mut PerPacket<Hits<B>>,
    pub(super) rays: &'s [u8; PACKETS],
}

impl<B: Backend> Step<B> for NearestOnCone<'_, B> {
    #[inline(always)]
    fn run(self) {
        let NearestOnCone { cone, body, eye_lies_on, block, hits, rays } = self;
        for (place, packet) in block.packets.iter().enumerate() {
            if rays[place] != 0 {
                let found = cone_hits::<B>(packet, cone, packet.starts_on(body, eye_lies_on));
                for (face, met) in (0..).zip(found.faces) {
                    hits[place].take(met & rays[place], found.t, None, body, face);
                }
            }
        }
    }
}

/// Finds the rays to a lamp that meet a cone before it.
pub(super) struct BlockedByCone<'s, B: Backend> {
    pub(super) cone: &'s Cone,
    pub(super) body: u32,
    pub(super) segments: Segments<'s, B>,
    pub(super) blocked: &'s mut [u8; PACKETS],
    pub(super) asked: &'s [u8; PACKETS],
}

impl<B: Backend> Step<B> for BlockedByCone<'_, B> {
    #[inline(always)]
    fn run(self) {
        let BlockedByCone { cone, body, segments: Segments { lamp, rays, .. }, blocked, asked } = self;
        for (place, ToLamp { packet, distance, .. }) in rays.iter().enumerate() {
            let open = asked[place] & !blocked[place];
            if open != 0 {
                let ConeHits { faces, t, other } = cone_hits::<B>(packet, cone, packet.starts_on(body, &[]));
                let mut met = (faces[SIDE] | faces[BASE] | faces[TOP]) & open & t.lt(*distance).bits();
                if met != 0 && cone.lies_on(lamp) {
                    // the lamp's own place on the cone is no hit (`Cone::is_at_lamp`)
                    met &= !(*distance - t).abs().le((*distance - other).abs()).bits();
                }
                blocked[place] |= met;
            }
        }
    }
}

/// `Cone::ends`.
#[inline(always)]
fn ends<L: Lanes>(origin: Vector<L::Real>, direction: Vector<L::Real>, cone: &Cone) -> Ends<L> {
    let (zero, infinity) = (L::Real::splat(0.0), L::Real::splat(f64::INFINITY));
    let axis = Vector::splat(cone.axis);
    let slope = L::Real::splat(cone.slope);
    let (low, high) = (L::Real::splat(cone.low), L::Real::splat(cone.high));

    let to_base = Vector::splat(cone.base) - origin;
    let shift = direction.dot(to_base + axis * L::Real::splat(cone.height * 0.5));
    let near = direction * shift - to_base;
    let (z, dz) = (near.dot(axis), direction.dot(axis));
    let (beside, sideways) = (near - axis * z, direction - axis * dz);
    let (radius, growth) = (L::Real::splat(cone.radius) + slope * z, slope * dz);
    let a = sideways.dot(sideways) - growth * growth;
    let b = sideways.dot(beside) - growth * radius;
    let c = beside.dot(beside) - radius * radius;
    let delta = b * b - a * c;
    let two_roots = delta.gt(zero);
    let steep = a.lt(zero);
    // most rays pass beside it: without roots, and not down the axis
    if (two_roots | steep | (a.eq(zero) & b.eq(zero))).bits() == 0 {
        return Ends { enter: infinity, leave: -infinity, entered: [0; 3], left: [0; 3] };
    }
    let root = L::Real::select(two_roots, delta.sqrt(), zero);
    let q = L::Real::select(b.gt(zero), -(b + root), root - b);
    let first = q / a;
    let second = L::Real::select(two_roots, c / q, first);
    let ordered = first.lt(second);
    let near_root = L::Real::select(ordered, first, second);
    let far_root = L::Real::select(ordered, second, first);

    let chord = !steep & two_roots & (radius * a - growth * b).gt(zero);
    let along = !steep & !chord & a.eq(zero) & b.eq(zero) & c.lt(zero);
    let grows = steep & growth.gt(zero);
    let shrinks = steep & !growth.gt(zero);
    // nowhere, unless one of the four cases holds
    let enter = L::Real::select(chord, near_root, infinity);
    let enter = L::Real::select(grows, far_root, enter);
    let enter = L::Real::select(shrinks | along, -infinity, enter);
    let leave = L::Real::select(chord, far_root, -infinity);
    let leave = L::Real::select(shrinks, near_root, leave);
    let leave = L::Real::select(grows | along, infinity, leave);

    if !cone.capped {
        let (at_enter, at_leave) = (z + enter * dz, z + leave * dz);
        let entered = (enter.abs().lt(infinity) & low.le(at_enter) & at_enter.le(high)).bits();
        let left = (leave.abs().lt(infinity) & low.le(at_leave) & at_leave.le(high)).bits();
        return Ends { enter: enter + shift, leave: leave + shift, entered: [entered, 0, 0], left: [left, 0, 0] };
    }
    let (to_low, to_high) = ((low - z) / dz, (high - z) / dz);
    let upwards = dz.gt(zero);
    let (first, last) = (L::Real::select(upwards, to_low, to_high), L::Real::select(upwards, to_high, to_low));
    let level = dz.eq(zero);
    let between = low.lt(z) & z.lt(high);
    let unlimited = L::Real::select(between, -infinity, infinity);
    let first = L::Real::select(level, unlimited, first);
    let last = L::Real::select(level, -unlimited, last);
    let (by_first, by_last) = (first.gt(enter), last.lt(leave));
    let enter = L::Real::select(by_first, first, enter);
    let leave = L::Real::select(by_last, last, leave);
    let met = enter.lt(leave).bits();
    let (by_first, by_last, upwards) = (by_first.bits(), by_last.bits(), upwards.bits());
    Ends {
        enter: enter + shift,
        leave: leave + shift,
        entered: [met & !by_first, met & by_first & upwards, met & by_first & !upwards],
        left: [met & !by_last, met & by_last & !upwards, met & by_last & upwards],
    }
}

/// The points and outward normals of what was seen on a cone, a face a lane (`reference`'s `Cone::surface_point`).
pub(super) struct PointsOnCone<'s, L: Lanes> {
    pub(super) cone: &'s Cone,
    pub(super) seen: Vector<L::Real>,
    pub(super) faces: &'s [u32; 8],
    pub(super) point: &'s mut Vector<L::Real>,
    pub(super) normal: &'s mut Vector<L::Real>,
}

impl<B: Backend> Step<B> for PointsOnCone<'_, B> {
    #[inline(always)]
    fn run(self) {
        let (cone, seen, one, zero) = (self.cone, self.seen, B::Real::splat(1.0), B::Real::splat(0.0));
        let axis = Vector::splat(cone.axis);
        let (slope, cosine) = (B::Real::splat(cone.slope), B::Real::splat(cone.cosine));
        let from_base = seen - Vector::splat(cone.base);
        let z = from_base.dot(axis);
        let beside = from_base - axis * z;
        let distance = beside.length();
        let normal = (beside * (one / distance) - axis * slope) * cosine;
        let at_tip = if cone.slope < 0.0 { axis } else { -axis };
        let normal = Vector::select(distance.gt(zero), normal, at_tip);
        let too_far = (distance - (B::Real::splat(cone.radius) + slope * z)) * cosine;
        let (on_base, on_top) =
            (B::equal(self.faces, ConeFace::Base.number()), B::equal(self.faces, ConeFace::Top.number()));
        let (on_base, on_top) = (mask::<B::Real>(on_base), mask::<B::Real>(on_top));
        let point = Vector::select(on_base, seen - axis * z, seen - normal * too_far);
        *self.point = Vector::select(on_top, seen - axis * (z - B::Real::splat(cone.height)), point);
        *self.normal = Vector::select(on_top, axis, Vector::select(on_base, -axis, normal));
    }
}
