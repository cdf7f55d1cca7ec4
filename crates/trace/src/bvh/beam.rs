//! Many rays through a hierarchy at once.
//!
//! Up to eight packets of eight rays go down together. A node's eight boxes are tried at once against the interval of all
//! rays; what is left, box by box, against the intervals of all packets at once; where few packets are left, against
//! their rays. All of it is f32 and conservative: a box that a ray can meet before its limit is never passed over.
//!
//! The bounds of errors are those of `shadow`.

use super::shadow::{LONGER, Shadow};
use super::{Bvh, Entry, MAX_DEPTH, Node, WIDTH};
use crate::engine::lanes::{Lanes, Mask, Single};
use crate::engine::packet::{PACKETS, PerPacket};
use crate::engine::vector::lanes;
use arrayvec::ArrayVec;

/// A level leaves at most seven open children behind.
pub(super) const OPEN: usize = (WIDTH - 1) * MAX_DEPTH + WIDTH;

/// So many packets are asked ray by ray at every node.
const FEW: u32 = 4;

/// Where all rays of a packet start and how they go: least and greatest coordinates, widened, and inverse directions.
#[derive(Clone, Copy, Debug)]
struct Interval {
    start: [[f32; 2]; 3],
    inverse: [[f32; 2]; 3],
}

/// The rays that go through a hierarchy together.
#[derive(Clone)]
pub(crate) struct Beam<'b, L: Lanes> {
    bvh: &'b Bvh,
    pub(crate) packets: PerPacket<Shadow<L>>,
    /// Where all of them start, once it is known, if that is one point.
    start: OneStart,
    /// How far each packet still looks; negative: no more.
    limits: [f32; PACKETS],
    intervals: Intervals,
}

/// Where all packets of a beam start.
#[derive(Clone, Copy, Debug)]
enum OneStart {
    /// At several points.
    None,
    /// At one point that is not known yet.
    Unknown,
    /// There: its coordinates, widened.
    At([[f32; 2]; 3]),
}

/// The packets that go down together, and those of them whose rays go both ways along some axis.
#[derive(Clone, Copy, Debug)]
struct Turn {
    packets: u8,
    wide: u8,
}

