//! `lancer convert`: scenes, views and pictures from one format to another, with nothing lost that is not told.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::{folder, run};
use std::fs;
use std::path::Path;

fn convert(folder: &Path, args: &[&str]) -> String {
    let (code, told, said) = run(folder, &[&["convert"], args].concat());
    assert_eq!((code, told.as_str()), (0, ""), "{said}");
    said
}

fn picture(folder: &Path, scene: &str, view: &str) -> String {
    let (code, picture, said) = run(folder, &[scene, view, "-"]);
    assert_eq!(code, 0, "{said}");
    picture
}

#[test]
fn a_scene_through_the_binary_format_and_back_is_the_same() {
    let folder = folder();
    let path = folder.path();
    assert_eq!(convert(path, &["scene.xml", "canonical.xml"]), "");
    assert_eq!(convert(path, &["scene.xml", "scene.lancer"]), "");
    assert_eq!(convert(path, &["scene.lancer", "back.xml"]), "");
    let read = |name: &str| fs::read_to_string(path.join(name)).unwrap();
    assert_eq!(read("back.xml"), read("canonical.xml"));
    assert_eq!(picture(path, "scene.lancer", "view.xml"), picture(path, "scene.xml", "view.xml"));
    // `--to` overrules the extension, and standard output gets XML
    assert_eq!(convert(path, &["scene.xml", "binary.xml", "--to", "binary"]), "");
    assert_eq!(fs::read(path.join("binary.xml")).unwrap(), fs::read(path.join("scene.lancer")).unwrap());
    assert_eq!(run(path, &["convert", "scene.lancer", "-"]).1, read("canonical.xml"));
}

#[test]
fn views_are_written_in_the_canonical_layout() {
    let folder = folder();
    assert_eq!(convert(folder.path(), &["view.xml", "again.xml"]), "");
    assert_eq!(picture(folder.path(), "scene.xml", "again.xml"), picture(folder.path(), "scene.xml", "view.xml"));
    let (code, _, said) = run(folder.path(), &["convert", "view.xml", "view.lancer"]);
    assert_eq!((code, said.as_str()), (1, "error: views have no binary form\n  help: write them as .xml\n"));
}

/// What the documents of 2009 cannot hold is told, and the picture of what they can hold is the same.
#[test]
fn documents_of_2009_are_written_with_the_list_of_losses() {
    let folder = folder();
    let path = folder.path();
    let losses = convert(path, &["scene.xml", "old.xml", "--to", "2009"]);
    assert!(losses.contains("old.xml") && losses.contains("background"), "{losses}");
    assert_eq!(convert(path, &["scene.xml", "old.xml", "--to", "2009", "--quiet"]), "");
    assert!(fs::read_to_string(path.join("old.xml")).unwrap().contains("<ObjetGraphique>"));
    convert(path, &["old.xml", "new.xml"]);
    assert_eq!(picture(path, "old.xml", "view.xml"), picture(path, "new.xml", "view.xml"));
    convert(path, &["view.xml", "old.view.xml", "--to", "2009"]);
    assert!(fs::read_to_string(path.join("old.view.xml")).unwrap().contains("<Rendu>"));
    // one level: a screen in the format's corners is rounded
    fs::write(path.join("a.ppm"), picture(path, "scene.xml", "view.xml")).unwrap();
    fs::write(path.join("b.ppm"), picture(path, "scene.xml", "old.view.xml")).unwrap();
    assert_eq!(run(path, &["diff", "a.ppm", "b.ppm", "--tolerance", "1"]).0, 0);
}

