//! The widgets of the panels, one file a value type. A widget shows a value and says what became of it; it changes
//! nothing itself.

mod change;
mod channels;
mod choice;
mod color;
mod line;
mod material;
mod number;
mod point;

pub use change::{Change, track};
pub use channels::{Channels, channels};
pub use choice::{choice, steps};
pub use color::color;
pub use line::line;
pub use material::{MaterialChoice, material};
pub(crate) use material::{preset_list, swatch};
pub use number::{NumberField, number};
pub use point::{point, size};
