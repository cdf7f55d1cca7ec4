//! Rays to colours: what a picture's pixels are, by the formulas of the course's subject.
//!
//! A checked scene is compiled into a [`World`]; a [`Camera`] turns pixels into rays; a [`Tracer`] follows them and
//! tells an [`Observer`] everything it computes. The [reference](mod@reference) is the subject's text in f64, one function a
//! formula: it is the truth that faster engines are held to, and the explanation of a pixel.

mod bvh;
mod camera;
mod cancel;
mod channels;
pub mod engine;
pub mod explain;
pub mod observe;
mod pick;
mod precision;
mod ray;
pub mod reference;
mod settings;
mod world;

pub use camera::Camera;
pub use cancel::Cancel;
pub use channels::Channels;
pub use engine::{Caster, Engine, Simd};
pub use explain::{PixelTree, explain};
pub use observe::{Observer, RayCounts, RayTree};
pub use pick::Picked;
pub use ray::{Ray, RayKind};
pub use reference::{TraceError, Tracer};
pub use settings::Settings;
pub use world::{BuildStats, World};
