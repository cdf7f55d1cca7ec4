//! How far the things in a hierarchy reach along a direction, found without looking at all of them: so a mesh that is
//! moved has its exact bounds at once.

use super::{Bvh, Entry, MAX_DEPTH, Node, WIDTH};
use glam::DVec3;

impl Bvh {
    /// The greatest of the leaves' values, where `value` of a leaf is the greatest `along · p` over its points `p`, to
    /// within `slack`. Without leaves it is `-∞`.
    pub(crate) fn greatest(&self, along: DVec3, slack: f64, value: impl Fn(u32, u32) -> f64) -> f64 {
        let mut greatest = f64::NEG_INFINITY;
        if self.nodes().is_empty() {
            return greatest;
        }
        let here = along.dot(self.origin()) + slack;
        let mut stack = [(Entry::Inner(0), f64::INFINITY); MAX_DEPTH * (WIDTH - 1) + 1];
        let mut open = 1;
        while open > 0 {
            open -= 1;
            let (entry, most) = stack[open];
            if most <= greatest {
                continue;
            }
            let node = match entry {
                Entry::Leaf { first, count } => {
                    greatest = greatest.max(value(first, count));
                    continue;
                }
                Entry::Inner(node) => &self.nodes()[node as usize],
            };
            let bottom = open;
            for child in 0..WIDTH {
                if node.low[0][child] > node.high[0][child] {
                    continue;
                }
                let most = here + reach(node, child, along);
                // the farthest one lies on top
                let mut place = open;
                while place > bottom && stack[place - 1].1 > most {
                    stack[place] = stack[place - 1];
                    place -= 1;
                }
                stack[place] = (node.children[child].entry(), most);
                open += 1;
            }
        }
        greatest
    }
}

/// The greatest `along · p` over the points `p` of a child's box.
fn reach(node: &Node, child: usize, along: DVec3) -> f64 {
    let mut most = 0.0;
    for axis in 0..3 {
        let (low, high) = (f64::from(node.low[axis][child]), f64::from(node.high[axis][child]));
        most += (along[axis] * low).max(along[axis] * high);
    }
    most
}

#[cfg(test)]
mod tests {
    use super::super::Bounds;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_greatest_is_that_of_all(
            points in prop::collection::vec([-9.0..9.0, -9.0..9.0, -9.0..9.0], 0..300),
            along in [-1.0..1.0, -1.0..1.0, -1.0..1.0],
        ) {
            let along = DVec3::from(along);
            let points: Vec<DVec3> = points.into_iter().map(DVec3::from).collect();
            let bounds: Vec<Bounds> = points.iter().map(|&point| Bounds { low: point, high: point }).collect();
            let (bvh, order) = Bvh::build(&bounds);
            let asked = std::cell::Cell::new(0);
            let found = bvh.greatest(along, 1e-14, |first, count| {
                asked.set(asked.get() + count);
                let leaf = &order[first as usize..(first + count) as usize];
                leaf.iter().map(|&item| along.dot(points[item as usize])).fold(f64::NEG_INFINITY, f64::max)
            });
            prop_assert_eq!(found, points.iter().map(|&point| along.dot(point)).fold(f64::NEG_INFINITY, f64::max));
            prop_assert!(asked.get() <= 60, "{} of {} points were asked", asked.get(), points.len());
        }
    }
}
