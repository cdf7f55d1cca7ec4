//! The nodes of a hierarchy: the boxes of eight children side by side, and where the children are.

use super::WIDTH;
use bytemuck::{Pod, Zeroable};

/// An inner node. The children's boxes are relative to the hierarchy's origin and rounded outwards.
#[repr(C, align(32))]
#[derive(Clone, Debug, Zeroable)]
pub(crate) struct Node {
    /// The least corners, by axis, then by child; `+∞` where there is no child.
    pub(crate) low: [[f32; WIDTH]; 3],
    /// The greatest corners; `-∞` where there is no child.
    pub(crate) high: [[f32; WIDTH]; 3],
    pub(crate) children: [Child; WIDTH],
}

impl Node {
    /// A node without children. No ray meets its boxes; should one that is not a number seem to, it finds a leaf there
    /// and does not go around in circles.
    pub(crate) const EMPTY: Node = Node {
        low: [[f32::INFINITY; WIDTH]; 3],
        high: [[f32::NEG_INFINITY; WIDTH]; 3],
        children: [Child(Child::LEAF); WIDTH],
    };
}

impl Node {
    /// Whether there is a child at that place.
    #[inline(always)]
    pub(crate) fn holds(&self, child: usize) -> bool {
        self.low[0][child] <= self.high[0][child]
    }
}

/// Where a child is, in 32 bits. Bit 31: it is a leaf; then bits 28 to 30 hold its count less 1, the rest its first.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Zeroable, Pod)]
pub(crate) struct Child(u32);

/// What a child is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Entry {
    /// The node of that number.
    Inner(u32),
    /// Things `first..first + count` in the order of the leaves.
    Leaf { first: u32, count: u32 },
}

impl Child {
    const LEAF: u32 = 1 << 31;
    const COUNT_SHIFT: u32 = 28;
    /// The bits of a leaf's first place.
    pub(crate) const FIRST: u32 = (1 << Child::COUNT_SHIFT) - 1;
    /// The greatest count of a leaf.
    pub(crate) const MOST: usize = 8;
    /// How many nodes and how many places in leaves a hierarchy can have.
    pub(crate) const PLACES: usize = 1 << Child::COUNT_SHIFT;

    /// The child that is that node.
    pub(crate) fn inner(node: u32) -> Child {
        Child(node)
    }

    /// A leaf of 1 to 8 things.
    pub(crate) fn leaf(first: u32, count: u32) -> Child {
        Child(Child::LEAF | (count - 1) << Child::COUNT_SHIFT | first)
    }

    /// Whether it is a leaf.
    #[inline(always)]
    pub(crate) fn is_leaf(self) -> bool {
        self.0 & Child::LEAF != 0
    }

    /// The child of these bits.
    #[inline(always)]
    pub(crate) fn of_bits(bits: u32) -> Child {
        Child(bits)
    }

    /// What it is.
    #[inline(always)]
    pub(crate) fn entry(self) -> Entry {
        if self.0 & Child::LEAF == 0 {
            Entry::Inner(self.0)
        } else {
            Entry::Leaf { first: self.0 & Child::FIRST, count: (self.0 >> Child::COUNT_SHIFT & 7) + 1 }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn children_are_what_they_were_made_of() {
        for node in [0, 1, Child::FIRST] {
            assert_eq!(Child::inner(node).entry(), Entry::Inner(node));
        }
        for first in [0, 1, 77, Child::FIRST] {
            for count in 1..=Child::MOST as u32 {
                assert_eq!(Child::leaf(first, count).entry(), Entry::Leaf { first, count });
            }
        }
        assert_eq!(size_of::<Node>(), 224);
    }
}
