//! The desktop editor: live views of one scene, every edit visible in all of them at once.
//!
//! A panel is a function of a [`Context`] that returns [`Action`]s; they are carried out in one place, which alone
//! changes the document. Pictures come from the sessions of `lancer-render`; the window never traces a ray and never
//! waits for one.

pub mod action;
pub mod app;
pub mod arguments;
mod bars;
mod beside;
pub mod chrome;
pub mod context;
pub mod dialogs;
pub mod entry;
pub mod explainer;
mod export;
pub mod fields;
mod files;
mod foreign;
mod frame;
pub mod kind;
pub mod launch;
pub mod layout;
pub mod menus;
mod modals;
pub mod panels;
mod perform;
mod pictures;
mod questions;
mod reading;
pub mod report;
pub mod settings;
pub mod story;
pub mod swatches;
pub mod theme;
mod tiles;
pub mod toasts;
pub mod told;
pub mod view;
pub mod welcome;
pub mod widgets;
mod writing;

pub use action::{Action, Exported, FileAction, Tab, ViewAction, WindowAction};
pub use app::{Start, Studio};
pub use context::Context;
