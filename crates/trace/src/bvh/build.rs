//! Building a hierarchy from the top down with the binned surface-area heuristic (Wald 2007), straight to wide nodes:
//! the set of a node is cut again and again where its greatest part is, until it has eight parts.

use super::{Bounds, Child, MAX_DEPTH, NO_FACET, Node, WIDTH};
use glam::DVec3;

/// A thing to be sorted into the hierarchy: its box relative to the frame's origin, rounded outwards.
#[repr(C, align(32))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Item {
    low: [f32; 3],
    number: u32,
    high: [f32; 3],
}

/// Where a hierarchy's single-precision coordinates start, and how far they may be off.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    origin: DVec3,
    slack: f64,
}

impl Frame {
    /// The frame of everything within those bounds: its origin is their middle, where `f32` is finest.
    pub(crate) fn around(bounds: Bounds) -> Frame {
        // the slack covers the rounding of the subtraction of the origin, and what f32 cannot tell from 0
        let slack = (4.0 * f64::EPSILON * bounds.reach()).max(f64::from(f32::MIN_POSITIVE));
        Frame { origin: bounds.center(), slack }
    }

    pub(crate) fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The item of that number with those bounds.
    pub(crate) fn item(&self, number: u32, bounds: Bounds) -> Item {
        // a rounding to f32 is off by 2⁻²⁴ of the number at most: twice that, and it lands beyond
        const OUTWARDS: f64 = 1.0 / (1 << 23) as f64;
        let (low, high) = (bounds.low - self.origin - self.slack, bounds.high - self.origin + self.slack);
        let (low, high) = (low - low.abs() * OUTWARDS, high + high.abs() * OUTWARDS);
        Item { low: low.to_array().map(|x| x as f32), number, high: high.to_array().map(|x| x as f32) }
    }
}

/// Below this level nodes are cut in halves by count, which bounds the depth whatever the input: 11 levels of eight
/// equal parts hold 2³² items.
const SAH_LEVELS: usize = MAX_DEPTH - 12;
const BINS: usize = 16;
/// What it costs to test a pack of items, against a node's eight boxes.
const PACK_COST: f32 = 1.0;

/// A box in single precision.
#[derive(Clone, Copy, Debug)]
struct Box32 {
    low: [f32; 3],
    high: [f32; 3],
}

impl Box32 {
    const EMPTY: Box32 = Box32 { low: [f32::INFINITY; 3], high: [f32::NEG_INFINITY; 3] };

    fn with(mut self, low: &[f32; 3], high: &[f32; 3]) -> Box32 {
        for axis in 0..3 {
            self.low[axis] = self.low[axis].min(low[axis]);
            self.high[axis] = self.high[axis].max(high[axis]);
        }
        self
    }

    fn half_area(&self) -> f32 {
        let [x, y, z] = [0, 1, 2].map(|axis| (self.high[axis] - self.low[axis]).max(0.0));
        x * y + y * z + z * x
    }
}

/// Twice the middle of an item along an axis.
fn center(item: &Item, axis: usize) -> f32 {
    item.low[axis] + item.high[axis]
}

/// A part of the items that becomes one child.
struct Part<'a> {
    items: &'a mut [Item],
    around: Box32,
    /// Where it would be cut; `None` if it is a leaf.
    cut: Option<Cut>,
}

#[derive(Clone, Copy)]
enum Cut {
    /// Items below that bin of the axis go left.
    Bin { axis: usize, bin: usize, low: f32, scale: f32 },
    /// The first half along the axis goes left.
    Half { axis: usize },
}

/// The nodes over the items, the root first, and the numbers of the items in the order of the leaves.
pub(super) fn build(mut items: Vec<Item>, pack: usize) -> (Vec<Node>, Vec<u32>) {
    items.truncate(Child::PLACES);
    let mut builder = Builder { pack, nodes: vec![Node::EMPTY], order: Vec::with_capacity(items.len()) };
    let part = builder.part(&mut items, 0);
    builder.fill(0, part, 0);
    (builder.nodes, builder.order)
}

struct Builder {
    pack: usize,
    nodes: Vec<Node>,
    order: Vec<u32>,
}

impl Builder {
    /// Makes the children of a node out of one part.
    fn fill(&mut self, node: usize, part: Part<'_>, level: usize) {
        let mut parts = vec![part];
        while parts.len() < WIDTH {
            let Some((place, cut)) = next_to_cut(&parts, level) else { break };
            let Part { items, .. } = parts.swap_remove(place);
            let left = cut.apply(items);
            let (left, right) = items.split_at_mut(left);
            parts.extend([self.part(left, level), self.part(right, level)]);
        }
        for (place, part) in parts.into_iter().enumerate() {
            let child = if part.cut.is_none() {
                self.leaf(part.items)
            } else {
                let child = self.nodes.len();
                self.nodes.push(Node::EMPTY);
                let Box32 { low, high } = part.around;
                self.set_child(node, place, Child::inner(child as u32), &Box32 { low, high });
                // from here on other cuts are made
                let part = if level + 1 == SAH_LEVELS { self.part(part.items, level + 1) } else { part };
                self.fill(child, part, level + 1);
                continue;
            };
            self.set_child(node, place, child, &part.around);
        }
    }

