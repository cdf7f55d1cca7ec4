//! The attributes of one element, read by the vocabulary's table.

use super::kind::Value;
use super::sink::Sink;
use super::vocabulary::{AttributeRule, ElementRule, Presence};
use super::{Element, Excerpt, StructureProblem, Written};
use crate::{Diagnostic, Span};
use lancer_scene::{Color, DVec3, Invalid, Rgb, Steps};
use std::borrow::Cow;

/// Where an element stands, as far as its attributes depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stands {
    /// The document's root.
    AtRoot,
    /// Anywhere else.
    Within,
    /// An inline material, which takes no name.
    Inline,
}

/// The values of an element's attributes. Whatever is wrong with them has been told; then no value is given, but for
/// those asked for by [`Fields::text_of`].
#[derive(Debug)]
pub(super) struct Fields<'d> {
    rule: &'static ElementRule,
    element: Element<'d>,
    values: Vec<(&'static AttributeRule, Value<'d>, Span)>,
    sound: bool,
    /// The attributes that unknown ones were probably meant to be: they are not told to be missing too.
    meant: Vec<Excerpt>,
}

impl<'d> Fields<'d> {
    pub(super) fn read(
        element: Element<'d>,
        rule: &'static ElementRule,
        stands: Stands,
        sink: &mut Sink<'_>,
    ) -> Fields<'d> {
        let values = Vec::with_capacity(rule.attributes.len());
        let mut fields = Fields { rule, element, values, sound: true, meant: Vec::new() };
        let mut seen = 0_u64;
        let takes = |attribute: &AttributeRule| match (attribute.presence, stands) {
            (Presence::AtRoot(_), stands) => stands == Stands::AtRoot,
            (Presence::Required(_), Stands::Inline) => false,
            _ => true,
        };
        for attribute in element.attributes() {
            let known = rule.attributes.iter().enumerate().find(|(_, known)| known.name == attribute.name);
            match known {
                Some((number, known)) if takes(known) => {
                    seen |= 1 << number;
                    match sink.keep_all(known.kind.read(known.name, &attribute.written())) {
                        Some(value) => fields.values.push((known, value, attribute.value_span)),
                        None => fields.sound = false,
                    }
                }
                _ if attribute.is_reserved() => {}
                Some(_) if stands == Stands::Inline => {
                    sink.error(attribute.name_span, StructureProblem::NamedInline);
                    fields.sound = false;
                }
                _ => {
                    let legal: Vec<&'static str> =
                        rule.attributes.iter().filter(|known| takes(known)).map(|known| known.name).collect();
                    let guess = sink.guess(attribute.name, legal.iter().copied());
                    fields.meant.extend(guess.0.clone());
                    let name = Excerpt::new(attribute.name);
                    let problem = StructureProblem::UnknownAttribute { name, element: rule.name, guess, legal };
                    sink.error(attribute.name_span, problem);
                    fields.sound = false;
                }
            }
        }
        for (number, attribute) in rule.attributes.iter().enumerate() {
            if let Presence::Required(sample) | Presence::AtRoot(sample) = attribute.presence
                && takes(attribute)
                && !fields.meant(attribute.name)
                && seen & (1 << number) == 0
            {
                let problem = StructureProblem::MissingAttribute { name: attribute.name, element: rule.name, sample };
                sink.error(element.name_span(), problem);
                fields.sound = false;
            }
        }
        fields
    }

    /// Whether every attribute is legal.
    pub(super) fn are_sound(&self) -> bool {
        self.sound
    }

    /// Whether an unknown attribute was probably meant to be this one.
    pub(super) fn meant(&self, name: &str) -> bool {
        self.meant.iter().any(|meant| meant.as_ref() == name)
    }

    /// The place of the element's name.
    pub(super) fn name_span(&self) -> Span {
        self.element.name_span()
    }

    /// The place of an attribute's value, if it stands.
    pub(super) fn span(&self, name: &str) -> Option<Span> {
        self.values.iter().find(|(attribute, ..)| attribute.name == name).map(|(_, _, span)| *span)
    }

    /// The text of an attribute that stands and is legal, whatever is wrong with the others; and its place.
    pub(super) fn text_of(&self, name: &str) -> Option<(&str, Span)> {
        self.values.iter().find(|(attribute, ..)| attribute.name == name).and_then(|(_, value, span)| match value {
            Value::Text(text) => Some((&**text, *span)),
            Value::Number(_)
            | Value::Integer(_)
            | Value::Pair(_)
            | Value::Triple(_)
            | Value::Corners(_)
            | Value::Word(_)
            | Value::Steps(_)
            | Value::Run(..) => None,
        })
    }

    /// The value that stands, or the default.
    fn value(&self, name: &str) -> Option<Cow<'_, Value<'d>>> {
        if !self.sound {
            return None;
        }
        if let Some((_, value, _)) = self.values.iter().find(|(attribute, ..)| attribute.name == name) {
            return Some(Cow::Borrowed(value));
        }
        let attribute = self.rule.attribute(name)?;
        match attribute.presence {
            Presence::Default(text) => attribute.kind.read(attribute.name, &Written::new(text)).ok().map(Cow::Owned),
            Presence::Required(_) | Presence::Automatic | Presence::Optional | Presence::AtRoot(_) => None,
        }
    }

    pub(super) fn triple(&self, name: &str) -> Option<[f64; 3]> {
        if let Value::Triple(numbers) = &*self.value(name)? { Some(*numbers) } else { None }
    }

    pub(super) fn point(&self, name: &str) -> Option<DVec3> {
        self.triple(name).map(DVec3::from)
    }

    pub(super) fn color(&self, name: &str) -> Option<Color> {
        self.triple(name).map(Rgb::from)
    }

    pub(super) fn number(&self, name: &str) -> Option<f64> {
        if let Value::Number(number) = &*self.value(name)? { Some(*number) } else { None }
    }

    pub(super) fn integer(&self, name: &str) -> Option<u32> {
        if let Value::Integer(number) = &*self.value(name)? { Some(*number) } else { None }
    }

    pub(super) fn pair(&self, name: &str) -> Option<[f64; 2]> {
        if let Value::Pair(numbers) = &*self.value(name)? { Some(*numbers) } else { None }
    }

    pub(super) fn corners(&self, name: &str) -> Option<[DVec3; 4]> {
        if let Value::Corners(corners) = &*self.value(name)? { Some(corners.map(DVec3::from)) } else { None }
    }

    pub(super) fn flag(&self, name: &str) -> Option<bool> {
        self.word(name).map(|word| word == "true")
    }

    pub(super) fn word(&self, name: &str) -> Option<&'static str> {
        if let Value::Word(word) = &*self.value(name)? { Some(word) } else { None }
    }

    pub(super) fn steps(&self, name: &str) -> Option<Steps> {
        if let Value::Steps(steps) = &*self.value(name)? { Some(*steps) } else { None }
    }

    pub(super) fn run(&self, name: &str) -> Option<(u32, u32)> {
        if let Value::Run(first, count) = &*self.value(name)? { Some((*first, *count)) } else { None }
    }

    /// What was read, or nothing and the broken rule among the problems, at the attribute that the rule names or else at
    /// the element's name.
    pub(super) fn checked<T>(&self, value: T, rule: Result<(), Invalid>, sink: &mut Sink<'_>) -> Option<T> {
        match rule {
            Ok(()) => Some(value),
            Err(rule) => {
                let span = self.place_of(&rule).unwrap_or_else(|| self.element.name_span());
                sink.push(Diagnostic::error(span, rule));
                None
            }
        }
    }

    fn place_of(&self, rule: &Invalid) -> Option<Span> {
        match rule {
            Invalid::NotFinite { field } | Invalid::OutOfRange { field, .. } => self.span(field),
            Invalid::Collinear => self
                .span("p0")
                .zip(self.span("p2"))
                .map(|(first, last)| Span { start: first.start.min(last.start), end: first.end.max(last.end) }),
            Invalid::Coplanar => self.span("u"),
            Invalid::ConeFlat => self.span("top"),
            Invalid::ConeThin => self.span("top-radius"),
            Invalid::ScaleZero => self.span("scale"),
            Invalid::BadName | Invalid::NameTaken { .. } => self.span("name"),
            Invalid::UnknownMaterial { .. } => self.span("material"),
            Invalid::NotParallelogram => self.span("corners"),
            Invalid::LookAtIsEye => self.span("look-at").or_else(|| self.span("center")),
            Invalid::UpAlongSight => self.span("up").or_else(|| self.span("look-at")),
            Invalid::ScreenCollinear => self.span("u"),
            Invalid::PartRange { .. } => self.span("facets"),
            Invalid::EyeInScreen | Invalid::FacetVertex { .. } | Invalid::NormalCount { .. } => None,
        }
    }
}
