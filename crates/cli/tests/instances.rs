//! Many objects that show one mesh file: it is read once, held once, has one hierarchy and is written once.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::run;
use lancer_formats::load::{LoadOptions, load_scene};
use lancer_formats::text;
use lancer_scene::{MeshGeometry, Scene};
use lancer_trace::World;
use lancer_words::Lang;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::sync::Arc;

const INSTANCES: usize = 1000;

fn load(path: &Path) -> Scene {
    load_scene(path, &LoadOptions::default()).unwrap().value.unwrap()
}

/// The one geometry that all objects show.
fn the_geometry(scene: &Scene) -> Arc<MeshGeometry> {
    let geometries: Vec<_> = scene.objects.iter().map(|object| object.shape.geometry().unwrap()).collect();
    assert_eq!(geometries.len(), INSTANCES);
    assert!(geometries.iter().all(|other| Arc::ptr_eq(other, geometries[0])), "one geometry in memory");
    Arc::clone(geometries[0])
}

#[test]
fn one_file_is_read_held_packed_and_written_once() {
    let folder = tempfile::TempDir::new().unwrap();
    let path = folder.path();
    assert_eq!(run(path, &["generate", "knot", "knot.glb", "--size", "10", "-q"]).0, 0);
    let mut text = String::from("<scene version='1'><material name='m'/><light position='9 20 9'/>\n");
    for number in 0..INSTANCES {
        let (x, z) = (number % 40, number / 40);
        // the same file by two names
        let src = if number % 2 == 0 { "knot.glb" } else { "./knot.glb" };
        let _ = writeln!(
            text,
            "<mesh src='{src}' scale='0.25' rotation='{} {} 0' position='{x} 0 {z}' material='m'/>",
            number * 7 % 360,
            number * 11 % 360
        );
    }
    fs::write(path.join("many.xml"), text + "</scene>").unwrap();
    fs::write(
        path.join("view.xml"),
        "<view version='1' width='96' height='64'><eye at='20 30 70' look-at='20 0 10'/></view>",
    )
    .unwrap();

    let scene = load(&path.join("many.xml"));
    let geometry = the_geometry(&scene);
    assert_eq!(geometry.facets.len(), 2000);
    // the file, the scene's objects and this test hold it: no copy is anywhere
    let stats = World::compile(&scene).build_stats();
    assert_eq!(stats.facets, 2000, "one hierarchy");

    // two source names keep the documents apart, not the geometries: the binary form holds the vertices once
    assert_eq!(run(path, &["convert", "many.xml", "many.lancer"]).0, 0);
    let bytes = fs::metadata(path.join("many.lancer")).unwrap().len();
    let vertices = 24 * geometry.positions.len() + 12 * geometry.facets.len();
    assert!((bytes as usize) < vertices + 400 * INSTANCES, "{bytes}");
    the_geometry(&load(&path.join("many.lancer")));
    assert_eq!(run(path, &["convert", "many.lancer", "again.xml"]).0, 0);
    assert_eq!(load(&path.join("again.xml")), scene);

    // seen from afar, where facets are far smaller than pixels, the engine sees what the reference sees
    let picture = |engine: &str| run(path, &["many.lancer", "view.xml", "-", "--engine", engine]).1;
    assert_eq!(picture("simd"), picture("reference"));
    assert!(text::describe(&scene, Lang::English).contains("1000"));
}
