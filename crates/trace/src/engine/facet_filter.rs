//! What f32 can tell of a ray and a facet: that they miss each other, that they surely meet, or nothing; and between
//! which distances.
//!
//! The test is that of Möller and Trumbore (1997), seen from the ray's start: with `a` the corner `P0`, `e1 = P0P1` and
//! `e2 = P0P2`, `N = e1 × e2` and the direction `I`, `α·I·N = (a × I)·e2`, `β·I·N = -(a × I)·e1` and `t·I·N = a·N`. Twice
//! these volumes are the edge functions of the exact test, in real numbers.
//!
//! How far they may be off. Let `u = 2⁻²⁴`, `E` the greatest coordinate of the hierarchy, `R` that and the greatest one of
//! the start together, `D` the greatest component of `I`, `s` that of `e1` and `e2`. A start is off by `4uR` from the
//! corners, the way to the hierarchy's space counted in, an edge by `2uE`, `I` by `uD`.
//!
//! * Volumes of edges. The start brings `4uR·2Ds·3 = 24uRDs`; `I` brings `6uRDs`; an edge, where the ray passes no farther
//!   than `s` from the facet, which is so for what meets it in either arithmetic, `12uRDs`; roundings bring `30uRDs`. So
//!   they are off by `72uRDs`, which is less than `80uRDs`. `N` is off by `8uEs + 8us²`, `I·N` so by `66uRDs`; the volume
//!   of the third edge, where it is taken as `I·N` less the two others, by `230uRDs`, which is less than `256uRDs`.
//! * The distance. Seen from where the ray meets the facet, errors do not grow with the distance to the start: `t·I·N` and
//!   `a·N` differ by `3s·8uEs` for the direction of `N`; by `5uR·|N|` for the places of corner and ray, where `|N|` is the
//!   sum of its components; and for roundings by `6u·|N|` times the way to the facet, along some axis.
//!
//! All sizes are taken greater by `4uR`, what the f32 corners may be off, and all bounds by a fifth at least. What double
//! precision adds is less by 2⁻²⁴ and lost in that.

use super::lanes::{Lanes, Mask, Single};
use super::vector::dot;
use crate::bvh::{Block, Shadow};

/// `80u`, and its share of `256u`.
const EDGE: f32 = 5.0 / 1_048_576.0;
const THIRD: f32 = 5.0 / 16.0;
/// `32u` and `8u`.
const TURNED: f32 = 1.0 / 524_288.0;
const ROUNDED: f32 = 1.0 / 2_097_152.0;
/// `8uR` of what boxes are wider by, which is `4uR`.
const MOVED: f32 = 2.0;
/// What is less than this may have been lost below the least number.
const LEAST: f32 = 16.0 * f32::MIN_POSITIVE;
/// Covers the roundings of a quotient.
const LESS: f32 = 1.0 - 1.0 / 2_097_152.0;
const MORE: f32 = 1.0 + 1.0 / 2_097_152.0;

/// So many rays of a packet had better try eight facets at a time than all together one facet.
pub(super) const FEW_RAYS: u32 = 3;

/// What a ray may meet of eight facets, or eight rays of one.
pub(super) struct Sighted<L: Lanes> {
    /// Those that may meet, and those of them that surely do.
    pub(super) may: u8,
    pub(super) sure: u8,
    /// Where it is if they do meet, at least and at most.
    pub(super) low: L::Single,
    pub(super) high: L::Single,
}

/// Rays as the filter sees them, by axis, then by lane.
#[derive(Clone, Copy)]
pub(super) struct Looking {
    origin: [[f32; 8]; 3],
    direction: [[f32; 8]; 3],
    /// `80uRD`, `4uR`, `8uR` and `32uE`.
    edge: [f32; 8],
    wider: [f32; 8],
    moved: [f32; 8],
    turned: f32,
}

/// One of them in all lanes.
struct Ray<L: Lanes> {
    origin: [L::Single; 3],
    direction: [L::Single; 3],
    edge: L::Single,
    wider: L::Single,
    moved: L::Single,
    turned: L::Single,
}

