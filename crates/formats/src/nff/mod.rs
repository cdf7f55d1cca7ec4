//! The Neutral File Format of Eric Haines (version 3.1, 1992): a scene and its view in one file, which therefore serves
//! as both. It is the format of the Standard Procedural Databases.
//!
//! A file is a list of entities, each begun by a word; numbers follow, over as many lines as one likes. What the format
//! leaves open is decided as its author's text on those databases says, and told in the manual (`docs/scene-format.md`).

mod entities;
mod problem;
mod scene;
mod tokens;
mod view;

pub use problem::NffProblem;

use crate::{Diagnostic, Outcome, Severity, Source};
use entities::Entities;
use lancer_scene::{Scene, Views};
use std::sync::Arc;

/// The words that begin an entity.
const ENTITIES: [&str; 8] = ["v", "b", "l", "f", "s", "c", "p", "pp"];

/// A file that was read: its scene and its view, each with what there is to say about it.
#[derive(Clone, Debug)]
pub struct NffFile {
    /// The text that the diagnostics are about.
    pub source: Source,
    /// The scene.
    pub scene: Outcome<Scene>,
    /// The one view.
    pub views: Outcome<Views>,
}

/// Whether a file is in this format, by its first word: one that begins an entity, a `v` only if `from` follows it.
pub fn is_nff(bytes: &[u8]) -> bool {
    let is_entity = |word: &[u8]| ENTITIES.iter().any(|entity| entity.as_bytes() == word);
    let mut words = bytes
        .split(|byte| matches!(byte, b'\n' | b'\r'))
        .map(|line| line.split(|byte| *byte == b'#').next().unwrap_or_default())
        .flat_map(|line| line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()));
    match words.next() {
        Some(b"v") => words.next() == Some(b"from"),
        Some(word) => is_entity(word),
        None => false,
    }
}

/// Reads a file under the name that messages give it.
pub fn read(name: impl Into<Arc<str>>, bytes: &[u8]) -> NffFile {
    let source = Source { name: name.into(), text: String::from_utf8_lossy(bytes).into() };
    let mut entities = Entities::of(&source.text);
    let mut scene = scene::Builder::new(source.text.len());
    while let Some(entity) = entities.next_entity(&mut scene.sink) {
        scene.add(entity);
    }
    let views = view::read(scene.view.take(), &mut scene.sink);
    let (scene, of_scene, of_view) = scene.finish();
    NffFile { source, scene: outcome(Some(scene), of_scene), views: outcome(views, of_view) }
}

/// The value, unless some diagnostic is an error.
fn outcome<T>(value: Option<T>, diagnostics: Vec<Diagnostic>) -> Outcome<T> {
    let sound = diagnostics.iter().all(|found| found.severity != Severity::Error);
    Outcome { value: value.filter(|_| sound), diagnostics }
}
