//! The mesh files that a scene document names, opened within its folder.
//!
//! A document may come from anywhere, so it must not make the program look at the rest of the disk. A path is followed
//! only if it stays at or below the document's folder, both as it is written and after all its links.

use super::file::{self, LoadCause};
use super::{LoadOptions, STANDARD};
use crate::mesh::{self, FilesBeside, MeshFault, MeshFile, MeshFiles, MeshProblem};
use crate::progress;
use lancer_scene::{Mesh, Object, Placement, Scene, Shape};
use std::collections::HashMap;
use std::fs;
use std::path::{Component, Path, PathBuf};

/// The folder of a document. A file that is named twice is read once, and its geometry shared.
#[derive(Debug)]
pub struct FolderOfDocument {
    folder: PathBuf,
    options: LoadOptions,
    read: HashMap<PathBuf, Result<MeshFile, MeshProblem>>,
}

impl FolderOfDocument {
    /// The folder of a document; that of standard input is the current one.
    pub fn new(document: &Path, options: LoadOptions) -> FolderOfDocument {
        let folder = match document.parent() {
            Some(folder) if folder != Path::new("") && document != Path::new(STANDARD) => folder.to_owned(),
            _ => PathBuf::from("."),
        };
        FolderOfDocument { folder, options, read: HashMap::new() }
    }

    /// Where a path leads, relative to the folder; the path without links, if it may be followed.
    fn follow(&self, path: &Path) -> Result<PathBuf, MeshFault> {
        if !self.options.allow_outside && leaves_folder(path) {
            return Err(MeshFault::Outside);
        }
        let folder = fs::canonicalize(&self.folder).map_err(|error| fault(error.into()))?;
        let target = fs::canonicalize(folder.join(path)).map_err(|error| fault(error.into()))?;
        if !self.options.allow_outside && !target.starts_with(&folder) {
            return Err(MeshFault::Outside);
        }
        Ok(target)
    }
}

impl MeshFiles for FolderOfDocument {
    fn read(&mut self, path: &str) -> Result<MeshFile, MeshProblem> {
        let problem = |fault| MeshProblem { file: path.into(), line: None, fault };
        let target = self.follow(Path::new(path)).map_err(problem)?;
        if let Some(known) = self.read.get(&target) {
            // What is odd about a file was said where it was named first.
            let mut file = known.clone()?;
            file.warnings = [].into();
            return Ok(file);
        }
        let result = progress::aside(|| {
            let bytes = file::regular(&target, self.options.most_bytes).map_err(|cause| problem(fault(cause)))?;
            let mut beside = FolderOfMesh { document: self, folder: Path::new(path).parent().unwrap_or(Path::new("")) };
            mesh::read(path, &bytes, &mut beside)
        });
        self.read.insert(target, result.clone());
        result
    }
}

/// The scene of one object that a mesh file is by itself. Its normals, if it has any, are used.
pub(super) fn scene_of(
    path: &Path,
    bytes: &[u8],
    options: LoadOptions,
) -> Result<(Scene, Vec<MeshProblem>), MeshProblem> {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let mut document = FolderOfDocument::new(path, options);
    let mut beside = FolderOfMesh { document: &mut document, folder: Path::new("") };
    let file = mesh::read(&name, bytes, &mut beside)?;
    let mesh = Mesh {
        smooth: !file.geometry.normals.is_empty(),
        geometry: file.geometry,
        source: Some(name.into()),
        placement: Placement::default(),
    };
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().trim().to_owned()).unwrap_or_default();
    let object = Object::new(stem, Shape::Mesh(mesh));
    // a file may have a name that no object can have
    let object = if object.check().is_ok() { object } else { Object { name: "mesh 1".into(), ..object } };
    Ok((Scene { objects: [object].into_iter().collect(), ..Scene::default() }, file.warnings.to_vec()))
}

/// The folder of a mesh file, within that of its document.
struct FolderOfMesh<'a> {
    document: &'a FolderOfDocument,
    /// Relative to the document's folder.
    folder: &'a Path,
}

impl FilesBeside for FolderOfMesh<'_> {
    fn read(&mut self, path: &str) -> Result<Vec<u8>, MeshFault> {
        let target = self.document.follow(&self.folder.join(path))?;
        progress::aside(|| file::regular(&target, self.document.options.most_bytes)).map_err(fault)
    }
}

/// Whether a path is absolute or climbs above where it starts.
fn leaves_folder(path: &Path) -> bool {
    let mut depth = 0_usize;
    for component in path.components() {
        match component {
            Component::Prefix(_) | Component::RootDir => return true,
            Component::CurDir => {}
            Component::Normal(_) => depth += 1,
            Component::ParentDir if depth == 0 => return true,
            Component::ParentDir => depth -= 1,
        }
    }
    false
}

/// Why a mesh file cannot be read.
fn fault(cause: LoadCause) -> MeshFault {
    match cause {
        LoadCause::Missing => MeshFault::Missing,
        LoadCause::IsAFolder | LoadCause::NotAFile => MeshFault::NotAFile,
        LoadCause::Forbidden => MeshFault::Forbidden,
        LoadCause::TooLarge { most } => MeshFault::TooLarge { most },
        LoadCause::NoMemory => MeshFault::NoMemory,
        LoadCause::LinksInACircle => MeshFault::LinksInACircle,
        LoadCause::NameTooLong => MeshFault::NameTooLong,
        LoadCause::Other(cause) => MeshFault::Unreadable(cause),
    }
}
