//! The compiled scene: flat arrays of bodies, surfaces and lamps, and hierarchies of boxes over what is bounded.
//!
//! Only what takes part in the picture is here: invisible objects and lamps are left out.

mod body;
mod contains;
mod facets;
pub(crate) mod hierarchy;
mod memory;

pub(crate) use body::{Body, Extent, Geometry};
pub(crate) use facets::Facets;

use glam::DVec3;
use hierarchy::{Bounds, Hierarchy};
use lancer_scene::{Color, Environment, MaterialRef, Name, Rgb, Scene, Surface};
use std::collections::HashMap;

/// A scene ready for rays.
#[derive(Clone, Debug)]
pub struct World {
    environment: Environment,
    surfaces: Vec<Surface>,
    lamps: Vec<Lamp>,
    bodies: Vec<Body>,
    /// Bodies without bounds: every ray is tried against them.
    unbounded: Vec<u32>,
    /// The other bodies; an item is a place in `bounded`.
    hierarchy: Hierarchy,
    bounded: Vec<u32>,
}

/// A lamp that takes part.
#[derive(Clone, Debug)]
pub(crate) struct Lamp {
    pub(crate) name: Name,
    pub(crate) position: DVec3,
    pub(crate) color: Color,
}

impl World {
    /// Compiles a scene. The scene should have passed `Scene::check`; of one that has not, parts that make no sense
    /// are left out.
    pub fn compile(scene: &Scene) -> World {
        let mut surfaces = Surfaces::of(scene);
        let bodies: Vec<Body> = scene
            .objects
            .iter()
            .filter(|object| object.visible)
            .map(|object| Body::compile(object, &mut surfaces))
            .collect();
        let lamps = scene
            .lights
            .iter()
            .filter(|light| light.visible)
            .map(|light| Lamp { name: light.name.clone(), position: light.position, color: light.color })
            .collect();
        let (mut unbounded, mut bounded, mut bounds) = (Vec::new(), Vec::new(), Vec::new());
        for (number, body) in (0_u32..).zip(&bodies) {
            match (body.bounds(), &body.geometry) {
                (Some(around), _) => {
                    bounded.push(number);
                    bounds.push(around);
                }
                (None, Geometry::Plane { .. }) => unbounded.push(number),
                // a mesh without facets has neither bounds nor points
                (None, Geometry::Sphere { .. } | Geometry::Facets(_)) => {}
            }
        }
        World {
            environment: scene.world.clone(),
            surfaces: surfaces.list,
            lamps,
            hierarchy: Hierarchy::build(&bounds),
            bodies,
            unbounded,
            bounded,
        }
    }

    /// Ambient light, background, medium, depth and composition.
    pub fn environment(&self) -> &Environment {
        &self.environment
    }

    /// A body by its number.
    pub(crate) fn body(&self, number: u32) -> &Body {
        &self.bodies[number as usize]
    }

    /// A surface by its number.
    pub(crate) fn surface(&self, number: u32) -> &Surface {
        &self.surfaces[number as usize]
    }

    /// The lamps in document order.
    pub(crate) fn lamps(&self) -> &[Lamp] {
        &self.lamps
    }

    /// The bodies that every ray is tried against.
    pub(crate) fn unbounded(&self) -> &[u32] {
        &self.unbounded
    }

    /// The hierarchy over the bounded bodies, and what its items mean.
    pub(crate) fn bounded(&self) -> (&Hierarchy, &[u32]) {
        (&self.hierarchy, &self.bounded)
    }
}

/// The surfaces of a scene while it is compiled: 0 is the built-in grey, then the materials in their order, then the
/// inline ones.
pub(crate) struct Surfaces {
    list: Vec<Surface>,
    by_name: HashMap<Name, u32>,
}

impl Surfaces {
    const GREY: u32 = 0;

    fn of(scene: &Scene) -> Surfaces {
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

/// The media that a ray is inside of, outermost first: `(body, index of its material)`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Media(Vec<(u32, Rgb)>);

impl Media {
    /// The index of the medium that a ray with this stack travels in.
    pub(crate) fn index(&self, world: &World) -> Rgb {
        self.0.last().map_or(world.environment.index, |(_, index)| *index)
    }

    /// Entering pushes, again if the body is there already.
    #[must_use]
    pub(crate) fn entered(&self, body: u32, index: Rgb) -> Media {
        let mut media = Vec::with_capacity(self.0.len() + 1);
        media.extend_from_slice(&self.0);
        media.push((body, index));
        Media(media)
    }

    /// Leaving removes the body's last entry; leaving what is not there changes nothing.
    #[must_use]
    pub(crate) fn left(&self, body: u32) -> Media {
        let mut media = self.clone();
        if let Some(place) = media.0.iter().rposition(|(entry, _)| *entry == body) {
            media.0.remove(place);
        }
        media
    }

    /// The bodies on the stack, outermost first.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = u32> + '_ {
        self.0.iter().map(|(body, _)| *body)
    }

    /// The stack of a ray that starts at a point in free space: the transparent bodies around it, planes first, then
    /// by the diagonal of their bounds, longest first, ties in document order.
    pub(crate) fn around(world: &World, point: DVec3) -> Media {
        let mut inside: Vec<(u32, u32, f64)> = (0_u32..)
            .zip(&world.bodies)
            .filter_map(|(number, body)| Some((number, body.medium?, body)))
            .filter(|(_, _, body)| body.contains(point))
            .map(|(number, medium, body)| {
                (number, medium, body.bounds().map_or(f64::INFINITY, |bounds| bounds.diagonal()))
            })
            .collect();
        // stable: equal diagonals stay in document order
        inside.sort_by(|(_, _, a), (_, _, b)| b.total_cmp(a));
        Media(inside.into_iter().map(|(number, medium, _)| (number, world.surface(medium).index)).collect())
    }
}

impl Bounds {
    /// The length from the least to the greatest corner.
    pub(crate) fn diagonal(&self) -> f64 {
        (self.high - self.low).length()
    }
}