    fn set_child(&mut self, node: usize, place: usize, child: Child, around: &Box32) {
        let node = &mut self.nodes[node];
        node.children[place] = child;
        for axis in 0..3 {
            node.low[axis][place] = around.low[axis];
            node.high[axis][place] = around.high[axis];
        }
    }

    fn leaf(&mut self, items: &[Item]) -> Child {
        let first = self.order.len() / self.pack;
        self.order.extend(items.iter().map(|item| item.number));
        let packs = items.len().div_ceil(self.pack);
        self.order.resize((first + packs) * self.pack, NO_FACET);
        Child::leaf(first as u32, packs as u32)
    }

    fn part<'a>(&self, items: &'a mut [Item], level: usize) -> Part<'a> {
        let around = items.iter().fold(Box32::EMPTY, |all, item| all.with(&item.low, &item.high));
        let cut = self.cut(items, &around, level);
        Part { items, around, cut }
    }

    fn cut(&self, items: &[Item], around: &Box32, level: usize) -> Option<Cut> {
        if items.len() <= self.pack {
            return None;
        }
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for item in items {
            for axis in 0..3 {
                low[axis] = low[axis].min(center(item, axis));
                high[axis] = high[axis].max(center(item, axis));
            }
        }
        let size = [0, 1, 2].map(|axis| high[axis] - low[axis]);
        let longest = (0..3).fold(0, |best, axis| if size[axis] > size[best] { axis } else { best });
        let packs = |count: usize| count.div_ceil(self.pack) as f32;
        let best = if level < SAH_LEVELS { self.best_bin(items, &low, &size) } else { None };
        let area = around.half_area();
        if items.len() <= self.pack * Child::MOST {
            let split = best.map_or(f32::INFINITY, |(cost, _)| area + PACK_COST * cost);
            if PACK_COST * packs(items.len()) * area <= split {
                return None;
            }
        }
        Some(best.map_or(Cut::Half { axis: longest }, |(_, cut)| cut))
    }

    /// The cheapest cut between bins, and the areas of its two parts times their packs.
    fn best_bin(&self, items: &[Item], low: &[f32; 3], size: &[f32; 3]) -> Option<(f32, Cut)> {
        let packs = |count: usize| count.div_ceil(self.pack) as f32;
        let mut best: Option<(f32, Cut)> = None;
        for axis in 0..3 {
            let scale = BINS as f32 / size[axis];
            if !(size[axis] > 0.0 && scale.is_finite() && size[axis].is_finite()) {
                continue;
            }
            let mut bins = [(Box32::EMPTY, 0_usize); BINS];
            for item in items {
                let (around, count) = &mut bins[bin(item, axis, low[axis], scale)];
                *around = around.with(&item.low, &item.high);
                *count += 1;
            }
            let mut right = [(0.0, 0); BINS];
            let (mut around, mut count) = (Box32::EMPTY, 0);
            for cut in (1..BINS).rev() {
                around = around.with(&bins[cut].0.low, &bins[cut].0.high);
                count += bins[cut].1;
                right[cut] = (around.half_area() * packs(count), count);
            }
            let (mut around, mut count) = (Box32::EMPTY, 0);
            for cut in 1..BINS {
                around = around.with(&bins[cut - 1].0.low, &bins[cut - 1].0.high);
                count += bins[cut - 1].1;
                let cost = around.half_area() * packs(count) + right[cut].0;
                if count > 0 && right[cut].1 > 0 && best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, Cut::Bin { axis, bin: cut, low: low[axis], scale }));
                }
            }
        }
        best
    }
}

/// The part to cut next and how: the widest one that is no leaf, or where only the depth counts, the one of most items.
fn next_to_cut(parts: &[Part<'_>], level: usize) -> Option<(usize, Cut)> {
    let size = |part: &Part<'_>| if level < SAH_LEVELS { part.around.half_area() } else { part.items.len() as f32 };
    let mut best: Option<(f32, usize, Cut)> = None;
    for (place, part) in parts.iter().enumerate() {
        if let Some(cut) = part.cut
            && best.is_none_or(|(most, _, _)| size(part) > most)
        {
            best = Some((size(part), place, cut));
        }
    }
    best.map(|(_, place, cut)| (place, cut))
}

fn bin(item: &Item, axis: usize, low: f32, scale: f32) -> usize {
    (((center(item, axis) - low) * scale) as usize).min(BINS - 1)
}

impl Cut {
    /// Partitions the items and gives the number of those that go left.
    fn apply(self, items: &mut [Item]) -> usize {
        match self {
            Cut::Bin { axis, bin: cut, low, scale } => {
                let mut kept = 0;
                for place in 0..items.len() {
                    if bin(&items[place], axis, low, scale) < cut {
                        items.swap(place, kept);
                        kept += 1;
                    }
                }
                kept
            }
            Cut::Half { axis } => {
                let half = items.len() / 2;
                items.select_nth_unstable_by(half, |a, b| {
                    center(a, axis).total_cmp(&center(b, axis)).then(a.number.cmp(&b.number))
                });
                half
            }
        }
    }
}
