//! The readers of native scenes and views: the model that comes out.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test")]

use lancer_formats::mesh::{MeshFile, MeshFiles, MeshProblem};
use lancer_formats::xml::{Document, read_scene, read_views};
use lancer_formats::{Describe, Diagnostic, Severity};
use proptest::prelude::*;
use std::path::PathBuf;

/// Mesh files are no matter of these tests.
struct NoFiles;

impl MeshFiles for NoFiles {
    fn read(&mut self, _path: &str) -> Result<MeshFile, MeshProblem> {
        Ok(MeshFile::new(Default::default(), Vec::new()))
    }
}

fn examples() -> Vec<PathBuf> {
    let scenes = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes"));
    let mut found = Vec::new();
    for folder in std::fs::read_dir(scenes).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_dir()) {
        found.extend(std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()));
    }
    found.retain(|path| path.extension().is_some_and(|extension| extension == "xml"));
    found.sort();
    found
}

#[test]
fn every_example_is_read() {
    let examples = examples();
    assert!(examples.len() > 20);
    for path in examples {
        let bytes = std::fs::read(&path).unwrap();
        let document = Document::read(path.display().to_string(), &bytes).unwrap();
        assert_eq!(document.to_bytes(), bytes);
        if path.to_string_lossy().ends_with(".view.xml") {
            let outcome = read_views(&document);
            assert_eq!(outcome.diagnostics, [], "{}", path.display());
            assert!(!outcome.value.unwrap().is_empty());
        } else {
            let outcome = read_scene(&document, &mut NoFiles);
            assert_eq!(outcome.diagnostics, [], "{}", path.display());
            assert_eq!(outcome.value.unwrap().check(), Ok(()));
        }
    }
}

const SCENE: &str = r##"<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE scene SYSTEM "scene.dtd">
<scene version="1" name="A &lt;ball&gt; &#233;" xml:lang="en" xmlns:x="http://example.org/">
  <world ambient="0.1 0.2 0.3" background="#336699" index="1" depth="3" compose="screen-each"/>
  <material name="été" ka="0.4" n="20 20 40" w="schlick" highlight="blinn"/>
  <light name="lamp" position="-2, 3 ,2" color="1 1 0.9" visible="true"/>
  <sphere center="0 0 0" radius="1" material="été"/>
  <cube center="0 0 0" edge="1" rotation="0 30 0"><material kt="1"/></cube>
  <mesh scale="-1 2 1" smooth="true">
    <vertices>0 0 0 <!-- one --> 1 0 0 <![CDATA[0 1 0]]> 0 0 1</vertices>
    <facets>0 1 2  0 3 1</facets>
    <part material="été" facets="1 1"/>
  </mesh>
</scene>
"##;

const VIEWS: &str = r#"<views version="1">
  <view name="front" width="64" height="48" samples="2" depth="3" without="shadows, reflection">
    <eye at="0 1 5"/><screen origin="-1 1.75 3.5" u="2 0 0" v="0 -1.5 0"/>
  </view>
  <view><eye at="3 2 5" look-at="0 0.5 0" up="0 1 0" fov="45"/></view>
  <view><eye at="3 2 5"/><screen center="0 0 0" size="4 3"/></view>
  <view><eye at="0 0 5"/><screen corners="-2 -1 0  2 -1 0  2 1 0  -2 1 0"/></view>
</views>
"#;

/// Small changes of a text: characters and pieces that mean something put in, taken out, or doubled.
fn mutants(text: &'static str) -> impl Strategy<Value = String> {
    const PIECES: [&str; 22] = [
        "\"",
        "'",
        "<",
        ">",
        "/",
        "=",
        " ",
        "0",
        "-",
        ",",
        "e",
        "x",
        "1e9",
        "nan",
        "&amp;",
        "&#10;",
        "é",
        "<material/>",
        "<world/>",
        "<!-- -->",
        "material=\"a\" ",
        "\u{FFFF}",
    ];
    let change = (0..text.len(), 0..6_usize, prop::sample::select(&PIECES[..]));
    prop::collection::vec(change, 1..5).prop_map(move |changes| {
        let mut text = text.to_owned();
        for (at, remove, piece) in changes {
            let start = text.floor_char_boundary(at.min(text.len()));
            let end = text.floor_char_boundary((start + remove).min(text.len()));
            text.replace_range(start..end, piece);
        }
        text
    })
}

/// What every reader promises: no panic, a value or an error, places within the text, and a value that is legal.
fn check_promises(bytes: &[u8]) -> Result<(), TestCaseError> {
    let document = match Document::read("a.xml", bytes) {
        Ok(document) => document,
        Err(malformed) => {
            let span = malformed.diagnostic.span.unwrap_or_default();
            prop_assert!(span.start <= span.end && span.end <= malformed.source.text.len());
            return Ok(());
        }
    };
    let (scene, views) = (read_scene(&document, &mut NoFiles), read_views(&document));
    let errors = |diagnostics: &[Diagnostic]| diagnostics.iter().any(|found| found.severity == Severity::Error);
    for diagnostics in [&scene.diagnostics, &views.diagnostics] {
        prop_assert!(diagnostics.is_sorted_by_key(|found| found.span.map_or(usize::MAX, |span| span.start)));
        for found in diagnostics {
            let span = found.span.unwrap_or_default();
            prop_assert!(span.start <= span.end && document.text().get(span.start..span.end).is_some(), "{found:?}");
        }
    }
    prop_assert_eq!(scene.value.is_none(), errors(&scene.diagnostics));
    prop_assert_eq!(views.value.is_none(), errors(&views.diagnostics));
    if let Some(scene) = scene.value {
        prop_assert_eq!(scene.check(), Ok(()));
    }
    for view in views.value.unwrap_or_default().iter() {
        prop_assert_eq!(view.check(), Ok(()));
    }
    Ok(())
}

