//! The menu bar, the tool bar and the status bar.

use crate::chrome::{icon_button, named};
use crate::entry::Entry;
use crate::kind::Kind;
use crate::menus::{Groups, MENUS, Menu};
use crate::panels::outliner::summary;
use crate::view::LiveView;
use crate::{Action, Context, FileAction, ViewAction, WindowAction};
use egui::{Align, Button, Layout, MenuBar, RichText, Role, Ui, WidgetInfo};
use egui_material_icons::MaterialIcon;
use egui_material_icons::icons as icon;
use lancer_words::{Lang, number, studio::app, studio::menu as words, studio::view};
use std::path::Path;

/// An entry as a row of a menu.
fn row(ui: &mut Ui, context: &Context<'_>, entry: Entry, actions: &mut Vec<Action>) {
    let wanted = entry.actions(context);
    let keys = entry.keys().first().map(|keys| words::keys(context.lang, &ui.ctx().format_shortcut(keys)));
    let adds = matches!(entry, Entry::Add(_));
    let text = if adds { entry.name(context.lang) } else { entry.title(context) };
    let checked = entry.checked(context);
    let sign = match checked {
        Some(true) => Some(icon::ICON_CHECK),
        Some(false) => None,
        None => entry.icon(),
    };
    let mut button = Button::new((sign_text(sign), text.as_str()));
    if let Some(keys) = keys {
        button = button.shortcut_text(RichText::new(keys).color(context.palette.weak));
    }
    let response = ui.add_enabled(wanted.is_some(), button);
    response.widget_info(|| match checked {
        Some(on) => WidgetInfo::selected(Role::MenuItemCheckBox, wanted.is_some(), on, &text),
        None => WidgetInfo::labeled(Role::MenuItem, wanted.is_some(), &text),
    });
    if response.clicked() {
        actions.extend(wanted.unwrap_or_default());
        ui.close();
    }
}

/// The picture of an entry, or as much room.
pub(crate) fn sign_text(sign: Option<MaterialIcon>) -> RichText {
    match sign {
        Some(sign) => sign.rich_text().size(16.0),
        None => icon::ICON_CHECK.rich_text().size(16.0).color(egui::Color32::TRANSPARENT),
    }
}

fn groups(ui: &mut Ui, context: &Context<'_>, groups: Groups, actions: &mut Vec<Action>) {
    for (place, group) in groups.iter().enumerate() {
        if place > 0 {
            ui.separator();
        }
        let name = match group {
            [Entry::Look(_), ..] => Some(words::look_from(context.lang)),
            [Entry::ShowTab(_), ..] => Some(words::show_tab(context.lang)),
            [Entry::Export(_), ..] => Some(words::export(context.lang)),
            [] | [_, ..] => None,
        };
        if let Some(name) = name {
            submenu(ui, &name, |ui| group.iter().for_each(|entry| row(ui, context, *entry, actions)));
            continue;
        }
        for entry in *group {
            row(ui, context, *entry, actions);
        }
    }
}

/// A menu within a menu. Its name is read out without the room that stands where others have a picture.
fn submenu(ui: &mut Ui, name: &str, content: impl FnOnce(&mut Ui)) {
    let response = ui.menu_button((sign_text(None), name), content).response;
    response.widget_info(|| WidgetInfo::labeled(Role::MenuItem, true, name));
}

/// The menu bar.
pub(crate) fn menu_bar(ui: &mut Ui, context: &Context<'_>) -> Vec<Action> {
    let (lang, mut actions) = (context.lang, Vec::new());
    ui.spacing_mut().interact_size.y = crate::chrome::SIDE;
    MenuBar::new().ui(ui, |ui| {
        for (name, menu, entries) in MENUS {
            ui.menu_button(name(lang), |ui| {
                ui.set_min_width(240.0);
                ui.spacing_mut().interact_size.y = 24.0;
                match menu {
                    Menu::File => file(ui, context, entries, &mut actions),
                    Menu::View => {
                        views(ui, context, &mut actions);
                        groups(ui, context, entries, &mut actions);
                    }
                    Menu::Edit | Menu::Add | Menu::Render | Menu::Help => groups(ui, context, entries, &mut actions),
                }
            });
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let (sign, other) = match ui.ctx().theme() {
                egui::Theme::Dark => (icon::ICON_LIGHT_MODE, egui::ThemePreference::Light),
                egui::Theme::Light => (icon::ICON_DARK_MODE, egui::ThemePreference::Dark),
            };
            if icon_button(ui, sign, &words::switch_theme(lang)).clicked() {
                actions.push(Action::Window(WindowAction::Theme(other)));
            }
            let other = match lang {
                Lang::English => Lang::French,
                Lang::French => Lang::English,
            };
            let button = Button::new(RichText::new(other.code().to_uppercase()).strong()).frame_when_inactive(false);
            if named(ui.add(button), Role::Button, None, &words::switch_language(lang)).clicked() {
                actions.push(Action::Window(WindowAction::Language(other)));
            }
        });
    });
    actions
}

