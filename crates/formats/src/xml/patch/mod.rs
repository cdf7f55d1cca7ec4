//! Saves an edited scene or edited views into the document that they were loaded from: what changed is changed in place,
//! and everything else stays byte for byte: encoding, mark, line ends, comments, order and spacing.

mod attributes;
mod list;
mod object;
mod splices;

use super::naming::AutomaticNames;
use super::read_scene::{ReadScene, SceneReader};
use super::read_views;
use super::sink::Sink;
use super::vocabulary::{EYE, LIGHT, MATERIAL, SCENE, SCREEN, VIEW, WORLD};
use super::write::{self, Columns, write_scene, write_views};
use super::{Document, Element, values};
use crate::Span;
use crate::mesh::{MeshFile, MeshFiles, MeshProblem};
use attributes::patch_attributes;
use lancer_scene::{Environment, MeshGeometry, Name, Scene, View, Views};
use list::{Matching, Place, patch_list};
use object::patch_object;
use splices::Splices;
use std::sync::Arc;

/// The bytes of a document after its scene was edited. An unedited scene gives the very bytes that were read.
///
/// A document that is no legal native scene is written anew in the canonical layout, as UTF-8.
pub fn patch_scene(document: &Document, scene: &Scene) -> Vec<u8> {
    let mut sink = Sink::new(document);
    let old = SceneReader::read(document, &mut Unread, &mut sink);
    match old.filter(|_| !sink.has_failed()) {
        Some(old) => document.encoding().encode(&patched_scene(document, &old, scene)),
        None => write_scene(scene).into_bytes(),
    }
}

/// The bytes of a document after its views were edited. Unedited views give the very bytes that were read.
///
/// A document that is no legal native one is written anew in the canonical layout, as UTF-8; so is one with a bare `view`
/// for its root, if there is now another number of views than one.
pub fn patch_views(document: &Document, views: &Views) -> Vec<u8> {
    let mut sink = Sink::new(document);
    let old = read_views::read(document, &mut sink);
    let bare = document.root().name() == VIEW.name;
    match old.filter(|_| !sink.has_failed() && (!bare || views.len() == 1)) {
        Some(old) => {
            let text = patched_views(document, &old.elements, &old.views, views);
            document.encoding().encode(&text)
        }
        None => write_views(views).into_bytes(),
    }
}

/// Mesh files are not read again: a mesh that has a file is written as its path.
struct Unread;

impl MeshFiles for Unread {
    fn read(&mut self, _path: &str) -> Result<MeshFile, MeshProblem> {
        Ok(MeshFile::new(MeshGeometry::default(), Vec::new()))
    }
}

fn whole(document: &Document) -> Span {
    Span { start: 0, end: document.text().len() }
}

fn patched_scene(document: &Document, old: &ReadScene<'_>, new: &Scene) -> String {
    if old.scene == *new {
        return document.text().to_owned();
    }
    let mut splices = Splices::new(document);
    let root = document.root();
    let before = &old.scene;
    patch_attributes(&mut splices, root, &SCENE, &values::scene(before), &values::scene(new), false);
    if root.content_span().is_none() {
        let lines = splices.written(|out| write::write_content(out, new));
        if !lines.is_empty() {
            splices.insert_within(root, &lines);
        }
        return splices.apply(whole(document));
    }
    patch_world(&mut splices, root, old.world, &before.world, &new.world);

    let groups: [&[Element<'_>]; 4] = [old.world.as_slice(), &old.materials, &old.lights, &old.objects];
    let place = |group: usize| place_of(root, &groups[..=group], &groups[group + 1..]);
    let materials = Matching::of(&before.materials, &new.materials, |material| &material.name);
    let lights = Matching::of(&before.lights, &new.lights, |light| &light.name);
    let objects = Matching::of(&before.objects, &new.objects, |object| &object.name);
    let [name_lights, name_objects] = names_to_write(old, new, &lights, &objects);
    patch_list(
        &mut splices,
        &old.materials,
        &materials,
        place(1),
        |splices, element, from, to| {
            let (old, new) = (values::material(&before.materials[from]), values::material(&new.materials[to]));
            patch_attributes(splices, element, &MATERIAL, &old, &new, false);
        },
        |out, indent, item| write::write_line(out, indent, &MATERIAL, &values::material(&new.materials[item])),
    );
    patch_list(
        &mut splices,
        &old.lights,
        &lights,
        place(2),
        |splices, element, from, to| {
            let (old, new) = (values::light(&before.lights[from]), values::light(&new.lights[to]));
            patch_attributes(splices, element, &LIGHT, &old, &new, name_lights[to]);
        },
        |out, indent, item| write::write_line(out, indent, &LIGHT, &values::light(&new.lights[item])),
    );
    patch_list(
        &mut splices,
        &old.objects,
        &objects,
        place(3),
        |splices, element, from, to| {
            patch_object(splices, element, &before.objects[from], &new.objects[to], name_objects[to]);
        },
        |out, indent, item| write::write_object(out, indent, &new.objects[item], Columns::default()),
    );
    splices.apply(whole(document))
}

fn patch_world<'d>(
    splices: &mut Splices<'d>,
    root: Element<'d>,
    element: Option<Element<'d>>,
    old: &Environment,
    new: &Environment,
) {
    match element {
        Some(element) => {
            patch_attributes(splices, element, &WORLD, &values::world(old), &values::world(new), false);
        }
        None if old == new => {}
        None => {
            let indent = splices.inner_indent(root);
            let lines = splices.written(|out| write::write_line(out, &indent, &WORLD, &values::world(new)));
            match root.elements().next() {
                Some(first) => splices.insert_before(first, &lines),
                None => splices.insert_within(root, &lines),
            }
        }
    }
}

/// Where the first item of a group goes: after the last element of the groups up to its own, or else before the first of
/// the later ones.
fn place_of<'d>(root: Element<'d>, upto: &[&[Element<'d>]], later: &[&[Element<'d>]]) -> Place<'d> {
    let start = |element: &&Element<'d>| element.span().start;
    let last = upto.iter().flat_map(|group| group.iter()).max_by_key(start);
    let first = later.iter().flat_map(|group| group.iter()).min_by_key(start);
    match (last, first) {
        (Some(last), _) => Place::After(*last),
        (None, Some(first)) => Place::Before(*first),
        (None, None) => Place::Within(root),
    }
}

