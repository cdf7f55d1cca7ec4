//! What stands within an element, checked by the vocabulary's table.

use super::sink::Sink;
use super::vocabulary::{ELEMENTS, ElementRule, TextRule, Times};
use super::{Element, Excerpt, Guess, Node, StructureProblem};

/// The legal elements within an element; everything else there has been told.
pub(super) struct Contents;

impl Contents {
    /// The legal elements within an element, in the order of the text, each with its rule.
    pub(super) fn read<'d>(
        element: Element<'d>,
        rule: &'static ElementRule,
        sink: &mut Sink<'d>,
    ) -> Vec<(&'static ElementRule, Element<'d>)> {
        let mut found: Vec<(&'static ElementRule, Element<'d>)> = Vec::new();
        for node in element.children() {
            match node {
                Node::Element(child) => {
                    let Some(known) = rule.children.iter().find(|known| known.rule.name == child.name()) else {
                        unknown(child, rule, sink);
                        continue;
                    };
                    let first = match known.times {
                        Times::Any => None,
                        Times::Once | Times::AtMostOnce => {
                            found.iter().find(|(rule, _)| std::ptr::eq(*rule, known.rule))
                        }
                    };
                    match first {
                        None => found.push((known.rule, child)),
                        Some((_, first)) => {
                            let line = sink.line(first.span().start);
                            let (name, parent) = (known.rule.name, rule.name);
                            sink.error(child.name_span(), StructureProblem::SecondElement { name, parent, line });
                        }
                    }
                }
                Node::Text(text) if rule.text == TextRule::Nothing => {
                    sink.error(text.trimmed_span(), StructureProblem::StrayText { parent: rule.name });
                }
                Node::Text(_) | Node::Comment(_) | Node::Instruction(_) => {}
            }
        }
        found
    }

    /// Nothing may stand within the element.
    pub(super) fn none<'d>(element: Element<'d>, rule: &'static ElementRule, sink: &mut Sink<'d>) {
        Contents::read(element, rule, sink);
    }
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
            guess: Guess::among(name, legal.iter().copied()),
            legal,
        },
    };
    sink.error(child.name_span(), problem);
}
