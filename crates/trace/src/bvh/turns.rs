//! Packets of rays from points of their own through a hierarchy, each by itself: its rays go together as long as they meet
//! the same boxes.
//!
//! The packets take turns: each goes one step, and then the next one has its turn. What a packet visits next is on its
//! way from memory meanwhile, and the processor overlaps the steps of packets that know nothing of each other.
//!
//! At a node the boxes of the eight children are tried with one ray of the packet after the other, and each child waits
//! with the rays that meet it. Rays that are reflected by neighbouring pixels share most of their ways, and even scattered
//! ones the upper half; what it costs to sort the children, and to come and go, they share too. A step has no branch that
//! could be guessed wrongly: the children that are met are sorted by a network and all put on the stack.
//!
//! The bounds of errors are those of `shadow`.

use super::beam::OPEN;
use super::shadow::{LONGER, Shadow};
use super::{Bvh, Child, Entry, Node, WIDTH};
use crate::engine::lanes::{Lanes, Mask, Single};
use crate::engine::packet::PACKETS;
use crate::engine::vector::lanes;
use std::cell::Cell;

/// A packet's rays as boxes see them, by axis, then by lane.
#[derive(Clone, Copy)]
struct Rays {
    inverse: [[f32; 8]; 3],
    above: [[f32; 8]; 3],
    below: [[f32; 8]; 3],
}

/// Is shown the leaves that rays reach.
pub(crate) trait Follow<L: Lanes> {
    /// How far the rays of a packet look at first.
    fn limits(&self, packet: usize) -> [f32; 8];

    /// A leaf that some rays of a packet reach before their limits, which it may shorten; a negative one ends a ray.
    fn leaf(&mut self, packet: usize, rays: u8, leaf: (u32, u32), limits: &mut [f32; 8]);

    /// A leaf that will be shown soon.
    fn soon(&self, first: u32);
}

impl Rays {
    const NONE: Rays = Rays { inverse: [[0.0; 8]; 3], above: [[0.0; 8]; 3], below: [[0.0; 8]; 3] };

    #[inline(always)]
    fn of<L: Lanes>(rays: &Shadow<L>) -> Rays {
        let mut lanes = Rays::NONE;
        for axis in 0..3 {
            lanes.inverse[axis] = rays.inverse[axis].store();
            lanes.above[axis] = rays.above[axis].store();
            lanes.below[axis] = rays.below[axis].store();
        }
        lanes
    }
}

/// The children that wait, with the rays that go there, nearer ones above farther ones of the same node.
struct Waiting {
    near: [f32; OPEN + WIDTH],
    child: [u32; OPEN + WIDTH],
    /// In the last eight bits.
    rays: [u32; OPEN + WIDTH],
}

/// Place for what waits for each packet.
struct Stacks([Waiting; PACKETS]);

thread_local! {
    /// Clearing it for every block would take longer than what is done with it. A mesh is followed within a world.
    static STACKS: Cell<Vec<Box<Stacks>>> = const { Cell::new(Vec::new()) };
}

impl Stacks {
    /// Those of this thread that nobody uses, or new ones.
    #[inline(never)]
    fn take() -> Box<Stacks> {
        const NONE: Waiting = Waiting { near: [0.0; OPEN + WIDTH], child: [0; OPEN + WIDTH], rays: [0; OPEN + WIDTH] };
        let mut unused = STACKS.take();
        let stacks = unused.pop().unwrap_or_else(|| Box::new(Stacks([NONE; PACKETS])));
        STACKS.set(unused);
        stacks
    }

    #[inline(never)]
    fn put_back(self: Box<Stacks>) {
        let mut unused = STACKS.take();
        unused.push(self);
        STACKS.set(unused);
    }
}

/// 2²³: the last bits of an f32 between it and its double are those of an integer.
const INTEGER: f32 = 8_388_608.0;
/// The bit of each lane, as a number.
const BITS: [f32; 8] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0];

/// Lies below all that waits.
const NOTHING_MORE: u32 = u32::MAX;

/// The packets of which the next step is at a node, or of which it is at a leaf.
#[derive(Clone, Copy)]
struct Round {
    packets: [u8; PACKETS],
    count: usize,
}

impl Round {
    const NONE: Round = Round { packets: [0; PACKETS], count: 0 };

    /// Adds a packet if it belongs here.
    #[inline(always)]
    fn add(&mut self, packet: usize, belongs: bool) {
        self.packets[self.count % PACKETS] = packet as u8;
        self.count += usize::from(belongs);
    }
}

/// Where a packet is.
#[derive(Clone, Copy)]
struct Place {
    /// How far its rays look.
    limits: [f32; 8],
    /// What is visited next, and by which rays.
    next: u32,
    rays: u8,
    /// How many children wait.
    waiting: usize,
}

