//! Saving an edited scene into its document: what changed changes, and everything else stays byte for byte.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test")]

#[path = "../../scene/tests/arbitrary/mod.rs"]
mod arbitrary;

use arbitrary::{Extent, scene, views};
use lancer_formats::mesh::{MeshFile, MeshFiles, MeshProblem};
use lancer_formats::xml::{Document, Node, patch_scene, patch_views, read_scene, read_views, write_scene, write_views};
use lancer_scene::{DVec3, MaterialRef, Object, PointLight, Rgb, Scene, Shape, Surface, Views};
use proptest::prelude::*;
use proptest::sample::Index;
use std::sync::Arc;

struct AnyFile;

impl MeshFiles for AnyFile {
    fn read(&mut self, _path: &str) -> Result<MeshFile, MeshProblem> {
        Ok(MeshFile::new(Default::default(), Vec::new()))
    }
}

fn document(bytes: &[u8]) -> Document {
    Document::read("edited.xml", bytes).unwrap_or_else(|bad| panic!("{:?}\n{}", bad.diagnostic, bad.source.text))
}

fn scene_of(document: &Document) -> Scene {
    let outcome = read_scene(document, &mut AnyFile);
    outcome.value.unwrap_or_else(|| panic!("{:?}\n{}", outcome.diagnostics, document.text()))
}

/// What becomes of a document when its scene is edited.
fn edited(text: &str, edit: impl FnOnce(&mut Scene)) -> String {
    let document = document(text.as_bytes());
    let mut scene = scene_of(&document);
    assert_eq!(String::from_utf8(patch_scene(&document, &scene)).unwrap(), text, "unedited");
    edit(&mut scene);
    let patched = String::from_utf8(patch_scene(&document, &scene)).unwrap();
    assert_eq!(scene_of(&self::document(patched.as_bytes())), scene, "{patched}");
    patched
}

fn object(scene: &mut Scene, index: usize, edit: impl FnOnce(&mut Object)) {
    scene.objects = scene.objects.with(|objects| edit(Arc::make_mut(&mut objects[index])));
}

const SAMPLE: &str = r#"<?xml version='1.0'?>
<!-- my scene -->
<scene   version="1">

  <!-- the light comes first here -->
  <light position = "0 5 0"/> <!-- a lamp -->
  <material name='red'  ka="0.4 0 0"/>	<!-- tab -->
  <sphere name="ball" center="0,0, 0"
          radius="1.0" material="red"/>

  <sphere center="2 0 0" radius="1"><!-- inside --></sphere><cube center="0 0 0" edge="1"/>
</scene>
"#;

#[test]
fn a_value_is_changed_in_place() {
    let patched = edited(SAMPLE, |scene| {
        object(scene, 0, |ball| ball.shape = Shape::Sphere { center: DVec3::ZERO, radius: 0.25 });
    });
    assert_eq!(patched, SAMPLE.replace("radius=\"1.0\" material", "radius=\"0.25\" material"));
    let patched = edited(SAMPLE, |scene| {
        scene.materials = scene.materials.with(|materials| {
            Arc::make_mut(&mut materials[0]).surface.ka = Rgb::splat(0.5);
        });
    });
    assert_eq!(patched, SAMPLE.replace("ka=\"0.4 0 0\"", "ka=\"0.5\""));
}

/// Whatever the encoding, the mark and the line ends, one value's bytes are all that changes.
#[test]
fn a_value_is_changed_in_place_in_every_encoding() {
    let text = "<?xml version=\"1.0\" encoding='UTF-8'?>\n<!-- HERE -->\n<scene version=\"1\" name=\"HERE\">\n\t<sphere\n  \
                center='0,0,0' radius = '1.0'  name=\"HERE\"/>\n</scene>\n\n";
    let mut tried = 0;
    for line_end in ["\n", "\r\n", "\r"] {
        for here in ["été", "plain", "10 €", "漢字 🔺"] {
            for encoding in ENCODINGS {
                let text = text.replace('\n', line_end).replace("HERE", here);
                let Some(bytes) = encoded(&text, encoding) else { continue };
                let document = document(&bytes);
                let mut scene = scene_of(&document);
                object(&mut scene, 0, |ball| ball.shape = Shape::Sphere { center: DVec3::ZERO, radius: 0.25 });
                let expected = encoded(&text.replace("'1.0'", "'0.25'"), encoding).unwrap();
                assert_eq!(patch_scene(&document, &scene), expected, "{encoding:?} {line_end:?} {here}");
                tried += 1;
            }
        }
    }
    assert_eq!(tried, 3 * (7 + 8 + 6 + 4));
}

