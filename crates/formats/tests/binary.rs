//! Binary scenes: exact, compact, shared, readable for ever, and refused whenever a byte is wrong.

#![allow(clippy::unwrap_used, clippy::panic, reason = "the helpers of tests may panic")]

#[path = "../../scene/tests/arbitrary/mod.rs"]
mod arbitrary;

use arbitrary::{Extent, scene};
use lancer_formats::Describe;
use lancer_formats::binary::{BinaryProblem, is_binary, read_scene, write_scene};
use lancer_formats::load::{FolderOfDocument, LoadOptions, load_scene};
use lancer_formats::xml::{self, Document};
use lancer_scene::{
    DVec3, Edit, Invalid, ListEdit, Mesh, MeshGeometry, Object, Placement, PointLight, Rgb, Scene, Shape, Stage,
};
use lancer_words::Lang;
use proptest::prelude::*;
use std::path::Path;
use std::sync::Arc;

/// One sphere, one lamp and a mesh of one facet.
fn small_scene() -> Scene {
    let geometry = MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
        facets: vec![[0, 1, 2]],
        ..MeshGeometry::default()
    };
    Scene {
        name: "Petite scène".into(),
        lights: [PointLight::new("lamp", DVec3::new(-2.0, 3.0, 0.1))].into_iter().collect(),
        objects: [
            Object::new("ball", Shape::Sphere { center: DVec3::new(0.0, 0.5, -0.0), radius: 0.5 }),
            Object::new("flag", mesh(&Arc::new(geometry), DVec3::ZERO)),
        ]
        .into_iter()
        .collect(),
        ..Scene::default()
    }
}

fn mesh(geometry: &Arc<MeshGeometry>, position: DVec3) -> Shape {
    let placement = Placement { position, ..Placement::default() };
    Shape::Mesh(Mesh { geometry: Arc::clone(geometry), source: None, placement, smooth: false })
}

fn read_xml(text: &str) -> Scene {
    let document = Document::read("scene.xml", text.as_bytes()).unwrap();
    let mut no_files = FolderOfDocument::new(Path::new("scene.xml"), LoadOptions::default());
    let outcome = xml::read_scene(&document, &mut no_files);
    outcome.value.unwrap_or_else(|| panic!("{:?}\n{text}", outcome.diagnostics))
}

/// The file with the bytes changed and then length and checksum made right again, as a hostile writer would.
fn forged(change: impl FnOnce(&mut Vec<u8>)) -> Vec<u8> {
    let mut file = write_scene(&small_scene());
    change(&mut file);
    let length = file.len() as u64;
    file[16..24].copy_from_slice(&length.to_le_bytes());
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&file[..12]);
    hasher.update(&file[16..]);
    let checksum = hasher.finalize();
    file[12..16].copy_from_slice(&checksum.to_le_bytes());
    file
}

/// The place of some bytes that the file holds once.
fn find(file: &[u8], bytes: &[u8]) -> usize {
    file.windows(bytes.len()).position(|window| window == bytes).unwrap()
}

proptest! {
    #[test]
    fn reading_gives_back_what_was_written(scene in scene(Extent::Whole)) {
        let file = write_scene(&scene);
        let read = read_scene(&file).unwrap();
        prop_assert_eq!(&read, &scene);
        // To the last bit, the sign of zeros included, which the equality of numbers does not see.
        prop_assert_eq!(write_scene(&read), file);
    }

    /// XML → binary → XML is the identity on the model, and so is XML itself on what it can hold.
    #[test]
    fn xml_and_binary_are_one_model(scene in scene(Extent::SelfContained)) {
        let text = xml::write_scene(&scene);
        let from_xml = read_xml(&text);
        prop_assert_eq!(&from_xml, &scene);
        let from_binary = read_scene(&write_scene(&from_xml)).unwrap();
        prop_assert_eq!(&from_binary, &scene);
        prop_assert_eq!(xml::write_scene(&from_binary), text);
    }

    #[test]
    fn no_bytes_behind_a_right_checksum_make_the_reader_panic(at in any::<prop::sample::Index>(), bytes: [u8; 4]) {
        let file = forged(|file| {
            let at = 24 + at.index(file.len() - 28);
            file[at..at + 4].copy_from_slice(&bytes);
        });
        if let Ok(scene) = read_scene(&file) {
            prop_assert_eq!(scene.check(), Ok(()));
        }
    }
}

/// Every scene that the project shows comes back through the binary format.
#[test]
fn the_scenes_of_the_project_come_back() {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let mut count = 0;
    for folder in std::fs::read_dir(scenes).unwrap() {
        let folder = folder.unwrap().path();
        for path in std::fs::read_dir(&folder).into_iter().flatten().map(|entry| entry.unwrap().path()) {
            let name = path.to_string_lossy();
            if name.ends_with(".xml") && !name.ends_with(".view.xml") {
                let scene = load_scene(&path, &LoadOptions::default()).unwrap().value.unwrap();
                assert_eq!(read_scene(&write_scene(&scene)), Ok(scene), "{name}");
                count += 1;
            }
        }
    }
    assert!(count >= 12, "only {count} scenes");
}

