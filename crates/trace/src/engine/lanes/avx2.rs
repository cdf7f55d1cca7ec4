//! The lanes in AVX2 with FMA: eight f64 in two registers, eight f32 in one.
//!
//! Safety: every function here uses instructions that the machine must have. The types of this file are only ever made
//! and used inside a function with `#[target_feature(enable = "avx2,fma")]`, which is itself called only where those
//! features were detected; that is the reason of every unsafe block below.
#![allow(unsafe_code, reason = "the instructions of AVX2 and FMA; see the module's text on why they are there")]

use super::{Lanes, Mask, Real, Single, exponent};
use std::arch::x86_64::*;
use std::mem::transmute;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// AVX2 with FMA.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Avx2;

/// Eight f64: lanes 0 to 3, lanes 4 to 7.
#[derive(Clone, Copy)]
pub(crate) struct Reals(__m256d, __m256d);

/// Eight f32.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct Singles(__m256);

/// A mask of [`Reals`]: each lane all ones or all zeros.
#[derive(Clone, Copy)]
pub(crate) struct RealMask(__m256d, __m256d);

/// A mask of [`Singles`]: each lane all ones or all zeros.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct SingleMask(__m256);

impl Lanes for Avx2 {
    type Real = Reals;
    type Single = Singles;
    type Mask = RealMask;
    type SingleMask = SingleMask;

    #[inline(always)]
    fn narrow(value: Reals) -> Singles {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        Singles(unsafe { _mm256_set_m128(_mm256_cvtpd_ps(value.1), _mm256_cvtpd_ps(value.0)) })
    }

    #[inline(always)]
    fn equal(list: &[u32; 8], value: u32) -> u8 {
        // SAFETY: as above; the eight numbers are read where they stand, which need not be aligned.
        unsafe {
            let numbers = _mm256_loadu_si256(list.as_ptr().cast());
            let same = _mm256_cmpeq_epi32(numbers, _mm256_set1_epi32(value as i32));
            _mm256_movemask_ps(_mm256_castsi256_ps(same)) as u8
        }
    }

    #[inline(always)]
    fn greatest_first(keys: Singles, of: [&[u32; 8]; 2]) -> ([f32; 8], [[u32; 8]; 2], usize) {
        greatest_first(keys.0, of)
    }

    #[inline(always)]
    fn prefetch<T>(memory: &T) {
        prefetch(memory);
    }
}

/// Methods of two operands, one instruction a register.
macro_rules! instructions {
    ($type:ident: $($method:ident $instruction:ident)*) => {$(
        #[inline(always)]
        fn $method(self, other: Self) -> Self {
            // SAFETY: this type exists only where AVX2 is (the module's text).
            unsafe { instructions!($type, $instruction(self, other)) }
        }
    )*};
    (Reals, $instruction:ident($a:ident, $b:ident)) => {
        Reals($instruction($a.0, $b.0), $instruction($a.1, $b.1))
    };
    (RealMask, $instruction:ident($a:ident, $b:ident)) => {
        RealMask($instruction($a.0, $b.0), $instruction($a.1, $b.1))
    };
    ($single:ident, $instruction:ident($a:ident, $b:ident)) => {
        $single($instruction($a.0, $b.0))
    };
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
    Reals Add add _mm256_add_pd;
    Reals Sub sub _mm256_sub_pd;
    Reals Mul mul _mm256_mul_pd;
    Reals Div div _mm256_div_pd;
    RealMask BitAnd bitand _mm256_and_pd;
    RealMask BitOr bitor _mm256_or_pd;
    Singles Add add _mm256_add_ps;
    Singles Sub sub _mm256_sub_ps;
    Singles Mul mul _mm256_mul_ps;
    Singles Div div _mm256_div_ps;
    SingleMask BitAnd bitand _mm256_and_ps;
    SingleMask BitOr bitor _mm256_or_ps;
}

/// Comparisons, one instruction each; the predicates are the ordered ones, false for NaN.
macro_rules! comparisons {
    ($mask:ident: $($method:ident $predicate:ident)*) => {$(
        #[inline(always)]
        fn $method(self, other: Self) -> $mask {
            // SAFETY: this type exists only where AVX2 is (the module's text).
            unsafe { comparisons!($mask, $predicate(self, other)) }
        }
    )*};
    (RealMask, $predicate:ident($a:ident, $b:ident)) => {
        RealMask(_mm256_cmp_pd::<$predicate>($a.0, $b.0), _mm256_cmp_pd::<$predicate>($a.1, $b.1))
    };
    (SingleMask, $predicate:ident($a:ident, $b:ident)) => {
        SingleMask(_mm256_cmp_ps::<$predicate>($a.0, $b.0))
    };
}

