//! A pixel with the whole tree of its rays: a click on a picture chooses it, a ray is unfolded by a click or by Enter.

use crate::chrome::small_icon_button;
use crate::explainer::{Explanation, Failure, MAX_RAYS, Target};
use crate::story::{self, Line, What};
use crate::theme::Palette;
use crate::widgets::{self, Change, NumberField};
use crate::{Action, Context, told};
use egui::{Align2, Color32, FontId, Id, Pos2, Rect, RichText, ScrollArea, Sense, TextStyle, Ui, WidgetInfo};
use egui_material_icons::icons::{ICON_CHEVRON_RIGHT, ICON_EXPAND_MORE, ICON_UNFOLD_LESS, ICON_UNFOLD_MORE};
use lancer_trace::{PixelTree, TraceError};
use lancer_words::{Lang, explain as terms, studio::explain as words, studio::view};
use std::collections::BTreeSet;
use std::sync::Arc;

/// The height of a line.
const ROW: f32 = 19.0;
/// How far a level is indented.
const INDENT: f32 = 18.0;
/// The width of a column of values.
const COLUMN: f32 = 74.0;

/// What the panel remembers: which rays are unfolded, which sample is shown, and the lines of that.
#[derive(Clone, Default)]
struct Memory {
    /// What the lines are of.
    of: Option<(Arc<Explanation>, Lang)>,
    open: BTreeSet<usize>,
    sample: usize,
    lines: Arc<Vec<Line>>,
}

/// Shows the panel; gives what the user wants.
pub fn show(ui: &mut Ui, context: &Context<'_>) -> Vec<Action> {
    let mut actions = Vec::new();
    let lang = context.lang;
    let explainer = context.explainer;
    let Some(target) = explainer.target() else {
        ui.label(RichText::new(words::no_view(lang)).weak());
        return actions;
    };
    let id = Id::unique("explain");
    let mut memory = ui
        .data(|data| data.get_temp::<Memory>(id))
        .unwrap_or_else(|| Memory { open: BTreeSet::from([0]), ..Memory::default() });
    let explanation = explainer.explanation().map(Arc::clone);
    renew(&mut memory, explanation.as_ref(), lang);
    let mut again = false;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        place(ui, context, target, explanation.as_deref(), &mut actions);
        let Some(Ok(tree)) = explanation.as_deref().map(|explanation| &explanation.outcome) else { return };
        again |= samples(ui, tree, &mut memory, lang);
        ui.separator();
        if small_icon_button(ui, ICON_UNFOLD_MORE, &words::unfold(lang)).clicked() {
            let rays = tree.samples.get(memory.sample).map_or(0, |sample| sample.tree.nodes.len());
            memory.open = (0..rays).collect();
            again = true;
        }
        if small_icon_button(ui, ICON_UNFOLD_LESS, &words::fold(lang)).clicked() {
            memory.open = BTreeSet::from([0]);
            again = true;
        }
        if ui.button(words::copy(lang)).clicked() {
            actions.push(Action::CopyText(story::text(&memory.lines)));
        }
        bytes(ui, context.palette, tree, lang);
        ui.add_space(8.0);
        ui.add(egui::Label::new(RichText::new(words::hint(lang)).weak().small()).truncate());
    });
    ui.add_space(2.0);
    match explanation.as_deref().map(|explanation| &explanation.outcome) {
        None => drop(ui.label(RichText::new(words::working(lang)).weak())),
        Some(Err(failure)) => drop(ui.colored_label(context.palette.error, why(failure, memory.of.as_ref(), lang))),
        Some(Ok(_)) => again |= tree(ui, context.palette, &mut memory),
    }
    if again && let Some((explanation, lang)) = memory.of.clone() {
        tell(&mut memory, &explanation, lang);
    }
    ui.data_mut(|data| data.insert_temp(id, memory));
    actions
}

