//! `lancer generate`: scenes with their views, in every format, that the program itself can read.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::{listing, run};
use lancer_formats::load::{LoadOptions, load_scene, load_views};
use lancer_scene::generate::Family;
use tempfile::TempDir;

#[test]
fn a_scene_and_its_view_are_written_side_by_side() {
    let folder = TempDir::new().unwrap();
    let path = folder.path();
    let told = "sponge.xml, and its view in sponge.view.xml\n".to_owned();
    assert_eq!(run(path, &["generate", "sponge", "--size", "1"]), (0, told, String::new()));
    let told = "my.lancer, et sa vue dans my.view.xml\n".to_owned();
    let args = ["generate", "sponge", "my.lancer", "--size", "1", "--lang", "fr"];
    assert_eq!(run(path, &args), (0, told, String::new()));
    assert_eq!(listing(path), ["my.lancer", "my.view.xml", "sponge.view.xml", "sponge.xml"]);
    let (scene, view) = Family::Sponge.generate(1).unwrap();
    for name in ["sponge.xml", "my.lancer"] {
        let read = load_scene(&path.join(name), &LoadOptions::default()).unwrap().value.unwrap();
        assert_eq!(read, scene, "{name}");
    }
    let views = load_views(&path.join("sponge.view.xml"), &LoadOptions::default()).unwrap().value.unwrap();
    assert_eq!(**views.first().unwrap(), view);
    assert_eq!(run(path, &["sponge.xml", "sponge.view.xml", "-", "--size", "20x15"]).0, 0);
    // nothing is said, and standard output gets the scene alone
    let (code, told, said) = run(path, &["generate", "sponge", "-", "--size", "1"]);
    assert!(code == 0 && told.contains("<scene") && said.is_empty(), "{said}");
    assert_eq!(run(path, &["generate", "nest", "--quiet"]), (0, String::new(), String::new()));
}

#[test]
fn every_family_is_in_the_help_with_its_sizes_and_can_be_written() {
    let folder = TempDir::new().unwrap();
    for lang in ["en", "fr"] {
        let (_, help, _) = run(folder.path(), &["generate", "--help", "--lang", lang]);
        for family in Family::ALL {
            let (sizes, usual) = (family.sizes(), family.usual_size().to_string());
            let line = help.lines().find(|line| line.trim_start().starts_with(family.word())).unwrap();
            let words: Vec<&str> = line.split_whitespace().collect();
            assert_eq!(words[1], format!("{}..{}", sizes.start(), sizes.end()), "{line}");
            assert_eq!(words[2], usual, "{line}");
        }
    }
    for family in Family::ALL {
        let (size, file) = (family.sizes().start().to_string(), format!("{}.xml", family.word()));
        assert_eq!(run(folder.path(), &["generate", family.word(), &file, "--size", &size]).0, 0, "{family:?}");
    }
}

#[test]
fn other_programs_get_theirs() {
    let folder = TempDir::new().unwrap();
    for file in ["knot.pov", "knot.obj", "knot.glb"] {
        let (code, told, said) = run(folder.path(), &["generate", "knot", file, "--size", "3"]);
        assert_eq!((code, told.as_str()), (0, ""), "{said}");
        assert!(said.contains(file), "what is lost is told: {said}");
    }
    assert_eq!(listing(folder.path()), ["knot.glb", "knot.mtl", "knot.obj", "knot.pov"]);
}

#[test]
fn wrong_names_sizes_and_places_are_refused_and_nothing_is_written() {
    let folder = TempDir::new().unwrap();
    let refused = |args: &[&str], code: i32, text: &str| {
        let (found, told, said) = run(folder.path(), &[&["generate"], args].concat());
        assert!(found == code && told.is_empty() && said.contains(text), "{args:?}: {found} {said}");
        assert!(listing(folder.path()).is_empty());
    };
    refused(&["teapot"], 2, "teapot");
    refused(&["sponge", "--size", "5"], 2, "the size of sponge is a whole number from 0 to 4");
    refused(&["sponge", "sponge.png"], 2, "`sponge.png` does not say which format to write");
    refused(&["sponge", "no/sponge.xml"], 3, "there is no folder `no`");
    refused(&["sponge", "no.obj/-"], 2, "does not say");
}