#[test]
fn a_file_cut_anywhere_is_refused() {
    let file = write_scene(&small_scene());
    for length in 0..file.len() {
        let problem = read_scene(&file[..length]).unwrap_err();
        let found = length as u64;
        let expected = if length < 24 { 24 } else { file.len() as u64 };
        if length == 0 {
            assert_eq!(problem, BinaryProblem::NotBinaryScene);
        } else {
            assert_eq!(problem, BinaryProblem::Cut { found, expected });
        }
    }
    let mut longer = file.clone();
    longer.push(0);
    let (found, expected) = (longer.len() as u64, file.len() as u64);
    assert_eq!(read_scene(&longer), Err(BinaryProblem::TooLong { found, expected }));
}

#[test]
fn a_file_with_any_bit_flipped_is_refused() {
    let mut file = write_scene(&small_scene());
    for bit in 0..8 * file.len() {
        file[bit / 8] ^= 1 << (bit % 8);
        let problem = read_scene(&file).unwrap_err();
        let expected = match bit {
            7 => BinaryProblem::TransferredAsText,
            0..64 => BinaryProblem::NotBinaryScene,
            64..128 | 192.. => BinaryProblem::Damaged,
            128..192 => {
                let expected = u64::from_le_bytes(file[16..24].try_into().unwrap());
                let found = file.len() as u64;
                if found < expected {
                    BinaryProblem::Cut { found, expected }
                } else {
                    BinaryProblem::TooLong { found, expected }
                }
            }
        };
        assert_eq!(problem, expected, "bit {bit}");
        file[bit / 8] ^= 1 << (bit % 8);
    }
    assert_eq!(read_scene(&file), Ok(small_scene()));
}

#[test]
fn transfers_as_text_are_told_from_other_damage() {
    let file = write_scene(&small_scene());
    let replaced = |from: &[u8], to: &[u8]| {
        let mut out = Vec::new();
        let mut rest = file.as_slice();
        while let Some(at) = rest.windows(from.len()).position(|window| window == from) {
            out.extend_from_slice(&rest[..at]);
            out.extend_from_slice(to);
            rest = &rest[at + from.len()..];
        }
        out.extend_from_slice(rest);
        out
    };
    let lone_line_feeds: Vec<u8> = replaced(b"\r\n", b"\n");
    let to_dos = {
        let mut out = Vec::new();
        for (at, &byte) in file.iter().enumerate() {
            if byte == b'\n' && (at == 0 || file[at - 1] != b'\r') {
                out.push(b'\r');
            }
            out.push(byte);
        }
        out
    };
    let damaged = [
        ("line ends of Unix", lone_line_feeds),
        ("line ends of DOS, naively", replaced(b"\n", b"\r\n")),
        ("line ends of DOS", to_dos),
        ("line ends of old Macs", replaced(b"\r\n", b"\r")),
        ("seven bits", file.iter().map(|byte| byte & 0x7f).collect()),
        ("Latin-1 to UTF-8", file.iter().map(|&byte| char::from(byte)).collect::<String>().into_bytes()),
        ("lossy UTF-8", String::from_utf8_lossy(&file).into_owned().into_bytes()),
    ];
    for (how, bytes) in damaged {
        assert!(is_binary(&bytes), "{how}");
        assert_eq!(read_scene(&bytes), Err(BinaryProblem::TransferredAsText), "{how}");
    }
    assert!(is_binary(&file));
    assert!(!is_binary(b"<scene version=\"1\"/>") && !is_binary(b"") && !is_binary(b"\x89PNG\r\n\x1a\n"));
}

#[test]
fn a_newer_version_asks_for_a_newer_lancer() {
    let newer = read_scene(&forged(|file| file[8] = 3)).unwrap_err();
    assert_eq!(newer, BinaryProblem::UnknownVersion { found: 3 });
    assert_eq!(
        newer.message(Lang::English),
        "this file needs a newer lancer: it has version 3, and this program reads up to version 2"
    );
    let none = read_scene(&forged(|file| file[8] = 0)).unwrap_err();
    assert_eq!(none.message(Lang::English), "there is no version 0 of the format");
}

