//! The body of version 1: its own structs as CBOR, then the arrays of the meshes.
//!
//! Nothing here may change, or files that people keep become unreadable: what a later version adds stands in a file of
//! its own. Keys and words are those of the XML documents where they have one. Everything that the model shares by
//! pointer (the geometry of meshes, surfaces without a name) stands once in a table and is referred to by number.
//!
//! Behind the CBOR item follow, for each geometry in the table's order, the vertices (3 × f64 each), the normals
//! (3 × f64) and the facets (3 × u32), without gaps; the file ends with the last one.

use super::BinaryProblem;
use glam::DVec3;
use lancer_scene as model;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::sync::Arc;

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

/// Appends the body of a scene to a file.
pub(super) fn write(scene: &model::Scene, file: &mut Vec<u8>) {
    let mut writer = Writer { surfaces: Table::new(), geometries: Table::new() };
    let objects = scene.objects.iter().map(|object| writer.object(object)).collect();
    let geometries = writer.geometries.items.clone();
    let body = Scene {
        name: scene.name.clone(),
        world: World {
            ambient: scene.world.ambient.to_array(),
            background: scene.world.background.to_array(),
            index: scene.world.index.to_array(),
            depth: scene.world.depth,
            compose: match scene.world.compose {
                model::Compose::Screen => Compose::Screen,
                model::Compose::ScreenEach => Compose::ScreenEach,
                model::Compose::Add => Compose::Add,
            },
        },
        materials: scene
            .materials
            .iter()
            .map(|material| Material { name: material.name.to_string(), surface: surface(&material.surface) })
            .collect(),
        lights: scene
            .lights
            .iter()
            .map(|light| Light {
                name: light.name.to_string(),
                position: light.position.to_array(),
                color: light.color.to_array(),
                visible: light.visible,
            })
            .collect(),
        objects,
        // The parts of meshes name surfaces too, so this table is complete only after this line.
        geometries: geometries.iter().map(|geometry| writer.geometry(geometry)).collect(),
        surfaces: writer.surfaces.items.iter().map(|item| surface(item)).collect(),
    };
    #[expect(clippy::expect_used, reason = "a Vec takes every byte, and every struct above has a form in CBOR")]
    ciborium::into_writer(&body, &mut *file).expect("the structs of version 1 can be written as CBOR");
    for geometry in &geometries {
        write_points(&geometry.positions, file);
        write_points(&geometry.normals, file);
        for facet in &geometry.facets {
            file.extend_from_slice(facet.map(u32::to_le_bytes).as_flattened());
        }
    }
}

fn write_points(points: &[DVec3], file: &mut Vec<u8>) {
    file.reserve_exact(points.len() * POINT_BYTES);
    for point in points {
        file.extend_from_slice(point.to_array().map(f64::to_le_bytes).as_flattened());
    }
}

const POINT_BYTES: usize = 24;
const FACET_BYTES: usize = 12;

/// What the model shares, each once, in the order of first use.
struct Table<T> {
    places: HashMap<*const T, u32>,
    items: Vec<Arc<T>>,
}

impl<T> Table<T> {
    fn new() -> Table<T> {
        Table { places: HashMap::new(), items: Vec::new() }
    }

    fn place(&mut self, item: &Arc<T>) -> u32 {
        *self.places.entry(Arc::as_ptr(item)).or_insert_with(|| {
            self.items.push(Arc::clone(item));
            // Four thousand million different items do not fit in memory.
            self.items.len() as u32 - 1
        })
    }
}

struct Writer {
    surfaces: Table<model::Surface>,
    geometries: Table<model::MeshGeometry>,
}

impl Writer {
    fn object(&mut self, object: &model::Object) -> Object {
        Object {
            name: object.name.to_string(),
            material: self.material_ref(&object.material),
            visible: object.visible,
            shape: match &object.shape {
                model::Shape::Sphere { center, radius } => Shape::Sphere { center: center.to_array(), radius: *radius },
                model::Shape::Plane { p0, p1, p2 } => {
                    Shape::Plane { p0: p0.to_array(), p1: p1.to_array(), p2: p2.to_array() }
                }
                model::Shape::Facet { p0, p1, p2 } => {
                    Shape::Facet { p0: p0.to_array(), p1: p1.to_array(), p2: p2.to_array() }
                }
                model::Shape::Cube { center, edge, rotation } => {
                    Shape::Cube { center: center.to_array(), edge: *edge, rotation: rotation.to_array() }
                }
                model::Shape::Parallelepiped { origin, edges: [u, v, w] } => {
                    Shape::Box { origin: origin.to_array(), u: u.to_array(), v: v.to_array(), w: w.to_array() }
                }
                model::Shape::Mesh(mesh) => Shape::Mesh {
                    geometry: self.geometries.place(&mesh.geometry),
                    src: mesh.source.as_deref().map(str::to_owned),
                    position: mesh.placement.position.to_array(),
                    rotation: mesh.placement.rotation.to_array(),
                    scale: mesh.placement.scale.to_array(),
                    smooth: mesh.smooth,
                },
            },
        }
    }

