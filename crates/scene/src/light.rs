//! Lamps.

use crate::{Color, Name, Rgb};
use glam::DVec3;

/// A point light: `I_L` of the subject, the same in every direction and at every distance.
#[derive(Clone, Debug, PartialEq)]
pub struct PointLight {
    /// Unique among objects and lights.
    pub name: Name,
    /// Where the lamp stands.
    pub position: DVec3,
    /// Its intensity `I_L`, 0..1.
    pub color: Color,
    /// `false`: takes no part in the picture and is kept in the scene.
    pub visible: bool,
}

impl PointLight {
    /// A visible white lamp.
    pub fn new(name: impl Into<Name>, position: DVec3) -> PointLight {
        PointLight { name: name.into(), position, color: Rgb::WHITE, visible: true }
    }
}
