//! What can be wrong with a file in the Neutral File Format.

use crate::Describe;
use crate::xml::{Excerpt, Guess, shortest};
use lancer_scene::Invalid;
use lancer_words::{Lang, nff as words};

/// What a number of the file says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A coordinate of a point, or of a direction.
    Coordinate,
    /// A channel of a colour.
    Channel,
    /// A radius.
    Radius,
    /// A fill's `Kd`.
    Diffuse,
    /// A fill's `Ks`.
    Specular,
    /// A fill's exponent of the highlight.
    Shine,
    /// A fill's `T`.
    Transmittance,
    /// A fill's index of refraction.
    Index,
    /// A view's angle.
    Angle,
    /// The distance of a view's hither plane.
    Hither,
    /// The pixels of a row or a column.
    Pixels,
    /// The corners of a polygon or a patch.
    Corners,
}

impl Quantity {
    fn told(self, lang: Lang) -> String {
        match self {
            Quantity::Coordinate => words::coordinate(lang),
            Quantity::Channel => words::channel(lang),
            Quantity::Radius => words::radius(lang),
            Quantity::Diffuse => words::diffuse(lang),
            Quantity::Specular => words::specular(lang),
            Quantity::Shine => words::shine(lang),
            Quantity::Transmittance => words::transmittance(lang),
            Quantity::Index => words::index(lang),
            Quantity::Angle => words::angle(lang),
            Quantity::Hither => words::hither(lang),
            Quantity::Pixels => words::pixels(lang),
            Quantity::Corners => words::corners(lang),
        }
    }
}

/// Something wrong or odd.
#[derive(Clone, Debug, PartialEq)]
pub enum NffProblem {
    /// A word that begins no entity.
    UnknownEntity {
        /// The word.
        word: Excerpt,
    },
    /// A word is due that says what a line of the view holds.
    UnknownOfView {
        /// The word that stands there.
        word: Excerpt,
        /// The one that was probably meant.
        guess: Guess,
    },
    /// The view lacks a line.
    ViewLacks {
        /// Its word.
        word: &'static str,
    },
    /// Something else stands where a number is due.
    NotANumber {
        /// What stands there.
        found: Excerpt,
        /// What the number would be.
        due: Quantity,
    },
    /// The file ends where a number is due.
    Ended {
        /// What the number would be.
        due: Quantity,
    },
    /// A number is outside its range.
    OutOfRange {
        /// What it is.
        what: Quantity,
        /// What it is said to be.
        found: f64,
        /// The least that is legal.
        least: f64,
        /// The greatest that is legal.
        greatest: f64,
    },
    /// A number is outside its range and is brought there.
    Clamped {
        /// What it is.
        what: Quantity,
        /// What it is said to be.
        found: f64,
        /// What is taken for it.
        taken: f64,
    },
    /// A count that is no whole number, or not one of those that are legal.
    Count {
        /// What it counts.
        what: Quantity,
        /// What stands there.
        found: Excerpt,
        /// The least that is legal.
        least: u32,
        /// The greatest that is legal.
        greatest: u32,
    },
    /// A negative radius: only the inside would be seen.
    InsideOnly,
    /// An object breaks a rule of the scene.
    Broken(Invalid),
    /// A second view, which is left out.
    SecondView,
    /// There is no view.
    NoView,
    /// The objects need more memory than a file of this size has a right to.
    TooMuchMemory {
        /// How many bytes.
        most: usize,
    },
    /// There are more errors, which are not told.
    More,
}

