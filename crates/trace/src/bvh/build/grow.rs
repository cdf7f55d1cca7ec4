//! The binary tree over a set of boxes, from the top down. Great sets are cut by all threads; sets that fit a thread's
//! cache are its own, on a lattice of their own.

use super::Source;
use super::bins::{Bins, Cut, Map};
use super::few::{FEW, cut_few};
use super::part::{part, sort};
use super::snapped::{Lattice, Snapped};
use super::tree::{Size, Tree, Twig};
use crate::bvh::huge::prefer_huge_pages;
use crate::bvh::{Bounds, Child, MAX_DEPTH};
use rayon::prelude::*;
use std::cell::RefCell;

/// Sets of no more boxes are built by one thread in its own memory.
pub(super) const LOCAL: usize = 1 << 12;

/// A part of the tree.
pub(super) enum Grown {
    Local(Local),
    Fork { area: f32, children: Box<[Grown; 2]> },
}

/// A part of the tree that one thread built; its root is the last node.
pub(super) struct Local {
    pub(super) twigs: Vec<Twig>,
    pub(super) size: Size,
}

/// A set on its way into the tree.
struct Set<'a> {
    boxes: &'a mut [Snapped],
    /// As many places for them to be moved to.
    spare: &'a mut [Snapped],
    /// Where the items' numbers are left when they have their places.
    order: &'a mut [u32],
    /// The place of the first one in the order of all.
    first: usize,
    around: Snapped,
    lattice: Lattice,
    map: Map,
    level: usize,
}

/// The memory that a thread builds in.
struct Scratch {
    boxes: Vec<Snapped>,
    spare: Vec<Snapped>,
    /// The bins of both parts, by level.
    bins: Vec<[Bins; 2]>,
    tree: Tree,
}

thread_local! {
    static SCRATCH: RefCell<Scratch> = const {
        RefCell::new(Scratch { boxes: Vec::new(), spare: Vec::new(), bins: Vec::new(), tree: Tree::NEW })
    };
}

impl<'a> Set<'a> {
    fn area(&self) -> f32 {
        self.area_of(self.around)
    }

    fn area_of(&self, around: Snapped) -> f32 {
        around.half_area() as f32 * self.lattice.unit
    }

    /// Whether the set must be halved, so that the depth is bounded: there are no more levels than halving needs, after
    /// a cut that parts off a single box.
    fn must_be_halved(&self) -> bool {
        let halvings = self.boxes.len().next_power_of_two().trailing_zeros() as usize;
        self.level + 1 + halvings > MAX_DEPTH
    }

    /// The best cut. `bins` hold the boxes already; they are sorted into `others` where those do not tell them apart.
    fn cut<S: Source>(&self, bins: &Bins, others: &mut Bins) -> Option<Cut> {
        if self.must_be_halved() {
            return None;
        }
        bins.best::<S>(&self.map, self.boxes.len()).or_else(|| {
            let map = Map::over_centers(self.boxes);
            others.fill(self.boxes, &map);
            others.best::<S>(&map, self.boxes.len())
        })
    }

