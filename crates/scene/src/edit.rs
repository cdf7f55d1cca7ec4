//! Edits: the only way a scene or its views change, each with its inverse.

use crate::scene::Stage;
use crate::{
    Environment, Invalid, List, Material, MaterialRef, MeshGeometry, Name, NameKind, Object, PointLight, Shape, View,
};
use std::collections::HashMap;
use std::sync::Arc;

/// A change of a [`Stage`]. Items are addressed by their place in their list.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// Sets the scene's title.
    Title(String),
    /// Sets ambient light, background, medium, depth and composition.
    World(Environment),
    /// Changes the materials. Setting one under a new name renames it wherever it is referred to.
    Materials(ListEdit<Material>),
    /// Changes the lamps.
    Lights(ListEdit<PointLight>),
    /// Changes the objects.
    Objects(ListEdit<Object>),
    /// Changes the views.
    Views(ListEdit<View>),
    /// Several edits as one, in order; all of them happen or none.
    Batch(Vec<Edit>),
}

/// A change of one list.
#[derive(Clone, Debug, PartialEq)]
pub enum ListEdit<T> {
    /// Replaces the item at a place.
    Set {
        /// The place.
        index: usize,
        /// The new item.
        item: Arc<T>,
    },
    /// Inserts an item before that place; the list's length appends it.
    Insert {
        /// The place.
        index: usize,
        /// The new item.
        item: Arc<T>,
    },
    /// Takes an item out.
    Remove {
        /// The place.
        index: usize,
    },
    /// Takes an item out and inserts it where it then stands at `to`.
    Move {
        /// The place before.
        from: usize,
        /// The place after.
        to: usize,
    },
}

/// Why an edit cannot be made. The stage is then as it was.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EditError {
    /// There is no item at that place.
    #[error("there is no item {index} in a list of {len}")]
    NoSuchItem {
        /// The place.
        index: usize,
        /// The list's length.
        len: usize,
    },
    /// The result would break a rule.
    #[error(transparent)]
    Invalid(#[from] Invalid),
    /// The material is still in use.
    #[error("the material `{name}` is used by `{user}`")]
    MaterialInUse {
        /// The material.
        name: Name,
        /// The first object that names it.
        user: Name,
    },
}

impl<T> ListEdit<T> {
    /// Edits the list and gives the edit that takes it back. On an error the list is as it was.
    fn apply(&self, list: &mut List<T>) -> Result<ListEdit<T>, EditError> {
        let len = list.len();
        let existing = |index: usize| list.get(index).cloned().ok_or(EditError::NoSuchItem { index, len });
        match self {
            ListEdit::Set { index, item } => {
                let (index, old) = (*index, existing(*index)?);
                list.change(|items| items[index] = Arc::clone(item));
                Ok(ListEdit::Set { index, item: old })
            }
            ListEdit::Insert { index, item } => {
                let index = *index;
                if index > len {
                    return Err(EditError::NoSuchItem { index, len });
                }
                list.change(|items| items.insert(index, Arc::clone(item)));
                Ok(ListEdit::Remove { index })
            }
            ListEdit::Remove { index } => {
                let (index, item) = (*index, existing(*index)?);
                list.change(|items| drop(items.remove(index)));
                Ok(ListEdit::Insert { index, item })
            }
            ListEdit::Move { from, to } => {
                let (from, to) = (*from, *to);
                existing(from)?;
                existing(to)?;
                list.change(|items| {
                    let item = items.remove(from);
                    items.insert(to, item);
                });
                Ok(ListEdit::Move { from: to, to: from })
            }
        }
    }

    /// The item that the edit brings in, and the place of the one that it replaces.
    fn incoming(&self) -> Option<(&T, Option<usize>)> {
        match self {
            ListEdit::Set { index, item } => Some((item, Some(*index))),
            ListEdit::Insert { item, .. } => Some((item, None)),
            ListEdit::Remove { .. } | ListEdit::Move { .. } => None,
        }
    }
}

impl Stage {
    /// The stage after the edit, and the edit that takes it back: applied to the new stage it gives this one.
    ///
    /// # Errors
    /// The place that does not exist or the rule that the result would break.
    pub fn apply(&self, edit: &Edit) -> Result<(Stage, Edit), EditError> {
        let mut next = self.clone();
        let inverse = next.change(edit)?;
        Ok((next, inverse))
    }

