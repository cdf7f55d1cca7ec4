//! `cosⁿ s` of the highlight over lanes: a power from IEEE additions, multiplications and one division in a fixed order.
//!
//! A library's `pow` differs from machine to machine in its last bits, and works on one number at a time. This one gives
//! equal bits on every backend. It is `2^(n·log₂ x)`, both functions as polynomials: `log₂ m` through the odd series in
//! `s = (m-1)/(m+1)` (that of fdlibm), `2^f` on `±½`; their coefficients interpolate at Chebyshev's nodes.

use super::lanes::Real;
use std::f64::consts::{LN_2, LOG2_E};

/// `(log₂((1+s)/(1-s))/s - 2/ln 2)/s²` in powers of `s²`, for `m = (1+s)/(1-s)` in `√½..√2`.
const LOGARITHM: [f64; 7] = [
    0.961796693925976,
    0.5770780163541355,
    0.412198583898078,
    0.32059873801756367,
    0.2623236397004895,
    0.221189987214124,
    0.21087079476015172,
];

/// `(2^f - 1)/f` in powers of `f`, for `f` in `-½..½`.
const EXPONENTIAL: [f64; 11] = [
    LN_2,
    0.24022650695910097,
    0.0555041086648216,
    0.009618129107606888,
    0.0013333558146416936,
    0.0001540353044173605,
    1.525273382983612e-5,
    1.321544258792169e-6,
    1.0178062445845774e-7,
    7.072585949269223e-9,
    4.4549605981865186e-10,
];

/// `base^exponent`, for a base in 0..=1, or above 1 by the roundings of a cosine, and an exponent in 0..=10000.
///
/// With `t = exponent·log₂ base` the relative error is at most `5·(|t| + 1)·2⁻⁵³`: 5.6e-14 for a result of 1e-30, 5.7e-13
/// for the smallest one, 2⁻¹⁰²². Below that the result is 0. It is exactly 1 for an exponent of 0 and for a base of 1, and
/// never more than 1 for a base that is not. Subnormal bases are bases like any other. A base of 0 counts as 2⁻¹⁰⁷⁷ or so,
/// NaN as some number: the caller has no highlight there.
///
/// The bound, in units of `u = 2⁻⁵³`, the greatest relative error of an operation:
///
/// * `s`: `m - 1` is exact (Sterbenz), so 2u from the sum and the division;
/// * `P = 2/ln 2 + s²·E(s²)`: the constant is right to 0.7u, the sum rounds once, the polynomial is right to 0.05u, and as
///   `s²·E` is at most 0.01 of `P`, the dozen roundings in it count for 0.14u: together 1.9u;
/// * `log₂ m = s·P`: 2u + 1.9u + 1u = 4.9u, and `e + log₂ m`, which is at least as large where `e` is not 0: 5.9u;
/// * `t`: 6.9u, an absolute error of 6.9u·|t|, which in `2^t` is a relative one of `6.9·ln 2·|t|` < 4.8u·|t|;
/// * `f = t - k` is exact; `Q(f)` of absolute error at most 4.4u, half of that in `f·Q`, which rounds by 0.42u more: against
///   `2^f` ≥ √½ that is 3.7u, the last sum 1u, the polynomial 0.2u: together 4.9u. `2^k` is exact.
#[inline(always)]
pub(crate) fn power<R: Real>(base: R, exponent: R) -> R {
    let t = exponent * log2(base);
    R::select(t.lt(R::splat(f64::from(f64::MIN_EXP - 1))), R::splat(0.0), exp2(t))
}

#[inline(always)]
fn log2<R: Real>(x: R) -> R {
    let (m, e) = x.split_exponent();
    let s = (m - R::splat(1.0)) / (m + R::splat(1.0));
    let z = s * s;
    let pair = |i| R::splat(LOGARITHM[i]) + R::splat(LOGARITHM[i + 1]) * z;
    let z2 = z * z;
    let polynomial = (pair(0) + pair(2) * z2) + (pair(4) + R::splat(LOGARITHM[6]) * z2) * (z2 * z2);
    e + s * (R::splat(2.0 * LOG2_E) + z * polynomial)
}

