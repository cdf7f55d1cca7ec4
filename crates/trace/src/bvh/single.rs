//! Rays that go each its own way through a hierarchy, against eight boxes at a time.
//!
//! The rays of some packets take turns: each goes one step, and then the next one has its turn. What a ray visits next is
//! on its way from memory meanwhile, and the processor overlaps the steps of rays that know nothing of each other; one
//! ray alone would mostly wait. Nodes and leaves have rounds of their own, and a step at a node has no branch that could
//! be guessed wrongly: the children that are met are sorted by a network and all put on the stack.
//!
//! The bounds of errors are those of `beam`: what is conservative for a packet is so for each of its rays.

use super::beam::{LONGER, OPEN, Shadow};
use super::{Bvh, Child, Entry, Node, WIDTH};
use crate::engine::lanes::{Lanes, Mask, Single};
use std::cell::Cell;

/// How many rays take turns at most.
const TURNS: usize = 32;

/// Rays as boxes see them, by axis, then by number: what the coordinate of a plane is multiplied with, and what is then
/// taken away, of the plane where the ray enters and of that where it leaves.
pub(crate) struct Scattered {
    inverse: [[f32; TURNS]; 3],
    enter: [[f32; TURNS]; 3],
    leave: [[f32; TURNS]; 3],
    /// The rays that go down along each axis.
    down: [u32; 3],
    /// The rays that there are.
    mask: u32,
    packets: usize,
}

/// Is shown the leaves that rays reach. A ray has the number of its packet times eight plus its lane.
pub(crate) trait Follow {
    /// How far a ray looks at first.
    fn limit(&self, ray: usize) -> f32;

    /// A leaf that a ray reaches before `limit`; gives how far that still looks.
    fn leaf(&mut self, ray: usize, first: u32, count: u32, limit: f32) -> f32;

    /// A leaf that will be shown soon.
    fn soon(&self, first: u32);
}

impl Scattered {
    /// How many packets there is place for.
    pub(crate) const PACKETS: usize = TURNS / 8;

    /// No rays.
    #[inline(always)]
    pub(crate) fn new() -> Scattered {
        let none = [[0.0; TURNS]; 3];
        Scattered { inverse: none, enter: none, leave: none, down: [0; 3], mask: 0, packets: 0 }
    }

    /// Adds the rays of a packet, if there is place.
    #[inline(always)]
    pub(crate) fn push<L: Lanes>(&mut self, rays: &Shadow<L>) {
        let first = 8 * self.packets;
        if self.packets == Scattered::PACKETS {
            return;
        }
        self.packets += 1;
        let mut there = rays.mask;
        for axis in 0..3 {
            // what is not a number would meet every box
            there &= rays.above[axis].abs().ge(L::Single::splat(0.0)).bits();
            let down = rays.inverse[axis].lt(L::Single::splat(0.0));
            let (above, below) = (rays.above[axis], rays.below[axis]);
            put(&mut self.inverse[axis], first, rays.inverse[axis].store());
            put(&mut self.enter[axis], first, L::Single::select(down, below, above).store());
            put(&mut self.leave[axis], first, L::Single::select(down, above, below).store());
            self.down[axis] |= u32::from(down.bits()) << first;
        }
        self.mask |= u32::from(there) << first;
    }

    /// Where a ray enters the boxes of a node's children; -1 for those that it does not meet before `limit`.
    #[inline(always)]
    fn meet<L: Lanes>(&self, ray: usize, node: &Node, limit: f32) -> [f32; WIDTH] {
        let (mut near, mut far) = (L::Single::splat(0.0), L::Single::splat(limit));
        for axis in 0..3 {
            let (low, high) = (&node.low[axis], &node.high[axis]);
            let down = self.down[axis] >> ray & 1 == 1;
            let (first, second) = if down { (high, low) } else { (low, high) };
            let inverse = L::Single::splat(self.inverse[axis][ray]);
            let enter = L::Single::load(first).mul_sub(inverse, L::Single::splat(self.enter[axis][ray]));
            let leave = L::Single::load(second).mul_sub(inverse, L::Single::splat(self.leave[axis][ray]));
            // what is not a number says nothing
            near = enter.max(near);
            far = leave.min(far);
        }
        let met = near.le(far * L::Single::splat(LONGER));
        L::Single::select(met, near, L::Single::splat(-1.0)).store()
    }
}

/// The children that wait, nearer ones above farther ones of the same node, and where the ray enters their boxes.
struct Waiting {
    near: [f32; OPEN + WIDTH],
    child: [u32; OPEN + WIDTH],
}

/// Place for what waits for each ray.
struct Stacks([Waiting; TURNS]);

thread_local! {
    /// Clearing it for every packet would take longer than what is done with it.
    static STACKS: Cell<Option<Box<Stacks>>> = const { Cell::new(None) };
}

impl Stacks {
    /// Those of this thread, or new ones.
    #[inline(never)]
    fn take() -> Box<Stacks> {
        const NONE: Waiting = Waiting { near: [0.0; OPEN + WIDTH], child: [0; OPEN + WIDTH] };
        STACKS.take().unwrap_or_else(|| Box::new(Stacks([NONE; TURNS])))
    }

