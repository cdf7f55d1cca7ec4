//! What lint found, in words: every finding in both languages, whole; and what it finds in the project's own scenes.

#![allow(clippy::unwrap_used, reason = "the helpers of tests may panic")]

use lancer_formats::Describe;
use lancer_formats::load::{LoadOptions, load_scene, load_views};
use lancer_scene::{Bounce, Finding, Name, Owner, Weight, lint};
use lancer_words::Lang;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn name(name: &str) -> Name {
    name.into()
}

/// One of each, and those that are told differently.
fn findings() -> Vec<Finding> {
    let (lamp, object, plane, view) = (name("lamp"), name("ball"), name("floor"), name("front"));
    let depth = |view, bounce| Finding::DepthTooSmall { view, depth: 1, enough: 2, object: object.clone(), bounce };
    let mirrors =
        |view| Finding::FacingMirrors { view, depth: 6, enough: 29, first: name("left"), second: name("right") };
    let hidden = |count| Finding::HiddenBehindPlane { plane: plane.clone(), object: object.clone(), count };
    vec![
        Finding::NoLamp { hidden: 0 },
        Finding::NoLamp { hidden: 2 },
        Finding::NoObject { hidden: 0 },
        Finding::NoObject { hidden: 1 },
        Finding::DarkLamp { lamp: lamp.clone() },
        Finding::LampInside { lamp: lamp.clone(), object: object.clone() },
        Finding::LampBehindPlane { lamp, plane: plane.clone() },
        Finding::EyeInside { view: view.clone(), object: object.clone() },
        Finding::EyeInGlass { view: view.clone(), object: object.clone() },
        Finding::EyeBehindGlassPlane { view: view.clone(), plane: plane.clone() },
        Finding::EyeBehindPlane { view: view.clone(), plane: plane.clone() },
        Finding::PlaneThroughEye { view: view.clone(), plane: plane.clone() },
        Finding::MirroredView { view: view.clone() },
        Finding::PixelsNotSquare { view: view.clone(), ratio: 4.0 / 3.0 },
        Finding::PixelsNotSquare { view: view.clone(), ratio: 0.5 },
        depth(None, Bounce::Reflection),
        depth(Some(view.clone()), Bounce::Transparency),
        mirrors(None),
        mirrors(Some(view)),
        hidden(1),
        hidden(3),
        Finding::CoincidentFaces { first: plane, second: object.clone() },
        Finding::OpenGlass { object: object.clone() },
        Finding::SheetGlass { object: object.clone() },
        Finding::EmptyMesh { object: object.clone() },
        Finding::UnusedMaterial { material: name("red") },
        Finding::WorldIndexBelowOne { index: 0.5 },
        Finding::IndexBelowOne { owner: Owner::Material(name("red")), index: 0.75 },
        Finding::IndexBelowOne { owner: Owner::Object(object.clone()), index: 0.75 },
        Finding::AlwaysWhite { owner: Owner::Material(name("red")) },
        Finding::AlwaysWhite { owner: Owner::Object(object) },
    ]
}

/// Compared with `tests/lint/*.txt`; `UPDATE_REFS=1` rewrites them.
#[test]
fn every_finding_is_told_in_both_languages() {
    for lang in Lang::ALL {
        let told: String = findings()
            .iter()
            .map(|finding| {
                let help = finding.help(lang).unwrap();
                assert_eq!(finding.label(lang), "");
                format!("{} ({:?})\n  {}\n  {help}\n", finding.code(), finding.weight(), finding.message(lang))
            })
            .collect();
        let path = format!("{}/tests/lint/findings.{}.txt", env!("CARGO_MANIFEST_DIR"), lang.code());
        if std::env::var_os("UPDATE_REFS").is_some() {
            std::fs::write(&path, &told).unwrap();
        }
        assert_eq!(told, std::fs::read_to_string(&path).unwrap(), "{path}");
    }
}

#[test]
fn every_finding_has_a_code_of_its_own_and_names_what_it_is_about() {
    let codes: BTreeSet<&str> = findings().iter().map(|finding| finding.code()).collect();
    assert_eq!(codes.len(), 22);
    for finding in findings() {
        assert!(finding.code().starts_with("lint::"));
        for lang in Lang::ALL {
            let message = finding.message(lang);
            for (_, name) in finding.names() {
                assert!(message.contains(&**name), "{message} does not name {name}");
            }
        }
    }
}

/// The documents of `scenes/`, without those of views.
fn scenes() -> Vec<PathBuf> {
    let folders = std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")).unwrap();
    let files = folders.flat_map(|folder| std::fs::read_dir(folder.unwrap().path()).into_iter().flatten());
    let mut scenes: Vec<PathBuf> = files
        .map(|file| file.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "xml"))
        .filter(|path| !path.to_string_lossy().ends_with(".view.xml"))
        .collect();
    scenes.sort();
    scenes
}

/// No false alarms: of all the scenes that the project shows, lint warns only of what they are there to show.
#[test]
fn the_scenes_of_the_project_are_sound() {
    let meant = ["depth.xml: view `depth 0`: with depth 0 the mirror `far mirror` reflects nothing"];
    let mut warned = Vec::new();
    let scenes = scenes();
    assert!(scenes.len() >= 12, "only {} scenes", scenes.len());
    for path in scenes {
        let loaded = load_scene(&path, &LoadOptions::default()).unwrap();
        assert_eq!(loaded.diagnostics, [], "{}", path.display());
        let scene = loaded.value.unwrap();
        let views = load_views(&path.with_extension("view.xml"), &LoadOptions::default());
        let views = views.ok().and_then(|views| views.value).unwrap_or_default();
        // Not to know the eyes must not make it say more.
        let blind: Vec<Finding> = lint(&scene, &[]);
        let findings = lint(&scene, &views);
        assert!(
            blind.iter().all(|finding| finding.weight() == Weight::Note || findings.contains(finding)),
            "{}: {blind:?}",
            path.display()
        );
        for finding in findings.iter().filter(|finding| finding.weight() == Weight::Warning) {
            let name = path.file_name().unwrap().to_string_lossy();
            warned.push(format!("{name}: {}", finding.message(Lang::English)));
        }
    }
    assert_eq!(warned, meant);
}
