//! Opening files: what a file holds is found out by looking into it, on whatever thread the caller likes. Nothing of a
//! document changes until it is handed the result, so a broken file leaves everything as it was.

use lancer_formats::load::{self, FolderOfDocument, LoadError, LoadOptions, Loaded};
use lancer_formats::mesh::{self, MeshFiles};
use lancer_formats::xml::{self, StructureProblem, XmlProblem};
use lancer_formats::{Diagnostic, Problem, Severity, Source, nff};
use lancer_scene::{MeshGeometry, Scene, Views};
use std::ffi::OsStr;
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;

/// What a file turned out to hold.
#[derive(Clone, Debug)]
pub enum Content {
    /// A scene.
    Scene(Box<SceneFile>),
    /// Views.
    Views(Box<ViewsFile>),
    /// The geometry of one object.
    Mesh(MeshFile),
}

/// A legal scene and the file that it was read from.
#[derive(Clone, Debug)]
pub struct SceneFile {
    /// The scene.
    pub scene: Scene,
    /// The file.
    pub on_disk: OnDisk,
    /// What is odd about it: warnings only.
    pub warnings: Warnings,
    /// Whether the file holds views too.
    pub holds_views: bool,
}

/// Legal views and the file that they were read from.
#[derive(Clone, Debug)]
pub struct ViewsFile {
    /// The views.
    pub views: Views,
    /// The file.
    pub on_disk: OnDisk,
    /// What is odd about it: warnings only.
    pub warnings: Warnings,
}

/// A mesh file that can be added to a scene.
#[derive(Clone, Debug)]
pub struct MeshFile {
    /// The file.
    pub path: PathBuf,
    /// Its geometry, with its own materials as parts.
    pub geometry: Arc<MeshGeometry>,
    /// What is odd about it: warnings only.
    pub warnings: Warnings,
}

/// What is odd about a file, with the text that it is about.
#[derive(Clone, Debug)]
pub struct Warnings {
    /// What was found, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// The text; empty for a file that is no text.
    pub source: Source,
}

/// A file as it was read or written last.
#[derive(Clone, Debug)]
pub struct OnDisk {
    /// Its path as the user gave it.
    pub path: PathBuf,
    /// What kind of file it is.
    pub kind: FileKind,
    /// The document that is patched when it is saved, so that comments and spacing stay.
    pub(crate) document: Option<xml::Document>,
    stamp: Option<Stamp>,
}

/// The kinds of files that scenes and views are read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FileKind {
    /// A native document.
    Native,
    /// A binary scene.
    Binary,
    /// A document of 2009 or an NFF file: it is read, and saved as a native one under another name.
    Foreign,
}

/// What tells that a file has changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Stamp {
    modified: Option<SystemTime>,
    bytes: u64,
}

impl Stamp {
    fn of(path: &Path) -> Option<Stamp> {
        let found = fs::metadata(path).ok()?;
        Some(Stamp { modified: found.modified().ok(), bytes: found.len() })
    }
}

impl OnDisk {
    /// A file that was just read or written.
    pub(crate) fn now(path: PathBuf, kind: FileKind, document: Option<xml::Document>) -> OnDisk {
        let stamp = Stamp::of(&path);
        OnDisk { path, kind, document, stamp }
    }

    /// Whether another program has written the file since; not if it is gone.
    pub fn changed_outside(&self) -> bool {
        Stamp::of(&self.path).is_some_and(|stamp| Some(stamp) != self.stamp)
    }
}

/// Why a file is not opened.
#[derive(Clone, Debug)]
pub enum OpenError {
    /// The system does not give it.
    Unreadable(LoadError),
    /// It breaks rules.
    Broken {
        /// Everything that was found, warnings too, in the order of the text.
        diagnostics: Vec<Diagnostic>,
        /// The text that it is about; empty for a file that is no text.
        source: Source,
    },
}

pub use lancer_formats::mesh::EXTENSIONS as MESH_EXTENSIONS;

/// Reads a file of any kind that the editor knows.
///
/// # Errors
/// Why it cannot be opened.
pub fn read(path: &Path, options: &LoadOptions) -> Result<Content, OpenError> {
    // whatever else is a scene or views by its content
    if mesh::is_mesh(path) {
        return read_mesh(path, options).map(Content::Mesh);
    }
    match read_scene(path, options) {
        Ok(scene) => Ok(Content::Scene(Box::new(scene))),
        Err(OpenError::Broken { diagnostics, .. }) if diagnostics.iter().any(is_views) => {
            read_views(path, options).map(|views| Content::Views(Box::new(views)))
        }
        Err(error) => Err(error),
    }
}

