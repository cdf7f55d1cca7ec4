//! Building a hierarchy: a binary tree is grown from the top down by the binned surface-area heuristic, its nodes are put
//! together to wide ones at the least cost, and their boxes are made from the items at last.

mod bins;
mod few;
mod grow;
mod part;
mod snapped;
mod tree;

use super::huge::prefer_huge_pages;
use super::{Bounds, Bvh, Child, Node};
use bytemuck::Zeroable;
use glam::DVec3;
use grow::{Grown, Local, grow};
use rayon::prelude::*;
use tree::{Size, Tree, Twig, spread};

/// What a hierarchy is built over.
pub(crate) trait Source: Sync {
    /// What the leaves hold: a few items, ready for rays.
    type Pack: Zeroable + Send;
    /// How many items a pack has place for.
    const PACK: usize;

    /// How many items there are; no more than [`Child::PLACES`] are taken.
    fn len(&self) -> usize;

    /// A box around all items, if possible not much too large.
    fn hull(&self) -> Bounds;

    /// The bounds of an item.
    fn bounds(&self, number: u32) -> Bounds;

    /// What it costs a ray to try the packs of a leaf, where trying the boxes of a node costs 1.
    fn cost(packs: usize) -> f32;

    /// Packs at most [`Source::PACK`] items and gives the box around them.
    fn pack(&self, numbers: &[u32], frame: &Frame, place: &mut Self::Pack) -> Bounds;
}

/// Where a hierarchy's single-precision coordinates start, and how far they may be off.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    origin: DVec3,
    slack: f64,
}

impl Frame {
    /// The frame of everything within those bounds: its origin is their middle, where `f32` is finest.
    fn around(bounds: Bounds) -> Frame {
        // the slack covers the rounding of the subtraction of the origin, and what f32 cannot tell from 0
        let slack = (4.0 * f64::EPSILON * bounds.reach()).max(f64::from(f32::MIN_POSITIVE));
        Frame { origin: bounds.center(), slack }
    }

    pub(crate) fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The bounds relative to the origin, rounded outwards.
    fn outwards(&self, bounds: Bounds) -> [[f32; 3]; 2] {
        // a rounding to f32 is off by 2⁻²⁴ of the number at most: twice that, and it lands beyond
        const OUTWARDS: f64 = 1.0 / (1 << 23) as f64;
        let (low, high) = (bounds.low - self.origin - self.slack, bounds.high - self.origin + self.slack);
        let (low, high) = (low - low.abs() * OUTWARDS, high + high.abs() * OUTWARDS);
        [low, high].map(|corner| corner.to_array().map(|x| x as f32))
    }
}

/// A child with the box around it.
type Place = (Child, Bounds);

/// The hierarchy over a source and its packs in the order of the leaves.
pub(super) fn build<S: Source>(source: &S) -> (Bvh, Vec<S::Pack>) {
    let count = source.len().min(Child::PLACES);
    if count == 0 {
        return (Bvh::default(), Vec::new());
    }
    if count <= grow::LOCAL {
        return build_all(source, count);
    }
    // on the threads of the pool altogether
    let mut built = None;
    rayon::scope(|_| built = Some(build_all(source, count)));
    built.unwrap_or_default()
}

fn build_all<S: Source>(source: &S, count: usize) -> (Bvh, Vec<S::Pack>) {
    let mut order = vec![0; count];
    prefer_huge_pages(&order);
    let (grown, bounds) = grow(source, &mut order);

    let mut top = Tree::NEW;
    let mut locals = Vec::new();
    gather(grown, &mut top, &mut locals);
    let inner = if locals.len() > 1 { Size::of(&top.twigs, S::PACK).nodes } else { 0 };
    let size = locals.iter().fold(Size { nodes: inner, packs: 0 }, |all, local| all.and(local.size));
    // a leaf alone hangs on a node too
    let top_nodes = if size.nodes == 0 { 1 } else { inner };
    let mut nodes = bytemuck::allocation::zeroed_vec::<Node>(size.nodes.max(1));
    let mut packs = bytemuck::allocation::zeroed_vec::<S::Pack>(size.packs);
    prefer_huge_pages(&nodes);
    prefer_huge_pages(&packs);
    let frame = Frame::around(bounds);
    let places = fill(source, &frame, &order, &locals, &mut nodes, top_nodes, &mut packs);
    let mut writer = Writer { frame: &frame, nodes: &mut nodes[..top_nodes], base: 0, next: 1 };
    if locals.len() > 1 {
        writer.node(&top.twigs, top.last(), 0, &mut |twig| places[twig.first as usize]);
    } else if top_nodes == 1 {
        writer.nodes[0] = writer.of(&places);
    }
    (Bvh { origin: frame.origin(), nodes, bounds: Some(bounds) }, packs)
}

