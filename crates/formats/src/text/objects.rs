//! The objects: number, name, shape, material and geometry. Objects of one shape line up among themselves.

use super::materials::OwnSurfaces;
use super::number::rounded;
use super::table::{Cell, Table};
use super::{COLUMNS, clean, row};
use lancer_scene::{DVec3, Enclosure, Extents, MaterialRef, Mesh, MeshGeometry, Object, Placement, Scene, Shape};
use lancer_words::{Lang, number as count, term, text as words};
use std::collections::HashMap;
use std::sync::Arc;
use unicode_width::UnicodeWidthStr;

/// Meshes of at most so many vertices and facets are listed; of others the counts and bounds are shown.
const LISTED: (usize, usize) = (12, 20);

pub(super) fn lines(scene: &Scene, lang: Lang) -> Vec<String> {
    if scene.objects.is_empty() {
        return vec![format!("  {}", words::none(lang))];
    }
    let own = OwnSurfaces::of(scene, lang);
    let mut table = Table::new([2, 2, 3, 3]);
    let heading = [term::name(lang), term::shape(lang), term::material(lang)];
    table.push([vec![Cell::Blank], heading.map(Cell::Text).to_vec()].concat());
    for (object, number) in scene.objects.iter().zip(1_u32..) {
        let name = clean(&object.name);
        table.push(vec![
            Cell::number(number.into()),
            Cell::text(if object.visible { name } else { words::hidden(lang, name) }),
            Cell::text(shape(&object.shape, lang)),
            Cell::text(own.label(&object.material, &object.name, lang)),
        ]);
    }
    let indent = table.width() + 3;
    let mut geometries = geometry_lines(scene, lang, COLUMNS.saturating_sub(indent));
    let mut extents = Extents::default();
    let mut rows = table.rows().into_iter();
    // beside the last line of a row, or below it where that is too wide
    let beside = |row: Vec<String>, right: &str| {
        let mut lines = row;
        let width = lines.last().map_or(0, |line| line.width());
        if width >= indent {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            *line = format!("{line}{:1$}{right}", "", indent - line.width());
        }
        lines
    };
    let mut text: Vec<String> = rows.next().map(|heading| beside(heading, &term::geometry(lang))).unwrap_or_default();
    for (row, object) in rows.zip(&scene.objects) {
        let mut geometry = geometries[kind(&object.shape)].next().unwrap_or_default().into_iter();
        text.extend(beside(row, &geometry.next().unwrap_or_default()));
        text.extend(geometry.flat_map(|line| beside(vec![String::new()], &line)));
        if let Shape::Mesh(mesh) = &object.shape {
            let bounds = extents.of(&object.shape);
            let material = |material: &MaterialRef| own.label(material, &object.name, lang);
            for (label, items) in mesh_details(mesh, bounds, &material, lang) {
                text.extend(wrapped(&label, &items, indent));
            }
        }
    }
    text
}

/// The shape in words.
fn shape(shape: &Shape, lang: Lang) -> String {
    match shape {
        Shape::Sphere { .. } => term::sphere(lang),
        Shape::Plane { .. } => term::plane(lang),
        Shape::Facet { .. } => term::facet(lang),
        Shape::Cube { .. } => term::cube(lang),
        Shape::Parallelepiped { .. } => term::parallelepiped(lang),
        Shape::Cone { .. } => term::cone(lang),
        Shape::Mesh(_) => term::mesh(lang),
    }
}

/// The number of the table that a shape's geometry stands in.
fn kind(shape: &Shape) -> usize {
    match shape {
        Shape::Sphere { .. } => 0,
        Shape::Plane { .. } => 1,
        Shape::Facet { .. } => 2,
        Shape::Cube { .. } => 3,
        Shape::Parallelepiped { .. } => 4,
        Shape::Cone { .. } => 5,
        Shape::Mesh(_) => 6,
    }
}

/// The lines of geometry of all objects of each kind, in document order, within a width if that can be.
fn geometry_lines(scene: &Scene, lang: Lang, width: usize) -> [std::vec::IntoIter<Vec<String>>; 7] {
    let turned = |object: &Arc<Object>| matches!(object.shape, Shape::Cube { rotation, .. } if rotation != DVec3::ZERO);
    let some_cube_turned = scene.objects.iter().any(turned);
    let mut enclosures = HashMap::new();
    let mut fields: [Vec<Vec<Field>>; 7] = Default::default();
    for object in &scene.objects {
        let of_object = match &object.shape {
            Shape::Sphere { center, radius } => vec![point("C", *center), length("R", *radius)],
            Shape::Plane { p0, p1, p2 } | Shape::Facet { p0, p1, p2 } => {
                vec![point("P0", *p0), point("P1", *p1), point("P2", *p2)]
            }
            Shape::Cube { center, edge, rotation } => {
                let rotation = some_cube_turned.then(|| point(&term::rotation(lang), *rotation));
                [point("C", *center), length(&term::edge(lang), *edge)].into_iter().chain(rotation).collect()
            }
            Shape::Parallelepiped { origin, edges: [u, v, w] } => {
                vec![point(&term::corner(lang), *origin), point("u", *u), point("v", *v), point("w", *w)]
            }
            Shape::Cone { base, top, base_radius, top_radius, capped } => {
                let ends = if *capped { words::capped(lang) } else { words::open(lang) };
                vec![
                    point(&term::base(lang), *base),
                    length("R", *base_radius),
                    point(&term::top(lang), *top),
                    length("R", *top_radius),
                    [Cell::Text(ends), Cell::Blank, Cell::Blank, Cell::Blank],
                ]
            }
            Shape::Mesh(mesh) => {
                let geometry = &mesh.geometry;
                let enclosure = enclosures.entry(Arc::as_ptr(geometry)).or_insert_with(|| geometry.enclosure());
                mesh_fields(geometry, *enclosure, lang)
            }
        };
        fields[kind(&object.shape)].push(of_object);
    }
    fields.map(|of_kind| aligned(&of_kind, width).into_iter())
}

