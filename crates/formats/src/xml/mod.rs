//! XML documents: the lossless document layer, and the native scenes and views.
//!
//! [`Document`] turns bytes into a source text with a flat table of its nodes. Everything that reads XML walks it.

mod document;
mod encoding;
mod problem;
mod reference;
mod scan;
mod syntax;

pub use document::{Attribute, Attributes, Children, Document, Element, Malformed, Node, Text};
pub use encoding::Encoding;
pub use problem::{Excerpt, XmlProblem};
pub use reference::escape;
pub use syntax::{Byte, CodePoint, SyntaxProblem};

/// Elements nested deeper than this are refused. A legal scene nests four deep.
pub const MAX_DEPTH: usize = 64;
