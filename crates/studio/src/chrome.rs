//! The small parts that bars and headers are made of. An icon never stands without a name.

use egui::{Button, Response, Role, Ui, Vec2, WidgetInfo};
use egui_material_icons::MaterialIcon;

/// The size of an icon in a bar.
pub const ICON: f32 = 17.0;
/// The side of a button that shows an icon alone.
const SIDE: f32 = 27.0;

/// Little room around icons.
fn tight<R>(ui: &mut Ui, add: impl FnOnce(&mut Ui) -> R) -> R {
    ui.scope(|ui| {
        ui.spacing_mut().button_padding = Vec2::splat(4.0);
        add(ui)
    })
    .inner
}

/// A button that shows an icon alone; its name is told to screen readers and under the pointer.
pub fn icon_button(ui: &mut Ui, icon: MaterialIcon, name: &str) -> Response {
    let button = Button::new(icon.rich_text().size(ICON)).frame_when_inactive(false).min_size(Vec2::splat(SIDE));
    named(tight(ui, |ui| ui.add(button)), Role::Button, None, name)
}

/// A switch that shows an icon alone.
pub fn icon_switch(ui: &mut Ui, on: bool, icon: MaterialIcon, name: &str) -> Response {
    let button =
        Button::new(icon.rich_text().size(ICON)).selected(on).frame_when_inactive(on).min_size(Vec2::splat(SIDE));
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
pub fn icon_menu(ui: &mut Ui, icon: MaterialIcon, name: &str, content: impl FnOnce(&mut Ui)) {
    let button = Button::new(icon.rich_text().size(ICON)).frame_when_inactive(false).min_size(Vec2::splat(SIDE));
    let config =
        egui::containers::menu::MenuConfig::default().close_behavior(egui::PopupCloseBehavior::CloseOnClickOutside);
    let roomy = ui.spacing().button_padding;
    let (response, _) = tight(ui, |ui| {
        egui::containers::menu::MenuButton::from_button(button).config(config).ui(ui, |ui| {
            ui.spacing_mut().button_padding = roomy;
            ui.set_min_width(180.0);
            content(ui);
        })
    });
    named(response, Role::Button, None, name);
}
