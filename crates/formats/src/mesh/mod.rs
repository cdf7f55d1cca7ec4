//! Mesh files: what `mesh @src` of a scene document names.
//!
//! A reader takes the bytes of one file and gives [`MeshGeometry`] as `lancer-scene` means it: finite positions,
//! triangles whose vertices exist, the file's normals, and the file's own materials as parts. The files themselves are
//! opened by [`crate::load`] alone, behind the trait [`MeshFiles`].

use crate::Describe;
use lancer_scene::MeshGeometry;
use lancer_words::{Lang, mesh as words};
use std::sync::{Arc, OnceLock};

/// Where the reader of a scene document gets its mesh files from.
pub trait MeshFiles {
    /// The mesh of a file; `path` is the text of `mesh @src`, relative to the document.
    ///
    /// # Errors
    /// Why the file cannot be opened or what is wrong with it.
    fn read(&mut self, path: &str) -> Result<MeshFile, MeshProblem>;
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

/// What is wrong with a mesh file. It is told at the place in the document that names the file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshProblem {
    /// The file, as the document names it.
    pub file: Arc<str>,
    /// The line it is about, from 1, in a format that has lines.
    pub line: Option<usize>,
    /// What is wrong.
    pub fault: MeshFault,
}

/// The faults of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub enum MeshFault {
    /// There is no such file.
    Missing,
    /// The system refuses to read it; its own words.
    Unreadable(String),
    /// It is a folder, a pipe or a device.
    NotAFile,
    /// It lies outside the document's folder.
    Outside,
}

impl Describe for MeshProblem {
    fn code(&self) -> &'static str {
        match self.fault {
            MeshFault::Missing => "mesh::missing",
            MeshFault::Unreadable(_) => "mesh::unreadable",
            MeshFault::NotAFile => "mesh::not-a-file",
            MeshFault::Outside => "mesh::outside",
        }
    }

    fn message(&self, lang: Lang) -> String {
        let fault = match &self.fault {
            MeshFault::Missing => words::missing(lang),
            MeshFault::Unreadable(cause) => words::unreadable(lang, cause),
            MeshFault::NotAFile => words::not_a_file(lang),
            MeshFault::Outside => words::outside(lang),
        };
        match self.line {
            Some(line) => words::in_line(lang, &self.file, line, fault),
            None => words::in_file(lang, &self.file, fault),
        }
    }

    fn label(&self, lang: Lang) -> String {
        words::named_here(lang)
    }

    fn help(&self, lang: Lang) -> Option<String> {
        match &self.fault {
            MeshFault::Missing => Some(words::missing_help(lang)),
            MeshFault::Unreadable(_) => None,
            MeshFault::NotAFile => Some(words::not_a_file_help(lang)),
            MeshFault::Outside => Some(words::outside_help(lang)),
        }
    }
}
