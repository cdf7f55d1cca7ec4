//! Hidden surfaces and shadows (subject §1.1, §1.2): the nearest hit along a ray, and whether anything stands between
//! a point and a lamp.

use super::intersect::{Start, intersect_cone, intersect_facet, intersect_plane, intersect_sphere};
use crate::Ray;
use crate::bvh::Sight;
use crate::precision::{lies_in_plane, lies_on_sphere};
use crate::world::{Body, Facets, Geometry, World};
use glam::DVec3;

/// What a ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hit {
    pub(crate) t: f64,
    pub(crate) body: u32,
    /// The facet's number; 0 for a sphere and a plane, of a cone the number of its face.
    pub(crate) facet: u32,
    /// The shares of `P0P1` and `P0P2`; 0 for what has no facets.
    pub(crate) alpha: f64,
    pub(crate) beta: f64,
}

impl Hit {
    /// Nearer first; at equal distance document order, then facet order.
    fn precedes(&self, other: &Hit) -> bool {
        (self.t, self.body, self.facet) < (other.t, other.body, other.facet)
    }
}

impl World {
    /// What the ray sees: the nearest hit, leaving out the very surface that it starts on: that of the body `start`, or
    /// for a primary ray every one that the eye lies on.
    pub(crate) fn nearest(&self, ray: &Ray, start: Option<u32>) -> Option<Hit> {
        let mut nearest: Option<Hit> = None;
        self.visit_hits(ray, start, f64::INFINITY, |hit| {
            if nearest.is_none_or(|best| hit.precedes(&best)) {
                nearest = Some(hit);
            }
            nearest.map_or(f64::INFINITY, |best| best.t)
        });
        nearest
    }

    /// Some body that the ray meets before the lamp at `distance`: what shadows the point where the ray starts.
    ///
    /// The segment is open at both ends: the surface that the lamp lies on does not hide it.
    pub(crate) fn blocker(&self, ray: &Ray, start: Option<u32>, lamp: DVec3, distance: f64) -> Option<u32> {
        let mut blocker = None;
        self.visit_hits(ray, start, distance, |hit| {
            if hit.t < distance && !self.is_at_lamp(ray, &hit, lamp, distance) {
                blocker = Some(hit.body);
                return -1.0;
            }
            distance
        });
        blocker
    }

    /// Whether a hit that is computed to be before a lamp is the lamp's own place on that surface.
    fn is_at_lamp(&self, ray: &Ray, hit: &Hit, lamp: DVec3, distance: f64) -> bool {
        match &self.body(hit.body).geometry {
            // the line meets the sphere at the lamp and once more, 2·I·(C - lamp) from it: which of the two is nearer?
            Geometry::Sphere { center, radius } => {
                lies_on_sphere(lamp, *center, *radius) && distance - hit.t <= ray.direction.dot(*center - lamp).abs()
            }
            Geometry::Plane { p0, p1, p2, .. } => lies_in_plane(lamp, *p0, *p1, *p2),
            Geometry::Cone(cone) => cone.lies_on(lamp) && cone.is_at_lamp(ray, hit.t, distance),
            Geometry::Facets(facets) => {
                let [p0, p1, p2] = facets.corners(hit.facet);
                lies_in_plane(lamp, p0, p1, p2)
            }
        }
    }

    /// Gives `found` every hit up to the limit; `found` gives the new limit, a negative one to stop.
    fn visit_hits(&self, ray: &Ray, start: Option<u32>, mut limit: f64, mut found: impl FnMut(Hit) -> f64) {
        let starts_on =
            |number| start.map_or_else(|| may_start_on(self.body(number), ray.origin), |body| body == number);
        for &number in self.unbounded() {
            limit = visit_body(self.body(number), number, ray, starts_on(number), limit, &mut found);
            if limit < 0.0 {
                return;
            }
        }
        let (bvh, bounded) = self.bounded();
        let sight = Sight::new(bvh, ray.origin, ray.direction, bvh.margin().at(ray.origin));
        bvh.visit(&sight, limit, |first, count, mut limit| {
            for &number in &bounded[first as usize..(first + count) as usize] {
                limit = visit_body(self.body(number), number, ray, starts_on(number), limit, &mut found);
                if limit < 0.0 {
                    break;
                }
            }
            limit
        });
    }
}

/// Whether an eye may lie on a body; of facets each is asked when it is hit.
fn may_start_on(body: &Body, eye: DVec3) -> bool {
    match &body.geometry {
        Geometry::Sphere { center, radius } => lies_on_sphere(eye, *center, *radius),
        Geometry::Plane { p0, p1, p2, .. } => lies_in_plane(eye, *p0, *p1, *p2),
        Geometry::Cone(cone) => cone.lies_on(eye),
        Geometry::Facets(_) => true,
    }
}

/// The hits of one body; gives the limit after them.
fn visit_body(
    body: &Body,
    number: u32,
    ray: &Ray,
    starts_here: bool,
    limit: f64,
    found: &mut impl FnMut(Hit) -> f64,
) -> f64 {
    let smooth_hit = |t: f64| Hit { t, body: number, facet: 0, alpha: 0.0, beta: 0.0 };
    match &body.geometry {
        Geometry::Sphere { center, radius } => {
            let start = if starts_here { Start::OnSurface } else { Start::Elsewhere };
            intersect_sphere(ray, *center, *radius, start).map_or(limit, |t| found(smooth_hit(t)))
        }
        Geometry::Cone(cone) => {
            let start = if starts_here { Start::OnSurface } else { Start::Elsewhere };
            let hit = intersect_cone(ray, cone, start);
            hit.map_or(limit, |(t, face)| found(Hit { facet: face.number(), ..smooth_hit(t) }))
        }
        Geometry::Plane { .. } if starts_here => limit,
        Geometry::Plane { p0, p1, p2, .. } => {
            intersect_plane(ray, *p0, *p1, *p2).map_or(limit, |t| found(smooth_hit(t)))
        }
        Geometry::Facets(facets) => visit_facets(facets, number, ray, starts_here, limit, found),
    }
}

fn visit_facets(
    facets: &Facets,
    body: u32,
    ray: &Ray,
    starts_here: bool,
    limit: f64,
    found: &mut impl FnMut(Hit) -> f64,
) -> f64 {
    facets.visit(ray, limit, |facet, limit| {
        let [p0, p1, p2] = facets.corners(facet);
        match intersect_facet(ray, p0, p1, p2) {
            Some(hit) if !(starts_here && lies_in_plane(ray.origin, p0, p1, p2)) => {
                found(Hit { t: hit.t, body, facet, alpha: hit.alpha, beta: hit.beta })
            }
            Some(_) | None => limit,
        }
    })
}