#[inline(always)]
fn exp2<R: Real>(t: R) -> R {
    let k = t.round();
    let f = t - k;
    let pair = |i| R::splat(EXPONENTIAL[i]) + R::splat(EXPONENTIAL[i + 1]) * f;
    let f2 = f * f;
    let f4 = f2 * f2;
    let low = (pair(0) + pair(2) * f2) + (pair(4) + pair(6) * f2) * f4;
    let high = pair(8) + R::splat(EXPONENTIAL[10]) * f2;
    (R::splat(1.0) + f * (low + high * (f4 * f4))).scale_exponent(k)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::lanes::agree::{Kernel, on_every_backend};
    use crate::engine::lanes::{Lanes, Portable};
    use proptest::prelude::*;

    const U: f64 = f64::EPSILON / 2.0;

    struct Power {
        base: [f64; 8],
        exponent: [f64; 8],
    }

    impl Kernel for Power {
        type Output = [f64; 8];

        #[inline(always)]
        fn run<L: Lanes>(&self) -> [f64; 8] {
            power(L::Real::load(&self.base), L::Real::load(&self.exponent)).store()
        }
    }

    fn one(base: f64, exponent: f64) -> f64 {
        Power { base: [base; 8], exponent: [exponent; 8] }.run::<Portable>()[0]
    }

    /// The stated bound, and what libm's own last bit may be off by.
    fn error_is_in_bounds(base: f64, exponent: f64, result: f64) -> Result<(), String> {
        let t = exponent * libm::log2(base);
        let truth = libm::pow(base, exponent);
        let bound = 5.0 * (t.abs() + 1.0) * U;
        let right = if t < -1022.0 - 1e-9 {
            result == 0.0
        } else if t < -1022.0 + 1e-9 {
            result == 0.0 || (result / truth - 1.0).abs() < 1e-12
        } else {
            (result - truth).abs() <= (bound + 2.0 * U) * truth
        };
        if right { Ok(()) } else { Err(format!("{base:e}^{exponent}: {result:e}, not {truth:e}")) }
    }

    fn base() -> impl Strategy<Value = f64> {
        prop_oneof![
            2 => 0.0..1.0_f64,
            // near 1, on both sides
            3 => (2_i32..53, 1.0..2.0).prop_map(|(k, m): (i32, f64)| 1.0 - libm::ldexp(m, -k)),
            1 => (1_u32..9).prop_map(|ulps| 1.0 + f64::from(ulps) * f64::EPSILON),
            // tiny, subnormal too
            2 => (-1073_i32..-2, 1.0..2.0).prop_map(|(k, m): (i32, f64)| libm::ldexp(m, k)),
            1 => Just(1.0),
        ]
        .prop_filter("a base is more than 0", |&base| base > 0.0)
    }

    fn exponent() -> impl Strategy<Value = f64> {
        prop_oneof![
            3 => 0.0..10_000.0,
            2 => (0_u32..=10_000).prop_map(f64::from),
            3 => 0.0..4.0,
            1 => Just(0.0),
            1 => Just(1.0),
            1 => Just(10_000.0),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2048))]

        #[test]
        fn the_error_is_within_its_bound_and_the_bits_are_the_same_everywhere(
            base in proptest::array::uniform8(base()), exponent in proptest::array::uniform8(exponent()),
        ) {
            let outputs = on_every_backend(&Power { base, exponent });
            for lane in 0..8 {
                let result = outputs[0].1[lane];
                prop_assert_eq!(error_is_in_bounds(base[lane], exponent[lane], result), Ok(()));
                if base[lane] <= 1.0 {
                    prop_assert!((0.0..=1.0).contains(&result), "{result}");
                }
            }
            for (backend, output) in &outputs {
                prop_assert_eq!(output.map(f64::to_bits), outputs[0].1.map(f64::to_bits), "{}", backend);
            }
        }
    }

    /// The whole error of the polynomials and their rounding, on a fine grid where results are of a highlight's size.
    #[test]
    fn highlights_on_a_grid() {
        for i in 1..=4096 {
            let cosine = f64::from(i) / 4096.0;
            for n in [0.01, 0.5, 1.0, 2.0, 3.3, 10.0, 30.0, 80.0, 125.0, 1000.0, 9999.5, 10_000.0] {
                error_is_in_bounds(cosine, n, one(cosine, n)).unwrap();
            }
        }
    }

    /// One number for the bits of many results (FNV-1a), so that no compiler and no processor changes a picture unseen.
    #[test]
    fn the_bits_are_those_of_every_machine() {
        for backend in 0..on_every_backend(&Power { base: [1.0; 8], exponent: [1.0; 8] }).len() {
            let mut digest = 0xcbf2_9ce4_8422_2325_u64;
            for i in 1..=4096 {
                let base = [f64::from(i) / 4096.0; 8];
                let exponent = [0.01, 0.5, 1.0, 3.3, 30.0, 125.0, 1000.0, 9999.5];
                for result in on_every_backend(&Power { base, exponent })[backend].1 {
                    digest = (digest ^ result.to_bits()).wrapping_mul(0x0000_0100_0000_01b3);
                }
            }
            assert_eq!(digest, 0x1abd_17ef_60ba_3703, "{digest:#x}");
        }
    }

    #[test]
    fn what_is_exact() {
        for base in [f64::from_bits(1), 1e-310, 1e-200, 0.3, 0.5, 0.9999, 1.0 - U, 1.0, 1.0 + 2.0 * U] {
            assert_eq!(one(base, 0.0), 1.0, "{base:e}");
        }
        for n in [0.0, 0.3, 1.0, 10_000.0] {
            assert_eq!(one(1.0, n), 1.0, "{n}");
        }
        // powers of two have an exact logarithm, and whole ones an exact power
        assert_eq!([one(0.5, 1.0), one(0.25, 0.5), one(0.125, 100.0)], [0.5, 0.5, libm::ldexp(1.0, -300)]);
        assert_eq!([one(0.5, 1022.0), one(0.5, 1023.0)], [f64::MIN_POSITIVE, 0.0]);
        assert_eq!([one(0.9, 10_000.0), one(f64::from_bits(1), 1.0), one(1e-300, 1.1)], [0.0; 3]);
    }

    #[test]
    fn a_zero_is_no_nan() {
        for n in [0.0, 1e-3, 1.0, 30.0, 10_000.0] {
            assert!((0.0..=1.0).contains(&one(0.0, n)), "{n}");
        }
        assert_eq!(one(0.0, 1.0), 0.0);
    }
}
