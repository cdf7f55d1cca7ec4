//! The scene of a file: its entities in the terms of the model.
//!
//! A fill becomes a material: `Ka = Kd = Kd·RGB`, `Kr = Ks`, `Kt = T`, and a highlight of strength `Ks` with the exponent
//! `Shine` if that is not 0. A lamp without a colour, and the ambient light, get the intensity that the text on the
//! Standard Procedural Databases (Haines, README of SPD 3.14) recommends: `√n/(2n)` of `n` lamps. Terms are summed, and
//! rays end after five levels, as that text says. All polygons under one fill are one mesh, and all patches are another.

use super::NffProblem;
use super::entities::{Entity, Fill, Sink, View};
use crate::mesh::triangulate;
use crate::{Diagnostic, Span};
use glam::DVec3;
use lancer_scene::{
    Compose, Environment, Material, MaterialRef, Mesh, MeshGeometry, Name, Object, Placement, PointLight, Rgb, Scene,
    Shape, Surface, limits,
};
use std::collections::HashMap;
use std::sync::Arc;

/// The level that the last rays of the databases have; the eye's have 0.
const DEPTH: u32 = 4;
/// What an object takes, about: its own fields, its name, and counters.
const OBJECT_BYTES: usize = 300;
/// What a vertex takes while it is looked for, about.
const VERTEX_BYTES: usize = 120;

/// Puts a scene together.
pub(super) struct Builder {
    pub(super) sink: Sink,
    pub(super) view: Option<View>,
    background: Rgb,
    lights: Vec<(DVec3, Option<Rgb>)>,
    materials: Vec<Material>,
    by_fill: HashMap<[u64; 8], MaterialRef>,
    fill: MaterialRef,
    objects: Vec<Object>,
    numbers: HashMap<&'static str, usize>,
    polygons: Facets,
    patches: Facets,
    /// The bytes that the scene takes, about, and may take.
    used: usize,
    most: usize,
}

/// The facets under one fill; equal corners are one vertex.
#[derive(Default)]
struct Facets {
    geometry: MeshGeometry,
    vertices: HashMap<[u64; 6], u32>,
}

impl Facets {
    fn vertex(&mut self, position: DVec3, normal: Option<DVec3>) -> u32 {
        let direction = normal.unwrap_or(DVec3::ZERO);
        // adding zero makes -0 and 0 one place
        let [[x, y, z], [u, v, w]] =
            [position, direction].map(|vector| vector.to_array().map(|number| (number + 0.0).to_bits()));
        let geometry = &mut self.geometry;
        *self.vertices.entry([x, y, z, u, v, w]).or_insert_with(|| {
            geometry.positions.push(position);
            geometry.normals.extend(normal);
            geometry.positions.len() as u32 - 1
        })
    }

    fn polygon(&mut self, corners: &[(DVec3, Option<DVec3>)]) {
        let vertices: Vec<u32> = corners.iter().map(|(position, normal)| self.vertex(*position, *normal)).collect();
        let positions: Vec<DVec3> = corners.iter().map(|(position, _)| *position).collect();
        triangulate(&positions, &mut |triangle| self.geometry.facets.push(triangle.map(|corner| vertices[corner])));
    }
}

impl Builder {
    /// For a file of so many bytes.
    pub(super) fn new(bytes: usize) -> Builder {
        Builder {
            sink: Sink::default(),
            view: None,
            background: Rgb::BLACK,
            lights: Vec::new(),
            materials: Vec::new(),
            by_fill: HashMap::new(),
            fill: MaterialRef::Default,
            objects: Vec::new(),
            numbers: HashMap::new(),
            polygons: Facets::default(),
            patches: Facets::default(),
            used: 0,
            most: (64 << 20) + bytes.saturating_mul(10),
        }
    }

