//! From a binary tree to wide nodes at the least cost: how the children of a binary node are spread over the eight places
//! of a wide one, and where a leaf begins, by dynamic programming (Ylitie, Karras and Laine 2017, §3.1).

use crate::bvh::WIDTH;

/// A node of the binary tree. It comes after its children; the right one right before it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Twig {
    /// The left child.
    left: u32,
    /// Its items in the order of the leaves, or for a leaf of another kind what its maker says.
    pub(super) first: u32,
    pub(super) count: u32,
    /// For 2 to 8 places how many of them the left child gets, 0 if it is best to use one less; three bits each. Bits 21
    /// to 23: up to that many places it is best to use one alone. Bit 31: in one place it is a leaf.
    plan: u32,
}

/// The binary tree, with the least costs of each node so far.
pub(super) struct Tree {
    pub(super) twigs: Vec<Twig>,
    costs: Vec<Costs>,
}

/// The least cost of a node in at most 1, 2 … 7 places: area times what is done there, where trying the boxes of a node is
/// 1.
type Costs = [f32; WIDTH - 1];

const LEAF: u32 = 1 << 31;
const ALONE_SHIFT: u32 = 21;

impl Twig {
    /// Whether it is best off with one place, however many it may have.
    fn is_always_alone(&self) -> bool {
        self.plan >> ALONE_SHIFT & 7 == 7
    }

    /// Whether it is a leaf where it has a place to itself.
    pub(super) fn is_leaf(&self) -> bool {
        self.plan & LEAF != 0
    }
}

impl Tree {
    pub(super) const NEW: Tree = Tree { twigs: Vec::new(), costs: Vec::new() };

    /// The number of the node that was added last.
    pub(super) fn last(&self) -> u32 {
        (self.twigs.len() - 1) as u32
    }

    pub(super) fn clear(&mut self) {
        self.twigs.clear();
        self.costs.clear();
    }

    /// Adds a leaf of these items.
    pub(super) fn leaf(&mut self, first: usize, count: usize, cost: f32) -> u32 {
        self.twigs.push(Twig { left: 0, first: first as u32, count: count as u32, plan: LEAF | 7 << ALONE_SHIFT });
        self.costs.push([cost; WIDTH - 1]);
        self.last()
    }

    /// Adds the parent of `left` and the last node, which may be a leaf of that cost instead; of an infinite one it may not.
    pub(super) fn fork(&mut self, left: u32, first: usize, count: usize, area: f32, as_leaf: f32) -> u32 {
        let right = self.last();
        let (l, r) = (&self.costs[left as usize], &self.costs[right as usize]);
        let [l_alone, r_alone] = [left, right].map(|child| self.twigs[child as usize].is_always_alone());
        let mut plan = 0;
        let mut costs = [0.0; WIDTH - 1];
        let mut before = f32::INFINITY;
        for places in 2..=WIDTH {
            // what makes use of one place alone gets no more
            let range = match (l_alone, r_alone) {
                (true, _) => 1..2,
                (false, true) => places - 1..places,
                (false, false) => 1..places,
            };
            let mut best = (f32::INFINITY, range.start);
            for given in range {
                let cost = l[given - 1] + r[places - given - 1];
                if cost < best.0 {
                    best = (cost, given);
                }
            }
            if best.0 < before || places == 2 {
                plan |= (best.1 as u32) << (3 * (places - 2));
                before = best.0;
            }
            if places < WIDTH {
                costs[places - 1] = before;
            }
        }
        let inner = before + area;
        let is_leaf = as_leaf <= inner;
        if is_leaf {
            plan |= LEAF;
        }
        costs[0] = if is_leaf { as_leaf } else { inner };
        let mut alone = 1;
        for places in 2..WIDTH {
            if costs[0] <= costs[places - 1] {
                costs[places - 1] = costs[0];
                alone = places as u32;
            }
        }
        plan |= alone << ALONE_SHIFT;
        self.twigs.push(Twig { left, first: first as u32, count: count as u32, plan });
        self.costs.push(costs);
        self.last()
    }
}

/// The nodes that stand in the places of a wide node made of that one.
pub(super) fn spread(twigs: &[Twig], node: u32) -> Spread {
    let mut spread = Spread { nodes: [0; WIDTH], len: 0 };
    place(twigs, node, WIDTH, true, &mut spread);
    spread
}

fn place(twigs: &[Twig], node: u32, mut places: usize, is_root: bool, spread: &mut Spread) {
    let Twig { left, plan, .. } = twigs[node as usize];
    if !is_root && places as u32 <= (plan >> ALONE_SHIFT & 7) {
        spread.nodes[spread.len] = node;
        spread.len += 1;
        return;
    }
    let given = |places: usize| (plan >> (3 * (places - 2)) & 7) as usize;
    while given(places) == 0 && places > 2 {
        places -= 1;
    }
    place(twigs, left, given(places), false, spread);
    place(twigs, node - 1, places - given(places), false, spread);
}

