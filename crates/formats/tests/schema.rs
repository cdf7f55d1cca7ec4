//! The published schema, checked by a program that others wrote: xmllint.
#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stderr, reason = "a test")]

#[path = "../../scene/tests/arbitrary/mod.rs"]
mod arbitrary;

use arbitrary::{Extent, scene as any_scene, views as any_views};
use lancer_formats::mesh::{MeshFile, MeshFiles, MeshProblem};
use lancer_formats::xml::{Document, DocumentKind, read_scene, read_views, schema, write_scene, write_views};
use lancer_words::Lang;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn xmllint(schema: &Path, documents: &[PathBuf]) -> Option<Output> {
    Command::new("xmllint").args(["--noout", "--relaxng"]).arg(schema).args(documents).output().ok()
}

/// The native documents below a folder.
fn documents(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut entries: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            found.extend(documents(&path));
        } else if path.extension().is_some_and(|extension| extension == "xml") {
            let text = fs::read(&path).unwrap();
            let text = String::from_utf8_lossy(&text);
            if ["<scene", "<views", "<view"].iter().any(|root| text.contains(root)) {
                found.push(path);
            }
        }
    }
    found
}

fn written(lang: Lang) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("lancer.rng");
    fs::write(&path, schema(lang)).unwrap();
    (folder, path)
}

#[test]
fn xmllint_accepts_every_example() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for lang in Lang::ALL {
        let (_folder, schema) = written(lang);
        let mut all = documents(&root.join("scenes"));
        all.extend(documents(&root.join("tests/scenes")));
        assert!(all.len() > 100, "{}", all.len());
        let Some(output) = xmllint(&schema, &all) else {
            eprintln!("left out: xmllint is not there");
            return;
        };
        let said = String::from_utf8_lossy(&output.stderr);
        let refused: Vec<&str> = said.lines().filter(|line| !line.ends_with(" validates")).take(20).collect();
        assert!(output.status.success(), "{}", refused.join("\n"));
    }
}

/// Whatever scene and views there are, what is written of them is valid: one run of the other program for many of them.
#[test]
fn xmllint_accepts_whatever_is_written() {
    let (folder, schema) = written(Lang::English);
    let mut runner = TestRunner::deterministic();
    let mut paths = Vec::new();
    for number in 0..100 {
        let scene = any_scene(Extent::Whole).new_tree(&mut runner).unwrap().current();
        let views = any_views().new_tree(&mut runner).unwrap().current();
        for (name, text) in [("scene", write_scene(&scene)), ("views", write_views(&views))] {
            paths.push(folder.path().join(format!("{name}{number:02}.xml")));
            fs::write(&paths[paths.len() - 1], text).unwrap();
        }
    }
    let Some(output) = xmllint(&schema, &paths) else {
        eprintln!("left out: xmllint is not there");
        return;
    };
    let said = String::from_utf8_lossy(&output.stderr);
    let refused: Vec<&str> = said.lines().filter(|line| !line.ends_with(" validates")).take(20).collect();
    assert!(output.status.success(), "{}", refused.join("\n"));
}

