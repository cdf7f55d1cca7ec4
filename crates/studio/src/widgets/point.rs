//! Three coordinates, and the width and height of a screen.

use super::number::{NumberField, raw};
use super::{Change, track};
use egui::Ui;
use lancer_document::number::NumberError;
use lancer_scene::{DVec3, limits};

/// Shows three coordinates in a row, named `name x`, `name y`, `name z`.
pub fn point(
    ui: &mut Ui,
    id: egui::Id,
    value: DVec3,
    name: &str,
    speed: f64,
    refused: &mut Option<NumberError>,
) -> Change<DVec3> {
    let values = value.to_array();
    row(ui, id, values, &["x", "y", "z"], name, (-limits::COORDINATE, speed), refused).map(DVec3::from)
}

/// Shows a width and a height.
pub fn size(
    ui: &mut Ui,
    id: egui::Id,
    value: [f64; 2],
    name: &str,
    speed: f64,
    refused: &mut Option<NumberError>,
) -> Change<[f64; 2]> {
    row(ui, id, value, &["w", "h"], name, (limits::LEAST, speed), refused)
}

/// Numbers side by side that share the width.
fn row<const N: usize>(
    ui: &mut Ui,
    id: egui::Id,
    values: [f64; N],
    letters: &[&str; N],
    name: &str,
    (least, speed): (f64, f64),
    refused: &mut Option<NumberError>,
) -> Change<[f64; N]> {
    let mut changed = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let width = (ui.available_width() - 4.0 * (N as f32 - 1.0)).max(60.0) / N as f32;
        for place in 0..N {
            let field = NumberField {
                name: &format!("{name} {}", letters[place]),
                prefix: "",
                range: least..=limits::COORDINATE,
                speed,
                whole: false,
                width: width.floor(),
            };
            let (response, shown) = raw(ui, values[place], &field, refused);
            if response.changed() {
                let mut values = values;
                values[place] = shown;
                changed = Some(values);
            }
            response.on_hover_text(letters[place]);
        }
    });
    track(ui, id, changed)
}