/// Puts the upper part of the tree together; a leaf of it is one of `locals`.
fn gather(grown: Grown, top: &mut Tree, locals: &mut Vec<Local>) -> u32 {
    match grown {
        Grown::Local(local) => {
            locals.push(local);
            top.leaf(locals.len() - 1, 0, 0.0)
        }
        Grown::Fork { area, children } => {
            let [left, right] = *children;
            let left = gather(left, top, locals);
            gather(right, top, locals);
            top.fork(left, 0, 0, area, f32::INFINITY)
        }
    }
}

/// Writes nodes and packs of all locals, each by itself, and gives what their parents have to know.
fn fill<S: Source>(
    source: &S,
    frame: &Frame,
    order: &[u32],
    locals: &[Local],
    nodes: &mut [Node],
    first_node: usize,
    mut packs: &mut [S::Pack],
) -> Vec<Place> {
    let mut jobs = Vec::with_capacity(locals.len());
    let mut base = Size { nodes: first_node, packs: 0 };
    let mut nodes = &mut nodes[first_node..];
    for local in locals {
        let (own_nodes, other_nodes) = nodes.split_at_mut(local.size.nodes);
        let (own_packs, other_packs) = packs.split_at_mut(local.size.packs);
        jobs.push((local, base, own_nodes, own_packs));
        base = base.and(local.size);
        (nodes, packs) = (other_nodes, other_packs);
    }
    let fill = |(local, base, nodes, packs): (&Local, Size, &mut [Node], &mut [S::Pack])| {
        let twigs = &local.twigs;
        let (mut unused, mut first) = (packs.iter_mut(), base.packs);
        let mut leaf = |twig: &Twig| {
            let numbers = &order[twig.first as usize..(twig.first + twig.count) as usize];
            let runs = numbers.chunks(S::PACK).zip(&mut unused);
            let around = runs.fold(Bounds::EMPTY, |all, (run, place)| all.union(source.pack(run, frame, place)));
            let count = numbers.len().div_ceil(S::PACK);
            first += count;
            (Child::leaf((first - count) as u32, count as u32), around)
        };
        let root = twigs.len() as u32 - 1;
        if nodes.is_empty() {
            return leaf(&twigs[root as usize]);
        }
        let mut writer = Writer { frame, nodes, base: base.nodes, next: 1 };
        let around = writer.node(twigs, root, 0, &mut leaf);
        (Child::inner(base.nodes as u32), around)
    };
    if jobs.len() == 1 { jobs.into_iter().map(fill).collect() } else { jobs.into_par_iter().map(fill).collect() }
}

/// Writes the nodes of one part of the tree.
struct Writer<'a> {
    frame: &'a Frame,
    nodes: &'a mut [Node],
    /// The number of the first of these nodes among all.
    base: usize,
    next: usize,
}

impl Writer<'_> {
    /// Writes the wide node of a binary one, and all below it. Siblings stand side by side.
    fn node(&mut self, twigs: &[Twig], node: u32, at: usize, leaf: &mut impl FnMut(&Twig) -> Place) -> Bounds {
        let spread = spread(twigs, node);
        let mut places = [(Child::inner(0), Bounds::EMPTY); super::WIDTH];
        let places = &mut places[..spread.nodes().len()];
        let first = self.next;
        for (place, &child) in places.iter_mut().zip(spread.nodes()) {
            let twig = &twigs[child as usize];
            if twig.is_leaf() {
                *place = leaf(twig);
            } else {
                place.0 = Child::inner((self.base + self.next) as u32);
                self.next += 1;
            }
        }
        let mut inner = first;
        for (place, &child) in places.iter_mut().zip(spread.nodes()) {
            if !twigs[child as usize].is_leaf() {
                inner += 1;
                place.1 = self.node(twigs, child, inner - 1, leaf);
            }
        }
        self.nodes[at] = self.of(places);
        places.iter().fold(Bounds::EMPTY, |all, (_, around)| all.union(*around))
    }

    fn of(&self, places: &[Place]) -> Node {
        let mut node = Node::EMPTY;
        for (place, (child, around)) in places.iter().enumerate() {
            let [low, high] = self.frame.outwards(*around);
            node.children[place] = *child;
            for axis in 0..3 {
                node.low[axis][place] = low[axis];
                node.high[axis][place] = high[axis];
            }
        }
        node
    }
}