/// Makes the lines of a new explanation; rays stay unfolded by their numbers.
fn renew(memory: &mut Memory, explanation: Option<&Arc<Explanation>>, lang: Lang) {
    let Some(explanation) = explanation else { return };
    let same = memory.of.as_ref().is_some_and(|(known, spoken)| Arc::ptr_eq(known, explanation) && *spoken == lang);
    if !same {
        let another = memory.of.as_ref().is_none_or(|(known, _)| known.pixel != explanation.pixel);
        if another {
            memory.open = BTreeSet::from([0]);
            memory.sample = 0;
        }
        memory.of = Some((Arc::clone(explanation), lang));
        tell(memory, explanation, lang);
    }
}

fn tell(memory: &mut Memory, explanation: &Explanation, lang: Lang) {
    memory.lines = Arc::default();
    if let Ok(pixel) = &explanation.outcome {
        memory.sample = memory.sample.min(pixel.samples.len().saturating_sub(1));
        if let Some(sample) = pixel.samples.get(memory.sample) {
            memory.lines = Arc::new(story::lines(explanation, &sample.tree, &memory.open, lang));
        }
    }
}

/// Which pixel: two numbers to type or drag, and its view.
fn place(
    ui: &mut Ui,
    context: &Context<'_>,
    target: &Target,
    explanation: Option<&Explanation>,
    actions: &mut Vec<Action>,
) {
    let lang = context.lang;
    ui.label(words::pixel(lang));
    let Some(explanation) = explanation else { return };
    let size = [explanation.view.width, explanation.view.height];
    let pixel = target.pixel(size);
    for (letter, value, whole) in [("x", pixel.0, size[0]), ("y", pixel.1, size[1])] {
        let name = words::coordinate(lang, letter);
        let range = 0.0..=f64::from(whole.saturating_sub(1));
        let field = NumberField { name: &name, prefix: "", range, speed: 0.5, whole: true, width: 46.0 };
        match widgets::number(ui, f64::from(value), &field, &mut None) {
            Change::Set(new) | Change::Dragging { value: new, .. } => {
                let new = new as u32;
                let pixel = if letter == "x" { (new, pixel.1) } else { (pixel.0, new) };
                actions.push(Action::Explain(Target::of_pixel(target.view.clone(), pixel, size)));
            }
            Change::Kept | Change::Released => {}
        }
    }
    ui.label(RichText::new(words::of(lang, &target.view, size[0], size[1])).weak());
}

/// Which sample of the pixel, where it has several; whether another one was chosen.
fn samples(ui: &mut Ui, pixel: &PixelTree, memory: &mut Memory, lang: Lang) -> bool {
    let count = pixel.samples.len();
    if count < 2 {
        return false;
    }
    let before = memory.sample;
    let name = words::sample(lang, memory.sample + 1, count);
    let combo = egui::ComboBox::from_id_salt("sample").selected_text(&name).width(150.0).show_ui(ui, |ui| {
        for sample in 0..count {
            if ui.selectable_value(&mut memory.sample, sample, words::sample(lang, sample + 1, count)).clicked() {
                ui.close();
            }
        }
    });
    combo.response.widget_info(|| WidgetInfo::labeled(egui::Role::ComboBox, true, &name));
    memory.sample != before
}

/// The colour that stands in the picture.
fn bytes(ui: &mut Ui, palette: &Palette, pixel: &PixelTree, lang: Lang) {
    ui.add_space(6.0);
    let [r, g, b] = pixel.bytes;
    let (swatch, _) = ui.allocate_exact_size(egui::Vec2::splat(14.0), Sense::hover());
    let stroke = egui::Stroke::new(1.0, palette.line);
    ui.painter().rect(swatch, 2.0, Color32::from_rgb(r, g, b), stroke, egui::StrokeKind::Outside);
    ui.label(format!("{r} {g} {b}")).on_hover_text(terms::bytes(lang));
}

fn why(failure: &Failure, of: Option<&(Arc<Explanation>, Lang)>, lang: Lang) -> String {
    match failure {
        Failure::View(rule) => format!("{} {}", view::cannot_render(lang), told::rule(rule, lang)),
        Failure::Trace(TraceError::Budget { .. }) => words::too_many(lang, MAX_RAYS),
        Failure::Trace(TraceError::NotFinite | TraceError::Cancelled) => {
            let (x, y) = of.map_or((0, 0), |(explanation, _)| explanation.pixel);
            view::not_a_number(lang, x, y)
        }
    }
}