impl Looking {
    /// No rays.
    pub(super) const NONE: Looking = Looking {
        origin: [[0.0; 8]; 3],
        direction: [[0.0; 8]; 3],
        edge: [0.0; 8],
        wider: [0.0; 8],
        moved: [0.0; 8],
        turned: 0.0,
    };

    /// The rays of a packet.
    #[inline(always)]
    pub(super) fn of<L: Lanes>(rays: &Shadow<L>, extent: f32) -> Looking {
        let [ox, oy, oz] = rays.origin;
        let [dx, dy, dz] = rays.direction;
        Looking {
            origin: [ox.store(), oy.store(), oz.store()],
            direction: [dx.store(), dy.store(), dz.store()],
            edge: (rays.spread * L::Single::splat(EDGE)).store(),
            wider: rays.wider.store(),
            moved: (rays.wider * L::Single::splat(MOVED)).store(),
            turned: extent * TURNED,
        }
    }

    #[inline(always)]
    fn ray<L: Lanes>(&self, lane: usize) -> Ray<L> {
        let ([ox, oy, oz], [dx, dy, dz]) = (&self.origin, &self.direction);
        Ray {
            origin: [L::Single::splat(ox[lane]), L::Single::splat(oy[lane]), L::Single::splat(oz[lane])],
            direction: [L::Single::splat(dx[lane]), L::Single::splat(dy[lane]), L::Single::splat(dz[lane])],
            edge: L::Single::splat(self.edge[lane]),
            wider: L::Single::splat(self.wider[lane]),
            moved: L::Single::splat(self.moved[lane]),
            turned: L::Single::splat(self.turned),
        }
    }

    /// What the ray of a lane sees of the facets of one or two blocks before `limit`.
    #[inline(always)]
    pub(super) fn at_facets<L: Lanes>(&self, lane: usize, blocks: &[Block], limit: f32) -> Sighted<L> {
        let ray = self.ray::<L>(lane);
        let [a, _, e1, e2, _] = edges::<L>(blocks, ray.origin);
        // one block stands twice
        let mask = if blocks.len() == 1 { 0x0f } else { 0xff };
        ray.at([a, e1, e2], mask, L::Single::splat(limit))
    }

    /// What the rays see of one facet of a block before their limits.
    #[inline(always)]
    pub(super) fn at_facet<L: Lanes>(&self, mask: u8, block: &Block, facet: usize, limit: L::Single) -> Sighted<L> {
        let ([ox, oy, oz], [dx, dy, dz]) = (&self.origin, &self.direction);
        let ray = Ray::<L> {
            origin: [L::Single::load(ox), L::Single::load(oy), L::Single::load(oz)],
            direction: [L::Single::load(dx), L::Single::load(dy), L::Single::load(dz)],
            edge: L::Single::load(&self.edge),
            wider: L::Single::load(&self.wider),
            moved: L::Single::load(&self.moved),
            turned: L::Single::splat(self.turned),
        };
        ray.at_one(mask, block, facet, limit)
    }
}

impl<L: Lanes> Ray<L> {
    #[inline(always)]
    fn at_one(&self, mask: u8, block: &Block, facet: usize, limit: L::Single) -> Sighted<L> {
        let zero = [L::Single::splat(0.0); 3];
        let (mut a, mut e1, mut e2) = (zero, zero, zero);
        for axis in 0..3 {
            let p0 = L::Single::splat(block.corners[0][axis][facet]);
            a[axis] = p0 - self.origin[axis];
            e1[axis] = L::Single::splat(block.corners[1][axis][facet]) - p0;
            e2[axis] = L::Single::splat(block.corners[2][axis][facet]) - p0;
        }
        self.at([a, e1, e2], mask, limit)
    }