/// Attributes of an element, legal ones and illegal ones by twos.
const VALUES: &[(&str, &[&str], &[&str])] = &[
    (
        "<world @/>",
        &[
            "ambient='1'",
            "ambient='-0.0'",
            "ambient='0.10 01 1.000'",
            "ambient=' 1e-1 , 0.5\t0 '",
            "ambient='10e-2'",
            "ambient='#09aFff'",
            "depth='0'",
            "depth='64'",
            "depth=' +6.0 '",
            "depth='6e0'",
            "index='0.00001'",
            "index='1e-9'",
            "index='1 1.1 1.2'",
            "compose=' add '",
        ],
        &[
            "ambient='1.01'",
            "ambient='-0.1'",
            "ambient='0.5 2 0.5'",
            "ambient='0,5'",
            "ambient='.5'",
            "ambient='#fff'",
            "ambient='red'",
            "ambient=''",
            "depth='65'",
            "depth='-1'",
            "depth='2.5'",
            "depth='six'",
            "index='0'",
            "index='0.0 1 1'",
            "index='-1'",
            "index='1 1'",
        ],
    ),
    (
        "<material name='a' @/>",
        &["n='0'", "n='10000'", "n='9999.5 0 1'", "ka='1' kd='0' w='grazing' highlight='blinn'"],
        &["n='10001'", "n='-1'", "n='10000.5'", "kt='1.5'", "w='Schlick'", "highlight=''"],
    ),
    (
        "<sphere center='0 0 0' @/>",
        &["radius='0.000000001'", "radius='1e9'", "radius='1000000000'", "radius='1' visible='false'"],
        &["radius='0'", "radius='-1'", "radius='1000000001'", "radius='0.0000000001'", "radius='nan'", "radius='+'"],
    ),
    (
        "<cone base='0 0 0' top='0 1 0' @/>",
        &["base-radius='0' top-radius='0.5'", "base-radius='1' top-radius='0' capped='true'"],
        &["base-radius='-1' top-radius='0.5'", "base-radius='1' top-radius='0' capped='no'"],
    ),
    (
        "<mesh @><vertices>0 0 0 1 0 0 0 1 0</vertices><facets>0 1 2</facets><part facets='0 1'/></mesh>",
        &["scale='-1 1 0.5'", "scale='2' smooth='true'"],
        &["scale='0'", "scale='1 0 1'", "scale='1 2'", "smooth='1'"],
    ),
    (
        "<mesh><vertices>0 0 0 1 0 0 0 1 0</vertices><facets>0 1 2</facets><part @/></mesh>",
        &["facets='0,1'", "facets='0 1' material='a'", "facets='+0.0 1e0'"],
        &["facets='0 0'", "facets='-1 1'", "facets='-0 1'", "facets='0'", ""],
    ),
    (
        "<mesh @><vertices>0 0 0 1 0 0 0 1 0</vertices><facets>0, 1.0 +2  0 1 2e0</facets></mesh>",
        &[""],
        &["src='a.obj'", "visible='\u{A0}true'"],
    ),
    ("<mesh><vertices>0 0 0 1 0 0 0 1 0</vertices><facets>@</facets></mesh>", &["", "0 1 2"], &["0 1 -2", "0 1 x"]),
];

/// A document of one element in a scene that has a material `a`.
fn scene(element: &str, attributes: &str) -> String {
    let material = if element.contains("<material") { "" } else { "<material name='a'/>" };
    format!("<scene version='1'>{material}{}</scene>", element.replace('@', attributes))
}

/// Views, legal ones and illegal ones.
const VIEWS: (&[&str], &[&str]) = (
    &[
        "<view width='1' height='65535' samples='64' depth='0' without='shadows,reflection'><eye at='0 0 5' look-at='0 0 0' fov='179'/></view>",
        "<view><eye at='0 0 5' look-at='0 0 0' up='1 0 0' fov='1.5'/></view>",
        "<view><eye at='0 0 5'/><screen origin='-2 2 0' u='4 0 0' v='0 -3 0'/></view>",
        "<view><screen center='0 0 0' size='4 3' up='0 1 1'/><eye at='0 0 5'/></view>",
        "<view><eye at='0 0 5'/><screen corners='-2 -1 0 2 -1 0 2 1 0 -2 1 0'/></view>",
    ],
    &[
        "<view><eye at='0 0 5'/></view>",
        "<view><eye at='0 0 5' fov='45'/><screen center='0 0 0' size='4 3'/></view>",
        "<view><eye at='0 0 5' look-at='0 0 0'/><screen center='0 0 0' size='4 3'/></view>",
        "<view><eye at='0 0 5'/><screen/></view>",
        "<view><eye at='0 0 5'/><screen origin='-2 2 0' u='4 0 0'/></view>",
        "<view><eye at='0 0 5'/><screen origin='-2 2 0' u='4 0 0' v='0 -3 0' size='4 3'/></view>",
        "<view><eye at='0 0 5'/><screen center='0 0 0' size='4 0'/></view>",
        "<view width='0'><eye at='0 0 5' look-at='0 0 0'/></view>",
        "<view height='65536'><eye at='0 0 5' look-at='0 0 0'/></view>",
        "<view samples='65'><eye at='0 0 5' look-at='0 0 0'/></view>",
        "<view without='shadows,,reflection'><eye at='0 0 5' look-at='0 0 0'/></view>",
        "<view><eye at='0 0 5' look-at='0 0 0' fov='179.5'/></view>",
        "<view><eye at='0 0 5' look-at='0 0 0' fov='0.5'/></view>",
        "<view><eye look-at='0 0 0'/></view>",
    ],
);

