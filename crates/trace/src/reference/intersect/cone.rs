//! Ray and right circular cone, truncated or not; a cylinder is one of equal radii.
//!
//! With `a` the unit axis from the base's centre `B` to the top's, `z = (P-B)·a` and `m = (R₁-R₀)/h`, the points of the side
//! are those with `|P-B-z·a|² = (R₀+m·z)²` and `0 ≤ z ≤ h`. Along a ray that is a quadratic equation (Haines 1987, «Standard
//! Procedural Databases»; Cychosz and Waggenspack 1994, «Intersecting a ray with a cylinder»). It is the equation of two
//! cones that meet at their tip, of which the one with `R₀+m·z > 0` is meant.
//!
//! A capped cone is convex: the ray's line is within it along one chord, which is what is left of the line between the two
//! planes of the caps and within the infinite cone. Nothing slips through between side and cap, because neither is asked
//! whether it alone is hit. An open cone is met at the ends of the chord of the infinite cone that lie between the planes.

use super::Start;
use crate::Ray;
use crate::precision::roundings;
use glam::DVec3;
use lancer_scene::{ConeFace, circle_extent};

/// A cone as rays meet it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// `B`, the centre of the first circle.
    pub(crate) base: DVec3,
    /// `a`, of unit length.
    pub(crate) axis: DVec3,
    /// `h`, from circle to circle.
    pub(crate) height: f64,
    /// `R₀`.
    pub(crate) radius: f64,
    /// `m`, how much the radius grows along the axis.
    pub(crate) slope: f64,
    /// `1/√(1+m²)`: the cosine of the angle between the axis and the side.
    pub(crate) cosine: f64,
    /// The least and the greatest `z`. A tip has no limit: the side ends there by itself, and rounding shall not cut it off.
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// Whether discs close its ends.
    pub(crate) capped: bool,
}

/// Where a line is within an infinite cone: distances `enter` and `leave` from the point at `shift`, which is at `z` along
/// the axis and moves along it by `dz`. Nowhere if it enters no sooner than it leaves.
#[derive(Clone, Copy, Debug)]
struct Within {
    shift: f64,
    z: f64,
    dz: f64,
    enter: f64,
    leave: f64,
}

/// Where a ray's line enters or leaves a cone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct End {
    /// The distance from the ray's start.
    pub(crate) t: f64,
    /// What is met there; nothing where an open cone has no side.
    pub(crate) face: Option<ConeFace>,
}

impl Cone {
    /// The cone between two circles that are not in one place, of radii that are not both 0.
    pub fn new([base, top]: [DVec3; 2], [base_radius, top_radius]: [f64; 2], capped: bool) -> Cone {
        let height = (top - base).length();
        let slope = (top_radius - base_radius) / height;
        Cone {
            base,
            axis: (top - base) / height,
            height,
            radius: base_radius,
            slope,
            cosine: 1.0 / (1.0 + slope * slope).sqrt(),
            low: if base_radius == 0.0 { f64::NEG_INFINITY } else { 0.0 },
            high: if top_radius == 0.0 { f64::INFINITY } else { height },
            capped,
        }
    }

    /// The radius `R₁` at the top.
    fn top_radius(&self) -> f64 {
        self.radius + self.slope * self.height
    }

    /// How far a point is along the axis, and how far beside it.
    fn place(&self, point: DVec3) -> (f64, DVec3) {
        let from_base = point - self.base;
        let z = from_base.dot(self.axis);
        (z, from_base - self.axis * z)
    }

    /// Where the ray's line is within the infinite cone.
    ///
    /// All is computed from the point of the line that is nearest to the cone's middle, which spares a cone far away the
    /// cancellation that the ray's own start would bring; `q/A` and `C/q` are the two roots without cancellation (Press et
    /// al., «Numerical Recipes», 5.6).
    fn within(&self, ray: &Ray) -> Within {
        let to_base = self.base - ray.origin;
        let shift = ray.direction.dot(to_base + self.axis * (self.height * 0.5));
        let near = ray.direction * shift - to_base;
        let (z, dz) = (near.dot(self.axis), ray.direction.dot(self.axis));
        let (beside, sideways) = (near - self.axis * z, ray.direction - self.axis * dz);
        let (radius, growth) = (self.radius + self.slope * z, self.slope * dz);
        let a = sideways.dot(sideways) - growth * growth;
        let b = sideways.dot(beside) - growth * radius;
        let c = beside.dot(beside) - radius * radius;
        let delta = b * b - a * c;
        let two_roots = delta > 0.0;
        let root = if two_roots { delta.sqrt() } else { 0.0 };
        let q = if b > 0.0 { -(b + root) } else { root - b };
        let first = q / a;
        // a line through the tip has one root, however Δ rounds
        let second = if two_roots { c / q } else { first };
        let (near_root, far_root) = if first < second { (first, second) } else { (second, first) };
        let (enter, leave) = if a < 0.0 {
            // steeper than the side: within one of the two cones before the roots, within the other one after them
            if growth > 0.0 { (far_root, f64::INFINITY) } else { (f64::NEG_INFINITY, near_root) }
        } else if two_roots && radius * a - growth * b > 0.0 {
            // the radius in the middle of the chord, at -B/A, is positive
            (near_root, far_root)
        } else if a == 0.0 && b == 0.0 && c < 0.0 {
            // along the axis of a cylinder
            (f64::NEG_INFINITY, f64::INFINITY)
        } else {
            (f64::INFINITY, f64::NEG_INFINITY)
        };
        Within { shift, z, dz, enter, leave }
    }

