//! What is wrong with elements, attributes, names and references.

use super::{Excerpt, Guess};
use lancer_scene::NameKind;
use lancer_words::Lang;
use lancer_words::xml::value::{all_of, any_of};
use lancer_words::xml::{Report, structure as words};

/// An element, an attribute, a name or a reference that is not what the vocabulary asks for. `line` is where the first
/// of two stands.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "the fields are what the problem's name says")]
pub enum StructureProblem {
    /// An element that does not stand there, nor anywhere.
    UnknownElement { name: Excerpt, parent: &'static str, guess: Guess, legal: Vec<&'static str> },
    /// A known element in the wrong place.
    MisplacedElement { name: &'static str, parent: &'static str, home: Vec<&'static str> },
    /// An attribute that the element does not have.
    UnknownAttribute { name: Excerpt, element: &'static str, guess: Guess, legal: Vec<&'static str> },
    /// A required attribute is missing.
    MissingAttribute { name: &'static str, element: &'static str, sample: &'static str },
    /// A required element is missing.
    MissingElement { name: &'static str, parent: &'static str, sample: &'static str },
    /// A mesh with neither vertices and facets nor a file.
    EmptyMesh,
    /// An element that may stand once stands again.
    SecondElement { name: &'static str, parent: &'static str, line: usize },
    /// Text that is no white space where none is due.
    StrayText { parent: &'static str },
    /// `material=` beside an inline material.
    TwoMaterials { element: &'static str },
    /// A name on an inline material.
    NamedInline,
    /// Inline geometry beside `src`.
    BesideSource { name: &'static str },
    /// A `screen` beside `look-at`.
    ScreenBesideLookAt,
    /// `up` or `fov` without `look-at`.
    NeedsLookAt { name: &'static str },
    /// Attributes of two ways to give a screen.
    MixedScreen { name: &'static str, other: &'static str },
    /// A screen without attributes.
    EmptyScreen,
    /// A view without a screen.
    NoScreen { name: Excerpt },
    /// A root that is no document's.
    UnknownRoot { name: Excerpt, guess: Guess },
    /// Views where a scene is due.
    ViewsForScene,
    /// A scene where views are due.
    SceneForViews,
    /// `Scene` with native content.
    SceneOf2009,
    /// A later version of the format.
    NewerVersion { version: Excerpt },
    /// A version that is none.
    BadVersion { found: Excerpt },
    /// A name that stands already.
    NameTaken { kind: NameKind, name: Excerpt, line: usize },
    /// A reference to a material that does not exist.
    UnknownMaterial { name: Excerpt, guess: Guess, known: Vec<Excerpt> },
    /// A screen that shows the scene mirrored: a warning.
    MirroredScreen,
    /// A document of views without a view: a warning.
    NoViews,
    /// More problems than are listed.
    TooMany { count: usize },
}

impl StructureProblem {
    pub(super) fn told(&self, lang: Lang) -> (&'static str, Report) {
        use StructureProblem as P;
        match self {
            P::UnknownElement { name, parent, legal, .. } if legal.is_empty() => {
                ("xml::unknown-element", words::no_elements(lang, name, parent))
            }
            P::UnknownElement { name, parent, guess, legal } => {
                let report = words::unknown_element(lang, name, parent, guess.word(lang), all_of(lang, legal));
                ("xml::unknown-element", report)
            }
            P::MisplacedElement { name, parent, home } => {
                ("xml::misplaced-element", words::misplaced_element(lang, name, parent, any_of(lang, home)))
            }
            P::UnknownAttribute { name, element, legal, .. } if legal.is_empty() => {
                ("xml::unknown-attribute", words::no_attributes(lang, name, element))
            }
            P::UnknownAttribute { name, element, guess, legal } => {
                let report = words::unknown_attribute(lang, name, element, guess.word(lang), all_of(lang, legal));
                ("xml::unknown-attribute", report)
            }
            P::MissingAttribute { name, element, sample } => {
                ("xml::missing-attribute", words::missing_attribute(lang, name, element, sample))
            }
            P::MissingElement { name, parent, sample } => {
                ("xml::missing-element", words::missing_element(lang, name, parent, sample))
            }
            P::EmptyMesh => ("xml::empty-mesh", words::empty_mesh(lang)),
            P::SecondElement { name, parent, line } => {
                ("xml::second-element", words::second_element(lang, name, parent, line))
            }
            P::StrayText { parent } => ("xml::stray-text", words::stray_text(lang, parent)),
            P::TwoMaterials { element } => ("xml::two-materials", words::two_materials(lang, element)),
            P::NamedInline => ("xml::named-inline", words::named_inline(lang)),
            P::BesideSource { name } => ("xml::beside-source", words::beside_source(lang, name)),
            P::ScreenBesideLookAt => ("xml::screen-beside-look-at", words::screen_beside_look_at(lang)),
            P::NeedsLookAt { name } => ("xml::needs-look-at", words::needs_look_at(lang, name)),
            P::MixedScreen { name, other } => ("xml::mixed-screen", words::mixed_screen(lang, name, other)),
            P::EmptyScreen => ("xml::empty-screen", words::empty_screen(lang)),
            P::NoScreen { name } => ("xml::no-screen", words::no_screen(lang, name)),
            P::UnknownRoot { name, guess } => ("xml::unknown-root", words::unknown_root(lang, name, guess.word(lang))),
            P::ViewsForScene => ("xml::views-for-scene", words::views_for_scene(lang)),
            P::SceneForViews => ("xml::scene-for-views", words::scene_for_views(lang)),
            P::SceneOf2009 => ("xml::scene-of-2009", words::scene_of_2009(lang)),
            P::NewerVersion { version } => ("xml::newer-version", words::newer_version(lang, version)),
            P::BadVersion { found } if found.as_ref().is_empty() => ("xml::bad-version", words::empty_version(lang)),
            P::BadVersion { found } => ("xml::bad-version", words::bad_version(lang, found)),
            P::NameTaken { kind, name, line } => (
                "xml::name-taken",
                match kind {
                    NameKind::ObjectOrLight => words::object_name_taken(lang, name, line),
                    NameKind::Material => words::material_name_taken(lang, name, line),
                    NameKind::View => words::view_name_taken(lang, name, line),
                },
            ),
            P::UnknownMaterial { name, guess, known } => {
                let known = match known.as_slice() {
                    [] => words::no_materials(lang),
                    names => words::known_materials(lang, all_of(lang, names)),
                };
                let guess = if guess.0.is_some() { guess.word(lang) } else { words::no_such_material(lang) };
                ("xml::unknown-material", words::unknown_material(lang, name, guess, known))
            }
            P::MirroredScreen => ("xml::mirrored-screen", words::mirrored_screen(lang)),
            P::NoViews => ("xml::no-views", words::no_views(lang)),
            P::TooMany { count } => ("xml::too-many", words::too_many(lang, count)),
        }
    }
}
