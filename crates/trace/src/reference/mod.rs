//! The reference: the subject's text in f64, one function a formula.
//!
//! `hidden_surfaces` (subject §1.1) finds what a ray sees with the formulas of `intersect` (§3); `shadow` (§1.2) asks
//! for the lamps; `bounce` (§1.3) mirrors and refracts; `light` (§2) is the model of light; `compose` (§2.6) puts the
//! terms together; `tracer` is the recursion over all of it.

pub mod bounce;
pub mod compose;
mod hidden_surfaces;
pub mod intersect;
pub mod light;
mod surface_point;
mod tracer;

pub use tracer::{TraceError, Tracer};