    /// The two ends of the chord, the nearer one first.
    pub(crate) fn ends(&self, ray: &Ray) -> [End; 2] {
        let Within { shift, z, dz, enter, leave } = self.within(ray);
        if !self.capped {
            let end = |s: f64| {
                let on_side = s.abs() < f64::INFINITY && self.low <= z + s * dz && z + s * dz <= self.high;
                End { t: s + shift, face: on_side.then_some(ConeFace::Side) }
            };
            return [end(enter), end(leave)];
        }
        let upwards = dz > 0.0;
        let (to_low, to_high) = ((self.low - z) / dz, (self.high - z) / dz);
        let (first, last) = if dz == 0.0 {
            // along the caps: between them or nowhere
            let between = self.low < z && z < self.high;
            if between { (f64::NEG_INFINITY, f64::INFINITY) } else { (f64::INFINITY, f64::NEG_INFINITY) }
        } else if upwards {
            (to_low, to_high)
        } else {
            (to_high, to_low)
        };
        let (by_first, by_last) =
            if upwards { (ConeFace::Base, ConeFace::Top) } else { (ConeFace::Top, ConeFace::Base) };
        let (enter, entered) = if first > enter { (first, by_first) } else { (enter, ConeFace::Side) };
        let (leave, left) = if last < leave { (last, by_last) } else { (leave, ConeFace::Side) };
        let is_met = enter < leave;
        [
            End { t: enter + shift, face: is_met.then_some(entered) },
            End { t: leave + shift, face: is_met.then_some(left) },
        ]
    }

    /// Whether a hit is computed to be at `t` before a lamp that lies on the cone at `distance` along the ray, but is
    /// the lamp's own place: of the ends of the chord the lamp is nearer to it than to the other one.
    pub(crate) fn is_at_lamp(&self, ray: &Ray, t: f64, distance: f64) -> bool {
        let [enter, leave] = self.ends(ray);
        let other = if t == enter.t { leave.t } else { enter.t };
        (distance - t).abs() <= (distance - other).abs()
    }

    /// The place and the unit normal, outwards, of a point that a ray was seen to meet on a face: moved along the normal
    /// onto the face, so that it lies there as well as f64 can say.
    pub(crate) fn surface_point(&self, seen: DVec3, face: ConeFace) -> (DVec3, DVec3) {
        let (z, beside) = self.place(seen);
        match face {
            ConeFace::Side => {
                let distance = beside.length();
                let normal = if distance > 0.0 {
                    (beside * (1.0 / distance) - self.axis * self.slope) * self.cosine
                } else if self.slope < 0.0 {
                    self.axis // the tip
                } else {
                    -self.axis
                };
                (seen - normal * ((distance - (self.radius + self.slope * z)) * self.cosine), normal)
            }
            ConeFace::Base => (seen - self.axis * z, -self.axis),
            ConeFace::Top => (seen - self.axis * (z - self.height), self.axis),
        }
    }

    /// Whether a computed point lies on the cone, as far as f64 can tell.
    pub(crate) fn lies_on(&self, point: DVec3) -> bool {
        let (z, beside) = self.place(point);
        let distance = beside.length();
        let top = self.base + self.axis * self.height;
        let greatest = if self.slope > 0.0 { self.top_radius() } else { self.radius };
        let near = roundings(&[point, self.base, top, DVec3::splat(greatest)]);
        let on_side = ((distance - (self.radius + self.slope * z)) * self.cosine).abs() <= near
            && (-near..=self.height + near).contains(&z);
        let on_cap = |level: f64, radius: f64| (z - level).abs() <= near && distance <= radius + near;
        on_side || self.capped && (on_cap(0.0, self.radius) || on_cap(self.height, self.top_radius()))
    }

    /// Whether a point is inside of the volume that it has if it is capped; a point of the surface is outside.
    pub(crate) fn contains(&self, point: DVec3) -> bool {
        let (z, beside) = self.place(point);
        0.0 < z && z < self.height && beside.length() < self.radius + self.slope * z && !self.lies_on(point)
    }

    /// The least and the greatest corner of a box around it, wider by what rounding makes of a thin cone.
    pub(crate) fn bounds(&self) -> (DVec3, DVec3) {
        let across = circle_extent(self.axis);
        let (top, top_radius) = (self.base + self.axis * self.height, self.top_radius());
        let slack = DVec3::splat(1e-9 * (self.height + self.radius + top_radius));
        let low = (self.base - across * self.radius).min(top - across * top_radius);
        let high = (self.base + across * self.radius).max(top + across * top_radius);
        (low - slack, high + slack)
    }
}

/// The distance of the nearest hit, if there is one, and what is met there.
///
/// A ray that starts on the cone does so at one end of the chord; the other end is ahead if the chord's middle is, that
/// is if the ray goes inwards.
pub fn intersect_cone(ray: &Ray, cone: &Cone, start: Start) -> Option<(f64, ConeFace)> {
    let [enter, leave] = cone.ends(ray);
    let seen = match start {
        Start::OnSurface => Some(leave).filter(|leave| enter.t + leave.t > 0.0),
        Start::Elsewhere => [enter, leave].into_iter().find(|end| end.face.is_some() && end.t > 0.0),
    }?;
    Some((seen.t, seen.face?))
}
