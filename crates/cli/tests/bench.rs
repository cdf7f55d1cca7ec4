//! `lancer bench`: that it measures what it says, in the form that is documented, and exports what other programs need.
//! Nothing here depends on how long anything takes.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::{listing, run};
use lancer_formats::load::{LoadOptions, load_scene, load_views};
use lancer_scene::generate::Family;
use lancer_scene::{Compose, Environment, Scene};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The paths of a JSON value's leaves: `scenes[].frame.rays`.
fn leaves(value: &Value, path: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Array(items) => items.iter().for_each(|item| leaves(item, &format!("{path}[]"), found)),
        Value::Object(members) => members.iter().for_each(|(name, member)| {
            let dot = if path.is_empty() { "" } else { "." };
            leaves(member, &format!("{path}{dot}{name}"), found);
        }),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {
            found.insert(path.to_owned());
        }
    }
}

#[test]
fn the_figures_are_told_as_json_with_the_documented_members() {
    let folder = tempfile::tempdir().unwrap();
    let asked = ["bench", "course", "field:5", "--size", "40x30", "--repeat", "2", "--threads", "2", "--json", "-q"];
    let (code, told, said) = run(folder.path(), &asked);
    assert_eq!((code, said.as_str()), (0, ""));
    let report: Value = serde_json::from_str(&told).unwrap();
    let mut found = BTreeSet::new();
    leaves(&report, "", &mut found);

    let document = fs::read_to_string(Path::new(ROOT).join("docs/performance.md")).unwrap();
    let section = document.split("### The members of `--json`").nth(1).unwrap().split("\n#").next().unwrap();
    let documented: BTreeSet<String> = section
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split('`').next().map(str::to_owned))
        // processor time is told by Linux
        .filter(|member| cfg!(target_os = "linux") || !member.ends_with(".processor"))
        .collect();
    assert_eq!(found, documented);

    assert_eq!(report["version"], 1);
    assert_eq!(report["program"], env!("CARGO_PKG_VERSION"));
    assert_eq!((&report["width"], &report["height"]), (&40.into(), &30.into()));
    assert_eq!((&report["threads"], &report["repeat"]), (&2.into(), &2.into()));
    let scenes = report["scenes"].as_array().unwrap();
    assert_eq!(scenes.len(), 2);
    assert_eq!((&scenes[0]["name"], &scenes[1]["name"]), (&"course:1".into(), &"field:5".into()));
    // a plane, three spheres and two cubes of twelve facets; 2·5² facets
    assert_eq!((&scenes[0]["primitives"], &scenes[1]["primitives"]), (&28.into(), &50.into()));
    for scene in scenes {
        let count = |set: &str, what: &str| scene[set][what].as_u64().unwrap();
        assert_eq!(count("primary", "rays"), 40 * 30);
        assert_eq!(count("reflected", "rays"), count("primary", "hits"));
        assert_eq!(count("diffuse", "rays"), count("primary", "hits"));
        assert!(count("shadow", "rays") <= count("primary", "hits"));
        for set in ["primary", "shadow", "reflected", "diffuse"] {
            assert!(count(set, "hits") <= count(set, "rays"));
            assert!(scene[set]["seconds"].as_f64().unwrap() > 0.0);
        }
        assert!(count("frame", "rays") > 40 * 30);
        assert!(scene["build"]["seconds"].as_f64().unwrap() > 0.0 && scene["bytes"].as_u64().unwrap() > 0);
    }
}

#[test]
fn one_table_in_either_language() {
    let folder = tempfile::tempdir().unwrap();
    for (lang, title, heads) in [
        (
            "en",
            "reference tracer; 16×12, 1 thread, median of 1",
            "scene primitives ms M/s B each primary shadow reflected diffuse ms M rays/s",
        ),
        (
            "fr",
            "traceur de référence ; 16×12, 1 fil d'exécution, médiane de 1",
            "scène primitives ms M/s o/prim. primaires d'ombre réfléchis diffus ms M rayons/s",
        ),
    ] {
        let asked = ["bench", "nest:1", "knot:3", "--size", "16x12", "--repeat", "1", "--threads", "1", "--lang", lang];
        let (code, told, _) = run(folder.path(), &asked);
        assert_eq!(code, 0);
        let lines: Vec<&str> = told.lines().collect();
        assert_eq!(lines.len(), 6, "{told}");
        assert_eq!((lines[0], lines[1]), (format!("lancer {}, {title}", env!("CARGO_PKG_VERSION")).as_str(), ""));
        assert_eq!(lines[3].split_whitespace().collect::<Vec<_>>().join(" "), heads);
        assert!(lines[4].starts_with("nest:1 ") && lines[5].starts_with("knot:3 "), "{told}");
        // every figure stands under its head
        let ends = |line: &str| line.chars().count();
        assert!(lines[3..].iter().all(|line| ends(line) == ends(lines[3])), "{told}");
        assert_eq!(lines[4].split_whitespace().count(), 11, "{told}");
    }
}

