//! The packed geometries of a world, by identity: a geometry is packed once, however many objects show it.

use super::packed::Packed;
use glam::{DMat3, DVec3};
use lancer_scene::MeshGeometry;
use std::collections::HashMap;
use std::sync::Arc;

/// Packed geometries. What is packed keeps its geometry, so an address stands for the same geometry all the time.
#[derive(Clone, Debug, Default)]
pub(crate) struct Packs(HashMap<Key, Arc<Packed>>);

/// The address of a geometry, and the bits of the placement that its vertices are baked with.
type Key = (usize, Option<[u64; 12]>);

impl Packs {
    /// The packed geometry, with its vertices baked by that linear part and position.
    pub(crate) fn get(&mut self, geometry: &Arc<MeshGeometry>, baking: Option<(DMat3, DVec3)>) -> Arc<Packed> {
        let bits = baking.map(|(linear, position)| {
            let mut bits = [0; 12];
            let numbers = linear.to_cols_array().into_iter().chain(position.to_array());
            bits.iter_mut().zip(numbers).for_each(|(bits, number)| *bits = number.to_bits());
            bits
        });
        let packed = self.0.entry((Arc::as_ptr(geometry) as usize, bits)).or_insert_with(|| {
            let baked = baking.map(|(linear, position)| {
                geometry.positions.iter().map(|vertex| linear * *vertex + position).collect::<Vec<DVec3>>()
            });
            Arc::new(Packed::new(Arc::clone(geometry), baked))
        });
        Arc::clone(packed)
    }
}
