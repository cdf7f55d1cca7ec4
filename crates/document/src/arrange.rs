//! What the outliner does with things that exist: copy, delete, reorder, rename, hide.

use crate::selection::Places;
use crate::{Command, Item, StepName, decimal, gizmo, naming};
use lancer_scene::{
    DVec3, Edit, Invalid, List, ListEdit, Material, MaterialRef, MeshGeometry, Name, NameKind, Object, PointLight,
    Shape, Stage, View,
};
use std::collections::BTreeSet;
use std::sync::Arc;

/// The items that exist and are no world, each once, with their places.
fn placed<'a>(stage: &Stage, items: impl IntoIterator<Item = &'a Item>) -> Vec<(Item, usize)> {
    let (places, distinct) = (Places::of(stage), items.into_iter().collect::<BTreeSet<&Item>>());
    let mut placed: Vec<(Item, usize)> =
        distinct.into_iter().filter_map(|item| places.place(item).map(|place| (item.clone(), place))).collect();
    placed.sort_by_key(|(_, place)| *place);
    placed
}

/// The name of a step about one thing or several.
fn about(
    items: &[(Item, usize)],
    one: impl FnOnce(Name) -> StepName,
    many: impl FnOnce(usize) -> StepName,
) -> StepName {
    match items {
        [(item, _)] => one(item.name().cloned().unwrap_or_else(|| Name::from(""))),
        several => many(several.len()),
    }
}

/// The step that deletes things. Objects that keep a deleted material's name get the built-in grey instead.
/// `None` where nothing of it exists.
pub fn deleted<'a>(stage: &Stage, items: impl IntoIterator<Item = &'a Item>) -> Option<Command> {
    let items = placed(stage, items);
    let (mut edits, mut materials, mut objects) = (Vec::new(), BTreeSet::new(), BTreeSet::new());
    for (item, _) in &items {
        match item {
            Item::Material(name) => drop(materials.insert(name.clone())),
            Item::Object(name) => drop(objects.insert(name.clone())),
            Item::World | Item::Light(_) | Item::View(_) => {}
        }
    }
    let mut geometries = Vec::new();
    for (index, object) in stage.scene.objects.iter().enumerate() {
        let refers = object.material_refs().filter_map(MaterialRef::name).any(|name| materials.contains(name));
        if refers && !objects.contains(&object.name) {
            let item = Arc::new(without_materials(object, &materials, &mut geometries));
            edits.push(Edit::Objects(ListEdit::Set { index, item }));
        }
    }
    // from the end, so that the places before stay true; materials when the objects are gone that have them
    let (last, first): (Vec<_>, Vec<_>) = items.iter().rev().partition(|(item, _)| matches!(item, Item::Material(_)));
    for (item, index) in first.into_iter().chain(last) {
        let index = *index;
        edits.push(match item {
            Item::World => continue,
            Item::Light(_) => Edit::Lights(ListEdit::Remove { index }),
            Item::Object(_) => Edit::Objects(ListEdit::Remove { index }),
            Item::Material(_) => Edit::Materials(ListEdit::Remove { index }),
            Item::View(_) => Edit::Views(ListEdit::Remove { index }),
        });
    }
    let name = about(&items, StepName::Deleted, StepName::DeletedMany);
    (!edits.is_empty()).then(|| Command::new(name, Edit::Batch(edits)))
}

/// The object with the built-in grey in place of some materials. Meshes that shared their geometry share it again.
fn without_materials(
    object: &Object,
    materials: &BTreeSet<Name>,
    geometries: &mut Vec<(Arc<MeshGeometry>, Arc<MeshGeometry>)>,
) -> Object {
    let cleared = |material: &mut MaterialRef| {
        if material.name().is_some_and(|name| materials.contains(name)) {
            *material = MaterialRef::Default;
        }
    };
    let mut object = Object::clone(object);
    cleared(&mut object.material);
    if let Shape::Mesh(mesh) = &mut object.shape
        && mesh.geometry.parts.iter().any(|part| part.material.name().is_some_and(|name| materials.contains(name)))
    {
        let known = geometries.iter().find(|(old, _)| Arc::ptr_eq(old, &mesh.geometry));
        mesh.geometry = match known {
            Some((_, new)) => Arc::clone(new),
            None => {
                let mut new = MeshGeometry::clone(&mesh.geometry);
                new.parts.iter_mut().for_each(|part| cleared(&mut part.material));
                let new = Arc::new(new);
                geometries.push((Arc::clone(&mesh.geometry), Arc::clone(&new)));
                new
            }
        };
    }
    object
}

