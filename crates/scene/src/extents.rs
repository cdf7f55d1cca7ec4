//! The bounds of many objects, where meshes share geometries: which vertices a geometry's facets use is found once for
//! all of its instances.

use crate::shape::hull;
use crate::{MeshGeometry, Shape};
use glam::DVec3;
use std::collections::HashMap;
use std::sync::Arc;

/// Finds bounds, and remembers geometries.
#[derive(Debug, Default)]
pub struct Extents {
    /// The used vertices of each geometry. It is kept alive, so that its address stays its own.
    used: HashMap<*const MeshGeometry, (Arc<MeshGeometry>, Vec<DVec3>)>,
}

impl Extents {
    /// The same as [`Shape::bounds`].
    pub fn of(&mut self, shape: &Shape) -> Option<(DVec3, DVec3)> {
        let Shape::Mesh(mesh) = shape else { return shape.bounds() };
        let (_, used) = self
            .used
            .entry(Arc::as_ptr(&mesh.geometry))
            .or_insert_with(|| (Arc::clone(&mesh.geometry), mesh.geometry.used_positions().collect()));
        let linear = mesh.placement.linear();
        hull(used.iter().map(|vertex| linear * *vertex + mesh.placement.position))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Mesh, Placement};

    #[test]
    fn instances_have_the_bounds_that_each_has_alone() {
        let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(0.0, 0.0, 99.0)];
        let geometry = Arc::new(MeshGeometry { positions, facets: vec![[0, 1, 2]], ..MeshGeometry::default() });
        let mut extents = Extents::default();
        for turn in 0..4 {
            let placement = Placement {
                rotation: DVec3::new(10.0, 30.0, 20.0) * f64::from(turn),
                position: DVec3::splat(f64::from(turn)),
                ..Placement::default()
            };
            let geometry = Arc::clone(&geometry);
            let shape = Shape::Mesh(Mesh { geometry, source: None, placement, smooth: false });
            assert_eq!(extents.of(&shape), shape.bounds());
        }
        assert_eq!(extents.used.len(), 1);
        let ball = Shape::Sphere { center: DVec3::ONE, radius: 1.0 };
        assert_eq!(extents.of(&ball), Some((DVec3::ZERO, DVec3::splat(2.0))));
    }
}
