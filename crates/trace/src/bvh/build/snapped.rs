//! Boxes on a coarse lattice: sixteen bytes hold one together with its number, and one instruction takes the least of
//! eight coordinates.
//!
//! They only decide where sets are cut. The boxes of nodes are made from the items themselves, so what the lattice
//! rounds away costs a little quality where a set is only some hundred steps long, and never a hit; before that the set
//! is put on a finer lattice.

use crate::bvh::Bounds;
use glam::DVec3;

/// The last place of a lattice, from 0.
const LAST: i16 = i16::MAX;

/// The place of a box in a lattice: its least corner, and how far its greatest one is from the lattice's end, by axis; so
/// the union of two is the least of each lane. Lanes 3 and 7 hold the item's number, or nothing of use.
///
/// A box of two items, of that number and of the next one, has the last bit of the number's 32 set.
#[repr(C, align(16))]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Snapped([i16; 8]);

impl Snapped {
    /// The box around nothing.
    pub(super) const NOTHING: Snapped = Snapped([LAST; 8]);
    const TWO: u32 = 1 << 31;

    /// The number of the item, or of the first one of two.
    pub(super) fn number(self) -> u32 {
        (u32::from(self.0[3] as u16) | u32::from(self.0[7] as u16) << 16) & !Snapped::TWO
    }

    /// How many items it is: one or two.
    #[inline(always)]
    pub(super) fn weight(self) -> usize {
        1 + usize::from(self.0[7] < 0)
    }

    /// The numbers of the items.
    pub(super) fn numbers(self) -> impl Iterator<Item = u32> {
        self.number()..self.number() + self.weight() as u32
    }

    /// The box around both, without a number.
    #[inline(always)]
    pub(super) fn union(self, other: Snapped) -> Snapped {
        let mut least = self.0;
        for (own, other) in least.iter_mut().zip(other.0) {
            *own = if other < *own { other } else { *own };
        }
        Snapped(least)
    }

    /// The box around all.
    pub(super) fn around(items: &[Snapped]) -> Snapped {
        items.iter().fold(Snapped::NOTHING, |all, item| all.union(*item))
    }

    /// Its least place along an axis.
    pub(super) fn low(&self, axis: usize) -> u16 {
        self.0[axis & 3] as u16
    }

    /// The sum of its least and greatest place, along an axis.
    #[inline(always)]
    pub(super) fn center(&self, axis: usize) -> u16 {
        (self.0[axis & 3] as u16).wrapping_add((LAST ^ self.0[(axis & 3) + 4]) as u16)
    }

    /// The sums of its least and greatest places, sixteen bits each from the lowest ones on. What is above the three of
    /// them is of no use.
    #[inline(always)]
    pub(super) fn centers(self) -> u64 {
        let [low, rest] = self.words();
        // no sum is greater than twice the last place, so none reaches into the next one
        low.wrapping_add(rest ^ WORD_OF_LAST)
    }

    /// How many steps it is long, along an axis.
    #[inline(always)]
    pub(super) fn size(&self, axis: usize) -> u32 {
        // an empty one has no size
        (i32::from(LAST) - i32::from(self.0[axis]) - i32::from(self.0[axis + 4])).max(0) as u32
    }

    /// The longest axis.
    pub(super) fn longest(&self) -> usize {
        (1..3).fold(0, |longest, axis| if self.size(axis) > self.size(longest) { axis } else { longest })
    }

    /// The shortest axis.
    pub(super) fn shortest(&self) -> usize {
        (1..3).fold(0, |shortest, axis| if self.size(axis) < self.size(shortest) { axis } else { shortest })
    }

    /// Half of its surface, and a little for its edges: so boxes without surface are told apart as well. That of the box
    /// around nothing is some number.
    #[inline(always)]
    pub(super) fn half_area(self) -> u64 {
        let [low, high] = self.words();
        // a place and the distance to the end are no more than the last place together, so nothing is borrowed
        let sizes = WORD_OF_LAST.wrapping_sub(low & SUMS).wrapping_sub(high & SUMS);
        let [x, y, z] = [sizes & 0xffff, sizes >> 16 & 0xffff, sizes >> 32 & 0xffff];
        x * (y + z) + y * z + x + y + z
    }

    /// Lanes 0 to 3 and lanes 4 to 7, the first one lowest.
    #[inline(always)]
    fn words(self) -> [u64; 2] {
        let words: [u64; 2] = bytemuck::cast(self.0.map(i16::to_le));
        words.map(u64::from_le)
    }
}

/// The last place in the three lanes of a word.
const WORD_OF_LAST: u64 = 0x0000_7fff_7fff_7fff;
/// The bits of those lanes.
const SUMS: u64 = 0x0000_ffff_ffff_ffff;

/// Where a lattice lies in the space of the items. It has the same step along each axis, and as many places as a
/// [`Snapped`] can tell apart along the longest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lattice {
    origin: DVec3,
    /// Steps in a unit of length; 0 where all places are one.
    steps: f64,
    /// The area of a square of one step, against that of the first lattice.
    pub(super) unit: f32,
}

impl Lattice {
    /// The lattice over a box.
    pub(super) fn over(bounds: Bounds) -> Lattice {
        let size = (bounds.high - bounds.low).max_element();
        // of points all on one place nothing can be told apart, whatever the step
        let steps = if size > 0.0 { f64::from(LAST) / size } else { 0.0 };
        Lattice { origin: bounds.low, steps: if steps.is_finite() { steps } else { 0.0 }, unit: 1.0 }
    }

