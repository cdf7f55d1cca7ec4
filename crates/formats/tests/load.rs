//! Opening files: what they are is decided by their content, what is no file is refused without waiting, and a document
//! reaches no file outside its folder.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that fails says so by panicking")]

use lancer_formats::load::{self, LoadCause, LoadError, LoadOptions, Loaded};
use lancer_formats::progress::{self, Progress, Stage};
use lancer_formats::{Describe, Severity, binary, picture, ppm};
use lancer_scene::{Mesh, Picture, Rgb, Scene, Shape};
use lancer_words::Lang;
use std::fs;
use std::io::Write;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

/// A scene document whose objects are the given elements, in the folder.
fn scene_in(folder: &Path, objects: &str) -> PathBuf {
    let path = folder.join("scene.xml");
    fs::write(&path, format!("<scene version=\"1\">\n{objects}\n</scene>\n")).unwrap();
    path
}

fn load(path: &Path) -> Loaded<Scene> {
    load::load_scene(path, &LoadOptions::default()).unwrap()
}

fn refused(path: &Path) -> LoadError {
    load::load_scene(path, &LoadOptions::default()).unwrap_err()
}

/// Severity and English message of everything that was found.
fn said(loaded: &Loaded<Scene>) -> Vec<(Severity, String)> {
    loaded.diagnostics.iter().map(|found| (found.severity, found.problem.message(Lang::English))).collect()
}

fn error(message: &str) -> Vec<(Severity, String)> {
    vec![(Severity::Error, message.to_owned())]
}

fn meshes(scene: &Scene) -> Vec<&Mesh> {
    let mesh = |shape: &'_ Shape| matches!(shape, Shape::Mesh(_));
    let meshes = scene.objects.iter().filter(|object| mesh(&object.shape));
    meshes.map(|object| if let Shape::Mesh(mesh) = &object.shape { mesh } else { panic!() }).collect()
}

#[test]
fn a_native_scene_comes_with_its_document() {
    let folder = folder();
    let path = scene_in(folder.path(), "<sphere center=\"0 0 0\" radius=\"1\"/>");
    let loaded = load(&path);
    assert!(!loaded.has_errors());
    assert_eq!(loaded.value.unwrap().objects.len(), 1);
    assert_eq!(loaded.document.unwrap().to_bytes(), fs::read(&path).unwrap());
    assert_eq!(&*loaded.source.name, path.to_str().unwrap());
}

#[test]
fn content_decides_and_not_the_name() {
    let folder = folder();
    let scene = load(&scene_in(folder.path(), "<sphere center=\"0 0 0\" radius=\"1\"/>")).value.unwrap();
    let path = folder.path().join("looks-like.xml");
    fs::write(&path, binary::write_scene(&scene)).unwrap();
    let loaded = load(&path);
    assert_eq!((loaded.value.as_ref(), loaded.document.is_none()), (Some(&scene), true));

    let renamed = folder.path().join("scene.lancer");
    fs::rename(folder.path().join("scene.xml"), &renamed).unwrap();
    assert_eq!(load(&renamed).value, Some(scene));
}

#[test]
fn a_damaged_binary_scene_is_told_without_a_place() {
    let folder = folder();
    let path = folder.path().join("a.lancer");
    let mut bytes = binary::write_scene(&Scene::default());
    bytes.pop();
    fs::write(&path, bytes).unwrap();
    let loaded = load(&path);
    assert!(loaded.value.is_none() && loaded.has_errors());
    assert_eq!((loaded.diagnostics.len(), loaded.diagnostics[0].span, &*loaded.source.text), (1, None, ""));
}

#[test]
fn views_are_loaded_and_a_binary_scene_is_no_view() {
    let folder = folder();
    let path = folder.path().join("view.xml");
    fs::write(&path, "<view version=\"1\"><eye at=\"0 1 5\" look-at=\"0 0 0\"/></view>").unwrap();
    let loaded = load::load_views(&path, &LoadOptions::default()).unwrap();
    assert_eq!(loaded.value.unwrap().len(), 1);

    fs::write(&path, binary::write_scene(&Scene::default())).unwrap();
    let loaded = load::load_views(&path, &LoadOptions::default()).unwrap();
    assert!(loaded.value.is_none());
    assert_eq!(loaded.diagnostics[0].problem.code(), "xml::scene-for-views");
}

