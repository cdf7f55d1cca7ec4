//! The binned surface-area heuristic (Wald 2007): items fall into a few bins along each axis by their middles, and a set
//! is cut between two bins.

use super::Source;
use super::snapped::Snapped;

/// The greatest number of bins along an axis, a power of 2.
const BINS: usize = 32;

/// Bins along the three axes; or three times along one, so that items that follow each other need not wait for each
/// other.
#[derive(Clone)]
pub(super) struct Bins([[Bin; BINS]; 3]);

#[repr(C)]
#[derive(Clone, Copy)]
struct Bin {
    around: Snapped,
    /// How many boxes there are in the lower half, how many items in the upper one.
    counts: u64,
}

impl Bin {
    const EMPTY: Bin = Bin { around: Snapped::NOTHING, counts: 0 };

    #[inline(always)]
    fn add(&mut self, item: Snapped) {
        self.around = self.around.union(item);
        self.counts += (item.weight() as u64) << 32 | 1;
    }

    #[inline(always)]
    fn merge(&mut self, other: &Bin) {
        self.around = self.around.union(other.around);
        self.counts += other.counts;
    }

    fn boxes(&self) -> usize {
        self.counts as u32 as usize
    }

    fn items(&self) -> usize {
        (self.counts >> 32) as usize
    }

    /// Area times packs.
    #[inline(always)]
    fn cost<S: Source>(&self) -> u64 {
        self.around.half_area() * self.items().div_ceil(S::PACK) as u64
    }
}

/// How the middles of the boxes in a set are sorted into bins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Map {
    /// The least sum of places, by axis.
    base: [u16; 3],
    /// Bins in 2¹⁶ steps of the sum.
    scale: [u16; 3],
    /// How many bins there are along each axis.
    bins: usize,
    /// The only axis that is looked at, if it is one.
    only: Option<usize>,
}

impl Map {
    /// Of greater sets only the longest axis is looked at: it is the best one nearly always, and that is much cheaper.
    const LARGE: usize = 1 << 14;

    /// The map for that many boxes within a box.
    pub(super) fn over(around: Snapped, boxes: usize) -> Map {
        let only = (boxes > Map::LARGE).then(|| around.longest());
        Map::between(boxes, only, |axis| (2 * around.low(axis), 2 * around.size(axis)))
    }

    /// The map over the middles themselves, for sets whose boxes reach far beyond those.
    pub(super) fn over_centers(items: &[Snapped]) -> Map {
        Map::between(items.len(), None, |axis| {
            let centers = || items.iter().map(|item| item.center(axis));
            let (least, most) = (centers().min().unwrap_or(0), centers().max().unwrap_or(0));
            (least, u32::from(most - least))
        })
    }

    fn between(boxes: usize, only: Option<usize>, range: impl Fn(usize) -> (u16, u32)) -> Map {
        // more bins than this are not worth their time
        let bins = match boxes {
            0..=32 => 6,
            _ if only.is_none() => 16,
            _ => BINS,
        };
        let mut map = Map { base: [0; 3], scale: [0; 3], bins, only };
        for axis in 0..3 {
            let (base, size) = range(axis);
            map.base[axis] = base;
            map.scale[axis] = (((bins as u32) << 16) / (size + 1)).min(u32::from(u16::MAX)) as u16;
        }
        map
    }

    /// The bin of a sum of places, from the least one on.
    #[inline(always)]
    fn place(&self, above: u64, axis: usize) -> usize {
        ((u32::from(above as u16) * u32::from(self.scale[axis])) >> 16) as usize & (BINS - 1)
    }

    /// The least sum of places that falls into that bin or a later one.
    fn threshold(&self, axis: usize, bin: usize) -> u32 {
        u32::from(self.base[axis]) + ((bin as u32) << 16).div_ceil(u32::from(self.scale[axis]).max(1))
    }

    fn axes(&self) -> impl Iterator<Item = usize> {
        self.only.map_or(0..3, |axis| axis..axis + 1)
    }
}

