//! What kind of document a root element begins.

use super::sink::Sink;
use super::vocabulary::{ELEMENTS, ElementRule, SCENE, VIEW, VIEWS};
use super::{Document, Element, Excerpt, Guess, StructureProblem};

/// The kinds of XML documents.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DocumentKind {
    /// A native scene.
    Scene,
    /// Native views.
    Views,
    /// A scene in the format of 2009: the root `Scene`.
    Scene2009,
    /// Views in the format of 2009: the root `Rendu`.
    Views2009,
}

impl Document {
    /// The kind that the root says; `None` for a root that begins no document. A `Scene` with native content or a
    /// version is a mistaken native scene.
    pub fn kind(&self) -> Option<DocumentKind> {
        let root = self.root();
        match root.name() {
            "scene" => Some(DocumentKind::Scene),
            "views" | "view" => Some(DocumentKind::Views),
            "Scene" if is_mistaken(root) => Some(DocumentKind::Scene),
            "Scene" => Some(DocumentKind::Scene2009),
            "Rendu" => Some(DocumentKind::Views2009),
            _ => None,
        }
    }
}

/// Whether a `Scene` is a native scene with a capital letter.
fn is_mistaken(root: Element<'_>) -> bool {
    let native = |name: &str| ELEMENTS.iter().any(|rule| rule.name == name);
    root.attribute("version").is_some() || root.elements().any(|child| native(child.name()))
}

/// Whether the root begins a native document of the kind that is due, of a version that is known here. If not, that is
/// all there is to say of the document.
pub(super) fn check_root<'d>(document: &'d Document, due: DocumentKind, sink: &mut Sink<'d>) -> bool {
    let root = document.root();
    let views = due == DocumentKind::Views;
    let problem = match root.name() {
        "Scene" if is_mistaken(root) => StructureProblem::SceneOf2009,
        "scene" | "Scene" if views => StructureProblem::SceneForViews,
        "views" | "view" | "Rendu" if !views => StructureProblem::ViewsForScene,
        "scene" | "views" | "view" => return known_version(root, sink),
        name => {
            let legal: &[&ElementRule] = if views { &[&VIEWS, &VIEW] } else { &[&SCENE] };
            let guess = Guess::among(name, legal.iter().map(|rule| rule.name));
            StructureProblem::UnknownRoot { name: Excerpt::new(name), guess }
        }
    };
    sink.error(root.name_span(), problem);
    false
}

/// Tells of a later version: then nothing else need be legal here. Other faults of the version come with the rest.
fn known_version<'d>(root: Element<'d>, sink: &mut Sink<'d>) -> bool {
    let Some(attribute) = root.attribute("version") else { return true };
    let version = attribute.value();
    let later = version.trim().parse::<f64>().is_ok_and(|version| version > 1.0);
    if later {
        sink.error(attribute.value_span, StructureProblem::NewerVersion { version: Excerpt::new(version.trim()) });
    }
    !later
}