/// The step that copies things, each behind its original and a little beside it; the copies are selected then.
/// `None` where nothing of it exists.
pub fn duplicated<'a>(stage: &Stage, items: impl IntoIterator<Item = &'a Item>) -> Option<Command> {
    let items = placed(stage, items);
    let mut taken = naming::taken(stage);
    let (mut edits, mut copies, mut last) = (Vec::new(), Vec::new(), None);
    for (item, place) in items.iter().rev() {
        let (index, place) = (place + 1, *place);
        let Some(original) = item.name() else { continue };
        let name = naming::copy(original, &taken);
        taken.insert(name.clone());
        last = Some(name.clone());
        let scene = &stage.scene;
        let (edit, copy) = match item {
            Item::World => continue,
            Item::Light(_) => {
                let Some(light) = scene.lights.get(place) else { continue };
                let item = Arc::new(beside_light(light, name.clone()));
                (Edit::Lights(ListEdit::Insert { index, item }), Item::Light(name))
            }
            Item::Object(_) => {
                let Some(object) = scene.objects.get(place) else { continue };
                let item = Arc::new(beside(object, name.clone()));
                (Edit::Objects(ListEdit::Insert { index, item }), Item::Object(name))
            }
            Item::Material(_) => {
                let Some(material) = scene.materials.get(place) else { continue };
                let item = Arc::new(Material { name: name.clone(), ..Material::clone(material) });
                (Edit::Materials(ListEdit::Insert { index, item }), Item::Material(name))
            }
            Item::View(_) => {
                let Some(view) = stage.views.get(place) else { continue };
                let item = Arc::new(View { name: name.clone(), ..View::clone(view) });
                (Edit::Views(ListEdit::Insert { index, item }), Item::View(name))
            }
        };
        edits.push(edit);
        copies.push(copy);
    }
    copies.reverse();
    let name = match copies.len() {
        1 => StepName::Duplicated(last?),
        count => StepName::DuplicatedMany(count),
    };
    (!edits.is_empty()).then(|| Command::new(name, Edit::Batch(edits)).selecting(copies))
}

/// A copy of an object, moved along x by its width so that both are seen; in the same place where there is no room.
fn beside(object: &Object, name: Name) -> Object {
    let copy = Object { name, ..Object::clone(object) };
    let width = match &object.shape {
        Shape::Plane { p0, p1, p2 } => (*p1 - *p0).length().min((*p2 - *p0).length()),
        Shape::Sphere { .. }
        | Shape::Facet { .. }
        | Shape::Cube { .. }
        | Shape::Parallelepiped { .. }
        | Shape::Cone { .. }
        | Shape::Mesh(_) => object.shape.bounds().map_or(0.0, |(low, high)| high.x - low.x),
    };
    let by = match &object.shape {
        // a plane that slides along itself would not be seen
        Shape::Plane { p0, p1, p2 } => (*p1 - *p0).cross(*p2 - *p0).normalize_or(DVec3::Y) * (width * 0.25),
        Shape::Sphere { .. }
        | Shape::Facet { .. }
        | Shape::Cube { .. }
        | Shape::Parallelepiped { .. }
        | Shape::Cone { .. }
        | Shape::Mesh(_) => DVec3::X * (width * 1.1),
    };
    let by = decimal::rounded_point(by, decimal::places(width.max(1e-9)) + 2);
    let moved = gizmo::translated(&copy, by);
    if moved.check().is_ok() { moved } else { copy }
}

/// A copy of a lamp, moved along x by a part of its height.
fn beside_light(light: &PointLight, name: Name) -> PointLight {
    let copy = PointLight { name, ..PointLight::clone(light) };
    let by = DVec3::X * decimal::round_length(light.position.length() * 0.2);
    let moved = gizmo::translated_light(&copy, by);
    if moved.check().is_ok() { moved } else { copy }
}

