//! Many pixels on many threads: from a compiled world and a view to a picture.
//!
//! A picture is cut into [`Tile`]s. Every pixel is computed on its own, from the world and its place alone, and tiles
//! are put into the film by their place; so a picture has the same bytes for any number of threads and any order
//! of the tiles. Workers send finished tiles and share no lock with whoever shows them.

mod adaptive;
mod blocks;
mod error;
mod film;
pub mod live;
mod pass;
mod pixel;
pub mod schedule;
mod still;
mod tile;
mod tracing;
mod work;

pub use error::{PixelFault, RenderError};
pub use pass::Pass;
pub use pixel::render_pixel;
pub use schedule::Unit;
pub use still::{RenderOptions, Still, render_still};
pub use tile::{Region, Tile, tiles};
pub use tracing::{SimdError, Tracing};
