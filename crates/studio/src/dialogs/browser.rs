//! The dialog of our own: a folder's files, a name, and two buttons. It is complete by keyboard.

use super::{Reply, Request};
use crate::chrome::icon_button;
use crate::theme::Palette;
use egui::{Button, Key, Modifiers, RichText, Role, ScrollArea, TextEdit, Ui, WidgetInfo};
use egui_material_icons::icons as icon;
use lancer_words::{Lang, studio::app as words};
use std::path::{Path, PathBuf};

/// More files than these of one folder are not listed.
const MOST_FILES: usize = 5000;

/// A dialog that is open.
#[derive(Debug)]
pub struct Browser {
    request: Request,
    folder: PathBuf,
    name: String,
    /// The kind of files that is listed; beyond the last: all.
    filter: usize,
    rows: Vec<Row>,
    /// Why the folder cannot be listed.
    trouble: Option<String>,
    /// The file that would be replaced, asked once.
    replaces: Option<PathBuf>,
    begun: bool,
}

#[derive(Debug)]
struct Row {
    name: String,
    is_folder: bool,
}

impl Browser {
    /// A dialog for a request.
    pub fn new(request: Request) -> Browser {
        let folder = request.folder.clone().filter(|folder| folder.is_dir());
        let folder = folder.or_else(|| std::env::current_dir().ok()).unwrap_or_else(|| PathBuf::from("/"));
        let name = request.name.clone();
        let mut browser =
            Browser { request, folder, name, filter: 0, rows: Vec::new(), trouble: None, replaces: None, begun: false };
        browser.list();
        browser
    }

    /// Reads the folder: folders first, each by name.
    fn list(&mut self) {
        self.replaces = None;
        let wanted = self.request.filters.get(self.filter).map(|(_, extensions)| extensions);
        let entries = match std::fs::read_dir(&self.folder) {
            Ok(entries) => entries,
            Err(error) => {
                self.trouble = Some(error.to_string());
                self.rows.clear();
                return;
            }
        };
        self.trouble = None;
        self.rows = entries
            .filter_map(Result::ok)
            .take(MOST_FILES)
            .filter_map(|entry| {
                let name = entry.file_name().to_string_lossy().into_owned();
                let is_folder = entry.path().is_dir();
                let extension =
                    Path::new(&name).extension().map(|extension| extension.to_string_lossy().to_lowercase());
                let fits = wanted.is_none_or(|wanted| extension.is_some_and(|extension| wanted.contains(&extension)));
                (!name.starts_with('.') && (is_folder || fits)).then_some(Row { name, is_folder })
            })
            .collect();
        self.rows.sort_by_cached_key(|row| (!row.is_folder, row.name.to_lowercase()));
    }

    fn enter(&mut self, folder: PathBuf) {
        self.folder = folder;
        self.list();
    }

    /// Draws the dialog; gives the reply once there is one.
    pub fn show(&mut self, ctx: &egui::Context, palette: &Palette, lang: Lang) -> Option<Reply> {
        let mut reply = None;
        let modal = crate::modals::modal(ctx, "file dialog").show(ctx, |ui| {
            ui.set_width(560.0);
            ui.heading(&self.request.title);
            ui.add_space(4.0);
            self.path(ui, lang);
            self.files(ui, palette, lang, &mut reply);
            self.kinds(ui, lang);
            self.finish(ui, palette, lang, &mut reply);
        });
        if modal.should_close() && reply.is_none() {
            reply = Some(Reply::Cancelled);
        }
        reply
    }