impl Describe for NffProblem {
    fn code(&self) -> &'static str {
        match self {
            NffProblem::UnknownEntity { .. } => "nff::entity",
            NffProblem::UnknownOfView { .. } => "nff::view-word",
            NffProblem::ViewLacks { .. } => "nff::view-lacks",
            NffProblem::NotANumber { .. } => "nff::number",
            NffProblem::Ended { .. } => "nff::ended",
            NffProblem::OutOfRange { .. } => "nff::range",
            NffProblem::Clamped { .. } => "nff::clamped",
            NffProblem::Count { .. } => "nff::count",
            NffProblem::InsideOnly => "nff::inside-only",
            NffProblem::Broken(_) => "nff::rule",
            NffProblem::SecondView => "nff::second-view",
            NffProblem::NoView => "nff::no-view",
            NffProblem::TooMuchMemory { .. } => "nff::memory",
            NffProblem::More => "nff::more",
        }
    }

    fn message(&self, lang: Lang) -> String {
        match self {
            NffProblem::UnknownEntity { word } => words::unknown_entity(lang, word),
            NffProblem::UnknownOfView { word, .. } => words::unknown_of_view(lang, word),
            NffProblem::ViewLacks { word } => words::view_lacks(lang, word),
            NffProblem::NotANumber { found, due } => words::not_a_number(lang, found, due.told(lang)),
            NffProblem::Ended { due } => words::ended(lang, due.told(lang)),
            NffProblem::OutOfRange { what, found, .. } => words::out_of_range(lang, what.told(lang), shortest(*found)),
            NffProblem::Clamped { what, found, taken } => {
                words::clamped(lang, what.told(lang), shortest(*found), shortest(*taken))
            }
            NffProblem::Count { what, found, .. } => words::count(lang, what.told(lang), found),
            NffProblem::InsideOnly => words::inside_only(lang),
            NffProblem::Broken(rule) => crate::xml::XmlProblem::from(rule.clone()).message(lang),
            NffProblem::SecondView => words::second_view(lang),
            NffProblem::NoView => words::no_view(lang),
            NffProblem::TooMuchMemory { most } => words::too_much_memory(lang, most >> 20),
            NffProblem::More => words::more(lang),
        }
    }

    fn label(&self, lang: Lang) -> String {
        match self {
            NffProblem::UnknownOfView { guess, .. } => guess.word(lang),
            NffProblem::Broken(rule) => crate::xml::XmlProblem::from(rule.clone()).label(lang),
            NffProblem::UnknownEntity { .. }
            | NffProblem::ViewLacks { .. }
            | NffProblem::NotANumber { .. }
            | NffProblem::Ended { .. }
            | NffProblem::OutOfRange { .. }
            | NffProblem::Clamped { .. }
            | NffProblem::Count { .. }
            | NffProblem::InsideOnly
            | NffProblem::SecondView
            | NffProblem::NoView
            | NffProblem::TooMuchMemory { .. }
            | NffProblem::More => String::new(),
        }
    }

    fn help(&self, lang: Lang) -> Option<String> {
        Some(match self {
            NffProblem::UnknownEntity { .. } => words::entities_help(lang),
            NffProblem::UnknownOfView { .. } | NffProblem::ViewLacks { .. } => words::view_help(lang),
            NffProblem::NotANumber { .. } => words::number_help(lang),
            NffProblem::Ended { .. } => words::ended_help(lang),
            NffProblem::OutOfRange { what, least, greatest: f64::MAX, .. } => {
                words::least_help(lang, what.told(lang), shortest(*least))
            }
            NffProblem::OutOfRange { what, least, greatest, .. } => {
                words::range_help(lang, what.told(lang), shortest(*least), shortest(*greatest))
            }
            NffProblem::Clamped { .. } => words::clamped_help(lang),
            NffProblem::Count { what, least, greatest, .. } => {
                words::count_help(lang, what.told(lang), least, greatest)
            }
            NffProblem::InsideOnly => words::inside_only_help(lang),
            NffProblem::SecondView => words::second_view_help(lang),
            NffProblem::NoView => words::no_view_help(lang),
            NffProblem::TooMuchMemory { .. } => words::too_much_memory_help(lang),
            NffProblem::Broken(rule) => return crate::xml::XmlProblem::from(rule.clone()).help(lang),
            NffProblem::More => return None,
        })
    }
}
