//! The files of a document: where it was read from and goes to, and whether there is anything to save.

use crate::insert::{self, NewItem};
use crate::journal::Entry;
use crate::open::{self, FileKind, MeshFile, OnDisk, SceneFile, ViewsFile};
use crate::saving::{SavedScene, SavedViews, SavingScene, SavingViews};
use crate::{Document, StepName, naming};
use lancer_formats::load::LoadOptions;
use lancer_formats::save::SceneFormat;
use lancer_formats::xml;
use lancer_scene::{Stage, View, Views};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a document knows of the disk. Comparing with what was saved makes an undo to it clean again.
#[derive(Clone, Debug)]
pub(crate) struct Files {
    scene: Option<OnDisk>,
    views: Option<OnDisk>,
    saved: Stage,
    /// The file that the names of meshes in the scene are relative to: the first one that the scene had.
    origin: Option<PathBuf>,
    options: LoadOptions,
}

impl Files {
    /// A document that has no files yet; as it begins, there is nothing to save.
    pub(crate) fn none(stage: Stage) -> Files {
        Files { scene: None, views: None, saved: stage, origin: None, options: LoadOptions::default() }
    }
}

impl Document {
    /// A document of a scene that was read, with the views that were read for it. Without any, it has one of the whole
    /// scene.
    pub fn open(scene: SceneFile, views: Option<ViewsFile>, options: LoadOptions) -> Document {
        let (views, on_disk) = match views {
            Some(file) if !file.views.is_empty() => (file.views, Some(file.on_disk)),
            Some(_) | None => ([insert::overview(&scene.scene)].into_iter().collect(), None),
        };
        let stage = Stage { scene: scene.scene, views };
        let mut document = Document::new(StepName::Opened, stage.clone());
        let origin = Some(scene.on_disk.path.clone());
        document.files = Files { scene: Some(scene.on_disk), views: on_disk, saved: stage, origin, options };
        document
    }

    /// The file of the scene.
    pub fn scene_file(&self) -> Option<&OnDisk> {
        self.files.scene.as_ref()
    }

    /// The file of the views.
    pub fn views_file(&self) -> Option<&OnDisk> {
        self.files.views.as_ref()
    }

    /// Whether the scene is not what its file holds.
    pub fn scene_is_modified(&self) -> bool {
        self.stage().scene != self.files.saved.scene
    }

    /// Whether the views are not what their file holds.
    pub fn views_are_modified(&self) -> bool {
        self.stage().views != self.files.saved.views
    }

    /// Whether anything would be lost.
    pub fn is_modified(&self) -> bool {
        self.scene_is_modified() || self.views_are_modified()
    }

    /// Whether somebody who ends now would lose work. Of a document without a file, where the eyes and screens of its
    /// views have come to does not count: whoever has just looked around has nothing to lose.
    pub fn has_work_to_lose(&self) -> bool {
        let saved = &self.files.saved.views;
        let looked_around = |(now, then): (&Arc<View>, &Arc<View>)| {
            View { eye: then.eye, screen: then.screen.clone(), ..View::clone(now) } == **then
        };
        let views = &self.stage().views;
        let only_looked = || {
            self.files.scene.is_none()
                && self.files.views.is_none()
                && views.len() == saved.len()
                && views.iter().zip(saved.iter()).all(looked_around)
        };
        self.scene_is_modified() || self.views_are_modified() && !only_looked()
    }

    /// Where the scene is saved without asking: its own file, unless that is of another format, which is not written.
    pub fn scene_path(&self) -> Option<&Path> {
        self.files.scene.as_ref().filter(|file| file.kind != FileKind::Foreign).map(|file| &*file.path)
    }

    /// Where the views are saved without asking.
    pub fn views_path(&self) -> Option<&Path> {
        self.files.views.as_ref().filter(|file| file.kind != FileKind::Foreign).map(|file| &*file.path)
    }

    /// What has to be written to save the scene; a gesture that is going on is committed.
    pub fn saving_scene(&mut self, path: &Path, format: SceneFormat) -> SavingScene {
        self.commit();
        SavingScene {
            scene: self.stage().scene.clone(),
            format,
            path: path.to_owned(),
            origin: self.files.origin.clone(),
            document: self.files.scene.as_ref().and_then(|file| file.document.clone()),
            options: self.files.options,
        }
    }