    fn geometry(&mut self, geometry: &model::MeshGeometry) -> Geometry {
        Geometry {
            vertices: geometry.positions.len() as u64,
            normals: geometry.normals.len() as u64,
            facets: geometry.facets.len() as u64,
            parts: geometry
                .parts
                .iter()
                .map(|part| Part { material: self.material_ref(&part.material), first: part.first, count: part.count })
                .collect(),
        }
    }

    fn material_ref(&mut self, material: &model::MaterialRef) -> MaterialRef {
        match material {
            model::MaterialRef::Default => MaterialRef::Default,
            model::MaterialRef::Named(name) => MaterialRef::Named(name.to_string()),
            model::MaterialRef::Inline(surface) => MaterialRef::Inline(self.surfaces.place(surface)),
        }
    }
}

fn surface(surface: &model::Surface) -> Surface {
    Surface {
        ka: surface.ka.to_array(),
        kd: surface.kd.to_array(),
        ks: surface.ks.to_array(),
        w: match surface.w {
            model::Reflectance::Constant => Reflectance::Constant,
            model::Reflectance::Schlick => Reflectance::Schlick,
            model::Reflectance::Grazing => Reflectance::Grazing,
        },
        n: surface.shininess.to_array(),
        kr: surface.kr.to_array(),
        kt: surface.kt.to_array(),
        index: surface.index.to_array(),
        highlight: match surface.highlight {
            model::Highlight::Phong => Highlight::Phong,
            model::Highlight::Blinn => Highlight::Blinn,
        },
    }
}

/// The scene of a body whose checksum is right. Its rules are not checked here.
pub(super) fn read(body: &[u8]) -> Result<model::Scene, BinaryProblem> {
    let mut rest = body;
    let scene: Scene = ciborium::from_reader(&mut rest).map_err(|error| malformed(&error))?;
    let surfaces: Vec<Arc<model::Surface>> = scene.surfaces.into_iter().map(|item| Arc::new(item.read())).collect();
    let mut geometries = Vec::with_capacity(scene.geometries.len());
    for geometry in scene.geometries {
        geometries.push(Arc::new(model::MeshGeometry {
            positions: read_points(&mut rest, geometry.vertices)?,
            normals: read_points(&mut rest, geometry.normals)?,
            facets: read_facets(&mut rest, geometry.facets)?,
            parts: geometry.parts.into_iter().map(|part| part.read(&surfaces)).collect::<Result<_, _>>()?,
        }));
    }
    if !rest.is_empty() {
        return Err(BinaryProblem::Malformed { detail: format!("{} bytes follow the last array", rest.len()) });
    }
    Ok(model::Scene {
        name: scene.name,
        world: model::Environment {
            ambient: scene.world.ambient.into(),
            background: scene.world.background.into(),
            index: scene.world.index.into(),
            depth: scene.world.depth,
            compose: match scene.world.compose {
                Compose::Screen => model::Compose::Screen,
                Compose::ScreenEach => model::Compose::ScreenEach,
                Compose::Add => model::Compose::Add,
            },
        },
        materials: scene
            .materials
            .into_iter()
            .map(|material| model::Material { name: material.name.into(), surface: material.surface.read() })
            .collect(),
        lights: scene
            .lights
            .into_iter()
            .map(|light| model::PointLight {
                name: light.name.into(),
                position: light.position.into(),
                color: light.color.into(),
                visible: light.visible,
            })
            .collect(),
        objects: scene
            .objects
            .into_iter()
            .map(|object| object.read(&surfaces, &geometries))
            .collect::<Result<_, BinaryProblem>>()?,
    })
}

impl Object {
    fn read(
        self,
        surfaces: &[Arc<model::Surface>],
        geometries: &[Arc<model::MeshGeometry>],
    ) -> Result<model::Object, BinaryProblem> {
        Ok(model::Object {
            name: self.name.into(),
            material: self.material.read(surfaces)?,
            visible: self.visible,
            shape: match self.shape {
                Shape::Sphere { center, radius } => model::Shape::Sphere { center: center.into(), radius },
                Shape::Plane { p0, p1, p2 } => model::Shape::Plane { p0: p0.into(), p1: p1.into(), p2: p2.into() },
                Shape::Facet { p0, p1, p2 } => model::Shape::Facet { p0: p0.into(), p1: p1.into(), p2: p2.into() },
                Shape::Cube { center, edge, rotation } => {
                    model::Shape::Cube { center: center.into(), edge, rotation: rotation.into() }
                }
                Shape::Box { origin, u, v, w } => {
                    model::Shape::Parallelepiped { origin: origin.into(), edges: [u.into(), v.into(), w.into()] }
                }
                Shape::Mesh { geometry, src, position, rotation, scale, smooth } => model::Shape::Mesh(model::Mesh {
                    geometry: at(geometries, geometry, "geometry")?,
                    source: src.map(Into::into),
                    placement: model::Placement {
                        scale: scale.into(),
                        rotation: rotation.into(),
                        position: position.into(),
                    },
                    smooth,
                }),
            },
        })
    }
}

