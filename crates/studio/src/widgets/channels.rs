//! One number or three: a coefficient, a shininess, an index. A link holds the channels together.

use super::number::{NumberField, raw};
use super::{Change, track};
use crate::chrome::small_icon_switch;
use egui::{Id, Ui};
use egui_material_icons::icons::{ICON_LINK, ICON_LINK_OFF};
use lancer_document::number::NumberError;
use lancer_scene::Rgb;
use lancer_words::{Lang, studio::panels as words};
use std::ops::RangeInclusive;

/// How the channels are shown and bounded.
#[derive(Clone, Debug)]
pub struct Channels<'a> {
    /// Their name for screen readers.
    pub name: &'a str,
    /// What each must lie in.
    pub range: RangeInclusive<f64>,
    /// How much one point of dragging changes them.
    pub speed: f64,
    /// The language of the names.
    pub lang: Lang,
}

/// Shows one number while the channels are linked and equal, three otherwise.
pub fn channels(
    ui: &mut Ui,
    id: Id,
    value: Rgb,
    field: &Channels<'_>,
    refused: &mut Option<NumberError>,
) -> Change<Rgb> {
    let apart_id = id.with("apart");
    let mut apart = !value.is_uniform() || ui.data(|data| data.get_temp(apart_id).unwrap_or(false));
    let mut changed = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let icon = if apart { ICON_LINK_OFF } else { ICON_LINK };
        if small_icon_switch(ui, !apart, icon, &words::linked(field.lang, field.name)).clicked() {
            apart = !apart;
            if !apart && !value.is_uniform() {
                let mean = (value.r + value.g + value.b) / 3.0;
                changed = Some(Rgb::splat((mean * 1e4).round() / 1e4));
            }
        }
        let count = if apart { 3 } else { 1 };
        let width = ((ui.available_width() - 4.0 * (count as f32 - 1.0)).max(50.0) / count as f32).floor();
        for channel in 0..count {
            let name = if apart { words::channel(field.lang, field.name, channel) } else { field.name.to_owned() };
            let number = NumberField {
                name: &name,
                prefix: "",
                range: field.range.clone(),
                speed: field.speed,
                whole: false,
                width,
            };
            let (response, shown) = raw(ui, value[channel], &number, refused);
            if response.changed() {
                let mut values = if apart { value } else { Rgb::splat(shown) };
                values[channel] = shown;
                changed = Some(values);
            }
            if apart {
                response.on_hover_text(name);
            }
        }
    });
    ui.data_mut(|data| data.insert_temp(apart_id, apart));
    track(ui, id, changed)
}
