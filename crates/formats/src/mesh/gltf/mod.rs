//! glTF 2.0, as text or binary (GLB): the triangles of its default scene, every node's placement carried out.
//!
//! Skins, morph targets, cameras, lights, lines and points are let pass. A file that cannot be understood without an
//! extension says so, and so do we.

mod buffers;
mod document;
mod surface;

use super::{Builder, Input, MeshFault, MeshProblem};
use buffers::{Buffers, Elements};
use document::{Document, Node, Primitive};
use glam::{DMat3, DMat4, DQuat, DVec3};
use lancer_scene::Surface;
use std::sync::Arc;

/// The extensions that change nothing about the triangles, or that are understood.
const KNOWN_EXTENSIONS: [&str; 6] =
    ["KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_punctual", "KHR_mesh_quantization", "KHR_xmp"];

pub(super) fn read(input: &mut Input<'_>) -> Result<Builder, MeshProblem> {
    let (json, binary) = split(input.bytes).map_err(|fault| input.at(None, fault))?;
    let document: Document<'_> = serde_json::from_slice(json).map_err(|error| {
        let line = (json.len() == input.bytes.len()).then(|| error.line());
        input.at(line, MeshFault::BadDocument(error.to_string()))
    })?;
    if !document.asset.version.starts_with("2.") {
        let found = document.asset.version.to_string();
        return Err(input.at(None, MeshFault::Unexpected { found, due: "2.0" }));
    }
    let known = |name: &str| KNOWN_EXTENSIONS.iter().any(|known| name.starts_with(known));
    if let Some(name) = document.extensions_required.iter().find(|name| !known(name)) {
        return Err(input.at(None, MeshFault::UnknownExtension(name.to_string())));
    }
    let buffers = Buffers::read(&document, binary, input)?;
    let mut reader = Reader {
        builder: Builder::new(input.bytes.len()),
        materials: document.materials.iter().map(|material| Arc::new(surface::of(material))).collect(),
        document: &document,
        buffers,
        has_normals: false,
    };
    reader.builder.add_file(reader.buffers.bytes_of_files());
    reader.scene().map_err(|fault| input.at(None, fault))?;
    if document.materials.iter().any(surface::has_texture) {
        input.warn(None, MeshFault::TexturesLeftOut);
    }
    if !reader.has_normals {
        reader.builder.geometry.normals.clear();
    }
    Ok(reader.builder)
}

/// The document's text, and the bytes that a GLB file has beside it.
fn split(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), MeshFault> {
    let Some(rest) = bytes.strip_prefix(b"glTF") else { return Ok((bytes, None)) };
    let (version, rest) = number(rest)?;
    if version != 2 {
        return Err(MeshFault::Unexpected { found: version.to_string(), due: "2" });
    }
    let (_, rest) = number(rest)?;
    let (json, rest) = chunk(rest, b"JSON")?;
    let binary = if rest.is_empty() { None } else { Some(chunk(rest, b"BIN\0")?.0) };
    Ok((json, binary))
}

fn number(bytes: &[u8]) -> Result<(u32, &[u8]), MeshFault> {
    let (number, rest) = bytes.split_first_chunk().ok_or(MeshFault::EndsEarly)?;
    Ok((u32::from_le_bytes(*number), rest))
}

/// A chunk of a GLB file, and the bytes behind it.
fn chunk<'a>(bytes: &'a [u8], kind: &[u8; 4]) -> Result<(&'a [u8], &'a [u8]), MeshFault> {
    let (length, rest) = number(bytes)?;
    let rest = rest.strip_prefix(kind).ok_or(MeshFault::Lacks("chunk"))?;
    rest.split_at_checked(length as usize).ok_or(MeshFault::EndsEarly)
}

/// The entry of a list.
fn entry<'a, T>(items: &'a [T], index: usize, list: &'static str) -> Result<&'a T, MeshFault> {
    items.get(index).ok_or(MeshFault::NoSuchEntry { list, index })
}

struct Reader<'a> {
    builder: Builder,
    document: &'a Document<'a>,
    buffers: Buffers,
    materials: Vec<Arc<Surface>>,
    /// Whether some primitive has normals.
    has_normals: bool,
}

