//! Eight rays side by side: the arithmetic that the engine's kernels are written in.
//!
//! A kernel is generic over [`Lanes`] and inlined into one `#[target_feature]` function per backend, so a packet is
//! eight rays on every machine and the kernel's text stands once. Two kinds of numbers serve two ends:
//!
//! * [`Real`], eight f64, decides. Each operation is the IEEE one, rounded to nearest, and nothing is fused, so every
//!   backend gives equal bits, and those of the same operations in scalar f64. (Which NaN an operation gives, its sign
//!   and payload, is the one thing left open; no comparison sees it.)
//! * [`Single`], eight f32, culls. Its multiply-add is fused where the machine has that, so kernels may use it only
//!   where an error bound covers both roundings.
//!
//! Everything here is `#[inline(always)]`: an instruction of a backend is inlined only into a function that enables its
//! feature, which is the kernel's entry, and only where nothing in between stays a call.

#[cfg(test)]
pub(crate) mod agree;
#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
mod portable;

#[cfg(target_arch = "x86_64")]
pub(crate) use avx2::Avx2;
#[cfg(target_arch = "x86_64")]
pub(crate) use avx512::Avx512;
pub(crate) use portable::Portable;

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// One way of computing eight rays side by side.
pub(crate) trait Lanes: Copy + Send + Sync + 'static {
    /// Eight f64.
    type Real: Real<Mask = Self::Mask>;
    /// Eight f32.
    type Single: Single<Mask = Self::SingleMask>;
    /// What comparing [`Lanes::Real`] gives.
    type Mask: Mask;
    /// What comparing [`Lanes::Single`] gives.
    type SingleMask: Mask;

    /// Each lane rounded to the nearest f32, ties to even; what is too large becomes infinite.
    fn narrow(value: Self::Real) -> Self::Single;

    /// The lanes of a list of numbers that hold `value`: lane `i` in bit `i`.
    fn equal(list: &[u32; 8], value: u32) -> u8;

    /// The lanes that are not negative, greatest first, with them what belongs to them in two lists, and how many they are;
    /// what stands after those has no meaning. The last three bits of each are cleared. There is neither NaN nor -0 among
    /// them.
    fn greatest_first(keys: Self::Single, of: [&[u32; 8]; 2]) -> ([f32; 8], [[u32; 8]; 2], usize);

    /// Has memory fetched that will be read soon. Nothing but the time until then depends on it.
    fn prefetch<T>(memory: &T);
}

/// One truth value a lane. The operators work lane by lane.
pub(crate) trait Mask: Copy + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> {
    /// The mask whose lane `i` is bit `i`.
    fn from_bits(bits: u8) -> Self;

    /// Lane `i` in bit `i`.
    fn bits(self) -> u8;
}

/// Eight f64. `Neg` flips the sign bit, of zeros and NaN too.
pub(crate) trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// What comparisons give.
    type Mask: Mask;

    /// The same value in every lane.
    fn splat(value: f64) -> Self;

    /// Lane `i` from place `i`.
    fn load(lanes: &[f64; 8]) -> Self;

    /// Lane `i` in place `i`.
    fn store(self) -> [f64; 8];

    /// The square root, correctly rounded; NaN below zero, `-0` of `-0`.
    fn sqrt(self) -> Self;

    /// Clears the sign bit, of zeros and NaN too.
    fn abs(self) -> Self;

    /// `if self < other { self } else { other }`: `other` where either is NaN or both are zeros.
    fn min(self, other: Self) -> Self;

    /// `if self > other { self } else { other }`: `other` where either is NaN or both are zeros.
    fn max(self, other: Self) -> Self;

    /// `self < other`; false for NaN, as are the other comparisons.
    fn lt(self, other: Self) -> Self::Mask;

    /// `self <= other`.
    fn le(self, other: Self) -> Self::Mask;

    /// `self > other`.
    fn gt(self, other: Self) -> Self::Mask;

    /// `self >= other`.
    fn ge(self, other: Self) -> Self::Mask;

    /// `self == other`; the two zeros are equal.
    fn eq(self, other: Self) -> Self::Mask;

    /// The lanes of `yes` where the mask is true, of `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// `(m, e)` with `self = m·2^e` exactly, `m` in `√½..√2`, and `e` an integer.
    ///
    /// For positive finite lanes, subnormal ones too. Every other lane gives two numbers without meaning, `m` in that
    /// range and `e` an integer below 2^12, and but for NaN the same two on every backend.
    fn split_exponent(self) -> (Self, Self);

    /// `self·2^k` for integers `k`, clamped to -1023..=1023, where -1023 stands for a factor of 0.
    ///
    /// The product is rounded once, so it is exact where it is normal. A NaN in `k` counts as -1023.
    fn scale_exponent(self, k: Self) -> Self;

    /// To the nearest integer, ties to the even one; the sign stays, of zeros too.
    fn round(self) -> Self;
}

