//! The lanes in AVX-512: eight f64 in one register, eight f32 in half of one, masks in mask registers.
//!
//! Safety: every function here uses instructions that the machine must have. The types of this file are only ever made
//! and used inside a function with `#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]`, which is itself
//! called only where those features were detected; that is the reason of every unsafe block below.
#![allow(unsafe_code, reason = "the instructions of AVX-512; see the module's text on why they are there")]

use super::{Lanes, Mask, Real, Single, avx2, exponent};
use std::arch::x86_64::*;
use std::mem::transmute;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// AVX-512 with its instructions for double words and for short vectors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Avx512;

/// Eight f64.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct Reals(__m512d);

/// Eight f32.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct Singles(__m256);

/// A mask of either, one bit a lane.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct Bits(__mmask8);

impl Lanes for Avx512 {
    type Real = Reals;
    type Single = Singles;
    type Mask = Bits;
    type SingleMask = Bits;

    #[inline(always)]
    fn narrow(value: Reals) -> Singles {
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        Singles(unsafe { _mm512_cvtpd_ps(value.0) })
    }

    #[inline(always)]
    fn equal(list: &[u32; 8], value: u32) -> u8 {
        // SAFETY: as above; the eight numbers are read where they stand, which need not be aligned.
        unsafe { _mm256_cmpeq_epi32_mask(_mm256_loadu_si256(list.as_ptr().cast()), _mm256_set1_epi32(value as i32)) }
    }

    #[inline(always)]
    fn greatest_first(keys: Singles, of: [&[u32; 8]; 2]) -> ([f32; 8], [[u32; 8]; 2], usize) {
        avx2::greatest_first(keys.0, of)
    }

    #[inline(always)]
    fn prefetch<T>(memory: &T) {
        avx2::prefetch(memory);
    }
}

impl Mask for Bits {
    #[inline(always)]
    fn from_bits(bits: u8) -> Self {
        Bits(bits)
    }

    #[inline(always)]
    fn bits(self) -> u8 {
        self.0
    }
}

impl BitAnd for Bits {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Bits(self.0 & other.0)
    }
}

impl BitOr for Bits {
    type Output = Self;

    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Bits(self.0 | other.0)
    }
}

impl Not for Bits {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        Bits(!self.0)
    }
}

/// Methods of two operands, one instruction each.
macro_rules! instructions {
    ($type:ident: $($method:ident $instruction:ident)*) => {$(
        #[inline(always)]
        fn $method(self, other: Self) -> Self {
            // SAFETY: this type exists only where AVX-512 is (the module's text).
            $type(unsafe { $instruction(self.0, other.0) })
        }
    )*};
}

macro_rules! operators {
    ($($type:ident $operator:ident $method:ident $instruction:ident;)*) => {$(
        impl $operator for $type {
            type Output = Self;

            instructions!($type: $method $instruction);
        }
    )*};
}

operators! {
    Reals Add add _mm512_add_pd;
    Reals Sub sub _mm512_sub_pd;
    Reals Mul mul _mm512_mul_pd;
    Reals Div div _mm512_div_pd;
    Singles Add add _mm256_add_ps;
    Singles Sub sub _mm256_sub_ps;
    Singles Mul mul _mm256_mul_ps;
    Singles Div div _mm256_div_ps;
}

/// Comparisons, one instruction each; the predicates are the ordered ones, false for NaN.
macro_rules! comparisons {
    ($instruction:ident: $($method:ident $predicate:ident)*) => {$(
        #[inline(always)]
        fn $method(self, other: Self) -> Bits {
            // SAFETY: this type exists only where AVX-512 is (the module's text).
            Bits(unsafe { $instruction::<$predicate>(self.0, other.0) })
        }
    )*};
}

impl Neg for Reals {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        Reals(unsafe { _mm512_xor_pd(self.0, _mm512_set1_pd(-0.0)) })
    }
}

