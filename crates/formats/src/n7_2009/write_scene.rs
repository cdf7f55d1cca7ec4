//! The writer of `Scene` documents.

use super::loss::Losses;
use super::writer::{Writer, colour, point};
use super::{DEPTH, Feature, Loss, UNIT, lone_facet};
use crate::xml::{AutomaticNames, shortest};
use lancer_scene::{
    Compose, DVec3, Highlight, MaterialRef, Mesh, Name, Object, Reflectance, Rgb, Scene, Shape, Surface, cone_facets,
};
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::sync::Arc;

/// The scene as a document of 2009, and what it could not hold. Numbers are written so that reading gives them again.
pub fn write_scene(scene: &Scene) -> (String, Vec<Loss>) {
    let mut losses = Losses::default();
    lost_of_world(scene, &mut losses);
    let (lights, hidden_lights): (Vec<_>, Vec<_>) = scene.lights.iter().partition(|light| light.visible);
    let (objects, hidden_objects): (Vec<_>, Vec<_>) = scene.objects.iter().partition(|object| object.visible);
    let hidden = hidden_lights.iter().map(|light| &light.name).chain(hidden_objects.iter().map(|object| &object.name));
    hidden.for_each(|name| losses.of(Feature::Hidden, name));

    let mut writer = Writer::new();
    let mut names = AutomaticNames::new([]);
    let mut surfaces = HashMap::new();
    writer.around("Scene", "", |writer| {
        for object in &objects {
            for (number, (material, shape)) in pieces(object).into_iter().enumerate() {
                let again = names.next(written_as(&shape));
                if number == 0 && again != object.name {
                    losses.of(Feature::Name, &object.name);
                }
                writer.around("ObjetGraphique", "", |writer| {
                    // Many objects may have one material.
                    let written = surfaces.entry(identity(&material)).or_insert_with(|| {
                        let before = writer.text.len();
                        write_surface(&scene.surface(&material), writer);
                        writer.text.split_off(before)
                    });
                    writer.text.push_str(written);
                    write_shape(&shape, writer);
                });
            }
        }
        for light in lights {
            if names.next("light") != light.name {
                losses.of(Feature::Name, &light.name);
            }
            let (position, color) = (point(light.position), colour(light.color));
            writer.line(&format!("<Source>{position}{color}</Source>"));
        }
        writer.line(&colour(scene.world.ambient));
    });
    lost_of_materials(scene, &objects, &mut losses);
    objects.iter().for_each(|object| lost_of_shape(object, &mut losses));
    (writer.text, losses.0)
}

fn lost_of_world(scene: &Scene, losses: &mut Losses) {
    let world = &scene.world;
    if !scene.name.is_empty() {
        losses.push(Loss::Title { title: scene.name.clone() });
    }
    if world.background != world.ambient {
        losses.push(Loss::Background);
    }
    if world.index != Rgb::WHITE {
        losses.push(Loss::WorldIndex);
    }
    if world.depth != DEPTH {
        losses.push(Loss::Depth { depth: world.depth });
    }
    if world.compose != Compose::Screen {
        losses.push(Loss::Compose { compose: world.compose });
    }
}

fn lost_of_materials(scene: &Scene, objects: &[&Arc<Object>], losses: &mut Losses) {
    let used: HashSet<&Name> =
        objects.iter().flat_map(|object| object.material_refs().filter_map(MaterialRef::name)).collect();
    for material in &scene.materials {
        if used.contains(&material.name) {
            losses.of(Feature::Name, &material.name);
            lost_of_surface(&material.surface, &material.name, losses);
        } else {
            losses.of(Feature::Unused, &material.name);
        }
    }
    let mut seen = HashSet::new();
    for object in objects {
        for material in object.material_refs() {
            if let MaterialRef::Inline(surface) = material
                && seen.insert(Arc::as_ptr(surface))
            {
                lost_of_surface(surface, &object.name, losses);
            }
        }
    }
}

fn lost_of_surface(surface: &Surface, owner: &Name, losses: &mut Losses) {
    let lost = [
        (surface.w != Reflectance::Constant, Feature::Law),
        (surface.highlight != Highlight::Phong, Feature::Highlight),
        (!surface.shininess.is_uniform(), Feature::Shininess),
        (!surface.index.is_uniform(), Feature::Dispersion),
    ];
    lost.into_iter().filter(|(lost, _)| *lost).for_each(|(_, feature)| losses.of(feature, owner));
}

fn lost_of_shape(object: &Object, losses: &mut Losses) {
    match &object.shape {
        Shape::Cube { .. } => losses.of(Feature::Cube, &object.name),
        Shape::Cone { .. } => losses.of(Feature::Cone, &object.name),
        Shape::Mesh(mesh) => {
            let lost = [
                (mesh.placement != Default::default(), Feature::Placement),
                (mesh.source.is_some(), Feature::File),
                (mesh.smooth, Feature::Smooth),
                (!mesh.geometry.parts.is_empty(), Feature::Parts),
            ];
            lost.into_iter().filter(|(lost, _)| *lost).for_each(|(_, feature)| losses.of(feature, &object.name));
        }
        Shape::Sphere { .. } | Shape::Plane { .. } | Shape::Facet { .. } | Shape::Parallelepiped { .. } => {}
    }
}

/// How many facets go around a cone.
const CONE_FACETS: u32 = 64;

