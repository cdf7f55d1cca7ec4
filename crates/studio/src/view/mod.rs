//! What a view pane is made of: its live picture, what the pointer does in it, and what is drawn over it.

mod live;
mod picker;

pub use live::LiveView;
pub use picker::{Answer, Picker, Purpose};