/// The step that brings a thing to another place of its list, at most the last one. `None` where it stands there.
pub fn reordered(stage: &Stage, item: &Item, to: usize) -> Option<Command> {
    let from = item.place(stage)?;
    let name = item.name()?.clone();
    let moved = |len: usize| (from, to.min(len - 1));
    let (from, to) = match item {
        Item::World => return None,
        Item::Light(_) => moved(stage.scene.lights.len()),
        Item::Object(_) => moved(stage.scene.objects.len()),
        Item::Material(_) => moved(stage.scene.materials.len()),
        Item::View(_) => moved(stage.views.len()),
    };
    let edit = match item {
        Item::World => return None,
        Item::Light(_) => Edit::Lights(ListEdit::Move { from, to }),
        Item::Object(_) => Edit::Objects(ListEdit::Move { from, to }),
        Item::Material(_) => Edit::Materials(ListEdit::Move { from, to }),
        Item::View(_) => Edit::Views(ListEdit::Move { from, to }),
    };
    (from != to).then(|| Command::new(StepName::Reordered(name), edit))
}

/// The step that renames a thing; white space around the new name is taken off. `None` where nothing changes.
///
/// # Errors
/// The name is empty or taken.
pub fn renamed(stage: &Stage, item: &Item, new: &str) -> Result<Option<Command>, Invalid> {
    let (Some(old), Some(index)) = (item.name(), item.place(stage)) else { return Ok(None) };
    let new: Name = new.trim().into();
    if new.is_empty() {
        return Err(Invalid::BadName);
    }
    if new == *old {
        return Ok(None);
    }
    let scene = &stage.scene;
    let free = |taken: bool, kind| if taken { Err(Invalid::NameTaken { name: new.clone(), kind }) } else { Ok(()) };
    let edit = match item {
        Item::World => return Ok(None),
        Item::Light(_) => {
            free(scene.has_object_or_light(&new), NameKind::ObjectOrLight)?;
            set_name(&scene.lights, index, |light: &mut PointLight| light.name = new.clone()).map(Edit::Lights)
        }
        Item::Object(_) => {
            free(scene.has_object_or_light(&new), NameKind::ObjectOrLight)?;
            set_name(&scene.objects, index, |object: &mut Object| object.name = new.clone()).map(Edit::Objects)
        }
        Item::Material(_) => {
            free(scene.material(&new).is_some(), NameKind::Material)?;
            set_name(&scene.materials, index, |material: &mut Material| material.name = new.clone())
                .map(Edit::Materials)
        }
        Item::View(_) => {
            free(stage.views.iter().any(|view| view.name == new), NameKind::View)?;
            set_name(&stage.views, index, |view: &mut View| view.name = new.clone()).map(Edit::Views)
        }
    };
    Ok(edit.map(|edit| Command::new(StepName::Renamed { from: old.clone(), to: new.clone() }, edit)))
}

fn set_name<T: Clone>(list: &List<T>, index: usize, change: impl FnOnce(&mut T)) -> Option<ListEdit<T>> {
    let mut item = T::clone(list.get(index)?);
    change(&mut item);
    Some(ListEdit::Set { index, item: Arc::new(item) })
}

/// The step that lets objects and lamps take part in the picture, or not. `None` where nothing changes.
pub fn shown<'a>(stage: &Stage, items: impl IntoIterator<Item = &'a Item>, visible: bool) -> Option<Command> {
    let (scene, mut edits) = (&stage.scene, Vec::new());
    let mut items = placed(stage, items);
    items.retain(|(item, index)| {
        let index = *index;
        let edit = match item {
            Item::Object(_) => scene.objects.get(index).filter(|object| object.visible != visible).map(|object| {
                let item = Arc::new(Object { visible, ..Object::clone(object) });
                Edit::Objects(ListEdit::Set { index, item })
            }),
            Item::Light(_) => scene.lights.get(index).filter(|light| light.visible != visible).map(|light| {
                let item = Arc::new(PointLight { visible, ..PointLight::clone(light) });
                Edit::Lights(ListEdit::Set { index, item })
            }),
            Item::World | Item::Material(_) | Item::View(_) => None,
        };
        let changes = edit.is_some();
        edits.extend(edit);
        changes
    });
    let name = if visible {
        about(&items, StepName::Shown, StepName::ShownMany)
    } else {
        about(&items, StepName::Hidden, StepName::HiddenMany)
    };
    (!edits.is_empty()).then(|| Command::new(name, Edit::Batch(edits)))
}

/// The step that sets the scene's title. `None` where it has it.
pub fn titled(stage: &Stage, title: &str) -> Option<Command> {
    (stage.scene.name != title).then(|| Command::new(StepName::Titled, Edit::Title(title.to_owned())))
}
