//! What stands around panels and panes: titles, the tabs at the bottom, windows of their own.

use crate::entry::{self, tab_name};
use crate::panels::{self, view::Tools};
use crate::theme;
use crate::view::{LiveView, Picker};
use crate::{Action, Context, Tab, ViewAction};
use egui::{CentralPanel, Frame, Margin, Panel, Ui, ViewportBuilder, ViewportId};
use lancer_document::wireframe::Wireframes;
use lancer_words::studio::{app as words, view};
use std::collections::BTreeMap;

/// A panel below a line with its name.
pub(crate) fn titled(
    ui: &mut Ui,
    context: &Context<'_>,
    name: &str,
    show: impl FnOnce(&mut Ui, &Context<'_>) -> Vec<Action>,
) -> Vec<Action> {
    let bar = Frame::new().fill(context.palette.bar).inner_margin(Margin::symmetric(10, 4));
    Panel::top(egui::Id::unique(("title", name))).frame(bar).show(ui, |ui| {
        ui.label(egui::RichText::new(name).font(theme::title_font(12.5)));
    });
    let inner = Frame::new().fill(context.palette.panel).inner_margin(Margin::same(8));
    CentralPanel::default().frame(inner).show(ui, |ui| held(ui, |ui| show(ui, context))).inner
}

/// What is shown never makes its panel larger: a panel has the size that the user gives it.
fn held<R>(ui: &mut Ui, show: impl FnOnce(&mut Ui) -> R) -> R {
    let rect = ui.available_rect_before_wrap();
    let mut child = ui.new_child(egui::UiBuilder::new().max_rect(rect));
    child.set_clip_rect(child.clip_rect().intersect(rect.expand(4.0)));
    let result = show(&mut child);
    ui.advance_cursor_after_rect(rect);
    result
}

/// The tabs at the bottom.
pub(crate) fn tabs(ui: &mut Ui, context: &Context<'_>) -> Vec<Action> {
    let (lang, palette, mut actions) = (context.lang, context.palette, Vec::new());
    let bar = Frame::new().fill(palette.bar).inner_margin(Margin::symmetric(8, 2));
    Panel::top("tab bar").frame(bar).show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 2.0;
            for tab in Tab::ALL {
                let on = context.settings.tab == tab;
                let mut name = tab_name(tab, lang);
                let count: usize = context.reports.iter().map(|report| report.diagnostics.len()).sum();
                if tab == Tab::Problems && count > 0 {
                    name = format!("{name} ({count})");
                }
                let color = if on { palette.text } else { palette.weak };
                let button = egui::Button::new(egui::RichText::new(name).color(color)).frame_when_inactive(false);
                let response = ui.add(button.selected(false));
                response.widget_info(|| egui::WidgetInfo::selected(egui::Role::Tab, true, on, tab_name(tab, lang)));
                if on {
                    let line = response.rect.x_range().shrink(6.0);
                    ui.painter().hline(line, response.rect.bottom() + 1.0, egui::Stroke::new(2.0, palette.accent));
                }
                if response.clicked() {
                    actions.push(Action::ShowTab(tab));
                }
            }
        });
    });
    let inner = Frame::new().fill(palette.panel).inner_margin(Margin::same(8));
    CentralPanel::default().frame(inner).show(ui, |ui| {
        let show = match context.settings.tab {
            Tab::Text => panels::text::show,
            Tab::Xml => panels::xml::show,
            Tab::Explain => panels::explain::show,
            Tab::Problems => panels::problems::show,
            Tab::History => panels::history::show,
        };
        actions.extend(held(ui, |ui| show(ui, context)));
    });
    actions
}

/// What stands where no view is open.
pub(crate) fn nothing(ui: &mut Ui, context: &Context<'_>) {
    ui.centered_and_justified(|ui| {
        let text = format!("{}\n{}", view::no_view(context.lang), view::no_view_help(context.lang));
        ui.label(egui::RichText::new(text).color(context.palette.weak));
    });
}

/// A view in a window of its own.
pub(crate) fn detached(
    ui: &Ui,
    context: &Context<'_>,
    name: &str,
    live: &mut BTreeMap<String, LiveView>,
    picker: &Picker,
    wireframes: &mut Wireframes,
) -> Vec<Action> {
    let view = context.document.stage().views.iter().find(|view| &*view.name == name);
    let (Some(view), Some(live)) = (view, live.get_mut(name)) else { return Vec::new() };
    let size = [(view.width as f32).clamp(320.0, 1600.0), (view.height as f32).clamp(240.0, 1000.0) + 50.0];
    let builder = ViewportBuilder::default().with_title(words::window_title(context.lang, name)).with_inner_size(size);
    let id = ViewportId::from_hash_of(("view", name));
    ui.ctx().show_viewport_immediate(id, builder, |ui, _class| {
        let mut actions = entry::pressed(ui.ctx(), context);
        let bar = Frame::new().fill(context.palette.bar).inner_margin(Margin::symmetric(6, 1));
        Panel::top(egui::Id::unique(("bar", name))).frame(bar).show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.label(name);
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    actions.extend(crate::view::header(ui, context, live, view));
                });
            });
        });
        CentralPanel::default().frame(Frame::new().fill(context.palette.ground)).show(ui, |ui| {
            let tools = Tools { picker, wireframes };
            actions.extend(panels::view::show(ui, context, live, view, tools));
        });
        if ui.input(|input| input.viewport().close_requested()) {
            actions.push(Action::View(view.name.clone(), ViewAction::Close));
        }
        actions
    })
}
