//! The lanes as arrays, for machines without the wide instructions; the compiler makes what it can of the loops. It is
//! also the plain text of what the other backends compute.
//!
//! A mask's lane is all ones or all zeros, as wide as the number it was compared from: what vector instructions give.

use super::{Lanes, Mask, Real, Single, exponent};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Arrays of eight.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Portable;

/// Eight numbers.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct Eight<T>([T; 8]);

/// Eight truth values, each all ones or all zeros.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct Flags<T>([T; 8]);

impl Lanes for Portable {
    type Real = Eight<f64>;
    type Single = Eight<f32>;
    type Mask = Flags<u64>;
    type SingleMask = Flags<u32>;

    #[inline(always)]
    fn narrow(value: Eight<f64>) -> Eight<f32> {
        value.map(|lane| lane as f32)
    }

    #[inline(always)]
    fn equal(list: &[u32; 8], value: u32) -> u8 {
        let mut bits = 0;
        for lane in 0..8 {
            bits |= u8::from(list[lane] == value) << lane;
        }
        bits
    }

    #[inline(always)]
    fn greatest_first(keys: Eight<f32>, of: [&[u32; 8]; 2]) -> ([f32; 8], [[u32; 8]; 2], usize) {
        let (mut sorted, mut order, mut count) = ([0.0; 8], [[0; 8]; 2], 0);
        for lane in 0..8 {
            if keys.0[lane] >= 0.0 {
                let key = f32::from_bits(keys.0[lane].to_bits() & !7);
                let mut place = count;
                while place > 0 && sorted[place - 1] <= key {
                    sorted[place] = sorted[place - 1];
                    order[0][place] = order[0][place - 1];
                    order[1][place] = order[1][place - 1];
                    place -= 1;
                }
                (sorted[place], order[0][place], order[1][place]) = (key, of[0][lane], of[1][lane]);
                count += 1;
            }
        }
        (sorted, order, count)
    }

    #[inline(always)]
    fn prefetch<T>(_: &T) {}
}

impl<T: Copy> Eight<T> {
    #[inline(always)]
    fn map<U>(self, of: impl Fn(T) -> U) -> Eight<U> {
        Eight(self.0.map(of))
    }

    #[inline(always)]
    fn zip<U>(self, other: Self, of: impl Fn(T, T) -> U) -> [U; 8] {
        std::array::from_fn(|lane| of(self.0[lane], other.0[lane]))
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident),*) => {$(
        impl<T: Copy + $operator<Output = T>> $operator for Eight<T> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Eight(self.zip(other, T::$method))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl<T: Copy + Neg<Output = T>> Neg for Eight<T> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map(T::neg)
    }
}

impl<T: Copy + BitAnd<Output = T>> BitAnd for Flags<T> {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Flags(std::array::from_fn(|lane| self.0[lane] & other.0[lane]))
    }
}

impl<T: Copy + BitOr<Output = T>> BitOr for Flags<T> {
    type Output = Self;

    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Flags(std::array::from_fn(|lane| self.0[lane] | other.0[lane]))
    }
}

impl<T: Copy + Not<Output = T>> Not for Flags<T> {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        Flags(self.0.map(T::not))
    }
}

/// Masks, and the methods that read the same for f64 and f32.
macro_rules! mask {
    ($bits:ty) => {
        impl Flags<$bits> {
            #[inline(always)]
            fn of(truth: impl Fn(usize) -> bool) -> Self {
                Flags(std::array::from_fn(|lane| if truth(lane) { <$bits>::MAX } else { 0 }))
            }
        }

        impl Mask for Flags<$bits> {
            #[inline(always)]
            fn from_bits(bits: u8) -> Self {
                Self::of(|lane| (bits >> lane) & 1 == 1)
            }

            #[inline(always)]
            fn bits(self) -> u8 {
                (0..8).fold(0, |bits, lane| bits | (((self.0[lane] & 1) as u8) << lane))
            }
        }
    };
}