#[test]
fn documents_of_2009_are_told_by_their_root() {
    let folder = folder();
    let path = folder.path().join("a.xml");
    fs::write(&path, "<Scene><Couleur r=\"255\" v=\"0\" b=\"0\"/></Scene>").unwrap();
    let loaded = load(&path);
    assert_eq!(loaded.value.unwrap().world.ambient, Rgb::new(1.0, 0.0, 0.0));
    assert!(loaded.document.is_none(), "saving uses the native format");
    let views = load::load_views(&path, &LoadOptions::default()).unwrap();
    assert_eq!(views.diagnostics[0].problem.code(), "xml::scene-for-views");

    fs::write(&path, "<Rendu/>").unwrap();
    assert!(load::load_views(&path, &LoadOptions::default()).unwrap().document.is_none());
    assert_eq!(load(&path).diagnostics[0].problem.code(), "xml::views-for-scene");
}

#[test]
fn a_document_that_is_not_well_formed_keeps_its_text_for_the_report() {
    let folder = folder();
    let path = folder.path().join("a.xml");
    fs::write(&path, "<scene version=\"1\">").unwrap();
    let loaded = load(&path);
    assert!(loaded.value.is_none() && loaded.document.is_none() && loaded.diagnostics.len() == 1);
    assert_eq!(&*loaded.source.text, "<scene version=\"1\">");
}

#[test]
fn what_is_no_regular_file_is_refused_without_waiting() {
    let folder = folder();
    let pipe = folder.path().join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    assert_eq!(refused(&pipe).cause, LoadCause::NotAFile);
    assert_eq!(refused(Path::new("/dev/zero")).cause, LoadCause::NotAFile);
    assert_eq!(refused(folder.path()).cause, LoadCause::IsAFolder);
    let missing = refused(&folder.path().join("no/scene.xml"));
    assert_eq!(missing.cause, LoadCause::Missing);
    let path = missing.path.display();
    assert_eq!(missing.message(Lang::English), format!("`{path}` cannot be read: there is no such file"));
    assert_eq!(missing.message(Lang::French), format!("impossible de lire « {path} » : ce fichier n'existe pas"));
    assert_eq!(
        refused(Path::new("/dev/null")).help(Lang::English).unwrap(),
        "name a file, or send its content to standard input and name `-`"
    );
}

#[test]
fn links_in_a_circle_and_names_too_long_are_told_in_either_language() {
    let folder = folder();
    symlink("b.obj", folder.path().join("a.obj")).unwrap();
    symlink("a.obj", folder.path().join("b.obj")).unwrap();
    let circle = refused(&folder.path().join("a.obj"));
    let path = circle.path.display();
    assert_eq!(
        [circle.message(Lang::English), circle.message(Lang::French)],
        [
            format!("`{path}` cannot be read: the symbolic links on its way lead in a circle"),
            format!("impossible de lire « {path} » : les liens symboliques qui y mènent forment un cycle"),
        ]
    );
    assert_eq!(refused(&folder.path().join("b.obj/scene.xml")).cause, LoadCause::LinksInACircle);
    let long = "n".repeat(300);
    assert_eq!(refused(&folder.path().join(&long)).cause, LoadCause::NameTooLong);
    let said_of = |src: &str| said(&load(&scene_in(folder.path(), &format!("<mesh src=\"{src}\"/>"))));
    assert_eq!(
        said_of("a.obj"),
        error("mesh file `a.obj`: the file cannot be read: the symbolic links on its way lead in a circle")
    );
    let expected =
        format!("mesh file `{long}.obj`: the file cannot be read: its name is longer than the system allows");
    assert_eq!(said_of(&format!("{long}.obj")), error(&expected));
}

#[test]
fn a_file_of_too_many_bytes_is_refused() {
    let folder = folder();
    let path = scene_in(folder.path(), "");
    let bytes = fs::metadata(&path).unwrap().len();
    let options = |most_bytes| LoadOptions { most_bytes, ..LoadOptions::default() };
    assert!(load::load_scene(&path, &options(bytes)).is_ok());
    let error = load::load_scene(&path, &options(bytes - 1)).unwrap_err();
    assert_eq!(error.cause, LoadCause::TooLarge { most: bytes - 1 });

    // A file without end that takes no place on the disk.
    fs::File::create(&path).unwrap().set_len(1 << 40).unwrap();
    assert_eq!(
        refused(&path).message(Lang::English),
        format!("`{}` cannot be read: it is larger than 4096 MiB", path.display())
    );
}

#[test]
fn a_forbidden_file_is_refused() {
    let folder = folder();
    let path = scene_in(folder.path(), "");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o000)).unwrap();
    if fs::metadata("/proc/self").is_ok_and(|own| own.uid() == 0) {
        return;
    }
    assert_eq!(refused(&path).cause, LoadCause::Forbidden);
}

