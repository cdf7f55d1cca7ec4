//! The mesh that a reader puts together: bounds checked, polygons cut, runs of one material kept.

use super::MeshFault;
use super::triangulate::{MOST_CORNERS, triangulate};
use glam::DVec3;
use lancer_scene::{MaterialRef, MeshGeometry, Part, Surface, limits};
use std::sync::Arc;

/// Grows a [`MeshGeometry`] within the memory that its file gives it a right to.
pub(super) struct Builder {
    pub(super) geometry: MeshGeometry,
    /// The material of the next facets, and the first facet that has it.
    material: Option<(Arc<Surface>, usize)>,
    /// The corners of the face that is being cut, and its triangles.
    corners: Vec<DVec3>,
    cut: Vec<[usize; 3]>,
    /// The bytes that the mesh may take.
    most: usize,
}

impl Builder {
    /// A builder for a file of so many bytes.
    pub(super) fn new(file_bytes: usize) -> Builder {
        let most = (64 << 20) + file_bytes.saturating_mul(10);
        Builder { geometry: MeshGeometry::default(), material: None, corners: Vec::new(), cut: Vec::new(), most }
    }

    /// Gives the mesh a right to the memory of one more file.
    pub(super) fn add_file(&mut self, bytes: usize) {
        self.most = self.most.saturating_add(bytes.saturating_mul(10));
    }

    /// How many vertices there are.
    pub(super) fn vertices(&self) -> usize {
        self.geometry.positions.len()
    }

    /// Adds a vertex.
    pub(super) fn vertex(&mut self, position: DVec3) -> Result<u32, MeshFault> {
        if let Some(wrong) = position.to_array().into_iter().find(|value| !within_scene(*value)) {
            return Err(MeshFault::Coordinate(wrong));
        }
        let number = u32::try_from(self.vertices()).map_err(|_| MeshFault::TooManyItems)?;
        self.geometry.positions.push(position);
        self.check_memory()?;
        Ok(number)
    }

    /// Adds a face, cut into facets, and gives these as numbers of its corners.
    pub(super) fn polygon(&mut self, corners: &[u32]) -> Result<&[[usize; 3]], MeshFault> {
        let positions = &self.geometry.positions;
        if let Some(&wrong) = corners.iter().find(|&&corner| corner as usize >= positions.len()) {
            return Err(MeshFault::NoSuchVertex { named: wrong.into(), vertices: positions.len() });
        }
        match corners.len() {
            0..=2 => return Err(MeshFault::TooFewCorners(corners.len())),
            3..=MOST_CORNERS => {}
            corners => return Err(MeshFault::TooManyCorners { corners, most: MOST_CORNERS }),
        }
        self.corners.clear();
        self.corners.extend(corners.iter().map(|&corner| positions[corner as usize]));
        self.cut.clear();
        triangulate(&self.corners, &mut |triangle| self.cut.push(triangle));
        let facets = self.cut.iter().map(|triangle| triangle.map(|number| corners[number]));
        self.geometry.facets.extend(facets);
        self.check_memory()?;
        Ok(&self.cut)
    }

    /// The next facets have this material, or the object's.
    pub(super) fn set_material(&mut self, material: Option<&Arc<Surface>>) {
        let same = match (&self.material, material) {
            (Some((old, _)), Some(new)) => Arc::ptr_eq(old, new),
            (None, None) => true,
            (Some(_), None) | (None, Some(_)) => false,
        };
        if !same {
            self.end_part();
            self.material = material.map(|surface| (Arc::clone(surface), self.geometry.facets.len()));
        }
    }

    fn end_part(&mut self) {
        let end = self.geometry.facets.len();
        if let Some((surface, first)) = self.material.take().filter(|(_, first)| *first < end) {
            let (first, count) = (first as u32, (end - first) as u32);
            self.geometry.parts.push(Part { material: MaterialRef::Inline(surface), first, count });
        }
    }

    fn check_memory(&self) -> Result<(), MeshFault> {
        let MeshGeometry { positions, normals, facets, .. } = &self.geometry;
        let used = size_of_val(&positions[..]) + size_of_val(&normals[..]) + size_of_val(&facets[..]);
        if used > self.most {
            return Err(MeshFault::TooMuchMemory { most: self.most });
        }
        Ok(())
    }

    /// The mesh. Normals that are no directions are left out, all of them, and the second value is true.
    pub(super) fn finish(mut self) -> Result<(MeshGeometry, bool), MeshFault> {
        self.end_part();
        let mut geometry = self.geometry;
        if geometry.facets.is_empty() {
            return Err(MeshFault::NoFacets);
        }
        if u32::try_from(geometry.facets.len()).is_err() {
            return Err(MeshFault::TooManyItems);
        }
        let is_direction = |vertex: &u32| {
            geometry.normals.get(*vertex as usize).is_some_and(|normal| normal.try_normalize().is_some())
        };
        let left_out = !geometry.normals.is_empty()
            && (geometry.normals.len() != geometry.positions.len()
                || !geometry.facets.iter().flatten().all(is_direction)
                || !geometry.normals.iter().all(|normal| normal.is_finite()));
        if left_out {
            geometry.normals = Vec::new();
        }
        geometry.positions.shrink_to_fit();
        geometry.normals.shrink_to_fit();
        geometry.facets.shrink_to_fit();
        Ok((geometry, left_out))
    }
}

/// Whether a coordinate is one that a scene may have.
fn within_scene(value: f64) -> bool {
    value.abs() <= limits::COORDINATE
}
