//! The scene and the views as documents, as they would be saved: with the comments, the order and the spacing of the
//! files that they were read from.

use super::lines;
use crate::{Action, Context};
use egui::Id;
use lancer_formats::xml::Document as Xml;
use lancer_words::studio::panels as words;

/// Shows the panel; gives what the user wants.
pub fn show(ui: &mut egui::Ui, context: &Context<'_>) -> Vec<Action> {
    let id = Id::unique("which document");
    let mut views = ui.data(|data| data.get_temp::<bool>(id)).unwrap_or(false);
    let lang = context.lang;
    let choose = |ui: &mut egui::Ui| {
        ui.selectable_value(&mut views, false, words::document_of_scene(lang));
        ui.selectable_value(&mut views, true, words::document_of_views(lang));
        ui.data_mut(|data| data.insert_temp(id, views));
        ui.add_space(8.0);
    };
    let shows_views = ui.data(|data| data.get_temp::<bool>(id)).unwrap_or(false);
    if shows_views {
        lines::show(ui, context, "scene.view.xml", |document, _| readable("views.xml", &document.views_text()), choose)
    } else {
        lines::show(ui, context, "scene.xml", |document, _| readable("scene.xml", &document.scene_text()), choose)
    }
}

/// The text of a document's bytes, whatever their encoding.
fn readable(name: &str, bytes: &[u8]) -> String {
    match Xml::read(name, bytes) {
        Ok(document) => document.text().to_owned(),
        Err(_) => String::from_utf8_lossy(bytes).into_owned(),
    }
}
