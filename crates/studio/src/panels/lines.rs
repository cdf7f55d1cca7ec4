//! A long text: made beside the window whenever the document changed, shown line by line as far as it is seen.

use crate::{Action, Context, FileAction};
use egui::{Id, RichText, ScrollArea, TextStyle, Ui};
use lancer_document::Document;
use lancer_scene::Stage;
use lancer_words::{Lang, studio::panels as words};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::sync::{Arc, Mutex, PoisonError};

/// Characters of a line that are shown; a mesh's line can hold millions.
const SHOWN: usize = 400;

/// A text and what it was made of.
#[derive(Default)]
struct Made {
    of: Option<(u64, Lang)>,
    text: Arc<str>,
    /// The first byte of each line.
    starts: Arc<Vec<usize>>,
    coming: Option<((u64, Lang), Receiver<String>)>,
}

/// Shows the text that `make` makes of the document, with buttons to copy and to save it.
pub(super) fn show(
    ui: &mut Ui,
    context: &Context<'_>,
    file_name: &str,
    make: fn(&Stage, Lang) -> String,
) -> Vec<Action> {
    let id = Id::unique(("lines", file_name));
    let made = ui.data_mut(|data| Arc::clone(data.get_temp_mut_or_default::<Arc<Mutex<Made>>>(id)));
    let mut made = made.lock().unwrap_or_else(PoisonError::into_inner);
    update(&mut made, ui, context.document, context.lang, make);
    let mut actions = Vec::new();
    let lang = context.lang;
    ui.horizontal(|ui| {
        if ui.button(words::copy(lang)).clicked() {
            actions.push(Action::CopyText(made.text.to_string()));
        }
        if ui.button(words::save_text(lang)).clicked() {
            let text = made.text.to_string();
            actions.push(Action::File(FileAction::SaveText { name: file_name.to_owned(), text }));
        }
        if made.of.is_none() {
            ui.label(RichText::new(words::preparing(lang)).weak());
        }
    });
    let height = ui.text_style_height(&TextStyle::Monospace);
    ui.spacing_mut().item_spacing.y = 2.0;
    let (text, starts) = (Arc::clone(&made.text), Arc::clone(&made.starts));
    ScrollArea::both().auto_shrink(false).show_rows(ui, height, starts.len(), |ui, seen| {
        for line in seen {
            let end = starts.get(line + 1).map_or(text.len(), |next| next - 1);
            let line = starts.get(line).and_then(|start| text.get(*start..end)).unwrap_or_default();
            ui.add(egui::Label::new(RichText::new(folded(line, lang)).monospace()).extend());
        }
    });
    actions
}

/// Takes a text that is ready, and asks for a new one if the document changed.
fn update(made: &mut Made, ui: &Ui, document: &Document, lang: Lang, make: fn(&Stage, Lang) -> String) {
    let wanted = (document.revision(), lang);
    if let Some((of, receiver)) = &made.coming {
        match receiver.try_recv() {
            Ok(text) => {
                made.starts =
                    Arc::new(std::iter::once(0).chain(text.match_indices('\n').map(|(place, _)| place + 1)).collect());
                made.text = text.into();
                made.of = Some(*of);
                made.coming = None;
            }
            Err(TryRecvError::Empty) => return,
            Err(TryRecvError::Disconnected) => made.coming = None,
        }
    }
    if made.of != Some(wanted) {
        let (sender, receiver) = channel();
        let (stage, ctx) = (document.stage().clone(), ui.ctx().clone());
        std::thread::spawn(move || {
            // a panel that is gone wants no text
            let _ = sender.send(make(&stage, lang));
            ctx.request_repaint();
        });
        made.coming = Some((wanted, receiver));
    }
}

/// The beginning of a long line, and how much is not shown.
fn folded(line: &str, lang: Lang) -> String {
    match line.char_indices().nth(SHOWN) {
        None => line.to_owned(),
        Some((end, _)) => {
            let (head, rest) = line.split_at(end);
            format!("{head}{}", words::folded(lang, rest.chars().count()))
        }
    }
}
