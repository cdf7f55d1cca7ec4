//! Opening files for reading: the one place where it happens.
//!
//! What a file is, is decided by its first bytes and its root element, never by its name. Only regular files are
//! opened: a folder, a pipe or a device is refused before it can make the program wait. A scene document may name
//! meshes; these are opened within its folder alone, unless the user allows more.

mod file;
mod meshes;

pub use file::{LoadCause, LoadError, STANDARD};
pub use meshes::FolderOfDocument;

use crate::xml::{Document, DocumentKind, StructureProblem, XmlProblem};
use crate::{Diagnostic, Outcome, Problem, Severity, Source, binary, mesh, n7_2009, nff, picture, xml};
use lancer_scene::{Picture, Scene, Views};
use std::path::Path;

/// How files are opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LoadOptions {
    /// Whether a document may name files outside its folder.
    pub allow_outside: bool,
    /// Larger files are refused.
    pub most_bytes: u64,
}

impl Default for LoadOptions {
    fn default() -> LoadOptions {
        LoadOptions { allow_outside: false, most_bytes: 4 << 30 }
    }
}

/// A file that was opened and read: what it holds as far as that is legal, and everything there is to say about it.
#[derive(Clone, Debug)]
pub struct Loaded<T> {
    /// What it holds; `None` if some diagnostic is an error.
    pub value: Option<T>,
    /// What was found, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// The text that the diagnostics are about; empty for a file that is no text.
    pub source: Source,
    /// The document of a native scene or of native views, to be patched when it is saved.
    pub document: Option<Document>,
}

impl<T> Loaded<T> {
    /// Whether the file breaks a rule.
    pub fn has_errors(&self) -> bool {
        self.value.is_none() || self.diagnostics.iter().any(|found| found.severity == Severity::Error)
    }

    /// A file without a text.
    fn bytes(path: &Path, value: Result<T, impl Into<Problem>>) -> Loaded<T> {
        let source = Source { name: name_of(path), text: "".into() };
        let (value, diagnostics) = match value {
            Ok(value) => (Some(value), Vec::new()),
            Err(problem) => (None, vec![Diagnostic::error(None, problem)]),
        };
        Loaded { value, diagnostics, source, document: None }
    }
}

/// Loads a scene: a binary one, a native document, a document of 2009, an NFF file, or a mesh
/// file, which is a scene of one object. The path `-` means standard input.
///
/// # Errors
/// Why the file cannot be read at all; what is wrong with its content stands in the result.
pub fn load_scene(path: &Path, options: &LoadOptions) -> Result<Loaded<Scene>, LoadError> {
    let bytes = file::read(path, options.most_bytes)?;
    if binary::is_binary(&bytes) {
        return Ok(Loaded::bytes(path, binary::read_scene(&bytes)));
    }
    if mesh::is_mesh(path) {
        let (value, warnings) = match meshes::scene_of(path, &bytes, *options) {
            Ok((scene, warnings)) => (Ok(scene), warnings),
            Err(problem) => (Err(problem), Vec::new()),
        };
        let warnings = warnings.into_iter().map(|warning| Diagnostic::warning(None, warning));
        let mut loaded = Loaded::bytes(path, value);
        loaded.diagnostics.extend(warnings);
        return Ok(loaded);
    }
    if nff::is_nff(&bytes) {
        let nff::NffFile { source, scene, .. } = nff::read(name_of(path), &bytes);
        return Ok(Loaded { value: scene.value, diagnostics: scene.diagnostics, source, document: None });
    }
    let mut files = FolderOfDocument::new(path, *options);
    Ok(document(path, &bytes, DocumentKind::Scene, |document| match document.kind() {
        Some(DocumentKind::Scene2009) => n7_2009::read_scene(document),
        Some(DocumentKind::Scene | DocumentKind::Views | DocumentKind::Views2009) | None => {
            xml::read_scene(document, &mut files)
        }
    }))
}

/// Loads views: a native document, one of 2009, or the view of an NFF file. The path `-` means standard input.
///
/// # Errors
/// Why the file cannot be read at all; what is wrong with its content stands in the result.
pub fn load_views(path: &Path, options: &LoadOptions) -> Result<Loaded<Views>, LoadError> {
    let bytes = file::read(path, options.most_bytes)?;
    if binary::is_binary(&bytes) {
        return Ok(Loaded::bytes(path, Err(XmlProblem::from(StructureProblem::SceneForViews))));
    }
    if nff::is_nff(&bytes) {
        let nff::NffFile { source, views, .. } = nff::read(name_of(path), &bytes);
        return Ok(Loaded { value: views.value, diagnostics: views.diagnostics, source, document: None });
    }
    Ok(document(path, &bytes, DocumentKind::Views, |document| match document.kind() {
        Some(DocumentKind::Views2009) => n7_2009::read_views(document),
        Some(DocumentKind::Views | DocumentKind::Scene | DocumentKind::Scene2009) | None => xml::read_views(document),
    }))
}

/// Reads an XML document. It is kept if it is native and of the kind that is due.
fn document<T>(path: &Path, bytes: &[u8], due: DocumentKind, read: impl FnOnce(&Document) -> Outcome<T>) -> Loaded<T> {
    match Document::read(name_of(path), bytes) {
        Ok(document) => {
            let Outcome { value, diagnostics } = read(&document);
            let source = document.source().clone();
            let document = (document.kind() == Some(due)).then_some(document);
            Loaded { value, diagnostics, source, document }
        }
        Err(malformed) => {
            let (source, diagnostics) = (malformed.source, vec![malformed.diagnostic]);
            Loaded { value: None, diagnostics, source, document: None }
        }
    }
}

/// Loads a picture of any format that can be written.
///
/// # Errors
/// Why the file cannot be read at all; what is wrong with its content stands in the result.
pub fn load_picture(path: &Path, options: &LoadOptions) -> Result<Loaded<Picture>, LoadError> {
    /// So much of a picture in bytes may be its header.
    const HEADER: usize = 1024;
    let bytes = file::read(path, options.most_bytes)?;
    let name = name_of(path);
    let loaded = |value, diagnostics, text: String| Loaded {
        value,
        diagnostics,
        source: Source { name, text: text.into() },
        document: None,
    };
    Ok(match picture::read(&bytes) {
        Ok(picture) => loaded(Some(picture), Vec::new(), String::new()),
        Err(mut wrong) => {
            // A pixmap's header, and all of a plain one, is text for the report; its spans count bytes.
            let shown = if bytes.starts_with(b"P3") { &bytes[..] } else { &bytes[..bytes.len().min(HEADER)] };
            wrong.span = wrong.span.filter(|span| span.end <= shown.len());
            let text = if wrong.span.is_none() { String::new() } else { as_ascii(shown) };
            loaded(None, vec![wrong], text)
        }
    })
}

/// The bytes as a text of as many characters.
fn as_ascii(bytes: &[u8]) -> String {
    let shown = |byte: &u8| if byte.is_ascii_graphic() || byte.is_ascii_whitespace() { char::from(*byte) } else { '?' };
    bytes.iter().map(shown).collect()
}

/// The path as messages give it.
fn name_of(path: &Path) -> std::sync::Arc<str> {
    path.to_string_lossy().into()
}
