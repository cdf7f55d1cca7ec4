//! The names of the steps in the history, told in each language by the catalogue of words.

use lancer_scene::Name;
use lancer_words::{Lang, attribute, step};

/// What a step did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StepName {
    /// The document as it was opened.
    Opened,
    /// A new document.
    New,
    /// Something was added.
    Added(Name),
    /// Something was taken out.
    Deleted(Name),
    /// Several things were taken out.
    DeletedMany(usize),
    /// Something was copied under a new name.
    Duplicated(Name),
    /// Something got a new name.
    Renamed {
        /// The name before.
        from: Name,
        /// The name after.
        to: Name,
    },
    /// Something stands at another place of its list.
    Reordered(Name),
    /// Something takes part in the picture again.
    Shown(Name),
    /// Something takes no part in the picture any more.
    Hidden(Name),
    /// Something was moved in space.
    Moved(Name),
    /// An attribute was set; its name as the documents spell it.
    Set {
        /// What it belongs to; empty for the world.
        item: Name,
        /// The attribute.
        attribute: &'static str,
    },
    /// A view looks from elsewhere.
    Navigated(Name),
    /// The title of the scene was set.
    Titled,
    /// Several things were copied.
    DuplicatedMany(usize),
    /// Several things take part in the picture again.
    ShownMany(usize),
    /// Several things take no part in the picture any more.
    HiddenMany(usize),
    /// Several things were moved in space.
    MovedMany(usize),
    /// The scene's file was read again.
    Reloaded,
    /// Views were read from a file.
    ViewsLoaded,
    /// What a journal kept after a crash.
    Recovered,
}

impl StepName {
    /// The name in words.
    pub fn text(&self, lang: Lang) -> String {
        match self {
            StepName::Opened => step::opened(lang),
            StepName::New => step::new(lang),
            StepName::Added(name) => step::added(lang, name),
            StepName::Deleted(name) => step::deleted(lang, name),
            StepName::DeletedMany(count) => step::deleted_many(lang, count),
            StepName::Duplicated(name) => step::duplicated(lang, name),
            StepName::Renamed { from, to } => step::renamed(lang, from, to),
            StepName::Reordered(name) => step::reordered(lang, name),
            StepName::Shown(name) => step::shown(lang, name),
            StepName::Hidden(name) => step::hidden(lang, name),
            StepName::Moved(name) => step::moved(lang, name),
            StepName::Set { item, attribute } if item.is_empty() => {
                step::set_world(lang, attribute::label(lang, "world", attribute))
            }
            StepName::Set { item, attribute } => step::set(lang, item, attribute::label(lang, "", attribute)),
            StepName::Navigated(name) => step::navigated(lang, name),
            StepName::Titled => step::titled(lang),
            StepName::DuplicatedMany(count) => step::duplicated_many(lang, count),
            StepName::ShownMany(count) => step::shown_many(lang, count),
            StepName::HiddenMany(count) => step::hidden_many(lang, count),
            StepName::MovedMany(count) => step::moved_many(lang, count),
            StepName::Reloaded => step::reloaded(lang),
            StepName::ViewsLoaded => step::views_loaded(lang),
            StepName::Recovered => step::recovered(lang),
        }
    }
}
