//! Files: questions, reading on a thread, saving, and what goes on after an answer.

use crate::app::Studio;
use crate::dialogs::{Browser, Reply, Request};
use crate::export::From;
use crate::modals::Modal;
use crate::report::Report;
use crate::settings::Settings;
use crate::toasts::Toast;
use crate::{FileAction, Tab, welcome};
use egui::ColorImage;
use lancer_document::{Document, StepName};
use lancer_formats::picture::Format;
use lancer_formats::{Diagnostic, Severity, Source};
use lancer_scene::{Name, Stage};
use lancer_words::{number, studio::app as words};
use std::path::{Path, PathBuf};

/// What goes on once unsaved changes are dealt with.
#[derive(Clone, Debug, PartialEq)]
pub enum After {
    /// The program ends.
    Quit,
    /// A new scene.
    New,
    /// A file is opened; without a path it is asked for.
    Open(Option<PathBuf>),
}

/// What a dialog was opened for.
#[derive(Clone, Debug)]
enum Question {
    Open,
    Save,
    Picture(Name, Format),
    Text(String),
}

/// Where the document comes from and goes to.
#[derive(Debug)]
pub(crate) struct Files {
    path: Option<PathBuf>,
    saved: Stage,
    question: Option<Question>,
}

impl Files {
    pub(crate) fn new(stage: &Stage) -> Files {
        Files { path: None, saved: stage.clone(), question: None }
    }

    /// The file of the scene.
    pub(crate) fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Whether the document is not what was saved.
    pub(crate) fn modified(&self, document: &Document) -> bool {
        *document.stage() != self.saved
    }

    /// No answer is waited for any more.
    pub(crate) fn forget_question(&mut self) {
        self.question = None;
    }
}

impl Studio {
    /// Takes what dialogs and threads have to tell.
    pub(crate) fn take_files(&mut self, ctx: &egui::Context) {
        self.exports.take(&mut self.toasts, self.model.lang);
        match self.dialogs.poll() {
            Some(Reply::Chosen(path)) => self.chosen(ctx, path),
            Some(Reply::Cancelled) => self.model.files.forget_question(),
            Some(Reply::Unavailable) => {
                if let Some(question) = &self.model.files.question {
                    self.browser = Some(Browser::new(self.request(question)));
                }
            }
            None => {}
        }
    }

    /// Asks for a file.
    fn ask(&mut self, question: Question) {
        self.dialogs.ask(&self.request(&question));
        self.model.files.question = Some(question);
    }

    fn request(&self, question: &Question) -> Request {
        let lang = self.model.lang;
        let kind = |name: String, extensions: &[&str]| (name, extensions.iter().map(|e| (*e).to_owned()).collect());
        let stem = self.model.files.path().and_then(Path::file_stem).map(|stem| stem.to_string_lossy().into_owned());
        let stem = stem.unwrap_or_else(|| "scene".to_owned());
        let (title, save, name, filters) = match question {
            Question::Open => {
                (words::open_title(lang), false, String::new(), vec![kind(words::scenes(lang), &["xml", "lancer"])])
            }
            Question::Save => (
                words::save_title(lang),
                true,
                format!("{stem}.xml"),
                vec![kind(words::xml_scenes(lang), &["xml"]), kind(words::binary_scenes(lang), &["lancer"])],
            ),
            Question::Picture(view, format) => {
                let extension = extension(*format);
                let name = format!("{stem}-{view}.{extension}");
                (words::save_picture_title(lang, view), true, name, vec![kind(words::pictures(lang), &[extension])])
            }
            Question::Text(_) => {
                (words::save_text_title(lang), true, format!("{stem}.txt"), vec![kind(words::texts(lang), &["txt"])])
            }
        };
        Request { title, save, folder: self.model.settings.folder.clone(), name, filters }
    }

    /// Goes on with a file that was chosen.
    pub(crate) fn chosen(&mut self, ctx: &egui::Context, path: PathBuf) {
        match self.model.files.question.take() {
            Some(Question::Picture(view, format)) => self.export(ctx, path, &view, format),
            _ => {}
        }
    }

    pub(crate) fn file(&mut self, ctx: &egui::Context, action: FileAction) {
        match action {
            FileAction::Quit => self.ask_about_changes(ctx, After::Quit),
            _ => {}
        }
    }

    pub(crate) fn ask_about_changes(&mut self, ctx: &egui::Context, after: After) {
        if self.model.modified() {
            self.modal = Some(Modal::Unsaved(after));
        } else {
            self.go_on(ctx, after);
        }
    }

    pub(crate) fn go_on(&mut self, ctx: &egui::Context, after: After) {
        match after {
            After::Quit => self.leave(ctx),
            After::New => {}
            After::Open(_) => {}
        }
    }

    pub(crate) fn save_then(&mut self, _ctx: &egui::Context, _after: After) {}

    pub(crate) fn show_loading(&mut self, _ctx: &egui::Context, _palette: &crate::theme::Palette) {}

    /// Asks where a picture goes.
    pub(crate) fn ask_for_picture(&mut self, view: &Name, format: Format) {
        self.ask(Question::Picture(view.clone(), format));
    }

    /// Writes the picture of a view at the view's own size: the one that is shown where it is that picture and finished,
    /// else one that is rendered for it.
    fn export(&mut self, ctx: &egui::Context, path: PathBuf, name: &str, format: Format) {
        let stage = self.model.document.stage();
        let Some(view) = stage.views.iter().find(|view| &*view.name == name) else { return };
        let format = Format::of_path(&path, format == Format::RawPpm).unwrap_or(format);
        let shown = self.panes.live.get(name).filter(|live| !format.is_linear() && live.view() == Some(&**view));
        let from = match shown.and_then(|live| live.session().image().picture()) {
            Some(picture) => From::Picture(picture),
            None => From::Render { scene: stage.scene.clone(), view: (**view).clone() },
        };
        self.model.settings.folder = path.parent().map(Path::to_owned);
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

/// The extension of a format.
fn extension(format: Format) -> &'static str {
    match format {
        Format::PlainPpm | Format::RawPpm => "ppm",
        Format::Png => "png",
        Format::Qoi => "qoi",
        Format::Bmp => "bmp",
        Format::Tiff => "tiff",
        Format::Exr => "exr",
    }
}