/// The lines as far as they are seen; whether a ray was folded or unfolded.
fn tree(ui: &mut Ui, palette: &Palette, memory: &mut Memory) -> bool {
    let lines = Arc::clone(&memory.lines);
    let mut turned = None;
    ui.spacing_mut().item_spacing.y = 0.0;
    let area = ScrollArea::vertical().id_salt("rays").auto_shrink(false);
    area.show_rows(ui, ROW, lines.len(), |ui, seen| {
        for line in lines.get(seen).unwrap_or_default() {
            if draw(ui, palette, line)
                && let What::Ray { ray, .. } = line.what
            {
                turned = Some(ray);
            }
        }
    });
    let Some(ray) = turned else { return false };
    if !memory.open.remove(&ray) {
        memory.open.insert(ray);
    }
    true
}

/// Draws a line; whether it is a ray that is to be folded or unfolded.
fn draw(ui: &mut Ui, palette: &Palette, line: &Line) -> bool {
    let (label, cells, color, strong) = match &line.what {
        What::Ray { heading, cells, .. } => (heading, Some(cells), palette.text, true),
        What::Term(label) => (label, None, palette.accent, true),
        What::Text(label) => (label, None, palette.weak, false),
        What::Values(label, cells) => (label, Some(cells), palette.weak, false),
        What::Sum(label, cells) => (label, Some(cells), palette.text, false),
    };
    let is_ray = matches!(line.what, What::Ray { .. });
    let sense = if is_ray { Sense::click() } else { Sense::hover() };
    let (rect, response) = ui.allocate_exact_size(egui::vec2(ui.available_width(), ROW), sense);
    let told = match cells {
        Some([r, g, b]) => format!("{label}: {r} {g} {b}"),
        None => label.clone(),
    };
    response.widget_info(|| match &line.what {
        What::Ray { open, .. } => WidgetInfo::selected(egui::Role::TreeItem, true, *open, &told),
        What::Term(_) | What::Text(_) | What::Values(..) | What::Sum(..) => {
            WidgetInfo::labeled(egui::Role::Label, true, &told)
        }
    });
    if is_ray && (response.hovered() || response.has_focus()) {
        ui.painter().rect_filled(rect, 4.0, palette.hover);
    }
    let left = rect.left() + line.indent as f32 * INDENT + 4.0;
    if let What::Ray { open, .. } = line.what {
        let icon = if open { ICON_EXPAND_MORE } else { ICON_CHEVRON_RIGHT };
        let font = FontId::new(16.0, icon.font_family());
        let at = Pos2::new(left - 2.0, rect.center().y);
        ui.painter().text(at, Align2::LEFT_CENTER, icon.codepoint, font, palette.weak);
    }
    let font = if strong { crate::theme::title_font(12.5) } else { TextStyle::Body.resolve(ui.style()) };
    let columns = columns(rect);
    let room = if cells.is_some() { columns - left - 24.0 } else { rect.right() - left - 16.0 };
    let galley = ui.painter().layout_job(one_line(label, font, color, room));
    let at = Pos2::new(left + 16.0, rect.center().y - galley.size().y / 2.0);
    ui.painter().galley(at, galley, color);
    for (place, cell) in cells.into_iter().flatten().enumerate() {
        let at = Pos2::new(columns + COLUMN * (place as f32 + 1.0), rect.center().y);
        ui.painter().text(at, Align2::RIGHT_CENTER, cell, FontId::monospace(12.0), color);
    }
    is_ray && response.clicked()
}

/// Where the columns of values begin: near the labels, and inside the panel.
fn columns(rect: Rect) -> f32 {
    (rect.right() - 3.0 * COLUMN - 8.0).min(rect.left() + 520.0)
}

/// A text on one line; what has no room is cut.
fn one_line(text: &str, font: FontId, color: Color32, room: f32) -> egui::text::LayoutJob {
    let mut job = egui::text::LayoutJob::simple_singleline(text.to_owned(), font, color);
    job.wrap = egui::text::TextWrapping::truncate_at_width(room.max(20.0));
    job
}