    #[inline(always)]
    fn at(&self, [a, e1, e2]: [[L::Single; 3]; 3], mask: u8, limit: L::Single) -> Sighted<L> {
        let side = cross::<L>(&a, &self.direction);
        let normal = cross::<L>(&e1, &e2);
        let (alpha, beta) = (dot::<L>(&side, &e2), -dot::<L>(&side, &e1));
        let whole = dot::<L>(&self.direction, &normal);
        // as exact as the others, for one test of all
        let rest = (whole - alpha - beta) * L::Single::splat(THIRD);
        let size = greatest::<L>(&e1).max(greatest::<L>(&e2)) + self.wider;
        let along = off::<L>(&a, &normal, size, self.moved, self.turned);
        let ahead = dot::<L>(&a, &normal);
        Volumes { alpha, beta, rest, whole, ahead, edge: self.edge * size, along }.sight::<false>(mask, limit)
    }
}

/// The volumes that a ray spans with a facet, and how far they may be off.
struct Volumes<L: Lanes> {
    alpha: L::Single,
    beta: L::Single,
    rest: L::Single,
    whole: L::Single,
    /// `a·N`.
    ahead: L::Single,
    edge: L::Single,
    along: L::Single,
}

impl<L: Lanes> Volumes<L> {
    /// `EARLY`: asks first whether there is anything to look for, where that can be foretold.
    #[inline(always)]
    fn sight<const EARLY: bool>(self, mask: u8, limit: L::Single) -> Sighted<L> {
        let Volumes { alpha, beta, rest, whole, ahead, edge, along } = self;
        let (least, most) = (rest.min(alpha).min(beta), rest.max(alpha).max(beta));
        let inside = (least.ge(-edge) | most.le(edge)).bits() & mask;
        if EARLY && inside == 0 {
            return Sighted { may: 0, sure: 0, low: ahead, high: ahead };
        }
        // as if the facet were seen from its front
        let (amount, ahead) = (whole.abs(), ahead.flipped_by(whole));
        let in_reach =
            (ahead - along).le(limit * amount * L::Single::splat(MORE)) & (ahead + along).ge(L::Single::splat(0.0));
        let may = inside & (in_reach | amount.le(edge)).bits();
        if may == 0 {
            return Sighted { may, sure: 0, low: ahead, high: ahead };
        }
        let surely = least.gt(edge) | most.lt(-edge);
        let sure = (surely & ahead.gt(along * L::Single::splat(4.0))).bits() & may;
        let inverse = L::Single::splat(1.0) / amount;
        let low = (ahead - along) * inverse * L::Single::splat(LESS);
        let high = (ahead + along) * inverse * L::Single::splat(MORE);
        Sighted { may, sure, low, high }
    }
}

/// Packets of rays that all start at one point, and what its rounding costs.
pub(super) struct Eye {
    origin: [f32; 3],
    wider: f32,
    moved: f32,
    turned: f32,
}

impl Eye {
    /// The point that the rays of a packet start at; its mask is not empty.
    #[inline(always)]
    pub(super) fn of<L: Lanes>(rays: &Shadow<L>, extent: f32) -> Eye {
        let lane = rays.mask.trailing_zeros() as usize % 8;
        let [x, y, z] = rays.origin;
        let wider = rays.wider.store()[lane];
        let origin = [x.store()[lane], y.store()[lane], z.store()[lane]];
        Eye { origin, wider, moved: wider * MOVED, turned: extent * TURNED }
    }
}

/// The directions of a packet's rays: the middle and how far they are from it along each axis.
#[derive(Clone, Copy)]
pub(super) struct Fan {
    middle: [f32; 3],
    half: [f32; 3],
    edge: f32,
}

impl Fan {
    /// No directions.
    pub(super) const NONE: Fan = Fan { middle: [0.0; 3], half: [0.0; 3], edge: 0.0 };

    /// The directions of the rays of a packet.
    #[inline(always)]
    pub(super) fn of<L: Lanes>(rays: &Shadow<L>) -> Fan {
        let mut fan = Fan::NONE;
        let mask = L::SingleMask::from_bits(rays.mask);
        for axis in 0..3 {
            let along = rays.direction[axis];
            let low = L::Single::select(mask, along, L::Single::splat(f32::INFINITY)).least();
            let high = L::Single::select(mask, along, L::Single::splat(f32::NEG_INFINITY)).greatest();
            fan.middle[axis] = 0.5 * (low + high);
            // the middle is rounded
            fan.half[axis] = 0.5 * (high - low) + (low.abs() + high.abs()) * f32::EPSILON;
        }
        fan.edge = L::Single::select(mask, rays.spread, L::Single::splat(0.0)).greatest() * (2.0 * EDGE);
        fan
    }
}

