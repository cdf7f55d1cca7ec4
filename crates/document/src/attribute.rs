//! Setting an attribute: an [`Edit`] replaces a whole item, so each of these takes the item as it is and lets a closure
//! change a copy of it.

use crate::{Item, StepName};
use lancer_scene::{
    Edit, Environment, List, ListEdit, Material, MaterialRef, MeshGeometry, Name, Object, PointLight, Shape, Stage,
    View,
};
use std::sync::Arc;

/// The changed copy of the first item of a list that is looked for.
fn changed<T: Clone>(
    list: &List<T>,
    is: impl Fn(&T) -> bool,
    change: impl FnOnce(&mut T),
    kind: impl FnOnce(ListEdit<T>) -> Edit,
) -> Option<Edit> {
    let index = list.iter().position(|item| is(item))?;
    let mut item = T::clone(list.get(index)?);
    change(&mut item);
    Some(kind(ListEdit::Set { index, item: Arc::new(item) }))
}

/// Changes an object; `None` if there is none of that name.
pub fn edit_object(stage: &Stage, name: &str, change: impl FnOnce(&mut Object)) -> Option<Edit> {
    changed(&stage.scene.objects, |object| &*object.name == name, change, Edit::Objects)
}

/// Changes a lamp; `None` if there is none of that name.
pub fn edit_light(stage: &Stage, name: &str, change: impl FnOnce(&mut PointLight)) -> Option<Edit> {
    changed(&stage.scene.lights, |light| &*light.name == name, change, Edit::Lights)
}

/// Changes a material; `None` if there is none of that name.
pub fn edit_material(stage: &Stage, name: &str, change: impl FnOnce(&mut Material)) -> Option<Edit> {
    changed(&stage.scene.materials, |material| &*material.name == name, change, Edit::Materials)
}

/// Changes a view; `None` if there is none of that name.
pub fn edit_view(stage: &Stage, name: &str, change: impl FnOnce(&mut View)) -> Option<Edit> {
    changed(&stage.views, |view| &*view.name == name, change, Edit::Views)
}

/// Changes what surrounds the objects.
pub fn edit_world(stage: &Stage, change: impl FnOnce(&mut Environment)) -> Edit {
    let mut world = stage.scene.world.clone();
    change(&mut world);
    Edit::World(world)
}

/// The name of the step that sets an attribute, as the documents spell it.
pub fn set(item: &Item, attribute: &'static str) -> StepName {
    StepName::Set { item: item.name().cloned().unwrap_or_else(|| Name::from("")), attribute }
}

/// Gives an object a material. A mesh from a file that has one shows it everywhere, as its document will say: the
/// file's own materials count only where the object has none.
pub fn set_material(object: &mut Object, material: MaterialRef) {
    if material != MaterialRef::Default
        && let Shape::Mesh(mesh) = &mut object.shape
        && mesh.source.is_some()
        && !mesh.geometry.parts.is_empty()
    {
        mesh.geometry = Arc::new(MeshGeometry { parts: Vec::new(), ..MeshGeometry::clone(&mesh.geometry) });
    }
    object.material = material;
}

#[cfg(test)]
mod tests {
    use super::*;
    use lancer_scene::{Mesh, Part, Placement};

    #[test]
    fn a_material_covers_those_of_a_meshs_file_only() {
        let part = Part { material: MaterialRef::Named("red".into()), first: 0, count: 1 };
        let geometry = Arc::new(MeshGeometry { parts: vec![part], ..MeshGeometry::default() });
        let painted = |source: Option<&str>, material| {
            let geometry = Arc::clone(&geometry);
            let mesh = Mesh { geometry, source: source.map(Arc::from), placement: Placement::default(), smooth: false };
            let mut object = Object::new("it", Shape::Mesh(mesh));
            set_material(&mut object, material);
            object.material_refs().cloned().collect::<Vec<_>>()
        };
        let (red, blue) = (MaterialRef::Named("red".into()), MaterialRef::Named("blue".into()));
        assert_eq!(painted(None, blue.clone()), [blue.clone(), red.clone()]);
        assert_eq!(painted(Some("it.obj"), MaterialRef::Default), [MaterialRef::Default, red]);
        assert_eq!(painted(Some("it.obj"), blue.clone()), [blue]);
    }
}
