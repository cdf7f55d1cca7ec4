//! Saving: what is to be written is taken from the document at once and can be written on any thread; the document hears
//! of it when it is on the disk.

use crate::open::{FileKind, OnDisk};
use lancer_formats::load::LoadOptions;
use lancer_formats::save::{self, Origin, SaveError, SceneFormat};
use lancer_formats::xml;
use lancer_scene::{Scene, Views};
use std::path::{Path, PathBuf};

/// A scene on its way to the disk.
#[derive(Clone, Debug)]
pub struct SavingScene {
    pub(crate) scene: Scene,
    pub(crate) format: SceneFormat,
    pub(crate) path: PathBuf,
    /// The file that the names of meshes are relative to.
    pub(crate) origin: Option<PathBuf>,
    pub(crate) document: Option<xml::Document>,
    pub(crate) options: LoadOptions,
}

/// A scene that is on the disk.
#[derive(Clone, Debug)]
pub struct SavedScene {
    pub(crate) scene: Scene,
    pub(crate) on_disk: OnDisk,
}

impl SavingScene {
    /// The bytes of the file. A native document that was read keeps its comments, order and spacing.
    pub fn bytes(&self) -> Vec<u8> {
        let origin = self.origin.as_deref().map(|path| Origin { path, document: self.document.as_ref() });
        save::scene_bytes(&self.scene, self.format, &self.path, origin, self.options)
    }

    /// Writes the file: beside its place, then moved there.
    ///
    /// # Errors
    /// Why it cannot be written; the old file is then whole.
    pub fn write(self) -> Result<SavedScene, SaveError> {
        let bytes = self.bytes();
        save::save(&self.path, |out| out.write_all(&bytes))?;
        let (kind, document) = match self.format {
            SceneFormat::Xml => (FileKind::Native, document(&self.path, &bytes)),
            SceneFormat::Binary => (FileKind::Binary, None),
        };
        Ok(SavedScene { scene: self.scene, on_disk: OnDisk::now(self.path, kind, document) })
    }
}

/// Views on their way to the disk.
#[derive(Clone, Debug)]
pub struct SavingViews {
    pub(crate) views: Views,
    pub(crate) path: PathBuf,
    pub(crate) document: Option<xml::Document>,
}

/// Views that are on the disk.
#[derive(Clone, Debug)]
pub struct SavedViews {
    pub(crate) views: Views,
    pub(crate) on_disk: OnDisk,
}

impl SavingViews {
    /// The bytes of the file. A native document that was read keeps its comments, order and spacing.
    pub fn bytes(&self) -> Vec<u8> {
        match &self.document {
            Some(document) => xml::patch_views(document, &self.views),
            None => xml::write_views(&self.views).into_bytes(),
        }
    }

    /// Writes the file: beside its place, then moved there.
    ///
    /// # Errors
    /// Why it cannot be written; the old file is then whole.
    pub fn write(self) -> Result<SavedViews, SaveError> {
        let bytes = self.bytes();
        save::save(&self.path, |out| out.write_all(&bytes))?;
        let document = document(&self.path, &bytes);
        Ok(SavedViews { views: self.views, on_disk: OnDisk::now(self.path, FileKind::Native, document) })
    }
}

/// What was written, as the document that the next save patches.
fn document(path: &Path, bytes: &[u8]) -> Option<xml::Document> {
    xml::Document::read(path.to_string_lossy(), bytes).ok()
}
