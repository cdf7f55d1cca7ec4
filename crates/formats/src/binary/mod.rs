//! The binary scene format, extension `.lancer`: the subject's «sérialisation» (§5.1), fast and exact.
//!
//! A file is a frame around a body (all numbers little-endian):
//!
//! | bytes | content |
//! |---|---|
//! | 0..8 | `89 4C 53 43 0D 0A 1A 0A`: after PNG's signature, so that a transfer as text cannot go unnoticed |
//! | 8..12 | format version |
//! | 12..16 | CRC-32 (IEEE 802.3) of all other bytes of the file |
//! | 16..24 | length of the file |
//! | 24.. | the body |
//!
//! The frame is the same in every version, so damage is told from a newer version. The body of version 1 is a CBOR item
//! (RFC 8949) for the structure and, behind it, the arrays of the meshes as they lie in memory (`v1/`); version 2 adds
//! the cone (`v2/`). The structs of a version never change: its files stay readable however the model grows.

mod frame;
mod problem;
mod v1;
mod v2;

use lancer_scene::Scene;

pub use problem::BinaryProblem;

/// The version that [`write_scene`] writes.
pub const VERSION: u32 = 2;

/// Whether a file is a binary scene by its first bytes, also one that a transfer as text has damaged.
pub fn is_binary(bytes: &[u8]) -> bool {
    bytes.starts_with(&frame::MAGIC) || frame::damaged_as_text(bytes)
}

/// The scene as the bytes of a file.
pub fn write_scene(scene: &Scene) -> Vec<u8> {
    let mut file = frame::begin(VERSION);
    v2::write(scene, &mut file);
    frame::seal(&mut file);
    file
}

/// The scene that a file holds, checked by [`Scene::check`]. Meshes that shared their geometry share it again.
///
/// # Errors
/// What is wrong with the file; any cut and any flipped bit is noticed.
pub fn read_scene(bytes: &[u8]) -> Result<Scene, BinaryProblem> {
    let (version, body) = frame::open(bytes)?;
    let scene = match version {
        1 => v1::read::<v1::Shape>(body)?,
        2 => v1::read::<v2::Shape>(body)?,
        found => return Err(BinaryProblem::UnknownVersion { found }),
    };
    scene.check().map_err(|(name, rule)| BinaryProblem::Invalid { name, rule })?;
    Ok(scene)
}
