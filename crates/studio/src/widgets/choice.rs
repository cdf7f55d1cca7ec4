//! One of several words, and the steps of the algorithm.

use super::Change;
use egui::{ComboBox, Id, Role, Ui, WidgetInfo};
use lancer_scene::Steps;
use lancer_words::{Lang, studio::view as words};

/// Shows the word that is chosen, and the others in a list.
pub fn choice(ui: &mut Ui, id: Id, chosen: usize, words: &[String], name: &str) -> Change<usize> {
    let mut change = Change::Kept;
    let shown = words.get(chosen).map_or("", String::as_str);
    let response = ComboBox::from_id_salt(id)
        .selected_text(shown)
        .width(ui.available_width().max(60.0))
        .show_ui(ui, |ui| {
            for (place, word) in words.iter().enumerate() {
                if ui.selectable_label(place == chosen, word).clicked() {
                    // a key closes nothing by itself
                    ui.close();
                    if place != chosen {
                        change = Change::Set(place);
                    }
                }
            }
        })
        .response;
    let enabled = response.enabled();
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(shown.to_owned()),
        ..WidgetInfo::labeled(Role::ComboBox, enabled, name)
    });
    change
}

/// Shows the steps that can be left out as switches.
pub fn steps(ui: &mut Ui, mut steps: Steps, lang: Lang) -> Change<Steps> {
    let mut changed = false;
    ui.vertical(|ui| {
        changed |= ui.checkbox(&mut steps.shadows, words::shadows(lang)).changed();
        changed |= ui.checkbox(&mut steps.reflection, words::reflection(lang)).changed();
        changed |= ui.checkbox(&mut steps.transparency, words::transparency(lang)).changed();
    });
    if changed { Change::Set(steps) } else { Change::Kept }
}
