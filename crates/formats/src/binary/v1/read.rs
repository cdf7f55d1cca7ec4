//! The reader of version 1.

use super::{
    Compose, FACET_BYTES, Highlight, MaterialRef, Object, POINT_BYTES, Part, Reflectance, Scene, Shape, Surface,
};
use crate::binary::BinaryProblem;
use glam::DVec3;
use lancer_scene as model;
use serde::de::DeserializeOwned;
use std::sync::Arc;

/// The shapes of a version.
pub(in crate::binary) trait ReadShape: DeserializeOwned {
    /// The shape of the model; the geometry of a mesh is one of the table's.
    fn read(self, geometries: &[Arc<model::MeshGeometry>]) -> Result<model::Shape, BinaryProblem>;
}

/// The scene of a body whose checksum is right. Its rules are not checked here.
pub(in crate::binary) fn read<S: ReadShape>(body: &[u8]) -> Result<model::Scene, BinaryProblem> {
    let mut rest = body;
    let scene: Scene<S> = ciborium::from_reader(&mut rest).map_err(|error| malformed(&error))?;
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

impl<S: ReadShape> Object<S> {
    fn read(
        self,
        surfaces: &[Arc<model::Surface>],
        geometries: &[Arc<model::MeshGeometry>],
    ) -> Result<model::Object, BinaryProblem> {
        Ok(model::Object {
            name: self.name.into(),
            material: self.material.read(surfaces)?,
            visible: self.visible,
            shape: self.shape.read(geometries)?,
        })
    }
}

impl ReadShape for Shape {
    fn read(self, geometries: &[Arc<model::MeshGeometry>]) -> Result<model::Shape, BinaryProblem> {
        Ok(match self {
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
pub(in crate::binary) fn at<T>(table: &[Arc<T>], place: u32, what: &str) -> Result<Arc<T>, BinaryProblem> {
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
