//! Which material: one of the scene's, the built-in grey, one of its own, or a new one.

use crate::Context;
use egui::{Align, ComboBox, Id, Image, Layout, Role, Ui, Vec2, WidgetInfo};
use lancer_document::presets;
use lancer_scene::{MaterialRef, Scene, Surface};
use lancer_words::studio::panels as words;

/// What was chosen.
#[derive(Clone, Debug, PartialEq)]
pub enum MaterialChoice {
    /// The built-in grey or one of the scene's.
    Known(MaterialRef),
    /// A surface of its own, which begins as what is shown now.
    Own,
    /// A new material of the scene, from a preset or as what is shown now.
    New(Option<presets::Preset>),
}

/// Shows the material and a list of the others with their swatches.
pub fn material(
    ui: &mut Ui,
    id: Id,
    chosen: &MaterialRef,
    context: &Context<'_>,
    name: &str,
) -> Option<MaterialChoice> {
    let (scene, lang) = (&context.document.stage().scene, context.lang);
    let mut choice = None;
    let shown = match chosen {
        MaterialRef::Default => words::built_in(lang),
        MaterialRef::Named(name) => name.to_string(),
        MaterialRef::Inline(_) => words::own_material(lang),
    };
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        swatch(ui, context, &scene.surface(chosen), 24.0);
        let response = ComboBox::from_id_salt(id)
            .selected_text(&shown)
            .width(ui.available_width().max(60.0))
            .height(420.0)
            .show_ui(ui, |ui| {
                ui.set_min_width(200.0);
                choice = list(ui, scene, chosen, context);
            })
            .response;
        let enabled = response.enabled();
        response.widget_info(|| WidgetInfo {
            current_text_value: Some(shown.clone()),
            ..WidgetInfo::labeled(Role::ComboBox, enabled, name)
        });
    });
    choice
}

fn list(ui: &mut Ui, scene: &Scene, chosen: &MaterialRef, context: &Context<'_>) -> Option<MaterialChoice> {
    let lang = context.lang;
    let mut choice = None;
    // as in a menu: what is under the pointer has a field, nothing else
    egui::containers::menu::menu_style(ui.style_mut());
    for material in &scene.materials {
        let reference = MaterialRef::Named(material.name.clone());
        if row(ui, context, &material.surface, &material.name, *chosen == reference) {
            choice = Some(MaterialChoice::Known(reference));
        }
    }
    if row(ui, context, &Surface::default(), &words::built_in(lang), *chosen == MaterialRef::Default) {
        choice = Some(MaterialChoice::Known(MaterialRef::Default));
    }
    ui.separator();
    let own = matches!(chosen, MaterialRef::Inline(_));
    if ui.selectable_label(own, words::own_material(lang)).clicked() {
        ui.close();
        choice = (!own).then_some(MaterialChoice::Own);
    }
    if ui.button(words::new_material(lang)).clicked() {
        ui.close();
        choice = Some(MaterialChoice::New(None));
    }
    ui.menu_button(words::new_from_preset(lang), |ui| {
        if let Some(preset) = preset_list(ui, context) {
            choice = Some(MaterialChoice::New(Some(preset)));
        }
    });
    choice
}

/// The presets with their swatches; the one that was chosen.
pub(crate) fn preset_list(ui: &mut Ui, context: &Context<'_>) -> Option<presets::Preset> {
    let mut chosen = None;
    for preset in presets::Preset::ALL {
        if row(ui, context, &preset.surface(), &preset.text(context.lang), false) {
            chosen = Some(preset);
        }
    }
    chosen
}

fn row(ui: &mut Ui, context: &Context<'_>, surface: &Surface, name: &str, selected: bool) -> bool {
    ui.horizontal(|ui| {
        swatch(ui, context, surface, 24.0);
        let whole_row = Layout::top_down_justified(Align::LEFT);
        let clicked = ui.with_layout(whole_row, |ui| ui.selectable_label(selected, name).clicked()).inner;
        if clicked {
            ui.close();
        }
        clicked
    })
    .inner
}

/// The picture of a material, or an empty field of its size while it is rendered.
pub(crate) fn swatch(ui: &mut Ui, context: &Context<'_>, surface: &Surface, side: f32) {
    let size = Vec2::splat(side);
    match context.swatches.get(ui.ctx(), surface) {
        Some(texture) => drop(ui.add(Image::new((texture.id(), size)).corner_radius(4))),
        None => drop(ui.allocate_exact_size(size, egui::Sense::hover())),
    }
}
