//! Objects as glTF 2.0, in one file: meshes of one geometry are nodes of one mesh. Materials are translated as
//! `mesh::gltf::surface` does, the other way round: `b = Kd + Kr`, metalness from the share of `Kr`, roughness from the
//! shininess, transmission from `Kt`.

use super::facetted::{self, Facetted, Numbering, facetted, runs};
use super::loss::{Feature, Loss, surfaces_in_use};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use lancer_scene::{DVec3, Object, Rgb, Scene, Shape, Surface};
use serde_json::{Value, json};
use std::collections::HashMap;
use std::sync::Arc;

/// How the parts of the file are held together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Container {
    /// `.gltf`: text, the numbers in base64.
    Text,
    /// `.glb`: binary.
    Binary,
}

/// Component types of glTF.
const U32: u32 = 5125;
const F32: u32 = 5126;

/// A file in the making.
#[derive(Default)]
struct Maker {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    meshes: Vec<Value>,
    nodes: Vec<Value>,
}

/// The scene's objects as a file.
pub fn write(scene: &Scene, container: Container) -> Vec<u8> {
    let mut maker = Maker::default();
    let mut numbering = Numbering::default();
    // meshes of one geometry, material and smoothness are one
    let mut known: HashMap<(usize, usize, bool), usize> = HashMap::new();
    for object in scene.objects.iter().filter(|object| object.visible) {
        let own = numbering.number(&object.material);
        let key = object.shape.mesh().map(|mesh| (Arc::as_ptr(&mesh.geometry) as usize, own, mesh.smooth));
        let mesh = match key.and_then(|key| known.get(&key)) {
            Some(mesh) => *mesh,
            None => {
                let Some(shape) = facetted(&object.shape) else { continue };
                let mesh = maker.mesh(object, &shape, &mut numbering);
                known.extend(key.map(|key| (key, mesh)));
                mesh
            }
        };
        maker.node(object, mesh);
    }
    let materials: Vec<Value> = numbering
        .0
        .iter()
        .enumerate()
        .map(|(number, material)| self::material(&numbering.name(number), &scene.surface(material)))
        .collect();
    maker.finish(materials, container)
}

/// What the file cannot say of the scene.
pub fn losses(scene: &Scene) -> Vec<Loss> {
    let mut losses = facetted::losses(scene);
    for (_, owner) in surfaces_in_use(scene) {
        losses.of(Feature::Coefficients, &owner);
    }
    losses.0
}