    /// Cuts the set in two and sorts the parts into bins.
    fn divide(self, cut: Option<Cut>, bins: &mut [Bins; 2]) -> [Set<'a>; 2] {
        let Set { boxes, spare, order, first, around, lattice, level, .. } = self;
        let count = boxes.len();
        let (left, items, around, boxes, spare) = match cut {
            Some(cut) => {
                part(boxes, spare, &cut);
                (cut.boxes, cut.items, cut.around, spare, boxes)
            }
            None => {
                let (axis, half) = (around.longest(), count / 2);
                boxes.select_nth_unstable_by_key(half, |item| (item.center(axis), item.number()));
                let (left, right) = boxes.split_at(half);
                (half, items(left), [Snapped::around(left), Snapped::around(right)], boxes, spare)
            }
        };
        let (boxes, spare, order) = (boxes.split_at_mut(left), spare.split_at_mut(left), order.split_at_mut(items));
        let [left_bins, right_bins] = bins;
        let set = |boxes: &'a mut [Snapped], spare, order, first, around, bins: &mut Bins| {
            let map = Map::over(around, boxes.len());
            // smaller sets are cut without bins
            if boxes.len() > FEW {
                sort(boxes, &map, bins);
            }
            Set { boxes, spare, order, first, around, lattice, map, level: level + 1 }
        };
        [
            set(boxes.0, spare.0, order.0, first, around[0], left_bins),
            set(boxes.1, spare.1, order.1, first + items, around[1], right_bins),
        ]
    }

    /// Cuts a set of a few boxes in two.
    fn divide_few<S: Source>(self) -> [Set<'a>; 2] {
        let Set { boxes, spare, order, first, lattice, map, level, .. } = self;
        let (left, around) = cut_few::<S>(boxes);
        let items = items(&boxes[..left]);
        let (boxes, spare, order) = (boxes.split_at_mut(left), spare.split_at_mut(left), order.split_at_mut(items));
        let (level, [left, right]) = (level + 1, around);
        [
            Set { boxes: boxes.0, spare: spare.0, order: order.0, first, around: left, lattice, map, level },
            Set {
                boxes: boxes.1,
                spare: spare.1,
                order: order.1,
                first: first + items,
                around: right,
                lattice,
                map,
                level,
            },
        ]
    }

    /// Whether the set is so small on its lattice that another one would serve it better: there the boxes of a surface
    /// were a few steps wide.
    fn is_coarse(&self) -> bool {
        let size = u64::from(self.around.size(self.around.longest()));
        size < 1 << 10 && size * size < (self.boxes.len() as u64) << 10
    }

    /// Puts the set on a lattice of its own and into bins, if that one is finer.
    fn refine<S: Source>(&mut self, source: &S, bins: &mut Bins) -> bool {
        let exact = self.boxes.iter().map(|item| bounds(source, *item)).fold(Bounds::EMPTY, Bounds::union);
        let lattice = self.lattice.within(exact);
        if !lattice.is_finer_than(&self.lattice) {
            return false;
        }
        self.lattice = lattice;
        for item in self.boxes.iter_mut() {
            *item = lattice.snap(item.number(), item.weight(), bounds(source, *item));
        }
        self.around = Snapped::around(self.boxes);
        self.map = Map::over(self.around, self.boxes.len());
        sort(self.boxes, &self.map, bins);
        true
    }

    /// Leaves the items' numbers where they are to stay.
    fn settle(&mut self) {
        let numbers = self.boxes.iter().flat_map(|item| item.numbers());
        self.order.iter_mut().zip(numbers).for_each(|(place, number)| *place = number);
    }
}

/// How many items there are in boxes.
fn items(boxes: &[Snapped]) -> usize {
    boxes.iter().map(|item| item.weight()).sum()
}

/// The bounds of the items in a box.
#[inline(always)]
fn bounds<S: Source>(source: &S, item: Snapped) -> Bounds {
    let (first, number) = (source.bounds(item.number()), item.number());
    if item.weight() == 2 { first.union(source.bounds(number + 1)) } else { first }
}

/// Boxes of those items on a lattice, one or two items each, and what is around all of them.
///
/// Two that follow each other are one box where they fill about the same room, as the halves of a quadrangle do: no good
/// cut would part them, and there is half as much to do.
fn snap<S: Source>(source: &S, lattice: &Lattice, numbers: std::ops::Range<u32>, boxes: &mut Vec<Snapped>) -> Bounds {
    let mut all = Bounds::EMPTY;
    let mut last: Option<(u32, Bounds)> = None;
    for number in numbers {
        let own = source.bounds(number);
        all = all.union(own);
        last = match last {
            Some((before, bounds)) => {
                let both = bounds.union(own);
                if S::PACK >= 4 && both.half_area() <= bounds.half_area() + own.half_area() {
                    boxes.push(lattice.snap(before, 2, both));
                    None
                } else {
                    boxes.push(lattice.snap(before, 1, bounds));
                    Some((number, own))
                }
            }
            None => Some((number, own)),
        };
    }
    if let Some((number, bounds)) = last {
        boxes.push(lattice.snap(number, 1, bounds));
    }
    all
}

/// The tree over all items of a source and what is around them; `order` is left with their numbers in the order of the
/// leaves.
pub(super) fn grow<S: Source>(source: &S, order: &mut [u32]) -> (Grown, Bounds) {
    let count = order.len() as u32;
    if order.len() <= LOCAL {
        let all = (0..count).map(|number| source.bounds(number)).fold(Bounds::EMPTY, Bounds::union);
        let lattice = Lattice::over(all);
        let fill = |boxes: &mut Vec<Snapped>| {
            snap(source, &lattice, 0..count, boxes);
        };
        return (Grown::Local(local(source, lattice, fill, order, 0, 0)), all);
    }
    let hull = source.hull();
    let (mut boxes, all) = snap_all(source, &Lattice::over(hull), count);
    let mut lattice = Lattice::over(hull);
    if Lattice::over(all).is_finer_than(&lattice) {
        lattice = Lattice::over(all);
        (boxes, _) = snap_all(source, &lattice, count);
    }
    let mut spare = Vec::with_capacity(boxes.len());
    prefer_huge_pages(spare.spare_capacity_mut());
    spare.resize(boxes.len(), Snapped::NOTHING);
    let around = Snapped::around(&boxes);
    let map = Map::over(around, boxes.len());
    let mut bins = Box::new(Bins::EMPTY);
    sort(&boxes, &map, &mut bins);
    let set = Set { boxes: &mut boxes, spare: &mut spare, order, first: 0, around, lattice, map, level: 0 };
    (grow_set(source, set, &bins), all)
}

