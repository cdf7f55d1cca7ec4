//! Shapes as POV-Ray's objects. A geometry that several meshes show is declared once and placed for each.

use super::texture::{Textures, surfaces};
use super::vector;
use crate::xml::shortest;
use lancer_scene::{DMat3, DVec3, Enclosure, Mesh, MeshGeometry, Object, Scene, Shape};
use std::collections::HashMap;
use std::io::{self, Write};
use std::sync::Arc;

/// What meshes of one shape share.
#[derive(Default)]
struct Shared {
    /// How many meshes show it, one for each visible object.
    shown: usize,
    /// Its number once it is declared, with its smooth normals and without.
    declared: [Option<usize>; 2],
    enclosure: Option<Enclosure>,
}

/// The geometries of a scene's meshes.
pub(super) struct Geometries {
    known: HashMap<*const MeshGeometry, Shared>,
    declared: usize,
}

impl Geometries {
    pub(super) fn of(scene: &Scene) -> Geometries {
        let mut known: HashMap<_, Shared> = HashMap::new();
        let visible = scene.objects.iter().filter(|object| object.visible);
        for geometry in visible.filter_map(|object| object.shape.geometry()) {
            known.entry(Arc::as_ptr(geometry)).or_default().shown += 1;
        }
        Geometries { known, declared: 0 }
    }

    fn get(&mut self, mesh: &Mesh) -> &mut Shared {
        self.known.entry(Arc::as_ptr(&mesh.geometry)).or_default()
    }

    /// Whether a mesh encloses a volume, asked once of each geometry.
    fn is_closed(&mut self, mesh: &Mesh) -> bool {
        let enclosure = self.get(mesh).enclosure.get_or_insert_with(|| mesh.geometry.enclosure());
        *enclosure != Enclosure::Sheet
    }

    /// The name of a geometry that is shared, declared before; `None` for one that stands alone, and for one of several
    /// materials.
    fn name(&mut self, mesh: &Mesh, out: &mut impl Write) -> io::Result<Option<String>> {
        let number = self.declared + 1;
        let shared = self.get(mesh);
        if shared.shown < 2 || !mesh.geometry.parts.is_empty() {
            return Ok(None);
        }
        let declared = &mut shared.declared[usize::from(mesh.smooth)];
        if let Some(number) = declared {
            return Ok(Some(format!("Mesh{number}")));
        }
        *declared = Some(number);
        self.declared = number;
        write!(out, "#declare Mesh{number} = mesh2 {{ ")?;
        lists(&mesh.geometry, None, mesh.smooth, out)?;
        faces(&mesh.geometry, &[], out)?;
        writeln!(out, "{INSIDE} }}")?;
        Ok(Some(format!("Mesh{number}")))
    }
}

/// The way to tell inside from outside: along a ray that hardly meets an edge.
const INSIDE: &str = "inside_vector <0.3142, 0.5772, 0.7537>";

/// Writes an object, and before it what it needs.
pub(super) fn write(
    object: &Object,
    textures: &mut Textures<'_>,
    geometries: &mut Geometries,
    out: &mut impl Write,
) -> io::Result<()> {
    if let Shape::Mesh(mesh) = &object.shape {
        return write_mesh(object, mesh, textures, geometries, out);
    }
    let texture = format!("texture {{ {} }}", textures.name(&object.material, out)?);
    let solid = format!("{texture}{}", textures.interior(&textures.surface(&object.material)));
    match &object.shape {
        Shape::Sphere { center, radius } => {
            write!(out, "sphere {{ {}, {} {solid} }}", vector(*center), shortest(*radius))?;
        }
        Shape::Plane { p0, p1, p2 } => {
            let normal = (p1 - p0).cross(p2 - p0).normalize();
            write!(out, "plane {{ {}, {} {solid} }}", vector(normal), shortest(normal.dot(*p0)))?;
        }
        Shape::Facet { p0, p1, p2 } => {
            write!(out, "triangle {{ {}, {}, {} {texture} }}", vector(*p0), vector(*p1), vector(*p2))?;
        }
        Shape::Cube { .. } | Shape::Parallelepiped { .. } => {
            let Some((origin, [a, b, c])) = object.shape.frame() else { return Ok(()) };
            write!(out, "box {{ 0, 1 {} {solid} }}", matrix(DMat3::from_cols(a, b, c), origin))?;
        }
        Shape::Cone { base, top, base_radius, top_radius, capped } => {
            let (open, kind) = if *capped { ("", &solid) } else { ("open ", &texture) };
            let ends = [(base, base_radius), (top, top_radius)];
            let [base, top] = ends.map(|(center, radius)| format!("{}, {}", vector(*center), shortest(*radius)));
            write!(out, "cone {{ {base}, {top} {open}{kind} }}")?;
        }
        Shape::Mesh(_) => {}
    }
    writeln!(out, " // {}", object.name)
}

