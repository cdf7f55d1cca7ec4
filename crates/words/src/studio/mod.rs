//! What the editor says.

pub mod app;
pub mod explain;
pub mod menu;
pub mod panels;
pub mod view;