    /// Edits the stage and gives the edit that takes it back. After an error, a part of a batch may have been made.
    ///
    /// What an item keeps of the one that it replaces is not checked again: its name, the geometry of a mesh. So a drag
    /// of many objects or of a large one costs what it changes.
    fn change(&mut self, edit: &Edit) -> Result<Edit, EditError> {
        let scene = &mut self.scene;
        Ok(match edit {
            Edit::Title(name) => Edit::Title(std::mem::replace(&mut scene.name, name.clone())),
            Edit::World(world) => {
                world.check()?;
                Edit::World(std::mem::replace(&mut scene.world, world.clone()))
            }
            Edit::Materials(change) => {
                if let Some((material, replaced)) = change.incoming() {
                    material.check()?;
                    let kept = replaced.and_then(|index| scene.materials.get(index));
                    if kept.is_none_or(|kept| kept.name != material.name) {
                        let names = scene.materials.iter().map(|item| &item.name);
                        free(&material.name, names, replaced, NameKind::Material)?;
                    }
                }
                if let ListEdit::Remove { index } = change
                    && let Some(material) = scene.materials.get(*index)
                {
                    unused(&scene.objects, &material.name)?;
                }
                let inverse = change.apply(&mut scene.materials)?;
                if let (ListEdit::Set { item: new, .. }, ListEdit::Set { item: old, .. }) = (change, &inverse) {
                    scene.objects = renamed(&scene.objects, &old.name, &new.name);
                }
                Edit::Materials(inverse)
            }
            Edit::Lights(change) => {
                if let Some((light, replaced)) = change.incoming() {
                    light.check()?;
                    let kept = replaced.and_then(|index| scene.lights.get(index));
                    if kept.is_none_or(|kept| kept.name != light.name) {
                        let kind = NameKind::ObjectOrLight;
                        free(&light.name, scene.lights.iter().map(|item| &item.name), replaced, kind)?;
                        free(&light.name, scene.objects.iter().map(|item| &item.name), None, kind)?;
                    }
                }
                Edit::Lights(change.apply(&mut scene.lights)?)
            }
            Edit::Objects(change) => {
                if let Some((object, replaced)) = change.incoming() {
                    let kept = replaced.and_then(|index| scene.objects.get(index));
                    let geometries = (kept.and_then(|kept| kept.shape.geometry()), object.shape.geometry());
                    if let (Some(kept), Some(new)) = geometries
                        && Arc::ptr_eq(kept, new)
                    {
                        object.check_instance()?;
                    } else {
                        object.check()?;
                    }
                    if kept.is_none_or(|kept| kept.name != object.name) {
                        let kind = NameKind::ObjectOrLight;
                        free(&object.name, scene.objects.iter().map(|item| &item.name), replaced, kind)?;
                        free(&object.name, scene.lights.iter().map(|item| &item.name), None, kind)?;
                    }
                    for name in object.material_refs().filter_map(MaterialRef::name) {
                        if scene.material(name).is_none() {
                            return Err(Invalid::UnknownMaterial { name: name.clone() }.into());
                        }
                    }
                }
                Edit::Objects(change.apply(&mut scene.objects)?)
            }
            Edit::Views(change) => {
                if let Some((view, replaced)) = change.incoming() {
                    view.check()?;
                    let kept = replaced.and_then(|index| self.views.get(index));
                    if kept.is_none_or(|kept| kept.name != view.name) {
                        free(&view.name, self.views.iter().map(|item| &item.name), replaced, NameKind::View)?;
                    }
                }
                Edit::Views(change.apply(&mut self.views)?)
            }
            Edit::Batch(edits) => {
                let inverses = edits.iter().map(|edit| self.change(edit)).collect::<Result<Vec<Edit>, EditError>>();
                Edit::Batch(inverses?.into_iter().rev().collect())
            }
        })
    }
}

/// Whether a name is free among others, not counting the item that it replaces.
fn free<'a>(
    name: &Name,
    others: impl Iterator<Item = &'a Name>,
    replaced: Option<usize>,
    kind: NameKind,
) -> Result<(), Invalid> {
    for (index, other) in others.enumerate() {
        if Some(index) != replaced && other == name {
            return Err(Invalid::NameTaken { name: name.clone(), kind });
        }
    }
    Ok(())
}

/// Whether no object names the material.
fn unused(objects: &List<Object>, name: &Name) -> Result<(), EditError> {
    match objects.iter().find(|object| object.material_refs().any(|material| material.name() == Some(name))) {
        Some(user) => Err(EditError::MaterialInUse { name: name.clone(), user: user.name.clone() }),
        None => Ok(()),
    }
}

/// The objects with every reference to `old` changed to `new`; objects without one are shared, and meshes that shared
/// their geometry share the changed one.
fn renamed(objects: &List<Object>, old: &Name, new: &Name) -> List<Object> {
    let refers = |object: &Object| object.material_refs().any(|material| material.name() == Some(old));
    if old == new || !objects.iter().any(|object| refers(object)) {
        return objects.clone();
    }
    let rename = |material: &mut MaterialRef| {
        if material.name() == Some(old) {
            *material = MaterialRef::Named(new.clone());
        }
    };
    let mut geometries = HashMap::new();
    objects.with(|objects| {
        for object in objects.iter_mut().filter(|object| refers(object)) {
            let object = Arc::make_mut(object);
            rename(&mut object.material);
            if let Shape::Mesh(mesh) = &mut object.shape
                && mesh.geometry.parts.iter().any(|part| part.material.name() == Some(old))
            {
                let renamed = geometries.entry(Arc::as_ptr(&mesh.geometry)).or_insert_with(|| {
                    let mut geometry = MeshGeometry::clone(&mesh.geometry);
                    geometry.parts.iter_mut().for_each(|part| rename(&mut part.material));
                    Arc::new(geometry)
                });
                mesh.geometry = Arc::clone(renamed);
            }
        }
    })
}
