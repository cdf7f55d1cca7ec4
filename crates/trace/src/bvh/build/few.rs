//! The last cuts: of a few boxes all cuts along the two longer axes are tried.

use super::Source;
use super::snapped::Snapped;

/// The greatest set that is cut here.
pub(super) const FEW: usize = 8;

/// Sorts two to [`FEW`] boxes so that both parts have the least sum of area times packs. Gives the number of boxes in the
/// first part and what is around both.
pub(super) fn cut_few<S: Source>(boxes: &mut [Snapped]) -> (usize, [Snapped; 2]) {
    // for each number the loops are laid out flat
    match boxes.len() {
        2 => cut_exactly::<S, 2>(boxes),
        3 => cut_exactly::<S, 3>(boxes),
        4 => cut_exactly::<S, 4>(boxes),
        5 => cut_exactly::<S, 5>(boxes),
        6 => cut_exactly::<S, 6>(boxes),
        7 => cut_exactly::<S, 7>(boxes),
        _ => cut_exactly::<S, FEW>(boxes),
    }
}

fn cut_exactly<S: Source, const N: usize>(boxes: &mut [Snapped]) -> (usize, [Snapped; 2]) {
    let Some(boxes) = boxes.first_chunk_mut::<N>() else {
        return (1, [Snapped::NOTHING; 2]);
    };
    let packs = |items: usize| items.div_ceil(S::PACK) as u64;
    let all: usize = boxes.iter().map(|item| item.weight()).sum();
    let mut best = (u64::MAX, 1, [Snapped::NOTHING; 2], [0; N]);
    // along the shortest one there is hardly anything to gain
    let shortest = Snapped::around(boxes).shortest();
    for axis in (0..3).filter(|axis| *axis != shortest) {
        let order = order(boxes, axis);
        // the cost of what is to the right of each cut
        let mut rights = [Snapped::NOTHING; N];
        let mut around = Snapped::NOTHING;
        for cut in (1..N).rev() {
            around = around.union(boxes[order[cut]]);
            rights[cut] = around;
        }
        let (mut left, mut items) = (Snapped::NOTHING, 0);
        for cut in 1..N {
            let item = boxes[order[cut - 1]];
            left = left.union(item);
            items += item.weight();
            let cost = left.half_area() * packs(items) + rights[cut].half_area() * packs(all - items);
            if cost < best.0 {
                best = (cost, cut, [left, rights[cut]], order);
            }
        }
    }
    let before = *boxes;
    for (place, from) in boxes.iter_mut().zip(best.3) {
        *place = before[from];
    }
    (best.1, best.2)
}

/// The places of the boxes in the order of their middles along an axis; equal ones keep their order.
fn order<const N: usize>(boxes: &[Snapped; N], axis: usize) -> [usize; N] {
    let mut ranks = [0; N];
    for place in 1..N {
        for before in 0..place {
            let is_after = usize::from(boxes[place].center(axis) >= boxes[before].center(axis));
            ranks[place] += is_after;
            ranks[before] += 1 - is_after;
        }
    }
    let mut order = [0; N];
    for (place, rank) in ranks.into_iter().enumerate() {
        order[if rank < N { rank } else { 0 }] = place;
    }
    order
}

#[cfg(test)]
mod tests {
    use super::super::snapped::Lattice;
    use super::*;
    use crate::bvh::{Bounds, Triangles};
    use glam::DVec3;
    use proptest::prelude::*;

    fn cost(parts: [&[Snapped]; 2]) -> u64 {
        let items = |part: &[Snapped]| part.iter().map(|item| item.weight()).sum::<usize>();
        parts.iter().map(|part| Snapped::around(part).half_area() * items(part).div_ceil(4) as u64).sum()
    }

    proptest! {
        #[test]
        fn no_cut_along_the_longer_axes_is_better(
            boxes in prop::collection::vec(([0.0..9.0, 0.0..9.0, 0.0..9.0], 0.0..1.0, 1..=2_usize), 2..=8),
        ) {
            let lattice = Lattice::over(Bounds { low: DVec3::ZERO, high: DVec3::splat(10.0) });
            let boxes = (0..).zip(boxes).map(|(number, (low, size, weight))| {
                lattice.snap(2 * number, weight, Bounds { low: low.into(), high: DVec3::from(low) + size })
            });
            let set: Vec<Snapped> = boxes.collect();
            let mut found = set.clone();
            let (cut, around) = cut_few::<Triangles<'_>>(&mut found);
            let (left, right) = found.split_at(cut);
            for (part, around) in [left, right].into_iter().zip(around) {
                prop_assert_eq!([0, 1, 2].map(|axis| Snapped::around(part).size(axis)), [0, 1, 2].map(|axis| around.size(axis)));
            }
            let mut numbers: Vec<u32> = found.iter().map(|item| item.number()).collect();
            numbers.sort_unstable();
            prop_assert_eq!(numbers, (0..set.len() as u32).map(|number| 2 * number).collect::<Vec<_>>());
            let shortest = Snapped::around(&set).shortest();
            for axis in (0..3).filter(|axis| *axis != shortest) {
                let mut sorted = set.clone();
                sorted.sort_by_key(|item| item.center(axis));
                for cut in 1..set.len() {
                    prop_assert!(cost([left, right]) <= cost([&sorted[..cut], &sorted[cut..]]));
                }
            }
        }
    }
}