impl Maker {
    /// Adds numbers, and gives the number of their accessor.
    fn accessor(&mut self, bytes: &[u8], accessor: Value) -> usize {
        self.views.push(json!({ "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len() }));
        self.bytes.extend_from_slice(bytes);
        let mut accessor = accessor;
        accessor["bufferView"] = json!(self.views.len() - 1);
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn points(&mut self, points: &[DVec3], with_bounds: bool) -> usize {
        let single = |point: &DVec3| point.as_vec3().to_array();
        let bytes: Vec<u8> = points.iter().flat_map(single).flat_map(f32::to_le_bytes).collect();
        let mut accessor = json!({ "componentType": F32, "count": points.len(), "type": "VEC3" });
        if with_bounds {
            let low = points.iter().fold([f32::INFINITY; 3], |low, at| least(low, single(at)));
            let high = points.iter().fold([f32::NEG_INFINITY; 3], |high, at| greatest(high, single(at)));
            (accessor["min"], accessor["max"]) = (json!(low), json!(high));
        }
        self.accessor(&bytes, accessor)
    }

    fn mesh<'a>(&mut self, object: &'a Object, shape: &Facetted<'_>, numbering: &mut Numbering<'a>) -> usize {
        let positions = self.points(&shape.geometry.positions, true);
        let normals = (!shape.normals.is_empty()).then(|| self.points(&shape.normals, false));
        let mut primitives = Vec::new();
        for (material, first, end) in runs(object, &shape.geometry) {
            let indices: Vec<u8> =
                shape.geometry.facets[first..end].iter().flatten().flat_map(|vertex| vertex.to_le_bytes()).collect();
            let accessor = json!({ "componentType": U32, "count": 3 * (end - first), "type": "SCALAR" });
            let mut attributes = json!({ "POSITION": positions });
            if let Some(normals) = normals {
                attributes["NORMAL"] = json!(normals);
            }
            let indices = self.accessor(&indices, accessor);
            primitives
                .push(json!({ "attributes": attributes, "indices": indices, "material": numbering.number(material) }));
        }
        self.meshes.push(json!({ "primitives": primitives }));
        self.meshes.len() - 1
    }

    fn node(&mut self, object: &Object, mesh: usize) {
        let mut node = json!({ "name": &*object.name, "mesh": mesh });
        if let Shape::Mesh(placed) = &object.shape
            && placed.placement != Default::default()
        {
            let linear = placed.placement.linear();
            let column = |column: DVec3, last: f64| [column.x, column.y, column.z, last];
            let columns = [
                column(linear.x_axis, 0.0),
                column(linear.y_axis, 0.0),
                column(linear.z_axis, 0.0),
                column(placed.placement.position, 1.0),
            ];
            node["matrix"] = json!(columns.concat());
        }
        self.nodes.push(node);
    }

    fn finish(mut self, materials: Vec<Value>, container: Container) -> Vec<u8> {
        while !self.bytes.len().is_multiple_of(4) {
            self.bytes.push(0);
        }
        let mut buffer = json!({ "byteLength": self.bytes.len() });
        if container == Container::Text {
            let text = BASE64_STANDARD.encode(&self.bytes);
            buffer["uri"] = json!(format!("data:application/octet-stream;base64,{text}"));
        }
        let mut document = json!({
            "asset": { "version": "2.0", "generator": "lancer" },
            "extensionsUsed": ["KHR_materials_ior", "KHR_materials_transmission"],
            "scene": 0,
            "scenes": [{ "nodes": (0..self.nodes.len()).collect::<Vec<_>>() }],
        });
        // an empty list is none
        for (name, list) in [
            ("nodes", self.nodes),
            ("meshes", self.meshes),
            ("accessors", self.accessors),
            ("bufferViews", self.views),
            ("materials", materials),
        ] {
            if !list.is_empty() {
                document[name] = Value::Array(list);
            }
        }
        if !self.bytes.is_empty() {
            document["buffers"] = json!([buffer]);
        }
        let mut text = document.to_string().into_bytes();
        match container {
            Container::Text => {
                text.push(b'\n');
                text
            }
            Container::Binary => {
                while !text.len().is_multiple_of(4) {
                    text.push(b' ');
                }
                let chunk =
                    |kind: &[u8; 4], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes(), &kind[..], bytes].concat();
                let mut chunks = chunk(b"JSON", &text);
                if !self.bytes.is_empty() {
                    chunks.extend(chunk(b"BIN\0", &self.bytes));
                }
                let length = 12 + chunks.len() as u32;
                [&b"glTF"[..], &2_u32.to_le_bytes(), &length.to_le_bytes(), &chunks].concat()
            }
        }
    }
}

fn least(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [0, 1, 2].map(|axis| a[axis].min(b[axis]))
}

fn greatest(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [0, 1, 2].map(|axis| a[axis].max(b[axis]))
}

fn material(name: &str, surface: &Surface) -> Value {
    let mean = |values: Rgb| values.to_array().iter().sum::<f64>() / 3.0;
    let through = surface.kt.max_channel();
    let base = surface.kd.zip(surface.kr, |kd, kr| kd + kr);
    let base = if through > 0.0 { base.zip(surface.kt, |base, kt| base + kt) } else { base };
    // the exponent of Blinn's model with the same width (Karis 2013)
    let rough = libm::pow(2.0 / (mean(surface.shininess) + 2.0), 0.25);
    let rough = if surface.ks == Rgb::BLACK && !surface.is_mirror() { 1.0 } else { rough };
    let mirrored = mean(surface.kr) / mean(base).max(1e-9);
    let metal = if rough < 1.0 { (mirrored / (1.0 - rough)).min(1.0) } else { 0.0 };
    let [r, g, b] = base.map(|channel| channel.min(1.0)).to_array();
    let mut material = json!({
        "name": name,
        "pbrMetallicRoughness": { "baseColorFactor": [r, g, b, 1.0], "metallicFactor": metal, "roughnessFactor": rough },
    });
    if through > 0.0 {
        material["extensions"] = json!({
            "KHR_materials_transmission": { "transmissionFactor": through },
            "KHR_materials_ior": { "ior": mean(surface.index).max(1.0) },
        });
    }
    material
}
