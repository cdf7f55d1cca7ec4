//! The published schema of the native documents: RELAX NG, made of the vocabulary.
//!
//! It says which elements and attributes there are, which must stand, and how each value is written. What needs more
//! than one value to judge (names that are taken, points on one line) is the readers' matter.

use super::escape;
use super::vocabulary::{
    AttributeRule, Child, ELEMENTS, ElementRule, Kind, MATERIAL, Presence, SCENE, STEPS, TextRule, Times, VIEW,
};
use lancer_words::Lang;
use std::fmt::Write as _;

/// A number as the documents write it.
const NUMBER: &str = r"[+\-]?[0-9]+(\.[0-9]+)?([eE][+\-]?[0-9]+)?";
/// What parts two numbers: white space, or one comma with white space around it.
const PARTED: &str = r"(\s+|\s*,\s*)";

/// The schema of scene and view documents, in RELAX NG's XML syntax, with the vocabulary's sentences in a language.
pub fn schema(lang: Lang) -> String {
    let mut out = Writer { text: String::new(), depth: 0, lang };
    out.text.push_str("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    out.within(
        "grammar xmlns=\"http://relaxng.org/ns/structure/1.0\" \
         xmlns:a=\"http://relaxng.org/ns/compatibility/annotations/1.0\" \
         datatypeLibrary=\"http://www.w3.org/2001/XMLSchema-datatypes\"",
        |out| {
            out.within("start", |out| {
                out.within("choice", |out| {
                    for root in ["scene", "views", "view-document"] {
                        out.line(&format!("<ref name=\"{root}\"/>"));
                    }
                });
            });
            for rule in ELEMENTS {
                out.element(rule, rule.name, Form::Usual);
            }
            out.element(&MATERIAL, "own-material", Form::Inline);
            out.element(&VIEW, "view-document", Form::Root);
            out.within("define name=\"reserved\"", |out| {
                out.within("zeroOrMore", |out| {
                    out.within("attribute", |out| {
                        out.line("<nsName ns=\"http://www.w3.org/XML/1998/namespace\"/>");
                    });
                });
            });
        },
    );
    out.text
}

/// Where an element stands, as far as that changes its attributes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Usual,
    /// A material within an object: it has no name.
    Inline,
    /// A view that is the document's root: it has a version.
    Root,
}

struct Writer {
    text: String,
    depth: usize,
    lang: Lang,
}

impl Writer {
    fn line(&mut self, line: &str) {
        // writing to a string cannot fail
        let _ = writeln!(self.text, "{:1$}{line}", "", 2 * self.depth);
    }

    /// An element with content: `tag` is its name with its attributes.
    fn within(&mut self, tag: &str, content: impl FnOnce(&mut Writer)) {
        self.line(&format!("<{tag}>"));
        self.depth += 1;
        content(self);
        self.depth -= 1;
        let name = tag.split_whitespace().next().unwrap_or(tag);
        self.line(&format!("</{name}>"));
    }

    fn document(&mut self, sentence: fn(Lang) -> String) {
        let sentence = sentence(self.lang);
        self.line(&format!("<a:documentation>{}</a:documentation>", escape(&sentence)));
    }

    fn element(&mut self, rule: &'static ElementRule, define: &str, form: Form) {
        self.within(&format!("define name=\"{define}\""), |out| {
            out.within(&format!("element name=\"{}\"", rule.name), |out| {
                out.document(rule.sentence);
                out.line("<ref name=\"reserved\"/>");
                let shared =
                    rule.children.iter().any(|child| child.rule.name == MATERIAL.name) && rule.name != SCENE.name;
                for attribute in rule.attributes {
                    let apart = attribute.kind == Kind::Path
                        || attribute.kind == Kind::MaterialName && shared
                        || form == Form::Inline && attribute.name == "name";
                    if !apart {
                        out.presence(attribute, form);
                    }
                }
                out.content(rule, shared);
            });
        });
    }

    /// An attribute that stands by itself.
    fn presence(&mut self, attribute: &AttributeRule, form: Form) {
        match (attribute.presence, form) {
            (Presence::Required(_), _) | (Presence::AtRoot(_), Form::Root) => self.attribute(attribute),
            (Presence::AtRoot(_), Form::Usual | Form::Inline) => {}
            (Presence::Default(_) | Presence::Automatic | Presence::Optional, _) => {
                self.within("optional", |out| out.attribute(attribute));
            }
        }
    }