impl Not for RealMask {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe {
            let ones = _mm256_castsi256_pd(_mm256_set1_epi64x(-1));
            RealMask(_mm256_xor_pd(self.0, ones), _mm256_xor_pd(self.1, ones))
        }
    }
}

impl Mask for RealMask {
    #[inline(always)]
    fn from_bits(bits: u8) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe {
            let bits = _mm256_set1_epi64x(i64::from(bits));
            let (low, high) = (_mm256_setr_epi64x(1, 2, 4, 8), _mm256_setr_epi64x(16, 32, 64, 128));
            RealMask(
                _mm256_castsi256_pd(_mm256_cmpeq_epi64(_mm256_and_si256(bits, low), low)),
                _mm256_castsi256_pd(_mm256_cmpeq_epi64(_mm256_and_si256(bits, high), high)),
            )
        }
    }

    #[inline(always)]
    fn bits(self) -> u8 {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe { (_mm256_movemask_pd(self.0) | (_mm256_movemask_pd(self.1) << 4)) as u8 }
    }
}

impl Not for SingleMask {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        SingleMask(unsafe { _mm256_xor_ps(self.0, _mm256_castsi256_ps(_mm256_set1_epi32(-1))) })
    }
}

impl Mask for SingleMask {
    #[inline(always)]
    fn from_bits(bits: u8) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe {
            let each = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
            let chosen = _mm256_and_si256(_mm256_set1_epi32(i32::from(bits)), each);
            SingleMask(_mm256_castsi256_ps(_mm256_cmpeq_epi32(chosen, each)))
        }
    }

    #[inline(always)]
    fn bits(self) -> u8 {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe { _mm256_movemask_ps(self.0) as u8 }
    }
}

impl Neg for Reals {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe {
            let sign = _mm256_set1_pd(-0.0);
            Reals(_mm256_xor_pd(self.0, sign), _mm256_xor_pd(self.1, sign))
        }
    }
}

impl Real for Reals {
    type Mask = RealMask;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        // SAFETY: called only where AVX2 is (the module's text).
        let both = unsafe { _mm256_set1_pd(value) };
        Reals(both, both)
    }

    #[inline(always)]
    fn load(lanes: &[f64; 8]) -> Self {
        // SAFETY: eight f64 either way.
        let [low, high] = unsafe { transmute::<[f64; 8], [__m256d; 2]>(*lanes) };
        Reals(low, high)
    }

    #[inline(always)]
    fn store(self) -> [f64; 8] {
        // SAFETY: eight f64 either way.
        unsafe { transmute::<[__m256d; 2], [f64; 8]>([self.0, self.1]) }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe { Reals(_mm256_sqrt_pd(self.0), _mm256_sqrt_pd(self.1)) }
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe {
            let sign = _mm256_set1_pd(-0.0);
            Reals(_mm256_andnot_pd(sign, self.0), _mm256_andnot_pd(sign, self.1))
        }
    }

    instructions!(Reals: min _mm256_min_pd max _mm256_max_pd);
    comparisons!(RealMask: lt _CMP_LT_OQ le _CMP_LE_OQ gt _CMP_GT_OQ ge _CMP_GE_OQ eq _CMP_EQ_OQ);

    #[inline(always)]
    fn select(mask: RealMask, yes: Self, no: Self) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe { Reals(_mm256_blendv_pd(no.0, yes.0, mask.0), _mm256_blendv_pd(no.1, yes.1, mask.1)) }
    }

    #[inline(always)]
    fn split_exponent(self) -> (Self, Self) {
        let subnormal = self.lt(Self::splat(f64::MIN_POSITIVE));
        let lifted = Self::select(subnormal, self * Self::splat(exponent::LIFT), self);
        let bias = Self::splat(exponent::BIAS);
        let lifted_bias = Self::splat(exponent::BIAS + f64::from(exponent::LIFT_EXPONENT));
        // SAFETY: this type exists only where AVX2 is (the module's text).
        let ((low_m, low_e), (high_m, high_e)) = unsafe { (split(lifted.0), split(lifted.1)) };
        (Reals(low_m, high_m), Reals(low_e, high_e) - Self::select(subnormal, lifted_bias, bias))
    }

    #[inline(always)]
    fn scale_exponent(self, k: Self) -> Self {
        let k = k.max(Self::splat(-exponent::BIAS)).min(Self::splat(exponent::BIAS));
        let biased = k + Self::splat(exponent::BIAS + exponent::INTEGER);
        // SAFETY: this type exists only where AVX2 is (the module's text).
        let factor = unsafe {
            Reals(
                _mm256_castsi256_pd(_mm256_slli_epi64::<52>(_mm256_castpd_si256(biased.0))),
                _mm256_castsi256_pd(_mm256_slli_epi64::<52>(_mm256_castpd_si256(biased.1))),
            )
        };
        self * factor
    }

    #[inline(always)]
    fn round(self) -> Self {
        const TO_EVEN: i32 = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe { Reals(_mm256_round_pd::<TO_EVEN>(self.0), _mm256_round_pd::<TO_EVEN>(self.1)) }
    }
}

