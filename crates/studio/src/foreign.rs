//! Scenes and views for other programs: what their formats cannot hold is found out beside the window, and said before
//! anybody is asked where the file goes.

use crate::Exported;
use lancer_formats::Problem;
use lancer_formats::export::{self, Container};
use lancer_formats::n7_2009::{self, N7Problem};
use lancer_formats::save::{SaveError, save, save_together};
use lancer_scene::{Scene, Stage, View, Views};
use std::io::Write;
use std::path::Path;
use std::sync::mpsc::{Receiver, channel};

/// The state of the document that is exported: as much of it as the format asks for.
#[derive(Clone, Debug)]
pub(crate) enum Foreign {
    /// A scene of 2009.
    Scene2009(Scene),
    /// Views of 2009.
    Views2009(Views),
    /// A scene of POV-Ray, seen by a camera.
    Povray(Scene, View),
    /// The objects for Wavefront, with the library of their materials beside them.
    Obj(Scene),
    /// The objects for glTF.
    Gltf(Scene, Container),
}

impl Foreign {
    /// What is exported of a document; `None` where the format has a camera and there is no view.
    pub(crate) fn of(what: Exported, stage: &Stage, view: Option<&View>) -> Option<Foreign> {
        let scene = stage.scene.clone();
        Some(match what {
            Exported::Scene2009 => Foreign::Scene2009(scene),
            Exported::Views2009 => Foreign::Views2009(stage.views.clone()),
            Exported::Povray => Foreign::Povray(scene, view?.clone()),
            Exported::Obj => Foreign::Obj(scene),
            Exported::Gltf => Foreign::Gltf(scene, Container::Text),
            Exported::Glb => Foreign::Gltf(scene, Container::Binary),
        })
    }

    /// What the format cannot hold of it.
    fn losses(&self) -> Vec<Problem> {
        let of_2009 =
            |losses: Vec<n7_2009::Loss>| losses.into_iter().map(|loss| N7Problem::Loss(loss).into()).collect();
        let of_others = |losses: Vec<export::Loss>| losses.into_iter().map(Problem::from).collect();
        match self {
            Foreign::Scene2009(scene) => of_2009(n7_2009::write_scene(scene).1),
            Foreign::Views2009(views) => of_2009(n7_2009::write_views(views).1),
            Foreign::Povray(scene, view) => of_others(export::povray_losses(scene, view)),
            Foreign::Obj(scene) => of_others(export::obj_losses(scene)),
            Foreign::Gltf(scene, _) => of_others(export::gltf_losses(scene)),
        }
    }

    /// Writes it.
    ///
    /// # Errors
    /// The file that cannot be written.
    pub(crate) fn write(&self, path: &Path) -> Result<(), SaveError> {
        let whole = |path: &Path, bytes: &[u8]| save(path, |out| out.write_all(bytes));
        match self {
            Foreign::Scene2009(scene) => whole(path, n7_2009::write_scene(scene).0.as_bytes()),
            Foreign::Views2009(views) => whole(path, n7_2009::write_views(views).0.as_bytes()),
            Foreign::Povray(scene, view) => save(path, |out| export::write_povray(scene, view, out)),
            Foreign::Obj(scene) => {
                let library = path.with_extension("mtl");
                let name = library.file_name().unwrap_or_default().to_string_lossy();
                let files = export::write_obj(scene, &name);
                let files = [(&*library, files.materials.as_bytes()), (path, files.objects.as_bytes())];
                save_together(files.map(|(path, bytes)| (path, move |out: &mut dyn Write| out.write_all(bytes))))
            }
            Foreign::Gltf(scene, container) => whole(path, &export::write_gltf(scene, *container)),
        }
    }
}

/// What an export loses.
#[derive(Debug)]
pub(crate) struct Losses {
    pub(crate) what: Exported,
    pub(crate) content: Box<Foreign>,
    pub(crate) losses: Vec<Problem>,
}

/// An export whose losses are being found.
#[derive(Debug)]
pub(crate) struct Weighing(Receiver<Losses>);

impl Weighing {
    /// Begins to find them.
    pub(crate) fn begin(ctx: &egui::Context, what: Exported, content: Foreign) -> Weighing {
        let (result, found) = channel();
        let ctx = ctx.clone();
        std::thread::spawn(move || {
            let losses = content.losses();
            // a window that is gone exports nothing
            let _ = result.send(Losses { what, content: Box::new(content), losses });
            ctx.request_repaint_of(egui::ViewportId::ROOT);
        });
        Weighing(found)
    }

    /// What is lost, once it is found.
    pub(crate) fn poll(&self) -> Option<Losses> {
        self.0.try_recv().ok()
    }
}
