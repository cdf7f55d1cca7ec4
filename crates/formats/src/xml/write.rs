//! The canonical layout: one thing a line, attributes in the vocabulary's order, defaults left out, names in columns.

use super::escape;
use super::values::{self, Values, written};
use super::vocabulary::{
    EYE, ElementRule, FACETS, LIGHT, MATERIAL, NORMALS, PART, SCENE, SCREEN, VERSION, VERTICES, VIEW, VIEWS, WORLD,
};
use lancer_scene::{DVec3, MaterialRef, Mesh, Object, Part, Scene, Shape, View, Views};
use std::fmt::Write as _;

/// The first line of every document that is written.
const DECLARATION: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
/// One step of indentation.
pub(super) const STEP: &str = "  ";
/// A list of numbers stands on one line if it is no longer than this.
const LINE: usize = 100;
/// Names up to this many characters are padded, so that what follows stands in a column.
const NAME: usize = 16;

/// A scene as a native document in the canonical layout. What was read from it reads back as the same scene.
///
/// A mesh that was read from a file is written as the path of that file. In the title, characters that no XML document
/// may hold become U+FFFD; checked names hold none.
pub fn write_scene(scene: &Scene) -> String {
    let mut out = String::from(DECLARATION);
    begin(&mut out, "", &SCENE, &values::scene(scene), Columns::default());
    out.push_str(">\n");
    write_content(&mut out, scene);
    end(&mut out, "", &SCENE);
    out
}

/// Everything within `scene`: its groups, with an empty line between them.
pub(super) fn write_content(out: &mut String, scene: &Scene) {
    let begun = out.len();
    let gap = |out: &mut String| out.push_str(if out.len() > begun { "\n" } else { "" });
    let world = values::world(&scene.world);
    if !written(&WORLD, &world).is_empty() {
        write_line(out, STEP, &WORLD, &world);
    }
    if !scene.materials.is_empty() {
        gap(out);
        let columns = Columns::of(scene.materials.iter().map(|material| (MATERIAL.name, &*material.name)));
        for material in &scene.materials {
            begin(out, STEP, &MATERIAL, &values::material(material), columns);
            out.push_str("/>\n");
        }
    }
    if !scene.lights.is_empty() {
        gap(out);
        let columns = Columns::of(scene.lights.iter().map(|light| (LIGHT.name, &*light.name)));
        for light in &scene.lights {
            begin(out, STEP, &LIGHT, &values::light(light), columns);
            out.push_str("/>\n");
        }
    }
    if !scene.objects.is_empty() {
        gap(out);
        let columns = Columns::of(scene.objects.iter().map(|object| (object.shape.element(), &*object.name)));
        for object in &scene.objects {
            write_object(out, STEP, object, columns);
        }
    }
}

/// An element of nothing but attributes, on a line of its own.
pub(super) fn write_line(out: &mut String, indent: &str, rule: &'static ElementRule, values: &Values<'_>) {
    begin(out, indent, rule, values, Columns::default());
    out.push_str("/>\n");
}

/// Views as a native document in the canonical layout. What was read from it reads back as the same views.
pub fn write_views(views: &Views) -> String {
    let mut out = String::from(DECLARATION);
    let _ = writeln!(out, "<{} version=\"{VERSION}\">", VIEWS.name);
    for view in views {
        write_view(&mut out, STEP, view);
    }
    end(&mut out, "", &VIEWS);
    out
}

pub(super) fn write_view(out: &mut String, indent: &str, view: &View) {
    let inner = format!("{indent}{STEP}");
    begin(out, indent, &VIEW, &values::view(view), Columns::default());
    out.push_str(">\n");
    write_line(out, &inner, &EYE, &values::eye(view));
    if let Some(screen) = values::screen(view) {
        write_line(out, &inner, &SCREEN, &screen);
    }
    end(out, indent, &VIEW);
}

pub(super) fn write_object(out: &mut String, indent: &str, object: &Object, columns: Columns) {
    let rule = values::shape_rule(&object.shape);
    begin(out, indent, rule, &values::object(object), columns);
    let inline_mesh = match &object.shape {
        Shape::Mesh(mesh) if mesh.source.is_none() => Some(mesh),
        Shape::Sphere { .. }
        | Shape::Plane { .. }
        | Shape::Facet { .. }
        | Shape::Cube { .. }
        | Shape::Parallelepiped { .. }
        | Shape::Cone { .. }
        | Shape::Mesh(_) => None,
    };
    if inline_mesh.is_none() && !is_inline(&object.material) {
        out.push_str("/>\n");
        return;
    }
    out.push_str(">\n");
    let inner = format!("{indent}{STEP}");
    write_inline(out, &inner, &object.material);
    if let Some(mesh) = inline_mesh {
        write_geometry(out, &inner, mesh);
    }
    end(out, indent, rule);
}

