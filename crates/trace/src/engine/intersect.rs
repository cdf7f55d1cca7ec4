//! Where eight rays meet one primitive: the reference's operations in the reference's order, lane by lane.

use super::lanes::{Lanes, Mask, Real};
use super::vector::{Vector, mask};
use glam::DVec3;

/// The distances to a sphere (`reference::intersect_sphere`), and the lanes that meet it. Rays of `starts_here` start on it.
#[inline(always)]
pub(super) fn sphere<L: Lanes>(
    origin: Vector<L::Real>,
    direction: Vector<L::Real>,
    center: DVec3,
    radius: f64,
    starts_here: u8,
) -> (u8, L::Real) {
    let zero = L::Real::splat(0.0);
    let sc = Vector::splat(center) - origin;
    let q = direction.dot(sc);
    let beside = sc - direction * q;
    let delta = L::Real::splat(radius * radius) - beside.dot(beside);
    let crosses = delta.gt(zero).bits();
    if crosses == 0 {
        return (0, zero);
    }
    let root = delta.sqrt();
    let (first, second) = (q - root, q + root);
    let outside = first.gt(zero);
    let elsewhere = crosses & (outside.bits() | second.gt(zero).bits()) & !starts_here;
    let here = crosses & q.gt(zero).bits() & starts_here;
    let takes_first = mask::<L::Real>(outside.bits() & !starts_here);
    (elsewhere | here, L::Real::select(takes_first, first, second))
}

/// The distances to a plane (`reference::intersect_plane`), and the lanes that meet it; `normal` is `P0P1 × P0P2`.
#[inline(always)]
pub(super) fn plane<L: Lanes>(
    origin: Vector<L::Real>,
    direction: Vector<L::Real>,
    p0: DVec3,
    normal: DVec3,
) -> (u8, L::Real) {
    let zero = L::Real::splat(0.0);
    let normal = Vector::splat(normal);
    let determinant = direction.dot(normal);
    let gamma = (Vector::splat(p0) - origin).dot(normal) / determinant;
    (gamma.gt(zero).bits() & !determinant.eq(zero).bits(), gamma)
}

/// Where rays meet a facet.
#[derive(Clone, Copy)]
pub(super) struct FacetHits<L: Lanes> {
    pub(super) lanes: u8,
    pub(super) t: L::Real,
    pub(super) alpha: L::Real,
    pub(super) beta: L::Real,
}

/// The hits of a facet (`reference::intersect_facet`).
#[inline(always)]
pub(super) fn facet<L: Lanes>(
    origin: Vector<L::Real>,
    direction: Vector<L::Real>,
    [p0, p1, p2]: [DVec3; 3],
) -> FacetHits<L> {
    let normal = (p1 - p0).cross(p2 - p0);
    volumes(origin, direction, [Vector::splat(p0), Vector::splat(p1), Vector::splat(p2)], Vector::splat(normal))
}

/// The same with a facet for each ray.
#[inline(always)]
pub(super) fn facet_each<L: Lanes>(
    origin: Vector<L::Real>,
    direction: Vector<L::Real>,
    corners: [Vector<L::Real>; 3],
) -> FacetHits<L> {
    let [p0, p1, p2] = corners;
    volumes(origin, direction, corners, (p1 - p0).cross(p2 - p0))
}

#[inline(always)]
fn volumes<L: Lanes>(
    origin: Vector<L::Real>,
    direction: Vector<L::Real>,
    [p0, p1, p2]: [Vector<L::Real>; 3],
    normal: Vector<L::Real>,
) -> FacetHits<L> {
    let zero = L::Real::splat(0.0);
    let determinant = direction.dot(normal);
    let (a, b, c) = (p0 - origin, p1 - origin, p2 - origin);
    let (rest, alpha, beta) = (edge(direction, b, c), edge(direction, c, a), edge(direction, a, b));
    let inside = (rest.ge(zero) & alpha.ge(zero) & beta.ge(zero)) | (rest.le(zero) & alpha.le(zero) & beta.le(zero));
    let sum = rest + alpha + beta;
    let t = a.dot(normal) / determinant;
    let lanes = inside.bits() & !sum.eq(zero).bits() & !determinant.eq(zero).bits() & t.gt(zero).bits();
    FacetHits { lanes, t, alpha: alpha / sum, beta: beta / sum }
}

/// `reference`'s edge function.
#[inline(always)]
fn edge<R: Real>(direction: Vector<R>, a: Vector<R>, b: Vector<R>) -> R {
    direction.dot((a - b).cross(a + b))
}
