//! What stands within an element, checked by the vocabulary's table.

use super::sink::Sink;
use super::vocabulary::{ELEMENTS, ElementRule, TextRule, Times};
use super::{Element, Excerpt, Node, StructureProblem};

/// The legal elements within an element, in the order of the text, each with its rule; everything else there is told.
pub(super) fn contents<'d>(
    element: Element<'d>,
    rule: &'static ElementRule,
    sink: &mut Sink<'d>,
) -> Vec<(&'static ElementRule, Element<'d>)> {
    let mut found = Vec::new();
    // Of each element that may stand once, the first.
    let mut first: Vec<Option<Element<'d>>> = vec![None; rule.children.len()];
    for node in element.children() {
        match node {
            Node::Element(child) => {
                let known = rule.children.iter().zip(&mut first).find(|(known, _)| known.rule.name == child.name());
                match known {
                    None => unknown(child, rule, sink),
                    Some((known, Some(first))) if known.times != Times::Any => {
                        let line = sink.line(first.span().start);
                        let (name, parent) = (known.rule.name, rule.name);
                        sink.error(child.name_span(), StructureProblem::SecondElement { name, parent, line });
                    }
                    Some((known, first)) => {
                        *first = Some(child);
                        found.push((known.rule, child));
                    }
                }
            }
            // white space may be written as a reference or within CDATA
            Node::Text(text) if rule.text == TextRule::Nothing && !text.is_blank() => {
                sink.error(text.trimmed_span(), StructureProblem::StrayText { parent: rule.name });
            }
            Node::Text(_) | Node::Comment(_) | Node::Instruction(_) => {}
        }
    }
    found
}

/// No elements may stand within the element, and no text but what its rule says.
pub(super) fn no_contents<'d>(element: Element<'d>, rule: &'static ElementRule, sink: &mut Sink<'d>) {
    contents(element, rule, sink);
}

/// An element that does not stand here.
fn unknown<'d>(child: Element<'d>, parent: &'static ElementRule, sink: &mut Sink<'d>) {
    let name = child.name();
    let elsewhere = ELEMENTS.iter().find(|rule| rule.name == name).filter(|rule| !rule.homes().is_empty());
    let legal: Vec<&'static str> = parent.children.iter().map(|child| child.rule.name).collect();
    let problem = match elsewhere {
        Some(rule) => StructureProblem::MisplacedElement { name: rule.name, parent: parent.name, home: rule.homes() },
        None => StructureProblem::UnknownElement {
            name: Excerpt::new(name),
            parent: parent.name,
            guess: sink.guess(name, legal.iter().copied()),
            legal,
        },
    };
    sink.error(child.name_span(), problem);
}
