//! Files: what is asked, what is read and written, and what goes on after an answer.

use crate::app::Studio;
use crate::dialogs::{Browser, Reply};
use crate::foreign::{Foreign, Weighing};
use crate::modals::{self, Modal};
use crate::questions::Question;
use crate::reading::{Purpose, Read, Reading};
use crate::report::Report;
use crate::theme::Palette;
use crate::toasts::Toast;
use crate::writing::{What, Writing, Written};
use crate::{Action, FileAction, Tab, ViewAction, told};
use lancer_document::open::{Content, MESH_EXTENSIONS, OnDisk, OpenError, ViewsFile, Warnings, views_beside};
use lancer_document::{Document, StepName};
use lancer_formats::load::LoadOptions;
use lancer_formats::progress::Stage;
use lancer_formats::save::SceneFormat;
use lancer_formats::{Describe, Severity};
use lancer_words::{number, studio::app as words};
use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Reading that takes longer is shown, with a way to give it up.
const SHOWN_AFTER: Duration = Duration::from_millis(250);

/// What goes on once unsaved changes are dealt with.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum After {
    /// The program ends.
    Quit,
    /// A new scene.
    New,
    /// A file is opened; without a path it is asked for.
    Open(Option<PathBuf>),
}

/// What is asked, read and written just now.
#[derive(Debug, Default)]
pub(crate) struct Files {
    pub(crate) question: Option<Question>,
    reading: Option<Reading>,
    /// Files to read after that one.
    waiting: VecDeque<(PathBuf, Purpose)>,
    writing: Vec<Writing>,
    /// What is about to be exported.
    weighing: Option<Weighing>,
    /// What goes on once everything is written.
    after: Option<After>,
}

impl Files {
    /// No answer is waited for any more.
    pub(crate) fn forget_question(&mut self) {
        self.question = None;
        self.after = None;
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
        let read = self.model.files.reading.as_ref().and_then(Reading::poll);
        if let Some(read) = read
            && let Some(reading) = self.model.files.reading.take()
        {
            self.take_read(ctx, &reading, read);
            self.read_next(ctx);
        }
        self.take_written(ctx);
        if let Some(weighed) = self.model.files.weighing.as_ref().and_then(Weighing::poll) {
            self.model.files.weighing = None;
            if weighed.losses.is_empty() {
                self.ask(Question::Export(weighed.what, weighed.content));
            } else {
                self.modal = Some(Modal::Losses(Box::new(weighed)));
            }
        }
    }

    /// Goes on with a file that was chosen.
    pub(crate) fn chosen(&mut self, ctx: &egui::Context, path: PathBuf) {
        let Some(question) = self.model.files.question.take() else { return };
        self.model.settings.folder = path.parent().map(Path::to_owned);
        match question {
            Question::Open => self.read(ctx, path, Purpose::Open(Vec::new())),
            Question::LoadViews => self.read(ctx, path, Purpose::Views),
            Question::Mesh => self.read(ctx, path, Purpose::Mesh),
            Question::Save => self.write_document(ctx, path),
            Question::SaveViews => self.write_views(ctx, path),
            Question::Picture(view, format) => self.export(ctx, path, &view, format),
            Question::Export(_, content) => self.write(ctx, path, What::Foreign(content)),
            Question::Text { text, .. } => self.write(ctx, path, What::Text(text)),
        }
    }

    /// Does something about files.
    pub(crate) fn file(&mut self, ctx: &egui::Context, action: FileAction) {
        match action {
            FileAction::New => self.ask_about_changes(ctx, After::New),
            FileAction::Open(path) => self.open(ctx, path),
            FileAction::Save => match self.model.document.scene_path().map(Path::to_owned) {
                Some(path) => self.write_document(ctx, path),
                None => self.ask(Question::Save),
            },
            FileAction::SaveAs => self.ask(Question::Save),
            FileAction::LoadViews => self.ask(Question::LoadViews),
            FileAction::SaveViews => match self.model.document.views_path().map(Path::to_owned) {
                Some(path) => self.write_views(ctx, path),
                None => self.ask(Question::SaveViews),
            },
            FileAction::SaveViewsAs => self.ask(Question::SaveViews),
            FileAction::SaveText { name, text } => self.ask(Question::Text { name, text }),
            FileAction::Export(what) => {
                let stage = self.model.document.stage();
                let active = stage.views.iter().find(|view| Some(&*view.name) == self.model.active.as_deref());
                let view = active.or_else(|| stage.views.iter().next()).map(|view| &**view);
                // without a view the menu does not offer a format with a camera
                let content = Foreign::of(what, stage, view);
                self.model.files.weighing = content.map(|content| Weighing::begin(ctx, what, content));
            }
            FileAction::AddMesh => self.ask(Question::Mesh),
            FileAction::Quit => self.ask_about_changes(ctx, After::Quit),
        }
    }

