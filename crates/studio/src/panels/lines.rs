//! A long text: made beside the window whenever the document changed, shown line by line as far as it is seen.

use crate::beside::Beside;
use crate::{Action, Context, FileAction};
use egui::{Id, RichText, ScrollArea, TextStyle, Ui};
use lancer_document::Document;
use lancer_words::{Lang, studio::panels as words};
use std::sync::{Arc, Mutex, PoisonError};

/// Characters of a line that are shown; a mesh's line can hold millions.
const SHOWN: usize = 400;

/// A text with the first byte of each line.
#[derive(Debug)]
struct Made {
    text: String,
    starts: Vec<usize>,
}

impl Made {
    fn new(text: String) -> Made {
        let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(place, _)| place + 1)).collect();
        Made { text, starts }
    }
}

/// What a text is made of: the revision of the document, and the language.
type Of = (u64, Lang);

/// Shows the text that `make` makes of the document, with buttons to copy and to save it, after `more`.
pub(super) fn show(
    ui: &mut Ui,
    context: &Context<'_>,
    file_name: &str,
    make: fn(&Document, Lang) -> String,
    more: impl FnOnce(&mut Ui),
) -> Vec<Action> {
    let id = Id::unique(("lines", file_name));
    let beside = ui.data_mut(|data| Arc::clone(data.get_temp_mut_or_default::<Arc<Mutex<Beside<Of, Arc<Made>>>>>(id)));
    let mut beside = beside.lock().unwrap_or_else(PoisonError::into_inner);
    let lang = context.lang;
    let wanted = (context.document.revision(), lang);
    if !beside.is_of(&wanted) {
        let document = context.document.clone();
        beside.follow(ui.ctx(), &wanted, move || Arc::new(Made::new(make(&document, lang))));
    }
    let made = beside.get().map(Arc::clone);
    let text = || made.as_ref().map(|made| made.text.clone()).unwrap_or_default();
    let mut actions = Vec::new();
    ui.horizontal(|ui| {
        more(ui);
        if ui.button(words::copy(lang)).clicked() {
            actions.push(Action::CopyText(text()));
        }
        if ui.button(words::save_text(lang)).clicked() {
            actions.push(Action::File(FileAction::SaveText { name: file_name.to_owned(), text: text() }));
        }
        if made.is_none() {
            ui.label(RichText::new(words::preparing(lang)).weak());
        }
    });
    let Some(made) = made else { return actions };
    let height = ui.text_style_height(&TextStyle::Monospace);
    ui.spacing_mut().item_spacing.y = 2.0;
    let (text, starts) = (&made.text, &made.starts);
    ScrollArea::both().id_salt(file_name).auto_shrink(false).show_rows(ui, height, starts.len(), |ui, seen| {
        for line in seen {
            let end = starts.get(line + 1).map_or(text.len(), |next| next - 1);
            let line = starts.get(line).and_then(|start| text.get(*start..end)).unwrap_or_default();
            ui.add(egui::Label::new(RichText::new(folded(line, lang)).monospace()).extend());
        }
    });
    actions
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
