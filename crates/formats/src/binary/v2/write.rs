//! The writer of version 2.

use super::Shape;
use crate::binary::v1::{
    Compose, Geometry, Highlight, Light, Material, MaterialRef, Object, POINT_BYTES, Part, Reflectance, Scene, Surface,
    World,
};
use glam::DVec3;
use lancer_scene as model;
use std::collections::HashMap;
use std::sync::Arc;

/// Appends the body of a scene to a file.
pub(in crate::binary) fn write(scene: &model::Scene, file: &mut Vec<u8>) {
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
    ciborium::into_writer(&body, &mut *file).expect("the structs of version 2 can be written as CBOR");
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
    fn object(&mut self, object: &model::Object) -> Object<Shape> {
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
                model::Shape::Cone { base, top, base_radius, top_radius, capped } => Shape::Cone {
                    base: base.to_array(),
                    top: top.to_array(),
                    base_radius: *base_radius,
                    top_radius: *top_radius,
                    capped: *capped,
                },
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
