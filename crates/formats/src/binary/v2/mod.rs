//! The body of version 2: that of version 1 with one shape more, the cone.
//!
//! Nothing here may change, as nothing in `v1` may. The arrays behind the CBOR item are those of version 1.

mod write;

use super::BinaryProblem;
use super::v1::{ReadShape, Triple, at};
use lancer_scene as model;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

pub(super) use write::write;

/// The shapes of version 2.
#[derive(Serialize, Deserialize)]
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
    Cone {
        base: Triple,
        top: Triple,
        #[serde(rename = "base-radius")]
        base_radius: f64,
        #[serde(rename = "top-radius")]
        top_radius: f64,
        capped: bool,
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
            Shape::Cone { base, top, base_radius, top_radius, capped } => {
                model::Shape::Cone { base: base.into(), top: top.into(), base_radius, top_radius, capped }
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
