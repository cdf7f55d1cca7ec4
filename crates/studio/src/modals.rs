//! Windows that ask for an answer before anything else goes on, and sheets to read.

use crate::app::Studio;
use crate::dialogs::Reply;
use crate::entry::Entry;
use crate::files::After;
use crate::foreign::Losses;
use crate::menus::MENUS;
use crate::questions::Question;
use crate::theme::Palette;
use egui::{Align, Button, Grid, Id, Key, Layout, Modifiers, RichText, ScrollArea, Ui};
use egui_material_icons::icons::ICON_WARNING;
use lancer_document::Document;
use lancer_document::journal::{Entry as Kept, LeftBehind};
use lancer_formats::Describe;
use lancer_formats::load::LoadOptions;
use lancer_words::{Lang, studio::app as words, studio::menu};
use std::path::Path;

/// What is asked or shown.
#[derive(Debug)]
pub(crate) enum Modal {
    /// Changes are not saved.
    Unsaved(After),
    /// The sheet of shortcuts.
    Shortcuts,
    /// What the program is.
    About,
    /// What a format cannot hold of what is exported to it.
    Losses(Box<Losses>),
    /// A program before this one has ended without saving: what it kept.
    Recover(Box<Kept>, LeftBehind),
}

/// Shows what is open and carries out the answer.
pub(crate) fn show(studio: &mut Studio, ctx: &egui::Context, palette: &Palette) {
    let lang = studio.model.lang;
    if let Some(browser) = &mut studio.browser
        && let Some(reply) = browser.show(ctx, palette, lang)
    {
        studio.browser = None;
        if let Reply::Chosen(path) = reply {
            studio.chosen(ctx, path);
        } else {
            studio.model.files.forget_question();
        }
    }
    studio.show_loading(ctx, palette);
    match studio.modal.take() {
        Some(Modal::Unsaved(after)) => unsaved(studio, ctx, palette, after),
        Some(Modal::Shortcuts) => {
            let open = sheet(ctx, palette, lang, |ui| shortcuts(ui, palette, lang));
            studio.modal = open.then_some(Modal::Shortcuts);
        }
        Some(Modal::About) => {
            let open = sheet(ctx, palette, lang, |ui| about(ui, lang));
            studio.modal = open.then_some(Modal::About);
        }
        Some(Modal::Losses(losses)) => ask_about_losses(studio, ctx, palette, losses),
        Some(Modal::Recover(entry, journal)) => recover(studio, ctx, palette, entry, journal),
        None => {}
    }
}

/// A window that everything else waits for.
pub(crate) fn modal(ctx: &egui::Context, name: &str) -> egui::Modal {
    let frame = egui::Frame::window(&ctx.style_of(ctx.theme())).inner_margin(egui::Margin::same(20));
    egui::Modal::new(Id::unique(name)).frame(frame)
}

/// A button that is taken by Enter.
pub(crate) fn default_button<'a>(text: String, palette: &Palette) -> Button<'a> {
    Button::new(RichText::new(text).strong()).fill(palette.selected).min_size(egui::vec2(90.0, 28.0))
}

fn unsaved(studio: &mut Studio, ctx: &egui::Context, palette: &Palette, after: After) {
    let (lang, name) = (studio.model.lang, studio.model.name());
    let mut answer = None;
    let modal = modal(ctx, "unsaved").show(ctx, |ui| {
        ui.set_width(440.0);
        ui.heading(words::unsaved_title(lang));
        ui.add_space(6.0);
        ui.label(words::unsaved_text(lang, name));
        ui.add_space(14.0);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let enter = ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
            if ui.add(default_button(words::unsaved_save(lang), palette)).clicked() || enter {
                answer = Some(Answer::Save);
            }
            if ui.add(Button::new(words::cancel(lang)).min_size(egui::vec2(80.0, 28.0))).clicked() {
                answer = Some(Answer::Cancel);
            }
            if ui.add(Button::new(words::unsaved_discard(lang)).min_size(egui::vec2(80.0, 28.0))).clicked() {
                answer = Some(Answer::Discard);
            }
        });
    });
    match answer.or_else(|| modal.should_close().then_some(Answer::Cancel)) {
        Some(Answer::Save) => studio.save_then(ctx, after),
        Some(Answer::Discard) => studio.go_on(ctx, after),
        Some(Answer::Cancel) => {}
        None => studio.modal = Some(Modal::Unsaved(after)),
    }
}

