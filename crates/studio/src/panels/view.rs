//! A pane: the live picture of a view, what the pointer does in it, and the line below it.

use crate::explainer::Target;
use crate::view::{self, Gesture, LiveView, Mapping, Picker, Purpose, Scope};
use crate::{Action, Context, Tab, ViewAction};
use egui::{Align2, FontId, Key, Modifiers, PointerButton, Rect, Response, Role, Sense, Ui, Vec2, WidgetInfo};
use lancer_document::wireframe::Wireframes;
use lancer_document::{Document, Item, Selection};
use lancer_scene::View;
use lancer_words::studio::view as words;
use std::sync::Arc;

/// What all panes share.
#[derive(Debug)]
pub struct Tools<'a> {
    /// Tells what stands under the pointer.
    pub picker: &'a Picker,
    /// Works out outlines.
    pub wireframes: &'a mut Wireframes,
}

/// Shows the pane of a view; gives what the user wants.
pub fn show(
    ui: &mut Ui,
    context: &Context<'_>,
    live: &mut LiveView,
    view: &Arc<View>,
    tools: Tools<'_>,
) -> Vec<Action> {
    let whole = ui.available_rect_before_wrap();
    let (area, line) = whole.split_top_bottom_at_y(whole.bottom() - view::FOOTER);
    ui.painter().rect_filled(area, 0.0, context.palette.ground);
    let pixels = ui.ctx().pixels_per_point();
    live.offer([area.width(), area.height()].map(|length| (length * pixels).floor().max(0.0) as u32));
    live.follow(context.document.stage(), &view.name);

    let response = ui.interact(area, ui.scope_id().with(("picture", &*view.name)), Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, words::picture_of(context.lang, &view.name)));
    let mapping = Mapping::new(placed(area, live.size(), pixels), view);
    paint(ui, context, live, &mapping, area);

    let world = live.session().world().cloned();
    let pointer = response.hover_pos().filter(|place| mapping.rect.contains(*place));
    let under = live.under.clone();
    let scope = Scope { context, view, mapping, world: world.as_deref(), picture: live.size(), under: under.as_ref() };
    let mut actions = focus(ui, context, &response, live, view);
    actions.extend(view::follow(ui, &response, &scope, &mut live.gesture, &mut live.marking));

    let lamp = pointer.filter(|_| response.clicked()).and_then(|place| scope.lamp(place, live.grid));
    if let Some(lamp) = lamp {
        let modifiers = ui.input(|input| input.modifiers);
        actions.push(Action::Select(picked(context.document, Some(lamp), modifiers.shift || modifiers.command)));
    } else {
        let asked = question(ui, &response, live, &mapping, pointer);
        ask(live, view, asked, tools.picker);
    }
    if let Some(place) = pointer.filter(|_| response.clicked() && explains(context)) {
        let pixel = mapping.pixel(place, live.size());
        let target = pixel.map(|pixel| Target::of_pixel(view.name.clone(), pixel, live.size()));
        actions.extend(target.map(Action::Explain));
    }
    if live.marking || live.gesture.is_some() && response.dragged_by(PointerButton::Primary) {
        ui.ctx().set_cursor_icon(if live.marking { egui::CursorIcon::Crosshair } else { egui::CursorIcon::Grabbing });
    }
    let painter = ui.painter().with_clip_rect(area);
    view::draw(&painter, &scope, live.gesture.as_ref(), live.grid, tools.wireframes);
    if let Some(region) = live.region() {
        view::rectangle(&painter, mapping.region_rect(region, live.size()), context.palette);
    }
    if let Some(target) = context.explainer.target().filter(|target| explains(context) && target.view == view.name) {
        view::explained(&painter, &scope.mapping, target.pixel(live.size()), live.size(), context.palette);
    }
    view::hint(&painter, area, live.gesture.as_ref(), live.marking, context.lang);
    view::footer(ui, line, live, &scope, pointer);
    if context.active == Some(&*view.name) && context.settings.layout.views().len() > 1 {
        let stroke = egui::Stroke::new(1.5, context.palette.accent);
        ui.painter().rect_stroke(whole, 0.0, stroke, egui::StrokeKind::Inside);
    }
    if response.has_focus() {
        let stroke = egui::Stroke::new(2.0, context.palette.accent);
        ui.painter().rect_stroke(whole, 0.0, stroke, egui::StrokeKind::Inside);
    }
    actions
}

/// Whether a click explains a pixel.
fn explains(context: &Context<'_>) -> bool {
    context.settings.tabs && context.settings.tab == Tab::Explain
}