    pub(super) fn add(&mut self, entity: Entity) {
        if self.used > self.most {
            return;
        }
        match entity {
            Entity::View(view) if self.view.is_none() => self.view = Some(view),
            Entity::View(view) => self.sink.warn(view.span, NffProblem::SecondView),
            Entity::Background(color) => self.background = color,
            Entity::Light { position, color } => {
                self.used += OBJECT_BYTES;
                self.lights.push((position, color));
            }
            Entity::Fill(fill) => {
                self.end_fill();
                self.fill = self.material(&fill);
            }
            Entity::Sphere { span, center, radius } => self.simple(span, Shape::Sphere { center, radius }),
            Entity::Cone { span, ends: [base, top], radii: [base_radius, top_radius] } => {
                self.simple(span, Shape::Cone { base, top, base_radius, top_radius, capped: false });
            }
            Entity::Polygon(corners) => {
                self.used += VERTEX_BYTES * corners.len();
                let corners: Vec<_> = corners.into_iter().map(|position| (position, None)).collect();
                self.polygons.polygon(&corners);
            }
            Entity::Patch(corners) => {
                self.used += VERTEX_BYTES * corners.len();
                let corners: Vec<_> = corners.into_iter().map(|(position, normal)| (position, Some(normal))).collect();
                self.patches.polygon(&corners);
            }
        }
        if self.used > self.most {
            self.sink.of_scene.push(Diagnostic::error(None, NffProblem::TooMuchMemory { most: self.most }));
        }
    }

    /// A sphere or a cone, which must be legal.
    fn simple(&mut self, span: Span, shape: Shape) {
        match shape.check() {
            Ok(()) => self.object(shape.element(), shape),
            Err(rule) => self.sink.error(span, NffProblem::Broken(rule)),
        }
    }

    fn object(&mut self, stem: &'static str, shape: Shape) {
        self.used += OBJECT_BYTES;
        let number = self.numbers.entry(stem).or_default();
        *number += 1;
        let object = Object::new(format!("{stem} {number}"), shape);
        self.objects.push(Object { material: self.fill.clone(), ..object });
    }

    /// The material of a fill; equal ones share one.
    fn material(&mut self, fill: &Fill) -> MaterialRef {
        let Fill { color, diffuse, specular, shine, transmittance, index } = *fill;
        let key = [color.r, color.g, color.b, diffuse, specular, shine, transmittance, index].map(f64::to_bits);
        if let Some(known) = self.by_fill.get(&key) {
            return known.clone();
        }
        self.used += OBJECT_BYTES;
        let name: Name = format!("fill {}", self.materials.len() + 1).into();
        let surface = Surface {
            ka: color * diffuse,
            kd: color * diffuse,
            ks: if shine > 0.0 { Rgb::splat(specular) } else { Rgb::BLACK },
            shininess: Rgb::splat(shine),
            kr: Rgb::splat(specular),
            kt: Rgb::splat(transmittance),
            // files of opaque fills often say 0
            index: Rgb::splat(if index < limits::LEAST { 1.0 } else { index }),
            ..Surface::default()
        };
        self.materials.push(Material { name: name.clone(), surface });
        self.by_fill.insert(key, MaterialRef::Named(name.clone()));
        MaterialRef::Named(name)
    }

    /// Makes objects of the polygons and patches since the last fill.
    fn end_fill(&mut self) {
        for (stem, smooth) in [("polygons", false), ("patches", true)] {
            let facets = if smooth { &mut self.patches } else { &mut self.polygons };
            let Facets { mut geometry, .. } = std::mem::take(facets);
            if geometry.facets.is_empty() {
                continue;
            }
            geometry.positions.shrink_to_fit();
            geometry.normals.shrink_to_fit();
            geometry.facets.shrink_to_fit();
            let geometry = Arc::new(geometry);
            self.object(stem, Shape::Mesh(Mesh { geometry, source: None, placement: Placement::default(), smooth }));
        }
    }

    /// The scene, and what is said of it and of the view.
    pub(super) fn finish(mut self) -> (Scene, Vec<Diagnostic>, Vec<Diagnostic>) {
        self.end_fill();
        let count = self.lights.len().max(1) as f64;
        let intensity = count.sqrt() / (2.0 * count);
        let light = |(number, (position, color)): (usize, (DVec3, Option<Rgb>))| PointLight {
            color: color.unwrap_or(Rgb::splat(intensity)),
            ..PointLight::new(format!("light {}", number + 1), position)
        };
        let scene = Scene {
            name: String::new(),
            world: Environment {
                ambient: Rgb::splat(intensity),
                background: self.background,
                depth: DEPTH,
                compose: Compose::Add,
                ..Environment::default()
            },
            materials: self.materials.into_iter().collect(),
            lights: self.lights.into_iter().enumerate().map(light).collect(),
            objects: self.objects.into_iter().collect(),
        };
        (scene, self.sink.of_scene, self.sink.of_view)
    }
}
