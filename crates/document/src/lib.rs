//! The document of the editor without its window.
//!
//! A [`Document`] holds a scene and its views, the steps that led there, what is selected, and the files it came from.
//! Panels read it and give it edits; nothing else changes it. Every change gives a new revision, so that whoever shows
//! the document knows what is stale.

mod document;
mod gesture;
mod history;
mod selection;
mod step;

pub use document::Document;
pub use history::History;
pub use selection::{Item, Selection};
pub use step::StepName;