    #[inline(never)]
    fn put_back(self: Box<Stacks>) {
        STACKS.set(Some(self));
    }
}

/// Lies below all that waits.
const NOTHING_MORE: u32 = u32::MAX;

impl Waiting {
    /// Puts what is beyond the limit away; gives how many are left.
    #[inline(always)]
    fn shorten(&mut self, count: usize, limit: f32) -> usize {
        let mut kept = 1;
        for place in 1..count.min(OPEN) {
            (self.near[kept], self.child[kept]) = (self.near[place], self.child[place]);
            kept += usize::from(self.near[place] <= limit * LONGER);
        }
        kept
    }
}

/// The rays of which the next step is at a node, or of which it is at a leaf.
struct Round {
    rays: [u8; TURNS],
    count: usize,
}

impl Round {
    const NONE: Round = Round { rays: [0; TURNS], count: 0 };

    /// Adds a ray if it belongs here.
    #[inline(always)]
    fn add(&mut self, ray: usize, belongs: bool) {
        self.rays[self.count % TURNS] = ray as u8;
        self.count += usize::from(belongs);
    }
}

impl Bvh {
    /// Shows every leaf that each ray reaches before its limit, nearer boxes first.
    #[inline(always)]
    pub(crate) fn follow<L: Lanes>(&self, rays: &Scattered, visitor: &mut impl Follow) {
        let nodes = self.nodes();
        if nodes.is_empty() {
            return;
        }
        let mut stacks = Stacks::take();
        let Stacks(waiting) = &mut *stacks;
        let (mut limits, mut next, mut counts) = ([0.0; TURNS], [0; TURNS], [1; TURNS]);
        let mut nears = [[0.0; WIDTH]; TURNS];
        let (mut inner, mut leaves) = (Round::NONE, Round::NONE);
        let mut left = rays.mask;
        while left != 0 {
            let ray = left.trailing_zeros() as usize;
            left &= left - 1;
            limits[ray] = visitor.limit(ray);
            waiting[ray].child[0] = NOTHING_MORE;
            inner.add(ray, true);
        }
        while inner.count + leaves.count > 0 {
            let (now, soon) = (inner, leaves);
            (inner, leaves) = (Round::NONE, Round::NONE);
            // in two steps, each short enough for the processor to look far ahead
            for (&ray, near) in now.rays[..now.count].iter().zip(&mut nears) {
                let ray = usize::from(ray) % TURNS;
                *near = rays.meet::<L>(ray, &nodes[next[ray] as usize], limits[ray]);
            }
            for (&ray, near) in now.rays[..now.count].iter().zip(&nears) {
                let ray = usize::from(ray) % TURNS;
                let near = L::Single::load(near);
                let met = near.ge(L::Single::splat(0.0)).bits();
                let (near, child) = L::greatest_first(near, bytemuck::cast_ref(&nodes[next[ray] as usize].children));
                let count = counts[ray];
                // a level leaves at most seven open children behind
                put(&mut waiting[ray].near, count, near);
                put(&mut waiting[ray].child, count, child);
                counts[ray] = count + met.count_ones() as usize - 1;
                next[ray] = waiting[ray].child[counts[ray]];
                step::<L>(ray, nodes, next[ray], (&mut inner, &mut leaves));
            }
            for &ray in &soon.rays[..soon.count] {
                visitor.soon(next[usize::from(ray) % TURNS] & Child::FIRST);
            }
            for &ray in &soon.rays[..soon.count] {
                let ray = usize::from(ray) % TURNS;
                if let Entry::Leaf { first, count } = Child::of_bits(next[ray]).entry() {
                    let limit = visitor.leaf(ray, first, count, limits[ray]);
                    if limit < limits[ray] {
                        limits[ray] = limit;
                        counts[ray] = waiting[ray].shorten(counts[ray], limit);
                    }
                }
                counts[ray] -= 1;
                next[ray] = waiting[ray].child[counts[ray]];
                step::<L>(ray, nodes, next[ray], (&mut inner, &mut leaves));
            }
        }
        stacks.put_back();
    }
}

/// Eight at once, to a place that is there.
#[inline(always)]
fn put<T, const N: usize>(list: &mut [T; N], first: usize, eight: [T; WIDTH]) {
    if let Some(place) = list.get_mut(first..).and_then(|rest| rest.first_chunk_mut()) {
        *place = eight;
    }
}

/// Adds a ray to the round that it belongs to by what it visits next, and has that fetched.
#[inline(always)]
fn step<L: Lanes>(ray: usize, nodes: &[Node], child: u32, (inner, leaves): (&mut Round, &mut Round)) {
    let is_leaf = Child::of_bits(child).is_leaf();
    leaves.add(ray, is_leaf && child != NOTHING_MORE);
    inner.add(ray, !is_leaf);
    // for a leaf the root, which is there
    if let Some(node) = nodes.get(if is_leaf { 0 } else { child as usize }) {
        L::prefetch(node);
    }
}