/// `m` and the stored exponent of four positive normal numbers, as [`Real::split_exponent`] wants them.
///
/// # Safety
///
/// The machine must have AVX2.
#[inline(always)]
unsafe fn split(x: __m256d) -> (__m256d, __m256d) {
    // SAFETY: the caller's promise.
    unsafe {
        let shifted = _mm256_add_epi64(_mm256_castpd_si256(x), _mm256_set1_epi64x(exponent::TO_ONE));
        let mantissa = _mm256_and_si256(shifted, _mm256_set1_epi64x(exponent::MANTISSA));
        let integer = _mm256_set1_pd(exponent::INTEGER);
        let biased = _mm256_or_si256(_mm256_srli_epi64::<52>(shifted), _mm256_castpd_si256(integer));
        (
            _mm256_castsi256_pd(_mm256_add_epi64(mantissa, _mm256_set1_epi64x(exponent::ROOT_HALF))),
            _mm256_sub_pd(_mm256_castsi256_pd(biased), integer),
        )
    }
}

impl Neg for Singles {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        Singles(unsafe { _mm256_xor_ps(self.0, _mm256_set1_ps(-0.0)) })
    }
}

impl Single for Singles {
    type Mask = SingleMask;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        // SAFETY: called only where AVX2 is (the module's text).
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
        // SAFETY: this type exists only where AVX2 and FMA are (the module's text).
        Singles(unsafe { _mm256_fmadd_ps(self.0, factor.0, addend.0) })
    }

    #[inline(always)]
    fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
        // SAFETY: this type exists only where AVX2 and FMA are (the module's text).
        Singles(unsafe { _mm256_fmsub_ps(self.0, factor.0, subtrahend.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        Singles(unsafe { _mm256_andnot_ps(_mm256_set1_ps(-0.0), self.0) })
    }

    #[inline(always)]
    fn flipped_by(self, sign: Self) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        Singles(unsafe { _mm256_xor_ps(self.0, _mm256_and_ps(_mm256_set1_ps(-0.0), sign.0)) })
    }

    instructions!(Singles: min _mm256_min_ps max _mm256_max_ps);
    comparisons!(SingleMask: lt _CMP_LT_OQ le _CMP_LE_OQ gt _CMP_GT_OQ ge _CMP_GE_OQ);

    #[inline(always)]
    fn select(mask: SingleMask, yes: Self, no: Self) -> Self {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        Singles(unsafe { _mm256_blendv_ps(no.0, yes.0, mask.0) })
    }

    #[inline(always)]
    fn least(self) -> f32 {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe {
            let four = _mm_min_ps(_mm256_castps256_ps128(self.0), _mm256_extractf128_ps::<1>(self.0));
            let two = _mm_min_ps(four, _mm_movehl_ps(four, four));
            _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)))
        }
    }

    #[inline(always)]
    fn greatest(self) -> f32 {
        // SAFETY: this type exists only where AVX2 is (the module's text).
        unsafe {
            let four = _mm_max_ps(_mm256_castps256_ps128(self.0), _mm256_extractf128_ps::<1>(self.0));
            let two = _mm_max_ps(four, _mm_movehl_ps(four, four));
            _mm_cvtss_f32(_mm_max_ss(two, _mm_movehdup_ps(two)))
        }
    }
}

/// For each set of lanes the numbers of its lanes, then those of the others.
static CHOSEN_FIRST: [[u8; 8]; 256] = {
    let mut table = [[0; 8]; 256];
    let mut set = 0;
    while set < 256 {
        let (mut place, mut wanted) = (0, 2);
        while wanted > 0 {
            wanted -= 1;
            let mut lane = 0;
            while lane < 8 {
                if set >> lane & 1 == wanted {
                    table[set][place] = lane as u8;
                    place += 1;
                }
                lane += 1;
            }
        }
        set += 1;
    }
    table
};

