//! Scenes into files: the writer that a name means, and that a document finds its meshes again wherever it goes.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that fails says so by panicking")]

use lancer_formats::load::{self, LoadOptions};
use lancer_formats::save::{self, Origin, SaveCause, SceneFormat};
use lancer_scene::{Mesh, Scene, Shape};
use lancer_words::Lang;
use std::fs;
use std::path::{Path, PathBuf};

const OPTIONS: LoadOptions = LoadOptions { allow_outside: false, most_bytes: 1 << 20 };

/// A file without a document to be patched.
fn from(path: &Path) -> Option<Origin<'_>> {
    Some(Origin { path, document: None })
}

fn load(path: &Path) -> Scene {
    let loaded = load::load_scene(path, &OPTIONS).unwrap();
    loaded.value.unwrap_or_else(|| panic!("{:?}", loaded.diagnostics))
}

fn mesh(scene: &Scene, object: usize) -> &Mesh {
    let Shape::Mesh(mesh) = &scene.objects[object].shape else { panic!("no mesh") };
    mesh
}

/// The sources of the meshes.
fn sources(scene: &Scene) -> Vec<Option<&str>> {
    (0..scene.objects.len()).map(|object| mesh(scene, object).source.as_deref()).collect()
}

/// The scene with the vertices of every mesh inline.
fn inline(scene: &Scene) -> Scene {
    let objects = scene.objects.iter().enumerate().map(|(number, object)| {
        let shape = Shape::Mesh(Mesh { source: None, ..mesh(scene, number).clone() });
        lancer_scene::Object { shape, ..(**object).clone() }
    });
    Scene { objects: objects.collect(), ..scene.clone() }
}

/// A folder `a` with a document that names a mesh with a material of its own twice, once in another material.
fn example() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let meshes = folder.path().join("a/meshes");
    fs::create_dir_all(&meshes).unwrap();
    let facet = "mtllib a.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 0.1 0\nf 1 2 3\n";
    fs::write(meshes.join("a.obj"), facet).unwrap();
    fs::write(meshes.join("a.mtl"), "newmtl red\nKd 1 0 0\n").unwrap();
    let path = folder.path().join("a/scene.xml");
    let document = "<scene version=\"1\"><material name=\"m\"/><mesh src=\"meshes/a.obj\"/>\
                    <mesh src=\"meshes/a.obj\" material=\"m\" scale=\"2\"/></scene>";
    fs::write(&path, document).unwrap();
    (folder, path)
}

#[test]
fn the_extension_chooses_the_writer() {
    let of = |name: &str| SceneFormat::of_path(Path::new(name));
    assert_eq!(of("a.xml"), Ok(SceneFormat::Xml));
    assert_eq!(of("a.LANCER"), Ok(SceneFormat::Binary));
    assert_eq!(of("-"), Ok(SceneFormat::Xml));
    let unknown = of("a.obj").unwrap_err();
    assert_eq!(unknown.message(Lang::English), "no scene format has the extension .obj; known are .xml and .lancer");
    assert_eq!(
        unknown.message(Lang::French),
        "aucun format de scène n'a l'extension .obj ; sont connues .xml et .lancer"
    );
}

#[test]
fn every_format_reads_back_as_the_same_scene() {
    let (_folder, origin) = example();
    let scene = load(&origin);
    for (format, name) in [(SceneFormat::Xml, "copy.xml"), (SceneFormat::Binary, "copy.lancer")] {
        let path = origin.with_file_name(name);
        save::save_scene(&scene, format, &path, from(&origin), OPTIONS).unwrap();
        assert_eq!(load(&path), scene, "{name}");
    }
}

#[test]
fn a_document_that_goes_up_names_its_meshes_from_there() {
    let (folder, origin) = example();
    let scene = load(&origin);
    let path = folder.path().join("scene.xml");
    save::save_scene(&scene, SceneFormat::Xml, &path, from(&origin), OPTIONS).unwrap();
    let moved = load(&path);
    assert_eq!(sources(&moved), [Some("a/meshes/a.obj"); 2]);
    assert_eq!(inline(&moved), inline(&scene));
}

#[test]
fn a_document_that_goes_elsewhere_takes_its_vertices_along() {
    let (folder, origin) = example();
    let scene = load(&origin);
    let elsewhere = folder.path().join("b");
    fs::create_dir(&elsewhere).unwrap();
    let path = elsewhere.join("scene.xml");
    save::save_scene(&scene, SceneFormat::Xml, &path, from(&origin), OPTIONS).unwrap();
    assert_eq!(load(&path), inline(&scene));

    // A file of the same name that holds something else is not the mesh.
    fs::create_dir(elsewhere.join("meshes")).unwrap();
    fs::write(elsewhere.join("meshes/a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    save::save_scene(&scene, SceneFormat::Xml, &path, from(&origin), OPTIONS).unwrap();
    assert_eq!(load(&path), inline(&scene));
}

#[test]
fn a_binary_scene_whose_mesh_file_has_changed_keeps_its_own() {
    let (folder, origin) = example();
    let scene = load(&origin);
    let binary = origin.with_file_name("scene.lancer");
    save::save_scene(&scene, SceneFormat::Binary, &binary, from(&origin), OPTIONS).unwrap();
    fs::write(folder.path().join("a/meshes/a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let scene = load(&binary);
    let path = origin.with_file_name("copy.xml");
    save::save_scene(&scene, SceneFormat::Xml, &path, from(&binary), OPTIONS).unwrap();
    assert_eq!(load(&path), inline(&scene));
}

#[test]
fn a_document_keeps_what_did_not_change_wherever_it_goes() {
    let (folder, path) = example();
    let text = "<scene version='1'> <!-- kept --> <mesh\tname='m'  src='meshes/a.obj'/>\r\n</scene>\n";
    fs::write(&path, text).unwrap();
    let loaded = load::load_scene(&path, &OPTIONS).unwrap();
    let scene = loaded.value.unwrap();
    let origin = Some(Origin { path: &path, document: loaded.document.as_ref() });
    let bytes = |scene: &Scene, to: &Path| {
        String::from_utf8(save::scene_bytes(scene, SceneFormat::Xml, to, origin, OPTIONS)).unwrap()
    };
    assert_eq!(bytes(&scene, &path), text);
    assert_eq!(bytes(&scene, &path.with_file_name("copy.xml")), text);
    assert_eq!(bytes(&scene, &folder.path().join("up.xml")), text.replace("meshes", "a/meshes"));

    let elsewhere = folder.path().join("b.xml");
    fs::remove_dir_all(folder.path().join("a/meshes")).unwrap();
    save::save_scene(&scene, SceneFormat::Xml, &elsewhere, origin, OPTIONS).unwrap();
    assert!(fs::read_to_string(&elsewhere).unwrap().starts_with("<scene version='1'> <!-- kept --> <mesh"));
    assert_eq!(load(&elsewhere), inline(&scene));
}

#[test]
fn a_scene_that_cannot_be_written_says_so() {
    let (folder, origin) = example();
    let path = folder.path().join("no/scene.xml");
    let error = save::save_scene(&load(&origin), SceneFormat::Xml, &path, from(&origin), OPTIONS).unwrap_err();
    assert_eq!(error.cause, SaveCause::MissingFolder(folder.path().join("no")));
}
