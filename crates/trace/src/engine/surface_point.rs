//! The points that rays see: places on the primitives, normals, surfaces (`reference`'s, over lanes).

use super::cone::PointsOnCone;
use super::dispatch::Backend;
use super::lanes::{Lanes, Mask, Real};
use super::packet::{Hits, Packet};
use super::vector::{Vector, lanes, mask, put_value};
use crate::World;
use crate::world::{Extent, Facets, Geometry};
use glam::DVec3;

/// What the rays of a packet see. Both normals are turned against the rays.
#[derive(Clone, Copy)]
pub(super) struct Points<L: Lanes> {
    /// The lanes whose rays meet something.
    pub(super) mask: u8,
    pub(super) point: Vector<L::Real>,
    /// The geometric normal: side, medium, `T`, and whether a lamp is in front.
    pub(super) geometric: Vector<L::Real>,
    /// The normal of the lamp terms and of `R`: smooth where the mesh is.
    pub(super) normal: Vector<L::Real>,
    pub(super) body: [u32; 8],
    /// The number of the surface.
    pub(super) surface: [u32; 8],
    /// The lanes whose rays pass into the body, and those that pass out; the others meet sheets.
    pub(super) enters: u8,
    pub(super) leaves: u8,
}

impl<L: Backend> Points<L> {
    /// No points.
    #[inline(always)]
    pub(super) fn none() -> Points<L> {
        let zero = Vector::splat(DVec3::ZERO);
        let (point, geometric, normal, numbers) = (zero, zero, zero, [0; 8]);
        Points { mask: 0, point, geometric, normal, body: numbers, surface: numbers, enters: 0, leaves: 0 }
    }

    /// Becomes the points of a packet's hits, recomputed from the primitives. In place: they are too large to be moved.
    #[inline(always)]
    pub(super) fn find(&mut self, world: &World, packet: &Packet<L>, hits: &Hits<L>, met: u8) {
        let seen = packet.origin + packet.direction * hits.t;
        let points = self;
        (points.mask, points.point, points.body) = (met, seen, hits.body);
        let (mut outward, mut smooth, mut is_smooth) = (seen, seen, 0);
        let (mut sheets, mut inverted) = (0, 0);
        let mut left = met;
        while left != 0 {
            let number = hits.body[left.trailing_zeros() as usize];
            let group = left & L::equal(&hits.body, number);
            left &= !group;
            let body = world.body(number);
            put_value(&mut points.surface, group, body.surface);
            let (point, normal) = match &body.geometry {
                Geometry::Sphere { center, radius } => {
                    // N = CP/R
                    let center = Vector::splat(*center);
                    let normal = (seen - center).normalize();
                    (center + normal * L::Real::splat(*radius), normal)
                }
                Geometry::Plane { p0, normal, .. } => {
                    let normal = Vector::splat(*normal);
                    (seen - normal * normal.dot(seen - Vector::splat(*p0)), normal)
                }
                Geometry::Cone(cone) => {
                    let (mut point, mut normal) = (seen, seen);
                    let faces = &hits.facet;
                    L::enter(PointsOnCone { cone, seen, faces, point: &mut point, normal: &mut normal });
                    (point, normal)
                }
                Geometry::Facets(facets) => {
                    let first = hits.facet[group.trailing_zeros() as usize];
                    if group & !L::equal(&hits.facet, first) == 0 && facets.normals(first).is_none() {
                        // all on one flat facet
                        let [p0, p1, p2] = facets.corners(first);
                        if let Some(part) = facets.surface(first) {
                            put_value(&mut points.surface, group, part);
                        }
                        let (u, v) = (p1 - p0, p2 - p0);
                        let along = Vector::splat(u) * hits.alpha;
                        let point = Vector::splat(p0) + along + Vector::splat(v) * hits.beta;
                        (point, Vector::splat(u.cross(v).normalize()))
                    } else {
                        let on = OnFacets::gather(facets, hits, group, &mut points.surface);
                        if on.smooth != 0 {
                            smooth = Vector::select(mask::<L::Real>(group), Vector::load(&on.smooth_normal), smooth);
                            is_smooth |= on.smooth;
                        }
                        let (u, v): (Vector<L::Real>, _) = (Vector::load(&on.u), Vector::load(&on.v));
                        (Vector::load(&on.p0) + u * hits.alpha + v * hits.beta, Vector::load(&on.normal))
                    }
                }
            };
            let chosen = mask::<L::Real>(group);
            points.point = Vector::select(chosen, point, points.point);
            outward = Vector::select(chosen, normal, outward);
            match body.extent {
                Extent::Sheet => sheets |= group,
                Extent::HalfSpace | Extent::Volume { inverted: false } => {}
                Extent::Volume { inverted: true } => inverted |= group,
            }
        }
        let inward = outward.dot(packet.direction).lt(L::Real::splat(0.0)).bits();
        points.enters = (inward ^ inverted) & !sheets & met;
        points.leaves = !(inward ^ inverted) & !sheets & met;
        points.geometric = outward.against(packet.direction);
        points.normal = if is_smooth == 0 {
            points.geometric
        } else {
            let turned = smooth.against(-points.geometric);
            Vector::select(mask::<L::Real>(is_smooth), turned, points.geometric)
        };
    }
}

/// What points on facets are computed from, one facet a lane.
struct OnFacets {
    p0: [[f64; 8]; 3],
    u: [[f64; 8]; 3],
    v: [[f64; 8]; 3],
    normal: [[f64; 8]; 3],
    smooth_normal: [[f64; 8]; 3],
    /// The lanes that have a smooth normal.
    smooth: u8,
}

impl OnFacets {
    #[inline(always)]
    fn gather<L: Lanes>(facets: &Facets, hits: &Hits<L>, group: u8, surface: &mut [u32; 8]) -> OnFacets {
        let none = [[0.0; 8]; 3];
        let mut on = OnFacets { p0: none, u: none, v: none, normal: none, smooth_normal: none, smooth: 0 };
        let (alpha, beta) = (hits.alpha.store(), hits.beta.store());
        let mut left = group;
        while left != 0 {
            let facet = hits.facet[left.trailing_zeros() as usize];
            let same = left & L::equal(&hits.facet, facet);
            left &= !same;
            let [p0, p1, p2] = facets.corners(facet);
            let (u, v) = (p1 - p0, p2 - p0);
            let normal = u.cross(v).normalize();
            let normals = facets.normals(facet);
            let part = facets.surface(facet);
            for lane in lanes(same) {
                put(&mut on.p0, lane, p0);
                put(&mut on.u, lane, u);
                put(&mut on.v, lane, v);
                put(&mut on.normal, lane, normal);
                if let Some(part) = part {
                    surface[lane] = part;
                }
                let smooth = normals.and_then(|[n0, n1, n2]| {
                    (n0 * (1.0 - alpha[lane] - beta[lane]) + n1 * alpha[lane] + n2 * beta[lane]).try_normalize()
                });
                if let Some(smooth) = smooth {
                    put(&mut on.smooth_normal, lane, smooth);
                    on.smooth |= 1 << lane;
                }
            }
        }
        on
    }
}

#[inline(always)]
fn put(list: &mut [[f64; 8]; 3], lane: usize, vector: DVec3) {
    list[0][lane] = vector.x;
    list[1][lane] = vector.y;
    list[2][lane] = vector.z;
}
