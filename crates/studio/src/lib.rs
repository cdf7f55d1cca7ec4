//! The desktop editor: live views of one scene, every edit visible in all of them at once.
//!
//! A panel is a function of a [`Context`] that returns [`Action`]s; they are carried out in one place, which alone
//! changes the document. Pictures come from the sessions of `lancer-render`; the window never traces a ray and never
//! waits for one.

pub mod action;
pub mod chrome;
pub mod context;
pub mod fields;
pub mod panels;
pub mod report;
pub mod swatches;
pub mod theme;
pub mod toasts;
pub mod widgets;

pub use action::{Action, FileAction, Tab, ViewAction, WindowAction};
pub use context::Context;