impl Bvh {
    /// Shows every leaf that each ray of some packets reaches before its limit, roughly from near to far.
    #[inline(always)]
    pub(crate) fn follow<L: Lanes>(&self, rays: &[Shadow<L>], packets: u8, visitor: &mut impl Follow<L>) {
        let nodes = self.nodes();
        if nodes.is_empty() {
            return;
        }
        let mut kept = Stacks::take();
        let Stacks(stacks) = &mut *kept;
        let mut all = [Rays::NONE; PACKETS];
        let nowhere = Place { limits: [-1.0; 8], next: 0, rays: 0, waiting: 1 };
        let mut places = [nowhere; PACKETS];
        let (mut inner, mut leaves) = (Round::NONE, Round::NONE);
        for packet in lanes(packets) {
            all[packet] = Rays::of(&rays[packet]);
            let there = rays[packet].that_are_numbers();
            let place = &mut places[packet];
            place.limits = visitor.limits(packet);
            place.rays = there;
            stacks[packet].child[0] = NOTHING_MORE;
            inner.add(packet, there != 0);
        }
        while inner.count + leaves.count > 0 {
            let (now, soon) = (inner, leaves);
            (inner, leaves) = (Round::NONE, Round::NONE);
            for &packet in &now.packets[..now.count % (PACKETS + 1)] {
                let packet = usize::from(packet) % PACKETS;
                let (place, waiting) = (&mut places[packet], &mut stacks[packet]);
                place.at_node::<L>(&all[packet], &nodes[place.next as usize], waiting);
                place.step::<L>(packet, nodes, waiting, (&mut inner, &mut leaves));
            }
            for &packet in &soon.packets[..soon.count % (PACKETS + 1)] {
                visitor.soon(places[usize::from(packet) % PACKETS].next & Child::FIRST);
            }
            for &packet in &soon.packets[..soon.count % (PACKETS + 1)] {
                let packet = usize::from(packet) % PACKETS;
                let (place, waiting) = (&mut places[packet], &mut stacks[packet]);
                if let Entry::Leaf { first, count } = Child::of_bits(place.next).entry() {
                    visitor.leaf(packet, place.rays, (first, count), &mut place.limits);
                }
                place.step::<L>(packet, nodes, waiting, (&mut inner, &mut leaves));
            }
        }
        kept.put_back();
    }
}

impl Place {
    /// Puts the children that some rays meet on top of what waits, the nearest last.
    #[inline(always)]
    fn at_node<L: Lanes>(&mut self, rays: &Rays, node: &Node, waiting: &mut Waiting) {
        let zero = L::Single::splat(0.0);
        let (mut lows, mut highs) = ([zero; 3], [zero; 3]);
        for axis in 0..3 {
            lows[axis] = L::Single::load(&node.low[axis]);
            highs[axis] = L::Single::load(&node.high[axis]);
        }
        let there = lows[0].le(highs[0]);
        // for each child the nearest place where a ray enters, and the sum of the rays' bits
        let most = L::Single::splat(f32::INFINITY);
        let (mut nearest, mut sum) = (most, L::Single::splat(INTEGER));
        for lane in lanes(self.rays) {
            let (mut near, mut far) = (zero, L::Single::splat(self.limits[lane]));
            for axis in 0..3 {
                let inverse = L::Single::splat(rays.inverse[axis][lane]);
                let low = lows[axis].mul_sub(inverse, L::Single::splat(rays.above[axis][lane]));
                let high = highs[axis].mul_sub(inverse, L::Single::splat(rays.below[axis][lane]));
                near = low.min(high).max(near);
                far = low.max(high).min(far);
            }
            let met = near.le(far * L::Single::splat(LONGER));
            nearest = L::Single::select(met, near.min(nearest), nearest);
            sum = sum + L::Single::select(met, L::Single::splat(BITS[lane]), zero);
        }
        let keys = L::Single::select(nearest.lt(most) & there, nearest, L::Single::splat(-1.0));
        let sum: [u32; 8] = bytemuck::cast(sum.store());
        let (near, [child, rays], count) = L::greatest_first(keys, [bytemuck::cast_ref(&node.children), &sum]);
        // a level leaves at most seven open children behind
        put(&mut waiting.near, self.waiting, near);
        put(&mut waiting.child, self.waiting, child);
        put(&mut waiting.rays, self.waiting, rays);
        self.waiting += count;
    }

    /// Takes what waits on top, adds the packet to the round that it belongs to by that, and has it fetched.
    #[inline(always)]
    fn step<L: Lanes>(
        &mut self,
        packet: usize,
        nodes: &[Node],
        waiting: &Waiting,
        (inner, leaves): (&mut Round, &mut Round),
    ) {
        let limits = L::Single::load(&self.limits) * L::Single::splat(LONGER);
        loop {
            self.waiting = self.waiting.wrapping_sub(1).min(OPEN + WIDTH - 1);
            self.next = waiting.child[self.waiting];
            self.rays =
                waiting.rays[self.waiting] as u8 & limits.ge(L::Single::splat(waiting.near[self.waiting])).bits();
            if self.rays != 0 || self.waiting == 0 {
                break;
            }
        }
        let is_leaf = Child::of_bits(self.next).is_leaf();
        leaves.add(packet, is_leaf && self.next != NOTHING_MORE);
        inner.add(packet, !is_leaf);
        // for a leaf the root, which is there
        if let Some(node) = nodes.get(if is_leaf { 0 } else { self.next as usize }) {
            L::prefetch(node);
        }
    }
}

/// Eight at once, to a place that is there.
#[inline(always)]
fn put<T, const N: usize>(list: &mut [T; N], first: usize, eight: [T; WIDTH]) {
    if let Some(place) = list.get_mut(first..).and_then(|rest| rest.first_chunk_mut()) {
        *place = eight;
    }
}
