//! The manual of the documents says what the program does: its tables are the vocabulary's, its examples are legal.
//!
//! `UPDATE_REFS=1` rewrites the tables.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use lancer_formats::mesh::{MeshFile, MeshFiles, MeshProblem};
use lancer_formats::xml::vocabulary::{
    AttributeRule, ELEMENTS, ElementRule, Kind, Presence, SCENE, STEPS, TextRule, Times,
};
use lancer_formats::xml::{Document, DocumentKind, read_scene, read_views};
use lancer_scene::limits;
use lancer_words::Lang;
use std::path::PathBuf;

fn manual() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/scene-format.md"))
}

#[test]
fn the_tables_are_those_of_the_vocabulary() {
    let text = std::fs::read_to_string(manual()).unwrap();
    let views = ELEMENTS.iter().position(|element| element.name == "views").unwrap();
    let (scene, views) = ELEMENTS.split_at(views);
    let updated = replaced(&replaced(&text, "scene", &tables(scene)), "views", &tables(views));
    if std::env::var_os("UPDATE_REFS").is_some() {
        std::fs::write(manual(), &updated).unwrap();
    } else {
        assert!(
            text == updated,
            "docs/scene-format.md is not up to date: UPDATE_REFS=1 cargo test -p lancer-formats --test manual"
        );
    }
}

/// The text with what stands between the marks of a table replaced.
fn replaced(text: &str, name: &str, table: &str) -> String {
    let (begin, end) = (format!("<!-- {name}: from the vocabulary -->\n"), format!("<!-- end of {name} -->"));
    let (before, rest) = text.split_once(&begin).unwrap();
    let (_, after) = rest.split_once(&end).unwrap();
    format!("{before}{begin}{table}\n{end}{after}")
}

fn tables(elements: &[&'static ElementRule]) -> String {
    elements.iter().map(|element| table(element)).collect()
}

fn table(element: &'static ElementRule) -> String {
    let mut text = format!("\n#### `{}`\n\n{}. {}\n", element.name, (element.sentence)(Lang::English), place(element));
    if !element.attributes.is_empty() {
        text += "\n| attribute | in the subject | | value | without it |\n|---|---|---|---|---|\n";
        for attribute in element.attributes {
            let AttributeRule { name, term, sentence, .. } = attribute;
            let term = if term.is_empty() { String::new() } else { format!("`{term}`") };
            let [value, without] = [value(attribute.kind), without(attribute.presence)];
            text += &format!("| `{name}` | {term} | {} | {value} | {without} |\n", sentence(Lang::English));
        }
    }
    match element.text {
        TextRule::Nothing => {}
        TextRule::Coordinates => text += "\nIts text is coordinates, three each.\n",
        TextRule::Indices => text += "\nIts text is vertex numbers, three each.\n",
    }
    text
}

/// Where an element stands, and how often.
fn place(element: &ElementRule) -> String {
    let times = |parent: &ElementRule| {
        parent.children.iter().find(|child| child.rule.name == element.name).map(|child| match child.times {
            Times::Once => "once",
            Times::AtMostOnce => "at most once",
            Times::Any => "any number of times",
        })
    };
    let mut places: Vec<(&str, Vec<String>)> = Vec::new();
    for (parent, times) in ELEMENTS.iter().filter_map(|parent| Some((format!("`{}`", parent.name), times(parent)?))) {
        match places.iter_mut().find(|(known, _)| *known == times) {
            Some((_, parents)) => parents.push(parent),
            None => places.push((times, vec![parent])),
        }
    }
    if places.is_empty() {
        return "It is the root of its document.".to_owned();
    }
    let places: Vec<String> =
        places.iter().map(|(times, parents)| format!("{times} in {}", parents.join(", "))).collect();
    format!("It stands {}.", places.join("; "))
}

fn value(kind: Kind) -> String {
    match kind {
        Kind::Version => "1".to_owned(),
        Kind::Text => "text".to_owned(),
        Kind::Name => "a name".to_owned(),
        Kind::MaterialName => "the name of a material".to_owned(),
        Kind::Path => "a path".to_owned(),
        Kind::Color => "a colour, 0 to 1".to_owned(),
        Kind::Channels(min, max) => format!("1 or 3 numbers, {}", range(min, max)),
        Kind::Point => "3 numbers".to_owned(),
        Kind::Factors => "1 or 3 numbers, not 0".to_owned(),
        Kind::Length => "a number greater than 0".to_owned(),
        Kind::Number(min, max) => format!("a number, {}", range(min, max)),
        Kind::Integer(min, max) => format!("a whole number, {min} to {max}"),
        Kind::Size => "2 numbers greater than 0".to_owned(),
        Kind::Corners => "12 numbers".to_owned(),
        Kind::Choice(words) => one_of(words),
        Kind::Steps => format!("any of {}", one_of(STEPS)),
        Kind::Run => "2 whole numbers".to_owned(),
    }
}

fn range(min: f64, max: f64) -> String {
    if (min, max) == (limits::LEAST, limits::COORDINATE) {
        "greater than 0".to_owned()
    } else {
        format!("{min} to {max}")
    }
}

fn one_of(words: &[&str]) -> String {
    words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
}

fn without(presence: Presence) -> String {
    match presence {
        Presence::Required(_) => "*required*".to_owned(),
        Presence::Default("") => "none".to_owned(),
        Presence::Default(value) => format!("`{value}`"),
        Presence::Automatic => "a free name".to_owned(),
        Presence::Optional => String::new(),
        Presence::AtRoot(_) => "*required* of a root, illegal elsewhere".to_owned(),
    }
}

/// No example names a mesh file.
struct NoFiles;

impl MeshFiles for NoFiles {
    fn read(&mut self, path: &str) -> Result<MeshFile, MeshProblem> {
        panic!("an example names {path}")
    }
}

#[test]
fn the_examples_are_legal() {
    let text = std::fs::read_to_string(manual()).unwrap();
    let examples: Vec<&str> = text.split("```xml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert!(examples.len() >= 3, "the manual has examples");
    for example in examples {
        let document = Document::read("example.xml", example.as_bytes()).unwrap();
        let diagnostics = match document.kind() {
            Some(DocumentKind::Scene) => read_scene(&document, &mut NoFiles).diagnostics,
            Some(DocumentKind::Views) => read_views(&document).diagnostics,
            other => panic!("{other:?}: {example}"),
        };
        assert_eq!(diagnostics, [], "{example}");
    }
}

#[test]
fn one_example_has_every_element_of_a_scene() {
    let text = std::fs::read_to_string(manual()).unwrap();
    let example = text.split("```xml\n").nth(2).unwrap().split("```").next().unwrap();
    for element in SCENE.children {
        assert!(example.contains(&format!("<{} ", element.rule.name)), "{}", element.rule.name);
    }
}