    /// Opens a file. Views and meshes come into the scene that is shown; a scene takes its place, so changes are asked
    /// about before.
    fn open(&mut self, ctx: &egui::Context, path: Option<PathBuf>) {
        let is_mesh = path
            .as_deref()
            .and_then(Path::extension)
            .is_some_and(|extension| MESH_EXTENSIONS.contains(&extension.to_string_lossy().to_lowercase().as_str()));
        match path {
            Some(path) if is_mesh => self.read(ctx, path, Purpose::Mesh),
            path => self.ask_about_changes(ctx, After::Open(path)),
        }
    }

    /// Opens the files of the command line: a scene, then documents of views.
    pub(crate) fn open_all(&mut self, ctx: &egui::Context, files: Vec<PathBuf>) {
        let mut files = files.into_iter();
        if let Some(scene) = files.next() {
            self.read(ctx, scene, Purpose::Open(files.collect()));
        }
    }

    /// Asks about changes that are not saved, then goes on.
    pub(crate) fn ask_about_changes(&mut self, ctx: &egui::Context, after: After) {
        if self.model.modified() {
            self.modal = Some(Modal::Unsaved(after));
        } else {
            self.go_on(ctx, after);
        }
    }

    /// Goes on, whatever is not saved.
    pub(crate) fn go_on(&mut self, ctx: &egui::Context, after: After) {
        match after {
            After::Quit => self.leave(ctx),
            After::New => self.begin_new(),
            After::Open(Some(path)) => self.read(ctx, path, Purpose::Open(Vec::new())),
            After::Open(None) => self.ask(Question::Open),
        }
    }

    /// Saves, then goes on.
    pub(crate) fn save_then(&mut self, ctx: &egui::Context, after: After) {
        self.file(ctx, FileAction::Save);
        self.model.files.after = Some(after);
    }

    /// A new scene: a lamp and a view of the place where things will stand.
    fn begin_new(&mut self) {
        self.model.reports.clear();
        self.begin_document(Document::new(StepName::New, crate::welcome::empty()));
    }

    fn read(&mut self, ctx: &egui::Context, path: PathBuf, purpose: Purpose) {
        self.model.files.waiting.push_back((path, purpose));
        self.read_next(ctx);
    }

    fn read_next(&mut self, ctx: &egui::Context) {
        let files = &mut self.model.files;
        if files.reading.is_none()
            && let Some((path, purpose)) = files.waiting.pop_front()
        {
            files.reading = Some(Reading::begin(ctx, path, purpose));
        }
    }

    /// Reads again what another program has written.
    pub(crate) fn look_outside(&mut self, ctx: &egui::Context) {
        let document = &self.model.document;
        let changed = [document.scene_file(), document.views_file()].into_iter().flatten();
        let changed: Vec<PathBuf> =
            changed.filter(|file| file.changed_outside()).map(|file: &OnDisk| file.path.clone()).collect();
        for path in changed {
            self.read(ctx, path, Purpose::Reload);
        }
    }

