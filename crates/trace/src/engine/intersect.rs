//! Where eight rays meet one primitive: the reference's operations in the reference's order, lane by lane.

use super::lanes::{Lanes, Mask, Real, Single};
use super::vector::{Vector, mask};
use crate::bvh::{Block, Shadow};
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
    let zero = L::Real::splat(0.0);
    let normal = Vector::splat((p1 - p0).cross(p2 - p0));
    let determinant = direction.dot(normal);
    let a = Vector::splat(p0) - origin;
    let b = Vector::splat(p1) - origin;
    let c = Vector::splat(p2) - origin;
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

/// How far an edge function of the filter can be off, over direction, coordinates and reach: 2⁻¹⁵.
///
/// With `u = 2⁻²⁴`, `R` the sum of the greatest coordinates of a ray's start and of the corners, and reach `A` (no corner is
/// farther than `A` from the start along any axis): corners and start are rounded to `uR` together, so their difference
/// is off by `2uR`, a sum or difference of two of those by `6uR`, a component of a product by `2·(2·2A·6uR + 4uA²) + 8uA²`
/// `≤ 64uAR`, and the scalar product with a direction of components at most `D` by `3·64uDAR + 72uDA² ≤ 264uDAR < 512u·DAR`.
const SLACK: f32 = 1.0 / 32_768.0;

/// The lanes whose rays may meet a facet of a block, leaving out none that do.
#[inline(always)]
pub(super) fn may_meet<L: Lanes>(rays: &Shadow<L>, reach: L::Single, block: &Block, lane: usize) -> u8 {
    let slack = rays.spread * reach * L::Single::splat(SLACK);
    let a = seen_corner::<L>(rays, block, 0, lane);
    let b = seen_corner::<L>(rays, block, 1, lane);
    let c = seen_corner::<L>(rays, block, 2, lane);
    let rest = rough_edge::<L>(&rays.direction, &b, &c);
    let alpha = rough_edge::<L>(&rays.direction, &c, &a);
    let beta = rough_edge::<L>(&rays.direction, &a, &b);
    let least = rest.min(alpha).min(beta);
    let greatest = rest.max(alpha).max(beta);
    (least.ge(-slack).bits() | greatest.le(slack).bits()) & rays.mask
}

/// A corner from where the rays start.
#[inline(always)]
fn seen_corner<L: Lanes>(rays: &Shadow<L>, block: &Block, corner: usize, lane: usize) -> [L::Single; 3] {
    let [x, y, z] = &block.corners[corner];
    [
        L::Single::splat(x[lane]) - rays.origin[0],
        L::Single::splat(y[lane]) - rays.origin[1],
        L::Single::splat(z[lane]) - rays.origin[2],
    ]
}

#[inline(always)]
fn rough_edge<L: Lanes>(direction: &[L::Single; 3], a: &[L::Single; 3], b: &[L::Single; 3]) -> L::Single {
    let [dx, dy, dz] = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let [sx, sy, sz] = [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
    let x = dy.mul_sub(sz, sy * dz);
    let y = dz.mul_sub(sx, sz * dx);
    let z = dx.mul_sub(sy, sx * dy);
    direction[0].mul_add(x, direction[1].mul_add(y, direction[2] * z))
}
