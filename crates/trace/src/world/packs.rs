//! The packed geometries of a world, by identity: a geometry is packed once, however many objects show it, and stays
//! packed as long as somebody may show it again.

use super::packed::Packed;
use super::placed::Carrying;
use glam::{DMat3, DVec3};
use lancer_scene::Mesh;
use rayon::prelude::*;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// Packed geometries. What is packed keeps its geometry, so an address stands for the same geometry all the time.
#[derive(Clone, Debug, Default)]
pub(crate) struct Packs(Arc<HashMap<Key, Arc<Packed>>>);

/// The address of a geometry, and the bits of the placement that its vertices are baked with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Key {
    geometry: usize,
    baking: Option<[u64; 12]>,
}

/// The linear part and the position that the vertices of a mesh have to be baked with, if they have to.
fn baking(mesh: &Mesh) -> Option<(DMat3, DVec3)> {
    match Carrying::of(&mesh.placement) {
        Carrying::Nothing | Carrying::Rays { .. } => None,
        Carrying::Facets { linear } => Some((linear, mesh.placement.position)),
    }
}

impl Key {
    fn of(mesh: &Mesh) -> Key {
        let baking = baking(mesh).map(|(linear, position)| {
            let mut bits = [0; 12];
            let numbers = linear.to_cols_array().into_iter().chain(position.to_array());
            bits.iter_mut().zip(numbers).for_each(|(bits, number)| *bits = number.to_bits());
            bits
        });
        Key { geometry: Arc::as_ptr(&mesh.geometry) as usize, baking }
    }
}

/// Packs the geometry of a mesh, or its baked vertices.
fn pack(mesh: &Mesh) -> Arc<Packed> {
    let baked = baking(mesh).map(|(linear, position)| {
        mesh.geometry.positions.iter().map(|vertex| linear * *vertex + position).collect::<Vec<DVec3>>()
    });
    Arc::new(Packed::new(Arc::clone(&mesh.geometry), baked))
}

impl Packs {
    /// The packs that these meshes need: those that are here, and new ones, packed side by side. What is here and not
    /// needed is kept while its geometry lives elsewhere: in a history of scenes, from where it may come back.
    pub(crate) fn with<'a>(&self, meshes: impl Iterator<Item = &'a Mesh>) -> Packs {
        let mut needed: Vec<(Key, &Mesh)> = meshes.map(|mesh| (Key::of(mesh), mesh)).collect();
        let mut seen = HashSet::with_capacity(needed.len());
        needed.retain(|(key, _)| seen.insert(*key));
        let is_wanted = |key: &Key, packed: &Arc<Packed>| {
            seen.contains(key) || key.baking.is_none() && Arc::strong_count(packed.geometry()) > 1
        };
        let same = needed.iter().all(|(key, _)| self.0.contains_key(key))
            && self.0.iter().all(|(key, packed)| is_wanted(key, packed));
        if same {
            return self.clone();
        }
        let new: Vec<(Key, Arc<Packed>)> = needed
            .into_par_iter()
            .filter(|(key, _)| !self.0.contains_key(key))
            .map(|(key, mesh)| (key, pack(mesh)))
            .collect();
        let kept = self.0.iter().filter(|(key, packed)| is_wanted(key, packed));
        Packs(Arc::new(kept.map(|(key, packed)| (*key, Arc::clone(packed))).chain(new).collect()))
    }

    /// The packed geometry of a mesh; one that is not among them is packed for this caller alone.
    pub(crate) fn get(&self, mesh: &Mesh) -> Arc<Packed> {
        self.0.get(&Key::of(mesh)).map_or_else(|| pack(mesh), Arc::clone)
    }
}