#[test]
fn the_samples_are_legal() {
    let scene = Document::read("a.xml", SCENE.as_bytes()).unwrap();
    assert_eq!(read_scene(&scene, &mut NoFiles).diagnostics, []);
    let views = Document::read("a.xml", VIEWS.as_bytes()).unwrap();
    assert_eq!(read_views(&views).diagnostics, []);
}

/// A file that is cut anywhere gives a message, and nothing worse.
#[test]
fn every_truncation_is_told() {
    for text in [SCENE, VIEWS] {
        for end in 0..text.trim_end().len() {
            let Err(malformed) = Document::read("a.xml", &text.as_bytes()[..end]) else {
                panic!("cut at {end}: {}", &text[..end])
            };
            assert_eq!(malformed.diagnostic.severity, Severity::Error);
        }
    }
}

/// The automatic names are the first free numbers once every name that stands is known.
#[test]
fn automatic_names_avoid_all_others() {
    let text = "<scene version='1'><sphere center='0 0 0' radius='1'/><cube name='sphere 1' center='0 0 0' edge='1'/>
        <sphere center='0 0 0' radius='1'/><light position='0 0 0' name=' sphere 3 '/><light position='0 0 0'/></scene>";
    let document = Document::read("a.xml", text.as_bytes()).unwrap();
    let scene = read_scene(&document, &mut NoFiles).value.unwrap();
    let names: Vec<_> = scene.objects.iter().map(|object| &*object.name).collect();
    assert_eq!(names, ["sphere 2", "sphere 1", "sphere 4"]);
    let names: Vec<_> = scene.lights.iter().map(|light| &*light.name).collect();
    assert_eq!(names, ["sphere 3", "light 1"]);
}

/// Every error of a document is told at once, in the order of the text.
#[test]
fn all_errors_are_told() {
    let text =
        "<scene version='1'>\n".to_owned() + &"<sphere center='0 0' radius='-1' colour='1'/>\n".repeat(50) + "</scene>";
    let document = Document::read("a.xml", text.as_bytes()).unwrap();
    let outcome = read_scene(&document, &mut NoFiles);
    assert_eq!(outcome.diagnostics.len(), 150);
    let codes: Vec<_> = outcome.diagnostics.iter().map(|found| found.problem.code()).collect();
    assert_eq!(codes[..3], ["xml::number-count", "rule::not-positive", "xml::unknown-attribute"]);
}

/// A hostile document of nothing but errors costs neither much memory nor much time.
#[test]
fn errors_are_bounded() {
    let mut text = "<scene version='1'>".to_owned();
    for number in 0..30_000 {
        text += &format!("<sphere center='0 0 0' radius='1' material='m{number}'/>");
    }
    text += "</scene>";
    let document = Document::read("a.xml", text.as_bytes()).unwrap();
    let outcome = read_scene(&document, &mut NoFiles);
    assert!(outcome.value.is_none());
    assert_eq!(outcome.diagnostics.len(), 10_001);
    assert_eq!(outcome.diagnostics.last().unwrap().problem.code(), "xml::too-many");
}

/// Nor does one that invites comparisons of everything with everything: with them, this test would take many minutes.
#[test]
fn no_document_takes_quadratic_time() {
    let objects = "<sphere center='0 0 0' radius='1'/>".repeat(50_000);
    let worlds = "<world/>".repeat(50_000);
    let unknown: String = (0..50_000).map(|number| format!("<sphere{number} radiu{number}='1'/>")).collect();
    let attributes: String = (0..50_000).map(|number| format!(" radiu{number}='1'")).collect();
    let materials: String = (0..5_000).map(|number| format!("<material name='mat{number}'/>")).collect();
    let used: String =
        (0..5_000).map(|number| format!("<sphere center='0 0 0' radius='1' material='mat {number}'/>")).collect();
    for body in [objects + &worlds, unknown, format!("<sphere{attributes}/>"), materials + &used] {
        let document = Document::read("a.xml", format!("<scene version='1'>{body}</scene>").as_bytes()).unwrap();
        assert!(read_scene(&document, &mut NoFiles).value.is_none());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_mutated_scene_keeps_the_promises(text in mutants(SCENE)) {
        check_promises(text.as_bytes())?;
    }

    #[test]
    fn mutated_views_keep_the_promises(text in mutants(VIEWS)) {
        check_promises(text.as_bytes())?;
    }

    #[test]
    fn flipped_bytes_keep_the_promises(at in any::<prop::sample::Index>(), byte in any::<u8>()) {
        let mut bytes = SCENE.as_bytes().to_vec();
        let at = at.index(bytes.len());
        bytes[at] = byte;
        check_promises(&bytes)?;
    }
}
