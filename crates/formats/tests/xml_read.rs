//! The readers of native scenes and views: the model that comes out.

use lancer_formats::mesh::{MeshFile, MeshFiles, MeshProblem};
use lancer_formats::xml::{Document, read_scene, read_views};
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
