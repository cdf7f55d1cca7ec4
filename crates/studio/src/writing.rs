//! Writing the document on a thread of its own.

use crate::foreign::Foreign;
use lancer_document::saving::{SavedScene, SavedViews, SavingScene, SavingViews};
use lancer_formats::save::{SaveError, save};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, channel};

/// What is written.
#[derive(Debug)]
pub(crate) enum What {
    /// The scene.
    Scene(SavingScene),
    /// The views.
    Views(SavingViews),
    /// A text.
    Text(String),
    /// Something for another program.
    Foreign(Box<Foreign>),
}

/// What was written.
#[derive(Debug)]
pub(crate) enum Written {
    /// The scene.
    Scene(SavedScene),
    /// The views.
    Views(SavedViews),
    /// Something that is not the document.
    Other,
}

/// Something on its way into a file.
#[derive(Debug)]
pub(crate) struct Writing {
    pub(crate) path: PathBuf,
    end: Receiver<Result<Written, SaveError>>,
}

impl Writing {
    /// Begins to write.
    pub(crate) fn begin(ctx: &egui::Context, path: PathBuf, what: What) -> Writing {
        let (result, end) = channel();
        let (ctx, file) = (ctx.clone(), path.clone());
        std::thread::spawn(move || {
            let written = match what {
                What::Scene(scene) => scene.write().map(Written::Scene),
                What::Views(views) => views.write().map(Written::Views),
                What::Text(text) => save(&file, |out| out.write_all(text.as_bytes())).map(|()| Written::Other),
                What::Foreign(content) => content.write(&file).map(|()| Written::Other),
            };
            // a window that is gone wants no news
            let _ = result.send(written);
            ctx.request_repaint_of(egui::ViewportId::ROOT);
        });
        Writing { path, end }
    }

    /// How it ended, once it has.
    pub(crate) fn poll(&self) -> Option<Result<Written, SaveError>> {
        self.end.try_recv().ok()
    }
}