#[test]
fn attributes_come_and_go_in_their_order() {
    let patched = edited(SAMPLE, |scene| {
        object(scene, 0, |ball| (ball.visible, ball.material) = (false, MaterialRef::Default));
        scene.name = "<b> & 'c'".into();
    });
    let expected = SAMPLE.replace(" material=\"red\"/>", " visible=\"false\"/>");
    assert_eq!(patched, expected.replace("version=\"1\">", "version=\"1\" name=\"&lt;b&gt; &amp; 'c'\">"));
    let patched = edited(SAMPLE, |scene| {
        scene.materials = scene.materials.with(|materials| {
            let material = Arc::make_mut(&mut materials[0]);
            (material.surface.kd, material.name) = (Rgb::splat(0.1), "it's".into());
        });
        object(scene, 0, |ball| ball.material = MaterialRef::Named("it's".into()));
    });
    let expected = SAMPLE.replace("'red'  ka=\"0.4 0 0\"", "'it&apos;s'  ka=\"0.4 0 0\" kd=\"0.1\"");
    assert_eq!(patched, expected.replace("material=\"red\"", "material=\"it's\""));
}

#[test]
fn elements_come_go_and_move() {
    let removed = edited(SAMPLE, |scene| scene.objects = scene.objects.with(|objects| drop(objects.remove(0))));
    // The second sphere was `sphere 1` and still is: its name needs not be written.
    let expected =
        SAMPLE.replace("  <sphere name=\"ball\" center=\"0,0, 0\"\n          radius=\"1.0\" material=\"red\"/>\n", "");
    assert_eq!(removed, expected);
    let inserted = edited(SAMPLE, |scene| {
        let lamp = PointLight::new("lamp", DVec3::X);
        scene.lights = scene.lights.with(|lights| lights.insert(0, Arc::new(lamp)));
        let eye = Object::new("eye", Shape::Sphere { center: DVec3::ZERO, radius: 3.0 });
        scene.objects = scene.objects.with(|objects| objects.push(Arc::new(eye)));
    });
    let expected = SAMPLE.replace("  <light", "  <light name=\"lamp\" position=\"1 0 0\"/>\n  <light");
    let cube = "<cube center=\"0 0 0\" edge=\"1\"/>\n";
    assert_eq!(
        inserted,
        expected.replace(cube, &format!("{cube}<sphere name=\"eye\" center=\"0 0 0\" radius=\"3\"/>\n"))
    );
    let moved = edited(SAMPLE, |scene| scene.objects = scene.objects.with(|objects| objects.rotate_left(1)));
    assert!(moved.contains("</sphere><cube center=\"0 0 0\" edge=\"1\"/>\n<sphere name=\"ball\" center=\"0,0, 0\"\n          radius=\"1.0\" material=\"red\"/>\n</scene>"), "{moved}");
}

#[test]
fn automatic_names_are_written_where_they_would_change() {
    let text = "<scene version=\"1\">\n<sphere center=\"0 0 0\" radius=\"1\"/>\n<sphere center=\"1 0 0\" radius=\"1\"/>\n</scene>\n";
    let patched = edited(text, |scene| scene.objects = scene.objects.with(|objects| drop(objects.remove(0))));
    assert_eq!(patched, "<scene version=\"1\">\n<sphere name=\"sphere 2\" center=\"1 0 0\" radius=\"1\"/>\n</scene>\n");
    let patched = edited(text, |scene| {
        object(scene, 0, |first| first.name = "sphere 9".into());
    });
    assert_eq!(
        patched,
        text.replacen("<sphere", "<sphere name=\"sphere 9\"", 1)
            .replace("<sphere center=\"1", "<sphere name=\"sphere 2\" center=\"1")
    );
}

