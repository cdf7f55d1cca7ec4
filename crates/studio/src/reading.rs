//! Reading files on a thread of its own, so that the window goes on; what was begun can be given up.

use lancer_document::open::{self, Content, OpenError, ViewsFile, views_with};
use lancer_formats::load::LoadOptions;
use lancer_formats::progress::{self, Progress};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::time::Instant;

/// What files are read for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// A scene takes the place of the one before, views take the place of the views, a mesh is added. The paths are
    /// those of the views of the scene; without any, the document beside it is looked for.
    Open(Vec<PathBuf>),
    /// Views take the place of the views.
    Views,
    /// A mesh is added.
    Mesh,
    /// Another program has written the file.
    Reload,
}

/// What was read.
#[derive(Debug)]
pub(crate) struct Read {
    /// The file.
    pub(crate) content: Result<Content, OpenError>,
    /// The views of a scene, with their paths.
    pub(crate) views: Vec<(PathBuf, Result<ViewsFile, OpenError>)>,
}

/// A file that is being read.
#[derive(Debug)]
pub(crate) struct Reading {
    pub(crate) path: PathBuf,
    pub(crate) purpose: Purpose,
    pub(crate) begun: Instant,
    /// How far it is.
    pub(crate) progress: Progress,
    news: Receiver<Read>,
}

impl Reading {
    /// Begins to read.
    pub(crate) fn begin(ctx: &egui::Context, path: PathBuf, purpose: Purpose) -> Reading {
        let (result, news) = channel();
        let (ctx, file, why) = (ctx.clone(), path.clone(), purpose.clone());
        let progress = Progress::default();
        let watched = progress.clone();
        std::thread::spawn(move || {
            // whoever gave it up wants no result
            let _ = result.send(progress::watched(&watched, || read(&file, why)));
            ctx.request_repaint_of(egui::ViewportId::ROOT);
        });
        Reading { path, purpose, begun: Instant::now(), progress, news }
    }

    /// What was read, once it is.
    pub(crate) fn poll(&self) -> Option<Read> {
        self.news.try_recv().ok()
    }
}

fn read(path: &Path, purpose: Purpose) -> Read {
    let options = LoadOptions::default();
    let content = match purpose {
        Purpose::Open(_) | Purpose::Reload => open::read(path, &options),
        Purpose::Views => open::read_views(path, &options).map(|views| Content::Views(Box::new(views))),
        Purpose::Mesh => open::read_mesh(path, &options).map(Content::Mesh),
    };
    let paths = match (&content, purpose) {
        (Ok(Content::Scene(scene)), Purpose::Open(views)) if views.is_empty() => {
            Some(views_with(scene)).filter(|beside| beside.is_file()).into_iter().collect()
        }
        (Ok(_), Purpose::Open(views)) => views,
        (Ok(_) | Err(_), _) => Vec::new(),
    };
    let views = paths.into_iter().map(|path| (path.clone(), open::read_views(&path, &options))).collect();
    Read { content, views }
}