#[test]
fn what_is_no_scene_is_wrong_use() {
    let folder = tempfile::tempdir().unwrap();
    for (asked, said) in [
        (["bench", "teapot"].as_slice(), "the scenes are course, sphereflake, tetrahedron"),
        (&["bench", "knot:501"], "the size of knot is a whole number from 3 to 500"),
        (&["bench", "--size", "4000x4000"], "at most 8388608 pixels"),
        (&["bench", "--export", "x", "--json"], "cannot be used with"),
    ] {
        let (code, told, complaint) = run(folder.path(), asked);
        assert_eq!((code, told.as_str()), (2, ""), "{asked:?}");
        assert!(complaint.contains(said), "{complaint}");
    }
    let (code, _, complaint) = run(folder.path(), &["bench", "course", "--export", "nowhere"]);
    assert_eq!(code, 3);
    assert!(complaint.contains("nowhere"), "{complaint}");
}

/// The course scene that is generated is the one of the examples.
#[test]
fn the_course_scene_is_that_of_the_examples() {
    let folder = Path::new(ROOT).join("scenes/course");
    let options = LoadOptions::default();
    let scene = load_scene(&folder.join("course.xml"), &options).unwrap().value.unwrap();
    let views = load_views(&folder.join("course.view.xml"), &options).unwrap().value.unwrap();
    let (generated, view) = Family::Course.generate(1).unwrap();
    assert_eq!(generated, scene);
    assert_eq!((view.eye, &view.screen, &view.name), (views[0].eye, &views[0].screen, &views[0].name));
}

#[test]
fn scenes_and_rays_are_exported_for_other_programs() {
    let folder = tempfile::tempdir().unwrap();
    let export = |threads: &str| {
        let asked = ["bench", "course", "knot:6", "--size", "48x27", "--export", ".", "--threads", threads];
        assert_eq!(run(folder.path(), &asked), (0, String::new(), String::new()));
    };
    export("1");
    let files = [
        "course-1.dat",
        "course-1.pov",
        "course-1.view.xml",
        "course-1.xml",
        "knot-6.dat",
        "knot-6.facets",
        "knot-6.pov",
        "knot-6.rays",
        "knot-6.view.xml",
        "knot-6.xml",
        "scenes.json",
    ];
    assert_eq!(listing(folder.path()), files);
    let contents = || files.map(|file| fs::read(folder.path().join(file)).unwrap());
    let first = contents();
    export("3");
    assert!(first == contents(), "the files are the same for every number of threads");

    // our own documents are the generated scene, with the sum that the others know
    let read = load_scene(&folder.path().join("knot-6.xml"), &LoadOptions::default()).unwrap().value.unwrap();
    let (scene, _) = Family::Knot.generate(6).unwrap();
    let world = Environment { compose: Compose::Add, ..scene.world.clone() };
    assert_eq!(read, Scene { world, ..scene });
    let (code, _, said) = run(folder.path(), &["knot-6.xml", "knot-6.view.xml", "-"]);
    assert_eq!((code, said.as_str()), (0, ""));

    // 20·6² facets of 10·6·6 vertices
    let facets = fs::read(folder.path().join("knot-6.facets")).unwrap();
    assert!(facets.starts_with(b"lancer facets 1\n"));
    let word = |bytes: &[u8], at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    assert_eq!((word(&facets, 16), word(&facets, 20)), (360, 720));
    assert_eq!(facets.len(), 24 + 360 * 12 + 720 * 12);

    let rays = fs::read(folder.path().join("knot-6.rays")).unwrap();
    assert!(rays.starts_with(b"lancer rays 1\n\n\n"));
    let mut at = 16;
    let mut hits = Vec::new();
    for set in 0..4 {
        let count = u64::from_le_bytes(rays[at..at + 8].try_into().unwrap()) as usize;
        let numbers: Vec<[f32; 8]> = rays[at + 8..at + 8 + 32 * count]
            .chunks_exact(32)
            .map(|ray| std::array::from_fn(|number| f32::from_bits(word(ray, 4 * number))))
            .collect();
        for [_, _, _, dx, dy, dz, length, met] in &numbers {
            assert!((dx * dx + dy * dy + dz * dz - 1.0).abs() < 1e-5);
            assert_eq!(length.is_finite(), set == 1, "shadow rays alone end");
            assert!(!met.is_nan() && *met >= 0.0);
        }
        hits.push((count, numbers.iter().filter(|ray| ray[7].is_finite()).count()));
        at += 8 + 32 * count;
    }
    assert_eq!(at, rays.len());
    assert_eq!(hits[0].0, 48 * 27);
    assert!(hits[0].1 > 200 && hits[2].0 == hits[0].1 && hits[3].0 == hits[0].1, "{hits:?}");
}