/// A mesh file that the new document would not find is written out.
#[test]
fn a_mesh_keeps_its_file_where_the_new_document_finds_it() {
    let folder = folder();
    let path = folder.path();
    fs::write(path.join("tent.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n").unwrap();
    fs::write(
        path.join("tent.xml"),
        "<scene version='1'><light position='1 3 4'/><mesh name='tent' src='tent.obj' scale='2'/></scene>",
    )
    .unwrap();
    fs::create_dir(path.join("elsewhere")).unwrap();
    convert(path, &["tent.xml", "beside.xml"]);
    convert(path, &["tent.xml", "elsewhere/tent.xml"]);
    convert(path, &["tent.xml", "elsewhere/tent.lancer"]);
    convert(path, &["elsewhere/tent.lancer", "back.xml"]);
    let read = |name: &str| fs::read_to_string(path.join(name)).unwrap();
    assert!(read("beside.xml").contains("src=\"tent.obj\""), "{}", read("beside.xml"));
    assert!(!read("elsewhere/tent.xml").contains("src="), "{}", read("elsewhere/tent.xml"));
    assert_eq!(read("back.xml"), read("beside.xml"));
    for scene in ["beside.xml", "elsewhere/tent.xml", "elsewhere/tent.lancer"] {
        assert_eq!(picture(path, scene, "view.xml"), picture(path, "tent.xml", "view.xml"), "{scene}");
    }
}

/// The view is named, or stands beside the scene.
#[test]
fn a_scene_becomes_one_of_pov_ray_with_a_view() {
    let folder = folder();
    let path = folder.path();
    let losses = convert(path, &["scene.xml", "scene.pov", "--views", "view.xml", "--view", "above"]);
    assert!(losses.contains("the composition `screen` becomes a plain sum"), "{losses}");
    let read = |name: &str| fs::read_to_string(path.join(name)).unwrap();
    assert!(read("scene.pov").contains("camera { perspective location <0, 5, 1>"), "{}", read("scene.pov"));
    fs::rename(path.join("view.xml"), path.join("scene.view.xml")).unwrap();
    assert_eq!(convert(path, &["scene.xml", "scene.pov", "--quiet"]), "");
    assert!(read("scene.pov").contains("location <0, 1, 4>"));
    let (code, _, said) = run(path, &["convert", "scene.xml", "scene.pov", "--view", "side"]);
    assert!(code == 1 && said.contains("`side`"), "{said}");
}

/// What is written as OBJ or glTF is read again as the same facets with nearly the same picture.
#[test]
fn facetted_objects_come_back_from_obj_and_gltf() {
    let folder = folder();
    let path = folder.path();
    fs::write(
        path.join("die.xml"),
        "<scene version='1'><material name='clay' ka='0.3 0.2 0.1' kd='0.6 0.4 0.2'/><light position='1 3 4'/>\
         <cube center='0 0.5 0' edge='1' rotation='10 30 0' material='clay'/>\
         <mesh material='clay' position='1 0 0' scale='0.5'><vertices>0 0 0 1 0 0 0 1 0 0 0 1</vertices>\
         <facets>0 2 1 0 1 3 0 3 2 1 2 3</facets></mesh></scene>",
    )
    .unwrap();
    for (file, tolerance) in [("die.obj", "0"), ("die.glb", "1"), ("die.gltf", "1")] {
        let losses = convert(path, &["die.xml", file]);
        assert!(losses.contains("lamps, ambient light and background are left out"), "{losses}");
        let again = format!("<scene version='1'><light position='1 3 4'/><mesh src='{file}'/></scene>");
        fs::write(
            path.join("again.xml"),
            again.replace(
                "<mesh",
                if file == "die.obj" {
                    "<mesh"
                } else {
                    "<material name='clay' ka='0.3 0.2 0.1' kd='0.6 0.4 0.2'/><mesh material='clay'"
                },
            ),
        )
        .unwrap();
        fs::write(path.join("a.ppm"), picture(path, "die.xml", "view.xml")).unwrap();
        fs::write(path.join("b.ppm"), picture(path, "again.xml", "view.xml")).unwrap();
        let (code, told, _) = run(path, &["diff", "a.ppm", "b.ppm", "--tolerance", tolerance]);
        assert_eq!(code, 0, "{file}: {told}");
    }
    assert!(fs::read_to_string(path.join("die.obj")).unwrap().starts_with("mtllib die.mtl\no cube 1\n"));
    let (code, _, said) = run(path, &["convert", "die.xml", "die.obj", "--lang", "fr"]);
    assert!(code == 0 && said.contains("les sources, la lumière ambiante et le fond sont omis"), "{said}");
}

#[test]
fn pictures_are_converted_between_their_formats() {
    let folder = folder();
    let path = folder.path();
    fs::write(path.join("a.ppm"), picture(path, "scene.xml", "view.xml")).unwrap();
    for name in ["a.png", "a.qoi", "a.tiff", "a.bmp"] {
        convert(path, &["a.ppm", name]);
        convert(path, &[name, "back.ppm"]);
        assert_eq!(fs::read(path.join("back.ppm")).unwrap(), fs::read(path.join("a.ppm")).unwrap(), "{name}");
    }
    convert(path, &["a.png", "raw.ppm", "--binary"]);
    assert!(fs::read(path.join("raw.ppm")).unwrap().starts_with(b"P6\n"));
}

#[test]
fn what_cannot_be_converted_is_told() {
    let folder = folder();
    for (args, code, text) in [
        (
            ["scene.xml", "scene.png"],
            1,
            "error: `scene.png` is a picture's name, but the input is no picture\n  help: a scene becomes a picture by \
             rendering it: lancer SCENE VIEW OUTPUT\n",
        ),
        (
            ["scene.xml", "scene.doc"],
            2,
            "error: the name `scene.doc` does not say which format to write\n  help: scenes: .xml, .lancer, \
             .pov, .obj, .gltf or .glb; views: .xml; or choose with --to\n",
        ),
        (
            ["scene.xml", "scene"],
            2,
            "error: the name `scene` does not say which format to write\n  help: scenes: .xml, .lancer, .pov, \
             .obj, .gltf or .glb; views: .xml; or choose with --to\n",
        ),
        (
            ["scene.xml", "scene.pov"],
            1,
            "error: `scene.pov` needs a camera, but no view is given\n  help: name the document of the views: --views \
             FILE; without it, `scene.view.xml` beside the scene is taken if it is there\n",
        ),
        (
            ["view.xml", "view.glb"],
            1,
            "error: `view.glb` holds objects, but the input is a document of views\n  help: give the scene as IN, and \
             the views with --views FILE\n",
        ),
        (
            ["nothing.xml", "scene.lancer"],
            3,
            "error: `nothing.xml` cannot be read: there is no such file\n  help: check the name and the folder\n",
        ),
        (
            ["scene.xml", "no/such/scene.lancer"],
            3,
            "error: `no/such/scene.lancer` cannot be written: there is no folder `no/such`\n  help: make the folder \
             first, or check its name\n",
        ),
    ] {
        let before = common::listing(folder.path());
        assert_eq!(
            run(folder.path(), &["convert", args[0], args[1]]),
            (code, String::new(), text.to_owned()),
            "{args:?}"
        );
        assert_eq!(common::listing(folder.path()), before);
    }
}

/// A binary scene that is cut short or changed is refused, wherever a scene is read.
#[test]
fn a_damaged_binary_scene_is_refused() {
    let folder = folder();
    convert(folder.path(), &["scene.xml", "scene.lancer"]);
    let whole = fs::read(folder.path().join("scene.lancer")).unwrap();
    fs::write(folder.path().join("cut.lancer"), &whole[..whole.len() / 2]).unwrap();
    let (code, told, said) = run(folder.path(), &["show", "cut.lancer"]);
    assert_eq!((code, told.as_str()), (1, ""));
    assert!(said.contains("cut.lancer"), "{said}");
}

/// An NFF file is a scene and a view, and becomes a document; a mesh file becomes a document that names it, or holds its
/// vertices where it is not found from there.
#[test]
fn files_of_others_become_scenes() {
    let folder = folder();
    let path = folder.path();
    let nff = "b 0 0 1\nv\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 12 8\nl 5 5 5\nf 1 0 0 1 0 0 0 0\n\
               s 0 0 0 1\nc\n-1 -1 0 0.2\n1 1 0 0\n";
    fs::write(path.join("two.nff"), nff).unwrap();
    assert_eq!(convert(path, &["two.nff", "two.xml"]), "");
    let text = fs::read_to_string(path.join("two.xml")).unwrap();
    for line in [
        "<world ambient=\"0.5\" background=\"0 0 1\" depth=\"4\" compose=\"add\"/>",
        "<sphere name=\"sphere 1\" center=\"0 0 0\" radius=\"1\" material=\"fill 1\"/>",
        "<cone name=\"cone 1\" base=\"-1 -1 0\" top=\"1 1 0\" base-radius=\"0.2\" top-radius=\"0\" capped=\"false\" \
         material=\"fill 1\"/>",
    ] {
        let found = text.lines().any(|found| found.split_whitespace().eq(line.split_whitespace()));
        assert!(found, "{line} is not in\n{text}");
    }
    assert_eq!(picture(path, "two.xml", "two.nff"), picture(path, "two.nff", "two.nff"));

    convert(path, &["two.nff", "two.view.xml"]);
    assert_eq!(picture(path, "two.xml", "two.view.xml"), picture(path, "two.nff", "two.nff"));

    fs::create_dir(path.join("elsewhere")).unwrap();
    fs::write(path.join("tri.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    convert(path, &["tri.obj", "beside.xml"]);
    assert!(fs::read_to_string(path.join("beside.xml")).unwrap().contains("<mesh name=\"tri\" src=\"tri.obj\"/>"));
    convert(path, &["tri.obj", "elsewhere/within.xml"]);
    assert!(fs::read_to_string(path.join("elsewhere/within.xml")).unwrap().contains("<facets>0 1 2</facets>"));
    assert_eq!(picture(path, "elsewhere/within.xml", "two.nff"), picture(path, "tri.obj", "two.nff"));
    fs::write(path.join("bad.nff"), "s 0 0 0\n").unwrap();
    let (code, _, said) = run(path, &["convert", "bad.nff", "bad.xml"]);
    assert_eq!(code, 1);
    assert!(said.contains("bad.nff:1:8") && said.contains("the file ends where a radius is due"), "{said}");
}