fn snap_all<S: Source>(source: &S, lattice: &Lattice, count: u32) -> (Vec<Snapped>, Bounds) {
    /// Items that one thread snaps at a time; the last one of a run is not put together with the next.
    const RUN: u32 = 1 << 14;
    let runs: Vec<(Vec<Snapped>, Bounds)> = (0..count.div_ceil(RUN))
        .into_par_iter()
        .map(|run| {
            let numbers = run * RUN..((run + 1) * RUN).min(count);
            let mut boxes = Vec::with_capacity(numbers.len());
            let all = snap(source, lattice, numbers, &mut boxes);
            (boxes, all)
        })
        .collect();
    let mut boxes = Vec::with_capacity(runs.iter().map(|(boxes, _)| boxes.len()).sum());
    prefer_huge_pages(boxes.spare_capacity_mut());
    let mut all = Bounds::EMPTY;
    for (run, around) in runs {
        boxes.extend_from_slice(&run);
        all = all.union(around);
    }
    (boxes, all)
}

fn grow_set<S: Source>(source: &S, mut set: Set<'_>, bins: &Bins) -> Grown {
    if set.boxes.len() <= LOCAL {
        let Set { boxes, order, first, around, lattice, level, .. } = set;
        let lattice = lattice.within(lattice.bounds(around));
        let fill = |own: &mut Vec<Snapped>| {
            own.extend(boxes.iter().map(|item| lattice.snap(item.number(), item.weight(), bounds(source, *item))));
        };
        return Grown::Local(local(source, lattice, fill, order, first, level));
    }
    let mut parts = Box::new([Bins::EMPTY; 2]);
    if set.is_coarse() && set.refine(source, &mut parts[0]) {
        return grow_set(source, set, &parts[0]);
    }
    let area = set.area();
    let cut = set.cut::<S>(bins, &mut parts[0]);
    let [left, right] = set.divide(cut, &mut parts);
    let (left, right) = rayon::join(|| grow_set(source, left, &parts[0]), || grow_set(source, right, &parts[1]));
    Grown::Fork { area, children: Box::new([left, right]) }
}

/// The tree over a set that is one thread's own, on a lattice that its boxes lie in, or almost.
fn local<S: Source>(
    source: &S,
    lattice: Lattice,
    fill: impl FnOnce(&mut Vec<Snapped>),
    order: &mut [u32],
    first: usize,
    level: usize,
) -> Local {
    SCRATCH.with_borrow_mut(|scratch| {
        let Scratch { boxes, spare, bins, tree } = scratch;
        boxes.clear();
        fill(boxes);
        if spare.len() < boxes.len() {
            spare.resize(boxes.len(), Snapped::NOTHING);
        }
        if bins.is_empty() {
            // a cut takes a level, and so does a finer lattice, which comes once before a cut at most
            bins.resize(2 * MAX_DEPTH + 2, [Bins::EMPTY; 2]);
        }
        tree.clear();
        let around = Snapped::around(boxes);
        let map = Map::over(around, boxes.len());
        if let Some(([own, _], below)) = bins.split_first_mut() {
            own.fill(boxes, &map);
            let spare = &mut spare[..boxes.len()];
            let set = Set { boxes, spare, order, first, around, lattice, map, level };
            branch(source, set, own, below, tree);
        }
        Local { twigs: tree.twigs.clone(), size: Size::of(&tree.twigs, S::PACK) }
    })
}

/// Adds a set to the tree and gives the number of its node.
fn branch<S: Source>(source: &S, mut set: Set<'_>, bins: &Bins, below: &mut [[Bins; 2]], tree: &mut Tree) -> u32 {
    let (first, count, area) = (set.first, set.order.len(), set.area());
    let packs = count.div_ceil(S::PACK);
    let as_leaf = if packs <= Child::MOST { area * S::cost(packs) } else { f32::INFINITY };
    // a box is a leaf at least; there is a level below for each cut and each finer lattice
    let (true, Some((parts, below))) = (packs > 1 && set.boxes.len() > 1, below.split_first_mut()) else {
        set.settle();
        return tree.leaf(first, count, as_leaf);
    };
    if set.is_coarse() && set.refine(source, &mut parts[0]) {
        return branch(source, set, &parts[0], below, tree);
    }
    let [left, right] = if set.boxes.len() <= FEW && !set.must_be_halved() {
        set.divide_few::<S>()
    } else {
        let cut = set.cut::<S>(bins, &mut parts[0]);
        set.divide(cut, parts)
    };
    let left = branch(source, left, &parts[0], below, tree);
    branch(source, right, &parts[1], below, tree);
    tree.fork(left, first, count, area, as_leaf)
}
