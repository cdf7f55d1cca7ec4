//! The scene suite: `tests/scenes/<topic>/<one-thing>.xml` with its view, its picture and its expectations. The format
//! is told in `tests/scenes/README.md`. Every scene is rendered by the reference, and by the engine in every way that
//! this machine can run it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod expectation;

use expectation::Expectation;
use lancer_formats::load::{self, LoadError, LoadOptions, Loaded};
use lancer_formats::picture::{self, Format};
use lancer_formats::{Describe, Diagnostic, Severity};
use lancer_render::{RenderOptions, Still, Tracing, render_still};
use lancer_scene::{Picture, View};
use lancer_trace::{Cancel, Simd, World};
use lancer_words::Lang;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

/// How many differing pixels a failure prints.
const PRINTED: usize = 8;

/// `tests/scenes` of the repository.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/scenes")
}

/// Every test by its name `topic/one-thing`, and what is wrong with the files themselves.
fn tests() -> (Vec<String>, Vec<String>) {
    let (mut names, mut problems) = (Vec::new(), Vec::new());
    for topic in fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_dir()) {
        let topic_name = topic.file_name().unwrap().to_str().unwrap().to_owned();
        for file in fs::read_dir(&topic).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file()) {
            let file_name = file.file_name().unwrap().to_str().unwrap();
            let stem =
                [".view.xml", ".xml", ".nff", ".ppm", ".expect"].iter().find_map(|end| file_name.strip_suffix(end));
            match stem {
                // what scenes refer to: meshes, materials
                None => {}
                Some(stem) if !scene_files(&topic, stem)[0].is_file() => {
                    problems.push(format!("{topic_name}/{file_name} belongs to no scene: {stem}.xml is missing"));
                }
                Some(stem) if scene_files(&topic, stem)[0] == file => names.push(format!("{topic_name}/{stem}")),
                Some(_) => {}
            }
        }
    }
    names.sort();
    problems.sort();
    (names, problems)
}

/// The files of a scene and of its views: documents, or one NFF file.
fn scene_files(folder: &Path, stem: &str) -> [PathBuf; 2] {
    let both = folder.join(format!("{stem}.nff"));
    if both.is_file() {
        [both.clone(), both]
    } else {
        [".xml", ".view.xml"].map(|end| folder.join(format!("{stem}{end}")))
    }
}

/// What was loaded, or its first error.
fn value<T>(loaded: Result<Loaded<T>, LoadError>) -> Result<T, String> {
    let loaded = loaded.map_err(|error| error.message(Lang::English))?;
    let place = |found: &Diagnostic| found.span.map_or((0, 0), |span| loaded.source.position(span.start));
    let told = |found: &Diagnostic| {
        let (line, column) = place(found);
        format!("{}:{line}:{column}: {}", loaded.source.name, found.problem.message(Lang::English))
    };
    match loaded.diagnostics.iter().find(|found| found.severity == Severity::Error) {
        Some(found) => Err(told(found)),
        None => loaded.value.ok_or_else(|| "nothing was read".to_owned()),
    }
}

/// Reads a test's scene and its first view and renders them with the reference and the engine.
fn render(name: &str) -> Result<Still, String> {
    let [scene, views] = scene_files(&folder(), name);
    let options = LoadOptions::default();
    let scene = value(load::load_scene(&scene, &options))?;
    let views = value(load::load_views(&views, &options))?;
    let view = views.first().ok_or("the view document holds no view")?;
    let world = World::compile(&scene);
    let reference = still(&world, view, Tracing::Reference, 1)?;
    for simd in Simd::ALL.into_iter().filter(|simd| simd.is_available()) {
        for threads in [1, 3] {
            let engine = still(&world, view, Tracing::Engine(simd), threads)?;
            agree(&engine, &reference).map_err(|problem| format!("{} on {threads} threads: {problem}", simd.name()))?;
        }
    }
    Ok(reference)
}

/// Renders a view.
fn still(world: &World, view: &View, tracing: Tracing, threads: usize) -> Result<Still, String> {
    let options = RenderOptions { tracing, threads: NonZeroUsize::new(threads), ..RenderOptions::default() };
    render_still(world, view, &options, &Cancel::default(), |_, _| ()).map_err(|error| error.to_string())
}

/// The engine's rays are the reference's, and so are its bytes. Its powers differ by less than 10⁻¹², which could move a
/// byte by 1 where a colour lies that near to the border of two; no scene of the suite has such a pixel.
fn agree(engine: &Still, reference: &Still) -> Result<(), String> {
    if engine.counts != reference.counts {
        return Err(format!("{:?} instead of the reference's {:?}", engine.counts, reference.counts));
    }
    let pixels = engine.picture.bytes.iter().zip(&reference.picture.bytes).enumerate();
    let mut differing = pixels.filter(|(_, (engine, reference))| engine != reference);
    match differing.next() {
        None => Ok(()),
        Some((place, (bytes, due))) => {
            let (x, y) = (place % engine.picture.width as usize, place / engine.picture.width as usize);
            let more = differing.count();
            Err(format!("pixel {x} {y} is {bytes:?} instead of the reference's {due:?}, and {more} more differ"))
        }
    }
}

