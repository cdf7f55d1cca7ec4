//! Bytes to scene and back, bytes to picture and back.
//!
//! Readers and writers meet only in the model of `lancer-scene`. A reader takes bytes and gives an [`Outcome`]: a value
//! as far as one can be made, *and* every diagnostic with its span. Files are opened in [`load`] and [`save`] alone.

pub mod binary;
pub mod diagnostic;
pub mod export;
mod finding;
pub mod load;
pub mod mesh;
pub mod n7_2009;
pub mod nff;
pub mod picture;
pub mod ppm;
pub mod progress;
mod refusal;
pub mod save;
pub mod text;
pub mod xml;

pub use diagnostic::{Describe, Diagnostic, Lines, Outcome, Problem, Severity, Source, Span};