/// Up to eight facets as all rays from one point see them, by axis, then by facet: volumes are scalar products of these
/// with a ray's direction.
pub(super) struct Seen {
    alpha: [[f32; 8]; 3],
    beta: [[f32; 8]; 3],
    rest: [[f32; 8]; 3],
    whole: [[f32; 8]; 3],
    ahead: [f32; 8],
    size: [f32; 8],
    along: [f32; 8],
}

impl Seen {
    /// The facets of one or two blocks.
    #[inline(always)]
    pub(super) fn of<L: Lanes>(eye: &Eye, blocks: &[Block]) -> Seen {
        let [x, y, z] = eye.origin;
        let origin = [L::Single::splat(x), L::Single::splat(y), L::Single::splat(z)];
        let [a, b, e1, e2, e3] = edges::<L>(blocks, origin);
        let ([ax, ay, az], [bx, by, bz]) = (cross::<L>(&e2, &a), cross::<L>(&a, &e1));
        let (normal, [cx, cy, cz]) = (cross::<L>(&e1, &e2), cross::<L>(&b, &e3));
        let size = greatest::<L>(&e1).max(greatest::<L>(&e2)) + L::Single::splat(eye.wider);
        let along = off::<L>(&a, &normal, size, L::Single::splat(eye.moved), L::Single::splat(eye.turned));
        Seen {
            alpha: [ax.store(), ay.store(), az.store()],
            beta: [bx.store(), by.store(), bz.store()],
            rest: [cx.store(), cy.store(), cz.store()],
            whole: [normal[0].store(), normal[1].store(), normal[2].store()],
            ahead: dot::<L>(&a, &normal).store(),
            size: size.store(),
            along: along.store(),
        }
    }

    /// The facets that some ray of a fan may meet.
    #[inline(always)]
    pub(super) fn within<L: Lanes>(&self, fan: &Fan) -> u8 {
        let (alpha, beta) = (span::<L>(&self.alpha, fan), span::<L>(&self.beta, fan));
        let rest = span::<L>(&self.rest, fan);
        let edge = L::Single::load(&self.size) * L::Single::splat(fan.edge);
        let positive = alpha.1.min(beta.1).min(rest.1).ge(-edge);
        let negative = alpha.0.max(beta.0).max(rest.0).le(edge);
        (positive | negative).bits()
    }

    /// What the rays of a packet see of one of the facets before their limits.
    #[inline(always)]
    pub(super) fn by<L: Lanes>(&self, rays: &Shadow<L>, facet: usize, limit: L::Single) -> Sighted<L> {
        let volume = Volumes::<L> {
            alpha: dot::<L>(&rays.direction, &one::<L>(&self.alpha, facet)),
            beta: dot::<L>(&rays.direction, &one::<L>(&self.beta, facet)),
            rest: dot::<L>(&rays.direction, &one::<L>(&self.rest, facet)),
            whole: dot::<L>(&rays.direction, &one::<L>(&self.whole, facet)),
            ahead: L::Single::splat(self.ahead[facet]),
            edge: rays.spread * L::Single::splat(self.size[facet] * EDGE),
            along: L::Single::splat(self.along[facet]),
        };
        volume.sight::<true>(rays.mask, limit)
    }
}

