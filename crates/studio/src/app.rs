//! The window: what it holds, and one frame of it.

use crate::Action;
use crate::action::{FileAction, Tab};
use crate::bars;
use crate::context::{Context, PaneState};
use crate::dialogs::{Browser, Dialogs};
use crate::entry;
use crate::explainer::{Explainer, Target};
use crate::export::Exports;
use crate::files::{After, Files};
use crate::frame::{detached, nothing, tabs, titled};
use crate::layout::{Layout, SIMPLIFICATION};
use crate::modals::{self, Modal};
use crate::panels;
use crate::report::Report;
use crate::settings::{self, Settings};
use crate::swatches::Swatches;
use crate::theme::{self, Palette};
use crate::tiles::Tiles;
use crate::toasts::Toasts;
use crate::view::{Answer, LiveView, Picker, Purpose};
use egui::{CentralPanel, Frame, Margin, Panel, Ui, ViewportCommand, ViewportId};
use lancer_document::journal::{self, Journal};
use lancer_document::wireframe::Wireframes;
use lancer_document::{Document, Item, StepName};
use lancer_render::Tracing;
use lancer_render::live::Renderer;
use lancer_scene::Stage;
use lancer_words::{Lang, studio::app as words};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::Duration;

/// How long news of the pictures wait for others: painting more often would only take time from rendering.
const BETWEEN_NEWS: Duration = Duration::from_millis(33);

/// How the window begins.
pub struct Start {
    /// What was remembered.
    pub settings: Settings,
    /// The language; `None` for the remembered one or the locale's.
    pub lang: Option<Lang>,
    /// What follows the rays of all pictures.
    pub tracing: Tracing,
    /// What is shown until something is opened.
    pub stage: Stage,
    /// Files to open: a scene, then documents of views.
    pub open: Vec<PathBuf>,
    /// What asks for files.
    pub dialogs: Box<dyn Dialogs>,
    /// The folder in which steps are kept for the case of a crash.
    pub journals: Option<PathBuf>,
}

impl std::fmt::Debug for Start {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Start").field("open", &self.open).finish_non_exhaustive()
    }
}

/// What panels read.
#[derive(Debug)]
pub(crate) struct Model {
    pub(crate) document: Document,
    pub(crate) lang: Lang,
    pub(crate) settings: Settings,
    pub(crate) files: Files,
    pub(crate) reports: Vec<Report>,
    pub(crate) renaming: Option<Item>,
    /// The view that is worked in.
    pub(crate) active: Option<String>,
    pub(crate) explainer: Explainer,
    swatches: Swatches,
}

/// The views that are shown.
#[derive(Debug)]
pub(crate) struct Panes {
    // the sessions end before the threads that serve them
    pub(crate) live: BTreeMap<String, LiveView>,
    renderer: Renderer,
    picker: Picker,
    wireframes: Wireframes,
}

/// The program.
pub struct Studio {
    pub(crate) model: Model,
    pub(crate) panes: Panes,
    pub(crate) toasts: Toasts,
    pub(crate) modal: Option<Modal>,
    pub(crate) exports: Exports,
    pub(crate) dialogs: Box<dyn Dialogs>,
    pub(crate) browser: Option<Browser>,
    journal: Option<Journal>,
    /// The window may close though there are changes.
    pub(crate) leaving: bool,
    title: String,
}

impl std::fmt::Debug for Studio {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Studio").field("model", &self.model).finish_non_exhaustive()
    }
}

impl Studio {
    /// A window that begins as it is told.
    pub fn new(ctx: &egui::Context, start: Start) -> Studio {
        theme::install(ctx);
        ctx.options_mut(|options| options.zoom_with_keyboard = false);
        let mut settings = start.settings;
        ctx.set_theme(settings.theme);
        ctx.set_zoom_factor(settings.zoom);
        let locale = || sys_locale::get_locale().map(|locale| Lang::of_locale(&locale)).unwrap_or_default();
        let lang = start.lang.or(settings.language()).unwrap_or_else(locale);
        settings.layout = std::mem::take(&mut settings.layout).fitted(&start.stage);
        let waker = ctx.clone();
        let left_behind = start.journals.as_deref().map(journal::left_behind).unwrap_or_default();
        let recovery = left_behind.into_iter().find_map(|journal| Some((journal.read()?, journal)));
        let mut studio = Studio {
            model: Model {
                files: Files::default(),
                document: Document::new(StepName::Opened, start.stage),
                lang,
                settings,
                reports: Vec::new(),
                renaming: None,
                active: None,
                explainer: Explainer::default(),
                swatches: Swatches::new(ctx.clone(), start.tracing),
            },
            panes: Panes {
                live: BTreeMap::new(),
                renderer: Renderer::new(None, start.tracing, move || {
                    waker.request_repaint_after_for(BETWEEN_NEWS, ViewportId::ROOT);
                }),
                picker: Picker::new(ctx.clone()),
                wireframes: Wireframes::default(),
            },
            toasts: Toasts::default(),
            modal: recovery.map(|(entry, journal)| Modal::Recover(Box::new(entry), journal)),
            // without a journal one works as well, only not as safely
            journal: start.journals.and_then(|folder| Journal::begin(&folder).ok()),
            exports: Exports::new(start.tracing),
            dialogs: start.dialogs,
            browser: None,
            leaving: false,
            title: String::new(),
        };
        studio.open_all(ctx, start.open);
        studio
    }