/// The lengths of arrays are believed only as far as the file holds them.
#[test]
fn hostile_lengths_take_no_memory() {
    for (key, count) in [("vertices", 3_u8), ("facets", 1)] {
        let file = forged(|file| {
            let at = find(file, &[key.as_bytes(), &[count]].concat()) + key.len();
            // CBOR: an unsigned number of eight bytes.
            file.splice(at..=at, [0x1b, 0x0f, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff]);
        });
        let problem = read_scene(&file).unwrap_err();
        let detail = "an array of 1152921504606846975 items does not fit in the file".to_owned();
        assert_eq!(problem, BinaryProblem::Malformed { detail });
    }
    // A list of 2⁶⁰ objects, a name of 2⁶⁰ bytes, a million nested arrays.
    let long: [&[u8]; 3] = [&[0x9b, 0x10, 0, 0, 0, 0, 0, 0, 0], &[0x7b, 0x10, 0, 0, 0, 0, 0, 0, 0], &[0x81; 1_000_000]];
    for bytes in long {
        let file = forged(|file| {
            let at = find(file, b"gobjects") + 8;
            file.splice(at..at + 1, bytes.iter().copied());
        });
        assert!(matches!(read_scene(&file), Err(BinaryProblem::Malformed { .. })));
    }
}

#[test]
fn a_whole_file_with_a_wrong_scene_says_what_is_wrong() {
    let radius = read_scene(&forged(|file| {
        let at = find(file, b"fradius") + 7;
        // CBOR: 0.5 as a number of two bytes; its sign is the first bit.
        file[at + 1] ^= 0x80;
    }));
    let rule = Invalid::OutOfRange { field: "radius", value: -0.5, min: 1e-9, max: 1e9 };
    assert_eq!(radius, Err(BinaryProblem::Invalid { name: Some("ball".into()), rule }));

    let key = read_scene(&forged(|file| {
        let at = find(file, b"fradius") + 1;
        file[at] = b'R';
    }));
    let detail = "unknown field `Radius`, expected `center` or `radius`".to_owned();
    assert_eq!(key, Err(BinaryProblem::Malformed { detail }));

    let behind = read_scene(&forged(|file| file.extend_from_slice(b"more")));
    assert_eq!(behind, Err(BinaryProblem::Malformed { detail: "4 bytes follow the last array".into() }));

    let geometry = read_scene(&forged(|file| {
        let at = find(file, b"hgeometry\0") + 9;
        file[at] = 1;
    }));
    assert_eq!(geometry, Err(BinaryProblem::Malformed { detail: "there is no geometry 1".into() }));
}

#[test]
fn shared_geometry_stands_once_and_is_shared_again() {
    let geometry = Arc::new(MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
        facets: vec![[0, 1, 2]; 10_000],
        ..MeshGeometry::default()
    });
    let flags = (0..20_u32).map(|at| Object::new(format!("flag {at}"), mesh(&geometry, DVec3::X * f64::from(at))));
    let scene = Scene { objects: flags.collect(), ..Scene::default() };
    let file = write_scene(&scene);
    assert!(file.len() < 125_000, "{}", file.len());
    let read = read_scene(&file).unwrap();
    assert_eq!(read, scene);
    let geometries: Vec<_> = read.objects.iter().map(|object| Arc::as_ptr(object.shape.geometry().unwrap())).collect();
    assert!(geometries.windows(2).all(|pair| pair[0] == pair[1]));
}

/// `tests/binary/version1.lancer` was written once. It must be read for ever, and must not be written again.
#[test]
fn the_stored_file_of_version_1_is_read() {
    let read = read_scene(include_bytes!("binary/version1.lancer")).unwrap();
    assert_eq!(read, version1());
}

