//! Polygons into triangles: meshes of files have quads and larger faces, the model has facets.
//!
//! Ears are clipped (Meisters 1975) in the plane that the polygon is seen in best. Unlike faster methods, this keeps
//! every corner, also one on the straight line between its neighbours: a mesh that was closed stays closed.

use glam::{DVec2, DVec3};

/// Polygons of more corners are refused: the time grows with the square of the number.
pub(super) const MOST_CORNERS: usize = 4096;

/// Cuts a polygon of at least three corners into triangles that turn like it, as numbers of its corners. A polygon that
/// crosses itself is cut somehow.
pub(crate) fn triangulate(corners: &[DVec3], emit: &mut impl FnMut([usize; 3])) {
    match corners.len() {
        0..=2 => {}
        3 => emit([0, 1, 2]),
        _ => match seen_flat(corners) {
            Some(flat) => clip(&flat, emit),
            None => fan(&(0..corners.len()).collect::<Vec<_>>(), emit),
        },
    }
}

/// The corners in a plane in which the polygon turns anticlockwise; `None` if it has no area.
fn seen_flat(corners: &[DVec3]) -> Option<Vec<DVec2>> {
    // Newell's normal: twice the area that the polygon shows to each axis. Taken about a corner, for far coordinates.
    let origin = corners[0];
    let pairs = corners.windows(2).map(|pair| (pair[0] - origin).cross(pair[1] - origin));
    let normal: DVec3 = pairs.sum();
    let size = normal.abs();
    let flat = |x: fn(DVec3) -> f64, y: fn(DVec3) -> f64, turned: bool| {
        let see = |corner: &DVec3| {
            let from = *corner - origin;
            if turned { DVec2::new(y(from), x(from)) } else { DVec2::new(x(from), y(from)) }
        };
        Some(corners.iter().map(see).collect())
    };
    if size.max_element() == 0.0 || !size.is_finite() {
        None
    } else if size.z >= size.x && size.z >= size.y {
        flat(|p| p.x, |p| p.y, normal.z < 0.0)
    } else if size.y >= size.x {
        flat(|p| p.z, |p| p.x, normal.y < 0.0)
    } else {
        flat(|p| p.y, |p| p.z, normal.x < 0.0)
    }
}

/// The triangles from the first corner to each edge.
fn fan(ring: &[usize], emit: &mut impl FnMut([usize; 3])) {
    if let Some((&first, rest)) = ring.split_first() {
        rest.windows(2).for_each(|edge| emit([first, edge[0], edge[1]]));
    }
}

