//! Every operation of every backend against scalar arithmetic, bit for bit, on all kinds of numbers.

use super::{Lanes, Mask, Portable, Real, Single};
use proptest::prelude::*;
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

/// Something to compute on a backend; `run` must be `#[inline(always)]`.
pub(crate) trait Kernel {
    type Output;
    fn run<L: Lanes>(&self) -> Self::Output;
}

/// What a kernel gives on each backend that this machine has.
pub(crate) fn on_every_backend<K: Kernel>(kernel: &K) -> Vec<(&'static str, K::Output)> {
    #[cfg(target_arch = "x86_64")]
    let others = [("avx2", super::avx2::run(kernel)), ("avx512", super::avx512::run(kernel))];
    #[cfg(not(target_arch = "x86_64"))]
    let others: [(&'static str, Option<K::Output>); 0] = [];
    let portable = ("portable", kernel.run::<Portable>());
    let present = others.into_iter().filter_map(|(backend, output)| Some((backend, output?)));
    std::iter::once(portable).chain(present).collect()
}

#[derive(Clone, Debug)]
struct Operands {
    a: [f64; 8],
    b: [f64; 8],
    k: [f64; 8],
    p: [f32; 8],
    q: [f32; 8],
    r: [f32; 8],
    left: u8,
    right: u8,
}

impl Operands {
    /// Small numbers, of which some are equal.
    fn numbers(&self) -> [u32; 8] {
        self.p.map(|p| p.to_bits() % 3)
    }
}

/// The operations' names and the bits of their lanes; every NaN has the same.
type Results = Vec<(&'static str, [u64; 8])>;

fn real_bits(lanes: [f64; 8]) -> [u64; 8] {
    lanes.map(|lane| if lane.is_nan() { u64::MAX } else { lane.to_bits() })
}

fn single_bits(lanes: [f32; 8]) -> [u64; 8] {
    lanes.map(|lane| if lane.is_nan() { u64::MAX } else { u64::from(lane.to_bits()) })
}

fn truth_bits(bits: u8) -> [u64; 8] {
    std::array::from_fn(|lane| u64::from((bits >> lane) & 1))
}

/// Every operation but the multiply-adds, which have two right answers.
impl Kernel for Operands {
    type Output = Results;

    #[inline(always)]
    fn run<L: Lanes>(&self) -> Results {
        let mut results = reals::<L>(self);
        results.extend(singles::<L>(self));
        results
    }
}

#[inline(always)]
fn reals<L: Lanes>(operands: &Operands) -> Results {
    let (a, b, k) = (L::Real::load(&operands.a), L::Real::load(&operands.b), L::Real::load(&operands.k));
    let (left, right) = (L::Mask::from_bits(operands.left), L::Mask::from_bits(operands.right));
    let real = |value: L::Real| real_bits(value.store());
    let truth = |mask: L::Mask| truth_bits(mask.bits());
    let (m, e) = a.split_exponent();
    vec![
        ("splat", real(L::Real::splat(operands.a[0]))),
        ("load", real(a)),
        ("a + b", real(a + b)),
        ("a - b", real(a - b)),
        ("a * b", real(a * b)),
        ("a / b", real(a / b)),
        ("-a", real(-a)),
        ("sqrt", real(a.sqrt())),
        ("abs", real(a.abs())),
        ("min", real(a.min(b))),
        ("max", real(a.max(b))),
        ("lt", truth(a.lt(b))),
        ("le", truth(a.le(b))),
        ("gt", truth(a.gt(b))),
        ("ge", truth(a.ge(b))),
        ("eq", truth(a.eq(b))),
        ("select", real(L::Real::select(left, a, b))),
        ("select by comparison", real(L::Real::select(a.lt(b), a, b))),
        ("mantissa", real(m)),
        ("exponent", real(e)),
        ("scale", real(a.scale_exponent(k))),
        ("round", real(a.round())),
        ("narrow", single_bits(L::narrow(a).store())),
        ("and", truth(left & right)),
        ("or", truth(left | right)),
        ("not", truth(!left)),
        ("equal", truth_bits(L::equal(&operands.numbers(), operands.numbers()[3]))),
    ]
}

#[inline(always)]
fn singles<L: Lanes>(operands: &Operands) -> Results {
    let (p, q) = (L::Single::load(&operands.p), L::Single::load(&operands.q));
    let (left, right) = (L::SingleMask::from_bits(operands.left), L::SingleMask::from_bits(operands.right));
    let single = |value: L::Single| single_bits(value.store());
    let truth = |mask: L::SingleMask| truth_bits(mask.bits());
    let [low, high] = [&operands.p[..4], &operands.q[4..]].map(|half| <&[f32; 4]>::try_from(half).unwrap());
    vec![
        ("f32 splat", single(L::Single::splat(operands.p[0]))),
        ("f32 load", single(p)),
        ("f32 of_halves", single(L::Single::of_halves(low, high))),
        ("f32 p + q", single(p + q)),
        ("f32 p - q", single(p - q)),
        ("f32 p * q", single(p * q)),
        ("f32 p / q", single(p / q)),
        ("f32 -p", single(-p)),
        ("f32 abs", single(p.abs())),
        ("f32 flipped_by", single(p.flipped_by(q))),
        ("f32 min", single(p.min(q))),
        ("f32 max", single(p.max(q))),
        ("f32 lt", truth(p.lt(q))),
        ("f32 le", truth(p.le(q))),
        ("f32 gt", truth(p.gt(q))),
        ("f32 ge", truth(p.ge(q))),
        ("f32 select", single(L::Single::select(left, p, q))),
        ("f32 select by comparison", single(L::Single::select(p.lt(q), p, q))),
        ("f32 and", truth(left & right)),
        ("f32 or", truth(left | right)),
        ("f32 not", truth(!left)),
        ("f32 least", single_bits([p.least(); 8])),
        ("f32 greatest", single_bits([p.greatest(); 8])),
    ]
}

/// The same by scalar arithmetic.
fn expected(operands: &Operands) -> Results {
    let Operands { a, b, k, p, q, left, right, .. } = operands;
    let lanes = |of: &dyn Fn(usize) -> f64| real_bits(std::array::from_fn(of));
    let truths = |of: &dyn Fn(usize) -> bool| std::array::from_fn(|lane| u64::from(of(lane)));
    let single = |of: &dyn Fn(usize) -> f32| single_bits(std::array::from_fn(of));
    let bit = |bits: u8, lane: usize| bits & (1 << lane) != 0;
    let [p_numbers, q_numbers] = [p, q];
    let least = |of: fn(f32, f32) -> f32| {
        let four: Vec<f32> = (0..4).map(|lane| of(p[lane], p[lane + 4])).collect();
        of(of(four[0], four[2]), of(four[1], four[3]))
    };
    vec![
        ("splat", lanes(&|_| a[0])),
        ("load", lanes(&|i| a[i])),
        ("a + b", lanes(&|i| a[i] + b[i])),
        ("a - b", lanes(&|i| a[i] - b[i])),
        ("a * b", lanes(&|i| a[i] * b[i])),
        ("a / b", lanes(&|i| a[i] / b[i])),
        ("-a", lanes(&|i| -a[i])),
        ("sqrt", lanes(&|i| a[i].sqrt())),
        ("abs", lanes(&|i| a[i].abs())),
        ("min", lanes(&|i| if a[i] < b[i] { a[i] } else { b[i] })),
        ("max", lanes(&|i| if a[i] > b[i] { a[i] } else { b[i] })),
        ("lt", truths(&|i| a[i] < b[i])),
        ("le", truths(&|i| a[i] <= b[i])),
        ("gt", truths(&|i| a[i] > b[i])),
        ("ge", truths(&|i| a[i] >= b[i])),
        ("eq", truths(&|i| a[i] == b[i])),
        ("select", lanes(&|i| if bit(*left, i) { a[i] } else { b[i] })),
        ("select by comparison", lanes(&|i| if a[i] < b[i] { a[i] } else { b[i] })),
        ("mantissa", lanes(&|i| split(a[i]).0)),
        ("exponent", lanes(&|i| split(a[i]).1)),
        ("scale", lanes(&|i| scaled(a[i], k[i]))),
        ("round", lanes(&|i| a[i].round_ties_even())),
        ("narrow", single(&|i| a[i] as f32)),
        ("and", truths(&|i| bit(left & right, i))),
        ("or", truths(&|i| bit(left | right, i))),
        ("not", truths(&|i| !bit(*left, i))),
        ("equal", truths(&|i| operands.numbers()[i] == operands.numbers()[3])),
        ("f32 splat", single(&|_| p[0])),
        ("f32 load", single(&|i| p[i])),
        ("f32 of_halves", single(&|i| if i < 4 { p_numbers[i] } else { q_numbers[i] })),
        ("f32 p + q", single(&|i| p[i] + q[i])),
        ("f32 p - q", single(&|i| p[i] - q[i])),
        ("f32 p * q", single(&|i| p[i] * q[i])),
        ("f32 p / q", single(&|i| p[i] / q[i])),
        ("f32 -p", single(&|i| -p[i])),
        ("f32 abs", single(&|i| p[i].abs())),
        ("f32 flipped_by", single(&|i| if q[i].is_sign_negative() { -p[i] } else { p[i] })),
        ("f32 min", single(&|i| if p[i] < q[i] { p[i] } else { q[i] })),
        ("f32 max", single(&|i| if p[i] > q[i] { p[i] } else { q[i] })),
        ("f32 lt", truths(&|i| p[i] < q[i])),
        ("f32 le", truths(&|i| p[i] <= q[i])),
        ("f32 gt", truths(&|i| p[i] > q[i])),
        ("f32 ge", truths(&|i| p[i] >= q[i])),
        ("f32 select", single(&|i| if bit(*left, i) { p[i] } else { q[i] })),
        ("f32 select by comparison", single(&|i| if p[i] < q[i] { p[i] } else { q[i] })),
        ("f32 and", truths(&|i| bit(left & right, i))),
        ("f32 or", truths(&|i| bit(left | right, i))),
        ("f32 not", truths(&|i| !bit(*left, i))),
        ("f32 least", single(&|_| least(|a, b| if a < b { a } else { b }))),
        ("f32 greatest", single(&|_| least(|a, b| if a > b { a } else { b }))),
    ]
}

/// By the portable lanes where `x` is not positive and finite: what those give has no meaning, but must be the same.
fn split(x: f64) -> (f64, f64) {
    if x > 0.0 && x.is_finite() {
        let (half, exponent) = libm::frexp(x);
        if half < FRAC_1_SQRT_2 { (half * 2.0, f64::from(exponent - 1)) } else { (half, f64::from(exponent)) }
    } else {
        let (m, e) = <Portable as Lanes>::Real::splat(x).split_exponent();
        (m.store()[0], e.store()[0])
    }
}

fn scaled(x: f64, k: f64) -> f64 {
    if k > -1023.0 { libm::ldexp(x, k.min(1023.0) as i32) } else { x * 0.0 }
}

/// The fused and the unfused multiply-adds.
struct MultiplyAdd<'a>(&'a Operands);

impl Kernel for MultiplyAdd<'_> {
    type Output = [[u64; 8]; 2];

    #[inline(always)]
    fn run<L: Lanes>(&self) -> [[u64; 8]; 2] {
        let [p, q, r] = [self.0.p, self.0.q, self.0.r].map(|lanes| L::Single::load(&lanes));
        [p.mul_add(q, r), p.mul_sub(q, r)].map(|value| single_bits(value.store()))
    }
}

/// All kinds of numbers: those that differ little or are halves, those on the edges, any bits at all.
fn real() -> impl Strategy<Value = f64> {
    let edges = [
        0.0,
        1.0,
        f64::INFINITY,
        f64::NAN,
        f64::MIN_POSITIVE,
        f64::MIN_POSITIVE.next_down(),
        f64::MAX,
        5e-324,
        FRAC_1_SQRT_2,
        FRAC_1_SQRT_2.next_down(),
        SQRT_2,
        SQRT_2.next_up(),
        (1_u64 << 52) as f64,
        ((1_u64 << 52) as f64).next_down(),
        ((1_u64 << 51) as f64) + 0.5,
        f64::from(f32::MAX).next_up(),
        f64::from(f32::MIN_POSITIVE) / 3.0,
        0.5_f64.next_down(),
    ];
    let edge = (0..edges.len(), any::<bool>()).prop_map(move |(i, minus)| if minus { -edges[i] } else { edges[i] });
    prop_oneof![
        3 => -4.0..4.0,
        2 => (-20_i32..20).prop_map(|halves| f64::from(halves) / 2.0),
        2 => (-40_i32..40, 0.5..2.0).prop_map(|(exponent, m)| libm::ldexp(m, exponent)),
        3 => edge,
        3 => proptest::num::f64::ANY,
        1 => proptest::num::f64::SUBNORMAL,
    ]
}

fn single() -> impl Strategy<Value = f32> {
    prop_oneof![
        3 => -4.0..4.0_f32,
        1 => (-3_i8..3).prop_map(f32::from),
        1 => Just(-0.0_f32),
        2 => proptest::num::f32::ANY,
        1 => proptest::num::f32::SUBNORMAL,
    ]
}

fn operands() -> impl Strategy<Value = Operands> {
    let reals = || proptest::array::uniform8(real());
    let singles = || proptest::array::uniform8(single());
    let k = prop_oneof![
        8 => (-1100_i32..=1100).prop_map(f64::from),
        1 => real().prop_map(f64::round_ties_even),
    ];
    let k = proptest::array::uniform8(k);
    (reals(), reals(), k, singles(), singles(), singles(), any::<u8>(), any::<u8>())
        .prop_map(|(a, b, k, p, q, r, left, right)| Operands { a, b, k, p, q, r, left, right })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn every_operation_is_the_scalar_one(operands in operands()) {
        let expected = expected(&operands);
        for (backend, results) in on_every_backend(&operands) {
            prop_assert_eq!(results.len(), expected.len());
            for (result, expected) in results.iter().zip(&expected) {
                prop_assert_eq!(result, expected, "{}", backend);
            }
        }
    }

    #[test]
    fn multiply_adds_are_rounded_once_or_twice(operands in operands()) {
        let Operands { p, q, r, .. } = &operands;
        let of = |f: &dyn Fn(usize) -> f32| single_bits(std::array::from_fn(f));
        let fused = [of(&|i| p[i].mul_add(q[i], r[i])), of(&|i| p[i].mul_add(q[i], -r[i]))];
        let twice = [of(&|i| p[i] * q[i] + r[i]), of(&|i| p[i] * q[i] - r[i])];
        for (backend, results) in on_every_backend(&MultiplyAdd(&operands)) {
            prop_assert!(results == fused || results == twice, "{backend}: {results:x?}, not {fused:x?} or {twice:x?}");
        }
    }
}

#[test]
fn masks_keep_their_bits() {
    struct Bits;
    impl Kernel for Bits {
        type Output = Vec<(u8, u8)>;

        #[inline(always)]
        fn run<L: Lanes>(&self) -> Vec<(u8, u8)> {
            (0..=255).map(|bits| (L::Mask::from_bits(bits).bits(), L::SingleMask::from_bits(bits).bits())).collect()
        }
    }
    let all: Vec<(u8, u8)> = (0..=255).map(|bits| (bits, bits)).collect();
    for (backend, bits) in on_every_backend(&Bits) {
        assert_eq!(bits, all, "{backend}");
    }
}

/// Keys of which the lanes of a set are not negative.
struct Keys([f32; 8]);

impl Kernel for Keys {
    type Output = ([f32; 8], [[u32; 8]; 2], usize);

    #[inline(always)]
    fn run<L: Lanes>(&self) -> ([f32; 8], [[u32; 8]; 2], usize) {
        let [first, second] = [[10, 11, 12, 13, 14, 15, 16, 17], [30, 31, 32, 33, 34, 35, 36, 37]];
        L::greatest_first(L::Single::load(&self.0), [&first, &second])
    }
}

#[test]
fn lanes_are_sorted_by_their_keys() {
    for set in 0..=255_u8 {
        for turn in 0..16_u32 {
            // in many orders, some alike, one nothing
            let key =
                |lane: u32| if set >> lane & 1 == 1 { (lane * (turn | 1) % 8 * 37 % 24) as f32 * 0.3 } else { -1.0 };
            let keys: [f32; 8] = std::array::from_fn(|lane| key(lane as u32));
            let mut expected: Vec<(u32, u32)> = (0..8)
                .filter(|lane| set >> lane & 1 == 1)
                .map(|lane: u32| (keys[lane as usize].to_bits() & !7, 10 + lane))
                .collect();
            expected.sort_unstable_by(|a, b| b.cmp(a));
            for (backend, (sorted, [first, second], count)) in on_every_backend(&Keys(keys)) {
                assert_eq!(count, expected.len(), "{backend} {keys:?}");
                let got: Vec<(u32, u32)> = sorted.iter().map(|key| key.to_bits()).zip(first).take(count).collect();
                assert_eq!(got, expected, "{backend} {keys:?}");
                for lane in 0..count {
                    assert_eq!(second[lane], first[lane] + 20, "{backend} {keys:?}");
                }
            }
        }
    }
}