    /// The scene and its views, for tests and for whoever wants to know.
    pub fn document(&self) -> &Document {
        &self.model.document
    }

    /// The views that are shown, in the order of their panes.
    pub fn shown(&self) -> Vec<String> {
        self.model.settings.layout.views()
    }

    /// The messages that are shown.
    pub fn toasts(&self) -> &Toasts {
        &self.toasts
    }

    /// The view of that name while it is shown.
    pub fn live(&self, view: &str) -> Option<&LiveView> {
        self.panes.live.get(view)
    }

    /// Takes what threads and the system have to tell.
    fn take_news(&mut self, ctx: &egui::Context) {
        for live in self.panes.live.values_mut() {
            live.poll();
        }
        let answers: Vec<Answer> = self.panes.picker.answers().collect();
        for answer in answers {
            self.answer(ctx, answer);
        }
        self.take_files(ctx);
        let dropped = ctx.input(|input| input.raw.dropped_files.clone());
        for file in dropped {
            let path = file.path().to_owned();
            self.perform(ctx, Action::File(FileAction::Open(Some(path))));
        }
        let returns = ctx.input(|input| input.raw.events.contains(&egui::Event::WindowFocused(true)));
        if returns {
            self.look_outside(ctx);
        }
        let closes = ctx.input(|input| input.viewport().close_requested());
        if closes && !self.leaving && self.model.modified() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.ask_about_changes(ctx, After::Quit);
        }
    }

    /// Takes what stands under a pointer.
    fn answer(&mut self, ctx: &egui::Context, answer: Answer) {
        if let Purpose::Select { more } = answer.purpose {
            let item = answer.picked.as_ref().map(|picked| Item::Object(picked.object.clone()));
            let selection = panels::view::picked(&self.model.document, item, more);
            self.perform(ctx, Action::Select(selection));
        }
        if let Some(live) = self.panes.live.get_mut(&*answer.view) {
            live.under = Some(answer);
        }
    }

    /// Makes the shown views what the layout says, and lets each follow the document.
    fn arrange(&mut self) {
        let model = &mut self.model;
        let stage = model.document.stage();
        let shown = model.settings.layout.views();
        self.panes.live.retain(|name, _| shown.contains(name));
        for name in &shown {
            if !self.panes.live.contains_key(name) {
                let live = LiveView::new(self.panes.renderer.open());
                self.panes.live.insert(name.clone(), live);
            }
        }
        let known = model.active.as_ref().is_some_and(|active| shown.contains(active));
        if !known {
            model.active = shown.first().cloned();
            if let Some(live) = model.active.as_ref().and_then(|active| self.panes.live.get(active)) {
                live.activate();
            }
        }
        for (name, live) in &mut self.panes.live {
            live.follow(stage, name);
        }
    }

    /// Lets the explanation follow what its view shows, as long as it is seen. Without a pixel it begins in the middle
    /// of the view that is worked in.
    fn explain(&mut self, ctx: &egui::Context) {
        let model = &mut self.model;
        if !model.settings.tabs || model.settings.tab != Tab::Explain {
            return;
        }
        let shown = |target: &Target| self.panes.live.contains_key(&*target.view);
        if !model.explainer.target().is_some_and(shown)
            && let Some(active) = &model.active
        {
            model.explainer.aim(Target { view: active.as_str().into(), at: (0.5, 0.5) });
        }
        let live = model.explainer.target().and_then(|target| self.panes.live.get(&*target.view));
        if let Some(live) = live
            && let (Some(world), Some(scene), Some(view)) = (live.session().world(), live.scene(), live.view())
        {
            model.explainer.follow(ctx, world, scene, view);
        }
    }

    /// Everything in the main window.
    fn panels(&mut self, ui: &mut Ui, palette: &Palette) -> Vec<Action> {
        let active =
            self.model.active.as_ref().and_then(|active| self.panes.live.get(active).map(|live| (active, live)));
        let pane = active.map(|(name, live)| PaneState {
            fit: live.fit,
            grid: live.grid,
            paused: live.session().status().paused,
            detached: self.model.settings.layout.is_detached(name),
        });
        let context = self.model.context(palette, pane);
        let settings = context.settings;
        let mut actions = Vec::new();
        if self.modal.is_none() && self.browser.is_none() {
            actions.extend(entry::pressed(ui.ctx(), &context));
        }
        let bar = |margin| Frame::new().fill(palette.bar).inner_margin(margin);
        let wide = |inset: i8| Margin::symmetric(inset, 3);
        actions.extend(Panel::top("menu").frame(bar(wide(6))).show(ui, |ui| bars::menu_bar(ui, &context)).inner);
        actions.extend(Panel::top("tools").frame(bar(wide(8))).show(ui, |ui| bars::tool_bar(ui, &context)).inner);
        Panel::bottom("status").frame(bar(Margin::symmetric(10, 2))).exact_size(24.0).show(ui, |ui| {
            bars::status_bar(ui, &context, self.panes.live.values());
        });
        let side = Frame::new().fill(palette.panel);
        if settings.tabs {
            let panel = Panel::bottom("tabs").frame(side).resizable(true).default_size(220.0).size_range(80.0..=600.0);
            actions.extend(panel.show(ui, |ui| tabs(ui, &context)).inner);
        }
        if settings.outliner {
            let panel =
                Panel::left("outliner").frame(side).resizable(true).default_size(216.0).size_range(160.0..=480.0);
            let name = words::outliner(context.lang);
            actions.extend(panel.show(ui, |ui| titled(ui, &context, &name, panels::outliner::show)).inner);
        }
        if settings.properties {
            let panel =
                Panel::right("properties").frame(side).resizable(true).default_size(330.0).size_range(260.0..=520.0);
            let name = words::properties(context.lang);
            actions.extend(panel.show(ui, |ui| titled(ui, &context, &name, panels::properties::show)).inner);
        }
        let mut layout = settings.layout.clone();
        CentralPanel::default().frame(Frame::new().fill(palette.ground)).show(ui, |ui| {
            let mut tiles = Tiles {
                context: &context,
                live: &mut self.panes.live,
                picker: &self.panes.picker,
                wireframes: &mut self.panes.wireframes,
                actions: &mut actions,
            };
            if layout.tree.root().is_none() || layout.tree.tiles.is_empty() {
                nothing(ui, &context);
            } else {
                layout.tree.ui(&mut tiles, ui);
            }
        });
        for name in &layout.detached {
            actions.extend(detached(
                ui,
                &context,
                name,
                &mut self.panes.live,
                &self.panes.picker,
                &mut self.panes.wireframes,
            ));
        }
        layout.tree.simplify(&SIMPLIFICATION);
        self.model.settings.layout = layout;
        actions
    }
}

