//! How good a hierarchy is: what a ray through it meets on average.

use super::{Bvh, Entry, Node, WIDTH};

impl Bvh {
    /// The nodes and the counted things of leaves that a random line through the bounds meets on average: a convex body
    /// within another is met in proportion to its surface (Goldsmith and Salmon 1987).
    pub(crate) fn cost(&self) -> f64 {
        let mut met = 0.0;
        let mut whole = 0.0;
        for (number, node) in self.nodes().iter().enumerate() {
            let mut around = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
            for child in (0..WIDTH).filter(|&child| node.low[0][child] <= node.high[0][child]) {
                let own = corners(node, child);
                for axis in 0..3 {
                    around = [min(around[0], own[0], axis), max(around[1], own[1], axis)];
                }
                met += half_area(&own)
                    * match node.children[child].entry() {
                        Entry::Inner(_) => 1.0,
                        Entry::Leaf { count, .. } => f64::from(count),
                    };
            }
            if number == 0 {
                whole = half_area(&around);
                met += whole;
            }
        }
        if whole > 0.0 { met / whole } else { 0.0 }
    }
}

fn corners(node: &Node, child: usize) -> [[f64; 3]; 2] {
    [&node.low, &node.high].map(|side| [0, 1, 2].map(|axis| f64::from(side[axis][child])))
}

fn min(mut a: [f64; 3], b: [f64; 3], axis: usize) -> [f64; 3] {
    a[axis] = a[axis].min(b[axis]);
    a
}

fn max(mut a: [f64; 3], b: [f64; 3], axis: usize) -> [f64; 3] {
    a[axis] = a[axis].max(b[axis]);
    a
}

fn half_area([low, high]: &[[f64; 3]; 2]) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|axis| high[axis] - low[axis]);
    x * y + y * z + z * x
}
