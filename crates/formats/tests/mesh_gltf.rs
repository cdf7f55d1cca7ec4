//! glTF and GLB: what a scene of nodes gives, and what is refused.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that fails says so by panicking")]

mod meshes_by_hand;

use glam::DVec3;
use lancer_formats::mesh::{self, FilesBeside, MeshFault};
use lancer_scene::{MeshGeometry, Rgb};
use meshes_by_hand::*;

#[test]
fn a_gltf_scene_is_placed_and_its_materials_are_parts() {
    let file = read("two.gltf", by_hand("two.gltf"));
    let geometry = &file.geometry;
    assert_eq!(geometry.check(), Ok(()));
    // The square lies mirrored at x = 10, its strip turned round so that it still faces up.
    assert_eq!(geometry.facets, [[0, 2, 1], [1, 2, 3], [4, 5, 6]]);
    assert_eq!(
        geometry.positions[..4],
        [[10.0, 0.0, 0.0], [9.0, 0.0, 0.0], [10.0, 1.0, 0.0], [9.0, 1.0, 0.0]].map(DVec3::from)
    );
    for facet in &geometry.facets {
        let [a, b, c] = facet.map(|vertex| geometry.positions[vertex as usize]);
        assert!((b - a).cross(c - a).z > 0.9);
    }
    // The triangle is turned a quarter about z.
    assert!((geometry.positions[5] - DVec3::new(10.0, 1.0, 0.0)).length() < 1e-12);
    assert!((geometry.positions[6] - DVec3::new(9.0, 0.0, 0.0)).length() < 1e-12);
    assert_eq!(parts(geometry), [(0, 2)]);
    let gold = surface(&geometry.parts[0].material);
    assert_eq!(gold.kr, Rgb::new(0.5, 0.375, 0.125));
    assert_eq!(gold.kd, Rgb::new(0.5, 0.375, 0.125));
    assert_eq!(gold.shininess, Rgb::splat(30.0));
    assert_eq!(gold.check(), Ok(()));
    assert_eq!(
        warnings(&file),
        ["mesh file `two.gltf`: its normals are not used: some are missing or have no direction"]
    );
}

#[test]
fn a_glb_file_brings_its_buffer() {
    let file = read("a.glb", glb(|document| document));
    assert_eq!(warnings(&file), [""; 0]);
    assert_eq!(positions(&file.geometry), [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 4.0, 0.0]]);
    assert_eq!(file.geometry.normals, [DVec3::new(0.0, 0.0, 0.125); 3]);
    assert_eq!(file.geometry.facets, [[0, 1, 2]]);
}

#[test]
fn a_gltf_file_says_what_is_wrong() {
    let said = |from: &str, to: &str| {
        message(
            "a.glb",
            glb(|document| {
                assert!(document.contains(from), "{from}");
                document.replacen(from, to, 1)
            }),
        )
    };
    let file = |text: &str| format!("mesh file `a.glb`: {text}");
    let contradicts =
        |index: usize, list: &str| file(&format!("entry {index} of `{list}` contradicts the rest of the file"));
    assert_eq!(said("\"count\":3", "\"count\":7"), contradicts(0, "accessors"));
    assert_eq!(said("\"count\":3", "\"count\":18446744073709551615"), contradicts(0, "accessors"));
    assert_eq!(said("\"count\":3", "\"count\":2"), contradicts(1, "accessors"));
    assert_eq!(said("VEC3", "VEC2"), contradicts(0, "accessors"));
    assert_eq!(said("\"byteOffset\":36", "\"byteOffset\":40"), contradicts(1, "accessors"));
    assert_eq!(said("\"byteOffset\":36", "\"byteOffset\":18446744073709551615"), contradicts(1, "accessors"));
    assert_eq!(
        said("\"byteLength\":72}],\"buffers\"", "\"byteLength\":73}],\"buffers\""),
        contradicts(0, "bufferViews")
    );
    assert_eq!(said("\"buffers\":[{\"byteLength\":72", "\"buffers\":[{\"byteLength\":80"), contradicts(0, "buffers"));
    assert_eq!(said("\"bufferView\":0,\"c", "\"bufferView\":5,\"c"), file("there is no entry 5 in `bufferViews`"));
    assert_eq!(said("\"mesh\":0", "\"mesh\":1"), file("there is no entry 1 in `meshes`"));
    assert_eq!(said("\"mesh\":0", "\"mesh\":0,\"children\":[0]"), file("there is not one facet"));
    assert_eq!(said("\"nodes\"", "\"scenes\":[{\"nodes\":[0,0]}],\"nodes\""), contradicts(0, "nodes"));
    assert_eq!(said("\"POSITION\"", "\"COLOR\""), file("`POSITION` is missing"));
    assert_eq!(said("2.0", "1.0"), file("`2.0` is due, not `1.0`"));
    assert_eq!(said("}}]}]", "},\"indices\":0}]}]"), contradicts(0, "accessors"));
    assert_eq!(
        said("\"nodes\"", "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"nodes\""),
        file("the file needs the glTF extension `KHR_draco_mesh_compression`, which is not known")
    );
    assert!(said("\"nodes\"", "nodes").starts_with("mesh file `a.glb`: this is no glTF document: "));
    assert_eq!(
        message("a.gltf", "{\n}"),
        "mesh file `a.gltf`, line 2: this is no glTF document: missing field `asset` at line 2 column 1"
    );
    let lost = String::from_utf8(by_hand("two.gltf")).unwrap().replace("square%20one", "lost");
    assert_eq!(message("m/two.gltf", lost), "mesh file `m/lost.bin`: there is no such file");
}

/// A few bytes that name one mesh many times cannot become gigabytes.
#[test]
fn a_gltf_file_cannot_multiply_its_meshes_without_bound() {
    let geometry = MeshGeometry { positions: vec![DVec3::ZERO; 100_000], ..MeshGeometry::default() };
    let buffer: Vec<u8> = geometry.positions.iter().flat_map(|_| [0; 12]).collect();
    let nodes = vec!["{\"mesh\":0}"; 100_000].join(",");
    let document = format!(
        r#"{{"asset":{{"version":"2.0"}},"nodes":[{nodes}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":100000,"type":"VEC3"}}],
        "bufferViews":[{{"buffer":0,"byteLength":1200000}}],"buffers":[{{"byteLength":1200000,"uri":"b"}}]}}"#
    );
    struct Buffer(Vec<u8>);
    impl FilesBeside for Buffer {
        fn read(&mut self, _: &str) -> Result<Vec<u8>, MeshFault> {
            Ok(self.0.clone())
        }
    }
    let most = (64 << 20) + 10 * (document.len() + buffer.len());
    let problem = mesh::read("a.gltf", document.as_bytes(), &mut Buffer(buffer)).unwrap_err();
    assert_eq!(problem.fault, MeshFault::TooMuchMemory { most });
}
