//! What a view pane is made of: its live picture, what the pointer does in it, and what is drawn over it.

mod footer;
mod gesture;
mod header;
mod live;
mod mapping;
mod overlay;
mod picker;

pub use gesture::Gesture;
pub use header::header;
pub use live::LiveView;
pub use mapping::Mapping;
pub use picker::{Answer, Picker, Purpose};

pub(crate) use footer::{HEIGHT as FOOTER, footer};
pub(crate) use gesture::{Scope, follow};
pub(crate) use overlay::{draw, explained, hint, rectangle};
