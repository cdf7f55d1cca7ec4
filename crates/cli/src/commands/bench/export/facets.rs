//! All facets of a scene as numbers, little-endian: `lancer facets 1\n`, the numbers of vertices and of facets in 32 bits
//! each, three coordinates in 32 bits for each vertex, three numbers of vertices in 32 bits for each facet.

use super::placed;
use lancer_scene::Scene;
use std::io::{self, BufWriter, Write};

pub(super) fn write(scene: &Scene, out: &mut dyn Write) -> io::Result<()> {
    let meshes: Vec<_> = scene.objects.iter().filter_map(|object| placed(&object.shape)).collect();
    let vertices: usize = meshes.iter().map(|(positions, _)| positions.len()).sum();
    let facets: usize = meshes.iter().map(|(_, geometry)| geometry.facets.len()).sum();
    let mut out = BufWriter::new(out);
    out.write_all(b"lancer facets 1\n")?;
    out.write_all(&(vertices as u32).to_le_bytes())?;
    out.write_all(&(facets as u32).to_le_bytes())?;
    for coordinate in meshes.iter().flat_map(|(positions, _)| positions).flat_map(|position| position.to_array()) {
        out.write_all(&(coordinate as f32).to_le_bytes())?;
    }
    let mut first = 0;
    for (positions, geometry) in &meshes {
        for vertex in geometry.facets.iter().flatten() {
            out.write_all(&(first + vertex).to_le_bytes())?;
        }
        first += positions.len() as u32;
    }
    out.flush()
}
