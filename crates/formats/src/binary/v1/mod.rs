//! The body of version 1: its own structs as CBOR, then the arrays of the meshes.
//!
//! Nothing here may change, or files that people keep become unreadable: what a later version adds stands in a file of
//! its own. Keys and words are those of the XML documents where they have one. Everything that the model shares by
//! pointer (the geometry of meshes, surfaces without a name) stands once in a table and is referred to by number.
//!
//! Behind the CBOR item follow, for each geometry in the table's order, the vertices (3 × f64 each), the normals
//! (3 × f64) and the facets (3 × u32), without gaps; the file ends with the last one.

mod read;
mod write;

use serde::{Deserialize, Serialize};

pub(super) use read::read;
pub(super) use write::write;

type Triple = [f64; 3];

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Scene {
    name: String,
    world: World,
    materials: Vec<Material>,
    surfaces: Vec<Surface>,
    lights: Vec<Light>,
    objects: Vec<Object>,
    geometries: Vec<Geometry>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct World {
    ambient: Triple,
    background: Triple,
    index: Triple,
    depth: u32,
    compose: Compose,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Compose {
    Screen,
    ScreenEach,
    Add,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Material {
    name: String,
    surface: Surface,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Surface {
    ka: Triple,
    kd: Triple,
    ks: Triple,
    w: Reflectance,
    n: Triple,
    kr: Triple,
    kt: Triple,
    index: Triple,
    highlight: Highlight,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Reflectance {
    Constant,
    Schlick,
    Grazing,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Highlight {
    Phong,
    Blinn,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Light {
    name: String,
    position: Triple,
    color: Triple,
    visible: bool,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Object {
    name: String,
    material: MaterialRef,
    visible: bool,
    shape: Shape,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum MaterialRef {
    Default,
    Named(String),
    /// A place in the table of surfaces.
    Inline(u32),
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
enum Shape {
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
struct Geometry {
    vertices: u64,
    normals: u64,
    facets: u64,
    parts: Vec<Part>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Part {
    material: MaterialRef,
    first: u32,
    count: u32,
}

/// Bytes of a point in an array.
const POINT_BYTES: usize = 24;
/// Bytes of a facet in an array.
const FACET_BYTES: usize = 12;
