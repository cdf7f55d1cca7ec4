//! The way into each backend: which one this machine can run, and the functions that are compiled for it.
//!
//! The kernels are generic and always inlined; here they are instantiated once for each backend inside of functions
//! that may use its instructions. Recursion and the larger steps go through these functions again.
#![allow(unsafe_code, reason = "calls functions that are compiled for more instructions than the program as a whole")]

#[cfg(target_arch = "x86_64")]
use super::lanes::{Avx2, Avx512};
use super::lanes::{Lanes, Portable};

/// The instructions that the engine uses. The pictures are the same, byte for byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Simd {
    /// What every machine has.
    Portable,
    /// AVX2, FMA and what came with them for counting and shifting bits: x86-64 since about 2013.
    Avx2,
    /// AVX-512 F, DQ and VL.
    Avx512,
}

impl Simd {
    /// Every kind, slowest first.
    pub const ALL: [Simd; 3] = [Simd::Portable, Simd::Avx2, Simd::Avx512];

    /// The name by which `LANCER_SIMD` asks for it.
    pub const fn name(self) -> &'static str {
        match self {
            Simd::Portable => "portable",
            Simd::Avx2 => "avx2",
            Simd::Avx512 => "avx512",
        }
    }

    /// Whether this machine can run it.
    pub fn is_available(self) -> bool {
        match self {
            Simd::Portable => true,
            #[cfg(target_arch = "x86_64")]
            Simd::Avx2 => {
                std::is_x86_feature_detected!("avx2")
                    && std::is_x86_feature_detected!("fma")
                    && std::is_x86_feature_detected!("bmi1")
                    && std::is_x86_feature_detected!("bmi2")
                    && std::is_x86_feature_detected!("lzcnt")
                    && std::is_x86_feature_detected!("popcnt")
            }
            #[cfg(target_arch = "x86_64")]
            Simd::Avx512 => {
                Simd::Avx2.is_available()
                    && std::is_x86_feature_detected!("avx512f")
                    && std::is_x86_feature_detected!("avx512dq")
                    && std::is_x86_feature_detected!("avx512vl")
            }
            #[cfg(not(target_arch = "x86_64"))]
            Simd::Avx2 | Simd::Avx512 => false,
        }
    }

    /// The fastest that this machine can run.
    pub fn best() -> Simd {
        Simd::ALL.into_iter().rev().find(|simd| simd.is_available()).unwrap_or(Simd::Portable)
    }
}

/// A piece of work that is written for any backend and compiled for each: its arguments.
pub(super) trait Step<B> {
    /// Always inlined, so that it is compiled for the backend that it is entered through.
    fn run(self);
}

/// Lanes with a way in.
pub(super) trait Backend: Lanes {
    /// Runs a step as a function of its own that is compiled for the backend. Only called from within the backend, or
    /// where its instructions are known to be there.
    fn enter(step: impl Step<Self>);
}

/// Runs a step with the instructions that `simd` says, or the best there are if it is not available.
#[cfg(target_arch = "x86_64")]
pub(super) fn enter<S: Step<Portable> + Step<Avx2> + Step<Avx512>>(simd: Simd, step: S) {
    match if simd.is_available() { simd } else { Simd::best() } {
        Simd::Portable => Portable::enter(step),
        Simd::Avx2 => Avx2::enter(step),
        Simd::Avx512 => Avx512::enter(step),
    }
}

/// Runs a step; there is one backend on this machine.
#[cfg(not(target_arch = "x86_64"))]
pub(super) fn enter<S: Step<Portable>>(_: Simd, step: S) {
    Portable::enter(step);
}

macro_rules! backend {
    ($lanes:ident $(, $features:literal)?) => {
        impl Backend for $lanes {
            #[inline(always)]
            fn enter(step: impl Step<Self>) {
                #[inline(never)]
                $(#[target_feature(enable = $features)])?
                fn compiled(step: impl Step<$lanes>) {
                    step.run();
                }
                // SAFETY: the function `enter` of this file is the only way from outside into a backend, and it asks
                // `Simd::is_available` for these very features; steps enter further steps of their own backend only.
                #[allow(unused_unsafe, reason = "the portable function is safe")]
                unsafe {
                    compiled(step);
                }
            }
        }
    };
}

backend!(Portable);
#[cfg(target_arch = "x86_64")]
backend!(Avx2, "avx2,fma,bmi1,bmi2,lzcnt,popcnt");
#[cfg(target_arch = "x86_64")]
backend!(Avx512, "avx2,fma,bmi1,bmi2,lzcnt,popcnt,avx512f,avx512dq,avx512vl");