impl Part {
    fn read(self, surfaces: &[Arc<model::Surface>]) -> Result<model::Part, BinaryProblem> {
        Ok(model::Part { material: self.material.read(surfaces)?, first: self.first, count: self.count })
    }
}

impl MaterialRef {
    fn read(self, surfaces: &[Arc<model::Surface>]) -> Result<model::MaterialRef, BinaryProblem> {
        Ok(match self {
            MaterialRef::Default => model::MaterialRef::Default,
            MaterialRef::Named(name) => model::MaterialRef::Named(name.into()),
            MaterialRef::Inline(place) => model::MaterialRef::Inline(at(surfaces, place, "surface")?),
        })
    }
}

impl Surface {
    fn read(self) -> model::Surface {
        model::Surface {
            ka: self.ka.into(),
            kd: self.kd.into(),
            ks: self.ks.into(),
            w: match self.w {
                Reflectance::Constant => model::Reflectance::Constant,
                Reflectance::Schlick => model::Reflectance::Schlick,
                Reflectance::Grazing => model::Reflectance::Grazing,
            },
            shininess: self.n.into(),
            kr: self.kr.into(),
            kt: self.kt.into(),
            index: self.index.into(),
            highlight: match self.highlight {
                Highlight::Phong => model::Highlight::Phong,
                Highlight::Blinn => model::Highlight::Blinn,
            },
        }
    }
}

/// An item of a table.
fn at<T>(table: &[Arc<T>], place: u32, what: &str) -> Result<Arc<T>, BinaryProblem> {
    let missing = || BinaryProblem::Malformed { detail: format!("there is no {what} {place}") };
    table.get(place as usize).cloned().ok_or_else(missing)
}

/// Takes `count` items of `size` bytes. Memory is taken only after this has found them all in the file.
fn take<'a>(rest: &mut &'a [u8], count: u64, size: usize) -> Result<&'a [u8], BinaryProblem> {
    let bytes = usize::try_from(count).ok().and_then(|count| count.checked_mul(size));
    let Some((taken, left)) = bytes.and_then(|bytes| rest.split_at_checked(bytes)) else {
        return Err(BinaryProblem::Malformed { detail: format!("an array of {count} items does not fit in the file") });
    };
    *rest = left;
    Ok(taken)
}

fn read_points(rest: &mut &[u8], count: u64) -> Result<Vec<DVec3>, BinaryProblem> {
    let (points, _) = take(rest, count, POINT_BYTES)?.as_chunks::<POINT_BYTES>();
    let number = |point: &[u8; POINT_BYTES], at: usize| {
        let mut bytes = [0; 8];
        bytes.copy_from_slice(&point[8 * at..8 * at + 8]);
        f64::from_le_bytes(bytes)
    };
    Ok(points.iter().map(|point| DVec3::new(number(point, 0), number(point, 1), number(point, 2))).collect())
}

fn read_facets(rest: &mut &[u8], count: u64) -> Result<Vec<[u32; 3]>, BinaryProblem> {
    let (facets, _) = take(rest, count, FACET_BYTES)?.as_chunks::<FACET_BYTES>();
    let number = |facet: &[u8; FACET_BYTES], at: usize| {
        let mut bytes = [0; 4];
        bytes.copy_from_slice(&facet[4 * at..4 * at + 4]);
        u32::from_le_bytes(bytes)
    };
    Ok(facets.iter().map(|facet| [0, 1, 2].map(|at| number(facet, at))).collect())
}

/// What the CBOR decoder says, without its internal names.
fn malformed(error: &ciborium::de::Error<std::io::Error>) -> BinaryProblem {
    use ciborium::de::Error;
    let detail = match error {
        Error::Io(_) => "the structure ends too early".to_owned(),
        Error::Syntax(offset) => format!("no CBOR at byte {offset} of the body"),
        Error::Semantic(None, message) => message.clone(),
        Error::Semantic(Some(offset), message) => format!("{message}, at byte {offset} of the body"),
        Error::RecursionLimitExceeded => "the structure is nested too deeply".to_owned(),
    };
    BinaryProblem::Malformed { detail }
}