/// Whether a reader of scenes says that the document holds views.
fn is_views(diagnostic: &Diagnostic) -> bool {
    diagnostic.problem == Problem::Xml(XmlProblem::Structure(StructureProblem::ViewsForScene))
}

/// Reads a scene.
///
/// # Errors
/// Why it cannot be opened.
pub fn read_scene(path: &Path, options: &LoadOptions) -> Result<SceneFile, OpenError> {
    let loaded = load::load_scene(path, options).map_err(OpenError::Unreadable)?;
    let (scene, on_disk, warnings) = legal(path, loaded)?;
    let holds_views = nff::is_nff(warnings.source.text.as_bytes());
    Ok(SceneFile { scene, on_disk, warnings, holds_views })
}

/// Reads views.
///
/// # Errors
/// Why they cannot be opened.
pub fn read_views(path: &Path, options: &LoadOptions) -> Result<ViewsFile, OpenError> {
    let loaded = load::load_views(path, options).map_err(OpenError::Unreadable)?;
    let (views, on_disk, warnings) = legal(path, loaded)?;
    Ok(ViewsFile { views, on_disk, warnings })
}

fn legal<T>(path: &Path, loaded: Loaded<T>) -> Result<(T, OnDisk, Warnings), OpenError> {
    let broken = loaded.has_errors();
    let Loaded { value, diagnostics, source, document } = loaded;
    match value.filter(|_| !broken) {
        Some(value) => {
            let kind = match &document {
                Some(_) => FileKind::Native,
                None if source.text.is_empty() => FileKind::Binary,
                None => FileKind::Foreign,
            };
            Ok((value, OnDisk::now(path.to_owned(), kind, document), Warnings { diagnostics, source }))
        }
        None => Err(OpenError::Broken { diagnostics, source }),
    }
}

/// Reads a mesh file. The files that it names are looked for at and below its folder.
///
/// # Errors
/// Why it cannot be opened.
pub fn read_mesh(path: &Path, options: &LoadOptions) -> Result<MeshFile, OpenError> {
    let source = Source { name: path.to_string_lossy().into(), text: "".into() };
    let name = path.file_name().map(OsStr::to_string_lossy).unwrap_or_default();
    match FolderOfDocument::new(path, *options).read(&name) {
        Ok(file) => {
            let warning =
                |problem| Diagnostic { severity: Severity::Warning, span: None, problem: Problem::Mesh(problem) };
            let diagnostics = file.warnings.iter().cloned().map(warning).collect();
            let warnings = Warnings { diagnostics, source };
            Ok(MeshFile { path: path.to_owned(), geometry: file.geometry, warnings })
        }
        Err(problem) => Err(OpenError::Broken { diagnostics: vec![Diagnostic::error(None, problem)], source }),
    }
}

/// The name by which a scene at `scene` finds a file at or below its folder; `None` for one elsewhere, or whose name is
/// no text.
pub fn name_below(scene: &Path, file: &Path) -> Option<Arc<str>> {
    let folder = match scene.parent() {
        Some(folder) if folder != Path::new("") => folder,
        Some(_) | None => Path::new("."),
    };
    let (folder, file) = (fs::canonicalize(folder).ok()?, fs::canonicalize(file).ok()?);
    let parts = file.strip_prefix(folder).ok()?.components().map(|part| match part {
        Component::Normal(name) => name.to_str(),
        Component::Prefix(_) | Component::RootDir | Component::CurDir | Component::ParentDir => None,
    });
    Some(parts.collect::<Option<Vec<&str>>>()?.join("/").into())
}

/// Where the views of a scene stand that are opened with it: `first.view.xml` beside `first.xml`, unless the file holds
/// them itself, as an NFF file does.
pub fn views_with(scene: &SceneFile) -> PathBuf {
    if scene.holds_views { scene.on_disk.path.clone() } else { views_beside(&scene.on_disk.path) }
}

/// Where the views of a scene are saved first: `first.view.xml` beside `first.xml`.
pub fn views_beside(scene: &Path) -> PathBuf {
    scene.with_extension("view.xml")
}