impl Reader<'_> {
    /// The meshes of the nodes of the default scene, else of the first, else of all nodes.
    fn scene(&mut self) -> Result<(), MeshFault> {
        let document = self.document;
        let roots = match (document.scene, document.scenes.first()) {
            (Some(index), _) => entry(&document.scenes, index, "scenes")?.nodes.clone(),
            (None, Some(scene)) => scene.nodes.clone(),
            (None, None) => {
                let mut is_root = vec![true; document.nodes.len()];
                for &child in document.nodes.iter().flat_map(|node| &node.children) {
                    if let Some(is_root) = is_root.get_mut(child) {
                        *is_root = false;
                    }
                }
                (0..is_root.len()).filter(|&node| is_root[node]).collect()
            }
        };
        // A node has one parent at most, so that none is met twice: in a circle neither.
        let mut met = vec![false; document.nodes.len()];
        let mut waiting: Vec<(usize, DMat4)> = roots.iter().rev().map(|&root| (root, DMat4::IDENTITY)).collect();
        while let Some((index, outer)) = waiting.pop() {
            let node = entry(&document.nodes, index, "nodes")?;
            if std::mem::replace(&mut met[index], true) {
                return Err(MeshFault::BadEntry { list: "nodes", index });
            }
            let placement = outer * matrix(node);
            if let Some(mesh) = node.mesh {
                for primitive in &entry(&document.meshes, mesh, "meshes")?.primitives {
                    self.primitive(primitive, placement)?;
                }
            }
            waiting.extend(node.children.iter().rev().map(|&child| (child, placement)));
        }
        Ok(())
    }

    fn primitive(&mut self, primitive: &Primitive, placement: DMat4) -> Result<(), MeshFault> {
        /// The modes of primitives that are made of triangles.
        const TRIANGLES: u32 = 4;
        const STRIP: u32 = 5;
        const FAN: u32 = 6;
        if !(TRIANGLES..=FAN).contains(&primitive.mode) {
            return Ok(());
        }
        let material = match primitive.material {
            Some(index) => Some(entry(&self.materials, index, "materials")?),
            None => None,
        };
        self.builder.set_material(material);
        let first = self.vertices(primitive, placement)?;
        let count = self.builder.vertices() - first;
        let corners = match primitive.indices {
            Some(accessor) => Some(self.buffers.elements(self.document, accessor, "SCALAR")?),
            None => None,
        };
        let corner = |at: usize| match &corners {
            Some(corners) => corners.index(at),
            None => at,
        };
        let corners_count = corners.as_ref().map_or(count, Elements::len);
        let triangles = if primitive.mode == TRIANGLES { corners_count / 3 } else { corners_count.saturating_sub(2) };
        let inside_out = DMat3::from_mat4(placement).determinant() < 0.0;
        for i in 0..triangles {
            let [a, mut b, mut c] = match primitive.mode {
                TRIANGLES => [3 * i, 3 * i + 1, 3 * i + 2],
                STRIP => [i, i + 1 + i % 2, i + 2 - i % 2],
                _ => [i + 1, i + 2, 0],
            };
            if inside_out {
                (b, c) = (c, b);
            }
            let mut numbers = [0; 3];
            for (number, at) in numbers.iter_mut().zip([a, b, c]) {
                let named = corner(at);
                if named >= count {
                    return Err(MeshFault::NoSuchVertex { named: named as i64, vertices: count });
                }
                *number = (first + named) as u32;
            }
            self.builder.polygon(&numbers)?;
        }
        Ok(())
    }

    /// Adds a primitive's vertices and gives the number of the first.
    fn vertices(&mut self, primitive: &Primitive, placement: DMat4) -> Result<usize, MeshFault> {
        let first = self.builder.vertices();
        let accessor = primitive.attributes.position.ok_or(MeshFault::Lacks("POSITION"))?;
        let positions = self.buffers.elements(self.document, accessor, "VEC3")?;
        let normals = match primitive.attributes.normal {
            Some(accessor) => Some(self.buffers.elements(self.document, accessor, "VEC3")?),
            None => None,
        };
        if let (Some(normals), Some(index)) = (&normals, primitive.attributes.normal)
            && normals.len() != positions.len()
        {
            return Err(MeshFault::BadEntry { list: "accessors", index });
        }
        self.has_normals |= normals.is_some();
        let to_normal = DMat3::from_mat4(placement).inverse().transpose();
        for at in 0..positions.len() {
            // The zero of a primitive without normals is no direction: then the normals of all are left out.
            let normal = normals.as_ref().map_or(DVec3::ZERO, |normals| to_normal * normals.vector(at));
            self.builder.geometry.normals.push(normal);
            self.builder.vertex(placement.transform_point3(positions.vector(at)))?;
        }
        Ok(first)
    }
}

/// The placement of a node within its parent.
fn matrix(node: &Node) -> DMat4 {
    if let Some(columns) = &node.matrix {
        return DMat4::from_cols_array(columns);
    }
    let scale = node.scale.as_deref().map_or(DVec3::ONE, |scale| DVec3::from_array(*scale));
    let rotation =
        node.rotation.as_deref().map_or(DQuat::IDENTITY, |rotation| DQuat::from_array(*rotation).normalize());
    let translation = node.translation.as_deref().map_or(DVec3::ZERO, |by| DVec3::from_array(*by));
    DMat4::from_scale_rotation_translation(scale, rotation, translation)
}
