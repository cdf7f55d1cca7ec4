//! Damaged files of every format: cut at two hundred places, and with bytes changed, taken out, doubled and exchanged.
//! Reading gives a legal scene or a message that can be told, never a panic, and takes at most ten times the file's size
//! and 64 MiB of memory.
//!
//! `LANCER_MUTATIONS=10000 cargo test -p lancer-formats --test damage` tries more than the ordinary test does.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod meshes_by_hand;

use lancer_formats::mesh::{self, FilesBeside, MeshFault, MeshFile, MeshFiles, MeshProblem};
use lancer_formats::xml::{self, Document, DocumentKind};
use lancer_formats::{Describe, Diagnostic, binary, n7_2009, nff};
use lancer_scene::{Scene, Views};
use lancer_words::Lang;
use meshes_by_hand::{Folder, by_hand};
use std::fs;
use std::path::Path;

/// Marsaglia's xorshift: the same damage in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 32) as usize % end.max(1)
    }
}

/// One to four bytes or runs of bytes are changed.
fn damaged(whole: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = whole.to_vec();
    for _ in 0..=random.below(4) {
        let (at, other) = (random.below(bytes.len()), random.below(bytes.len()));
        match random.below(6) {
            _ if bytes.is_empty() => {}
            0 => bytes[at] = random.below(256) as u8,
            1 => bytes[at] = b"0123456789-.e \n\"<>{}[],/#"[random.below(25)],
            2 => drop(bytes.remove(at)),
            3 => bytes.swap(at, other),
            4 => drop(bytes.drain(at..(at + random.below(40)).min(bytes.len()))),
            _ => {
                let run = bytes[at..(at + random.below(40)).min(bytes.len())].to_vec();
                bytes.splice(other..other, run);
            }
        }
    }
    bytes
}

fn tell(diagnostics: &[Diagnostic]) {
    for found in diagnostics {
        for lang in Lang::ALL {
            assert!(!found.problem.message(lang).is_empty());
            let _ = (found.problem.label(lang), found.problem.help(lang));
        }
    }
}

fn check_scene(scene: Option<Scene>, diagnostics: &[Diagnostic]) {
    tell(diagnostics);
    match scene {
        Some(scene) => assert_eq!(scene.check(), Ok(())),
        None => assert!(!diagnostics.is_empty()),
    }
}

fn check_views(views: Option<Views>, diagnostics: &[Diagnostic]) {
    tell(diagnostics);
    match views {
        Some(views) => assert!(views.iter().all(|view| view.check().is_ok())),
        None => assert!(!diagnostics.is_empty()),
    }
}

/// Documents of this test name no files that exist.
struct Nothing;

impl MeshFiles for Nothing {
    fn read(&mut self, path: &str) -> Result<MeshFile, MeshProblem> {
        mesh::read(path, b"", &mut Folder)
    }
}

/// A document of any kind.
fn document(bytes: &[u8]) {
    match Document::read("it.xml", bytes) {
        Err(malformed) => tell(&[malformed.diagnostic]),
        Ok(document) => match document.kind() {
            Some(DocumentKind::Scene2009) => {
                let read = n7_2009::read_scene(&document);
                check_scene(read.value, &read.diagnostics);
            }
            Some(DocumentKind::Views2009) => {
                let read = n7_2009::read_views(&document);
                check_views(read.value, &read.diagnostics);
            }
            Some(DocumentKind::Views) => {
                let read = xml::read_views(&document);
                check_views(read.value, &read.diagnostics);
            }
            Some(DocumentKind::Scene) | None => {
                let read = xml::read_scene(&document, &mut Nothing);
                check_scene(read.value, &read.diagnostics);
            }
        },
    }
}

fn neutral(bytes: &[u8]) {
    let file = nff::read("it.nff", bytes);
    check_scene(file.scene.value, &file.scene.diagnostics);
    check_views(file.views.value, &file.views.diagnostics);
}

/// As it is, and with a length and a checksum that are right again, so that the damage gets behind them.
fn binary_scene(bytes: &[u8]) {
    let mut sealed = bytes.to_vec();
    if sealed.len() >= 24 {
        let length = sealed.len() as u64;
        sealed[16..24].copy_from_slice(&length.to_le_bytes());
        let mut checksum = crc32fast::Hasher::new();
        checksum.update(&sealed[..12]);
        checksum.update(&sealed[16..]);
        sealed[12..16].copy_from_slice(&checksum.finalize().to_le_bytes());
    }
    for bytes in [bytes, &sealed] {
        match binary::read_scene(bytes) {
            Ok(scene) => assert_eq!(scene.check(), Ok(())),
            Err(problem) => tell(&[Diagnostic::error(None, problem)]),
        }
    }
}