/// A shape in the terms of the format.
enum Piece {
    Sphere { center: DVec3, radius: f64 },
    Plane([DVec3; 3]),
    Cube { corner: DVec3, edges: [DVec3; 3] },
    Facets(Vec<[DVec3; 3]>),
}

/// The objects that an object becomes: one, or one for each material of a mesh.
fn pieces(object: &Object) -> Vec<(MaterialRef, Piece)> {
    let material = || object.material.clone();
    match &object.shape {
        Shape::Sphere { center, radius } => vec![(material(), Piece::Sphere { center: *center, radius: *radius })],
        Shape::Plane { p0, p1, p2 } => vec![(material(), Piece::Plane([*p0, *p1, *p2]))],
        Shape::Facet { p0, p1, p2 } => vec![(material(), Piece::Facets(vec![[*p0, *p1, *p2]]))],
        Shape::Cube { .. } | Shape::Parallelepiped { .. } => {
            let frame = object.shape.frame();
            frame.map(|(corner, edges)| (material(), Piece::Cube { corner, edges })).into_iter().collect()
        }
        Shape::Cone { base, top, base_radius, top_radius, capped } => {
            let facets = cone_facets([*base, *top], [*base_radius, *top_radius], *capped, CONE_FACETS);
            vec![(material(), Piece::Facets(facets))]
        }
        Shape::Mesh(mesh) => {
            let runs = runs(mesh, &object.material);
            runs.into_iter().map(|(material, facets)| (material, Piece::Facets(facets))).collect()
        }
    }
}

/// The facets of a mesh, placed, by their materials in the order in which each appears. Parts of one material are
/// one object.
fn runs(mesh: &Mesh, own: &MaterialRef) -> Vec<(MaterialRef, Vec<[DVec3; 3]>)> {
    let geometry = &mesh.geometry;
    let linear = mesh.placement.linear();
    let unplaced = mesh.placement == Default::default();
    let placed = |vertex: u32| {
        let position = geometry.positions[vertex as usize];
        if unplaced { position } else { linear * position + mesh.placement.position }
    };
    let mut runs: Vec<(MaterialRef, Vec<[DVec3; 3]>)> = Vec::new();
    let mut known = HashMap::new();
    let mut add = |material: &MaterialRef, facets: Range<usize>| {
        let run = *known.entry(identity(material)).or_insert_with(|| {
            runs.push((material.clone(), Vec::new()));
            runs.len() - 1
        });
        runs[run].1.extend(geometry.facets[facets].iter().map(|facet| facet.map(placed)));
    };
    let mut at = 0;
    for part in &geometry.parts {
        let (first, end) = (part.first as usize, part.first as usize + part.count as usize);
        if at < first {
            add(own, at..first);
        }
        add(&part.material, first..end);
        at = end;
    }
    if at < geometry.facets.len() || geometry.facets.is_empty() {
        add(own, at..geometry.facets.len());
    }
    runs
}

/// What makes two references the same material: a name, or one surface shared in memory.
fn identity(material: &MaterialRef) -> (Option<Name>, Option<*const Surface>) {
    match material {
        MaterialRef::Default => (None, None),
        MaterialRef::Named(name) => (Some(name.clone()), None),
        MaterialRef::Inline(surface) => (None, Some(Arc::as_ptr(surface))),
    }
}

/// The stem of the name that reading gives the piece.
fn written_as(piece: &Piece) -> &'static str {
    match piece {
        Piece::Sphere { .. } => "sphere",
        Piece::Plane(_) => "plane",
        Piece::Cube { .. } => "box",
        Piece::Facets(facets) if lone_facet(facets).is_some() => "facet",
        Piece::Facets(_) => "mesh",
    }
}

fn write_surface(surface: &Surface, writer: &mut Writer) {
    let mean = |value: Rgb| if value.is_uniform() { value.r } else { (value.r + value.g + value.b) / 3.0 };
    let index = shortest(mean(surface.index) * UNIT);
    writer.around("Matiere", &format!(" n=\"{index}\""), |writer| {
        let shininess = format!(" n=\"{}\"", shortest(mean(surface.shininess) * UNIT));
        let coefficients = [
            ("Ambiante", "", surface.ka),
            ("Diffuse", "", surface.kd),
            ("Speculaire", shininess.as_str(), surface.ks),
            ("Reflection", "", surface.kr),
            ("Refraction", "", surface.kt),
        ];
        for (name, attributes, value) in coefficients {
            writer.line(&format!("<{name}{attributes}>{}</{name}>", colour(value)));
        }
    });
}

fn write_shape(piece: &Piece, writer: &mut Writer) {
    let points = |points: &[DVec3]| points.iter().map(|at| point(*at)).collect::<String>();
    match piece {
        Piece::Sphere { center, radius } => {
            writer.line(&format!("<Sphere rayon=\"{}\">{}</Sphere>", shortest(*radius), point(*center)));
        }
        Piece::Plane(corners) => writer.line(&format!("<Plan>{}</Plan>", points(corners))),
        Piece::Cube { corner, edges } => {
            let ends = edges.map(|edge| *corner + edge);
            writer.line(&format!("<Cube>{}{}</Cube>", point(*corner), points(&ends)));
        }
        Piece::Facets(facets) => writer.around("ObjetFacette", "", |writer| {
            for corners in facets {
                writer.line(&format!("<Facette>{}</Facette>", points(corners)));
            }
        }),
    }
}
