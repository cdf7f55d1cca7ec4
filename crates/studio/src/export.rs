//! Pictures on their way into files: rendered at the view's own size on threads of their own, whatever the pane shows.

use crate::chrome::icon_button;
use crate::theme::Palette;
use crate::toasts::{Toast, Toasts};
use egui::{Align2, Area, Frame, Id, Margin, Order, ProgressBar, Vec2};
use egui_material_icons::icons as icon;
use lancer_formats::picture::{self, Format};
use lancer_formats::{Describe, save};
use lancer_render::{RenderError, RenderOptions, Tracing, render_still};
use lancer_scene::{Picture, Scene, View};
use lancer_trace::{Cancel, World};
use lancer_words::{Lang, studio::app as words};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::{Receiver, channel};

/// What a picture is made from.
#[derive(Debug)]
#[expect(clippy::large_enum_variant, reason = "there is one at a time")]
pub(crate) enum From {
    /// It is there.
    Picture(Picture),
    /// It is rendered.
    Render {
        /// The scene.
        scene: Scene,
        /// The view at the size of the picture.
        view: View,
    },
}

/// How the export of a picture ended.
enum End {
    Written,
    Cancelled,
    Failed(Box<dyn Fn(Lang) -> String + Send>),
}

struct Export {
    name: String,
    /// Thousandths.
    done: Arc<AtomicU32>,
    cancel: Cancel,
    end: Receiver<End>,
}

/// The pictures on their way.
pub(crate) struct Exports {
    /// What follows their rays.
    tracing: Tracing,
    exports: Vec<Export>,
}

impl std::fmt::Debug for Exports {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("Exports").field(&self.exports.len()).finish()
    }
}

impl Exports {
    /// No picture yet.
    pub(crate) fn new(tracing: Tracing) -> Exports {
        Exports { tracing, exports: Vec::new() }
    }

    /// Begins to write a picture.
    pub(crate) fn begin(&mut self, ctx: &egui::Context, path: PathBuf, format: Format, from: From) {
        let name = path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into());
        let (done, cancel, (result, end)) = (Arc::new(AtomicU32::new(0)), Cancel::default(), channel());
        let export = Export { name, done: Arc::clone(&done), cancel: cancel.clone(), end };
        let (ctx, tracing) = (ctx.clone(), self.tracing);
        std::thread::spawn(move || {
            let progress = |now: u64, all: u64| {
                let thousandths = (now * 1000 / all.max(1)) as u32;
                if done.swap(thousandths, Ordering::Relaxed) / 10 != thousandths / 10 {
                    ctx.request_repaint_of(egui::ViewportId::ROOT);
                }
            };
            // a window that is gone wants no news
            let _ = result.send(run(path, format, from, tracing, &cancel, progress));
            ctx.request_repaint_of(egui::ViewportId::ROOT);
        });
        self.exports.push(export);
    }

    /// Takes what has ended.
    pub(crate) fn take(&mut self, toasts: &mut Toasts, lang: Lang) {
        self.exports.retain(|export| match export.end.try_recv() {
            Ok(End::Written) => {
                toasts.say(Toast::done(words::written(lang, &export.name)));
                false
            }
            Ok(End::Failed(why)) => {
                toasts.say(Toast::failed(why(lang)));
                false
            }
            Ok(End::Cancelled) => false,
            Err(std::sync::mpsc::TryRecvError::Empty) => true,
            Err(std::sync::mpsc::TryRecvError::Disconnected) => false,
        });
    }

    /// Draws how far they are.
    pub(crate) fn show(&self, ctx: &egui::Context, palette: &Palette, lang: Lang) {
        if self.exports.is_empty() {
            return;
        }
        let area = Area::new(Id::unique("exports")).order(Order::Foreground);
        area.anchor(Align2::CENTER_BOTTOM, Vec2::new(0.0, -44.0)).show(ctx, |ui| {
            for export in &self.exports {
                Frame::popup(ui.style()).fill(palette.bar).inner_margin(Margin::symmetric(12, 8)).show(ui, |ui| {
                    ui.horizontal(|ui| {
                        ui.label(words::exporting(lang, &export.name));
                        let part = export.done.load(Ordering::Relaxed) as f32 / 1000.0;
                        ui.add(ProgressBar::new(part).desired_width(160.0).show_percentage());
                        if icon_button(ui, icon::ICON_CLOSE, &words::cancel(lang)).clicked() {
                            export.cancel.cancel();
                        }
                    });
                });
            }
        });
    }
}

/// Renders where it must, and writes.
fn run(
    path: PathBuf,
    format: Format,
    from: From,
    tracing: Tracing,
    cancel: &Cancel,
    progress: impl FnMut(u64, u64),
) -> End {
    let picture = match from {
        From::Picture(picture) => picture,
        From::Render { scene, view } => {
            let options = RenderOptions { tracing, keep_linear: format.is_linear(), ..RenderOptions::default() };
            match render_still(&World::compile(&scene), &view, &options, cancel, progress) {
                Ok(still) => still.picture,
                Err(RenderError::Cancelled) => return End::Cancelled,
                Err(error) => return End::Failed(Box::new(move |lang| crate::told::render(&error, lang))),
            }
        }
    };
    match save::save(&path, |out| picture::write(&picture, format, out)) {
        Ok(()) => End::Written,
        Err(error) => End::Failed(Box::new(move |lang| error.message(lang))),
    }
}
