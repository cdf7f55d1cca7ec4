//! The scene: an immutable snapshot whose parts are shared.

use crate::{Environment, List, Material, MaterialRef, Name, Object, PointLight, Surface, Views};
use std::sync::Arc;

/// Everything that is in a scene. A clone is cheap; an [`crate::Edit`] gives a new one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// The scene's title; may be empty.
    pub name: String,
    /// Ambient light, background, medium, depth, composition.
    pub world: Environment,
    /// The named materials, in document order.
    pub materials: List<Material>,
    /// The lamps, in document order: the order of their terms.
    pub lights: List<PointLight>,
    /// The objects, in document order: the order that decides between equal distances.
    pub objects: List<Object>,
}

/// A scene and its views: all that an edit can change.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stage {
    /// The scene.
    pub scene: Scene,
    /// The views of it.
    pub views: Views,
}

impl Scene {
    /// The material of that name.
    pub fn material(&self, name: &str) -> Option<&Arc<Material>> {
        self.materials.iter().find(|material| &*material.name == name)
    }

    /// The surface that a reference means; the built-in grey where the name is unknown, which a checked scene never has.
    pub fn surface(&self, material: &MaterialRef) -> Surface {
        match material {
            MaterialRef::Default => Surface::default(),
            MaterialRef::Named(name) => self.material(name).map(|found| found.surface.clone()).unwrap_or_default(),
            MaterialRef::Inline(surface) => Surface::clone(surface),
        }
    }

    /// Whether some object or lamp has that name.
    pub fn has_object_or_light(&self, name: &Name) -> bool {
        self.lights.iter().any(|light| light.name == *name) || self.objects.iter().any(|object| object.name == *name)
    }
}
