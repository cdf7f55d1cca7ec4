//! Export to the format of 2009: the document is made beside the window, then what it cannot hold is said before
//! anybody is asked where it goes.

use crate::Exported;
use lancer_formats::n7_2009::{self, Loss};
use lancer_scene::Stage;
use std::sync::mpsc::{Receiver, channel};

/// A document of 2009 and what it cannot hold.
#[derive(Clone, Debug)]
pub(crate) struct Losses {
    pub(crate) what: Exported,
    pub(crate) text: String,
    pub(crate) losses: Vec<Loss>,
}

/// A document of 2009 that is being made.
#[derive(Debug)]
pub(crate) struct Making(Receiver<Losses>);

impl Making {
    /// Begins to make it.
    pub(crate) fn begin(ctx: &egui::Context, stage: &Stage, what: Exported) -> Making {
        let (result, made) = channel();
        let (ctx, stage) = (ctx.clone(), stage.clone());
        std::thread::spawn(move || {
            let (text, losses) = match what {
                Exported::Scene => n7_2009::write_scene(&stage.scene),
                Exported::Views => n7_2009::write_views(&stage.views),
            };
            // a window that is gone exports nothing
            let _ = result.send(Losses { what, text, losses });
            ctx.request_repaint_of(egui::ViewportId::ROOT);
        });
        Making(made)
    }

    /// The document, once it is made.
    pub(crate) fn poll(&self) -> Option<Losses> {
        self.0.try_recv().ok()
    }
}
