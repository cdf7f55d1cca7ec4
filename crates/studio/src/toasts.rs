//! Messages that come up in a corner of the window and go away by themselves.

use crate::theme::Palette;
use egui::{Align2, Area, Frame, Id, Margin, Order, RichText, Vec2};
use egui_material_icons::icons::{ICON_CHECK_CIRCLE, ICON_CLOSE, ICON_ERROR, ICON_INFO};
use lancer_words::{Lang, studio::app as words};

/// What a message is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mood {
    /// Something was done.
    Done,
    /// Something to know.
    Note,
    /// Something failed.
    Failed,
}

/// A message.
#[derive(Clone, Debug, PartialEq)]
pub struct Toast {
    /// What it is about.
    pub mood: Mood,
    /// A sentence.
    pub text: String,
}

impl Toast {
    /// Something was done.
    pub fn done(text: impl Into<String>) -> Toast {
        Toast { mood: Mood::Done, text: text.into() }
    }

    /// Something to know.
    pub fn note(text: impl Into<String>) -> Toast {
        Toast { mood: Mood::Note, text: text.into() }
    }

    /// Something failed.
    pub fn failed(text: impl Into<String>) -> Toast {
        Toast { mood: Mood::Failed, text: text.into() }
    }
}

/// The messages that are shown.
#[derive(Debug, Default)]
pub struct Toasts {
    shown: Vec<(Toast, Option<f64>)>,
}

impl Toasts {
    /// Shows a message; one that says the same is replaced.
    pub fn say(&mut self, toast: Toast) {
        self.shown.retain(|(known, _)| *known != toast);
        self.shown.push((toast, None));
        // an endless row of messages helps nobody
        if self.shown.len() > 5 {
            self.shown.remove(0);
        }
    }

    /// The messages that are shown, the newest last.
    pub fn iter(&self) -> impl Iterator<Item = &Toast> {
        self.shown.iter().map(|(toast, _)| toast)
    }

    /// How long a message stays, in seconds: long enough to be read twice; a failure until it is closed.
    fn lifetime(toast: &Toast) -> Option<f64> {
        match toast.mood {
            Mood::Done | Mood::Note => Some(4.0 + toast.text.chars().count() as f64 / 12.0),
            Mood::Failed => None,
        }
    }

    /// Draws the messages at the bottom of the window.
    pub fn show(&mut self, ctx: &egui::Context, palette: &Palette, lang: Lang) {
        if self.shown.is_empty() {
            return;
        }
        let now = ctx.input(|input| input.time);
        for (toast, end) in &mut self.shown {
            *end = end.or_else(|| Toasts::lifetime(toast).map(|seconds| now + seconds));
        }
        self.shown.retain(|(_, end)| end.is_none_or(|end| now < end));
        let next = self.shown.iter().filter_map(|(_, end)| *end).fold(f64::INFINITY, f64::min);
        if next.is_finite() {
            ctx.request_repaint_after(std::time::Duration::from_secs_f64((next - now).max(0.01)));
        }
        let mut closed = None;
        let area = Area::new(Id::unique("toasts")).order(Order::Foreground);
        area.anchor(Align2::RIGHT_BOTTOM, Vec2::new(-16.0, -44.0)).show(ctx, |ui| {
            for (place, (toast, _)) in self.shown.iter().enumerate() {
                if draw(ui, toast, palette, lang) {
                    closed = Some(place);
                }
            }
        });
        if let Some(place) = closed {
            self.shown.remove(place);
        }
    }
}

/// Draws one message; whether it is to be closed.
fn draw(ui: &mut egui::Ui, toast: &Toast, palette: &Palette, lang: Lang) -> bool {
    let (icon, color) = match toast.mood {
        Mood::Done => (ICON_CHECK_CIRCLE, palette.success),
        Mood::Note => (ICON_INFO, palette.accent),
        Mood::Failed => (ICON_ERROR, palette.error),
    };
    let frame = Frame::popup(ui.style()).fill(palette.bar).inner_margin(Margin::symmetric(12, 8));
    frame
        .show(ui, |ui| {
            ui.set_max_width(420.0);
            ui.horizontal(|ui| {
                ui.label(icon.rich_text().color(color).size(18.0));
                ui.add(egui::Label::new(RichText::new(&toast.text)).wrap());
                crate::chrome::icon_button(ui, ICON_CLOSE, &words::close(lang)).clicked()
            })
            .inner
        })
        .inner
}
