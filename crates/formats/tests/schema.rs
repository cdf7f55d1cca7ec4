//! The published schema, checked by a program that others wrote: xmllint.
#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stderr, reason = "a test")]

use lancer_formats::xml::schema;
use lancer_words::Lang;
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

/// The messages that a schema cannot give are about names, geometry or ranges; these it must give.
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
