//! Whether the documents name what exists: their links, the paths in them, and places such as `trace/src/ray.rs::Ray`.

use std::fs;
use std::path::Path;

/// The documents, from the root of the checkout.
const FOLDERS: [&str; 4] = ["", "docs", "scenes", "tests/scenes"];

/// Folders of the checkout: a path in a document that begins with one of them must exist.
const TOP: [&str; 7] = [".ci/", "benches/", "crates/", "docs/", "scenes/", "tests/", "xtask/"];

/// Every name in a document that means nothing.
pub(crate) fn broken_names(root: &Path) -> Vec<String> {
    let mut broken = Vec::new();
    for folder in FOLDERS {
        let path = root.join(folder);
        for (name, text) in documents(&path) {
            let prose = without_blocks(&text);
            let mut complain =
                |what: String| broken.push(format!("{}: {what}", Path::new(folder).join(&name).display()));
            for link in prose.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
                if !link.contains("://") && !leads_somewhere(&path, &name, link) {
                    complain(format!("the link {link} leads nowhere"));
                }
            }
            for span in prose.split('`').skip(1).step_by(2) {
                if !names_something(root, span) {
                    complain(format!("`{span}` does not exist"));
                }
            }
        }
    }
    broken
}

/// The Markdown files right in a folder, by name.
fn documents(folder: &Path) -> Vec<(String, String)> {
    let mut found: Vec<(String, String)> = fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .filter(|entry| entry.path().extension().is_some_and(|extension| extension == "md"))
        .filter_map(|entry| Some((entry.file_name().into_string().ok()?, fs::read_to_string(entry.path()).ok()?)))
        .collect();
    found.sort();
    found
}

/// A document without its fenced blocks: commands, output and diagrams.
fn without_blocks(text: &str) -> String {
    text.split("```").step_by(2).collect()
}

/// Whether a relative link has a file, and the heading in it where one is meant.
fn leads_somewhere(folder: &Path, document: &str, link: &str) -> bool {
    let (file, heading) = link.split_once('#').unwrap_or((link, ""));
    let path = folder.join(if file.is_empty() { document } else { file });
    let headings = || fs::read_to_string(&path).unwrap_or_default();
    path.exists() && (heading.is_empty() || without_blocks(&headings()).lines().any(|line| anchor(line) == heading))
}

/// The anchor that GitHub gives a heading; empty for any other line.
fn anchor(line: &str) -> String {
    let Some(title) = line.trim_start_matches('#').strip_prefix(' ').filter(|_| line.starts_with('#')) else {
        return String::new();
    };
    let kept = |sign: &char| sign.is_alphanumeric() || matches!(sign, ' ' | '-' | '_');
    title.to_lowercase().chars().filter(kept).map(|sign| if sign == ' ' { '-' } else { sign }).collect()
}

/// Whether a run of code is no path of the checkout, or one that exists, with the item that it names.
fn names_something(root: &Path, span: &str) -> bool {
    if let Some((file, item)) = span.split_once(".rs::") {
        let source = fs::read_to_string(root.join("crates").join(format!("{file}.rs"))).unwrap_or_default();
        return ["fn", "struct", "enum"]
            .iter()
            .any(|kind| source.split(&format!("{kind} {item}")).skip(1).any(|rest| !rest.starts_with(is_of_a_name)));
    }
    let is_path = TOP.iter().any(|top| span.starts_with(top)) && !span.contains([' ', '*', '<', '{', '…']);
    !is_path || root.join(span).exists()
}

fn is_of_a_name(sign: char) -> bool {
    sign.is_alphanumeric() || sign == '_'
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_exist_is_seen() {
        let root = crate::root();
        assert!(names_something(root, "Ka·Ia") && names_something(root, "crates/*/tests"));
        assert!(
            names_something(root, "crates/scene/src/color.rs") && !names_something(root, "crates/scene/src/colour.rs")
        );
        assert!(
            names_something(root, "scene/src/color.rs::screen") && !names_something(root, "scene/src/color.rs::scree")
        );
        assert!(leads_somewhere(&root.join("scenes"), "README.md", "../Cargo.toml"));
        assert!(!leads_somewhere(&root.join("scenes"), "README.md", "nothing.md"));
        assert_eq!(anchor("### Cast shadows — *ombres portées* (§1.2)"), "cast-shadows--ombres-portées-12");
        assert_eq!(anchor("no heading"), "");
    }
}
