//! A number: dragged, or typed as arithmetic.

use super::{Change, track};
use egui::{DragValue, Response, TextStyle, Ui, Vec2, WidgetInfo};
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
    ui.spacing_mut().button_padding = Vec2::new(PADDING, 3.0);
    let digit = ui.ctx().fonts_mut(|fonts| fonts.glyph_width(&TextStyle::Button.resolve(ui.style()), '0'));
    let room = ((field.width - 2.0 * PADDING) / digit).max(3.0);
    let text = written(value, room);
    let drag = DragValue::new(&mut shown)
        .range(field.range.clone())
        .speed(field.speed)
        .prefix(field.prefix)
        .max_decimals(if field.whole { 0 } else { 5 })
        .update_while_editing(false)
        .custom_formatter(|value, _| written(value, room))
        // what was only looked at keeps every digit
        .custom_parser(|typed| match if typed == text { Ok(value) } else { evaluate(typed, value) } {
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

/// Room on both sides of a number.
const PADDING: f32 = 3.0;

/// A number as short as it can be written, with as many decimals as there is room for, counted in digits; all of them
/// are kept.
fn written(value: f64, room: f32) -> String {
    let width = |sign: char| match sign {
        '.' => 0.45,
        '-' => 0.7,
        _ => 1.0,
    };
    let fits = |text: &String| text.chars().map(width).sum::<f32>() <= room;
    let whole = format!("{value}");
    if fits(&whole) {
        return whole;
    }
    let rounded = (0..=6).rev().map(|decimals| {
        let text = format!("{value:.decimals$}");
        if decimals == 0 { text } else { text.trim_end_matches('0').trim_end_matches('.').to_owned() }
    });
    let is_told = |text: &String| fits(text) && !matches!(text.as_str(), "0" | "-0");
    rounded.into_iter().find(is_told).unwrap_or_else(|| format!("{value:.0e}"))
}

#[cfg(test)]
mod tests {
    use super::written;

    #[test]
    fn a_number_fits_its_field_and_is_never_shown_as_nothing() {
        assert_eq!(written(0.45, 5.0), "0.45");
        assert_eq!(written(0.7079, 4.5), "0.708");
        assert_eq!(written(-12.3456, 4.5), "-12.3");
        assert_eq!(written(0.199_999_99, 6.0), "0.2");
        assert_eq!(written(0.000_012_5, 5.0), "1e-5");
        assert_eq!(written(1_234_567_890.0, 6.0), "1e9");
    }
}