/// Is shown the leaves that rays reach.
pub(crate) trait Visit<L: Lanes> {
    /// A leaf, and the packets of which some ray may meet its box. May shorten the beam.
    fn leaf(&mut self, beam: &mut Beam<'_, L>, first: u32, count: u32, packets: u8);

    /// How far some rays of a packet still look; negative: no more.
    fn limit(&self, packet: usize, lanes: u8) -> f32;
}

/// A child that waits for its turn.
#[derive(Clone, Copy)]
struct Open {
    node: u32,
    child: u8,
    packets: u8,
    near: f32,
}

impl<'b, L: Lanes> Beam<'b, L> {
    /// A beam without rays.
    #[inline(always)]
    pub(crate) fn new(bvh: &'b Bvh, from_one_point: bool) -> Beam<'b, L> {
        let start = if from_one_point { OneStart::Unknown } else { OneStart::None };
        let (limits, intervals) = ([-1.0; PACKETS], Intervals::EMPTY);
        Beam { bvh, packets: PerPacket::new(), start, limits, intervals }
    }

    /// Adds a packet whose rays look as far as `limit`, in lengths of their directions. One without rays keeps a place.
    #[inline(always)]
    pub(crate) fn push(&mut self, rays: Shadow<L>, limit: f32) {
        let place = self.packets.len() % PACKETS;
        if rays.mask != 0 {
            self.limits[place] = limit;
            if self.bvh.nodes().len() > 1 {
                let start = match self.start {
                    OneStart::At(start) => start,
                    OneStart::Unknown | OneStart::None => starts(&rays),
                };
                if let OneStart::Unknown = self.start {
                    self.start = OneStart::At(start);
                }
                self.intervals.set(place, &Interval { start, inverse: inverses(&rays) });
            }
        }
        self.packets.push(rays);
    }

    /// Shortens a packet's rays; a negative limit ends them.
    #[inline(always)]
    pub(crate) fn shorten(&mut self, packet: usize, limit: f32) {
        self.limits[packet] = limit;
    }

    /// The packets that look anywhere.
    #[inline(always)]
    pub(crate) fn looking(&self) -> u8 {
        self.still_looking(0.0)
    }

    /// The packets of which the rays go so different ways that each had better go alone.
    #[inline(always)]
    pub(crate) fn scattered(&self) -> u8 {
        let mut packets = 0;
        if self.bvh.nodes().len() > 1 {
            for packet in lanes(self.still_looking(0.0)) {
                packets |= u8::from(self.intervals.get(packet).axes_of_both_ways() > 1) << packet;
            }
        }
        packets
    }

    /// Shows every leaf that some ray reaches before its limit, roughly from near to far.
    #[inline(always)]
    pub(crate) fn traverse(&mut self, visitor: &mut impl Visit<L>) {
        let bvh = self.bvh;
        match bvh.nodes() {
            [] => {}
            [only] => self.try_each(only, visitor),
            nodes => self.descend(nodes, visitor),
        }
    }

    /// The children of the only node, ray by ray.
    #[inline(always)]
    fn try_each(&mut self, node: &Node, visitor: &mut impl Visit<L>) {
        for child in 0..WIDTH {
            if !node.holds(child) {
                continue;
            }
            let Entry::Leaf { first, count } = node.children[child].entry() else { continue };
            let mut packets = 0;
            for packet in 0..self.packets.len() {
                packets |= u8::from(self.rays_meet(packet, node, child) != 0) << packet;
            }
            if packets != 0 {
                visitor.leaf(self, first, count, packets);
            }
        }
    }

    /// From the root down: packets of rays that keep together all at once, the rays of the others one by one.
    #[inline(always)]
    fn descend(&mut self, nodes: &[Node], visitor: &mut impl Visit<L>) {
        let all = self.still_looking(0.0);
        let mut turn = Turn { packets: 0, wide: 0 };
        for packet in lanes(all) {
            let axes = self.intervals.get(packet).axes_of_both_ways();
            turn.packets |= u8::from(axes <= 1) << packet;
            turn.wide |= u8::from(axes == 1) << packet;
        }
        // the rays that are still to come, one by one, of each packet
        let mut alone = [0_u8; PACKETS];
        for packet in lanes(all & !turn.packets) {
            alone[packet] = self.packets[packet].mask;
        }
        // one call of the walk, so that it is compiled once
        loop {
            if turn.packets != 0 {
                self.walk(nodes, turn, visitor);
            }
            let Some(packet) = alone.iter().position(|rays| *rays != 0) else { break };
            let lane = alone[packet].trailing_zeros();
            alone[packet] &= alone[packet] - 1;
            self.isolate(packet, lane as usize, visitor.limit(packet, 1 << lane));
            turn = Turn { packets: 1 << packet, wide: 0 };
        }
    }

    /// Leaves a packet only one of its rays.
    #[inline(always)]
    fn isolate(&mut self, packet: usize, lane: usize, limit: f32) {
        let rays = &mut self.packets[packet];
        rays.mask = 1 << lane;
        self.intervals.set(packet, &Interval { start: starts(rays), inverse: inverses(rays) });
        self.limits[packet] = limit;
    }

    /// From the root down, nearer children first.
    #[inline(always)]
    fn walk(&mut self, nodes: &[Node], turn: Turn, visitor: &mut impl Visit<L>) {
        let several = !turn.packets.is_power_of_two();
        let whole = if several { self.intervals.whole::<L>(turn.packets) } else { Interval::EMPTY };
        let mut open: ArrayVec<Open, OPEN> = ArrayVec::new();
        let (mut number, mut packets) = (0_u32, turn.packets);
        while packets != 0 {
            let node = &nodes[number as usize];
            // one packet alone is tried by its own interval, several by that of all rays
            let alone = packets.is_power_of_two();
            let own = if alone { self.intervals.get(packets.trailing_zeros() as usize) } else { whole };
            let (hits, nears) = own.meet::<L>(node, self.farthest(packets));
            let bottom = open.len();
            for child in lanes(hits) {
                if !node.holds(child) {
                    continue;
                }
                let mut left = packets;
                if !alone {
                    left &= self.intervals.meet::<L>(node, child, &self.limits);
                }
                let left = self.refined(left, turn.wide, alone, node, child);
                if left != 0 {
                    let mut place = open.len();
                    open.push(Open { node: number, child: child as u8, packets: left, near: nears[child] });
                    // the nearest on top
                    while place > bottom && open[place - 1].near < open[place].near {
                        open.swap(place - 1, place);
                        place -= 1;
                    }
                }
            }
            packets = 0;
            while let Some(next) = open.pop() {
                let left = next.packets & self.still_looking(next.near);
                if left == 0 {
                    continue;
                }
                let (parent, child) = (&nodes[next.node as usize], next.child as usize);
                match parent.children[child].entry() {
                    Entry::Inner(inner) => {
                        (number, packets) = (inner, left);
                        break;
                    }
                    Entry::Leaf { first, count } => {
                        visitor.leaf(self, first, count, left);
                    }
                }
            }
        }
    }

    /// The packets of which some ray meets a child's box. Ray by ray all are only asked where few packets are left, which
    /// bounds the work, at leaves, where more depends on it, and wide ones; of others, one after the other until one meets
    /// it. So a large box costs one question, and a box between the rays, of which a mesh seen from afar is full, is left
    /// out.
    #[inline(always)]
    fn refined(&self, mut packets: u8, wide: u8, alone: bool, node: &Node, child: usize) -> u8 {
        let each = packets.count_ones() <= FEW || node.children[child].is_leaf();
        let asked = if each { packets } else { packets & wide };
        for packet in lanes(asked) {
            // the interval of a single ray is that ray
            let known = alone && self.packets[packet].mask.is_power_of_two();
            if !known && self.rays_meet(packet, node, child) == 0 {
                packets &= !(1 << packet);
            }
        }
        for packet in lanes(packets & !asked) {
            if self.rays_meet(packet, node, child) != 0 {
                break;
            }
            packets &= !(1 << packet);
        }
        packets
    }

    /// The rays of a packet that meet a child's box before its limit.
    #[inline(always)]
    fn rays_meet(&self, packet: usize, node: &Node, child: usize) -> u8 {
        let rays = &self.packets[packet];
        let (mut near, mut far) = (L::Single::splat(0.0), L::Single::splat(self.limits[packet]));
        for axis in 0..3 {
            let low = L::Single::splat(node.low[axis][child]).mul_sub(rays.inverse[axis], rays.above[axis]);
            let high = L::Single::splat(node.high[axis][child]).mul_sub(rays.inverse[axis], rays.below[axis]);
            near = near.max(low.min(high));
            far = far.min(low.max(high));
        }
        near.le(far * L::Single::splat(LONGER)).bits() & rays.mask
    }

    /// The packets that still look as far as that.
    #[inline(always)]
    fn still_looking(&self, near: f32) -> u8 {
        let limits = L::Single::load(&self.limits);
        let near = L::Single::splat(near);
        (limits.ge(L::Single::splat(0.0)) & (limits * L::Single::splat(LONGER)).ge(near)).bits()
    }

    /// The farthest limit of some packets.
    #[inline(always)]
    fn farthest(&self, packets: u8) -> f32 {
        let limits = L::Single::load(&self.limits);
        L::Single::select(L::SingleMask::from_bits(packets), limits, L::Single::splat(-1.0)).greatest()
    }
}

/// The least and the greatest coordinates of where the rays of a packet start, widened.
#[inline(always)]
fn starts<L: Lanes>(rays: &Shadow<L>) -> [[f32; 2]; 3] {
    let mut starts = [[0.0; 2]; 3];
    for (ends, &origin) in starts.iter_mut().zip(&rays.origin) {
        *ends = [extremes(rays.mask, origin - rays.wider)[0], extremes(rays.mask, origin + rays.wider)[1]];
    }
    starts
}

/// The least and the greatest inverse directions of the rays of a packet.
#[inline(always)]
fn inverses<L: Lanes>(rays: &Shadow<L>) -> [[f32; 2]; 3] {
    let mut inverses = [[0.0; 2]; 3];
    for (ends, &inverse) in inverses.iter_mut().zip(&rays.inverse) {
        *ends = extremes(rays.mask, inverse);
    }
    inverses
}

/// The least and the greatest of some lanes.
#[inline(always)]
fn extremes<S: Single>(lanes: u8, of: S) -> [f32; 2] {
    let (mask, most) = (S::Mask::from_bits(lanes), S::splat(f32::INFINITY));
    [S::select(mask, of, most).least(), S::select(mask, of, -most).greatest()]
}

impl Interval {
    /// No ray: neutral in a union.
    const EMPTY: Interval =
        Interval { start: [[f32::INFINITY, f32::NEG_INFINITY]; 3], inverse: [[f32::INFINITY, f32::NEG_INFINITY]; 3] };

