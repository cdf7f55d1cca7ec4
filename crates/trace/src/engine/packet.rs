//! Packets of eight rays and blocks of up to eight packets: what is traced together.

use super::lanes::Lanes;
use super::vector::Vector;
use crate::RayKind;
use arrayvec::ArrayVec;
use glam::DVec3;

/// How many packets a block has at most.
pub(crate) const PACKETS: usize = 8;
/// Stands for "no body".
pub(crate) const NOTHING: u32 = u32::MAX;

/// A list with one item for each packet of a block.
pub(crate) type PerPacket<T> = ArrayVec<T, PACKETS>;
/// Eight colours: red, green, blue.
pub(crate) type Colors<L> = [<L as Lanes>::Real; 3];

/// Eight rays, of which those in `mask` are traced.
#[derive(Clone, Copy)]
pub(crate) struct Packet<L: Lanes> {
    pub(crate) origin: Vector<L::Real>,
    /// Of unit length.
    pub(crate) direction: Vector<L::Real>,
    /// The lanes that hold a ray.
    pub(crate) mask: u8,
    /// The lanes that carry each channel.
    pub(crate) channels: [u8; 3],
    /// Which packet of the block's pixels its lanes belong to.
    pub(crate) place: usize,
    /// The body that each ray starts on; [`NOTHING`] for a primary ray.
    pub(crate) start: [u32; 8],
    /// The stack of media that each ray carries: a number of [`super::media::Stacks`].
    pub(crate) media: [u32; 8],
}

impl<L: Lanes> Packet<L> {
    /// No rays.
    #[inline(always)]
    pub(crate) fn none() -> Packet<L> {
        let zero = Vector::splat(DVec3::ZERO);
        let (start, media) = ([NOTHING; 8], [0; 8]);
        Packet { origin: zero, direction: zero, mask: 0, channels: [0; 3], place: 0, start, media }
    }
}

/// Rays of one kind and level.
#[derive(Clone)]
pub(crate) struct Block<L: Lanes> {
    pub(crate) kind: RayKind,
    pub(crate) level: u32,
    /// Whether all rays start at one point.
    pub(crate) from_one_point: bool,
    pub(crate) packets: PerPacket<Packet<L>>,
}

impl<L: Lanes> Block<L> {
    /// A block without rays.
    #[inline(always)]
    pub(crate) fn new(kind: RayKind, level: u32, from_one_point: bool) -> Block<L> {
        Block { kind, level, from_one_point, packets: PerPacket::new() }
    }

    /// The point where all rays start, if that is one.
    #[inline(always)]
    pub(crate) fn eye(&self) -> Option<Vector<L::Real>> {
        if !self.from_one_point {
            return None;
        }
        for packet in &self.packets {
            if packet.mask != 0 {
                return Some(Vector::splat(packet.origin.lane(packet.mask.trailing_zeros() as usize)));
            }
        }
        None
    }
}

/// What the rays of a packet meet first.
#[derive(Clone, Copy)]
pub(crate) struct Hits<L: Lanes> {
    /// The distance, infinite where nothing is met.
    pub(crate) t: L::Real,
    /// The shares of `P0P1` and `P0P2`, of facets.
    pub(crate) alpha: L::Real,
    pub(crate) beta: L::Real,
    /// The body, [`NOTHING`] where nothing is met.
    pub(crate) body: [u32; 8],
    /// The facet's number, 0 for a sphere and a plane.
    pub(crate) facet: [u32; 8],
}