/// The menu of files, with the recent ones after the first group.
fn file(ui: &mut Ui, context: &Context<'_>, entries: Groups, actions: &mut Vec<Action>) {
    let Some((first, rest)) = entries.split_first() else { return };
    first.iter().for_each(|entry| row(ui, context, *entry, actions));
    submenu(ui, &words::open_recent(context.lang), |ui| {
        if context.settings.recent.is_empty() {
            ui.add_enabled(false, Button::new(words::no_recent(context.lang)));
        }
        for path in &context.settings.recent {
            let name =
                path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into());
            if ui.button(name).on_hover_text(path.display().to_string()).clicked() {
                actions.push(Action::File(FileAction::Open(Some(path.clone()))));
                ui.close();
            }
        }
    });
    ui.separator();
    groups(ui, context, rest, actions);
}

/// The views of the document, to be shown.
fn views(ui: &mut Ui, context: &Context<'_>, actions: &mut Vec<Action>) {
    submenu(ui, &words::show_view(context.lang), |ui| {
        for view in &context.document.stage().views {
            let open = context.settings.layout.shows(&view.name);
            if ui.add(Button::selectable(open, view.name.to_string())).clicked() {
                actions.push(Action::View(view.name.clone(), ViewAction::Show));
                ui.close();
            }
        }
    });
    ui.separator();
}

/// The tool bar: what is done most, as pictures with names.
pub(crate) fn tool_bar(ui: &mut Ui, context: &Context<'_>) -> Vec<Action> {
    const GROUPS: [&[Entry]; 4] = [
        &[Entry::New, Entry::Open, Entry::Save],
        &[Entry::Undo, Entry::Redo],
        &[
            Entry::Add(Kind::Sphere),
            Entry::Add(Kind::Plane),
            Entry::Add(Kind::Cube),
            Entry::Add(Kind::Parallelepiped),
            Entry::Add(Kind::Cone),
            Entry::Add(Kind::Facet),
            Entry::Add(Kind::Mesh),
            Entry::Add(Kind::Light),
        ],
        &[Entry::SplitRight, Entry::SplitBelow, Entry::Frame, Entry::Grid],
    ];
    let mut actions = Vec::new();
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        for (place, group) in GROUPS.into_iter().enumerate() {
            if place > 0 {
                ui.add_space(6.0);
                ui.separator();
                ui.add_space(6.0);
            }
            for entry in group {
                button(ui, context, *entry, &mut actions);
            }
        }
    });
    actions
}

fn button(ui: &mut Ui, context: &Context<'_>, entry: Entry, actions: &mut Vec<Action>) {
    let Some(icon) = entry.icon() else { return };
    let wanted = entry.actions(context);
    let keys = entry.keys().first().map(|keys| words::keys(context.lang, &ui.ctx().format_shortcut(keys)));
    let title = entry.title(context);
    let name = keys.map_or_else(|| title.clone(), |keys| format!("{title}  ({keys})"));
    let response = ui.add_enabled_ui(wanted.is_some(), |ui| match entry.checked(context) {
        Some(on) => crate::chrome::icon_switch(ui, on, icon, &name),
        None => icon_button(ui, icon, &name),
    });
    if response.inner.clicked() {
        actions.extend(wanted.unwrap_or_default());
    }
}

/// The status bar: what the document holds, and what the pictures cost.
pub(crate) fn status_bar<'a>(ui: &mut Ui, context: &Context<'_>, shown: impl Iterator<Item = &'a LiveView>) {
    let lang = context.lang;
    let small = |text: String| RichText::new(text).small().color(context.palette.weak);
    let mut rays = 0;
    let (mut longest, mut working) = (std::time::Duration::ZERO, 0);
    for live in shown {
        let status = live.session().status();
        rays += status.counts.total();
        longest = longest.max(status.elapsed);
        working += usize::from(!live.session().is_finished() && !status.paused);
    }
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        let file = context.path.and_then(Path::file_name).map(|name| name.to_string_lossy().into_owned());
        let state = match (context.modified, &file) {
            (true, _) => Some(app::modified(lang)),
            (false, Some(_)) => Some(app::saved(lang)),
            // nothing was ever saved, and there is nothing to save
            (false, None) => None,
        };
        let file = file.unwrap_or_else(|| app::untitled(lang));
        let counts = summary(context.document.stage(), lang);
        let parts: Vec<String> = [Some(file), Some(counts), state].into_iter().flatten().collect();
        ui.label(small(parts.join(" · ")));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let cost = app::totals(lang, view::compact(lang, rays), view::duration(lang, longest));
            let text = if working > 0 {
                format!("{} · {cost}", app::rendering(lang, number::views(lang, working)))
            } else {
                cost
            };
            ui.label(small(text));
        });
    });
}
