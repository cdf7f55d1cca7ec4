//! The document of the editor without its window.
//!
//! A [`Document`] holds a scene and its views, the steps that led there, what is selected, and the files it came from.
//! Panels read it and give it edits; nothing else changes it. Every change gives a new revision, so that whoever shows
//! the document knows what is stale.
//!
//! What a menu, a key or the pointer does is worked out by functions of the stage that give a [`Command`] or an edit:
//! [`insert`], [`arrange`], [`attribute`], [`gizmo`]; by [`navigate`] for the eye. They know no window and can be
//! tested without one. Files are read by [`open`] and written by [`saving`], on whatever thread; [`journal`] keeps the
//! last step for the case of a crash.

pub mod arrange;
pub mod attribute;
mod command;
mod decimal;
mod document;
mod files;
mod gesture;
pub mod gizmo;
mod history;
pub mod insert;
pub mod journal;
mod naming;
pub mod navigate;
pub mod number;
pub mod open;
pub mod presets;
pub mod saving;
mod selection;
mod sight;
mod silhouette;
mod step;
pub mod wireframe;

pub use command::Command;
pub use document::Document;
pub use gizmo::Axis;
pub use history::History;
pub use selection::{Item, Selection};
pub use sight::{Focus, focus};
pub use step::StepName;