/// What is selected after a click on something or on nothing.
pub(crate) fn picked(document: &Document, item: Option<Item>, more: bool) -> Selection {
    let mut selection = if more { document.selection().clone() } else { Selection::default() };
    if let Some(item) = item {
        selection.toggle(item);
    }
    selection
}

/// Where a picture of that many pixels stands: pixel by pixel in the middle, or made smaller where it has no place.
fn placed(area: Rect, [width, height]: [u32; 2], pixels: f32) -> Rect {
    let size = Vec2::new(width as f32, height as f32) / pixels;
    let scale = (area.width() / size.x).min(area.height() / size.y).min(1.0);
    let size = if scale.is_finite() { size * scale } else { Vec2::ZERO };
    let min = area.center() - size / 2.0;
    // on whole pixels of the screen, so that none is smeared
    let min = egui::pos2((min.x * pixels).round() / pixels, (min.y * pixels).round() / pixels);
    Rect::from_min_size(min, size)
}

/// Draws the picture, or why there is none.
fn paint(ui: &Ui, context: &Context<'_>, live: &mut LiveView, mapping: &Mapping, area: Rect) {
    let uv = Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
    if let Some(texture) = live.texture(ui.ctx()) {
        ui.painter().image(texture.id(), mapping.rect, uv, egui::Color32::WHITE);
    }
    if let Some(rule) = &live.session().status().refused {
        let text = format!("{}\n{}", words::cannot_render(context.lang), crate::told::rule(rule, context.lang));
        let galley = ui.painter().layout(text, FontId::proportional(13.5), egui::Color32::WHITE, area.width() - 48.0);
        let around = Align2::CENTER_CENTER.anchor_size(area.center(), galley.size());
        ui.painter().rect_filled(around.expand(12.0), 6.0, egui::Color32::from_black_alpha(190));
        ui.painter().galley(around.min, galley, egui::Color32::WHITE);
    }
}

/// A view that is clicked into or pointed at is the one that is worked in.
fn focus(ui: &Ui, context: &Context<'_>, response: &Response, live: &mut LiveView, view: &View) -> Vec<Action> {
    let pressed = response.is_pointer_button_down_on() && ui.input(|input| input.pointer.any_pressed());
    if pressed || response.clicked() {
        response.request_focus();
    }
    if response.has_focus() {
        ui.memory_mut(|memory| {
            let keys = egui::EventFilter { horizontal_arrows: true, vertical_arrows: true, escape: true, tab: false };
            memory.set_focus_lock_filter(response.id, keys);
        });
    }
    let here = response.has_focus() || response.hovered();
    let (marks, escapes) = ui.input_mut(|input| {
        let marks = here && !input.modifiers.any() && input.key_pressed(Key::R);
        (marks, live.marking && input.consume_key(Modifiers::NONE, Key::Escape))
    });
    if marks && !ui.ctx().text_edit_focused() {
        live.marking = true;
    }
    if escapes {
        live.marking = false;
    }
    let wants = pressed || response.gained_focus();
    let news = wants && context.active != Some(&*view.name);
    news.then(|| Action::View(view.name.clone(), ViewAction::Focus)).into_iter().collect()
}

/// Asks what stands somewhere. A click before the scene is compiled for the first time is asked about once it is.
fn ask(live: &mut LiveView, view: &Arc<View>, asked: Option<((f64, f64), Purpose)>, picker: &Picker) {
    match live.session().world().cloned() {
        Some(world) => {
            for (point, purpose) in live.waiting.take().into_iter().chain(asked) {
                picker.ask(&world, view, point, purpose);
            }
        }
        None => match asked {
            Some((_, Purpose::Select { .. })) => live.waiting = asked,
            Some((_, Purpose::Hover)) | None => {}
        },
    }
}

/// The point of the view that has to be asked about, and why.
fn question(
    ui: &Ui,
    response: &Response,
    live: &LiveView,
    mapping: &Mapping,
    pointer: Option<egui::Pos2>,
) -> Option<((f64, f64), Purpose)> {
    let known = |point: (f64, f64)| live.under.as_ref().is_some_and(|answer| answer.point == point);
    if let Some(Gesture::Undecided { from }) = live.gesture {
        // what was pressed on decides what the drag does
        return Some(mapping.to_view(from)).filter(|point| !known(*point)).map(|point| (point, Purpose::Hover));
    }
    let point = mapping.to_view(pointer?);
    if response.clicked() && live.gesture.is_none() {
        let modifiers = ui.input(|input| input.modifiers);
        return Some((point, Purpose::Select { more: modifiers.shift || modifiers.command }));
    }
    (!known(point) && !response.dragged()).then_some((point, Purpose::Hover))
}
