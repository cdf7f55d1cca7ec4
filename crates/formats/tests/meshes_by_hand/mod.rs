//! The mesh files that were written by hand, and what the tests of their readers share.
#![allow(dead_code, reason = "each test binary uses a part of it")]

use lancer_formats::Describe;
use lancer_formats::mesh::{self, FilesBeside, MeshFault, MeshFile, MeshProblem};
use lancer_scene::{MaterialRef, MeshGeometry, Surface};
use lancer_words::Lang;
use std::fs;
use std::path::Path;

/// The files by hand.
pub(crate) struct Folder;

impl FilesBeside for Folder {
    fn read(&mut self, path: &str) -> Result<Vec<u8>, MeshFault> {
        fs::read(Path::new("tests/meshes").join(path)).map_err(|_| MeshFault::Missing)
    }
}

/// The bytes of a file by hand.
pub(crate) fn by_hand(name: &str) -> Vec<u8> {
    fs::read(Path::new("tests/meshes").join(name)).unwrap()
}

pub(crate) fn read(name: &str, bytes: impl AsRef<[u8]>) -> MeshFile {
    mesh::read(name, bytes.as_ref(), &mut Folder).unwrap_or_else(|problem| panic!("{}", problem.message(Lang::English)))
}

pub(crate) fn refused(name: &str, bytes: impl AsRef<[u8]>) -> MeshProblem {
    mesh::read(name, bytes.as_ref(), &mut Folder).unwrap_err()
}

/// The English message of a refusal.
pub(crate) fn message(name: &str, bytes: impl AsRef<[u8]>) -> String {
    refused(name, bytes).message(Lang::English)
}

pub(crate) fn warnings(file: &MeshFile) -> Vec<String> {
    file.warnings.iter().map(|warning| warning.message(Lang::English)).collect()
}

pub(crate) fn positions(geometry: &MeshGeometry) -> Vec<[f64; 3]> {
    geometry.positions.iter().map(|position| position.to_array()).collect()
}

pub(crate) fn surface(material: &MaterialRef) -> &Surface {
    match material {
        MaterialRef::Inline(surface) => surface,
        MaterialRef::Default | MaterialRef::Named(_) => panic!("{material:?}"),
    }
}

/// The parts as (first, count).
pub(crate) fn parts(geometry: &MeshGeometry) -> Vec<(u32, u32)> {
    geometry.parts.iter().map(|part| (part.first, part.count)).collect()
}

pub(crate) fn area(geometry: &MeshGeometry) -> f64 {
    let corners = |facet: &[u32; 3]| facet.map(|vertex| geometry.positions[vertex as usize]);
    geometry.facets.iter().map(corners).map(|[a, b, c]| (b - a).cross(c - a).length() / 2.0).sum()
}

/// A GLB file of one triangle with normals; `edit` changes the document.
pub(crate) fn glb(edit: impl Fn(String) -> String) -> Vec<u8> {
    let mut binary = Vec::new();
    for value in [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1_i32] {
        binary.extend((value as f32).to_le_bytes());
    }
    let document = r#"{"asset":{"version":"2.0"},"nodes":[{"mesh":0,"scale":[2,4,8]}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
                     {"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC3"}],
        "bufferViews":[{"buffer":0,"byteLength":72}],"buffers":[{"byteLength":72}]}"#;
    let document = edit(document.into());
    let mut file = b"glTF\x02\0\0\0".to_vec();
    file.extend((28 + document.len() as u32 + 72).to_le_bytes());
    file.extend((document.len() as u32).to_le_bytes());
    file.extend(b"JSON");
    file.extend(document.bytes());
    file.extend(72_u32.to_le_bytes());
    file.extend(b"BIN\0");
    file.extend(binary);
    file
}
