//! The house rules that a machine can check.

use crate::documents;
use std::fs;
use std::path::{Path, PathBuf};

/// The greatest length of a source file.
const LINES: usize = 600;

/// The crates that each crate may use (ARCHITECTURE.md); cargo refuses cycles, this refuses new arrows.
const ARROWS: [(&str, &[&str]); 8] = [
    ("words", &[]),
    ("scene", &[]),
    ("formats", &["scene", "words"]),
    ("trace", &["scene"]),
    ("render", &["scene", "trace"]),
    ("document", &["words", "scene", "formats", "trace"]),
    ("studio", &["words", "scene", "formats", "trace", "render", "document"]),
    ("cli", &["words", "scene", "formats", "trace", "render"]),
];

/// The only files that may hold `unsafe`.
const UNSAFE: [&str; 4] = [
    "crates/trace/src/bvh/huge.rs",
    "crates/trace/src/engine/dispatch.rs",
    "crates/trace/src/engine/lanes/avx2.rs",
    "crates/trace/src/engine/lanes/avx512.rs",
];

/// Prints every broken rule.
pub(crate) fn report(root: &Path) -> Result<(), String> {
    let broken = broken_rules(root);
    if broken.is_empty() { Ok(()) } else { Err(broken.join("\n")) }
}

fn broken_rules(root: &Path) -> Vec<String> {
    let mut broken = Vec::new();
    for file in sources(root) {
        let name = relative(root, &file);
        let text = read(&file);
        if text.lines().count() > LINES {
            broken.push(format!("{name}: more than {LINES} lines; does it hold one noun or one verb?"));
        }
        if name != "xtask/src/tidy.rs" {
            for mark in ["TODO", "FIXME", "todo!(", "unimplemented!(", "dbg!("] {
                if text.contains(mark) {
                    broken.push(format!("{name}: {mark}"));
                }
            }
            if text.contains("unsafe {") && !UNSAFE.contains(&name.as_str()) {
                broken.push(format!("{name}: unsafe outside of the places for it"));
            }
        }
        if !text.trim_start().starts_with("//!") && !name.contains("/examples/") {
            broken.push(format!("{name}: the first paragraph says why the file exists"));
        }
    }
    for (name, allowed) in ARROWS {
        let manifest = read(&root.join("crates").join(name).join("Cargo.toml"));
        let normal = manifest.split("[dev-dependencies]").next().unwrap_or_default();
        for line in normal.lines().filter(|line| line.starts_with("lancer-")) {
            let used = line.trim_start_matches("lancer-").split(['.', ' ', '=']).next().unwrap_or_default();
            if !allowed.contains(&used) {
                broken.push(format!("crates/{name} must not use {used}"));
            }
        }
    }
    for scene in files(&root.join("scenes"), "xml") {
        let name = relative(root, &scene);
        if name.ends_with(".view.xml") {
            continue;
        }
        if !scene.with_extension("view.xml").exists() {
            broken.push(format!("{name}: has no view beside it"));
        }
        if !read(&scene).contains("<!--") {
            broken.push(format!("{name}: has no sentence of purpose"));
        }
    }
    broken.extend(documents::broken_names(root));
    broken
}

fn sources(root: &Path) -> Vec<PathBuf> {
    [root.join("crates"), root.join("xtask")].iter().flat_map(|folder| files(folder, "rs")).collect()
}

/// The files below a folder with that extension, in the order of their names.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            found.extend(files(&path, extension));
        } else if path.extension().is_some_and(|found| found == extension) {
            found.push(path);
        }
    }
    found
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_default()
}

fn relative(root: &Path, path: &Path) -> String {
    path.strip_prefix(root).unwrap_or(path).to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_house_is_tidy() {
        let broken = broken_rules(crate::root());
        assert!(broken.is_empty(), "{}", broken.join("\n"));
    }

    #[test]
    fn every_crate_has_its_arrows() {
        let mut crates: Vec<String> = fs::read_dir(crate::root().join("crates"))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        crates.sort();
        let mut known: Vec<&str> = ARROWS.iter().map(|(name, _)| *name).collect();
        known.sort_unstable();
        assert_eq!(crates, known);
    }
}
