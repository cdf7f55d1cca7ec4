//! The engine: the reference's formulas over eight rays at a time.
#![allow(dead_code, unused_imports, reason = "the kernels that use the lanes are still to come")]

mod lanes;
mod power;
