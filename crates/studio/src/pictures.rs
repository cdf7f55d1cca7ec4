//! Pictures of views: into files and on the clipboard.

use crate::app::Studio;
use crate::export::From;
use crate::questions::Question;
use crate::toasts::Toast;
use egui::ColorImage;
use lancer_formats::picture::Format;
use lancer_scene::Name;
use lancer_words::studio::app as words;
use std::path::PathBuf;

impl Studio {
    /// Asks where a picture goes.
    pub(crate) fn ask_for_picture(&mut self, view: &Name, format: Format) {
        self.ask(Question::Picture(view.clone(), format));
    }

    /// Writes the picture of a view at the view's own size: the one that is shown where it is that picture and finished,
    /// else one that is rendered for it.
    pub(crate) fn export(&mut self, ctx: &egui::Context, path: PathBuf, name: &str, format: Format) {
        let stage = self.model.document.stage();
        let Some(view) = stage.views.iter().find(|view| &*view.name == name) else { return };
        let format = Format::of_path(&path, format == Format::RawPpm).unwrap_or(format);
        let shown = self.panes.live.get(name).filter(|live| !format.is_linear() && live.view() == Some(&**view));
        let from = match shown.and_then(|live| live.session().image().picture()) {
            Some(picture) => From::Picture(picture),
            None => From::Render { scene: stage.scene.clone(), view: (**view).clone() },
        };
        self.exports.begin(ctx, path, format, from);
    }

    /// Puts the picture of a view on the clipboard, as it is shown.
    pub(crate) fn copy_picture(&mut self, ctx: &egui::Context, name: &str) {
        let Some(live) = self.panes.live.get(name) else { return };
        let image = live.session().image();
        let size = [image.width() as usize, image.height() as usize];
        ctx.copy_image(ColorImage::from_rgb(size, image.bytes().as_flattened()));
        self.toasts.say(Toast::done(words::copied(self.model.lang)));
    }
}
