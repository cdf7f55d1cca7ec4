//! XML documents: the lossless document layer, and the native scenes and views.
//!
//! [`Document`] turns bytes into a source text with a flat table of its nodes. Everything that reads XML walks it.

mod contents;
mod document;
mod encoding;
mod fields;
mod kind;
mod naming;
mod nearest;
mod number;
mod patch;
mod problem;
mod read_mesh;
mod read_scene;
mod read_views;
mod reference;
mod root;
mod rule;
mod scan;
mod schema;
pub(crate) mod sink;
mod structure;
mod syntax;
mod value;
mod values;
pub mod vocabulary;
mod write;

pub use document::{Attribute, Attributes, Children, Document, Element, Malformed, Node, Text};
pub use encoding::Encoding;
pub use naming::AutomaticNames;
pub use number::{Number, Numbers, Written, shortest};
pub use patch::{patch_scene, patch_views};
pub use problem::{Excerpt, Guess, XmlProblem};
pub use read_scene::read_scene;
pub use read_views::read_views;
pub use reference::escape;
pub use root::DocumentKind;
pub use schema::schema;
pub use structure::StructureProblem;
pub use syntax::{Byte, CodePoint, SyntaxProblem};
pub use value::{Due, ValueProblem};
pub use write::{write_scene, write_views};

/// Elements nested deeper than this are refused. A legal scene nests four deep.
pub const MAX_DEPTH: usize = 64;
