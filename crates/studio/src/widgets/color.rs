//! A colour: a field that opens a picker, and its linear numbers.

use super::{Change, Channels, channels, track};
use egui::{Id, Role, Ui, WidgetInfo};
use lancer_document::number::NumberError;
use lancer_scene::Rgb;

/// Shows a colour in 0..1. The field shows it as a picture would: its bytes, without gamma.
pub fn color(ui: &mut Ui, id: Id, value: Rgb, field: &Channels<'_>, refused: &mut Option<NumberError>) -> Change<Rgb> {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let mut bytes = value.to_bytes();
        let response = ui
            .scope(|ui| {
                ui.spacing_mut().interact_size = egui::vec2(26.0, 22.0);
                // the frame of the field: without it white would be lost on a white panel
                let frame = ui.visuals().window_stroke.color;
                ui.visuals_mut().widgets.inactive.bg_fill = frame;
                ui.color_edit_button_srgb(&mut bytes)
            })
            .inner;
        let enabled = response.enabled();
        response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, field.name));
        let picked = track(ui, id.with("picker"), response.changed().then(|| Rgb::from_bytes(bytes)));
        picked.or(channels(ui, id, value, field, refused))
    })
    .inner
}