/// Eight f32, for culling. `Neg` flips the sign bit, of zeros and NaN too.
pub(crate) trait Single:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// What comparisons give.
    type Mask: Mask;

    /// The same value in every lane.
    fn splat(value: f32) -> Self;

    /// Lane `i` from place `i`.
    fn load(lanes: &[f32; 8]) -> Self;

    /// Lanes 0 to 3 from `low`, 4 to 7 from `high`.
    fn of_halves(low: &[f32; 4], high: &[f32; 4]) -> Self;

    /// Lane `i` in place `i`.
    fn store(self) -> [f32; 8];

    /// `self·factor + addend`, rounded once where the machine has a fused multiply-add, else twice.
    fn mul_add(self, factor: Self, addend: Self) -> Self;

    /// `self·factor - subtrahend`, rounded as [`Single::mul_add`] is.
    fn mul_sub(self, factor: Self, subtrahend: Self) -> Self;

    /// Clears the sign bit, of zeros and NaN too.
    fn abs(self) -> Self;

    /// Flips the sign bit where that of `sign` is set.
    fn flipped_by(self, sign: Self) -> Self;

    /// `if self < other { self } else { other }`: `other` where either is NaN or both are zeros.
    fn min(self, other: Self) -> Self;

    /// `if self > other { self } else { other }`: `other` where either is NaN or both are zeros.
    fn max(self, other: Self) -> Self;

    /// `self < other`; false for NaN, as are the other comparisons.
    fn lt(self, other: Self) -> Self::Mask;

    /// `self <= other`.
    fn le(self, other: Self) -> Self::Mask;

    /// `self > other`.
    fn gt(self, other: Self) -> Self::Mask;

    /// `self >= other`.
    fn ge(self, other: Self) -> Self::Mask;

    /// The lanes of `yes` where the mask is true, of `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// The least lane: [`Single::min`] of lanes `i` and `i + 4`, then of those `i` and `i + 2`, then of the last two.
    /// Without meaning where a lane is NaN.
    fn least(self) -> f32;

    /// The greatest lane, in the same order with [`Single::max`]. Without meaning where a lane is NaN.
    fn greatest(self) -> f32;
}

/// The constants of [`Real::split_exponent`] and [`Real::scale_exponent`], which every backend computes alike.
mod exponent {
    /// What lifts the subnormal numbers into the normal range, and its exponent.
    pub(super) const LIFT: f64 = (1_u64 << LIFT_EXPONENT) as f64;
    pub(super) const LIFT_EXPONENT: u32 = 54;

    /// The bits of the f64 next to √½. With `x = m·2^e` the bits of `x` and of `m` differ by `e` in the exponent's place,
    /// so adding `1 - √½` in bits carries into it just where the mantissa passes that of √½.
    pub(super) const ROOT_HALF: i64 = std::f64::consts::FRAC_1_SQRT_2.to_bits() as i64;
    pub(super) const TO_ONE: i64 = ONE - ROOT_HALF;
    pub(super) const ONE: i64 = 1.0_f64.to_bits() as i64;

    /// The bits of the mantissa, without the exponent above them.
    pub(super) const MANTISSA_BITS: u32 = 52;
    pub(super) const MANTISSA: i64 = (1 << MANTISSA_BITS) - 1;

    /// The exponents that [`scale_exponent`](super::Real::scale_exponent) knows are within ± this; it is also what an
    /// exponent is stored with.
    pub(super) const BIAS: f64 = 1023.0;

    /// 2^52: in its binade the last bit of the mantissa is worth 1, so an integer below it stands in the low bits.
    pub(super) const INTEGER: f64 = (1_u64 << MANTISSA_BITS) as f64;
}
