//! Mesh files: what `mesh @src` of a scene document names.
//!
//! A reader takes the bytes of one file and gives [`MeshGeometry`] as `lancer-scene` means it: finite positions,
//! triangles whose vertices exist, the file's normals, and the file's own materials as parts. The readers are our own,
//! because a message has to name the line and the rule, in the reader's language, and because no header may make them
//! take more memory than about ten times the file. The files themselves are opened by [`crate::load`] alone, behind
//! the traits [`MeshFiles`] and [`FilesBeside`].

mod builder;
mod gltf;
mod mtl;
mod obj;
mod ply;
mod problem;
mod stl;
mod triangulate;
mod words;

pub use problem::{MeshFault, MeshProblem};

pub(crate) use triangulate::triangulate;

use builder::Builder;
use lancer_scene::MeshGeometry;
use std::path::Path;
use std::sync::{Arc, OnceLock};

/// So many warnings about one file are told; the rest would say the same.
const MOST_WARNINGS: usize = 20;

/// The extensions of mesh files; whatever else is a scene or views by its content.
pub const EXTENSIONS: [&str; 5] = ["obj", "ply", "stl", "gltf", "glb"];

/// Whether a path names a mesh file, by its extension.
pub fn is_mesh(path: &Path) -> bool {
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    extension.is_some_and(|extension| EXTENSIONS.contains(&&*extension))
}

/// Where the reader of a scene document gets its mesh files from.
pub trait MeshFiles {
    /// The mesh of a file; `path` is the text of `mesh @src`, relative to the document.
    ///
    /// # Errors
    /// Why the file cannot be opened or what is wrong with it.
    fn read(&mut self, path: &str) -> Result<MeshFile, MeshProblem>;
}

/// Where the reader of a mesh file gets the files that this file names: materials and buffers.
pub trait FilesBeside {
    /// The bytes of a file; `path` is relative to the mesh file.
    ///
    /// # Errors
    /// Why the file cannot be opened.
    fn read(&mut self, path: &str) -> Result<Vec<u8>, MeshFault>;
}

/// A mesh file that was read. A clone shares everything.
#[derive(Clone, Debug)]
pub struct MeshFile {
    /// The geometry, with the file's own materials as parts.
    pub geometry: Arc<MeshGeometry>,
    /// What is odd about the file without making it useless.
    pub warnings: Arc<[MeshProblem]>,
    plain: Arc<OnceLock<Arc<MeshGeometry>>>,
}

impl MeshFile {
    /// A file's geometry and warnings.
    pub fn new(geometry: MeshGeometry, warnings: Vec<MeshProblem>) -> MeshFile {
        MeshFile { geometry: Arc::new(geometry), warnings: warnings.into(), plain: Arc::default() }
    }

    /// The geometry without the file's own materials, for an object that has a material; made once and shared.
    pub fn without_materials(&self) -> Arc<MeshGeometry> {
        if self.geometry.parts.is_empty() {
            return Arc::clone(&self.geometry);
        }
        let plain = || Arc::new(MeshGeometry { parts: Vec::new(), ..MeshGeometry::clone(&self.geometry) });
        Arc::clone(self.plain.get_or_init(plain))
    }
}

/// Reads a mesh file; the extension of its name decides the format.
///
/// # Errors
/// What is wrong with it.
pub fn read(file: &str, bytes: &[u8], beside: &mut dyn FilesBeside) -> Result<MeshFile, MeshProblem> {
    let mut input = Input { file: file.into(), bytes, beside, warnings: Vec::new() };
    let extension = Path::new(file).extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    let builder = match extension.as_deref() {
        Some("obj") => obj::read(&mut input)?,
        Some("ply") => ply::read(&input)?,
        Some("stl") => stl::read(&input)?,
        Some("gltf" | "glb") => gltf::read(&mut input)?,
        other => {
            let extension = other.map(|extension| format!(".{extension}")).unwrap_or_default();
            return Err(input.at(None, MeshFault::UnknownFormat(extension)));
        }
    };
    let (geometry, normals_left_out) = builder.finish().map_err(|fault| input.at(None, fault))?;
    if normals_left_out {
        input.warn(None, MeshFault::NormalsLeftOut);
    }
    Ok(MeshFile::new(geometry, input.warnings))
}

/// A file as a reader gets it.
struct Input<'a> {
    file: Arc<str>,
    bytes: &'a [u8],
    beside: &'a mut dyn FilesBeside,
    warnings: Vec<MeshProblem>,
}

impl Input<'_> {
    /// A problem in this file.
    fn at(&self, line: impl Into<Option<usize>>, fault: MeshFault) -> MeshProblem {
        MeshProblem { file: Arc::clone(&self.file), line: line.into(), fault }
    }

    /// Adds a warning about this file.
    fn warn(&mut self, line: impl Into<Option<usize>>, fault: MeshFault) {
        let warning = self.at(line, fault);
        self.pass_on([warning]);
    }

    /// Adds warnings about any file, as long as there are not too many.
    fn pass_on(&mut self, warnings: impl IntoIterator<Item = MeshProblem>) {
        let room = MOST_WARNINGS.saturating_sub(self.warnings.len());
        self.warnings.extend(warnings.into_iter().take(room));
    }

    /// The name of a file beside this one, as the document would name it.
    fn name_beside(&self, path: &str) -> Arc<str> {
        match self.file.rsplit_once('/') {
            Some((folder, _)) if !path.starts_with('/') => format!("{folder}/{path}").into(),
            _ => path.into(),
        }
    }
}