#[test]
fn materials_become_inline_and_back() {
    let text = "<scene version=\"1\">\r\n  <sphere center=\"0 0 0\" radius=\"1\" />\r\n</scene>\r\n";
    let glass = Surface { kt: Rgb::WHITE, ..Surface::default() };
    let inline = edited(text, |scene| object(scene, 0, |ball| ball.material = MaterialRef::Inline(Arc::new(glass))));
    let child = "  <sphere center=\"0 0 0\" radius=\"1\">\r\n    <material kt=\"1\"/>\r\n  </sphere>\r\n";
    assert_eq!(inline, text.replace("  <sphere center=\"0 0 0\" radius=\"1\" />\r\n", child));
    let back = edited(&inline, |scene| object(scene, 0, |ball| ball.material = MaterialRef::Default));
    assert_eq!(back, inline.replace("    <material kt=\"1\"/>\r\n", ""));
}

#[test]
fn empty_elements_are_opened() {
    let lamp = |scene: &mut Scene| scene.lights = [PointLight::new("lamp", DVec3::X)].into_iter().collect();
    let line = "  <light name=\"lamp\" position=\"1 0 0\"/>\n";
    assert_eq!(edited("<scene version='1'/>", lamp), format!("<scene version='1'>\n{line}</scene>"));
    assert_eq!(edited("<scene version='1'></scene>", lamp), format!("<scene version='1'>\n{line}</scene>"));
    let commented = "<scene version='1'>\n  <!-- nothing -->\n</scene>";
    assert_eq!(edited(commented, lamp), format!("<scene version='1'>\n  <!-- nothing -->\n{line}</scene>"));
    let world = edited(commented, |scene| scene.world.depth = 3);
    assert_eq!(world, "<scene version='1'>\n  <!-- nothing -->\n  <world depth=\"3\"/>\n</scene>");
}

#[test]
fn only_the_changed_list_of_a_mesh_is_written_anew() {
    let text = "<scene version=\"1\">\n  <mesh>\n    <vertices>0 0 0, 1 0 0, 0 1 0</vertices>\n    <facets>0, 1, 2</facets>\n  </mesh>\n</scene>\n";
    let patched = edited(text, |scene| {
        object(scene, 0, |mesh| {
            let Shape::Mesh(mesh) = &mut mesh.shape else { panic!("no mesh") };
            Arc::make_mut(&mut mesh.geometry).positions[1].x = 2.0;
        });
    });
    assert_eq!(patched, text.replace("0 0 0, 1 0 0, 0 1 0", "0 0 0  2 0 0  0 1 0"));
}

#[test]
fn a_mesh_file_stays_a_path() {
    let text = "<scene version=\"1\"><mesh src=\"a.obj\" scale=\"2\"/></scene>";
    let patched = edited(text, |scene| object(scene, 0, |mesh| mesh.visible = false));
    assert_eq!(patched, "<scene version=\"1\"><mesh src=\"a.obj\" scale=\"2\" visible=\"false\"/></scene>");
}

#[test]
fn what_the_encoding_lacks_becomes_a_reference() {
    let text = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<scene version=\"1\" name=\"\u{E9}\"/>\n";
    let latin: Vec<u8> = text.chars().map(|character| character as u8).collect();
    let document = document(&latin);
    let scene = Scene { name: "é€".into(), ..scene_of(&document) };
    let patched = patch_scene(&document, &scene);
    assert!(patched.windows(9).any(|bytes| bytes == b"\xE9&#8364;\""), "{}", String::from_utf8_lossy(&patched));
    assert_eq!(scene_of(&self::document(&patched)), scene);
}

#[test]
fn views_are_patched() {
    let text = "<views version=\"1\">\n  <!-- one -->\n  <view  name='front' ><eye at=\"0 1 5\" look-at=\"0 0 0\" fov=\"30\"/></view>\n</views>";
    let document = document(text.as_bytes());
    let views = read_views(&document).value.unwrap();
    assert_eq!(patch_views(&document, &views), text.as_bytes());
    let mut view = (*views[0]).clone();
    view.width = 100;
    view.screen = lancer_scene::ScreenSpec::Centered { center: DVec3::ZERO, size: [4.0, 3.0], up: DVec3::Y };
    let patched = patch_views(&document, &[view].into_iter().collect());
    assert_eq!(
        String::from_utf8(patched).unwrap(),
        text.replace("'front'", "'front' width=\"100\"")
            .replace(" look-at=\"0 0 0\" fov=\"30\"/>", "/>\n    <screen center=\"0 0 0\" size=\"4 3\"/>")
    );
    let bare = "<view version='1'><eye at='0 1 5' look-at='0 0 0'/></view>";
    let document = self::document(bare.as_bytes());
    let mut view = (*read_views(&document).value.unwrap()[0]).clone();
    view.eye = DVec3::Z;
    let patched = patch_views(&document, &[view].into_iter().collect());
    assert_eq!(String::from_utf8(patched).unwrap(), bare.replace("0 1 5", "0 0 1"));
}