    fn attribute(&mut self, attribute: &AttributeRule) {
        self.within(&format!("attribute name=\"{}\"", attribute.name), |out| {
            out.document(attribute.sentence);
            out.value(attribute.kind);
        });
    }

    /// What stands between the tags.
    fn content(&mut self, rule: &'static ElementRule, shared: bool) {
        match rule.text {
            TextRule::Coordinates => return self.pattern(r"[0-9eE+\-.,\s]*"),
            TextRule::Indices => return self.pattern(r"[0-9,\s]*"),
            TextRule::Nothing => {}
        }
        let source = rule.attributes.iter().find(|attribute| attribute.kind == Kind::Path);
        let inline = |child: &&Child| source.is_some() && child.rule.text != TextRule::Nothing;
        if rule.children.is_empty() {
            return self.line("<empty/>");
        }
        self.within("interleave", |out| {
            if let Some(source) = source {
                // the file, or everything that it would hold
                out.within("choice", |out| {
                    out.attribute(source);
                    out.within("interleave", |out| {
                        for child in rule.children.iter().filter(inline) {
                            out.times(
                                if child.rule.name == "normals" { Times::AtMostOnce } else { Times::Once },
                                child.rule.name,
                            );
                        }
                    });
                });
            }
            if shared {
                let material = rule.attributes.iter().find(|attribute| attribute.kind == Kind::MaterialName);
                out.within("choice", |out| {
                    out.line("<empty/>");
                    if let Some(material) = material {
                        out.attribute(material);
                    }
                    out.line("<ref name=\"own-material\"/>");
                });
            }
            for child in rule.children.iter().filter(|child| !inline(child)) {
                if !(shared && child.rule.name == MATERIAL.name) {
                    out.times(child.times, child.rule.name);
                }
            }
        });
    }

    fn times(&mut self, times: Times, name: &str) {
        let reference = format!("<ref name=\"{name}\"/>");
        match times {
            Times::Once => self.line(&reference),
            Times::AtMostOnce => self.within("optional", |out| out.line(&reference)),
            Times::Any => self.within("zeroOrMore", |out| out.line(&reference)),
        }
    }

    /// How a value is written.
    fn value(&mut self, kind: Kind) {
        let numbers = |count: usize| format!("{NUMBER}({PARTED}{NUMBER}){{{}}}", count - 1);
        let blanks = |pattern: String| format!(r"\s*({pattern})\s*");
        match kind {
            Kind::Version => self.pattern(r"\s*1\s*"),
            Kind::Text => self.line("<text/>"),
            Kind::Name | Kind::MaterialName | Kind::Path => self.pattern(r".*\S.*"),
            Kind::Color => {
                self.pattern(&blanks(format!("#[0-9a-fA-F]{{6}}|{NUMBER}|{}", numbers(3))));
            }
            Kind::Channels(..) | Kind::Factors => self.pattern(&blanks(format!("{NUMBER}|{}", numbers(3)))),
            Kind::Point => self.pattern(&blanks(numbers(3))),
            Kind::Length | Kind::Number(..) => self.pattern(&blanks(NUMBER.to_owned())),
            Kind::Size => self.pattern(&blanks(numbers(2))),
            Kind::Corners => self.pattern(&blanks(numbers(12))),
            Kind::Integer(..) => self.pattern(r"\s*\+?[0-9]+\s*"),
            Kind::Run => self.pattern(&blanks(format!("[0-9]+{PARTED}[0-9]+"))),
            Kind::Choice(words) => self.pattern(&blanks(words.join("|"))),
            Kind::Steps => {
                let word = STEPS.join("|");
                self.pattern(&format!(r"\s*(({word})({PARTED}({word}))*)?\s*"));
            }
        }
    }

    fn pattern(&mut self, pattern: &str) {
        self.within("data type=\"string\"", |out| {
            out.line(&format!("<param name=\"pattern\">{}</param>", escape(pattern)));
        });
    }
}
