//! A line of a list: its text from the left, over the whole width that it is given.

use egui::{Response, Role, Sense, TextStyle, TextWrapMode, Ui, Vec2, WidgetInfo, WidgetText};

/// Shows a line that can be selected, clicked and dragged; a text that is too long is cut.
pub fn line(ui: &mut Ui, size: Vec2, selected: bool, name: &str, text: impl Into<WidgetText>) -> Response {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    let visuals = ui.style().interact_selectable(&response, selected);
    if selected || response.hovered() || response.has_focus() {
        ui.painter().rect_filled(rect, visuals.corner_radius, visuals.weak_bg_fill);
    }
    let wide = rect.width() - 12.0;
    let galley = text.into().into_galley(ui, Some(TextWrapMode::Truncate), wide, TextStyle::Button);
    let place = egui::pos2(rect.left() + 6.0, rect.center().y - galley.size().y / 2.0);
    ui.painter().galley(place, galley, visuals.text_color());
    response.widget_info(|| WidgetInfo::selected(Role::ListBoxOption, true, selected, name));
    response
}
