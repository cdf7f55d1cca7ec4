//! Where eight rays meet one primitive: the reference's operations in the reference's order, lane by lane.

use super::lanes::{Lanes, Mask, Real, Single};
use super::vector::{Vector, mask};
use crate::bvh::{Block, LeafBox, Shadow};
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

/// How far an edge function of the filter can be off, over direction, coordinates and reach: 2⁻¹⁵.
///
/// With `u = 2⁻²⁴`, `R` the sum of the greatest coordinates of a ray's start and of the corners, and reach `A` (no corner is
/// farther than `A` from the start along any axis): corners and start are rounded to `uR` together, so their difference
/// is off by `2uR`, a sum or difference of two of those by `6uR`, a component of a product by `2·(2·2A·6uR + 4uA²) + 8uA²`
/// `≤ 64uAR`, and the scalar product with a direction of components at most `D` by `3·64uDAR + 72uDA² ≤ 264uDAR < 512u·DAR`.
const SLACK: f32 = 1.0 / 32_768.0;

/// What the edge functions of a packet's rays are off at most, in a leaf of that reach.
#[inline(always)]
pub(super) fn slack<L: Lanes>(rays: &Shadow<L>, place: LeafBox<'_>) -> L::Single {
    rays.spread * place.reach(rays) * L::Single::splat(SLACK)
}

/// The lanes whose rays may meet a facet of a block, leaving out none that do.
#[inline(always)]
pub(super) fn may_meet<L: Lanes>(rays: &Shadow<L>, slack: L::Single, block: &Block, lane: usize) -> u8 {
    let a = seen_corner::<L>(rays, block, 0, lane);
    let b = seen_corner::<L>(rays, block, 1, lane);
    let c = seen_corner::<L>(rays, block, 2, lane);
    let rest = along::<L>(&rays.direction, &edge_normal::<L>(&b, &c));
    let alpha = along::<L>(&rays.direction, &edge_normal::<L>(&c, &a));
    let beta = along::<L>(&rays.direction, &edge_normal::<L>(&a, &b));
    one_sided::<L>(rest, alpha, beta, slack) & rays.mask
}

/// The lanes in which all three edge functions may have one sign.
#[inline(always)]
fn one_sided<L: Lanes>(rest: L::Single, alpha: L::Single, beta: L::Single, slack: L::Single) -> u8 {
    let least = rest.min(alpha).min(beta);
    let greatest = rest.max(alpha).max(beta);
    (least.ge(-slack) | greatest.le(slack)).bits()
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

/// `(a - b) × (a + b)`: what the scalar product with a direction is taken of.
#[inline(always)]
fn edge_normal<L: Lanes>(a: &[L::Single; 3], b: &[L::Single; 3]) -> [L::Single; 3] {
    let [dx, dy, dz] = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let [sx, sy, sz] = [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
    [dy.mul_sub(sz, sy * dz), dz.mul_sub(sx, sz * dx), dx.mul_sub(sy, sx * dy)]
}

#[inline(always)]
fn along<L: Lanes>(direction: &[L::Single; 3], normal: &[L::Single; 3]) -> L::Single {
    direction[0].mul_add(normal[0], direction[1].mul_add(normal[1], direction[2] * normal[2]))
}

/// Up to eight facets as seen from one point: the edge normals, which all rays from there share.
pub(super) struct SeenFacets {
    normals: [[[f32; 8]; 3]; 3],
}

impl SeenFacets {
    /// The facets of one or two blocks, seen from a point in the hierarchy's f32 space.
    #[inline(always)]
    pub(super) fn from_point<L: Lanes>(point: [f32; 3], blocks: &[Block]) -> SeenFacets {
        let (low, high) = (&blocks[0].corners, &blocks[blocks.len() - 1].corners);
        let mut seen = [[L::Single::splat(0.0); 3]; 3];
        for corner in 0..3 {
            for axis in 0..3 {
                let coordinates = L::Single::of_halves(&low[corner][axis], &high[corner][axis]);
                seen[corner][axis] = coordinates - L::Single::splat(point[axis]);
            }
        }
        let [a, b, c] = &seen;
        let mut normals = [[[0.0; 8]; 3]; 3];
        for axis in 0..3 {
            normals[0][axis] = edge_normal::<L>(b, c)[axis].store();
            normals[1][axis] = edge_normal::<L>(c, a)[axis].store();
            normals[2][axis] = edge_normal::<L>(a, b)[axis].store();
        }
        SeenFacets { normals }
    }

    /// The lanes of a packet whose rays, which start at the point, may meet one of the facets.
    #[inline(always)]
    pub(super) fn may_meet<L: Lanes>(&self, rays: &Shadow<L>, slack: L::Single, facet: usize) -> u8 {
        let mut edges = [slack; 3];
        for edge in 0..3 {
            let [x, y, z] = &self.normals[edge];
            let normal = [L::Single::splat(x[facet]), L::Single::splat(y[facet]), L::Single::splat(z[facet])];
            edges[edge] = along::<L>(&rays.direction, &normal);
        }
        one_sided::<L>(edges[0], edges[1], edges[2], slack) & rays.mask
    }

    /// Which of the facets a single ray from the point may meet.
    #[inline(always)]
    pub(super) fn met_by<L: Lanes>(&self, direction: [f32; 3], slack: f32) -> u8 {
        let mut edges = [L::Single::splat(slack); 3];
        for edge in 0..3 {
            let [x, y, z] = &self.normals[edge];
            let normal = [L::Single::load(x), L::Single::load(y), L::Single::load(z)];
            let [dx, dy, dz] = direction;
            edges[edge] = along::<L>(&[L::Single::splat(dx), L::Single::splat(dy), L::Single::splat(dz)], &normal);
        }
        one_sided::<L>(edges[0], edges[1], edges[2], L::Single::splat(slack))
    }
}