    /// Takes a file that was read.
    fn take_read(&mut self, ctx: &egui::Context, reading: &Reading, read: Read) {
        let content = match read.content {
            Ok(content) => content,
            Err(error) => return self.take_failure(&reading.path, error),
        };
        if reading.purpose != Purpose::Reload {
            self.model.settings.remember(&reading.path);
        }
        match content {
            Content::Scene(scene) => {
                self.model.reports = vec![report(&scene.warnings)];
                if reading.purpose == Purpose::Reload {
                    self.model.document.reload_scene(*scene);
                    self.say_reloaded(&reading.path);
                } else {
                    let mut files = Vec::new();
                    for (path, views) in read.views {
                        match views {
                            Ok(views) => files.push(views),
                            Err(error) => self.take_failure(&path, error),
                        }
                    }
                    self.take_scene(*scene, files);
                }
            }
            Content::Views(views) => {
                self.model.reports = vec![report(&views.warnings)];
                let count = views.views.len();
                self.model.document.load_views(*views);
                self.fit_layout();
                if reading.purpose == Purpose::Reload {
                    self.say_reloaded(&reading.path);
                } else {
                    let lang = self.model.lang;
                    let text = words::views_loaded(lang, short(&reading.path), number::views(lang, count));
                    self.toasts.say(Toast::done(text));
                }
            }
            Content::Mesh(mesh) => {
                let by_itself = matches!(reading.purpose, Purpose::Open(_));
                if by_itself {
                    // one that the program is started with is no part of the first scene
                    self.begin_new();
                }
                self.model.reports = vec![report(&mesh.warnings)];
                let item = self.model.document.new_mesh(mesh);
                if let Err(error) = self.add(item) {
                    let lang = self.model.lang;
                    self.toasts.say(Toast::failed(words::refused(lang, told::edit(&error, lang))));
                } else if by_itself && let Some(view) = self.model.document.stage().views.first() {
                    let name = view.name.clone();
                    self.perform(ctx, Action::View(name, ViewAction::Frame));
                }
            }
        }
        self.say_warnings(&reading.path);
    }

    /// A file that is not opened: what is wrong with it stands in the Problems, the scene that is shown stays.
    fn take_failure(&mut self, path: &Path, error: OpenError) {
        let lang = self.model.lang;
        match error {
            OpenError::Unreadable(error) => self.toasts.say(Toast::failed(told::sentence(&error.message(lang)))),
            OpenError::Broken { diagnostics, source } => {
                let report = Report { source, diagnostics };
                let errors = number::errors(lang, report.count(Severity::Error));
                self.model.reports = vec![report];
                self.toasts.say(Toast::failed(words::broken(lang, short(path), errors)));
                self.show_problems();
            }
        }
    }

    fn say_reloaded(&mut self, path: &Path) {
        self.toasts.say(Toast::note(words::reloaded(self.model.lang, short(path))));
    }

    /// Says how many warnings there are, and shows them.
    fn say_warnings(&mut self, path: &Path) {
        let lang = self.model.lang;
        self.model.reports.retain(|report| !report.diagnostics.is_empty());
        let warnings: usize = self.model.reports.iter().map(|report| report.count(Severity::Warning)).sum();
        if warnings > 0 {
            let text = words::loaded_with(lang, short(path), number::warnings(lang, warnings));
            self.toasts.say(Toast::note(text));
            self.show_problems();
        }
    }

    fn show_problems(&mut self) {
        self.model.settings.tab = Tab::Problems;
        self.model.settings.tabs = true;
    }

    fn take_scene(&mut self, scene: lancer_document::open::SceneFile, views: Vec<ViewsFile>) {
        let mut views = views.into_iter();
        let first = views.next();
        self.model.reports.extend(first.iter().map(|views| report(&views.warnings)));
        let mut document = Document::open(scene, first, LoadOptions::default());
        for more in views {
            self.model.reports.push(report(&more.warnings));
            document.add_views(&more.views);
        }
        self.begin_document(document);
    }

    /// Panes of views that are gone are closed; where none is left, the first two views are shown.
    fn fit_layout(&mut self) {
        let layout = std::mem::take(&mut self.model.settings.layout);
        self.model.settings.layout = layout.fitted(self.model.document.stage());
    }

    /// Shows another document.
    pub(crate) fn begin_document(&mut self, document: Document) {
        self.model.document = document;
        self.model.renaming = None;
        self.model.active = None;
        self.fit_layout();
    }