    /// Hears that a scene is on the disk.
    pub fn saved_scene(&mut self, saved: SavedScene) {
        self.files.origin.get_or_insert_with(|| saved.on_disk.path.clone());
        self.files.saved.scene = saved.scene;
        self.files.scene = Some(saved.on_disk);
    }

    /// What has to be written to save the views; a gesture that is going on is committed.
    pub fn saving_views(&mut self, path: &Path) -> SavingViews {
        self.commit();
        SavingViews {
            views: self.stage().views.clone(),
            path: path.to_owned(),
            document: self.files.views.as_ref().and_then(|file| file.document.clone()),
        }
    }

    /// Hears that views are on the disk.
    pub fn saved_views(&mut self, saved: SavedViews) {
        self.files.saved.views = saved.views;
        self.files.views = Some(saved.on_disk);
    }

    /// Takes the scene of its file, or of another one, in place of this one, as a step.
    pub fn reload_scene(&mut self, file: SceneFile) {
        let stage = Stage { scene: file.scene, views: self.stage().views.clone() };
        self.files.saved.scene = stage.scene.clone();
        self.files.origin = Some(file.on_disk.path.clone());
        self.files.scene = Some(file.on_disk);
        self.replace(StepName::Reloaded, stage);
    }

    /// Takes the views of a file in place of those there are, as a step.
    pub fn load_views(&mut self, file: ViewsFile) {
        let stage = Stage { scene: self.stage().scene.clone(), views: file.views };
        self.files.saved.views = stage.views.clone();
        self.files.views = Some(file.on_disk);
        self.replace(StepName::ViewsLoaded, stage);
    }

    /// Adds the views of a file to those there are, under names of their own, as a step.
    pub fn add_views(&mut self, views: &Views) {
        let stage = Stage { scene: self.stage().scene.clone(), views: joined(self.stage(), views) };
        self.replace(StepName::ViewsLoaded, stage);
    }

    /// The mesh file as a thing that can be added: by its name if it stands at or below the scene's folder, else with its
    /// vertices in the scene.
    pub fn new_mesh(&self, file: MeshFile) -> NewItem {
        let source = self.files.origin.as_deref().and_then(|scene| open::name_below(scene, &file.path));
        let stem = file.path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        NewItem::Mesh { stem, geometry: file.geometry, source }
    }

    /// The scene as a native document: its file's own, patched, or a new one. No file is looked at.
    pub fn scene_text(&self) -> Vec<u8> {
        let scene = &self.stage().scene;
        match self.files.scene.as_ref().and_then(|file| file.document.as_ref()) {
            Some(document) => xml::patch_scene(document, scene),
            None => xml::write_scene(scene).into_bytes(),
        }
    }

    /// The views as a native document: their file's own, patched, or a new one.
    pub fn views_text(&self) -> Vec<u8> {
        let views = &self.stage().views;
        match self.files.views.as_ref().and_then(|file| file.document.as_ref()) {
            Some(document) => xml::patch_views(document, views),
            None => xml::write_views(views).into_bytes(),
        }
    }

    /// What a journal keeps of the document.
    pub fn entry(&self) -> Entry {
        Entry {
            stage: self.base().clone(),
            scene: self.files.scene.as_ref().map(|file| file.path.clone()),
            views: self.files.views.as_ref().map(|file| file.path.clone()),
        }
    }

    /// A document of what a journal kept, with the files as they are now, as far as they can be read: what they hold is
    /// the first step, what was kept the second.
    pub fn recover(entry: Entry, scene: Option<SceneFile>, views: Option<ViewsFile>, options: LoadOptions) -> Document {
        match scene {
            Some(scene) => {
                let mut document = Document::open(scene, views, options);
                document.replace(StepName::Recovered, entry.stage);
                document
            }
            None => {
                let mut document = Document::new(StepName::Recovered, entry.stage);
                document.files = Files { origin: entry.scene, options, ..Files::none(Stage::default()) };
                if let Some(views) = views {
                    document.files.saved.views = views.views;
                    document.files.views = Some(views.on_disk);
                }
                document
            }
        }
    }
}

/// The views of a stage and others behind them.
fn joined(stage: &Stage, more: &Views) -> Views {
    let mut taken = naming::taken(stage);
    stage.views.with(|views| {
        for view in more {
            let name = naming::distinct(&view.name, &taken);
            taken.insert(name.clone());
            views.push(if name == view.name { Arc::clone(view) } else { Arc::new(View { name, ..View::clone(view) }) });
        }
    })
}
