//! One ray through a hierarchy, from near to far.

use super::{Bvh, Entry, MAX_DEPTH, Node, WIDTH};
use glam::DVec3;

/// A ray as boxes see it: in a hierarchy's space, in single precision, with its margin.
///
/// The slabs' distances are those of Kay and Kajiya (1986), rounded so that the interval is never too short: the origin
/// is moved outwards by the margin and to the next `f32`, and the interval is widened by what its three roundings can be
/// off (Ize 2013).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sight {
    /// The origin, moved up along each axis: what a box's least corner is seen from.
    above: [f32; 3],
    /// The origin, moved down: what the greatest corner is seen from.
    below: [f32; 3],
    inverse: [f32; 3],
    backwards: [bool; 3],
}

/// Six roundings of an `f32`: a subtraction, the inverse, a product, and as much again for the comparison's other side.
const ROUNDINGS: f32 = 6.0 * f32::EPSILON;

impl Sight {
    /// The sight of a ray in the hierarchy's space. The margin is that of [`Bvh::margin`] at least, in this space.
    pub(crate) fn new(bvh: &Bvh, origin: DVec3, direction: DVec3, margin: f64) -> Sight {
        let seen = origin - bvh.origin();
        let margin = margin + f64::from(f32::MIN_POSITIVE);
        Sight {
            above: (seen + margin).to_array().map(rounded_up),
            below: (seen - margin).to_array().map(|x| -rounded_up(-x)),
            inverse: direction.to_array().map(|along| (1.0 / along) as f32),
            backwards: direction.to_array().map(f64::is_sign_negative),
        }
    }

    /// The distances at which the ray enters and leaves the boxes of a node's children; it misses a box that it leaves
    /// before it enters it. NaN, where a face lies exactly where a ray along it starts, counts as inside.
    #[inline]
    fn intervals(&self, node: &Node) -> ([f32; WIDTH], [f32; WIDTH]) {
        let (mut near, mut far) = ([0.0_f32; WIDTH], [f32::INFINITY; WIDTH]);
        for axis in 0..3 {
            let (above, below, inverse) = (self.above[axis], self.below[axis], self.inverse[axis]);
            let (low, high) = (&node.low[axis], &node.high[axis]);
            for child in 0..WIDTH {
                let (a, b) = ((low[child] - above) * inverse, (high[child] - below) * inverse);
                let (enter, leave) = if self.backwards[axis] { (b, a) } else { (a, b) };
                near[child] = if enter > near[child] { enter } else { near[child] };
                far[child] = if leave < far[child] { leave } else { far[child] };
            }
        }
        (near.map(|near| near * (1.0 - ROUNDINGS)), far.map(|far| far * (1.0 + ROUNDINGS) + f32::MIN_POSITIVE))
    }
}

/// The least `f32` that is not below the number.
fn rounded_up(x: f64) -> f32 {
    let nearest = x as f32;
    if f64::from(nearest) < x { nearest.next_up() } else { nearest }
}

impl Bvh {
    /// Visits every leaf with an item that the ray meets before `limit`, nearer boxes first. `visit` gets the leaf's
    /// first place, its count and the limit, and gives the new limit; a negative one ends the visit.
    pub(crate) fn visit(&self, sight: &Sight, mut limit: f64, mut visit: impl FnMut(u32, u32, f64) -> f64) -> f64 {
        if self.nodes().is_empty() {
            return limit;
        }
        let mut stack = [(Entry::Inner(0), 0.0_f32); MAX_DEPTH * (WIDTH - 1) + 1];
        let mut open = 1;
        while open > 0 {
            open -= 1;
            let (entry, near) = stack[open];
            if f64::from(near) > limit {
                continue;
            }
            let node = match entry {
                Entry::Leaf { first, count } => {
                    limit = visit(first, count, limit);
                    if limit < 0.0 {
                        return limit;
                    }
                    continue;
                }
                Entry::Inner(node) => &self.nodes()[node as usize],
            };
            let (near, far) = sight.intervals(node);
            let bottom = open;
            for child in 0..WIDTH {
                if near[child] > far[child] || f64::from(near[child]) > limit {
                    continue;
                }
                // the nearest one lies on top
                let mut place = open;
                while place > bottom && stack[place - 1].1 < near[child] {
                    stack[place] = stack[place - 1];
                    place -= 1;
                }
                stack[place] = (node.children[child].entry(), near[child]);
                open += 1;
            }
        }
        limit
    }
}