fn mesh_file(name: &str, bytes: &[u8], beside: &mut dyn FilesBeside) {
    match mesh::read(name, bytes, beside) {
        Ok(file) => {
            assert_eq!(file.geometry.check(), Ok(()));
            assert!(!file.geometry.facets.is_empty());
            tell(&file.warnings.iter().map(|warning| Diagnostic::warning(None, warning.clone())).collect::<Vec<_>>());
        }
        Err(problem) => tell(&[Diagnostic::error(None, problem)]),
    }
}

/// A material library instead of the one that the mesh names.
struct Library<'l>(&'l [u8]);

impl FilesBeside for Library<'_> {
    fn read(&mut self, _: &str) -> Result<Vec<u8>, MeshFault> {
        Ok(self.0.to_vec())
    }
}

fn binary_ply() -> Vec<u8> {
    let mut file =
        b"ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty \
        float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
            .to_vec();
    let corners = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]];
    corners.as_flattened().iter().for_each(|number| file.extend(number.to_le_bytes()));
    for facet in [[0_i32, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]] {
        file.push(3);
        facet.iter().for_each(|vertex| file.extend(vertex.to_le_bytes()));
    }
    file
}

fn binary_stl() -> Vec<u8> {
    let mut file = vec![b' '; 80];
    file.extend(4_u32.to_le_bytes());
    for number in 0..4_u16 {
        (0..12).for_each(|place| file.extend((f32::from(number * 7 + place) % 5.0).to_le_bytes()));
        file.extend([0; 2]);
    }
    file
}

/// A glTF file in one piece: its JSON, then its buffer.
fn glb() -> Vec<u8> {
    let mut buffer: Vec<u8> =
        [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].iter().flat_map(|n| n.to_le_bytes()).collect();
    buffer.extend([0_u16, 1, 2, 0].iter().flat_map(|n| n.to_le_bytes()));
    let mut json =
        r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[2,1,1]}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":44}],
        "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
        {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]}"#
            .as_bytes()
            .to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunk = |kind: &[u8], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes()[..], kind, bytes].concat();
    let body = [chunk(b"JSON", &json), chunk(b"BIN\0", &buffer)].concat();
    [b"glTF".as_slice(), &2_u32.to_le_bytes(), &(body.len() as u32 + 12).to_le_bytes(), &body].concat()
}

/// The most memory that the process has had, in bytes; `None` where the system does not tell.
fn most_memory() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmPeak:"))?;
    line.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok().map(|kilobytes| kilobytes * 1024)
}

#[test]
fn damaged_files_of_every_format_are_read_or_refused() {
    let count = std::env::var("LANCER_MUTATIONS").ok().and_then(|count| count.parse().ok()).unwrap_or(400);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let file = |path: &str| fs::read(root.join(path)).unwrap();
    type Reader = Box<dyn Fn(&[u8])>;
    let of_mesh = |name: &'static str| -> Reader { Box::new(move |bytes| mesh_file(name, bytes, &mut Folder)) };
    let cube = by_hand("cube.obj");
    let library: Reader = Box::new(move |bytes| mesh_file("a.obj", &cube, &mut Library(bytes)));
    let files: [(&str, Vec<u8>, Reader); 14] = [
        ("scene", file("scenes/course/objects.xml"), Box::new(document)),
        ("views", file("scenes/course/steps.view.xml"), Box::new(document)),
        ("scene of 2009", file("tests/n7_2009/scene.xml"), Box::new(document)),
        ("views of 2009", file("tests/n7_2009/views.xml"), Box::new(document)),
        ("binary scene", file("crates/formats/tests/binary/version2.lancer"), Box::new(binary_scene)),
        ("NFF", file("scenes/gallery/molecule.nff"), Box::new(neutral)),
        ("OBJ", by_hand("normals.obj"), of_mesh("a.obj")),
        ("MTL", by_hand("cube.mtl"), library),
        ("PLY text", by_hand("dart.ply"), of_mesh("a.ply")),
        ("PLY binary", binary_ply(), of_mesh("a.ply")),
        ("STL text", by_hand("tetrahedron.stl"), of_mesh("a.stl")),
        ("STL binary", binary_stl(), of_mesh("a.stl")),
        ("glTF", by_hand("two.gltf"), of_mesh("a.gltf")),
        ("GLB", glb(), of_mesh("a.glb")),
    ];
    mesh::read("a.glb", &glb(), &mut Folder).unwrap();
    mesh::read("a.ply", &binary_ply(), &mut Folder).unwrap();
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for (name, whole, read) in files {
        let before = most_memory();
        for cut in 0..200 {
            read(&whole[..whole.len() * cut / 200]);
        }
        for _ in 0..count {
            read(&damaged(&whole, &mut random));
        }
        if let (Some(before), Some(after)) = (before, most_memory()) {
            let most = (64 << 20) + 10 * whole.len() as u64;
            assert!(after - before <= most, "{name}: {} bytes for a file of {}", after - before, whole.len());
        }
    }
}