impl Model {
    /// What panels may read.
    pub(crate) fn context<'a>(&'a self, palette: &'a Palette, pane: Option<PaneState>) -> Context<'a> {
        Context {
            document: &self.document,
            lang: self.lang,
            palette,
            active: self.active.as_deref(),
            pane,
            settings: &self.settings,
            path: self.path(),
            modified: self.modified(),
            renaming: self.renaming.as_ref(),
            reports: &self.reports,
            explainer: &self.explainer,
            swatches: &self.swatches,
        }
    }

    /// The file of the scene.
    fn path(&self) -> Option<&std::path::Path> {
        self.document.scene_file().map(|file| file.path.as_path())
    }

    /// Whether there are changes that are not saved.
    pub(crate) fn modified(&self) -> bool {
        self.document.has_work_to_lose()
    }

    /// The name of the document for titles and questions.
    pub(crate) fn name(&self) -> String {
        let file = self.path().and_then(std::path::Path::file_name);
        file.map_or_else(|| words::untitled(self.lang), |name| name.to_string_lossy().into_owned())
    }
}

impl eframe::App for Studio {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        let ctx = ui.ctx().clone();
        self.take_news(&ctx);
        self.arrange();
        self.explain(&ctx);
        let palette = Palette::of(ctx.theme());
        let actions = self.panels(ui, palette);
        modals::show(self, &ctx, palette);
        self.exports.show(&ctx, palette, self.model.lang);
        self.toasts.show(&ctx, palette, self.model.lang);
        modals::drop_hint(&ctx, palette, self.model.lang);
        if !actions.is_empty() {
            ctx.request_repaint();
        }
        for action in actions {
            self.perform(&ctx, action);
        }
        self.arrange();
        if let Some(journal) = &mut self.journal {
            journal.follow(&self.model.document);
        }
        let name = self.model.name();
        let title = match self.model.modified() {
            true => words::window_title_modified(self.model.lang, name),
            false => words::window_title(self.model.lang, name),
        };
        if title != self.title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        eframe::set_value(storage, settings::KEY, &self.model.settings);
    }

    fn on_exit(&mut self, _gl: Option<&eframe::glow::Context>) {
        // who closes the window has been asked; only a crash leaves something behind
        if let Some(journal) = &mut self.journal {
            journal.forget();
        }
    }

    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        visuals.panel_fill.to_normalized_gamma_f32()
    }
}

impl Studio {
    /// Keeps what was recovered before what kept it goes.
    pub(crate) fn keep_recovered(&mut self) {
        if let Some(journal) = &mut self.journal {
            journal.follow(&self.model.document);
            journal.wait();
        }
    }

    /// Panels and panes as in the beginning.
    pub(crate) fn reset_layout(&mut self) {
        let settings = &mut self.model.settings;
        (settings.outliner, settings.properties, settings.tabs) = (true, true, true);
        settings.layout = Layout::of(self.model.document.stage());
    }
}