/// [`Lanes::greatest_first`], for AVX-512 too: its vectors of eight f32 are those of AVX2.
#[inline(always)]
pub(super) fn greatest_first(keys: __m256, of: [&[u32; 8]; 2]) -> ([f32; 8], [[u32; 8]; 2], usize) {
    // SAFETY: called by backends whose types exist only where AVX2 is (the module's text).
    unsafe {
        let place = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
        // as integers they are ordered as they are; the lane is part of the number
        let key = _mm256_or_si256(_mm256_andnot_si256(_mm256_set1_epi32(7), _mm256_castps_si256(keys)), place);
        let (key, count) = sorted(key);
        let first = _mm256_permutevar8x32_epi32(transmute::<[u32; 8], __m256i>(*of[0]), key);
        let second = _mm256_permutevar8x32_epi32(transmute::<[u32; 8], __m256i>(*of[1]), key);
        let keys = _mm256_andnot_si256(_mm256_set1_epi32(7), key);
        let of = [transmute::<__m256i, [u32; 8]>(first), transmute::<__m256i, [u32; 8]>(second)];
        (transmute::<__m256i, [f32; 8]>(keys), of, count)
    }
}

/// [`Lanes::prefetch`] on x86-64.
#[inline(always)]
pub(super) fn prefetch<T>(memory: &T) {
    let start = std::ptr::from_ref(memory).cast::<i8>();
    let mut line = 0;
    while line < size_of::<T>() {
        // SAFETY: within the borrowed memory, which is not even read.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(start.add(line)) };
        line += 64;
    }
}

/// Eight integers, those that are not negative first, and of them the greatest first; and how many are not negative.
#[inline(always)]
fn sorted(key: __m256i) -> (__m256i, usize) {
    /// Each lane with its partner, which the permutation brings to it; of the two the lanes of `LESS` keep the lesser.
    #[inline(always)]
    fn round<const LESS: i32>(key: __m256i, partner: __m256i) -> __m256i {
        // SAFETY: called only where AVX2 is (the module's text).
        unsafe { _mm256_blend_epi32::<LESS>(_mm256_max_epi32(key, partner), _mm256_min_epi32(key, partner)) }
    }
    // SAFETY: called only where AVX2 is (the module's text).
    unsafe {
        let set = !_mm256_movemask_ps(_mm256_castsi256_ps(key)) & 0xff;
        let count = set.count_ones() as usize;
        let chosen = _mm_cvtsi64_si128(i64::from_le_bytes(CHOSEN_FIRST[set as usize]));
        let key = _mm256_permutevar8x32_epi32(key, _mm256_cvtepu8_epi32(chosen));
        // 0-2 1-3, 0-1 2-3, 1-2 of each half: enough for four
        let key = round::<0b1100_1100>(key, _mm256_shuffle_epi32::<0b01_00_11_10>(key));
        let key = round::<0b1010_1010>(key, _mm256_shuffle_epi32::<0b10_11_00_01>(key));
        let key = round::<0b0100_0100>(key, _mm256_shuffle_epi32::<0b11_01_10_00>(key));
        if _mm256_extract_epi32::<4>(key) < 0 {
            return (key, count);
        }
        // two halves, each the greatest first, are merged: 0-7 1-6 2-5 3-4, 0-2 1-3 4-6 5-7, 0-1 2-3 4-5 6-7
        let turned = _mm256_permute4x64_epi64::<0b00_01_10_11>(_mm256_shuffle_epi32::<0b10_11_00_01>(key));
        let key = round::<0b1111_0000>(key, turned);
        let key = round::<0b1100_1100>(key, _mm256_shuffle_epi32::<0b01_00_11_10>(key));
        (round::<0b1010_1010>(key, _mm256_shuffle_epi32::<0b10_11_00_01>(key)), count)
    }
}

/// Runs a kernel on this backend; none where the machine lacks it.
#[cfg(test)]
pub(super) fn run<K: super::agree::Kernel>(kernel: &K) -> Option<K::Output> {
    #[target_feature(enable = "avx2,fma")]
    fn entry<K: super::agree::Kernel>(kernel: &K) -> K::Output {
        kernel.run::<Avx2>()
    }
    let present = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
    // SAFETY: the features are present.
    present.then(|| unsafe { entry(kernel) })
}