/// Twice the signed area of a triangle, positive where it turns anticlockwise.
fn area(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

fn clip(flat: &[DVec2], emit: &mut impl FnMut([usize; 3])) {
    let mut ring: Vec<usize> = (0..flat.len()).collect();
    // A simple polygon has two ears at any time, and a cut makes new ones beside it. The bound ends the search in a
    // polygon that is not simple.
    let mut tests = 256 * ring.len();
    let mut at = 1;
    let mut since_cut = 0;
    while ring.len() > 3 && since_cut < ring.len() && tests > 0 {
        if is_ear(&ring, at, flat) {
            let [before, corner, after] = around(&ring, at);
            emit([before, corner, after]);
            ring.remove(at);
            at = (at + ring.len() - 1) % ring.len();
            since_cut = 0;
        } else {
            at = (at + 1) % ring.len();
            since_cut += 1;
        }
        tests -= 1;
    }
    fan(&ring, emit);
}

/// The corners before, at and after a place of the ring.
fn around(ring: &[usize], at: usize) -> [usize; 3] {
    let count = ring.len();
    [ring[(at + count - 1) % count], ring[at], ring[(at + 1) % count]]
}

/// Whether the triangle at a place has an area and lies inside the polygon, with no other corner in it or on its rim.
fn is_ear(ring: &[usize], at: usize, flat: &[DVec2]) -> bool {
    let [before, corner, after] = around(ring, at);
    let [a, b, c] = [before, corner, after].map(|number| flat[number]);
    if area(a, b, c) <= 0.0 {
        return false;
    }
    // One of the three in another guise is no other corner.
    let inside = |p: DVec2| area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0;
    ring.iter().all(|&other| {
        let p = flat[other];
        other == before || other == corner || other == after || p == a || p == b || p == c || !inside(p)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cut(corners: &[DVec3]) -> Vec<[usize; 3]> {
        let mut triangles = Vec::new();
        triangulate(corners, &mut |triangle| triangles.push(triangle));
        triangles
    }

    fn flat(corners: &[[f64; 2]]) -> Vec<DVec3> {
        corners.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect()
    }

    /// The triangles turn like the polygon, cover its area, and every edge is either the polygon's or has two sides.
    fn check(corners: &[DVec3]) {
        let normal: DVec3 = (1..corners.len()).map(|i| corners[i - 1].cross(corners[i])).sum::<DVec3>()
            + corners[corners.len() - 1].cross(corners[0]);
        let triangles = cut(corners);
        assert_eq!(triangles.len(), corners.len() - 2);
        let mut sum = 0.0;
        let mut edges = Vec::new();
        for [a, b, c] in triangles {
            let area = (corners[b] - corners[a]).cross(corners[c] - corners[a]).dot(normal.normalize());
            assert!(area > 0.0, "{corners:?}: {a} {b} {c}");
            sum += area;
            edges.extend([(a, b), (b, c), (c, a)]);
        }
        assert!((sum - normal.length()).abs() < 1e-9 * normal.length(), "{corners:?}");
        for i in 0..corners.len() {
            let edge = (i, (i + 1) % corners.len());
            assert_eq!(edges.iter().filter(|&&other| other == edge).count(), 1, "{corners:?}: {edge:?}");
            edges.retain(|&other| other != edge);
        }
        assert!(edges.iter().all(|&(a, b)| edges.contains(&(b, a))), "{corners:?}");
    }

    #[test]
    fn a_square_becomes_two_triangles() {
        assert_eq!(cut(&flat(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])), [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn a_dart_is_cut_along_its_dent() {
        let dart = flat(&[[0.0, 0.0], [4.0, 2.0], [0.0, 4.0], [1.0, 2.0]]);
        for turn in 0..4 {
            let mut turned = dart.clone();
            turned.rotate_left(turn);
            check(&turned);
            turned.reverse();
            check(&turned);
        }
    }

    #[test]
    fn combs_spirals_and_corners_on_a_straight_edge() {
        let mut comb = vec![[20.0, -1.0], [20.0, 5.0]];
        comb.extend((0..20).rev().map(|i| [f64::from(i), if i % 2 == 0 { 5.0 } else { 0.0 }]));
        comb.push([0.0, -1.0]);
        check(&flat(&comb));
        let arm = |radius: f64| (0..60).map(move |i| (f64::from(i) * 0.3, radius + f64::from(i) * 0.1));
        let polar = |(angle, radius): (f64, f64)| [radius * angle.cos(), radius * angle.sin()];
        let spiral: Vec<[f64; 2]> =
            arm(1.4).map(polar).chain(arm(1.0).map(polar).collect::<Vec<_>>().into_iter().rev()).collect();
        check(&flat(&spiral));
        check(&flat(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [3.0, 3.0], [1.5, 3.0], [0.0, 3.0]]));
    }

    #[test]
    fn a_polygon_without_area_is_cut_too() {
        let line: Vec<DVec3> = (0..6).map(|i| DVec3::splat(f64::from(i))).collect();
        assert_eq!(cut(&line).len(), 4);
        assert_eq!(cut(&[DVec3::ZERO; 5]).len(), 3);
    }

    /// The work grows with the square of the corners at most: with their cube, this test would take days.
    #[test]
    fn the_largest_polygon_is_cut() {
        let zigzag = |i: usize| DVec3::new((i * 7919 % 4096) as f64, (i * 104_729 % 4096) as f64, i as f64);
        assert_eq!(cut(&(0..MOST_CORNERS).map(zigzag).collect::<Vec<_>>()).len(), MOST_CORNERS - 2);
    }

    proptest! {
        /// Star-shaped polygons, tilted: simple, with dents.
        #[test]
        fn every_star_is_covered(
            radii in proptest::collection::vec(0.2_f64..5.0, 4..40),
            normal in prop::array::uniform3(-1.0_f64..1.0),
        ) {
            let normal = DVec3::from(normal);
            prop_assume!(normal.length() > 0.1);
            let (u, v) = normal.normalize().any_orthonormal_pair();
            let step = std::f64::consts::TAU / radii.len() as f64;
            let corners: Vec<DVec3> = radii
                .iter()
                .enumerate()
                .map(|(i, radius)| (u * (step * i as f64).cos() + v * (step * i as f64).sin()) * *radius)
                .collect();
            check(&corners);
        }

        #[test]
        fn any_points_give_all_triangles(points in proptest::collection::vec(prop::array::uniform3(-3_i8..3), 3..30)) {
            let corners: Vec<DVec3> = points.iter().map(|p| DVec3::from(p.map(f64::from))).collect();
            let triangles = cut(&corners);
            prop_assert_eq!(triangles.len(), corners.len() - 2);
            prop_assert!(triangles.iter().flatten().all(|&corner| corner < corners.len()));
        }
    }
}