#[test]
fn a_mesh_that_is_named_twice_is_read_once_and_shared() {
    let folder = folder();
    fs::create_dir(folder.path().join("meshes")).unwrap();
    fs::write(folder.path().join("meshes/a.obj"), format!("mtllib a.mtl\nusemtl red\n{TRIANGLE}")).unwrap();
    fs::write(folder.path().join("meshes/a.mtl"), "newmtl red\nKd 1 0 0\nNs x\n").unwrap();
    symlink("meshes/a.obj", folder.path().join("link.obj")).unwrap();
    let loaded = load(&scene_in(
        folder.path(),
        "<mesh src=\"meshes/a.obj\"/><mesh src=\"./meshes/../meshes/a.obj\"/><mesh src=\"link.obj\"/>\n\
         <mesh src=\"meshes/a.obj\"><material kd=\"1\"/></mesh><mesh src=\"meshes/a.obj\"><material kd=\"0\"/></mesh>",
    ));
    let scene = loaded.value.as_ref().unwrap();
    let meshes = meshes(scene);
    assert!(meshes[1..3].iter().all(|mesh| Arc::ptr_eq(&mesh.geometry, &meshes[0].geometry)));
    assert!(Arc::ptr_eq(&meshes[3].geometry, &meshes[4].geometry));
    assert_eq!(meshes.iter().map(|mesh| mesh.geometry.parts.len()).collect::<Vec<_>>(), [1, 1, 1, 0, 0]);
    assert_eq!(
        said(&loaded),
        [(Severity::Warning, "mesh file `meshes/a.mtl`, line 3: a number is due, not `x`".to_owned())]
    );
}

#[test]
fn a_document_reaches_no_file_outside_its_folder() {
    let outer = folder();
    let folder = outer.path().join("scenes");
    fs::create_dir_all(folder.join("a")).unwrap();
    fs::write(outer.path().join("secret.obj"), TRIANGLE).unwrap();
    fs::write(outer.path().join("secret.mtl"), "newmtl red").unwrap();
    symlink("../secret.obj", folder.join("link.obj")).unwrap();
    symlink("..", folder.join("up")).unwrap();
    let absolute = outer.path().join("secret.obj");
    let missing = outer.path().join("missing.obj");
    for src in ["../secret.obj", "link.obj", "up/secret.obj", "a/../../secret.obj", "../missing.obj"]
        .into_iter()
        .chain([absolute.to_str().unwrap(), missing.to_str().unwrap()])
    {
        let loaded = load(&scene_in(&folder, &format!("<mesh src=\"{src}\"/>")));
        let expected =
            format!("mesh file `{src}`: the path is absolute or leads out of the folder of the scene document");
        assert_eq!(said(&loaded), error(&expected));
        let help = loaded.diagnostics[0].problem.help(Lang::English).unwrap();
        assert!(help.contains("--allow-outside"), "{help}");
        let options = LoadOptions { allow_outside: true, ..LoadOptions::default() };
        let allowed = load::load_scene(&folder.join("scene.xml"), &options).unwrap();
        assert_eq!(allowed.value.is_some(), !src.contains("missing"), "{src}");
    }
}

#[test]
fn neither_do_the_files_that_its_meshes_name() {
    let outer = folder();
    let folder = outer.path().join("scenes");
    fs::create_dir_all(folder.join("meshes")).unwrap();
    fs::create_dir(folder.join("materials")).unwrap();
    fs::write(outer.path().join("secret.mtl"), "newmtl red\nKd 1 0 0").unwrap();
    fs::write(folder.join("materials/a.mtl"), "newmtl red\nKd 1 0 0").unwrap();
    let mesh = |library: &str| {
        fs::write(folder.join("meshes/a.obj"), format!("mtllib {library}\nusemtl red\n{TRIANGLE}")).unwrap();
        load(&scene_in(&folder, "<mesh src=\"meshes/a.obj\"/>"))
    };
    assert_eq!(said(&mesh("../materials/a.mtl")), []);
    let outside = |name: &str| {
        let file = format!("mesh file `{name}`: the path is absolute or leads out of the folder of the scene document");
        let red = "mesh file `meshes/a.obj`, line 2: no library defines the material `red`".to_owned();
        vec![(Severity::Warning, file), (Severity::Warning, red)]
    };
    assert_eq!(said(&mesh("../../secret.mtl")), outside("meshes/../../secret.mtl"));
    symlink(outer.path().join("secret.mtl"), folder.join("meshes/link.mtl")).unwrap();
    assert_eq!(said(&mesh("link.mtl")), outside("meshes/link.mtl"));
    assert_eq!(said(&mesh("/etc/passwd")), outside("/etc/passwd"));

    fs::write(
        folder.join("meshes/a.gltf"),
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"%2e%2e/%2E./secret.mtl\",\"byteLength\":1}]}",
    )
    .unwrap();
    let loaded = load(&scene_in(&folder, "<mesh src=\"meshes/a.gltf\"/>"));
    let expected =
        "mesh file `meshes/../../secret.mtl`: the path is absolute or leads out of the folder of the scene document";
    assert_eq!(said(&loaded), error(expected));
}