/// Says what an export loses, and asks whether it is made.
fn ask_about_losses(studio: &mut Studio, ctx: &egui::Context, palette: &Palette, losses: Box<Losses>) {
    let lang = studio.model.lang;
    let mut answer = None;
    let modal = modal(ctx, "losses").show(ctx, |ui| {
        ui.set_width(460.0);
        ui.heading(words::losses_title(lang, losses.what.format(lang)));
        ui.add_space(6.0);
        ui.label(words::losses_text(lang));
        ui.add_space(8.0);
        ScrollArea::vertical().max_height(260.0).show(ui, |ui| {
            for loss in &losses.losses {
                ui.horizontal_top(|ui| {
                    ui.label(ICON_WARNING.rich_text().size(15.0).color(palette.warning));
                    ui.add(egui::Label::new(loss.message(lang)).wrap());
                });
            }
        });
        ui.add_space(14.0);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let enter = ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
            if ui.add(default_button(words::export(lang), palette)).clicked() || enter {
                answer = Some(true);
            }
            if ui.add(Button::new(words::cancel(lang)).min_size(egui::vec2(80.0, 28.0))).clicked() {
                answer = Some(false);
            }
        });
    });
    match answer.or_else(|| modal.should_close().then_some(false)) {
        Some(true) => studio.ask(Question::Export(losses.what, losses.content)),
        Some(false) => {}
        None => studio.modal = Some(Modal::Losses(losses)),
    }
}

enum Answer {
    Save,
    Discard,
    Cancel,
}

/// Offers what a program kept that ended without saving.
fn recover(studio: &mut Studio, ctx: &egui::Context, palette: &Palette, entry: Box<Kept>, journal: LeftBehind) {
    let lang = studio.model.lang;
    let file = entry.scene.as_deref().and_then(Path::file_name).map(|name| name.to_string_lossy().into_owned());
    let name = file.unwrap_or_else(|| words::untitled(lang));
    let age = journal.written.elapsed().unwrap_or_default();
    let mut answer = None;
    let modal = modal(ctx, "recover").show(ctx, |ui| {
        ui.set_width(440.0);
        ui.heading(words::recover_title(lang));
        ui.add_space(6.0);
        ui.label(words::recover_text(lang, name, words::ago(lang, age)));
        ui.add_space(14.0);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let enter = ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
            if ui.add(default_button(words::recover(lang), palette)).clicked() || enter {
                answer = Some(Answer::Save);
            }
            if ui.add(Button::new(words::recover_later(lang)).min_size(egui::vec2(80.0, 28.0))).clicked() {
                answer = Some(Answer::Cancel);
            }
            if ui.add(Button::new(words::recover_discard(lang)).min_size(egui::vec2(80.0, 28.0))).clicked() {
                answer = Some(Answer::Discard);
            }
        });
    });
    match answer.or_else(|| modal.should_close().then_some(Answer::Cancel)) {
        Some(Answer::Save) => {
            let options = LoadOptions::default();
            let (scene, views) = entry.files(&options);
            studio.begin_document(Document::recover(*entry, scene, views, options));
            studio.keep_recovered();
            journal.discard();
        }
        Some(Answer::Discard) => journal.discard(),
        // it is offered again on the next start
        Some(Answer::Cancel) => {}
        None => studio.modal = Some(Modal::Recover(entry, journal)),
    }
}

/// A sheet to read, with a button that closes it; whether it stays open.
fn sheet(ctx: &egui::Context, palette: &Palette, lang: Lang, content: impl FnOnce(&mut Ui)) -> bool {
    let mut closed = false;
    let modal = modal(ctx, "sheet").show(ctx, |ui| {
        content(ui);
        ui.add_space(10.0);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let enter = ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
            closed = ui.add(default_button(words::close(lang), palette)).clicked() || enter;
        });
    });
    !closed && !modal.should_close()
}