/// Up to eight nodes.
pub(super) struct Spread {
    nodes: [u32; WIDTH],
    len: usize,
}

impl Spread {
    pub(super) fn nodes(&self) -> &[u32] {
        &self.nodes[..self.len]
    }
}

/// How much room a tree takes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Size {
    /// Wide nodes.
    pub(super) nodes: usize,
    /// Packs in its leaves.
    pub(super) packs: usize,
}

impl Size {
    pub(super) fn and(self, other: Size) -> Size {
        Size { nodes: self.nodes + other.nodes, packs: self.packs + other.packs }
    }

    /// The room of the tree whose root is the last node.
    pub(super) fn of(twigs: &[Twig], pack: usize) -> Size {
        let mut size = Size::default();
        let mut open = vec![twigs.len() as u32 - 1];
        while let Some(node) = open.pop() {
            let twig = &twigs[node as usize];
            if twig.is_leaf() {
                size.packs += (twig.count as usize).div_ceil(pack);
            } else {
                size.nodes += 1;
                open.extend_from_slice(spread(twigs, node).nodes());
            }
        }
        size
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bvh::Child;
    use proptest::prelude::*;

    /// A binary tree with an area for each node and packs for each leaf.
    #[derive(Clone, Debug)]
    enum Plain {
        Leaf { area: f32, packs: usize },
        Fork { area: f32, children: Box<[Plain; 2]> },
    }

    impl Plain {
        fn area(&self) -> f32 {
            match self {
                Plain::Leaf { area, .. } | Plain::Fork { area, .. } => *area,
            }
        }

        fn packs(&self) -> usize {
            match self {
                Plain::Leaf { packs, .. } => *packs,
                Plain::Fork { children, .. } => children.iter().map(Plain::packs).sum(),
            }
        }

        fn as_leaf(&self) -> f32 {
            if self.packs() <= Child::MOST { self.area() * self.packs() as f32 } else { f32::INFINITY }
        }

        /// The least cost in at most so many places of a wide node: all ways are tried.
        fn cost(&self, places: usize) -> f32 {
            let as_leaf = self.as_leaf();
            let Plain::Fork { area, children } = self else { return as_leaf };
            let split = |places: usize| {
                (1..places)
                    .map(|given| children[0].cost(given) + children[1].cost(places - given))
                    .fold(f32::INFINITY, f32::min)
            };
            let alone = as_leaf.min(area + split(WIDTH));
            if places == 1 { alone } else { alone.min(split(places)) }
        }

        fn grow(&self, tree: &mut Tree, first: &mut usize) -> u32 {
            match self {
                Plain::Leaf { packs, .. } => {
                    *first += packs;
                    tree.leaf(*first - packs, *packs, self.as_leaf())
                }
                Plain::Fork { area, children } => {
                    let start = *first;
                    let left = children[0].grow(tree, first);
                    children[1].grow(tree, first);
                    tree.fork(left, start, *first - start, *area, self.as_leaf())
                }
            }
        }
    }

    fn plain() -> impl Strategy<Value = Plain> {
        // small integers, so that no sum is rounded
        let leaf = (1..40_u8, 1..3_usize).prop_map(|(area, packs)| Plain::Leaf { area: f32::from(area), packs });
        leaf.prop_recursive(4, 24, 2, |inner| {
            (inner.clone(), inner, 0..40_u8).prop_map(|(left, right, more)| {
                let area = left.area().max(right.area()) + f32::from(more);
                Plain::Fork { area, children: Box::new([left, right]) }
            })
        })
    }

    /// What the wide nodes of the plan cost.
    fn planned(tree: &Tree, areas: &dyn Fn(u32) -> f32, node: u32) -> f32 {
        let twig = &tree.twigs[node as usize];
        if twig.is_leaf() {
            return areas(node) * twig.count as f32;
        }
        let spread = spread(&tree.twigs, node);
        assert!((2..=WIDTH).contains(&spread.nodes().len()));
        areas(node) + spread.nodes().iter().map(|child| planned(tree, areas, *child)).sum::<f32>()
    }

    fn areas(plain: &Plain, areas: &mut Vec<f32>) {
        if let Plain::Fork { children, .. } = plain {
            children.iter().for_each(|child| self::areas(child, areas));
        }
        areas.push(plain.area());
    }

    proptest! {
        #[test]
        fn no_other_way_costs_less(plain in plain()) {
            let mut tree = Tree::NEW;
            let root = plain.grow(&mut tree, &mut 0);
            let mut known = Vec::new();
            areas(&plain, &mut known);
            let cost = planned(&tree, &|node| known[node as usize], root);
            prop_assert_eq!(cost, plain.cost(1));
            let size = Size::of(&tree.twigs, 1);
            prop_assert_eq!(size.packs, plain.packs());
        }
    }
}