#[test]
fn a_mesh_that_is_no_regular_file_is_refused_without_waiting() {
    let folder = folder();
    assert!(Command::new("mkfifo").arg(folder.path().join("pipe.obj")).status().unwrap().success());
    fs::create_dir(folder.path().join("folder.obj")).unwrap();
    fs::File::create(folder.path().join("endless.obj")).unwrap().set_len(1 << 40).unwrap();
    let said_of = |src: &str| said(&load(&scene_in(folder.path(), &format!("<mesh src=\"{src}\"/>"))));
    assert_eq!(said_of("pipe.obj"), error("mesh file `pipe.obj`: this is not a regular file"));
    assert_eq!(said_of("folder.obj"), error("mesh file `folder.obj`: this is not a regular file"));
    assert_eq!(said_of("endless.obj"), error("mesh file `endless.obj`: the file is larger than 4096 MiB"));
    assert_eq!(said_of("lost.obj"), error("mesh file `lost.obj`: there is no such file"));
    fs::write(folder.path().join("bad.obj"), "v 0 0 0\nf 1 2 3\n").unwrap();
    let expected = "mesh file `bad.obj`, line 2: a facet names vertex 2, which does not exist: 1 vertex so far";
    assert_eq!(said_of("bad.obj"), error(expected));
}

const SOURCE: &str = "LANCER_LOAD_TEST_SOURCE";

/// The part of the next test that runs in a process with another standard input and another current folder.
#[test]
fn in_a_process_with_an_input() {
    let Some(path) = std::env::var_os(SOURCE).map(PathBuf::from) else { return };
    let loaded = load(&path);
    assert_eq!(meshes(loaded.value.as_ref().unwrap()).len(), 1);
    println!("loaded `{}`", loaded.source.name);
}

#[test]
fn a_hyphen_is_standard_input_and_a_bare_name_stands_in_the_current_folder() {
    let folder = folder();
    let path = scene_in(folder.path(), "<mesh src=\"a.obj\"/>");
    fs::write(folder.path().join("a.obj"), TRIANGLE).unwrap();
    for (source, piped) in [("-", true), ("scene.xml", false)] {
        let mut child = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "in_a_process_with_an_input", "--nocapture"])
            .env(SOURCE, source)
            .current_dir(&folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut input = child.stdin.take().unwrap();
        if piped {
            input.write_all(&fs::read(&path).unwrap()).unwrap();
        }
        drop(input);
        let output = String::from_utf8(child.wait_with_output().unwrap().stdout).unwrap();
        assert!(output.contains(&format!("loaded `{source}`")), "{output}");
    }
}

#[test]
fn pictures_are_loaded_and_their_faults_located() {
    let folder = folder();
    let path = folder.path().join("a.ppm");
    let load = |bytes: &[u8]| {
        fs::write(&path, bytes).unwrap();
        load::load_picture(&path, &LoadOptions::default()).unwrap()
    };
    let good = Picture { width: 1, height: 2, bytes: vec![[1, 2, 3], [4, 5, 6]], linear: None };
    let mut file = Vec::new();
    ppm::write_plain(&good, &mut file).unwrap();
    assert_eq!(load(&file).value.as_ref(), Some(&good));
    let mut png = Vec::new();
    picture::write(&good, picture::Format::Png, &mut png).unwrap();
    assert_eq!(load(&png).value.as_ref(), Some(&good));

    let wrong = load(b"P3\n# \xe9t\xe9\n1 2\n255\n1 2 x");
    let span = wrong.diagnostics[0].span.unwrap();
    assert_eq!((&*wrong.source.text, wrong.source.position(span.start)), ("P3\n# ?t?\n1 2\n255\n1 2 x", (5, 5)));
    assert!(wrong.value.is_none());
    // The bytes of a raster are no text.
    let wrong = load(&[&b"P6 1 1000 15 "[..], &[16; 3000]].concat());
    assert_eq!(wrong.source.position(wrong.diagnostics[0].span.unwrap().start), (1, 14));
    let wrong = load(&[&b"P6 1 1000 15 "[..], &[1; 2000], &[16; 1000]].concat());
    assert_eq!((wrong.diagnostics[0].span, &*wrong.source.text), (None, ""));
    let wrong = load(b"GIF89a");
    assert_eq!(wrong.diagnostics[0].problem.code(), "picture::unknown-format");
}