/// Every key and what the mouse does.
fn shortcuts(ui: &mut Ui, palette: &Palette, lang: Lang) {
    ui.set_width(ui.ctx().content_rect().width().min(860.0) - 80.0);
    ui.heading(menu::shortcuts(lang));
    ui.add_space(6.0);
    let height = (ui.ctx().content_rect().height() - 200.0).max(120.0);
    ScrollArea::vertical().max_height(height).auto_shrink([false, true]).show(ui, |ui| {
        ui.columns(2, |columns| {
            let [left, right] = columns else { return };
            keys(left, palette, lang);
            mouse(right, palette, lang);
        });
    });
}

fn section(ui: &mut Ui, palette: &Palette, title: String) {
    ui.add_space(8.0);
    ui.label(RichText::new(title).small().strong().color(palette.accent));
}

fn keys(ui: &mut Ui, palette: &Palette, lang: Lang) {
    for (name, _, groups) in MENUS {
        let entries: Vec<Entry> =
            groups.iter().flat_map(|group| group.iter()).copied().filter(|entry| !entry.keys().is_empty()).collect();
        if entries.is_empty() {
            continue;
        }
        section(ui, palette, name(lang));
        Grid::new(name(lang)).num_columns(2).min_col_width(150.0).spacing([12.0, 3.0]).show(ui, |ui| {
            for entry in entries {
                let keys: Vec<String> =
                    entry.keys().iter().map(|keys| menu::keys(lang, &ui.ctx().format_shortcut(keys))).collect();
                ui.label(RichText::new(keys.join(", ")).color(palette.weak));
                ui.label(entry.name(lang));
                ui.end_row();
            }
        });
    }
}

fn mouse(ui: &mut Ui, palette: &Palette, lang: Lang) {
    section(ui, palette, menu::in_a_view(lang));
    type Words = fn(Lang) -> String;
    let rows: [(Words, Words); 12] = [
        (menu::click, menu::click_does),
        (menu::shift_click, menu::shift_click_does),
        (menu::drag_selected, menu::drag_selected_does),
        (menu::drag_axis, menu::drag_axis_does),
        (menu::drag_snap, menu::drag_snap_does),
        (menu::drag_escape, menu::drag_escape_does),
        (menu::orbit, menu::orbit_does),
        (menu::pan, menu::pan_does),
        (menu::wheel, menu::wheel_does),
        (menu::arrows, menu::arrows_does),
        (menu::page_keys, menu::page_keys_does),
        (menu::explain_click, menu::explain_click_does),
    ];
    let rows = rows.into_iter().chain([(menu::region as fn(Lang) -> String, menu::region_does as fn(Lang) -> String)]);
    for (what, does) in rows {
        ui.label(does(lang));
        ui.label(RichText::new(what(lang)).small().color(palette.weak));
        ui.add_space(3.0);
    }
}

fn about(ui: &mut Ui, lang: Lang) {
    ui.set_width(380.0);
    ui.heading("lancer");
    ui.add_space(6.0);
    ui.label(menu::about_text(lang));
    ui.label(menu::version(lang, env!("CARGO_PKG_VERSION")));
    ui.label(menu::licence(lang));
}

/// What is said while files hang over the window.
pub(crate) fn drop_hint(ctx: &egui::Context, palette: &Palette, lang: Lang) {
    if ctx.input(|input| input.raw.hovered_files.is_empty()) {
        return;
    }
    let layer = egui::LayerId::new(egui::Order::Foreground, Id::unique("drop"));
    let (painter, rect) = (ctx.layer_painter(layer), ctx.content_rect());
    painter.rect_filled(rect, 0.0, egui::Color32::from_black_alpha(150));
    painter.rect_stroke(rect.shrink(12.0), 8.0, egui::Stroke::new(2.0, palette.accent), egui::StrokeKind::Inside);
    let font = egui::FontId::proportional(20.0);
    painter.text(rect.center(), egui::Align2::CENTER_CENTER, words::drop_here(lang), font, egui::Color32::WHITE);
}
