//! Hidden surfaces and shadows (subject §1.1, §1.2): the nearest hit along a ray, and whether anything stands between
//! a point and a lamp.

use super::intersect::{Start, intersect_facet, intersect_plane, intersect_sphere, starts_on_facet};
use crate::Ray;
use crate::world::{Body, Facets, Geometry, World};

/// What a ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hit {
    pub(crate) t: f64,
    pub(crate) body: u32,
    /// The facet's number; 0 for a sphere and a plane.
    pub(crate) facet: u32,
    /// The shares of `P0P1` and `P0P2`; 0 for a sphere and a plane.
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
    /// What the ray sees: the nearest hit, leaving out the very surface that it starts on (`start`).
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

    /// Some body that the ray meets before `distance`: what shadows the point where the ray starts.
    pub(crate) fn blocker(&self, ray: &Ray, start: Option<u32>, distance: f64) -> Option<u32> {
        let mut blocker = None;
        self.visit_hits(ray, start, distance, |hit| {
            if hit.t < distance {
                blocker = Some(hit.body);
                return -1.0;
            }
            distance
        });
        blocker
    }

    /// Gives `found` every hit up to the limit; `found` gives the new limit, a negative one to stop.
    fn visit_hits(&self, ray: &Ray, start: Option<u32>, mut limit: f64, mut found: impl FnMut(Hit) -> f64) {
        for &number in self.unbounded() {
            limit = visit_body(self.body(number), number, ray, start == Some(number), limit, &mut found);
            if limit < 0.0 {
                return;
            }
        }
        let (hierarchy, bounded) = self.bounded();
        hierarchy.visit(ray, limit, |item, limit| {
            let number = bounded[item as usize];
            visit_body(self.body(number), number, ray, start == Some(number), limit, &mut found)
        });
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
    let mut last = limit;
    facets.hierarchy().visit(ray, limit, |facet, limit| {
        let [p0, p1, p2] = facets.corners(facet);
        last = match intersect_facet(ray, p0, p1, p2) {
            Some(hit) if !(starts_here && starts_on_facet(ray.origin, p0, p1, p2)) => {
                found(Hit { t: hit.t, body, facet, alpha: hit.alpha, beta: hit.beta })
            }
            Some(_) | None => limit,
        };
        last
    });
    last
}
