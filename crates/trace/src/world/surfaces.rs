//! The numbers of the surfaces, in the order in which a scene names them.

use lancer_scene::{MaterialRef, Name, Scene, Surface};
use std::collections::HashMap;

/// The surfaces of a scene while it is compiled: 0 is the built-in grey, then the materials in their order, then the
/// inline ones.
pub(crate) struct Surfaces {
    pub(crate) list: Vec<Surface>,
    by_name: HashMap<Name, u32>,
}

impl Surfaces {
    const GREY: u32 = 0;

    pub(crate) fn of(scene: &Scene) -> Surfaces {
        let mut list = vec![Surface::default()];
        let mut by_name = HashMap::new();
        for material in &scene.materials {
            by_name.insert(material.name.clone(), list.len() as u32);
            list.push(material.surface.clone());
        }
        Surfaces { list, by_name }
    }

    /// The number of the surface that a reference means.
    pub(crate) fn number(&mut self, material: &MaterialRef) -> u32 {
        match material {
            MaterialRef::Default => Surfaces::GREY,
            MaterialRef::Named(name) => self.by_name.get(name).copied().unwrap_or(Surfaces::GREY),
            MaterialRef::Inline(surface) => {
                self.list.push(Surface::clone(surface));
                self.list.len() as u32 - 1
            }
        }
    }

    /// Whether the surface lets light through.
    pub(crate) fn is_transparent(&self, number: u32) -> bool {
        self.list[number as usize].is_transparent()
    }
}
