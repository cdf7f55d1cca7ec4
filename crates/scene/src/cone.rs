//! What is to be known of cones beside their dimensions: which face a number stands for, how far they reach, and cones
//! as facets for whatever knows no round shapes: exports, outlines.

use glam::DVec3;

/// A part of a cone's surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ConeFace {
    /// The curved side.
    Side,
    /// The disc at the base.
    Base,
    /// The disc at the top.
    Top,
}

impl ConeFace {
    /// The number that stands for it where facets have their numbers.
    pub const fn number(self) -> u32 {
        match self {
            ConeFace::Side => 0,
            ConeFace::Base => 1,
            ConeFace::Top => 2,
        }
    }

    /// The face of a number; no other number stands for a face than those of [`ConeFace::number`].
    pub const fn of(number: u32) -> ConeFace {
        match number {
            0 => ConeFace::Side,
            1 => ConeFace::Base,
            _ => ConeFace::Top,
        }
    }
}

/// The corners of a regular polygon around an axis, anticlockwise seen from where the axis points.
pub fn circle(center: DVec3, axis: DVec3, radius: f64, corners: u32) -> Vec<DVec3> {
    let axis = axis.normalize_or(DVec3::Y);
    let u = axis.any_orthonormal_vector();
    let v = axis.cross(u);
    let corner = |number: u32| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(number) / f64::from(corners));
        center + (u * cos + v * sin) * radius
    };
    (0..corners).map(corner).collect()
}

/// How far a circle of radius 1 around an axis reaches along x, y and z: `√(1 - a²)` for each coordinate `a` of the
/// axis' direction, computed from the other two, so that a circle across a coordinate axis has no extent along it.
pub fn circle_extent(axis: DVec3) -> DVec3 {
    let a = axis.normalize_or_zero();
    let root = |one: f64, other: f64| (one * one + other * other).sqrt();
    DVec3::new(root(a.y, a.z), root(a.z, a.x), root(a.x, a.y))
}

/// The facets of a cone whose circles are polygons of so many corners, with normals that point outwards. Facets that
/// meet share their corners to the last bit, so those of a capped cone are a closed mesh.
pub fn cone_facets([base, top]: [DVec3; 2], radii: [f64; 2], capped: bool, around: u32) -> Vec<[DVec3; 3]> {
    let axis = top - base;
    let [below, above] = [(base, radii[0]), (top, radii[1])].map(|(center, radius)| match radius > 0.0 {
        true => circle(center, axis, radius, around),
        false => vec![center; around as usize],
    });
    let mut facets = Vec::new();
    for number in 0..around as usize {
        let next = (number + 1) % around as usize;
        if radii[0] > 0.0 {
            facets.push([below[number], below[next], above[next]]);
        }
        if radii[1] > 0.0 {
            facets.push([below[number], above[next], above[number]]);
        }
        if capped && radii[0] > 0.0 {
            facets.push([base, below[next], below[number]]);
        }
        if capped && radii[1] > 0.0 {
            facets.push([top, above[number], above[next]]);
        }
    }
    facets
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Enclosure, MeshGeometry};

    /// The volume of a prism over a regular polygon, a pyramid, a frustum: `h/3·(A + √(A·B) + B)`.
    #[test]
    fn the_facets_enclose_the_volume_of_the_pyramid() {
        for (radii, corners) in [([1.0, 1.0], 24), ([2.0, 0.0], 7), ([0.0, 0.5], 3), ([3.0, 1.0], 64)] {
            let (base, top) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(2.0, 5.0, 2.0));
            let facets = cone_facets([base, top], radii, true, corners);
            let volume: f64 = facets.iter().map(|[a, b, c]| (a - base).dot((b - base).cross(c - base)) / 6.0).sum();
            let angle = std::f64::consts::TAU / f64::from(corners);
            let area = radii.map(|radius| f64::from(corners) / 2.0 * radius * radius * angle.sin());
            let height = (top - base).length();
            let expected = height / 3.0 * (area[0] + (area[0] * area[1]).sqrt() + area[1]);
            assert!((volume - expected).abs() < 1e-12 * expected.max(1.0), "{radii:?}: {volume}, {expected}");
            let mesh = MeshGeometry {
                positions: facets.as_flattened().to_vec(),
                facets: (0..facets.len() as u32).map(|facet| [3 * facet, 3 * facet + 1, 3 * facet + 2]).collect(),
                ..MeshGeometry::default()
            };
            assert_eq!(mesh.enclosure(), Enclosure::Volume { inverted: false }, "{radii:?}");
            let open = cone_facets([base, top], radii, false, corners);
            let caps = radii.iter().filter(|radius| **radius > 0.0).count();
            assert_eq!(open.len() + caps * corners as usize, facets.len());
        }
    }
}
