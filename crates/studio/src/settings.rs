//! What is remembered from one start to the next.

use crate::Tab;
use crate::layout::Layout;
use lancer_words::Lang;
use std::path::{Path, PathBuf};

/// The key under which the settings are stored.
pub const KEY: &str = "settings";
/// How many files the menu of recent files holds.
const MOST_RECENT: usize = 10;

/// What is remembered from one start to the next.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
#[serde(default)]
pub struct Settings {
    /// The language's code; empty for the locale's.
    language: String,
    /// Light, dark, or as the system says.
    pub theme: egui::ThemePreference,
    /// The size of everything.
    pub zoom: f32,
    /// Whether the outliner is shown.
    pub outliner: bool,
    /// Whether the properties are shown.
    pub properties: bool,
    /// Whether the tabs at the bottom are shown.
    pub tabs: bool,
    /// The tab in front.
    pub tab: Tab,
    /// Files that were opened or saved, the newest first.
    pub recent: Vec<PathBuf>,
    /// The folder of the last dialog.
    pub folder: Option<PathBuf>,
    /// The panes.
    pub layout: Layout,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            language: String::new(),
            theme: egui::ThemePreference::Dark,
            zoom: 1.0,
            outliner: true,
            properties: true,
            tabs: true,
            tab: Tab::default(),
            recent: Vec::new(),
            folder: None,
            layout: Layout::default(),
        }
    }
}

impl Settings {
    /// The least and the greatest size of everything.
    pub const ZOOM: std::ops::RangeInclusive<f32> = 0.5..=3.0;

    /// The language that was chosen; `None` for the locale's.
    pub fn language(&self) -> Option<Lang> {
        Lang::ALL.into_iter().find(|lang| lang.code() == self.language)
    }

    /// Chooses a language.
    pub fn set_language(&mut self, lang: Lang) {
        self.language = lang.code().to_owned();
    }

    /// Remembers a file that was opened or saved.
    pub fn remember(&mut self, path: &Path) {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        self.folder = path.parent().map(Path::to_owned);
        self.recent.retain(|known| *known != path);
        self.recent.insert(0, path);
        self.recent.truncate(MOST_RECENT);
    }

    /// What was stored, with values brought into their ranges: a settings file can be edited by hand.
    pub fn restored(storage: Option<&dyn eframe::Storage>) -> Settings {
        let mut settings: Settings = storage.and_then(|storage| eframe::get_value(storage, KEY)).unwrap_or_default();
        let zoom = settings.zoom;
        settings.zoom = if zoom.is_finite() { zoom.clamp(*Settings::ZOOM.start(), *Settings::ZOOM.end()) } else { 1.0 };
        settings.recent.truncate(MOST_RECENT);
        settings
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_newest_file_stands_first_and_once() {
        let mut settings = Settings::default();
        for number in 0..12 {
            settings.remember(Path::new(&format!("/scenes/{number}.xml")));
        }
        settings.remember(Path::new("/scenes/5.xml"));
        assert_eq!(settings.recent.len(), MOST_RECENT);
        assert_eq!(settings.recent[0], Path::new("/scenes/5.xml"));
        assert_eq!(settings.recent.iter().filter(|path| path.ends_with("5.xml")).count(), 1);
        assert_eq!(settings.folder.as_deref(), Some(Path::new("/scenes")));
    }
}
