//! A number: dragged, or typed as arithmetic.

use super::{Change, track};
use egui::{DragValue, Response, Ui, WidgetInfo};
use lancer_document::number::{NumberError, evaluate};
use std::cell::RefCell;
use std::ops::RangeInclusive;

/// How a number is shown and bounded.
#[derive(Clone, Debug)]
pub struct NumberField<'a> {
    /// Its name for screen readers.
    pub name: &'a str,
    /// What stands before the number; may be empty.
    pub prefix: &'a str,
    /// What it must lie in.
    pub range: RangeInclusive<f64>,
    /// How much one point of dragging changes it.
    pub speed: f64,
    /// Whether only whole numbers are meant.
    pub whole: bool,
    /// Its width in points.
    pub width: f32,
}

/// Shows a number. A text that is no number is refused with its reason in `refused`.
pub fn number(ui: &mut Ui, value: f64, field: &NumberField<'_>, refused: &mut Option<NumberError>) -> Change<f64> {
    let (response, shown) = raw(ui, value, field, refused);
    track(ui, response.id, response.changed().then_some(shown))
}

/// The field alone, with what it now holds.
pub(super) fn raw(
    ui: &mut Ui,
    value: f64,
    field: &NumberField<'_>,
    refused: &mut Option<NumberError>,
) -> (Response, f64) {
    let mut shown = value;
    let error = RefCell::new(None);
    let drag = DragValue::new(&mut shown)
        .range(field.range.clone())
        .speed(field.speed)
        .prefix(field.prefix)
        .max_decimals(if field.whole { 0 } else { 5 })
        .update_while_editing(false)
        .custom_formatter(|value, _| written(value))
        .custom_parser(|text| match evaluate(text, value) {
            Ok(number) => Some(if field.whole { number.round() } else { number }),
            Err(reason) => {
                *error.borrow_mut() = Some(reason);
                None
            }
        });
    let response = ui.add_sized([field.width, ui.spacing().interact_size.y], drag);
    let enabled = response.enabled();
    response
        .widget_info(|| WidgetInfo { label: Some(field.name.to_owned()), ..WidgetInfo::drag_value(enabled, shown) });
    // the text is also read while it is typed; only what is left behind is refused
    if response.lost_focus() {
        *refused = error.into_inner().or(refused.take());
    }
    (response, shown)
}

/// A number as short as it can be written; at most nine digits are shown, all are kept.
fn written(value: f64) -> String {
    let short = format!("{value}");
    if short.len() <= 10 { short } else { format!("{}", (value * 1e6).round() / 1e6) }
}
