//! Cutting a set in two: its items are moved to the two parts, each part in the order that it had.

use super::bins::{Bins, Cut, Map};
use super::snapped::Snapped;
use rayon::prelude::*;

/// Sets of more items are cut by all threads together.
const TOGETHER: usize = 1 << 16;

/// Moves the items to `to`, those left of the cut first. What comes out is the same for any number of threads.
pub(super) fn part(from: &[Snapped], to: &mut [Snapped], cut: &Cut) {
    let threads = if from.len() > TOGETHER { rayon::current_num_threads() } else { 1 };
    if threads == 1 {
        move_run(from, to, [0, cut.boxes], cut);
        return;
    }
    let runs: Vec<&[Snapped]> = runs(from, threads).collect();
    let lefts: Vec<usize> = runs.par_iter().map(|run| run.iter().filter(|item| !cut.is_right(item)).count()).collect();
    let (mut left, mut right) = to.split_at_mut(cut.boxes);
    let mut jobs = Vec::with_capacity(runs.len());
    for (run, count) in runs.into_iter().zip(lefts) {
        let (own_left, rest_left) = std::mem::take(&mut left).split_at_mut(count);
        let (own_right, rest_right) = std::mem::take(&mut right).split_at_mut(run.len() - count);
        jobs.push((run, own_left, own_right));
        (left, right) = (rest_left, rest_right);
    }
    jobs.into_par_iter().for_each(|(run, left, right)| {
        let (mut left, mut right) = (left.iter_mut(), right.iter_mut());
        for item in run {
            let place = if cut.is_right(item) { right.next() } else { left.next() };
            if let Some(place) = place {
                *place = *item;
            }
        }
    });
}

/// Moves a run of items to places that count from `places`, one for those that go left and one for the others.
fn move_run(from: &[Snapped], to: &mut [Snapped], places: [usize; 2], cut: &Cut) {
    let [mut left, mut right] = places;
    for item in from {
        // without a branch on the side, which nobody can foresee
        let is_right = cut.is_right(item);
        let place = if is_right { right } else { left };
        left += usize::from(!is_right);
        right += usize::from(is_right);
        if let Some(place) = to.get_mut(place) {
            *place = *item;
        }
    }
}

/// Sorts the items of a set into bins, with all threads if they are many.
pub(super) fn sort(items: &[Snapped], map: &Map, bins: &mut Bins) {
    let threads = if items.len() > TOGETHER { rayon::current_num_threads() } else { 1 };
    if threads == 1 {
        bins.fill(items, map);
        return;
    }
    let runs: Vec<&[Snapped]> = runs(items, threads).collect();
    let sorted: Vec<Box<Bins>> = runs
        .into_par_iter()
        .map(|run| {
            let mut bins = Box::new(Bins::EMPTY);
            bins.fill(run, map);
            bins
        })
        .collect();
    *bins = Bins::EMPTY;
    sorted.iter().for_each(|other| bins.merge(other, map));
}

fn runs(items: &[Snapped], threads: usize) -> impl Iterator<Item = &[Snapped]> {
    items.chunks(items.len().div_ceil(4 * threads).max(TOGETHER / 4))
}
