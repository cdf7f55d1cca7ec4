//! Brings the element of one object from one state of the model to another.

use super::super::vocabulary::{FACETS, MATERIAL, NORMALS, PART, VERTICES};
use super::super::write::{self, Columns};
use super::super::{Element, values};
use super::attributes::patch_attributes;
use super::splices::Splices;
use lancer_scene::{MaterialRef, MeshGeometry, Object, Part, Shape};

/// Changes what differs between two states of an object. If it has become another kind of object, its element is written
/// anew. With `name_it`, the name is written out even if it has not changed.
pub(super) fn patch_object<'d>(
    splices: &mut Splices<'d>,
    element: Element<'d>,
    old: &Object,
    new: &Object,
    name_it: bool,
) {
    let (old_inline, new_inline) = (inline_geometry(&old.shape), inline_geometry(&new.shape));
    if old.shape.element() != new.shape.element() || old_inline.is_some() != new_inline.is_some() {
        let indent = splices.indent(element);
        let lines = splices.written(|out| write::write_object(out, &indent, new, Columns::default()));
        splices.replace(element.span(), lines.trim());
        return;
    }
    let rule = values::shape_rule(&new.shape);
    patch_attributes(splices, element, rule, &values::object(old), &values::object(new), name_it);
    patch_inline_material(splices, element, &old.material, &new.material);
    if let (Some(old), Some(new)) = (old_inline, new_inline)
        && old != new
    {
        patch_geometry(splices, element, old, new);
    }
}

/// The geometry that stands in the document itself.
fn inline_geometry(shape: &Shape) -> Option<&MeshGeometry> {
    match shape {
        Shape::Mesh(mesh) if mesh.source.is_none() => Some(&mesh.geometry),
        Shape::Sphere { .. }
        | Shape::Plane { .. }
        | Shape::Facet { .. }
        | Shape::Cube { .. }
        | Shape::Parallelepiped { .. }
        | Shape::Cone { .. }
        | Shape::Mesh(_) => None,
    }
}

fn child<'d>(element: Element<'d>, name: &str) -> Option<Element<'d>> {
    element.elements().find(|child| child.name() == name)
}

/// The inline material of an object or a part: changed in place, taken out, or put first.
fn patch_inline_material<'d>(splices: &mut Splices<'d>, element: Element<'d>, old: &MaterialRef, new: &MaterialRef) {
    let standing = child(element, MATERIAL.name);
    match (standing, old, new) {
        (Some(standing), MaterialRef::Inline(old), MaterialRef::Inline(new)) => {
            patch_attributes(splices, standing, &MATERIAL, &values::surface(old), &values::surface(new), false);
        }
        (Some(standing), _, _) => splices.remove(standing),
        (None, _, MaterialRef::Inline(_)) => {
            let indent = splices.inner_indent(element);
            let lines = splices.written(|out| write::write_inline(out, &indent, new));
            match element.elements().next() {
                Some(first) => splices.insert_before(first, &lines),
                None => splices.insert_within(element, &lines),
            }
        }
        (None, _, MaterialRef::Default | MaterialRef::Named(_)) => {}
    }
}

/// The lists and parts of an inline mesh, each if it differs.
fn patch_geometry<'d>(splices: &mut Splices<'d>, element: Element<'d>, old: &MeshGeometry, new: &MeshGeometry) {
    let indent = splices.inner_indent(element);
    let [vertices, normals, facets] = [&VERTICES, &NORMALS, &FACETS].map(|rule| child(element, rule.name));
    if let Some(vertices) = vertices.filter(|_| old.positions != new.positions) {
        let text = splices.written(|out| write::write_points(out, &indent, &new.positions));
        replace_content(splices, vertices, &text);
    }
    if old.normals != new.normals {
        let text = splices.written(|out| write::write_points(out, &indent, &new.normals));
        match (normals, vertices) {
            (Some(normals), _) if new.normals.is_empty() => splices.remove(normals),
            (Some(normals), _) => replace_content(splices, normals, &text),
            (None, Some(vertices)) => {
                let name = NORMALS.name;
                let line = format!("{indent}<{name}>{text}</{name}>{}", splices.line_end());
                splices.insert_after(vertices, &line);
            }
            (None, None) => {}
        }
    }
    if let Some(facets) = facets.filter(|_| old.facets != new.facets) {
        let text = splices.written(|out| write::write_facets(out, &indent, &new.facets));
        replace_content(splices, facets, &text);
    }
    let parts: Vec<Element<'d>> = element.elements().filter(|child| child.name() == PART.name).collect();
    if old.parts.len() == new.parts.len() {
        for ((old, new), part) in old.parts.iter().zip(&new.parts).zip(parts) {
            patch_part(splices, part, old, new);
        }
    } else if let Some(anchor) = element.elements().last() {
        let lines = splices.written(|out| new.parts.iter().for_each(|part| write::write_part(out, &indent, part)));
        if !lines.is_empty() {
            splices.insert_after(anchor, &lines);
        }
        parts.into_iter().for_each(|part| splices.remove(part));
    }
}

fn patch_part<'d>(splices: &mut Splices<'d>, element: Element<'d>, old: &Part, new: &Part) {
    patch_attributes(splices, element, &PART, &values::part(old), &values::part(new), false);
    patch_inline_material(splices, element, &old.material, &new.material);
}

/// Puts another list of numbers into an element.
fn replace_content(splices: &mut Splices<'_>, element: Element<'_>, text: &str) {
    match element.content_span() {
        Some(content) => splices.replace(content, text),
        None => {
            let name = element.name();
            splices.replace(element.span(), format!("<{name}>{text}</{name}>"));
        }
    }
}