    /// Shows what is being read, with a way to give it up, once it takes a while.
    pub(crate) fn show_loading(&mut self, ctx: &egui::Context, palette: &Palette) {
        let lang = self.model.lang;
        let Some(reading) = &self.model.files.reading else { return };
        if reading.begun.elapsed() < SHOWN_AFTER {
            ctx.request_repaint_after(SHOWN_AFTER);
            return;
        }
        let mut given_up = false;
        let modal = modals::modal(ctx, "reading").show(ctx, |ui| {
            ui.set_width(320.0);
            let (stage, part) = reading.progress.now();
            let name = short(&reading.path);
            let label = match stage {
                Stage::Bytes => words::loading(lang, name),
                Stage::Content => words::making_out(lang, name),
            };
            let label = ui.horizontal(|ui| {
                ui.add(egui::Spinner::new().size(18.0).color(palette.accent));
                ui.label(label).id
            });
            ui.add_space(8.0);
            let bar = match part {
                Some(part) => egui::ProgressBar::new(part as f32).show_percentage(),
                None => egui::ProgressBar::new(0.0),
            };
            ui.add(bar).labelled_by(label.inner);
            ui.add_space(10.0);
            ui.vertical_centered(|ui| {
                given_up = ui.add(modals::default_button(words::cancel(lang), palette)).clicked();
            });
        });
        if given_up || modal.should_close() {
            self.model.files.reading = None;
            self.model.files.waiting.clear();
        }
    }

    fn write(&mut self, ctx: &egui::Context, path: PathBuf, what: What) {
        self.model.files.writing.push(Writing::begin(ctx, path, what));
    }

    /// Writes the scene, and the views where they have changed: into their file, or beside the scene.
    fn write_document(&mut self, ctx: &egui::Context, path: PathBuf) {
        let format = match SceneFormat::of_path(&path) {
            Ok(format) => format,
            Err(unknown) => {
                let text = told::sentence(&unknown.message(self.model.lang));
                self.model.files.after = None;
                return self.toasts.say(Toast::failed(text));
            }
        };
        let document = &mut self.model.document;
        let same_place = document.scene_path() == Some(&*path);
        let known = document.views_path().filter(|_| same_place).map(Path::to_owned);
        let views_changed = document.views_are_modified() || known.is_none();
        let scene = document.saving_scene(&path, format);
        self.write(ctx, path.clone(), What::Scene(scene));
        let beside = known.clone().unwrap_or_else(|| views_beside(&path));
        if !views_changed {
            return;
        }
        if known.is_none() && beside.exists() {
            // a file that is not this document's is not written over unasked
            self.ask(Question::SaveViews);
        } else {
            self.write_views(ctx, beside);
        }
    }

    fn write_views(&mut self, ctx: &egui::Context, path: PathBuf) {
        let views = self.model.document.saving_views(&path);
        self.write(ctx, path, What::Views(views));
    }

    /// Takes what was written; once everything is, goes on with what waits for it.
    fn take_written(&mut self, ctx: &egui::Context) {
        let (lang, files) = (self.model.lang, &mut self.model.files);
        let mut done = Vec::new();
        files.writing.retain(|writing| match writing.poll() {
            Some(result) => {
                done.push((writing.path.clone(), result));
                false
            }
            None => true,
        });
        for (path, result) in done {
            match result {
                Err(error) => {
                    files.after = None;
                    self.toasts.say(Toast::failed(told::sentence(&error.message(lang))));
                    continue;
                }
                Ok(Written::Scene(saved)) => {
                    self.model.document.saved_scene(saved);
                    self.model.settings.remember(&path);
                }
                Ok(Written::Views(saved)) => self.model.document.saved_views(saved),
                Ok(Written::Other) => {}
            }
            self.toasts.say(Toast::done(words::written(lang, short(&path))));
        }
        if files.writing.is_empty()
            && files.question.is_none()
            && let Some(after) = files.after.take()
        {
            self.go_on(ctx, after);
        }
    }
}

/// What was found in a file that could be opened.
fn report(warnings: &Warnings) -> Report {
    Report { source: warnings.source.clone(), diagnostics: warnings.diagnostics.clone() }
}

/// A file's name without its folder.
fn short(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}