/// Where a set is cut in two, and what its parts are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    pub(super) axis: usize,
    /// Boxes with a lesser sum of places go left.
    pub(super) threshold: u32,
    /// How many boxes go left.
    pub(super) boxes: usize,
    /// How many items those are.
    pub(super) items: usize,
    /// The boxes around both parts.
    pub(super) around: [Snapped; 2],
}

impl Cut {
    /// Whether a box goes to the right part.
    #[inline(always)]
    pub(super) fn is_right(&self, item: &Snapped) -> bool {
        u32::from(item.center(self.axis)) >= self.threshold
    }
}

impl Bins {
    pub(super) const EMPTY: Bins = Bins([[Bin::EMPTY; BINS]; 3]);

    /// Sorts boxes into bins that may hold anything before.
    pub(super) fn fill(&mut self, items: &[Snapped], map: &Map) {
        let map = *map;
        let [x, y, z] = &mut self.0;
        for bins in [&mut *x, &mut *y, &mut *z] {
            bins[..map.bins].fill(Bin::EMPTY);
        }
        if let Some(axis) = map.only {
            let base = u64::from(map.base[axis]);
            let place = |item: &Snapped| map.place(u64::from(item.center(axis)).wrapping_sub(base), axis);
            let mut threes = items.chunks_exact(3);
            for three in &mut threes {
                x[place(&three[0])].add(three[0]);
                y[place(&three[1])].add(three[1]);
                z[place(&three[2])].add(three[2]);
            }
            threes.remainder().iter().for_each(|item| x[place(item)].add(*item));
            for (x, (y, z)) in x.iter_mut().zip(y.iter().zip(z.iter())).take(map.bins) {
                x.merge(y);
                x.merge(z);
            }
            if axis > 0 {
                self.0[axis] = self.0[0];
            }
            return;
        }
        let base = map.base.iter().rev().fold(0, |all, base| all << 16 | u64::from(*base));
        for item in items {
            // no sum is below its base, so nothing is borrowed from the next one
            let above = item.centers().wrapping_sub(base);
            x[map.place(above, 0)].add(*item);
            y[map.place(above >> 16, 1)].add(*item);
            z[map.place(above >> 32, 2)].add(*item);
        }
    }

    /// Adds what is in other bins of the same map.
    pub(super) fn merge(&mut self, other: &Bins, map: &Map) {
        for axis in map.axes() {
            self.0[axis].iter_mut().zip(&other.0[axis]).take(map.bins).for_each(|(own, other)| own.merge(other));
        }
    }

