//! The published schema of the native documents: RELAX NG, made of the vocabulary.
//!
//! It says which elements and attributes there are, which must stand, and how each value is written. What needs more
//! than one value to judge (names that are taken, points on one line) is the readers' matter, but for the ways to give
//! a screen.

mod value;

use super::escape;
use super::read_views::FORMS;
use super::vocabulary::{
    AttributeRule, Child, ELEMENTS, EYE, ElementRule, Kind, MATERIAL, Presence, SCENE, SCREEN, TextRule, Times, VIEW,
};
use lancer_words::Lang;
use std::fmt::Write as _;

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
            out.element(&EYE, LOOKING, Form::Looking);
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
    /// An eye that looks at a point, which gives the screen.
    Looking,
}

/// The name of an eye that looks at a point.
const LOOKING: &str = "looking-eye";

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
                        || form == Form::Inline && attribute.name == "name"
                        || rule.name == SCREEN.name
                        // where the screen is an element, nothing else says what the eye sees
                        || rule.name == EYE.name && form == Form::Usual && attribute.name != "at";
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
            (Presence::Optional, Form::Looking) => self.attribute(attribute),
            (Presence::AtRoot(_), Form::Usual | Form::Inline | Form::Looking) => {}
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
            TextRule::Indices => return self.pattern(r"[0-9+.eE,\s]*"),
            TextRule::Nothing => {}
        }
        if rule.name == SCREEN.name {
            return self.screen();
        } else if rule.name == VIEW.name {
            return self.sight();
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

    /// The attributes of a screen, in one of three ways.
    fn screen(&mut self) {
        self.within("choice", |out| {
            for form in FORMS {
                out.within("group", |out| {
                    let attributes = form.iter().filter_map(|(name, sample)| Some((SCREEN.attribute(name)?, sample)));
                    for (attribute, sample) in attributes {
                        match sample {
                            Some(_) => out.attribute(attribute),
                            None => out.within("optional", |out| out.attribute(attribute)),
                        }
                    }
                });
            }
        });
    }

    /// What a view holds: an eye that looks at a point, or an eye and a screen.
    fn sight(&mut self) {
        self.within("choice", |out| {
            out.times(Times::Once, LOOKING);
            out.within("interleave", |out| {
                out.times(Times::Once, EYE.name);
                out.times(Times::Once, SCREEN.name);
            });
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

    fn pattern(&mut self, pattern: &str) {
        self.within("data type=\"string\"", |out| out.parameter("pattern", pattern));
    }

    /// A limit of a type.
    fn parameter(&mut self, name: &str, value: &str) {
        self.line(&format!("<param name=\"{name}\">{}</param>", escape(value)));
    }
}