#[test]
fn what_cannot_be_patched_is_written_anew() {
    let broken = document(b"<scene version='1'><teapot/></scene>");
    assert_eq!(patch_scene(&broken, &Scene::default()), write_scene(&Scene::default()).into_bytes());
}

/// A document as people write it, from one in the canonical layout.
fn messy(canonical: &str, choices: &[u8], comments: bool) -> String {
    let mut choice = choices.iter().cycle().copied();
    let mut next = || choice.next().unwrap_or_default();
    let mut lines: Vec<String> = canonical.lines().map(str::to_owned).collect();
    let last = lines.len() - 1;
    for (number, line) in lines.iter_mut().enumerate() {
        let within = number > 1 && number < last;
        match next() % 16 {
            0 if comments && within => *line = format!("  <!-- remark {number} -->\n{line}"),
            1 if comments && within => *line = format!("{line}   <!-- after {number} -->"),
            2 if within => *line = line.replacen("  ", "\t", 1),
            3 if !line.contains('\'') => {
                if let Some((before, after)) = line.split_once("name=\"")
                    && let Some((name, after)) = after.split_once('"')
                {
                    *line = format!("{before}name='{name}'{after}");
                }
            }
            4 if within => *line = line.trim_start().to_owned(),
            5 => *line = line.replace("=\"", " = \""),
            // Names of objects can be left out; other things need theirs.
            6 | 7 if within && !line.contains("<material") && !line.contains("<view") => {
                if let (Some(start), true) = (line.find(" name=\""), line.starts_with("  <")) {
                    let end = line[start + 7..].find('"').map(|length| start + 8 + length);
                    line.replace_range(start..end.unwrap_or(start), "");
                }
            }
            _ => {}
        }
    }
    let mut text = String::new();
    for line in &lines {
        text.push_str(line);
        // Sometimes two elements share a line.
        let apart = next() % 11 != 0 || line.ends_with("?>");
        text.push_str(if apart {
            "\n"
        } else if line.ends_with('>') {
            ""
        } else {
            " "
        });
    }
    if next() % 3 == 0 { text.replace('\n', "\r\n") } else { text }
}

/// The encodings that are read, each by the name that a document declares, and with its mark if it has one.
const ENCODINGS: [(&str, &[u8]); 8] = [
    ("UTF-8", b""),
    ("UTF-8", b"\xEF\xBB\xBF"),
    ("UTF-16", b"\xFF\xFE"),
    ("UTF-16", b"\xFE\xFF"),
    ("ISO-8859-1", b""),
    ("windows-1252", b""),
    ("ISO-8859-15", b""),
    ("US-ASCII", b""),
];

/// A text that declares UTF-8 in another encoding; `None` if that does not have its characters.
fn encoded(text: &str, (name, mark): (&str, &[u8])) -> Option<Vec<u8>> {
    let text = text.replacen("UTF-8", name, 1);
    let narrow =
        |last: u32| text.chars().map(|c| u8::try_from(u32::from(c)).ok().filter(|_| u32::from(c) <= last)).collect();
    let bytes: Option<Vec<u8>> = match (name, mark) {
        ("UTF-16", b"\xFF\xFE") => Some(text.encode_utf16().flat_map(u16::to_le_bytes).collect()),
        ("UTF-16", _) => Some(text.encode_utf16().flat_map(u16::to_be_bytes).collect()),
        ("ISO-8859-1", _) => narrow(0xFF),
        ("US-ASCII", _) => narrow(0x7F),
        // both have the euro, and each where the other has none
        ("windows-1252", _) => text.chars().map(|c| if c == '€' { Some(0x80) } else { latin(c) }).collect(),
        ("ISO-8859-15", _) => text.chars().map(|c| if c == '€' { Some(0xA4) } else { latin(c) }).collect(),
        _ => Some(text.into_bytes()),
    };
    Some([mark, &bytes?].concat())
}

