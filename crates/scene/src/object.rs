//! Objects: a shape with a surface and a name.

use crate::{MaterialRef, Name, Shape};

/// One entry of a scene's list of objects.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Unique among objects and lamps.
    pub name: Name,
    /// Its surface; the parts of a mesh may have their own.
    pub material: MaterialRef,
    /// `false`: takes no part in the picture (no hit, shadow, light or medium) and is kept in the scene.
    pub visible: bool,
    /// Its geometry.
    pub shape: Shape,
}

impl Object {
    /// A visible object of the built-in grey.
    pub fn new(name: impl Into<Name>, shape: Shape) -> Object {
        Object { name: name.into(), material: MaterialRef::Default, visible: true, shape }
    }

    /// Every material that the object names: its own and those of a mesh's parts.
    pub fn material_refs(&self) -> impl Iterator<Item = &MaterialRef> {
        let parts = self.shape.geometry().map_or(&[][..], |geometry| geometry.parts.as_slice());
        std::iter::once(&self.material).chain(parts.iter().map(|part| &part.material))
    }
}