    /// The folder's path: each part is a button.
    fn path(&mut self, ui: &mut Ui, lang: Lang) {
        let mut to = None;
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 2.0;
            let parent = self.folder.parent().map(Path::to_owned);
            let up = ui.add_enabled_ui(parent.is_some(), |ui| {
                icon_button(ui, icon::ICON_ARROW_UPWARD, &words::folder_above(lang)).clicked()
            });
            if up.inner {
                to = parent;
            }
            let mut parts: Vec<&Path> = self.folder.ancestors().collect();
            parts.reverse();
            for part in parts {
                let name = part.file_name().map_or_else(|| part.display().to_string(), |n| n.to_string_lossy().into());
                if ui.add(Button::new(name).frame_when_inactive(false)).clicked() {
                    to = Some(part.to_owned());
                }
            }
        });
        if let Some(folder) = to {
            self.enter(folder);
        }
    }

    fn files(&mut self, ui: &mut Ui, palette: &Palette, lang: Lang, reply: &mut Option<Reply>) {
        let mut folder = None;
        egui::Frame::new().fill(palette.field).corner_radius(4).inner_margin(4).show(ui, |ui| {
            ScrollArea::vertical().max_height(280.0).min_scrolled_height(280.0).auto_shrink(false).show_rows(
                ui,
                22.0,
                self.rows.len(),
                |ui, range| {
                    ui.spacing_mut().item_spacing.y = 0.0;
                    for row in &self.rows[range] {
                        let sign = if row.is_folder { icon::ICON_FOLDER } else { icon::ICON_DRAFT };
                        let chosen = !row.is_folder && row.name == self.name;
                        let button = Button::selectable(chosen, (sign.rich_text().color(palette.weak), &row.name));
                        let response = ui.add(button.truncate().min_size(egui::vec2(ui.available_width(), 22.0)));
                        if response.clicked() {
                            if row.is_folder {
                                folder = Some(self.folder.join(&row.name));
                            } else {
                                self.name.clone_from(&row.name);
                                self.replaces = None;
                            }
                        }
                        if response.double_clicked() && !row.is_folder && !self.request.save {
                            *reply = Some(Reply::Chosen(self.folder.join(&row.name)));
                        }
                    }
                },
            );
            if let Some(trouble) = &self.trouble {
                ui.colored_label(palette.error, words::folder_unreadable(lang, trouble));
            } else if self.rows.is_empty() {
                ui.colored_label(palette.weak, words::folder_empty(lang));
            }
        });
        if let Some(folder) = folder {
            self.enter(folder);
        }
    }

    /// The name, and which kinds of files are listed.
    fn kinds(&mut self, ui: &mut Ui, lang: Lang) {
        ui.horizontal(|ui| {
            let label = ui.label(words::file_name(lang));
            let edit = TextEdit::singleline(&mut self.name).desired_width(280.0);
            let response = ui.add(edit).labelled_by(label.id);
            if response.changed() {
                self.replaces = None;
            }
            if !self.begun {
                self.begun = true;
                response.request_focus();
            }
            let before = self.filter;
            let all = words::all_files(lang);
            let names: Vec<String> =
                self.request.filters.iter().map(|(name, _)| name.clone()).chain(std::iter::once(all)).collect();
            let current = names.get(self.filter).cloned().unwrap_or_default();
            let combo = egui::ComboBox::from_id_salt("kinds").selected_text(current).show_ui(ui, |ui| {
                for (place, name) in names.iter().enumerate() {
                    if ui.selectable_value(&mut self.filter, place, name).clicked() {
                        ui.close();
                    }
                }
            });
            let name = words::kinds_of_files(lang);
            combo.response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, &name));
            if self.filter != before {
                self.list();
            }
        });
    }

    fn finish(&mut self, ui: &mut Ui, palette: &Palette, lang: Lang, reply: &mut Option<Reply>) {
        if let Some(path) = &self.replaces {
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            ui.colored_label(palette.warning, words::replaces(lang, name));
        }
        ui.add_space(4.0);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let text = match (self.request.save, self.replaces.is_some()) {
                (true, true) => words::replace(lang),
                (true, false) => words::save(lang),
                (false, _) => words::open(lang),
            };
            let ready = !self.name.trim().is_empty();
            let accept = Button::new(RichText::new(text).strong()).fill(palette.selected);
            let enter = ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
            if ui.add_enabled(ready, accept).clicked() || enter && ready {
                *reply = self.accept();
            }
            if ui.button(words::cancel(lang)).clicked() {
                *reply = Some(Reply::Cancelled);
            }
        });
    }

    /// Takes the name: a folder is entered, a file to be replaced is asked about once.
    fn accept(&mut self) -> Option<Reply> {
        let mut path = self.folder.join(self.name.trim());
        if path.is_dir() {
            self.name.clear();
            self.enter(path);
            return None;
        }
        if self.request.save
            && path.extension().is_none()
            && let Some(extension) = self.request.filters.get(self.filter).and_then(|(_, known)| known.first())
        {
            path.set_extension(extension);
        }
        if !self.request.save && !path.is_file() {
            self.trouble = Some(path.display().to_string());
            return None;
        }
        if self.request.save && path.exists() && self.replaces.as_ref() != Some(&path) {
            self.replaces = Some(path);
            return None;
        }
        Some(Reply::Chosen(path))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(folder: &Path, save: bool, name: &str) -> Request {
        Request {
            title: "Open".into(),
            save,
            folder: Some(folder.to_owned()),
            name: name.into(),
            filters: vec![("Scenes".into(), vec!["xml".into(), "lancer".into()])],
        }
    }

    #[test]
    fn folders_come_first_and_only_the_kind_is_listed() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["b.XML", "a.lancer", "c.txt", ".hidden.xml"] {
            std::fs::write(folder.path().join(name), "").unwrap();
        }
        std::fs::create_dir(folder.path().join("Z")).unwrap();
        let names = |browser: &Browser| browser.rows.iter().map(|row| row.name.clone()).collect::<Vec<_>>();
        let mut browser = Browser::new(request(folder.path(), false, ""));
        assert_eq!(names(&browser), ["Z", "a.lancer", "b.XML"]);
        browser.filter = 1;
        browser.list();
        assert_eq!(names(&browser), ["Z", "a.lancer", "b.XML", "c.txt"]);
    }

    #[test]
    fn a_file_is_replaced_only_when_it_was_asked() {
        let folder = tempfile::tempdir().unwrap();
        let old = folder.path().join("old.xml");
        std::fs::write(&old, "").unwrap();
        let mut browser = Browser::new(request(folder.path(), true, "old"));
        assert_eq!(browser.accept(), None);
        assert_eq!(browser.accept(), Some(Reply::Chosen(old)));
        browser.name = "new.lancer".into();
        assert_eq!(browser.accept(), Some(Reply::Chosen(folder.path().join("new.lancer"))));
    }

    #[test]
    fn a_file_to_open_must_exist_and_a_folder_is_entered() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("inner")).unwrap();
        let mut browser = Browser::new(request(folder.path(), false, "nothing.xml"));
        assert_eq!(browser.accept(), None);
        assert!(browser.trouble.is_some());
        browser.name = "inner".into();
        assert_eq!(browser.accept(), None);
        assert_eq!(browser.folder, folder.path().join("inner"));
    }
}