    /// The lattice over a box within this one.
    pub(super) fn within(&self, bounds: Bounds) -> Lattice {
        let lattice = Lattice::over(bounds);
        let step = if lattice.steps > 0.0 { self.steps / lattice.steps } else { 0.0 };
        Lattice { unit: self.unit * (step * step) as f32, ..lattice }
    }

    /// The item of that number with those bounds, or two items if `weight` is 2. The bounds lie within the lattice.
    #[inline(always)]
    pub(super) fn snap(&self, number: u32, weight: usize, bounds: Bounds) -> Snapped {
        // the sum with this leaves the nearest integer in the low bits of the number
        const ROUND: f64 = 1.5 * (1_u64 << 52) as f64;
        let low = (bounds.low - self.origin) * self.steps + ROUND;
        let high = (bounds.high - self.origin) * self.steps + ROUND;
        let lane = |x: f64| x.to_bits() as i16;
        let [a, b, c] = [lane(low.x), lane(low.y), lane(low.z)];
        let [d, e, f] = [high.x, high.y, high.z].map(|x| LAST.wrapping_sub(lane(x)));
        let number = number | if weight == 2 { Snapped::TWO } else { 0 };
        let (g, h) = (number as i16, (number >> 16) as i16);
        let size = |low: i16, high: i16| LAST.wrapping_sub(low).wrapping_sub(high);
        if a | b | c | d | e | f | size(a, d) | size(b, e) | size(c, f) < 0 {
            // no box of the lattice, or not of numbers: wherever it is put, no ray can meet it
            return Snapped([0, 0, 0, g, LAST, LAST, LAST, h]);
        }
        Snapped([a, b, c, g, d, e, f, h])
    }

    /// The bounds of a box in the lattice, to within a step.
    pub(super) fn bounds(&self, snapped: Snapped) -> Bounds {
        let step = if self.steps > 0.0 { self.steps.recip() } else { 0.0 };
        let point = |place: &dyn Fn(usize) -> i16| {
            DVec3::from([0, 1, 2].map(|axis| f64::from(place(axis)))) * step + self.origin
        };
        let (low, high) = (point(&|axis| snapped.0[axis]), point(&|axis| LAST - snapped.0[axis + 4]));
        Bounds { low: low - step, high: high + step }
    }

    /// Whether it has a much smaller step than another.
    pub(super) fn is_finer_than(&self, other: &Lattice) -> bool {
        self.steps > 2.0 * other.steps
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_stand_at_the_nearest_steps() {
        let around = Bounds { low: DVec3::splat(-1.0), high: DVec3::new(1.0, 0.0, -1.0) };
        let lattice = Lattice::over(around);
        let whole = lattice.snap(0x1234_fedc, 1, around);
        assert_eq!((whole.number(), whole.weight()), (0x1234_fedc, 1));
        assert_eq!([0, 1, 2].map(|axis| whole.size(axis)), [32767, 16384, 0]);
        assert_eq!(whole.longest(), 0);
        assert_eq!(whole.half_area(), 32767 * 16384 + 32767 + 16384);
        let left = lattice.snap(7, 2, Bounds { low: around.low, high: DVec3::new(-0.5, -1.0, -1.0) });
        assert_eq!(left.numbers().collect::<Vec<_>>(), [7, 8]);
        assert_eq!([0, 1, 2].map(|axis| left.size(axis)), [8192, 0, 0]);
        assert_eq!([0, 1, 2].map(|axis| left.center(axis)), [8192, 0, 0]);
        let union = left.union(lattice.snap(8, 1, Bounds { low: DVec3::NEG_Y, high: DVec3::NEG_Y }));
        assert_eq!([0, 1, 2].map(|axis| union.size(axis)), [16384, 0, 16384]);
        let centers = [0, 1, 2].map(|axis| (union.centers() >> (16 * axis)) as u16);
        assert_eq!(centers, [0, 1, 2].map(|axis| union.center(axis)));
        let bounds = lattice.bounds(whole);
        assert!((bounds.low - around.low).abs().max_element() < 1e-3 && bounds.low.cmple(around.low).all());
        assert!((bounds.high - around.high).abs().max_element() < 1e-3 && bounds.high.cmpge(around.high).all());
    }

    #[test]
    fn nothing_has_no_size() {
        assert_eq!([0, 1, 2].map(|axis| Snapped::NOTHING.size(axis)), [0; 3]);
        let point = Bounds { low: DVec3::ONE, high: DVec3::ONE };
        let lattice = Lattice::over(point);
        assert_eq!(lattice.snap(1, 1, point).half_area(), 0);
        assert_eq!(Snapped::NOTHING.union(lattice.snap(1, 1, point)).size(0), 0);
    }

    #[test]
    fn what_is_no_box_stands_somewhere() {
        let lattice = Lattice::over(Bounds { low: DVec3::ZERO, high: DVec3::ONE });
        for (low, high) in [
            (DVec3::ONE, DVec3::ZERO),
            (DVec3::NAN, DVec3::ONE),
            (DVec3::NEG_INFINITY, DVec3::INFINITY),
            (DVec3::splat(-1e300), DVec3::splat(1e300)),
        ] {
            let snapped = lattice.snap(9, 1, Bounds { low, high });
            assert_eq!(snapped.number(), 9);
            for axis in 0..3 {
                let (low, high) = (u32::from(snapped.low(axis)), u32::from(snapped.center(axis)));
                assert_eq!(low + snapped.size(axis) + low, high, "a box of the lattice");
            }
        }
    }
}
