//! The panels: each is a function of what it may read, and returns what the user wants.

pub mod history;
pub mod outliner;
pub mod problems;
pub mod properties;
pub mod text;
pub mod xml;
