//! What the readers of scenes and of views share: the vocabulary, and the small elements that everything is made of.

use super::{FULL, N7Problem, Points};
use crate::xml::sink::Sink;
use crate::xml::{Document, Element, Excerpt, Node, Number};
use lancer_scene::{Color, DVec3, Invalid, Rgb, limits};

/// An element of the format, with its attributes and what stands in it.
pub(super) struct Rule {
    pub(super) name: &'static str,
    attributes: &'static [&'static str],
    elements: &'static [&'static str],
}

const fn rule(name: &'static str, attributes: &'static [&'static str], elements: &'static [&'static str]) -> Rule {
    Rule { name, attributes, elements }
}

pub(super) const SCENE: Rule = rule("Scene", &[], &["ObjetGraphique", "Source", "Couleur"]);
pub(super) const OBJECT: Rule = rule("ObjetGraphique", &[], &["Matiere", "Sphere", "Plan", "Cube", "ObjetFacette"]);
pub(super) const MATERIAL: Rule =
    rule("Matiere", &["n"], &["Ambiante", "Diffuse", "Speculaire", "Reflection", "Refraction"]);
pub(super) const AMBIENT: Rule = rule("Ambiante", &[], &["Couleur"]);
pub(super) const DIFFUSE: Rule = rule("Diffuse", &[], &["Couleur"]);
pub(super) const SPECULAR: Rule = rule("Speculaire", &["n"], &["Couleur"]);
pub(super) const REFLECTION: Rule = rule("Reflection", &[], &["Couleur"]);
pub(super) const REFRACTION: Rule = rule("Refraction", &[], &["Couleur"]);
pub(super) const SPHERE: Rule = rule("Sphere", &["rayon"], &["Point"]);
pub(super) const PLANE: Rule = rule("Plan", &[], &["Point"]);
pub(super) const CUBE: Rule = rule("Cube", &[], &["Point"]);
pub(super) const FACETS: Rule = rule("ObjetFacette", &[], &["Facette"]);
pub(super) const FACET: Rule = rule("Facette", &[], &["Point"]);
pub(super) const LAMP: Rule = rule("Source", &[], &["Point", "Couleur"]);
pub(super) const VIEWS: Rule = rule("Rendu", &[], &["Vue"]);
pub(super) const VIEW: Rule = rule("Vue", &["largeur", "hauteur"], &["PointVue", "Point"]);
pub(super) const EYE: Rule = rule("PointVue", &[], &["Point"]);
const POINT: Rule = rule("Point", &["x", "y", "z"], &[]);
const COLOUR: Rule = rule("Couleur", &["r", "v", "b"], &[]);

/// A document and what has been found wrong with it.
pub(super) struct Reader<'d> {
    pub(super) sink: Sink<'d>,
}

impl<'d> Reader<'d> {
    pub(super) fn new(document: &'d Document) -> Reader<'d> {
        Reader { sink: Sink::new(document) }
    }

    /// Whether the root is the one that is due.
    pub(super) fn check_root(&mut self, root: Element<'d>, due: &'static str) -> bool {
        let right = root.name() == due;
        if !right {
            self.sink.error(root.name_span(), N7Problem::WrongRoot { found: Excerpt::new(root.name()), due });
        }
        right
    }

    /// The elements that the rule knows within an element. Everything else within it, and every attribute that the
    /// rule does not know, is warned of.
    pub(super) fn open(&mut self, element: Element<'d>, rule: &Rule) -> Vec<(&'static str, Element<'d>)> {
        for attribute in element.attributes() {
            if !attribute.is_reserved() && !rule.attributes.contains(&attribute.name) {
                // Nothing can be guessed among names of one letter.
                let words = rule.attributes.iter().copied().filter(|name| name.len() > 1);
                let problem = N7Problem::UnknownAttribute {
                    name: Excerpt::new(attribute.name),
                    element: rule.name,
                    guess: self.sink.guess(attribute.name, words),
                    legal: rule.attributes,
                };
                self.sink.warning(attribute.name_span, problem);
            }
        }
        let mut known = Vec::new();
        for node in element.children() {
            match node {
                Node::Element(child) => match rule.elements.iter().find(|name| **name == child.name()) {
                    Some(&name) => known.push((name, child)),
                    None => {
                        let problem = N7Problem::UnknownElement {
                            name: Excerpt::new(child.name()),
                            parent: rule.name,
                            guess: self.sink.guess(child.name(), rule.elements.iter().copied()),
                            legal: rule.elements,
                        };
                        self.sink.warning(child.name_span(), problem);
                    }
                },
                Node::Text(text) if text.is_blank() => {}
                Node::Text(text) => {
                    self.sink.warning(text.trimmed_span(), N7Problem::StrayText { parent: rule.name });
                }
                Node::Comment(_) | Node::Instruction(_) => {}
            }
        }
        known
    }

    /// The one element of that name; another one, and none at all, is an error.
    pub(super) fn only(
        &mut self,
        parent: (Element<'d>, &Rule),
        within: &[(&'static str, Element<'d>)],
        due: &'static [&'static str],
    ) -> Option<Element<'d>> {
        let found = self.at_most_one(parent.1, within, due);
        if found.is_none() {
            self.sink.error(parent.0.name_span(), N7Problem::MissingElement { parent: parent.1.name, due });
        }
        found
    }

    /// The element of one of those names, if there is one; a second one is an error.
    pub(super) fn at_most_one(
        &mut self,
        parent: &Rule,
        within: &[(&'static str, Element<'d>)],
        names: &[&'static str],
    ) -> Option<Element<'d>> {
        let mut found = within.iter().filter(|(name, _)| names.contains(name));
        let &(first_name, first) = found.next()?;
        for &(name, second) in found {
            let line = self.sink.line(first.span().start);
            let problem = if names.len() > 1 {
                N7Problem::SecondShape { name, first: first_name, line }
            } else {
                N7Problem::SecondElement { name, parent: parent.name, line }
            };
            self.sink.error(second.name_span(), problem);
        }
        Some(first)
    }

    /// A number that an attribute holds; `None` and an error where it is missing or no number.
    pub(super) fn number(&mut self, element: Element<'d>, rule: &Rule, name: &'static str) -> Option<Number> {
        let Some(attribute) = element.attribute(name) else {
            self.sink.error(element.name_span(), N7Problem::MissingAttribute { name, element: rule.name });
            return None;
        };
        self.sink.keep(attribute.written().number())
    }

    /// A number that an attribute holds, or the default where it is missing.
    pub(super) fn number_or(&mut self, element: Element<'d>, name: &'static str, default: f64) -> Option<Number> {
        match element.attribute(name) {
            Some(attribute) => self.sink.keep(attribute.written().number()),
            None => Some(Number { value: default, span: element.name_span() }),
        }
    }

    /// A number brought into its range, with a warning if it was outside.
    pub(super) fn clamped(&mut self, number: Number, name: &'static str, min: f64, max: f64) -> f64 {
        if !(min..=max).contains(&number.value) {
            self.sink.warning(number.span, N7Problem::Clamped { name, found: number.value, min, max });
        }
        number.value.clamp(min, max)
    }

    /// Exactly `N` points among the elements within one.
    pub(super) fn points<const N: usize>(
        &mut self,
        parent: (Element<'d>, &Rule),
        within: &[(&'static str, Element<'d>)],
        meaning: Points,
    ) -> Option<[DVec3; N]> {
        let points: Vec<Option<DVec3>> =
            within.iter().filter(|(name, _)| *name == POINT.name).map(|(_, point)| self.point(*point)).collect();
        let found = points.len();
        match <[Option<DVec3>; N]>::try_from(points) {
            Ok(points) => {
                // Each point that is missing has told why.
                let complete = points.iter().all(Option::is_some);
                complete.then(|| points.map(Option::unwrap_or_default))
            }
            Err(_) => {
                let problem = N7Problem::PointCount { parent: parent.1.name, found, due: N, meaning };
                self.sink.error(parent.0.name_span(), problem);
                None
            }
        }
    }

    fn point(&mut self, element: Element<'d>) -> Option<DVec3> {
        self.open(element, &POINT);
        let coordinates = ["x", "y", "z"].map(|name| self.coordinate(element, name));
        let [x, y, z] = coordinates;
        Some(DVec3::new(x?, y?, z?))
    }

    fn coordinate(&mut self, element: Element<'d>, field: &'static str) -> Option<f64> {
        let number = self.number(element, &POINT, field)?;
        self.within(number, field, -limits::COORDINATE, limits::COORDINATE)
    }

    /// A number that must lie within a range.
    pub(super) fn within(&mut self, number: Number, field: &'static str, min: f64, max: f64) -> Option<f64> {
        let Number { value, span } = number;
        if (min..=max).contains(&value) {
            return Some(value);
        }
        self.sink.error(span, Invalid::OutOfRange { field, value, min, max });
        None
    }

    /// A `Couleur`, each channel brought into 0..255 and divided by 255.
    pub(super) fn colour(&mut self, element: Element<'d>) -> Option<Color> {
        self.open(element, &COLOUR);
        let channels = ["r", "v", "b"].map(|name| {
            let number = self.number(element, &COLOUR, name)?;
            Some(self.clamped(number, name, 0.0, FULL) / FULL)
        });
        let [r, v, b] = channels;
        Some(Rgb::new(r?, v?, b?))
    }
}