fn is_inline(material: &MaterialRef) -> bool {
    matches!(material, MaterialRef::Inline(_))
}

/// An inline material on a line of its own; nothing for other materials.
pub(super) fn write_inline(out: &mut String, indent: &str, material: &MaterialRef) {
    if let MaterialRef::Inline(surface) = material {
        write_line(out, indent, &MATERIAL, &values::surface(surface));
    }
}

fn write_geometry(out: &mut String, indent: &str, mesh: &Mesh) {
    let geometry = &mesh.geometry;
    let mut list = |rule: &ElementRule, write: &dyn Fn(&mut String)| {
        out.push_str(indent);
        write_list(out, rule, write);
        out.push('\n');
    };
    list(&VERTICES, &|out| write_points(out, indent, &geometry.positions));
    if !geometry.normals.is_empty() {
        list(&NORMALS, &|out| write_points(out, indent, &geometry.normals));
    }
    list(&FACETS, &|out| write_facets(out, indent, &geometry.facets));
    for part in &geometry.parts {
        write_part(out, indent, part);
    }
}

/// An element around what `write` writes.
fn write_list(out: &mut String, rule: &ElementRule, write: impl FnOnce(&mut String)) {
    let _ = write!(out, "<{}>", rule.name);
    write(out);
    let _ = write!(out, "</{}>", rule.name);
}

pub(super) fn write_part(out: &mut String, indent: &str, part: &Part) {
    begin(out, indent, &PART, &values::part(part), Columns::default());
    if is_inline(&part.material) {
        out.push_str(">\n");
        write_inline(out, &format!("{indent}{STEP}"), &part.material);
        end(out, indent, &PART);
    } else {
        out.push_str("/>\n");
    }
}

/// The text of a list of points within an element at `indent`.
pub(super) fn write_points(out: &mut String, indent: &str, points: &[DVec3]) {
    let write = |out: &mut String, point: &DVec3| {
        let mut gap = "";
        for number in point.to_array() {
            out.push_str(gap);
            push_number(out, number);
            gap = " ";
        }
    };
    write_items(out, indent, points, write);
}

/// The text of a list of facets within an element at `indent`.
pub(super) fn write_facets(out: &mut String, indent: &str, facets: &[[u32; 3]]) {
    let write = |out: &mut String, [a, b, c]: &[u32; 3]| {
        let _ = write!(out, "{a} {b} {c}");
    };
    write_items(out, indent, facets, write);
}

/// Short lists stand on the line of their tags, others with one item a line.
fn write_items<T>(out: &mut String, indent: &str, items: &[T], write: impl Fn(&mut String, &T)) {
    let begun = out.len();
    for (number, item) in items.iter().enumerate() {
        out.push_str(if number == 0 { "" } else { STEP });
        write(out, item);
        if out.len() - begun > LINE {
            break;
        }
    }
    if out.len() - begun <= LINE {
        return;
    }
    out.truncate(begun);
    for item in items {
        let _ = write!(out, "\n{indent}{STEP}");
        write(out, item);
    }
    let _ = write!(out, "\n{indent}");
}

/// The shortest decimal that reads back as the same number, as [`super::shortest`] gives it.
fn push_number(out: &mut String, number: f64) {
    let _ = write!(out, "{number:?}");
    if out.ends_with(".0") {
        out.truncate(out.len() - 2);
    }
}

/// How far element names and names are padded within a group of like lines.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Columns {
    element: usize,
    name: usize,
}

impl Columns {
    /// The widths for elements and names.
    fn of<'l>(lines: impl Iterator<Item = (&'l str, &'l str)>) -> Columns {
        lines.fold(Columns::default(), |widest, (element, name)| {
            let name = Some(escape(name).chars().count()).filter(|width| *width <= NAME).unwrap_or_default();
            Columns { element: widest.element.max(element.len()), name: widest.name.max(name) }
        })
    }
}

/// A start tag up to its last attribute.
fn begin(out: &mut String, indent: &str, rule: &'static ElementRule, values: &Values<'_>, columns: Columns) {
    let _ = write!(out, "{indent}<{}", rule.name);
    let mut padding = columns.element.saturating_sub(rule.name.len());
    for (name, text) in written(rule, values) {
        let value = escape(&text);
        let _ = write!(out, "{:padding$} {name}=\"{value}\"", "");
        padding = if name == "name" { columns.name.saturating_sub(value.chars().count()) } else { 0 };
    }
}

fn end(out: &mut String, indent: &str, rule: &ElementRule) {
    let _ = writeln!(out, "{indent}</{}>", rule.name);
}
