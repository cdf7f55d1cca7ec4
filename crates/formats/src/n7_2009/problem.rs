//! What can be wrong with a document of 2009, and how it is told.

use super::Loss;
use crate::Describe;
use crate::xml::{Excerpt, Guess, shortest};
use lancer_words::xml::Report;
use lancer_words::xml::value::{all_of, any_of};
use lancer_words::{Lang, n7_2009 as words};

/// What is wrong with a document of 2009. What the format does not have is passed over with a warning; what it needs
/// and what breaks a rule is an error. `line` is where the first of two stands.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "the fields are what the problem's name says")]
pub enum N7Problem {
    /// An element that the format does not have there: a warning.
    UnknownElement { name: Excerpt, parent: &'static str, guess: Guess, legal: &'static [&'static str] },
    /// An attribute that the element does not have: a warning.
    UnknownAttribute { name: Excerpt, element: &'static str, guess: Guess, legal: &'static [&'static str] },
    /// Text that is no white space: a warning.
    StrayText { parent: &'static str },
    /// An element is missing: one of those that are due.
    MissingElement { parent: &'static str, due: &'static [&'static str] },
    /// An attribute is missing.
    MissingAttribute { name: &'static str, element: &'static str },
    /// An element that may stand once stands again.
    SecondElement { name: &'static str, parent: &'static str, line: usize },
    /// An object has a second shape.
    SecondShape { name: &'static str, first: &'static str, line: usize },
    /// Not as many points as are due.
    PointCount { parent: &'static str, found: usize, due: usize, meaning: Points },
    /// A colour of the scene that another follows: a warning.
    EarlierColour { line: usize },
    /// A number that was brought into its range: a warning.
    Clamped { name: &'static str, found: f64, min: f64, max: f64 },
    /// A refraction index that is not above 0.
    BadIndex { found: f64 },
    /// The bottom right corner is not where the others put it: a warning.
    CrookedCorner,
    /// The corners lie apart by something else than the extent: a warning.
    Extent { name: &'static str, extent: f64, apart: f64 },
    /// Views without a view: a warning.
    NoViews,
    /// A document of another kind.
    WrongRoot { found: Excerpt, due: &'static str },
    /// What writing the format leaves out: a warning.
    Loss(Loss),
}

/// What the points of an element are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names say it")]
pub enum Points {
    OfSphere,
    OfPlane,
    OfBox,
    OfFacet,
    OfLamp,
    OfEye,
    OfScreen,
}

impl Points {
    fn told(self, lang: Lang) -> String {
        match self {
            Points::OfSphere => words::points_of_sphere(lang),
            Points::OfPlane => words::points_of_plane(lang),
            Points::OfBox => words::points_of_box(lang),
            Points::OfFacet => words::points_of_facet(lang),
            Points::OfLamp => words::points_of_lamp(lang),
            Points::OfEye => words::points_of_eye(lang),
            Points::OfScreen => words::points_of_screen(lang),
        }
    }
}

/// How an element that is missing may be written.
fn sample(element: &str) -> &'static str {
    match element {
        "Couleur" => r#"<Couleur r="50" v="50" b="50"/>"#,
        "Matiere" => r#"<Matiere><Diffuse><Couleur r="200" v="40" b="40"/></Diffuse></Matiere>"#,
        "PointVue" => r#"<PointVue><Point x="0" y="20" z="600"/></PointVue>"#,
        _ => r#"<Sphere rayon="10"><Point x="0" y="0" z="0"/></Sphere>"#,
    }
}

impl N7Problem {
    fn told(&self, lang: Lang) -> (&'static str, Report) {
        use N7Problem as P;
        match self {
            P::UnknownElement { name, parent, legal: [], .. } => {
                ("n7::unknown-element", words::no_elements(lang, name, parent))
            }
            P::UnknownElement { name, parent, guess, legal } => {
                let report = words::unknown_element(lang, name, parent, guess.word(lang), all_of(lang, legal));
                ("n7::unknown-element", report)
            }
            P::UnknownAttribute { name, element, legal: [], .. } => {
                ("n7::unknown-attribute", words::no_attributes(lang, name, element))
            }
            P::UnknownAttribute { name, element, guess, legal } => {
                let report = words::unknown_attribute(lang, name, element, guess.word(lang), all_of(lang, legal));
                ("n7::unknown-attribute", report)
            }
            P::StrayText { parent } => ("n7::stray-text", words::stray_text(lang, parent)),
            P::MissingElement { parent, due } => {
                let sample = due.first().map_or("", |due| sample(due));
                ("n7::missing-element", words::missing_element(lang, parent, any_of(lang, due), sample))
            }
            P::MissingAttribute { name, element } => {
                ("n7::missing-attribute", words::missing_attribute(lang, name, element))
            }
            P::SecondElement { name, parent, line } => {
                ("n7::second-element", words::second_element(lang, name, parent, line))
            }
            P::SecondShape { name, first, line } => ("n7::second-shape", words::second_shape(lang, name, first, line)),
            P::PointCount { parent, found, due, meaning } => {
                let found = lancer_words::number::points(lang, *found);
                ("n7::point-count", words::point_count(lang, parent, found, due, meaning.told(lang)))
            }
            P::EarlierColour { line } => ("n7::earlier-colour", words::earlier_colour(lang, line)),
            P::Clamped { name, found, min, max } => {
                let numbers = [*found, found.clamp(*min, *max), *min, *max];
                let [found, taken, min, max] = numbers.map(shortest);
                ("n7::clamped", words::clamped(lang, name, found, taken, min, max))
            }
            P::BadIndex { found } => ("n7::bad-index", words::bad_index(lang, shortest(*found))),
            P::CrookedCorner => ("n7::crooked-corner", words::crooked_corner(lang)),
            P::Extent { name, extent, apart } => {
                ("n7::extent", words::extent(lang, name, shortest(*extent), shortest(*apart)))
            }
            P::NoViews => ("n7::no-views", words::no_views(lang)),
            P::WrongRoot { found, due } => ("n7::wrong-root", words::wrong_root(lang, found, due)),
            P::Loss(loss) => {
                let (message, label) = (loss.message(lang), loss.label(lang));
                (loss.code(), Report { message, label, help: loss.help(lang).unwrap_or_default() })
            }
        }
    }
}

impl Describe for N7Problem {
    fn code(&self) -> &'static str {
        self.told(Lang::English).0
    }

    fn message(&self, lang: Lang) -> String {
        self.told(lang).1.message
    }

    fn label(&self, lang: Lang) -> String {
        self.told(lang).1.label
    }

    fn help(&self, lang: Lang) -> Option<String> {
        Some(self.told(lang).1.help).filter(|help| !help.is_empty())
    }
}
