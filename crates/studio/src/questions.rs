//! What is asked for when a file is wanted: titles, proposed names, kinds of files.

use crate::Exported;
use crate::app::Studio;
use crate::dialogs::Request;
use crate::foreign::Foreign;
use lancer_document::open::MESH_EXTENSIONS;
use lancer_formats::picture::Format;
use lancer_scene::Name;
use lancer_words::studio::app as words;
use std::path::Path;

/// What a dialog was opened for.
#[derive(Clone, Debug)]
pub(crate) enum Question {
    Open,
    Save,
    LoadViews,
    SaveViews,
    Mesh,
    Picture(Name, Format),
    Text {
        name: String,
        text: String,
    },
    /// Something for another program.
    Export(Exported, Box<Foreign>),
}

impl Studio {
    /// Asks for a file.
    pub(crate) fn ask(&mut self, question: Question) {
        self.dialogs.ask(&self.request(&question));
        self.model.files.question = Some(question);
    }

    pub(crate) fn request(&self, question: &Question) -> Request {
        let lang = self.model.lang;
        let kind =
            |name: String, extensions: &[&str]| (name, extensions.iter().map(|e| (*e).to_owned()).collect::<Vec<_>>());
        let file = self.model.document.scene_file().map(|file| file.path.as_path());
        let stem = file.and_then(Path::file_stem).map(|stem| stem.to_string_lossy().into_owned());
        let stem = stem.unwrap_or_else(|| "scene".to_owned());
        let none = String::new();
        let xml_first = || vec![kind(words::xml_scenes(lang), &["xml"]), kind(words::binary_scenes(lang), &["lancer"])];
        let (title, save, name, filters) = match question {
            Question::Open => {
                let mut every = vec!["xml", "lancer", "nff"];
                every.extend(MESH_EXTENSIONS);
                (words::open_title(lang), false, none, vec![kind(words::scenes(lang), &every)])
            }
            Question::Save => {
                let mut filters = xml_first();
                if file.and_then(Path::extension).is_some_and(|extension| extension == "lancer") {
                    filters.reverse();
                }
                let extension = filters.first().and_then(|(_, known)| known.first()).cloned().unwrap_or_default();
                (words::save_title(lang), true, format!("{stem}.{extension}"), filters)
            }
            Question::LoadViews => {
                (words::load_views_title(lang), false, none, vec![kind(words::view_documents(lang), &["xml"])])
            }
            Question::SaveViews => {
                let name = format!("{stem}.view.xml");
                (words::save_views_title(lang), true, name, vec![kind(words::view_documents(lang), &["xml"])])
            }
            Question::Mesh => {
                (words::add_mesh_title(lang), false, none, vec![kind(words::meshes(lang), &MESH_EXTENSIONS)])
            }
            Question::Picture(view, format) => {
                let extension = extension(*format);
                let name = format!("{stem}-{view}.{extension}");
                (words::save_picture_title(lang, view), true, name, vec![kind(words::pictures(lang), &[extension])])
            }
            Question::Export(what, _) => {
                let (more, extension) = what.ending();
                let filter = kind(what.format(lang), &[extension]);
                let title = words::export_title(lang, what.name(lang));
                (title, true, format!("{stem}{more}.{extension}"), vec![filter])
            }
            Question::Text { name, .. } => {
                let extension = Path::new(name).extension().map(|e| e.to_string_lossy().into_owned());
                let filter = kind(words::texts(lang), &[extension.as_deref().unwrap_or("txt")]);
                (words::save_text_title(lang), true, name.clone(), vec![filter])
            }
        };
        Request { title, save, folder: self.model.settings.folder.clone(), name, filters }
    }
}

/// The extension of a format.
fn extension(format: Format) -> &'static str {
    match format {
        Format::PlainPpm | Format::RawPpm => "ppm",
        Format::Png => "png",
        Format::Qoi => "qoi",
        Format::Bmp => "bmp",
        Format::Tiff => "tiff",
        Format::Exr => "exr",
    }
}
