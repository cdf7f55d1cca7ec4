//! The body of version 1: its own structs as CBOR, then the arrays of the meshes.
//!
//! Nothing here may change, or files that people keep become unreadable: what a later version adds stands in a folder of
//! its own (`v2` has another set of shapes, and takes the rest from here). Keys and words are those of the XML documents where they have one. Everything that the model shares by
//! pointer (the geometry of meshes, surfaces without a name) stands once in a table and is referred to by number.
//!
//! Behind the CBOR item follow, for each geometry in the table's order, the vertices (3 × f64 each), the normals
//! (3 × f64) and the facets (3 × u32), without gaps; the file ends with the last one.

mod read;

use serde::{Deserialize, Serialize};

pub(super) use read::{ReadShape, at, read};

pub(super) type Triple = [f64; 3];

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Scene<S> {
    pub(super) name: String,
    pub(super) world: World,
    pub(super) materials: Vec<Material>,
    pub(super) surfaces: Vec<Surface>,
    pub(super) lights: Vec<Light>,
    pub(super) objects: Vec<Object<S>>,
    pub(super) geometries: Vec<Geometry>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct World {
    pub(super) ambient: Triple,
    pub(super) background: Triple,
    pub(super) index: Triple,
    pub(super) depth: u32,
    pub(super) compose: Compose,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Compose {
    Screen,
    ScreenEach,
    Add,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Material {
    pub(super) name: String,
    pub(super) surface: Surface,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Surface {
    pub(super) ka: Triple,
    pub(super) kd: Triple,
    pub(super) ks: Triple,
    pub(super) w: Reflectance,
    pub(super) n: Triple,
    pub(super) kr: Triple,
    pub(super) kt: Triple,
    pub(super) index: Triple,
    pub(super) highlight: Highlight,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Reflectance {
    Constant,
    Schlick,
    Grazing,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Highlight {
    Phong,
    Blinn,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Light {
    pub(super) name: String,
    pub(super) position: Triple,
    pub(super) color: Triple,
    pub(super) visible: bool,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Object<S> {
    pub(super) name: String,
    pub(super) material: MaterialRef,
    pub(super) visible: bool,
    pub(super) shape: S,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum MaterialRef {
    Default,
    Named(String),
    /// A place in the table of surfaces.
    Inline(u32),
}

/// The shapes of version 1.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(super) enum Shape {
    Sphere {
        center: Triple,
        radius: f64,
    },
    Plane {
        p0: Triple,
        p1: Triple,
        p2: Triple,
    },
    Facet {
        p0: Triple,
        p1: Triple,
        p2: Triple,
    },
    Cube {
        center: Triple,
        edge: f64,
        rotation: Triple,
    },
    Box {
        origin: Triple,
        u: Triple,
        v: Triple,
        w: Triple,
    },
    Mesh {
        /// A place in the table of geometries.
        geometry: u32,
        src: Option<String>,
        position: Triple,
        rotation: Triple,
        scale: Triple,
        smooth: bool,
    },
}

/// How long the arrays of a mesh are, and its parts.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Geometry {
    pub(super) vertices: u64,
    pub(super) normals: u64,
    pub(super) facets: u64,
    pub(super) parts: Vec<Part>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Part {
    pub(super) material: MaterialRef,
    pub(super) first: u32,
    pub(super) count: u32,
}

/// Bytes of a point in an array.
pub(super) const POINT_BYTES: usize = 24;
/// Bytes of a facet in an array.
const FACET_BYTES: usize = 12;