impl Seen {
    /// What the rays of a packet see of one of the facets before something at a distance. Only that is sure which is as
    /// surely before it, and as far from being at its place, as it is from the start.
    #[inline(always)]
    pub(super) fn before<L: Lanes>(&self, rays: &Shadow<L>, facet: usize, distance: L::Single) -> Sighted<L> {
        let mut sighted = self.by(rays, facet, distance * L::Single::splat(MORE));
        if sighted.sure == 0 {
            return sighted;
        }
        let whole = dot::<L>(&rays.direction, &one::<L>(&self.whole, facet));
        let ahead = L::Single::splat(self.ahead[facet]).flipped_by(whole);
        let before = ahead + L::Single::splat(4.0 * self.along[facet]);
        sighted.sure &= before.lt(distance * whole.abs() * L::Single::splat(LESS)).bits();
        sighted
    }
}

/// What the rays of a packet, wherever they start, see of one facet of a block before their limits.
#[inline(always)]
pub(super) fn sight<L: Lanes>(
    rays: &Shadow<L>,
    extent: f32,
    block: &Block,
    facet: usize,
    limit: L::Single,
) -> Sighted<L> {
    let ray = Ray::<L> {
        origin: rays.origin,
        direction: rays.direction,
        edge: rays.spread * L::Single::splat(EDGE),
        wider: rays.wider,
        moved: rays.wider * L::Single::splat(MOVED),
        turned: L::Single::splat(extent * TURNED),
    };
    ray.at_one(rays.mask, block, facet, limit)
}

/// The corners `P0` and `P1` of facets seen from a point, and `P0P1`, `P0P2` and `P1P2`.
#[inline(always)]
fn edges<L: Lanes>(blocks: &[Block], origin: [L::Single; 3]) -> [[L::Single; 3]; 5] {
    let (low, high) = (&blocks[0].corners, &blocks[blocks.len() - 1].corners);
    let mut edges = [[L::Single::splat(0.0); 3]; 5];
    for axis in 0..3 {
        let p0 = L::Single::of_halves(&low[0][axis], &high[0][axis]);
        let p1 = L::Single::of_halves(&low[1][axis], &high[1][axis]);
        let p2 = L::Single::of_halves(&low[2][axis], &high[2][axis]);
        edges[0][axis] = p0 - origin[axis];
        edges[1][axis] = p1 - origin[axis];
        edges[2][axis] = p1 - p0;
        edges[3][axis] = p2 - p0;
        edges[4][axis] = p2 - p1;
    }
    edges
}

/// How far a distance along a ray, times the whole volume, may be off.
#[inline(always)]
fn off<L: Lanes>(
    a: &[L::Single; 3],
    normal: &[L::Single; 3],
    size: L::Single,
    moved: L::Single,
    turned: L::Single,
) -> L::Single {
    let sum = normal[0].abs() + normal[1].abs() + normal[2].abs();
    let moved = (greatest::<L>(a) + size).mul_add(L::Single::splat(ROUNDED), moved);
    (size * size).mul_add(turned, sum.mul_add(moved, L::Single::splat(LEAST)))
}

/// The least and the greatest scalar product of a fan's directions with each of eight vectors.
#[inline(always)]
fn span<L: Lanes>(vectors: &[[f32; 8]; 3], fan: &Fan) -> (L::Single, L::Single) {
    let (mut middle, mut half) = (L::Single::splat(0.0), L::Single::splat(0.0));
    for axis in 0..3 {
        let along = L::Single::load(&vectors[axis]);
        middle = along.mul_add(L::Single::splat(fan.middle[axis]), middle);
        half = along.abs().mul_add(L::Single::splat(fan.half[axis]), half);
    }
    (middle - half, middle + half)
}

/// One vector of eight, in all lanes.
#[inline(always)]
fn one<L: Lanes>([x, y, z]: &[[f32; 8]; 3], place: usize) -> [L::Single; 3] {
    [L::Single::splat(x[place]), L::Single::splat(y[place]), L::Single::splat(z[place])]
}

/// `a × b`.
#[inline(always)]
fn cross<L: Lanes>(a: &[L::Single; 3], b: &[L::Single; 3]) -> [L::Single; 3] {
    [a[1].mul_sub(b[2], a[2] * b[1]), a[2].mul_sub(b[0], a[0] * b[2]), a[0].mul_sub(b[1], a[1] * b[0])]
}