/// A label and up to three numbers.
type Field = [Cell; 4];

fn point(label: &str, point: DVec3) -> Field {
    let [x, y, z] = point.to_array().map(Cell::number);
    [Cell::text(label), x, y, z]
}

fn length(label: &str, length: f64) -> Field {
    [Cell::text(label), Cell::number(length), Cell::Blank, Cell::Blank]
}

/// The fields of objects of one kind below each other, as many in a line as fit into the width.
fn aligned(objects: &[Vec<Field>], width: usize) -> Vec<Vec<String>> {
    let most = objects.iter().map(Vec::len).max().unwrap_or(1);
    let table = |in_a_line: usize| {
        let gaps: Vec<usize> = [3, 1, 1, 1]
            .repeat(in_a_line)
            .into_iter()
            .enumerate()
            .map(|(column, gap)| if column == 0 { 0 } else { gap })
            .collect();
        let mut table = Table::new(gaps);
        for line in objects.iter().flat_map(|fields| fields.chunks(in_a_line)) {
            table.push(line.concat());
        }
        table
    };
    let mut in_a_line = most;
    let mut fitting = table(most);
    while in_a_line > 1 && fitting.width() > width {
        in_a_line = in_a_line.div_ceil(2);
        fitting = table(in_a_line);
    }
    let mut lines = fitting.lines().into_iter();
    objects.iter().map(|fields| lines.by_ref().take(fields.len().div_ceil(in_a_line)).collect()).collect()
}

fn mesh_fields(geometry: &MeshGeometry, enclosure: Enclosure, lang: Lang) -> Vec<Field> {
    let enclosure = match enclosure {
        Enclosure::Volume { inverted: false } => words::closed(lang),
        Enclosure::Volume { inverted: true } => words::closed_inwards(lang),
        Enclosure::Sheet => words::sheet(lang),
    };
    let vertices = count::vertices(lang, geometry.positions.len());
    let facets = count::facets(lang, geometry.facets.len());
    [vertices, facets, enclosure].map(|words| [Cell::Text(words), Cell::Blank, Cell::Blank, Cell::Blank]).to_vec()
}

/// What stands below a mesh: each entry a label and items that may be broken into lines.
fn mesh_details(
    mesh: &Mesh,
    bounds: Option<(DVec3, DVec3)>,
    material: &dyn Fn(&MaterialRef) -> String,
    lang: Lang,
) -> Vec<(String, Vec<String>)> {
    let Mesh { geometry, source, placement, smooth } = mesh;
    let mut details = Vec::new();
    if let Some((low, high)) = bounds {
        // They are computed, and four digits are enough to know where the mesh is.
        let [x, y, z] = [0, 1, 2].map(|axis| (rounded(low[axis], 4), rounded(high[axis], 4)));
        details.push((words::bounds(lang, x.0, x.1, y.0, y.1, z.0, z.1), vec![]));
    }
    let unplaced = Placement::default();
    let mut manner = Vec::new();
    if placement.scale != unplaced.scale {
        let uniform = placement.scale == DVec3::splat(placement.scale.x);
        let factors = if uniform { row([placement.scale.x]) } else { row(placement.scale.to_array()) };
        manner.push(format!("{} {factors}", term::scale(lang)));
    }
    if placement.rotation != unplaced.rotation {
        manner.push(format!("{} {}", term::rotation(lang), row(placement.rotation.to_array())));
    }
    if placement.position != unplaced.position {
        manner.push(format!("{} {}", term::position(lang), row(placement.position.to_array())));
    }
    manner.extend(
        smooth.then(|| if geometry.normals.is_empty() { words::smooth(lang) } else { words::file_normals(lang) }),
    );
    manner.extend(source.as_ref().map(|path| words::from_file(lang, clean(path))));
    if !manner.is_empty() {
        details.push((String::new(), manner));
    }
    for part in &geometry.parts {
        let material = material(&part.material);
        let last = u64::from(part.first) + u64::from(part.count) - 1;
        let line = if part.count == 1 {
            words::part_of_one(lang, part.first, material)
        } else {
            words::part(lang, part.first, last, material)
        };
        details.push((line, vec![]));
    }
    if source.is_none() && geometry.positions.len() <= LISTED.0 && geometry.facets.len() <= LISTED.1 {
        let vertices = geometry.positions.iter().map(|position| row(position.to_array())).collect();
        details.push((words::vertices(lang), vertices));
        let facets = geometry.facets.iter().map(|facet| row(facet.map(f64::from))).collect();
        details.push((words::facets(lang), facets));
    }
    details
}

/// A label and items, in lines that are not longer than they must be.
fn wrapped(label: &str, items: &[String], indent: usize) -> Vec<String> {
    let mut lines = vec![format!("{:indent$}{label}", "")];
    let hanging = indent + if label.is_empty() { 0 } else { label.chars().count() + 2 };
    for item in items {
        let last = lines.len() - 1;
        let length = lines[last].chars().count().max(hanging);
        let first_of_line = length == hanging;
        let gap = if first_of_line { 0 } else { 3 };
        if !first_of_line && length + gap + item.chars().count() > COLUMNS {
            lines.push(format!("{:hanging$}{item}", ""));
        } else {
            let line = &mut lines[last];
            let missing = length - line.chars().count() + gap;
            line.extend(std::iter::repeat_n(' ', missing));
            line.push_str(item);
        }
    }
    lines
}