    /// The cut that makes the sum of area times packs least; `None` if all boxes are in one bin of each axis.
    pub(super) fn best<S: Source>(&self, map: &Map, boxes: usize) -> Option<Cut> {
        let mut best: Option<(u64, usize, usize)> = None;
        for axis in map.axes() {
            let bins = &self.0[axis][..map.bins];
            // the cost of everything to the right of each cut
            let mut right = [0; BINS];
            let mut part = Bin::EMPTY;
            for cut in (1..bins.len()).rev() {
                part.merge(&bins[cut]);
                right[cut] = part.cost::<S>();
            }
            let mut part = Bin::EMPTY;
            for cut in 1..bins.len() {
                part.merge(&bins[cut - 1]);
                let cost = part.cost::<S>() + right[cut];
                let are_two = part.boxes() > 0 && part.boxes() < boxes;
                if are_two && best.is_none_or(|(least, _, _)| cost < least) {
                    best = Some((cost, axis, cut));
                }
            }
        }
        best.map(|(_, axis, bin)| {
            let (left, right) = self.0[axis][..map.bins].split_at(bin);
            let [left, right] = [left, right].map(|bins| {
                let mut part = Bin::EMPTY;
                bins.iter().for_each(|bin| part.merge(bin));
                part
            });
            Cut {
                axis,
                threshold: map.threshold(axis, bin),
                boxes: left.boxes(),
                items: left.items(),
                around: [left.around, right.around],
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::part::part;
    use super::super::snapped::Lattice;
    use super::*;
    use crate::bvh::{Bounds, Triangles};
    use glam::DVec3;
    use proptest::prelude::*;

    fn snapped(boxes: Vec<([f64; 3], f64, usize)>) -> Vec<Snapped> {
        let lattice = Lattice::over(Bounds { low: DVec3::ZERO, high: DVec3::splat(10.0) });
        let boxes = (0..).zip(boxes).map(|(number, (low, size, weight))| {
            let bounds = Bounds { low: low.into(), high: DVec3::from(low) + DVec3::new(size, 0.1 * size, 0.0) };
            lattice.snap(2 * number, weight, bounds)
        });
        boxes.collect()
    }

    fn items(boxes: &[Snapped]) -> usize {
        boxes.iter().map(|item| item.weight()).sum()
    }

    fn cost(boxes: &[Snapped]) -> u64 {
        Snapped::around(boxes).half_area() * items(boxes).div_ceil(4) as u64
    }

    proptest! {
        /// The parts are what the cut says, each in the old order, and no cut between bins is better.
        #[test]
        fn a_cut_is_the_best_one_between_bins(
            boxes in prop::collection::vec(([0.0..9.0, 0.0..9.0, 0.0..0.5], 0.0..1.0, 1..=2_usize), 2..700),
        ) {
            let boxes = snapped(boxes);
            let map = Map::over(Snapped::around(&boxes), boxes.len());
            let mut bins = Bins::EMPTY;
            bins.fill(&boxes, &map);
            let Some(cut) = bins.best::<Triangles<'_>>(&map, boxes.len()) else {
                let places = boxes.iter().map(|item| item.center(0).abs_diff(boxes[0].center(0)));
                prop_assert!(places.max().unwrap_or(0) < 40_000, "they are far apart");
                return Ok(());
            };
            let mut parted = vec![Snapped::NOTHING; boxes.len()];
            part(&boxes, &mut parted, &cut);
            let (left, right) = parted.split_at(cut.boxes);
            let expected: (Vec<Snapped>, Vec<Snapped>) = boxes.iter().partition(|item| !cut.is_right(item));
            prop_assert_eq!((left, right), (&expected.0[..], &expected.1[..]));
            prop_assert_eq!(items(left), cut.items);
            for (part, around) in [left, right].into_iter().zip(cut.around) {
                let exact = Snapped::around(part);
                prop_assert_eq!([0, 1, 2].map(|axis| exact.size(axis)), [0, 1, 2].map(|axis| around.size(axis)));
            }
            for axis in 0..3 {
                for bin in 1..map.bins {
                    let other = Cut { axis, threshold: map.threshold(axis, bin), ..cut };
                    let (left, right): (Vec<Snapped>, Vec<Snapped>) = boxes.iter().partition(|item| !other.is_right(item));
                    if !left.is_empty() && !right.is_empty() {
                        prop_assert!(cost(&expected.0) + cost(&expected.1) <= cost(&left) + cost(&right));
                    }
                }
            }
        }
    }

    /// Of boxes that all reach from end to end, the middles still tell them apart; of equal ones nothing does.
    #[test]
    fn middles_tell_apart_what_boxes_do_not() {
        let boxes = snapped((0..20).map(|n| ([f64::from(n) * 1e-3, 0.0, 0.0], 9.0, 1)).collect());
        let map = Map::over(Snapped::around(&boxes), boxes.len());
        let mut bins = Bins::EMPTY;
        bins.fill(&boxes, &map);
        assert!(bins.best::<Triangles<'_>>(&map, boxes.len()).is_none());
        let map = Map::over_centers(&boxes);
        bins.fill(&boxes, &map);
        assert!(bins.best::<Triangles<'_>>(&map, boxes.len()).is_some());
        let equal = vec![boxes[0]; 20];
        let map = Map::over_centers(&equal);
        bins.fill(&equal, &map);
        assert!(bins.best::<Triangles<'_>>(&map, equal.len()).is_none());
    }
}
