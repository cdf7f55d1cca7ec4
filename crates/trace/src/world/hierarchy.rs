//! A hierarchy of boxes over anything that has bounds. It knows boxes and items only; the caller owns the items.
//!
//! Built from the top down with binned surface-area heuristic (Wald 2007). The boxes cull conservatively: a ray that
//! can hit an item always reaches it, so the answer is that of trying every item.

use crate::Ray;
use glam::DVec3;

/// A box along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) low: DVec3,
    pub(crate) high: DVec3,
}

impl Bounds {
    const EMPTY: Bounds = Bounds { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// The box around points.
    pub(crate) fn of(points: impl IntoIterator<Item = DVec3>) -> Bounds {
        points
            .into_iter()
            .fold(Bounds::EMPTY, |bounds, point| Bounds { low: bounds.low.min(point), high: bounds.high.max(point) })
    }

    /// The box moved outwards by a few roundings of its greatest coordinate, so that a hit that is computed at its
    /// face lies inside of it.
    pub(crate) fn widened(self) -> Bounds {
        let slack = DVec3::splat(8.0 * f64::EPSILON * self.low.abs().max(self.high.abs()).max_element());
        Bounds { low: self.low - slack, high: self.high + slack }
    }

    /// Whether a point lies in the box or on its face.
    pub(crate) fn contains(&self, point: DVec3) -> bool {
        self.low.cmple(point).all() && self.high.cmpge(point).all()
    }

    fn union(self, other: Bounds) -> Bounds {
        Bounds { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    fn center(&self) -> DVec3 {
        self.low * 0.5 + self.high * 0.5
    }

    fn half_area(&self) -> f64 {
        let size = (self.high - self.low).max(DVec3::ZERO);
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

#[derive(Clone, Debug)]
struct Node {
    bounds: Bounds,
    /// A leaf's first place in `items`, or an inner node's first child; the second child follows it.
    first: u32,
    /// A leaf's number of items; 0 for an inner node.
    count: u32,
}

/// The hierarchy. An empty one has no nodes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Hierarchy {
    nodes: Vec<Node>,
    items: Vec<u32>,
}

/// Leaves of at most this many items are not worth a split.
const LEAF: usize = 4;
const BINS: usize = 16;
/// So few items are all tried at once: that is cheaper than to walk down to them.
const FEW: usize = 12;
/// Below this level nodes are split in halves by count, which bounds the depth whatever the input.
const SAH_LEVELS: u32 = 48;
/// `SAH_LEVELS` and 32 halvings of at most 2³² items.
const MAX_DEPTH: usize = 96;

impl Hierarchy {
    /// Builds over the bounds of items 0, 1, 2 …
    pub(crate) fn build(bounds: &[Bounds]) -> Hierarchy {
        let mut items: Vec<u32> = (0..bounds.len() as u32).collect();
        let mut nodes = Vec::new();
        if !items.is_empty() {
            nodes.push(Node { bounds: Bounds::EMPTY, first: 0, count: 0 });
            let mut open = vec![(0_usize, 0_usize, items.len(), 0_u32)];
            while let Some((node, begin, end, level)) = open.pop() {
                let members = &mut items[begin..end];
                nodes[node].bounds = members.iter().fold(Bounds::EMPTY, |all, &item| all.union(bounds[item as usize]));
                let Some(split) = split(members, bounds, level) else {
                    nodes[node].first = begin as u32;
                    nodes[node].count = (end - begin) as u32;
                    continue;
                };
                let child = nodes.len();
                nodes[node].first = child as u32;
                nodes.extend([
                    Node { bounds: Bounds::EMPTY, first: 0, count: 0 },
                    Node { bounds: Bounds::EMPTY, first: 0, count: 0 },
                ]);
                open.push((child, begin, begin + split, level + 1));
                open.push((child + 1, begin + split, end, level + 1));
            }
        }
        Hierarchy { nodes, items }
    }

    /// The box around everything.
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        self.nodes.first().map(|root| root.bounds)
    }

    /// The memory that it takes.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice()) + size_of_val(self.items.as_slice())
    }

    /// Visits every item whose box the ray meets before `limit`, nearer boxes first. `visit` gets the item and the
    /// limit and gives the new one; a negative limit ends the visit.
    pub(crate) fn visit(&self, ray: &Ray, mut limit: f64, mut visit: impl FnMut(u32, f64) -> f64) {
        let Some(root) = self.nodes.first() else { return };
        let Some(near) = enter(&root.bounds, ray) else { return };
        if self.items.len() <= FEW {
            if near <= limit {
                for &item in &self.items {
                    limit = visit(item, limit);
                    if limit < 0.0 {
                        return;
                    }
                }
            }
            return;
        }
        let mut stack = [(0_u32, 0.0_f64); MAX_DEPTH];
        stack[0] = (0, near);
        let mut open = 1;
        while open > 0 {
            open -= 1;
            let (node, near) = stack[open];
            if near > limit {
                continue;
            }
            let Node { first, count, .. } = self.nodes[node as usize];
            if count > 0 {
                for &item in &self.items[first as usize..(first + count) as usize] {
                    limit = visit(item, limit);
                    if limit < 0.0 {
                        return;
                    }
                }
                continue;
            }
            let mut push = |child: u32, near: Option<f64>| {
                if let Some(near) = near
                    && near <= limit
                {
                    stack[open] = (child, near);
                    open += 1;
                }
            };
            let nears = [first, first + 1].map(|child| enter(&self.nodes[child as usize].bounds, ray));
            let second_is_nearer = matches!(nears, [Some(a), Some(b)] if b < a);
            // the one pushed last is visited first
            if second_is_nearer {
                push(first, nears[0]);
                push(first + 1, nears[1]);
            } else {
                push(first + 1, nears[1]);
                push(first, nears[0]);
            }
        }
    }
}

/// Where the members are cut in two, after partitioning them; `None` for a leaf.
fn split(members: &mut [u32], bounds: &[Bounds], level: u32) -> Option<usize> {
    if members.len() <= LEAF {
        return None;
    }
    let centers = Bounds::of(members.iter().map(|&item| bounds[item as usize].center()));
    let size = centers.high - centers.low;
    let axis = if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    };
    let halves = members.len() / 2;
    if level >= SAH_LEVELS || size[axis] <= 0.0 || !size[axis].is_finite() {
        members.sort_unstable_by(|&a, &b| {
            bounds[a as usize].center()[axis].total_cmp(&bounds[b as usize].center()[axis]).then(a.cmp(&b))
        });
        return Some(halves);
    }
    let scale = BINS as f64 / size[axis];
    let bin = |item: u32| (((bounds[item as usize].center()[axis] - centers.low[axis]) * scale) as usize).min(BINS - 1);
    let mut bins = [(Bounds::EMPTY, 0_usize); BINS];
    for &item in members.iter() {
        let (around, count) = &mut bins[bin(item)];
        *around = around.union(bounds[item as usize]);
        *count += 1;
    }
    // the cost of everything to the right of each cut
    let mut right = [0.0; BINS];
    let (mut around, mut count) = (Bounds::EMPTY, 0);
    for cut in (1..BINS).rev() {
        around = around.union(bins[cut].0);
        count += bins[cut].1;
        right[cut] = around.half_area() * count as f64;
    }
    let (mut around, mut count) = (Bounds::EMPTY, 0);
    let mut best = (f64::INFINITY, 0);
    for cut in 1..BINS {
        around = around.union(bins[cut - 1].0);
        count += bins[cut - 1].1;
        let cost = around.half_area() * count as f64 + right[cut];
        if count > 0 && count < members.len() && cost < best.0 {
            best = (cost, cut);
        }
    }
    // the extremes of the centres fall into the first and the last bin, so some cut parts them
    let mut kept = 0;
    for place in 0..members.len() {
        if bin(members[place]) < best.1 {
            members.swap(place, kept);
            kept += 1;
        }
    }
    Some(if kept == 0 || kept == members.len() { halves } else { kept })
}

/// The distance at which the ray enters the box, 0 if it starts inside; `None` if it misses. The far distance is
/// widened by twice the rounding of a slab (Ize 2013), the near one narrowed.
fn enter(bounds: &Bounds, ray: &Ray) -> Option<f64> {
    const SLACK: f64 = 8.0 * f64::EPSILON;
    let (mut near, mut far) = (0.0_f64, f64::INFINITY);
    for axis in 0..3 {
        let (low, high) = (bounds.low[axis] - ray.origin[axis], bounds.high[axis] - ray.origin[axis]);
        let along = ray.direction[axis];
        if along == 0.0 {
            if low > 0.0 || high < 0.0 {
                return None;
            }
            continue;
        }
        let (a, b) = (low / along, high / along);
        near = near.max(a.min(b) * (1.0 - SLACK));
        far = far.min(a.max(b) * (1.0 + SLACK));
    }
    (near <= far).then_some(near)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point(scale: f64) -> impl Strategy<Value = DVec3> {
        [-scale..scale, -scale..scale, -scale..scale].prop_map(DVec3::from)
    }

    proptest! {
        /// Every item whose own box the ray meets is visited, and each once.
        #[test]
        fn nothing_is_missed(
            boxes in prop::collection::vec((point(10.0), point(2.0)), 0..200),
            origin in point(15.0),
            target in point(5.0),
        ) {
            let bounds: Vec<Bounds> = boxes.iter().map(|&(at, size)| Bounds::of([at, at + size])).collect();
            let ray = Ray { origin, direction: (target - origin).normalize() };
            let mut visited = Vec::new();
            Hierarchy::build(&bounds).visit(&ray, f64::INFINITY, |item, limit| {
                visited.push(item);
                limit
            });
            visited.sort_unstable();
            prop_assert!(visited.windows(2).all(|pair| pair[0] < pair[1]));
            for (item, bounds) in (0..).zip(&bounds) {
                if enter(bounds, &ray).is_some() {
                    prop_assert!(visited.binary_search(&item).is_ok());
                }
            }
        }
    }

    #[test]
    fn equal_and_growing_boxes_stay_shallow() {
        for bounds in [
            vec![Bounds { low: DVec3::ZERO, high: DVec3::ONE }; 5000],
            (0..1000).map(|n| Bounds::of([DVec3::ZERO, DVec3::X * 1.7_f64.powi(n)])).collect(),
        ] {
            let hierarchy = Hierarchy::build(&bounds);
            let ray = Ray { origin: DVec3::new(0.5, 0.5, -1.0), direction: DVec3::Z };
            let mut visited = 0;
            hierarchy.visit(&ray, f64::INFINITY, |_, limit| {
                visited += 1;
                limit
            });
            assert!(visited <= bounds.len());
        }
    }
}