/// The bytes of a picture's file.
fn file_of(picture: &Picture) -> Vec<u8> {
    let mut bytes = Vec::new();
    picture::write(picture, Format::PlainPpm, &mut bytes).unwrap();
    bytes
}

/// Compares a picture with its file; rewrites the file if asked to.
fn compare(name: &str, rendered: &Picture, update: bool) -> Result<(), String> {
    let path = folder().join(format!("{name}.ppm"));
    let actual = file_of(rendered);
    let expected = match fs::read(&path) {
        Ok(expected) => expected,
        Err(_) if update => Vec::new(),
        Err(error) => return Err(format!("{name}.ppm: {error}; UPDATE_REFS=1 writes it")),
    };
    if actual == expected {
        return Ok(());
    }
    if update {
        return fs::write(&path, actual).map_err(|error| format!("{}: {error}", path.display()));
    }
    let outcome = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("scenes").join(name);
    fs::create_dir_all(outcome.parent().unwrap()).unwrap();
    fs::write(outcome.with_extension("actual.ppm"), actual).unwrap();
    let reference =
        picture::read(&expected).map_err(|problem| format!("{name}.ppm is no picture: {:?}", problem.problem))?;
    let (difference, drawn) =
        picture::compare(&reference, rendered, 0).map_err(|sizes| format!("{name}.ppm: {sizes}"))?;
    fs::write(outcome.with_extension("difference.ppm"), file_of(&drawn)).unwrap();
    let places = difference.first.iter().take(PRINTED).fold(String::new(), |text, place| {
        text + &format!("\n    pixel {} {}: {:?} instead of {:?}", place.x, place.y, place.second, place.first)
    });
    Err(format!(
        "{} of {} pixels differ, by up to {}; see {}.*{places}",
        difference.differing,
        difference.pixels,
        difference.max,
        outcome.display()
    ))
}

#[test]
fn every_scene_gives_its_picture_and_meets_its_expectations() {
    let update = std::env::var_os("UPDATE_REFS").is_some_and(|value| value == "1");
    let (names, mut problems) = tests();
    let stills: BTreeMap<&str, Result<Still, String>> =
        names.par_iter().map(|name| (name.as_str(), render(name))).collect();
    for (name, still) in &stills {
        let mut found = Vec::new();
        match still {
            Err(problem) => found.push(problem.clone()),
            Ok(still) => {
                found.extend(compare(name, &still.picture, update).err());
                let path = folder().join(format!("{name}.expect"));
                if path.is_file() {
                    match Expectation::read(&path) {
                        Err(problems) => found.extend(problems),
                        Ok(expectations) => {
                            let other = |name: &str| stills.get(name).and_then(|still| still.as_ref().ok());
                            found.extend(expectations.iter().filter_map(|due| due.unmet(still, other)));
                        }
                    }
                }
            }
        }
        problems.extend(found.into_iter().map(|problem| format!("{name}: {problem}")));
    }
    assert!(problems.is_empty(), "\n{}\n", problems.join("\n"));
}

/// The example scenes too, small: their meshes are larger than those of the suite. In `gallery/knot` rays that go into a
/// mesh one by one once shortened the others.
#[test]
fn the_engine_draws_every_example_as_the_reference_does() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let mut files: Vec<PathBuf> = fs::read_dir(&examples)
        .unwrap()
        .flat_map(|topic| fs::read_dir(topic.unwrap().path()).into_iter().flatten())
        .map(|file| file.unwrap().path())
        .filter(|path| [".view.xml", ".nff"].iter().any(|end| path.to_string_lossy().ends_with(end)))
        .collect();
    files.sort();
    assert!(files.len() > 25, "{files:?}");
    let problems: Vec<String> = files
        .par_iter()
        .filter_map(|path| {
            let scene = PathBuf::from(path.to_string_lossy().replace(".view.xml", ".xml"));
            let options = LoadOptions::default();
            let scene = value(load::load_scene(&scene, &options)).unwrap();
            let views = value(load::load_views(path, &options)).unwrap();
            let world = World::compile(&scene);
            let view = View { width: 160, height: 120, samples: 1, ..View::clone(views.first().unwrap()) };
            let reference = still(&world, &view, Tracing::Reference, 1).unwrap();
            let engine = still(&world, &view, Tracing::default(), 2).unwrap();
            agree(&engine, &reference).err().map(|problem| format!("{}: {problem}", path.display()))
        })
        .collect();
    assert!(problems.is_empty(), "{problems:#?}");
}
