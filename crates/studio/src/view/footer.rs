//! The line below a picture: what is under the pointer, and how far the picture is.

use super::gesture::Scope;
use super::live::LiveView;
use egui::{Align, Layout, Pos2, Rect, RichText, Sense, Stroke, Ui, UiBuilder, Vec2};
use lancer_trace::TraceError;
use lancer_words::{Lang, studio::view as words};

/// The height of the line.
pub(crate) const HEIGHT: f32 = 22.0;

/// Draws the line.
pub(crate) fn footer(ui: &mut Ui, rect: Rect, live: &LiveView, scope: &Scope<'_>, pointer: Option<Pos2>) {
    let (palette, lang) = (scope.context.palette, scope.context.lang);
    ui.painter().rect_filled(rect, 0.0, palette.panel);
    progress(ui, rect, live, scope);
    let inside = rect.shrink2(Vec2::new(8.0, 0.0));
    let mut line = ui.new_child(UiBuilder::new().max_rect(inside).layout(Layout::right_to_left(Align::Center)));
    line.spacing_mut().item_spacing.x = 6.0;
    let (text, color) = state(live, lang, palette);
    line.label(RichText::new(text).small().color(color));
    if live.looks_old() {
        line.label(RichText::new(words::stale(lang)).small().color(palette.warning));
    }
    let rest = line.available_rect_before_wrap();
    line.with_layout(Layout::left_to_right(Align::Center), |ui| {
        ui.set_clip_rect(ui.clip_rect().intersect(rest));
        ui.spacing_mut().item_spacing.x = 6.0;
        if let Some(pointer) = pointer {
            read_out(ui, live, scope, pointer);
        }
    });
}

/// A thin bar along the upper edge while the picture grows.
fn progress(ui: &Ui, rect: Rect, live: &LiveView, scope: &Scope<'_>) {
    let palette = scope.context.palette;
    let top = rect.top() + 0.5;
    ui.painter().hline(rect.x_range(), top, Stroke::new(1.0, palette.line));
    let session = live.session();
    if !session.is_finished() {
        let to = rect.left() + rect.width() * session.progress();
        ui.painter().hline(rect.left()..=to, rect.top() + 1.0, Stroke::new(2.0, palette.accent));
    }
}

/// What is said of the picture.
fn state(live: &LiveView, lang: Lang, palette: &crate::theme::Palette) -> (String, egui::Color32) {
    let (session, status) = (live.session(), live.session().status());
    let percent = (session.progress() * 100.0).floor();
    if let Some((x, y, error)) = &status.fault {
        let text = match error {
            TraceError::Budget { limit } => words::over_budget(lang, x, y, words::compact(lang, *limit)),
            TraceError::NotFinite | TraceError::Cancelled => words::not_a_number(lang, x, y),
        };
        return (text, palette.error);
    }
    if status.refused.is_some() {
        return (words::cannot_render(lang), palette.error);
    }
    if live.view().is_none() {
        return (words::waiting(lang), palette.weak);
    }
    if session.is_finished() {
        let rays = words::rays(lang, words::compact(lang, status.counts.total()));
        let text = format!("{} · {} · {rays}", words::done(lang), words::duration(lang, status.elapsed));
        return (text, palette.weak);
    }
    let percent = match lang {
        Lang::English => format!("{percent}%"),
        Lang::French => format!("{percent} %"),
    };
    if status.paused {
        return (format!("{} · {percent}", words::paused(lang)), palette.warning);
    }
    (percent, palette.text)
}

/// Pixel, colour as numbers, object, distance.
fn read_out(ui: &mut Ui, live: &LiveView, scope: &Scope<'_>, pointer: Pos2) {
    let (palette, lang) = (scope.context.palette, scope.context.lang);
    let Some((x, y)) = scope.mapping.pixel(pointer, scope.picture) else { return };
    let image = live.session().image();
    let place = y as usize * image.width() as usize + x as usize;
    let Some(&[r, g, b]) = image.bytes().get(place) else { return };
    let small = |text: String| RichText::new(text).small();
    ui.add(egui::Label::new(small(format!("({x}, {y})")).color(palette.weak)).selectable(false));
    let (swatch, _) = ui.allocate_exact_size(Vec2::splat(10.0), Sense::hover());
    ui.painter().rect(
        swatch,
        2.0,
        egui::Color32::from_rgb(r, g, b),
        Stroke::new(1.0, palette.line),
        egui::StrokeKind::Outside,
    );
    ui.add(egui::Label::new(small(format!("{r} {g} {b}"))).selectable(false));
    let near = |answer: &&super::Answer| scope.mapping.to_screen(answer.point).distance(pointer) <= 2.0;
    if let Some(answer) = scope.under.filter(near) {
        let text = match &answer.picked {
            Some(picked) => format!("{} · {}", picked.object, words::distance(lang, length(lang, picked.distance))),
            None => words::infinity(lang),
        };
        ui.add(egui::Label::new(small(text)).truncate().selectable(false));
    }
}

/// A length in four digits.
fn length(lang: Lang, length: f64) -> String {
    let text =
        if length != 0.0 && !(1e-3..1e5).contains(&length) { format!("{length:.3e}") } else { format!("{length:.3}") };
    match lang {
        Lang::English => text,
        Lang::French => text.replace('.', ","),
    }
}
