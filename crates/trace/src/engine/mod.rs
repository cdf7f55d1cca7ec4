//! The engine: the reference's formulas for sixty-four rays at a time.
//!
//! **f32 culls, f64 decides.** Boxes and a filter of facets throw away what a ray cannot hit, in f32 and with bounds of its
//! errors, so that nothing is lost; where the filter is sure of a hit, all that is surely farther goes too, and a shadow is
//! told. What is left is tried with the very f64 operations of [`mod@crate::reference`], in their order, eight rays at a
//! time. So hits, points and normals are the reference's to the last bit, whatever the backend, the companions of a ray,
//! the tile or the thread, and nothing needs an offset. Only powers differ, by less than 10⁻¹².
//!
//! `lanes` are eight numbers; `packet` holds eight rays, and blocks of eight packets; `hidden_surfaces` and `shadows`
//! find hits, of meshes by `facets_nearest` and `facets_blocking` for packets that keep together and `facets_alone` and
//! `blocking_alone` for others, all with `facet_filter`; `surface_point` finds points, `light` and `bounce` colours; `path`
//! is the recursion, `dispatch` the way in.
#![allow(clippy::needless_range_loop, reason = "closures of iterators are not compiled for a backend")]

mod blocking_alone;
mod bounce;
mod caster;
mod cone;
mod dispatch;
mod facet_filter;
mod facets_alone;
mod facets_blocking;
mod facets_nearest;
mod few;
mod hidden_surfaces;
mod image;
mod intersect;
pub(crate) mod lanes;
mod light;
mod media;
pub(crate) mod packet;
mod path;
mod power;
mod shadows;
mod surface_point;
pub(crate) mod vector;

pub use caster::Caster;
pub use dispatch::Simd;
pub use image::Engine;