/// The text in one of the encodings that have its characters.
fn in_some_encoding(text: &str, choice: u8) -> Vec<u8> {
    let encodings = ENCODINGS.iter().cycle().skip(usize::from(choice));
    let mut encoded = encodings.take(ENCODINGS.len()).filter_map(|encoding| encoded(text, *encoding));
    encoded.next().unwrap_or_else(|| text.as_bytes().to_vec())
}

/// A character that every Latin encoding has in the same place.
fn latin(character: char) -> Option<u8> {
    u8::try_from(character).ok().filter(|byte| byte.is_ascii() || *byte >= 0xC0)
}

/// One edit of a scene, with the parts of another at hand.
type Edit = (u8, Index, Index);

fn with_edit(scene: &Scene, other: &Scene, (kind, from, to): &Edit) -> Scene {
    let mut next = scene.clone();
    // an object of the other scene, with materials that this one has
    let foreign = |at: &Index| {
        let mut object = (!other.objects.is_empty()).then(|| (**at.get(&other.objects)).clone())?;
        let mut place = at.index(5);
        let mut another = || {
            place += 1;
            scene
                .materials
                .get(place - 1)
                .map_or(MaterialRef::Default, |material| MaterialRef::Named(material.name.clone()))
        };
        object.material = another();
        if let Shape::Mesh(mesh) = &mut object.shape {
            let parts = &mut Arc::make_mut(&mut mesh.geometry).parts;
            parts.iter_mut().filter(|part| part.material.name().is_some()).for_each(|part| part.material = another());
        }
        Some(Arc::new(object))
    };
    match kind % 12 {
        0 => next.name.clone_from(&other.name),
        1 => next.world = other.world.clone(),
        2 if !scene.objects.is_empty() => {
            next.objects = scene.objects.with(|objects| drop(objects.remove(from.index(scene.objects.len()))));
        }
        3 if !scene.objects.is_empty() => {
            next.objects = scene.objects.with(|objects| {
                let object = objects.remove(from.index(scene.objects.len()));
                objects.insert(to.index(scene.objects.len()), object);
            })
        }
        4 | 5 => next.objects = scene.objects.with(|objects| objects.splice(0..0, foreign(to)).for_each(drop)),
        6 => next.objects = scene.objects.with(|objects| objects.extend(foreign(to))),
        7 if !scene.objects.is_empty() => {
            next.objects = scene.objects.with(|objects| {
                let index = from.index(objects.len());
                if let Some(object) = foreign(to) {
                    objects[index] = Arc::new(Object { name: objects[index].name.clone(), ..(*object).clone() });
                }
            })
        }
        8 if !scene.objects.is_empty() => {
            next.objects = scene.objects.with(|objects| {
                let index = from.index(objects.len());
                Arc::make_mut(&mut objects[index]).name = format!("sphere {}", to.index(4)).into();
            })
        }
        9 if !other.lights.is_empty() => {
            next.lights = scene.lights.with(|lights| {
                lights.insert(to.index(lights.len() + 1), Arc::clone(from.get(&other.lights)));
            })
        }
        10 if !scene.lights.is_empty() => {
            next.lights = scene.lights.with(|lights| {
                let index = from.index(lights.len());
                let light = lights.remove(index);
                if to.index(2) == 0 {
                    lights.push(light);
                }
            })
        }
        11 if !other.materials.is_empty() => {
            next.materials = scene.materials.with(|materials| {
                materials.insert(to.index(materials.len() + 1), Arc::clone(from.get(&other.materials)));
            })
        }
        _ if !scene.materials.is_empty() => {
            next.materials = scene.materials.with(|materials| {
                let index = from.index(materials.len());
                let surface = other.materials.first().map(|material| material.surface.clone()).unwrap_or_default();
                Arc::make_mut(&mut materials[index]).surface = surface;
            })
        }
        _ => {}
    }
    // An edit that breaks a rule is no edit.
    if next.check().is_ok() { next } else { scene.clone() }
}

