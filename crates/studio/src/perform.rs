//! The one place where what the user wants is carried out.

use crate::app::Studio;
use crate::modals::Modal;
use crate::settings::Settings;
use crate::toasts::Toast;
use crate::{Action, Tab, ViewAction, WindowAction, told};
use egui::ViewportCommand;
use egui_tiles::LinearDir;
use lancer_document::insert::{self, NewItem, Standpoint};
use lancer_document::navigate::{self, Side};
use lancer_document::{Command, Item, StepName, attribute, focus};
use lancer_scene::{DVec3, EditError, Name, View};
use lancer_trace::World;
use lancer_words::studio::app as words;
use std::sync::Arc;

impl Studio {
    /// Carries out an action, as when a panel asks for it.
    pub fn perform(&mut self, ctx: &egui::Context, action: Action) {
        let before = self.model.document.stage().views.clone();
        let outcome = self.change(ctx, action);
        if let Err(error) = outcome {
            let lang = self.model.lang;
            self.toasts.say(Toast::failed(words::refused(lang, told::edit(&error, lang))));
        }
        let stage = self.model.document.stage();
        if !stage.views.same_items(&before) {
            let layout = &mut self.model.settings.layout;
            layout.follow(&before, stage);
            if let Some(active) = &mut self.model.active {
                let place = before.iter().position(|view| *view.name == **active);
                if let Some(view) = place.and_then(|place| stage.views.get(place))
                    && before.len() == stage.views.len()
                {
                    *active = view.name.to_string();
                }
            }
            layout.prune(stage);
        }
    }

    fn change(&mut self, ctx: &egui::Context, action: Action) -> Result<(), EditError> {
        let document = &mut self.model.document;
        match action {
            Action::Apply(name, edit) => document.apply(name, &edit)?,
            Action::Run(command) => document.run(command)?,
            Action::Add(item) => self.add(item)?,
            Action::Begin(name) => document.begin(name),
            // an edit that is not possible halfway through a drag leaves what was shown before
            Action::Preview(edit) => drop(document.in_gesture().then(|| document.preview(&edit))),
            Action::Commit => document.commit(),
            Action::Cancel => document.cancel(),
            Action::Select(selection) => document.select(|current| *current = selection),
            Action::Undo => drop(document.undo()),
            Action::Redo => drop(document.redo()),
            Action::Jump(step) => drop(document.jump(step)),
            Action::File(action) => self.file(ctx, action),
            Action::View(name, action) => self.view(ctx, &name, action)?,
            Action::Rename(item) => {
                self.model.settings.outliner = true;
                self.model.renaming = Some(item);
            }
            Action::Explain(target) => {
                self.model.explainer.aim(target);
                self.model.settings.tab = Tab::Explain;
                self.model.settings.tabs = true;
            }
            Action::EndRename => self.model.renaming = None,
            Action::ShowTab(tab) => {
                self.model.settings.tab = tab;
                self.model.settings.tabs = true;
            }
            Action::CopyText(text) => {
                ctx.copy_text(text);
                self.toasts.say(Toast::done(words::copied(self.model.lang)));
            }
            Action::Say(toast) => self.toasts.say(toast),
            Action::Window(action) => self.window(ctx, action),
        }
        Ok(())
    }

    /// The view of that name.
    fn view_named(&self, name: &str) -> Option<Arc<View>> {
        self.model.document.stage().views.iter().find(|view| &*view.name == name).cloned()
    }

    /// The compiled scene that a view shows.
    fn world(&self, view: &str) -> Option<Arc<World>> {
        self.panes.live.get(view).and_then(|live| live.session().world().cloned())
    }

    /// Adds something in front of the active view. A new view is shown.
    pub(crate) fn add(&mut self, item: NewItem) -> Result<(), EditError> {
        let stage = self.model.document.stage();
        let active = self.model.active.as_ref().and_then(|active| self.view_named(active));
        let at = active.map(|view| Standpoint::of(&view, &stage.scene, self.world(&view.name).as_deref()));
        let command = insert::added(stage, item, &at.unwrap_or_default());
        let added = command.select.as_ref().and_then(|items| items.first()).cloned();
        self.model.document.run(command)?;
        if let Some(Item::View(name)) = added {
            self.show(&name, LinearDir::Horizontal);
        }
        Ok(())
    }

    /// Shows a view where there is most room, and works in it.
    fn show_somewhere(&mut self, view: &str) {
        match self.model.settings.layout.roomiest() {
            Some((neighbour, dir)) => self.model.settings.layout.show(view, Some(&neighbour), dir),
            None => self.model.settings.layout.show(view, self.model.active.as_deref(), LinearDir::Horizontal),
        }
        self.activate(view);
    }

    /// Shows a view beside the active one, and works in it.
    fn show(&mut self, view: &str, dir: LinearDir) {
        self.model.settings.layout.show(view, self.model.active.as_deref(), dir);
        self.activate(view);
    }

    fn activate(&mut self, view: &str) {
        self.model.active = Some(view.to_owned());
        if let Some(live) = self.panes.live.get(view) {
            live.activate();
        }
    }

