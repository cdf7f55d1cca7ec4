//! The small parts that bars and headers are made of. An icon never stands without a name.

use egui::{Button, Response, Role, Ui, Vec2, WidgetInfo};
use egui_material_icons::MaterialIcon;

/// The size of an icon in a bar.
pub const ICON: f32 = 17.0;
/// The side of a button that shows an icon alone.
pub const SIDE: f32 = 27.0;
/// The side of such a button in a row of a list or of properties.
pub const SMALL: f32 = 22.0;

/// Little room around icons.
fn tight<R>(ui: &mut Ui, add: impl FnOnce(&mut Ui) -> R) -> R {
    ui.scope(|ui| {
        ui.spacing_mut().button_padding = Vec2::splat(2.0);
        ui.spacing_mut().interact_size = Vec2::ZERO;
        add(ui)
    })
    .inner
}

/// A button that shows an icon alone; its name is told to screen readers and under the pointer.
pub fn icon_button(ui: &mut Ui, icon: MaterialIcon, name: &str) -> Response {
    sized_icon_button(ui, icon, SIDE, name)
}

/// The same in a row, no higher than its text.
pub fn small_icon_button(ui: &mut Ui, icon: MaterialIcon, name: &str) -> Response {
    sized_icon_button(ui, icon, SMALL, name)
}

fn sized_icon_button(ui: &mut Ui, icon: MaterialIcon, side: f32, name: &str) -> Response {
    let sign = match side < SIDE {
        true => icon.rich_text().size(ICON - 2.0).weak(),
        false => icon.rich_text().size(ICON),
    };
    let button = Button::new(sign).frame_when_inactive(false).min_size(Vec2::splat(side));
    named(tight(ui, |ui| ui.add(button)), Role::Button, None, name)
}

/// A switch that shows an icon alone.
pub fn icon_switch(ui: &mut Ui, on: bool, icon: MaterialIcon, name: &str) -> Response {
    sized_icon_switch(ui, on, icon, SIDE, name)
}

/// The same in a row, no higher than its text.
pub fn small_icon_switch(ui: &mut Ui, on: bool, icon: MaterialIcon, name: &str) -> Response {
    sized_icon_switch(ui, on, icon, SMALL, name)
}

fn sized_icon_switch(ui: &mut Ui, on: bool, icon: MaterialIcon, side: f32, name: &str) -> Response {
    let size = if side < SIDE { ICON - 2.0 } else { ICON };
    let button =
        Button::new(icon.rich_text().size(size)).selected(on).frame_when_inactive(on).min_size(Vec2::splat(side));
    named(tight(ui, |ui| ui.add(button)), Role::Button, Some(on), name)
}

/// Gives a widget its name.
pub fn named(response: Response, kind: Role, selected: Option<bool>, name: &str) -> Response {
    let enabled = response.enabled();
    response.widget_info(|| match selected {
        Some(on) => WidgetInfo::selected(kind, enabled, on, name),
        None => WidgetInfo::labeled(kind, enabled, name),
    });
    response.on_hover_text(name).on_disabled_hover_text(name)
}

/// A button that shows an icon alone and opens a menu.
pub fn icon_menu(ui: &mut Ui, icon: MaterialIcon, side: f32, name: &str, content: impl FnOnce(&mut Ui)) {
    let sign = if side < SIDE { icon.rich_text().size(ICON).weak() } else { icon.rich_text().size(ICON) };
    let button = Button::new(sign).frame_when_inactive(false).min_size(Vec2::splat(side));
    let config =
        egui::containers::menu::MenuConfig::default().close_behavior(egui::PopupCloseBehavior::CloseOnClickOutside);
    let (roomy, high) = (ui.spacing().button_padding, ui.spacing().interact_size);
    let (response, _) = tight(ui, |ui| {
        egui::containers::menu::MenuButton::from_button(button).config(config).ui(ui, |ui| {
            ui.spacing_mut().button_padding = roomy;
            ui.spacing_mut().interact_size = high;
            ui.set_min_width(180.0);
            content(ui);
        })
    });
    named(response, Role::Button, None, name);
}