fn write_mesh(
    object: &Object,
    mesh: &Mesh,
    textures: &mut Textures<'_>,
    geometries: &mut Geometries,
    out: &mut impl Write,
) -> io::Result<()> {
    if mesh.geometry.facets.is_empty() {
        return Ok(());
    }
    let mut names = Vec::new();
    for material in surfaces(object, mesh) {
        names.push(textures.name(material, out)?);
    }
    let clear = surfaces(object, mesh).map(|material| textures.surface(material)).find(|it| it.is_transparent());
    let interior = match clear {
        Some(surface) if geometries.is_closed(mesh) => textures.interior(&surface),
        Some(_) | None => String::new(),
    };
    let Some(first) = names.first() else { return Ok(()) };
    if let Some(shape) = geometries.name(mesh, out)? {
        let place = matrix(mesh.placement.linear(), mesh.placement.position);
        return writeln!(out, "object {{ {shape} {place} texture {{ {first} }}{interior} }} // {}", object.name);
    }
    write!(out, "mesh2 {{ ")?;
    lists(&mesh.geometry, Some(mesh), mesh.smooth, out)?;
    if mesh.geometry.parts.is_empty() {
        faces(&mesh.geometry, &[], out)?;
        return writeln!(out, "{INSIDE} texture {{ {first} }}{interior} }} // {}", object.name);
    }
    writeln!(out, "texture_list {{ {}", names.len())?;
    names.iter().try_for_each(|name| writeln!(out, ", texture {{ {name} }}"))?;
    write!(out, "}} ")?;
    faces(&mesh.geometry, &texture_of_each_facet(object, mesh), out)?;
    writeln!(out, "{INSIDE}{interior} }} // {}", object.name)
}

/// The vertices, and normals where there are smooth ones; brought to their place if they stand for one object.
fn lists(geometry: &MeshGeometry, placed: Option<&Mesh>, smooth: bool, out: &mut impl Write) -> io::Result<()> {
    let (linear, position) = match placed {
        Some(mesh) => (mesh.placement.linear(), mesh.placement.position),
        None => (DMat3::IDENTITY, DVec3::ZERO),
    };
    writeln!(out, "vertex_vectors {{ {}", geometry.positions.len())?;
    for vertex in &geometry.positions {
        writeln!(out, ",{}", single(linear * *vertex + position))?;
    }
    write!(out, "}} ")?;
    if smooth {
        // normals go by the cross products of the columns, as P0P1 × P0P2 does
        let DMat3 { x_axis: x, y_axis: y, z_axis: z } = linear;
        let turned = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
        writeln!(out, "normal_vectors {{ {}", geometry.positions.len())?;
        for normal in geometry.smooth_normals().iter() {
            writeln!(out, ",{}", single((turned * *normal).normalize_or(DVec3::Y)))?;
        }
        write!(out, "}} ")?;
    }
    Ok(())
}

/// The facets, each with the number of its texture if there are several.
fn faces(geometry: &MeshGeometry, textures: &[usize], out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "face_indices {{ {}", geometry.facets.len())?;
    for (number, [a, b, c]) in geometry.facets.iter().enumerate() {
        match textures.get(number) {
            Some(texture) => writeln!(out, ",<{a},{b},{c}>,{texture}")?,
            None => writeln!(out, ",<{a},{b},{c}>")?,
        }
    }
    write!(out, "}} ")
}

/// The place of each facet's material among [`surfaces`].
fn texture_of_each_facet(object: &Object, mesh: &Mesh) -> Vec<usize> {
    let parts = &mesh.geometry.parts;
    let before: usize = surfaces(object, mesh).count() - parts.len();
    let mut places = vec![0; mesh.geometry.facets.len()];
    for (number, part) in parts.iter().enumerate() {
        let run = places.iter_mut().skip(part.first as usize).take(part.count as usize);
        run.for_each(|place| *place = before + number);
    }
    places
}

/// POV-Ray's meshes hold 32 bits.
fn single(point: DVec3) -> String {
    format!("<{},{},{}>", point.x as f32, point.y as f32, point.z as f32)
}

fn matrix(linear: DMat3, position: DVec3) -> String {
    let rows = [linear.x_axis, linear.y_axis, linear.z_axis, position];
    format!("matrix <{}>", rows.map(|row| row.to_array().map(shortest).join(", ")).join(", "))
}