    /// Does something to a view.
    fn view(&mut self, ctx: &egui::Context, name: &Name, action: ViewAction) -> Result<(), EditError> {
        let layout = &mut self.model.settings.layout;
        match action {
            ViewAction::Show => self.show_somewhere(name),
            ViewAction::Close => layout.close(name),
            ViewAction::Detach => layout.detach(name),
            ViewAction::Attach => {
                layout.close(name);
                self.show(name, LinearDir::Horizontal);
            }
            ViewAction::Split(dir) => self.split(name, dir)?,
            ViewAction::Focus => self.activate(name),
            ViewAction::FocusNext => {
                let shown = layout.views();
                let place = shown.iter().position(|view| view == &**name).map_or(0, |place| place + 1);
                if let Some(next) = shown.get(place % shown.len().max(1)) {
                    let next = next.clone();
                    layout.show(&next, None, LinearDir::Horizontal);
                    self.activate(&next);
                }
            }
            ViewAction::Look(side) => self.look(name, side)?,
            ViewAction::Frame => self.frame(name)?,
            ViewAction::SavePicture(format) => self.ask_for_picture(name, format),
            ViewAction::CopyPicture => self.copy_picture(ctx, name),
            ViewAction::Pause(paused) => self.with_live(name, |live| live.pause(paused)),
            ViewAction::Fit(fit) => self.with_live(name, |live| live.fit = fit),
            ViewAction::Grid(grid) => self.with_live(name, |live| live.grid = grid),
            ViewAction::First(region) => self.with_live(name, |live| live.refine(region)),
            ViewAction::Restart => self.with_live(name, crate::view::LiveView::restart),
        }
        Ok(())
    }

    fn with_live(&mut self, name: &str, change: impl FnOnce(&mut crate::view::LiveView)) {
        if let Some(live) = self.panes.live.get_mut(name) {
            change(live);
        }
    }

    /// A copy of a view in half of its place; what is selected stays selected.
    fn split(&mut self, name: &Name, dir: LinearDir) -> Result<(), EditError> {
        let Some(view) = self.view_named(name) else { return Ok(()) };
        let stage = self.model.document.stage();
        let command = insert::added(stage, NewItem::View(Some(View::clone(&view))), &Standpoint::default());
        let added = command.select.as_ref().and_then(|items| items.first()?.name().cloned());
        self.model.document.run(Command { select: None, ..command })?;
        if let Some(added) = added {
            self.model.settings.layout.show(&added, Some(name), dir);
            self.activate(&added);
        }
        Ok(())
    }

    /// Sets the eye and the screen of a view as one step.
    fn navigate(&mut self, name: &Name, to: impl FnOnce(&View, DVec3) -> View) -> Result<(), EditError> {
        let stage = self.model.document.stage();
        let vertical = navigate::vertical(stage);
        let edit = attribute::edit_view(stage, name, |view| *view = to(view, vertical));
        edit.map_or(Ok(()), |edit| self.model.document.apply(StepName::Navigated(name.clone()), &edit))
    }

    fn look(&mut self, name: &Name, side: Side) -> Result<(), EditError> {
        let Some(view) = self.view_named(name) else { return Ok(()) };
        let world = self.world(name);
        let pivot = focus(&view, &self.model.document.stage().scene, world.as_deref()).point;
        self.navigate(name, |view, vertical| navigate::look_along(view, vertical, pivot, side))
    }

    fn frame(&mut self, name: &Name) -> Result<(), EditError> {
        let (stage, selection) = (self.model.document.stage(), self.model.document.selection());
        let selected = navigate::ball_around(stage, selection.iter());
        let everything: Vec<Item> =
            stage.scene.objects.iter().map(|object| Item::Object(object.name.clone())).collect();
        let ball = selected.or_else(|| navigate::ball_around(stage, &everything));
        let Some((center, radius)) = ball else { return Ok(()) };
        self.navigate(name, |view, _| navigate::frame(view, center, radius))
    }

    /// Does something to the window.
    fn window(&mut self, ctx: &egui::Context, action: WindowAction) {
        let settings = &mut self.model.settings;
        match action {
            WindowAction::Language(lang) => {
                self.model.lang = lang;
                settings.set_language(lang);
            }
            WindowAction::Theme(theme) => {
                settings.theme = theme;
                ctx.set_theme(theme);
            }
            WindowAction::Zoom(zoom) => {
                let (least, most) = (*Settings::ZOOM.start(), *Settings::ZOOM.end());
                settings.zoom = ((zoom * 10.0).round() / 10.0).clamp(least, most);
                ctx.set_zoom_factor(settings.zoom);
            }
            WindowAction::Outliner(shown) => settings.outliner = shown,
            WindowAction::Properties(shown) => settings.properties = shown,
            WindowAction::Tabs(shown) => settings.tabs = shown,
            WindowAction::Shortcuts(shown) => self.modal = shown.then_some(Modal::Shortcuts),
            WindowAction::About(shown) => self.modal = shown.then_some(Modal::About),
            WindowAction::ResetLayout => self.reset_layout(),
        }
    }

    /// Ends the program, whatever is not saved.
    pub(crate) fn leave(&mut self, ctx: &egui::Context) {
        self.leaving = true;
        ctx.send_viewport_cmd(ViewportCommand::Close);
    }
}