/// Which lamps and objects without a name in the document must be given theirs, because the automatic one would now be
/// another.
fn names_to_write(old: &ReadScene<'_>, new: &Scene, lights: &Matching, objects: &Matching) -> [Vec<bool>; 2] {
    let unnamed = |elements: &[Element<'_>], place: Option<usize>| {
        place.is_some_and(|place| elements[place].attribute("name").is_none())
    };
    // What is renamed or becomes another kind of object gets its name written in any case.
    let mut named_lights: Vec<bool> = (lights.from.iter().zip(&new.lights))
        .map(|(place, light)| {
            !unnamed(&old.lights, *place) || place.is_some_and(|place| old.scene.lights[place].name != light.name)
        })
        .collect();
    let mut named_objects: Vec<bool> = (objects.from.iter().zip(&new.objects))
        .map(|(place, object)| {
            let changed = |place: usize| {
                let old = &old.scene.objects[place];
                old.name != object.name || old.shape.element() != object.shape.element()
            };
            !unnamed(&old.objects, *place) || place.is_some_and(changed)
        })
        .collect();
    // Names written out can change which automatic ones are free, so this is repeated until nothing changes.
    loop {
        let written = named(&named_lights, new.lights.iter().map(|light| &light.name))
            .chain(named(&named_objects, new.objects.iter().map(|object| &object.name)))
            .collect::<Vec<Name>>();
        let mut automatic = AutomaticNames::new(written);
        let mut stable = true;
        let mut check = |named: &mut bool, stem: &'static str, name: &Name| {
            if !*named && automatic.next(stem) != *name {
                (*named, stable) = (true, false);
            }
        };
        for (named, light) in named_lights.iter_mut().zip(&new.lights) {
            check(named, LIGHT.name, &light.name);
        }
        for (named, object) in named_objects.iter_mut().zip(&new.objects) {
            check(named, object.shape.element(), &object.name);
        }
        if stable {
            return [named_lights, named_objects];
        }
    }
}

/// The names that are written out.
fn named<'n>(named: &[bool], names: impl Iterator<Item = &'n Name>) -> impl Iterator<Item = Name> {
    named.iter().zip(names).filter(|(named, _)| **named).map(|(_, name)| name.clone()).collect::<Vec<_>>().into_iter()
}

fn patched_views(document: &Document, elements: &[Element<'_>], old: &Views, new: &Views) -> String {
    let mut splices = Splices::new(document);
    let root = document.root();
    let matching = Matching::of(old, new, |view| &view.name);
    if root.name() == VIEW.name {
        if let ([old], [new]) = (&**old, &**new) {
            patch_view(&mut splices, root, old, new, false);
        }
        return splices.apply(whole(document));
    }
    let mut named: Vec<bool> = (matching.from.iter().zip(new))
        .map(|(place, view)| {
            place.is_none_or(|place| elements[place].attribute("name").is_some() || old[place].name != view.name)
        })
        .collect();
    loop {
        let written: Vec<Name> = self::named(&named, new.iter().map(|view| &view.name)).collect();
        let mut automatic = AutomaticNames::new(written);
        let wrong =
            named.iter_mut().zip(new).filter(|(named, view)| !**named && automatic.next(VIEW.name) != view.name);
        if wrong.map(|(named, _)| *named = true).count() == 0 {
            break;
        }
    }
    patch_list(
        &mut splices,
        elements,
        &matching,
        Place::Within(root),
        |splices, element, from, to| patch_view(splices, element, &old[from], &new[to], named[to]),
        |out, indent, item| write::write_view(out, indent, &new[item]),
    );
    splices.apply(whole(document))
}

fn patch_view<'d>(splices: &mut Splices<'d>, element: Element<'d>, old: &Arc<View>, new: &Arc<View>, name_it: bool) {
    patch_attributes(splices, element, &VIEW, &values::view(old), &values::view(new), name_it);
    let child = |name: &str| element.elements().find(|child| child.name() == name);
    let Some(eye) = child(EYE.name) else { return };
    patch_attributes(splices, eye, &EYE, &values::eye(old), &values::eye(new), false);
    match (child(SCREEN.name), values::screen(old), values::screen(new)) {
        (Some(screen), Some(old), Some(new)) => patch_attributes(splices, screen, &SCREEN, &old, &new, false),
        (Some(screen), _, None) => splices.remove(screen),
        (_, _, Some(new)) => {
            let indent = splices.inner_indent(element);
            let lines = splices.written(|out| write::write_line(out, &indent, &SCREEN, &new));
            splices.insert_after(eye, &lines);
        }
        (None, _, None) => {}
    }
}