/// A mesh file alone is a scene of one object, named like the file; what is wrong with it is an error as always.
#[test]
fn a_mesh_file_is_a_scene_of_one_object() {
    let folder = folder();
    let path = folder.path().join("tri angle.obj");
    fs::write(&path, format!("mtllib none.mtl\n{TRIANGLE}vn 0 0 1\nf 1//1 2//1 3//1\n")).unwrap();
    let loaded = load(&path);
    let scene = loaded.value.as_ref().unwrap();
    assert_eq!((scene.objects.len(), &*scene.objects[0].name), (1, "tri angle"));
    let mesh = meshes(scene)[0];
    assert_eq!((mesh.source.as_deref(), mesh.geometry.facets.len()), (Some("tri angle.obj"), 2));
    assert!(!mesh.smooth, "one facet has no normals, so none is used");
    let warnings =
        ["mesh file `none.mtl`: there is no such file", "mesh file `tri angle.obj`: its normals are not used"];
    let told = said(&loaded);
    assert_eq!(told.len(), 2, "{told:?}");
    for ((severity, message), due) in told.iter().zip(warnings) {
        assert_eq!(*severity, Severity::Warning);
        assert!(message.starts_with(due), "{message}");
    }
    fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n").unwrap();
    let told = said(&load(&path));
    assert_eq!(told.len(), 1);
    assert!(told[0].1.starts_with("mesh file `tri angle.obj`, line 4: "), "{told:?}");
    fs::write(folder.path().join(" .stl"), "").unwrap();
    assert!(load(&folder.path().join(" .stl")).has_errors());
    assert_eq!(refused(&folder.path().join("none.ply")).cause, LoadCause::Missing);
}

/// Whoever waits for a long file sees how far it is: every reader of facets tells where it has come to.
#[test]
fn a_long_reading_is_seen_to_go_on() {
    const FACETS: usize = 5000;
    let folder = tempfile::tempdir().unwrap();
    let lines = |prefix: &str, line: &dyn Fn(usize) -> String| -> String {
        (0..FACETS).map(|number| format!("{prefix}{}\n", line(number))).collect()
    };
    let vertex = |number: usize| format!("{number} {} 0", number % 7);
    let facet = |number: usize| format!("{} {} {}", number, (number + 1) % FACETS, (number + 2) % FACETS);
    let counted = |number: usize| format!("{} {} {}", number + 1, (number + 1) % FACETS + 1, (number + 2) % FACETS + 1);
    let header = format!(
        "ply\nformat ascii 1.0\nelement vertex {FACETS}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {FACETS}\nproperty list uchar int vertex_indices\nend_header\n"
    );
    let mut stl = vec![0; 80];
    stl.extend((FACETS as u32).to_le_bytes());
    for number in 0..FACETS {
        let corners = [[number as f32, 0.0, 0.0], [number as f32, 1.0, 0.0], [number as f32, 0.0, 1.0]];
        stl.extend([0; 12]);
        stl.extend(corners.iter().flatten().flat_map(|coordinate| coordinate.to_le_bytes()));
        stl.extend([0; 2]);
    }
    let mesh = format!(
        "<scene version=\"1\"><mesh><vertices>{}</vertices><facets>{}</facets></mesh></scene>",
        lines("", &vertex),
        lines("", &facet)
    );
    let files: [(&str, Vec<u8>); 4] = [
        ("a.obj", ("mtllib a.mtl\n".to_owned() + &lines("v ", &vertex) + &lines("f ", &counted)).into_bytes()),
        ("a.ply", (header + &lines("", &vertex) + &lines("3 ", &facet)).into_bytes()),
        ("a.stl", stl),
        ("a.xml", mesh.into_bytes()),
    ];
    std::fs::write(folder.path().join("a.mtl"), "newmtl grey\n").unwrap();
    for (name, bytes) in files {
        let path = folder.path().join(name);
        std::fs::write(&path, &bytes).unwrap();
        let progress = Progress::default();
        let read = || load::load_scene(&path, &LoadOptions::default()).unwrap();
        assert_eq!(progress::watched(&progress, read).diagnostics, [], "{name}");
        let (stage, part) = progress.now();
        assert!(stage == Stage::Content && part.is_some_and(|part| part > 0.75 && part < 1.0), "{name}: {part:?}");
        assert_eq!(progress::watched(&Progress::default(), read).value, read().value, "{name}");
    }
}