/// The greatest of the absolute coordinates.
#[inline(always)]
fn greatest<L: Lanes>(a: &[L::Single; 3]) -> L::Single {
    a[0].abs().max(a[1].abs()).max(a[2].abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bvh::{Bvh, Start, Triangles};
    use crate::engine::lanes::Portable;
    use crate::engine::vector::Vector;
    use crate::reference::intersect::intersect_facet;
    use glam::DVec3;
    use proptest::prelude::*;

    fn point(size: f64) -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-size..size).prop_map(DVec3::from)
    }

    /// A facet of some size at some distance, a start, and what the ray aims at: anything from within the facet to
    /// somewhere beside it, as shares of its edges.
    fn meeting() -> impl Strategy<Value = ([DVec3; 3], DVec3, (f64, f64))> {
        let facet = (point(1.0), point(1.0), point(1.0), -6.0..0.0_f64, point(1.0));
        let share = || prop_oneof![-0.1..1.1_f64, Just(0.0), Just(0.5), Just(1.0), -1e-5..1e-5_f64];
        let near =
            prop_oneof![point(10.0), (point(1.0), -6.0..0.0_f64).prop_map(|(way, size)| way * 10_f64.powf(size))];
        (facet, near, (share(), share())).prop_map(|((a, b, c, size, center), start, shares)| {
            let corners = [a, b, c].map(|corner| center + corner * 10_f64.powf(size));
            (corners, start + if start.length() < 1.0 { corners[0] } else { DVec3::ZERO }, shares)
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 20_000, ..ProptestConfig::default() })]

        /// What double precision meets is never left out and lies between the bounds; what is sure is so.
        #[test]
        fn the_filter_knows_what_it_knows((corners, origin, (alpha, beta)) in meeting()) {
            let [p0, p1, p2] = corners;
            let target = p0 + (p1 - p0) * alpha + (p2 - p0) * beta;
            let direction = (target - origin).normalize();
            prop_assume!(direction.is_finite());
            let hit = intersect_facet(&crate::Ray { origin, direction }, p0, p1, p2);
            // another facet makes the hierarchy greater than this one
            let positions = [p0, p1, p2, DVec3::splat(-1.0), DVec3::splat(-1.0) + DVec3::X, DVec3::splat(1.0)];
            let (bvh, blocks) = Bvh::over(&Triangles { positions: &positions, facets: &[[0, 1, 2], [3, 4, 5]] });
            let lane = blocks[0].facets.iter().position(|&facet| facet == 0).unwrap();
            let start = Start::<Portable>::new(&bvh, bvh.margin(), Vector::splat(origin), Vector::splat(origin));
            let (rays, extent) = (&Shadow::new(&start, Vector::splat(direction), 0xff), bvh.extent());
            let most = <Portable as Lanes>::Single::splat(f32::INFINITY);
            let eye = Eye::of(rays, extent);
            let seen = Seen::of::<Portable>(&eye, &blocks);
            let within = seen.within::<Portable>(&Fan::of(rays)) >> lane & 1;
            let from_one = Looking::of(rays, extent).at_facets::<Portable>(0, &blocks, f32::INFINITY);
            for (name, sighted, place) in [
                ("single", from_one, lane),
                ("packet", sight(rays, extent, &blocks[0], lane, most), 0),
                ("from one point", seen.by(rays, lane, most), 0),
            ] {
                let (low, high) = (sighted.low.store()[place], sighted.high.store()[place]);
                let (may, sure) = (sighted.may >> place & 1 == 1, sighted.sure >> place & 1 == 1);
                if let Some(hit) = hit {
                    prop_assert!(may, "{name} leaves out {hit:?}");
                    let between = f64::from(low) <= hit.t && hit.t <= f64::from(high);
                    prop_assert!(!sure || between, "{name}: {} is not between {low} and {high}", hit.t);
                }
                prop_assert!(!sure || hit.is_some(), "{name} is sure of nothing");
            }
            prop_assert!(hit.is_none() || within == 1, "the fan leaves out {hit:?}");
        }
    }
}
