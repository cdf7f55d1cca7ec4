//! Many rays through a hierarchy at once.
//!
//! Up to eight packets of eight rays go down together. A node's eight boxes are tried at once against the interval of all
//! rays; what is left, box by box, against the intervals of all packets at once; where few packets are left, against
//! their rays. All of it is f32 and conservative: a box that a ray can meet before its limit is never passed over.
//!
//! How far f32 may be off: an origin relative to the hierarchy's is off by 2⁻²⁴ of itself, and so are products and
//! differences with the boxes' coordinates, so every box is taken wider by 2⁻²² of the greatest coordinate; inverse
//! directions and quotients are off by a few 2⁻²⁴ of themselves, so the far end is taken longer by 2⁻²⁰.

use super::{Bvh, Entry, MAX_DEPTH, Margin, Node, WIDTH};
use crate::engine::lanes::{Lanes, Mask, Real, Single};
use crate::engine::packet::PACKETS;
use crate::engine::vector::{Vector, lanes, narrow};
use arrayvec::ArrayVec;

/// 2⁻²² and 1 + 2⁻²⁰, see above.
const WIDER: f32 = 1.0 / 4_194_304.0;
pub(super) const LONGER: f32 = 1.0 + 1.0 / 1_048_576.0;
/// A component of a direction is never less than this share of the greatest: its quotients stay finite. Within any
/// distance that coordinates allow a ray turned by this much stays within the widening of the boxes.
const FLAT: f32 = 1e-20;
/// A level leaves at most seven open children behind.
pub(super) const OPEN: usize = (WIDTH - 1) * MAX_DEPTH + WIDTH;

/// So many packets are asked ray by ray at every node.
const FEW: u32 = 4;

/// The f32 shadow of a packet's rays, relative to a hierarchy's origin.
#[derive(Clone, Copy)]
pub(crate) struct Shadow<L: Lanes> {
    pub(crate) origin: [L::Single; 3],
    pub(crate) direction: [L::Single; 3],
    /// The greatest component of the direction times the sum of the greatest coordinates of start and hierarchy: what
    /// errors of products grow with.
    pub(crate) spread: L::Single,
    pub(super) inverse: [L::Single; 3],
    /// `(origin + w)/direction` and `(origin - w)/direction`, where `w` is what the boxes are wider by.
    pub(super) above: [L::Single; 3],
    pub(super) below: [L::Single; 3],
    /// What the boxes are wider by: 2⁻²² of the greatest coordinates of start and hierarchy.
    pub(crate) wider: L::Single,
    /// The lanes that hold a ray.
    pub(crate) mask: u8,
}

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
    margin: Margin,
    /// The greatest coordinate of the hierarchy, relative to its origin.
    extent: f32,
    pub(crate) packets: [Shadow<L>; PACKETS],
    /// How many of them there are.
    count: usize,
    /// How far each packet still looks; negative: no more.
    limits: [f32; PACKETS],
    intervals: Intervals,
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
    /// A beam without rays. The margin is that of f64: what a ray's hits can be off.
    #[inline(always)]
    pub(crate) fn new(bvh: &'b Bvh, margin: Margin) -> Beam<'b, L> {
        let zero = L::Single::splat(0.0);
        let none = [zero; 3];
        let nobody = Shadow {
            origin: none,
            direction: none,
            spread: zero,
            inverse: none,
            above: none,
            below: none,
            wider: zero,
            mask: 0,
        };
        Beam {
            bvh,
            margin,
            extent: bvh.extent(),
            packets: [nobody; PACKETS],
            count: 0,
            limits: [-1.0; PACKETS],
            intervals: Intervals::EMPTY,
        }
    }

    /// Adds a packet whose rays look as far as `limit`, in lengths of their directions. `start` is where they start in the
    /// world, `origin` and `direction` are the rays in the hierarchy's space.
    #[inline(always)]
    pub(crate) fn push(
        &mut self,
        start: Vector<L::Real>,
        (origin, direction): (Vector<L::Real>, Vector<L::Real>),
        mask: u8,
        limit: f32,
    ) {
        let margin = L::Real::splat(self.margin.fixed) + L::Real::splat(self.margin.per_origin) * start.greatest();
        let origin = narrow::<L>(origin - Vector::splat(self.bvh.origin()));
        let direction = narrow::<L>(direction);
        let farthest = origin[0].abs().max(origin[1].abs()).max(origin[2].abs());
        // as if the coordinates were so great that their rounding is the margin
        let coordinates = farthest + L::Single::splat(self.extent) + L::narrow(margin) * L::Single::splat(2.0 / WIDER);
        let wider = coordinates * L::Single::splat(WIDER);
        let greatest = direction[0].abs().max(direction[1].abs()).max(direction[2].abs());
        let flat = greatest * L::Single::splat(FLAT);
        let zero = L::Single::splat(0.0);
        let (mut inverse, mut above, mut below) = ([zero; 3], [zero; 3], [zero; 3]);
        for axis in 0..3 {
            let along = direction[axis];
            let size = along.abs().max(flat);
            let along = L::Single::select(along.lt(zero), -size, size);
            inverse[axis] = L::Single::splat(1.0) / along;
            above[axis] = (origin[axis] + wider) * inverse[axis];
            below[axis] = (origin[axis] - wider) * inverse[axis];
        }
        let place = self.count % PACKETS;
        self.count += 1;
        if self.bvh.nodes().len() > 1 {
            self.intervals.set(place, &Interval::of::<L>(&origin, wider, &inverse, mask));
        }
        self.limits[place] = if mask == 0 { -1.0 } else { limit };
        let spread = greatest * coordinates;
        self.packets[place] = Shadow { origin, direction, spread, inverse, above, below, wider, mask };
    }

    /// Adds a packet of which no ray takes part, so that the places of packets stay the same.
    #[inline(always)]
    pub(crate) fn skip(&mut self) {
        self.count += 1;
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
            for packet in 0..self.count.min(PACKETS) {
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
        let interval = Interval::of::<L>(&rays.origin, rays.wider, &rays.inverse, rays.mask);
        self.intervals.set(packet, &interval);
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

impl Interval {
    /// No ray: neutral in a union.
    const EMPTY: Interval =
        Interval { start: [[f32::INFINITY, f32::NEG_INFINITY]; 3], inverse: [[f32::INFINITY, f32::NEG_INFINITY]; 3] };

    #[inline(always)]
    fn of<L: Lanes>(origin: &[L::Single; 3], wider: L::Single, inverse: &[L::Single; 3], mask: u8) -> Interval {
        let mask = <L::Single as Single>::Mask::from_bits(mask);
        let most = L::Single::splat(f32::INFINITY);
        let mut interval = Interval::EMPTY;
        for axis in 0..3 {
            let (low, high) = (origin[axis] - wider, origin[axis] + wider);
            interval.start[axis][0] = L::Single::select(mask, low, most).least();
            interval.start[axis][1] = L::Single::select(mask, high, -most).greatest();
            interval.inverse[axis][0] = L::Single::select(mask, inverse[axis], most).least();
            interval.inverse[axis][1] = L::Single::select(mask, inverse[axis], -most).greatest();
        }
        interval
    }

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
