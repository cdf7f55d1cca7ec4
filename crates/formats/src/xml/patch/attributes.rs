//! Brings the attributes of an element from one state of the model to another.

use super::super::kind::Value;
use super::super::values::Values;
use super::super::vocabulary::{AttributeRule, ElementRule, Presence};
use super::super::{Attribute, Element, escape};
use super::splices::Splices;
use crate::Span;

/// Changes those attributes whose values differ, in place; takes out those that have no value any more, and puts new ones
/// where the vocabulary's order has them. Others stay, also where they say what holds without them.
///
/// With `name_it`, the name is written out even if it has not changed.
pub(super) fn patch_attributes(
    splices: &mut Splices<'_>,
    element: Element<'_>,
    rule: &'static ElementRule,
    old: &Values<'_>,
    new: &Values<'_>,
    name_it: bool,
) {
    // Where a new attribute goes: after those that precede it in the vocabulary, or after the name.
    let mut place = element.name_span().end;
    for attribute in rule.attributes {
        let (old, new) = (value_of(old, attribute), value_of(new, attribute));
        let standing = element.attribute(attribute.name);
        let due = name_it && attribute.name == "name" && standing.is_none();
        if old != new || due {
            match (&standing, new.map(|value| attribute.kind.write(value))) {
                (Some(standing), Some(text)) => {
                    let text = quoted(&text, splices, standing);
                    splices.replace(standing.value_span, text);
                }
                (Some(standing), None) => remove(splices, standing),
                (None, Some(text)) if due || !is_default(attribute, &text) => {
                    splices.insert(place, format!(" {}=\"{}\"", attribute.name, escape(&text)));
                }
                (None, _) => {}
            }
        }
        if let Some(standing) = standing {
            place = place.max(standing.span().end);
        }
    }
}

fn value_of<'v, 'm>(values: &'v Values<'m>, attribute: &AttributeRule) -> Option<&'v Value<'m>> {
    values.iter().find(|(name, _)| *name == attribute.name).map(|(_, value)| value)
}

fn is_default(attribute: &AttributeRule, text: &str) -> bool {
    matches!(attribute.presence, Presence::Default(default) if default == text)
}

/// A text as it may stand between the quotes that an attribute has.
fn quoted(text: &str, splices: &Splices<'_>, attribute: &Attribute<'_>) -> String {
    let escaped = escape(text).into_owned();
    match splices.text().as_bytes().get(attribute.value_span.end) {
        Some(b'\'') => escaped.replace('\'', "&apos;"),
        _ => escaped,
    }
}

/// Takes an attribute out with the white space before it.
fn remove(splices: &mut Splices<'_>, attribute: &Attribute<'_>) {
    let span = attribute.span();
    let before = splices.text()[..span.start].trim_end().len();
    splices.replace(Span { start: before, end: span.end }, "");
}