    /// Along how many axes some rays go up and some down.
    #[inline(always)]
    fn axes_of_both_ways(&self) -> u32 {
        let mut axes = 0;
        for axis in 0..3 {
            axes += u32::from(self.inverse[axis][0] < 0.0 && self.inverse[axis][1] > 0.0);
        }
        axes
    }

    /// The children whose boxes some ray may meet before `farthest`, and where at the nearest.
    #[inline(always)]
    fn meet<L: Lanes>(&self, node: &Node, farthest: f32) -> (u8, [f32; WIDTH]) {
        let (mut near, mut far) = (L::Single::splat(0.0), L::Single::splat(farthest));
        for axis in 0..3 {
            let [low, high] = self.start[axis];
            let (low, high) = (L::Single::splat(low), L::Single::splat(high));
            let [least, greatest] = one_sided(self.inverse[axis]);
            let (least, greatest) = (L::Single::splat(least), L::Single::splat(greatest));
            let node_low = L::Single::load(&node.low[axis]);
            let node_high = L::Single::load(&node.high[axis]);
            let (enter, leave) = slab::<L>(node_low - high, node_high - low, least, greatest);
            near = near.max(enter);
            far = far.min(leave);
        }
        (near.le(far * L::Single::splat(LONGER)).bits(), near.store())
    }
}

/// Stands for every quotient.
const ANY: f32 = 1e30;

/// Rays that go both ways along an axis say nothing about it: every quotient is possible.
#[inline(always)]
fn one_sided(inverse: [f32; 2]) -> [f32; 2] {
    if inverse[0] < 0.0 && inverse[1] > 0.0 { [-ANY, ANY] } else { inverse }
}

/// The least and the greatest product of a distance between `low` and `high` and an inverse between `least` and
/// `greatest`.
#[inline(always)]
fn slab<L: Lanes>(low: L::Single, high: L::Single, least: L::Single, greatest: L::Single) -> (L::Single, L::Single) {
    let [a, b, c, d] = [low * least, low * greatest, high * least, high * greatest];
    (a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
}

/// The intervals of all packets, one packet a lane.
#[derive(Clone)]
struct Intervals {
    start: [[[f32; PACKETS]; 2]; 3],
    inverse: [[[f32; PACKETS]; 2]; 3],
}

impl Intervals {
    /// Those of no ray.
    const EMPTY: Intervals = {
        let none = [[f32::INFINITY; PACKETS], [f32::NEG_INFINITY; PACKETS]];
        Intervals { start: [none; 3], inverse: [none; 3] }
    };

    #[inline(always)]
    fn set(&mut self, packet: usize, interval: &Interval) {
        for axis in 0..3 {
            for end in 0..2 {
                self.start[axis][end][packet] = interval.start[axis][end];
                self.inverse[axis][end][packet] = interval.inverse[axis][end];
            }
        }
    }

    #[inline(always)]
    fn get(&self, packet: usize) -> Interval {
        let mut interval = Interval::EMPTY;
        for axis in 0..3 {
            for end in 0..2 {
                interval.start[axis][end] = self.start[axis][end][packet];
                interval.inverse[axis][end] = self.inverse[axis][end][packet];
            }
        }
        interval
    }

    /// The interval around those of some packets.
    #[inline(always)]
    fn whole<L: Lanes>(&self, packets: u8) -> Interval {
        let mask = L::SingleMask::from_bits(packets);
        let most = L::Single::splat(f32::INFINITY);
        let mut whole = Interval::EMPTY;
        for axis in 0..3 {
            let (start, inverse) = (&self.start[axis], &self.inverse[axis]);
            whole.start[axis][0] = L::Single::select(mask, L::Single::load(&start[0]), most).least();
            whole.start[axis][1] = L::Single::select(mask, L::Single::load(&start[1]), -most).greatest();
            whole.inverse[axis][0] = L::Single::select(mask, L::Single::load(&inverse[0]), most).least();
            whole.inverse[axis][1] = L::Single::select(mask, L::Single::load(&inverse[1]), -most).greatest();
        }
        whole
    }

    /// The packets of which some ray may meet a child's box before their limits.
    #[inline(always)]
    fn meet<L: Lanes>(&self, node: &Node, child: usize, limits: &[f32; PACKETS]) -> u8 {
        let (mut near, mut far) = (L::Single::splat(0.0), L::Single::load(limits));
        for axis in 0..3 {
            let (start, inverse) = (&self.start[axis], &self.inverse[axis]);
            let low = L::Single::splat(node.low[axis][child]) - L::Single::load(&start[1]);
            let high = L::Single::splat(node.high[axis][child]) - L::Single::load(&start[0]);
            let (least, greatest) = (L::Single::load(&inverse[0]), L::Single::load(&inverse[1]));
            let zero = L::Single::splat(0.0);
            let both = least.lt(zero) & greatest.gt(zero);
            let least = L::Single::select(both, L::Single::splat(-ANY), least);
            let greatest = L::Single::select(both, L::Single::splat(ANY), greatest);
            let (enter, leave) = slab::<L>(low, high, least, greatest);
            near = near.max(enter);
            far = far.min(leave);
        }
        near.le(far * L::Single::splat(LONGER)).bits()
    }
}