macro_rules! numbers {
    ($float:ty, $bits:ty) => {
        type Mask = Flags<$bits>;

        #[inline(always)]
        fn splat(value: $float) -> Self {
            Eight([value; 8])
        }

        #[inline(always)]
        fn load(lanes: &[$float; 8]) -> Self {
            Eight(*lanes)
        }

        #[inline(always)]
        fn store(self) -> [$float; 8] {
            self.0
        }

        #[inline(always)]
        fn abs(self) -> Self {
            self.map(<$float>::abs)
        }

        #[inline(always)]
        fn min(self, other: Self) -> Self {
            Eight(self.zip(other, |a, b| if a < b { a } else { b }))
        }

        #[inline(always)]
        fn max(self, other: Self) -> Self {
            Eight(self.zip(other, |a, b| if a > b { a } else { b }))
        }

        #[inline(always)]
        fn lt(self, other: Self) -> Flags<$bits> {
            Flags::<$bits>::of(|lane| self.0[lane] < other.0[lane])
        }

        #[inline(always)]
        fn le(self, other: Self) -> Flags<$bits> {
            Flags::<$bits>::of(|lane| self.0[lane] <= other.0[lane])
        }

        #[inline(always)]
        fn gt(self, other: Self) -> Flags<$bits> {
            Flags::<$bits>::of(|lane| self.0[lane] > other.0[lane])
        }

        #[inline(always)]
        fn ge(self, other: Self) -> Flags<$bits> {
            Flags::<$bits>::of(|lane| self.0[lane] >= other.0[lane])
        }

        #[inline(always)]
        fn select(mask: Flags<$bits>, yes: Self, no: Self) -> Self {
            Eight(std::array::from_fn(|lane| {
                let (yes, no) = (yes.0[lane].to_bits(), no.0[lane].to_bits());
                <$float>::from_bits((yes & mask.0[lane]) | (no & !mask.0[lane]))
            }))
        }
    };
}

mask!(u64);
mask!(u32);

impl Real for Eight<f64> {
    numbers!(f64, u64);

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    #[inline(always)]
    fn eq(self, other: Self) -> Flags<u64> {
        Flags::<u64>::of(|lane| self.0[lane] == other.0[lane])
    }

    #[inline(always)]
    fn split_exponent(self) -> (Self, Self) {
        let subnormal = self.lt(Self::splat(f64::MIN_POSITIVE));
        let shifted = Self::select(subnormal, self * Self::splat(exponent::LIFT), self)
            .map(|lane| (lane.to_bits() as i64).wrapping_add(exponent::TO_ONE));
        let mantissa =
            shifted.map(|bits| f64::from_bits(((bits & exponent::MANTISSA) + exponent::ROOT_HALF).cast_unsigned()));
        let biased = shifted.map(|bits| {
            let integer = bits.cast_unsigned() >> exponent::MANTISSA_BITS;
            f64::from_bits(integer | exponent::INTEGER.to_bits()) - exponent::INTEGER
        });
        let lifted = Self::splat(exponent::BIAS + f64::from(exponent::LIFT_EXPONENT));
        (mantissa, biased - Self::select(subnormal, lifted, Self::splat(exponent::BIAS)))
    }

    #[inline(always)]
    fn scale_exponent(self, k: Self) -> Self {
        let k = k.max(Self::splat(-exponent::BIAS)).min(Self::splat(exponent::BIAS));
        let biased = k + Self::splat(exponent::BIAS + exponent::INTEGER);
        self * biased.map(|lane| f64::from_bits(lane.to_bits() << exponent::MANTISSA_BITS))
    }

    /// `f64::round_ties_even` is a call where the machine has no instruction for it: here 2^52 pushes the fraction out.
    #[inline(always)]
    fn round(self) -> Self {
        let integer = self.map(|lane| ((lane.abs() + exponent::INTEGER) - exponent::INTEGER).copysign(lane));
        Self::select(self.abs().lt(Self::splat(exponent::INTEGER)), integer, self)
    }
}

impl Single for Eight<f32> {
    numbers!(f32, u32);

    #[inline(always)]
    fn of_halves(low: &[f32; 4], high: &[f32; 4]) -> Self {
        Eight(std::array::from_fn(|lane| if lane < 4 { low[lane] } else { high[lane - 4] }))
    }

    #[inline(always)]
    fn flipped_by(self, sign: Self) -> Self {
        let flipped = |a: f32, b: f32| f32::from_bits(a.to_bits() ^ (b.to_bits() & 1 << 31));
        Eight(self.zip(sign, flipped))
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    #[inline(always)]
    fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
        self * factor - subtrahend
    }

    #[inline(always)]
    fn least(self) -> f32 {
        fold(self.0, |a, b| if a < b { a } else { b })
    }

    #[inline(always)]
    fn greatest(self) -> f32 {
        fold(self.0, |a, b| if a > b { a } else { b })
    }
}

/// Eight lanes to four, to two, to one.
#[inline(always)]
fn fold(lanes: [f32; 8], of: impl Fn(f32, f32) -> f32) -> f32 {
    let four: [f32; 4] = std::array::from_fn(|lane| of(lanes[lane], lanes[lane + 4]));
    let two: [f32; 2] = std::array::from_fn(|lane| of(four[lane], four[lane + 2]));
    of(two[0], two[1])
}
