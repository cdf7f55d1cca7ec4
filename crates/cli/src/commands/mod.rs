//! The commands, one file each: what its arguments are, and what it does with them.

pub(crate) mod bench;
pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod convert;
pub(crate) mod diff;
pub(crate) mod explain;
pub(crate) mod generate;
pub(crate) mod help;
pub(crate) mod man;
pub(crate) mod render;
pub(crate) mod schema;
pub(crate) mod show;