/// The texts of the comments in a document.
fn comments(document: &Document) -> Vec<String> {
    let text = document.text();
    let comments = document.root().children().filter(|node| matches!(node, Node::Comment(_)));
    comments.map(|comment| text[comment.span().start..comment.span().end].to_owned()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn whatever_is_edited_reads_back_and_the_rest_stays(
        scene in scene(Extent::SelfContained),
        other in scene(Extent::SelfContained),
        choices in prop::collection::vec(any::<u8>(), 1..40),
        edits in prop::collection::vec(any::<Edit>(), 0..6),
    ) {
        let bytes = in_some_encoding(&messy(&write_scene(&scene), &choices, true), choices[0]);
        let document = document(&bytes);
        let base = scene_of(&document);
        prop_assert_eq!(patch_scene(&document, &base), bytes, "unedited");

        let target = edits.iter().fold(base.clone(), |scene, edit| with_edit(&scene, &other, edit));
        let patched = self::document(&patch_scene(&document, &target));
        prop_assert_eq!(scene_of(&patched), target.clone(), "\n{}\nbecame\n{}", document.text(), patched.text());
        for comment in comments(&document) {
            prop_assert!(patched.text().contains(&comment), "{} is lost in\n{}", comment, patched.text());
        }
        // The elements of what has not changed, with names of their own, stand as they stood.
        for element in document.root().elements() {
            let name = element.attribute("name").map(|name| name.value().into_owned());
            let kept = name.is_some_and(|name| match element.name() {
                "material" => base.material(&name) == target.material(&name),
                "light" => {
                    let light = |scene: &Scene| scene.lights.iter().find(|light| *light.name == *name).cloned();
                    light(&base) == light(&target)
                }
                _ => {
                    let object = |scene: &Scene| scene.objects.iter().find(|object| *object.name == *name).cloned();
                    object(&base) == object(&target)
                }
            });
            let span = element.span();
            let own = &document.text()[span.start..span.end];
            prop_assert!(!kept || patched.text().contains(own), "{}\nis lost in\n{}", own, patched.text());
        }
    }

    /// One attribute comes, goes or changes: all bytes but those of its element's start tag stay.
    #[test]
    fn an_attribute_changes_its_own_tag_alone(
        scene in scene(Extent::SelfContained),
        choices in prop::collection::vec(any::<u8>(), 1..40),
        at in any::<Index>(),
    ) {
        let bytes = in_some_encoding(&messy(&write_scene(&scene), &choices, true), choices[0]);
        let document = document(&bytes);
        let mut scene = scene_of(&document);
        prop_assume!(!scene.objects.is_empty());
        let index = at.index(scene.objects.len());
        object(&mut scene, index, |object| object.visible = !object.visible);
        let patched = self::document(&patch_scene(&document, &scene));
        prop_assert_eq!(patched.encoding(), document.encoding());
        let is_object = |element: &lancer_formats::xml::Element<'_>| !matches!(element.name(), "world" | "material" | "light");
        let tag = document.root().elements().filter(is_object).nth(index).unwrap().start_tag();
        let (old, new) = (document.text(), patched.text());
        prop_assert!(new.starts_with(&old[..tag.start]) && new.ends_with(&old[tag.end..]), "{old}\nbecame\n{new}");
    }

    #[test]
    fn whatever_is_edited_in_views_reads_back(
        views in views(),
        other in views(),
        choices in prop::collection::vec(any::<u8>(), 1..40),
        places in prop::collection::vec(any::<Index>(), 0..5),
    ) {
        let bytes = in_some_encoding(&messy(&write_views(&views), &choices, true), choices[0]);
        let document = document(&bytes);
        let base = read_views(&document).value.unwrap_or_else(|| panic!("{}", document.text()));
        prop_assert_eq!(patch_views(&document, &base), bytes, "unedited");
        let mut all: Vec<_> = base.iter().chain(other.iter()).cloned().collect();
        let mut target: Vec<_> = Vec::new();
        for place in places {
            if !all.is_empty() {
                let view = all.remove(place.index(all.len()));
                if target.iter().all(|taken: &Arc<lancer_scene::View>| taken.name != view.name) {
                    target.push(view);
                }
            }
        }
        // A view that has become another one under its old name.
        if let (Some(old), Some(new)) = (base.first(), other.last()) && target.iter().all(|taken| taken.name != old.name) {
            target.push(Arc::new(lancer_scene::View { name: old.name.clone(), ..(**new).clone() }));
        }
        let target: Views = target.into_iter().collect();
        let patched = self::document(&patch_views(&document, &target));
        let read = read_views(&patched).value.unwrap_or_else(|| panic!("{}", patched.text()));
        prop_assert_eq!(read, target, "\n{}\nbecame\n{}", document.text(), patched.text());
    }
}