/// Reader and schema agree on what is legal wherever one value, or the ways to give a screen, decide.
#[test]
fn the_schema_draws_the_readers_line() {
    let mut documents: Vec<(String, bool)> = Vec::new();
    for (element, legal, illegal) in VALUES {
        documents.extend(legal.iter().map(|attributes| (scene(element, attributes), true)));
        documents.extend(illegal.iter().map(|attributes| (scene(element, attributes), false)));
    }
    let views = |view: &&str| format!("<views version='1'>{view}</views>");
    documents.extend(VIEWS.0.iter().map(|view| (views(view), true)));
    documents.extend(VIEWS.1.iter().map(|view| (views(view), false)));

    let (folder, schema) = written(Lang::French);
    let mut paths = Vec::new();
    for (number, (text, legal)) in documents.iter().enumerate() {
        let document = Document::read("a.xml", text.as_bytes()).unwrap();
        let read = match document.kind() {
            Some(DocumentKind::Views) => read_views(&document).value.is_some(),
            _ => read_scene(&document, &mut NoFiles).value.is_some(),
        };
        assert_eq!(read, *legal, "the reader: {text}");
        paths.push(folder.path().join(format!("{number:03}.xml")));
        fs::write(&paths[number], text).unwrap();
    }
    let Some(output) = xmllint(&schema, &paths) else {
        eprintln!("left out: xmllint is not there");
        return;
    };
    let said = String::from_utf8_lossy(&output.stderr);
    for (path, (text, legal)) in paths.iter().zip(&documents) {
        let verdict = format!("{} {}", path.display(), if *legal { "validates" } else { "fails to validate" });
        assert!(said.lines().any(|line| line == verdict), "xmllint on {text}\n{said}");
    }
}

struct NoFiles;

impl MeshFiles for NoFiles {
    fn read(&mut self, path: &str) -> Result<MeshFile, MeshProblem> {
        panic!("{path} is not to be read")
    }
}

/// The messages that a schema cannot give are about names and geometry; these it must give.
#[test]
fn xmllint_refuses_what_is_clearly_wrong() {
    let (folder, schema) = written(Lang::English);
    for (number, wrong) in [
        r#"<scene/>"#,
        r#"<scene version="1"><spheer center="0 0 0" radius="1"/></scene>"#,
        r#"<scene version="1"><sphere centre="0 0 0" radius="1"/></scene>"#,
        r#"<scene version="1"><sphere radius="1"/></scene>"#,
        r#"<scene version="1"><sphere center="0 0" radius="1"/></scene>"#,
        r#"<scene version="1"><sphere center="0 0 0" radius="inf"/></scene>"#,
        r#"<scene version="1"><sphere center="0 0 0" radius="1 2"/></scene>"#,
        r#"<scene version="1"><world compose="multiply"/></scene>"#,
        r#"<scene version="1"><world/><world/></scene>"#,
        r#"<scene version="1"><world ambient="0.1 0.2"/></scene>"#,
        r#"<scene version="1"><material ka="0"/></scene>"#,
        r#"<scene version="1"><sphere center="0 0 0" radius="1" material="a"><material/></sphere></scene>"#,
        r#"<scene version="1"><mesh src="a.obj"><vertices>0 0 0</vertices><facets>0 0 0</facets></mesh></scene>"#,
        r#"<scene version="1"><mesh><facets>0 1 2</facets></mesh></scene>"#,
        r#"<scene version="1">text</scene>"#,
        r#"<views version="1"><view version="1"><eye at="0 0 1"/></view></views>"#,
        r#"<views version="1"><view><screen/></view></views>"#,
        r#"<view version="1" without="light"><eye at="0 0 1" look-at="0 0 0"/></view>"#,
    ]
    .into_iter()
    .enumerate()
    {
        let path = folder.path().join(format!("{number}.xml"));
        fs::write(&path, wrong).unwrap();
        let Some(output) = xmllint(&schema, &[path]) else {
            eprintln!("left out: xmllint is not there");
            return;
        };
        assert_eq!(output.status.code(), Some(3), "accepted: {wrong}\n{}", String::from_utf8_lossy(&output.stderr));
    }
}