fn version1() -> Scene {
    use lancer_scene::{Compose, Environment, Highlight, Material, MaterialRef, Part, Reflectance, Surface};
    let glass = Surface {
        ka: Rgb::splat(0.05),
        kd: Rgb::new(0.05, 0.1, 0.15),
        ks: Rgb::splat(0.2),
        w: Reflectance::Schlick,
        shininess: Rgb::splat(125.0),
        kr: Rgb::splat(0.15),
        kt: Rgb::splat(0.95),
        index: Rgb::new(1.5, 1.51, 1.53),
        highlight: Highlight::Blinn,
    };
    let metal = Arc::new(Surface { w: Reflectance::Grazing, kr: Rgb::splat(0.78), ..Surface::default() });
    let geometry = Arc::new(MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Z, DVec3::Y],
        normals: vec![DVec3::NEG_X, DVec3::X, DVec3::Z, DVec3::Y],
        facets: vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]],
        parts: vec![
            Part { material: MaterialRef::Named("glass".into()), first: 0, count: 1 },
            Part { material: MaterialRef::Inline(Arc::clone(&metal)), first: 2, count: 2 },
        ],
    });
    let pyramid = |source: Option<&str>, smooth| {
        Shape::Mesh(Mesh {
            geometry: Arc::clone(&geometry),
            source: source.map(Arc::from),
            placement: Placement {
                scale: DVec3::new(1.0, -2.0, 0.1),
                rotation: DVec3::new(0.0, 180.0, 0.0),
                position: DVec3::new(0.0, 0.0, 2.0),
            },
            smooth,
        })
    };
    let (p0, p1, p2) = (DVec3::ZERO, DVec3::Z, DVec3::X);
    let object = |name: &str, material, visible, shape| Object { name: name.into(), material, visible, shape };
    Scene {
        name: "Version 1, née en 2026".into(),
        world: Environment {
            ambient: Rgb::new(0.12, 0.12, 0.16),
            background: Rgb::new(0.05, 0.06, 0.1),
            index: Rgb::splat(1.000_3),
            depth: 9,
            compose: Compose::ScreenEach,
        },
        materials: [Material { name: "glass".into(), surface: glass }].into_iter().collect(),
        lights: [
            PointLight::new("key", DVec3::new(-2.0, 3.0, 2.0)),
            PointLight { color: Rgb::new(0.1, 0.2, 0.3), visible: false, ..PointLight::new("fill", DVec3::ONE) },
        ]
        .into_iter()
        .collect(),
        objects: [
            object(
                "ball",
                MaterialRef::Named("glass".into()),
                true,
                Shape::Sphere { center: DVec3::new(0.0, 0.5, 0.0), radius: 0.5 },
            ),
            object("floor", MaterialRef::Default, true, Shape::Plane { p0, p1, p2 }),
            object("flag", MaterialRef::Inline(metal), false, Shape::Facet { p0, p1, p2 }),
            object(
                "die",
                MaterialRef::Default,
                true,
                Shape::Cube { center: DVec3::ONE, edge: 0.5, rotation: DVec3::new(0.0, 30.0, 0.0) },
            ),
            object(
                "slab",
                MaterialRef::Default,
                true,
                Shape::Parallelepiped { origin: DVec3::X, edges: [DVec3::X, DVec3::Y * 0.2, DVec3::Z * 3.0] },
            ),
            object("pyramid", MaterialRef::Default, true, pyramid(None, false)),
            object("twin", MaterialRef::Named("glass".into()), true, pyramid(Some("pyramid.obj"), true)),
        ]
        .into_iter()
        .collect(),
    }
}

/// The same for version 2: that scene, and cones.
#[test]
fn the_stored_file_of_version_2_is_read() {
    let read = read_scene(include_bytes!("binary/version2.lancer")).unwrap();
    assert_eq!(read, version2());
}

fn version2() -> Scene {
    let cone = |name: &str, top_radius, capped| {
        let shape =
            Shape::Cone { base: DVec3::X, top: DVec3::new(1.0, 2.5, -0.5), base_radius: 0.75, top_radius, capped };
        Arc::new(Object::new(name, shape))
    };
    let scene = version1();
    let cones = [cone("tower", 0.0, true), cone("pipe", 0.75, false)];
    Scene { name: "Version 2".into(), objects: scene.objects.iter().cloned().chain(cones).collect(), ..scene }
}

/// What was read is a scene like any other: it can be edited.
#[test]
fn a_read_scene_can_be_edited() {
    let scene = read_scene(&write_scene(&small_scene())).unwrap();
    let (stage, _) = Stage { scene, ..Stage::default() }.apply(&Edit::Objects(ListEdit::Remove { index: 0 })).unwrap();
    assert_eq!(stage.scene.objects.len(), 1);
}

/// `cargo test --release -p lancer-formats --test binary -- --ignored --nocapture`: well under 100 ms each.
#[test]
#[ignore = "a measurement"]
fn a_million_facets_in_milliseconds() {
    let side = 708_u32;
    let height = |x: u32, y: u32| (f64::from(x) * 0.1).sin() * (f64::from(y) * 0.07).cos();
    let positions = (0..side * side).map(|i| (i % side, i / side));
    let cell = |i: u32| i / (side - 1) * side + i % (side - 1);
    let facets = (0..(side - 1) * (side - 1)).map(cell);
    let geometry = MeshGeometry {
        positions: positions.map(|(x, y)| DVec3::new(f64::from(x), height(x, y), f64::from(y))).collect(),
        facets: facets.flat_map(|at| [[at, at + 1, at + side], [at + 1, at + side + 1, at + side]]).collect(),
        ..MeshGeometry::default()
    };
    let scene = Scene {
        objects: [Object::new("field", mesh(&Arc::new(geometry), DVec3::ZERO))].into_iter().collect(),
        ..Scene::default()
    };
    for _ in 0..5 {
        let start = std::time::Instant::now();
        let file = write_scene(&scene);
        let (written, start) = (start.elapsed(), std::time::Instant::now());
        let read = read_scene(&file).unwrap();
        println!("{} bytes: written in {written:?}, read in {:?}", file.len(), start.elapsed());
        assert_eq!(read, scene);
    }
}
