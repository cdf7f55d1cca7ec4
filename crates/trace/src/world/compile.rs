//! From a scene to a world, and from a world to the one of an edited scene: what did not change is not made again.

use super::body::{Body, Geometry};
use super::packed::Packed;
use super::surfaces::Surfaces;
use super::top::Top;
use super::{Lamp, World};
use lancer_scene::{Material, Object, Scene};
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::Arc;

/// So few objects are compiled sooner than other threads wake.
const TOGETHER: usize = 64;

impl World {
    /// Compiles a scene. The scene should have passed `Scene::check`; of one that has not, parts that make no sense
    /// are left out.
    pub fn compile(scene: &Scene) -> World {
        World::default().update(scene)
    }

    /// Whether this is the world of that scene, so that an update would change nothing.
    pub fn is_of(&self, scene: &Scene) -> bool {
        self.scene.world == scene.world
            && self.scene.materials.same_items(&scene.materials)
            && self.scene.lights.same_items(&scene.lights)
            && self.scene.objects.same_items(&scene.objects)
    }

    /// Compiles a scene that may share parts with this world's: the same world as [`World::compile`] gives, but what is
    /// the same in memory is taken over. Another material, lamp or view rebuilds nothing, an object that moves only the
    /// hierarchy over the objects; a geometry that was here before and still lives in some scene is not packed again.
    #[must_use]
    pub fn update(&self, scene: &Scene) -> World {
        let lamps = if self.scene.lights.same_items(&scene.lights) { Arc::clone(&self.lamps) } else { lamps(scene) };
        let mut surfaces = Surfaces::of(scene);
        let objects_stay = self.scene.objects.same_items(&scene.objects);
        if objects_stay && same_roles(&self.scene, scene) {
            surfaces.list.extend_from_slice(self.surfaces.get(surfaces.list.len()..).unwrap_or_default());
            let surfaces = Arc::new(surfaces.list);
            return World { scene: scene.clone(), surfaces, lamps, ..self.clone() };
        }
        let objects: Vec<&Arc<Object>> = visible(scene).collect();
        let packs = self.packs.with(objects.iter().filter_map(|object| object.shape.mesh()));
        let before = Before::of(self, &objects);
        let geometry = |(place, object): (usize, &&Arc<Object>)| match before.body(place, object) {
            Some(body) => body.geometry.clone(),
            None => Geometry::of(&object.shape, &packs),
        };
        let geometries: Vec<Geometry> = if objects.len() <= TOGETHER {
            objects.iter().enumerate().map(geometry).collect()
        } else {
            objects.par_iter().enumerate().with_min_len(TOGETHER).map(geometry).collect()
        };
        let bodies: Vec<Body> = objects
            .iter()
            .zip(geometries)
            .map(|(object, geometry)| Body::new(object, geometry, &mut surfaces))
            .collect();
        let top = Top::over(&bodies, &self.top).map_or_else(|| Arc::clone(&self.top), Arc::new);
        World { scene: scene.clone(), surfaces: Arc::new(surfaces.list), lamps, bodies: Arc::new(bodies), top, packs }
    }

    /// The packed geometries that some body shows, as often as one does.
    pub(crate) fn packs_in_use(&self) -> Vec<&Packed> {
        let facets = self.bodies.iter().filter_map(|body| match &body.geometry {
            Geometry::Facets(facets) => Some(&**facets.packed()),
            Geometry::Sphere { .. } | Geometry::Plane { .. } | Geometry::Cone(_) => None,
        });
        facets.collect()
    }
}

/// The objects that take part, in document order: those of the bodies.
fn visible(scene: &Scene) -> impl Iterator<Item = &Arc<Object>> {
    scene.objects.iter().filter(|object| object.visible)
}

/// Whether the materials of both scenes have the same names and let light through alike, so that the bodies' numbers of
/// surfaces and their media are the same.
fn same_roles(a: &Scene, b: &Scene) -> bool {
    let same = |(a, b): (&Arc<Material>, &Arc<Material>)| {
        Arc::ptr_eq(a, b) || a.name == b.name && a.surface.is_transparent() == b.surface.is_transparent()
    };
    a.materials.len() == b.materials.len() && a.materials.iter().zip(b.materials.iter()).all(same)
}

fn lamps(scene: &Scene) -> Arc<Vec<Lamp>> {
    let lamps = scene.lights.iter().filter(|light| light.visible);
    Arc::new(
        lamps.map(|light| Lamp { name: light.name.clone(), position: light.position, color: light.color }).collect(),
    )
}

fn address(object: &Arc<Object>) -> usize {
    Arc::as_ptr(object) as usize
}

/// Where the objects of an edited scene stood before. Most edits leave the head and the tail of the list alone; what is
/// between them is looked up.
struct Before<'a> {
    bodies: &'a [Body],
    objects: Vec<&'a Arc<Object>>,
    head: usize,
    /// How many objects of the new list come before the common tail, and how many of the old.
    middle: [usize; 2],
    /// The places of the old ones between head and tail, by address.
    places: HashMap<usize, usize>,
}

impl<'a> Before<'a> {
    fn of(world: &'a World, objects: &[&Arc<Object>]) -> Before<'a> {
        let before: Vec<&Arc<Object>> = visible(&world.scene).collect();
        let same = |(a, b): &(&&Arc<Object>, &&Arc<Object>)| Arc::ptr_eq(a, b);
        let head = before.iter().zip(objects).take_while(same).count();
        let tail = before[head..].iter().rev().zip(objects[head..].iter().rev()).take_while(same).count();
        let middle = [objects.len() - tail, before.len() - tail];
        let places = (head..middle[1]).map(|place| (address(before[place]), place)).collect();
        Before { bodies: &world.bodies, objects: before, head, middle, places }
    }

    /// The body whose geometry that of the object at a place in the new list is.
    fn body(&self, place: usize, object: &Arc<Object>) -> Option<&'a Body> {
        let [end, end_before] = self.middle;
        let found = if place < self.head {
            Some(place)
        } else if place >= end {
            Some(place - end + end_before)
        } else {
            self.places.get(&address(object)).copied().or_else(|| {
                // one that was edited where it stands, but not in its shape; a mesh finds what is its own in the packs
                let edited = (end == end_before).then(|| self.objects[place])?;
                (object.shape.geometry().is_none() && edited.shape == object.shape).then_some(place)
            })
        };
        found.map(|place| &self.bodies[place])
    }
}