impl Real for Reals {
    type Mask = Bits;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        // SAFETY: called only where AVX-512 is (the module's text).
        Reals(unsafe { _mm512_set1_pd(value) })
    }

    #[inline(always)]
    fn load(lanes: &[f64; 8]) -> Self {
        // SAFETY: eight f64 either way.
        Reals(unsafe { transmute::<[f64; 8], __m512d>(*lanes) })
    }

    #[inline(always)]
    fn store(self) -> [f64; 8] {
        // SAFETY: eight f64 either way.
        unsafe { transmute::<__m512d, [f64; 8]>(self.0) }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        Reals(unsafe { _mm512_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        Reals(unsafe { _mm512_andnot_pd(_mm512_set1_pd(-0.0), self.0) })
    }

    instructions!(Reals: min _mm512_min_pd max _mm512_max_pd);
    comparisons!(_mm512_cmp_pd_mask: lt _CMP_LT_OQ le _CMP_LE_OQ gt _CMP_GT_OQ ge _CMP_GE_OQ eq _CMP_EQ_OQ);

    #[inline(always)]
    fn select(mask: Bits, yes: Self, no: Self) -> Self {
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        Reals(unsafe { _mm512_mask_blend_pd(mask.0, no.0, yes.0) })
    }

    #[inline(always)]
    fn split_exponent(self) -> (Self, Self) {
        let subnormal = self.lt(Self::splat(f64::MIN_POSITIVE));
        let lifted = Self::select(subnormal, self * Self::splat(exponent::LIFT), self);
        let bias = Self::splat(exponent::BIAS);
        let lifted_bias = Self::splat(exponent::BIAS + f64::from(exponent::LIFT_EXPONENT));
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        let (mantissa, biased) = unsafe {
            let shifted = _mm512_add_epi64(_mm512_castpd_si512(lifted.0), _mm512_set1_epi64(exponent::TO_ONE));
            let mantissa = _mm512_and_si512(shifted, _mm512_set1_epi64(exponent::MANTISSA));
            (
                _mm512_castsi512_pd(_mm512_add_epi64(mantissa, _mm512_set1_epi64(exponent::ROOT_HALF))),
                _mm512_cvtepi64_pd(_mm512_srli_epi64::<{ exponent::MANTISSA_BITS }>(shifted)),
            )
        };
        (Reals(mantissa), Reals(biased) - Self::select(subnormal, lifted_bias, bias))
    }

    #[inline(always)]
    fn scale_exponent(self, k: Self) -> Self {
        let k = k.max(Self::splat(-exponent::BIAS)).min(Self::splat(exponent::BIAS));
        let biased = k + Self::splat(exponent::BIAS + exponent::INTEGER);
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        let factor = unsafe {
            let bits = _mm512_castpd_si512(biased.0);
            _mm512_castsi512_pd(_mm512_slli_epi64::<{ exponent::MANTISSA_BITS }>(bits))
        };
        self * Reals(factor)
    }

    #[inline(always)]
    fn round(self) -> Self {
        const TO_EVEN: i32 = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        Reals(unsafe { _mm512_roundscale_pd::<TO_EVEN>(self.0) })
    }
}

impl Neg for Singles {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        Singles(unsafe { _mm256_xor_ps(self.0, _mm256_set1_ps(-0.0)) })
    }
}

impl Single for Singles {
    type Mask = Bits;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        // SAFETY: called only where AVX-512 is (the module's text).
        Singles(unsafe { _mm256_set1_ps(value) })
    }

    #[inline(always)]
    fn load(lanes: &[f32; 8]) -> Self {
        // SAFETY: eight f32 either way.
        Singles(unsafe { transmute::<[f32; 8], __m256>(*lanes) })
    }

    #[inline(always)]
    fn of_halves(low: &[f32; 4], high: &[f32; 4]) -> Self {
        // SAFETY: eight f32 either way.
        Singles(unsafe { transmute::<[[f32; 4]; 2], __m256>([*low, *high]) })
    }

    #[inline(always)]
    fn store(self) -> [f32; 8] {
        // SAFETY: eight f32 either way.
        unsafe { transmute::<__m256, [f32; 8]>(self.0) }
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        // SAFETY: this type exists only where AVX-512 and FMA are (the module's text).
        Singles(unsafe { _mm256_fmadd_ps(self.0, factor.0, addend.0) })
    }

    #[inline(always)]
    fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
        // SAFETY: this type exists only where AVX-512 and FMA are (the module's text).
        Singles(unsafe { _mm256_fmsub_ps(self.0, factor.0, subtrahend.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        Singles(unsafe { _mm256_andnot_ps(_mm256_set1_ps(-0.0), self.0) })
    }

    #[inline(always)]
    fn flipped_by(self, sign: Self) -> Self {
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        Singles(unsafe { _mm256_xor_ps(self.0, _mm256_and_ps(_mm256_set1_ps(-0.0), sign.0)) })
    }

    instructions!(Singles: min _mm256_min_ps max _mm256_max_ps);
    comparisons!(_mm256_cmp_ps_mask: lt _CMP_LT_OQ le _CMP_LE_OQ gt _CMP_GT_OQ ge _CMP_GE_OQ);

    #[inline(always)]
    fn select(mask: Bits, yes: Self, no: Self) -> Self {
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        Singles(unsafe { _mm256_mask_blend_ps(mask.0, no.0, yes.0) })
    }

    #[inline(always)]
    fn least(self) -> f32 {
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        unsafe {
            let four = _mm_min_ps(_mm256_castps256_ps128(self.0), _mm256_extractf128_ps::<1>(self.0));
            let two = _mm_min_ps(four, _mm_movehl_ps(four, four));
            _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)))
        }
    }

    #[inline(always)]
    fn greatest(self) -> f32 {
        // SAFETY: this type exists only where AVX-512 is (the module's text).
        unsafe {
            let four = _mm_max_ps(_mm256_castps256_ps128(self.0), _mm256_extractf128_ps::<1>(self.0));
            let two = _mm_max_ps(four, _mm_movehl_ps(four, four));
            _mm_cvtss_f32(_mm_max_ss(two, _mm_movehdup_ps(two)))
        }
    }
}

/// Runs a kernel on this backend; none where the machine lacks it.
#[cfg(test)]
pub(super) fn run<K: super::agree::Kernel>(kernel: &K) -> Option<K::Output> {
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
    fn entry<K: super::agree::Kernel>(kernel: &K) -> K::Output {
        kernel.run::<Avx512>()
    }
    let present = is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512dq")
        && is_x86_feature_detected!("avx512vl")
        && is_x86_feature_detected!("avx2")
        && is_x86_feature_detected!("fma");
    // SAFETY: the features are present.
    present.then(|| unsafe { entry(kernel) })
}
