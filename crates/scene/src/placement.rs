//! Where a mesh or a cube stands: scale, then rotation about the fixed axes x, y, z in turn, then translation.

use glam::{DMat3, DVec3};

/// A placement; the default one changes nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// Factors along x, y, z, none of them 0.
    pub scale: DVec3,
    /// Degrees about the fixed axes x, then y, then z.
    pub rotation: DVec3,
    /// Translation.
    pub position: DVec3,
}

impl Default for Placement {
    fn default() -> Placement {
        Placement { scale: DVec3::ONE, rotation: DVec3::ZERO, position: DVec3::ZERO }
    }
}

impl Placement {
    /// Where the placement brings a point.
    pub fn apply(&self, point: DVec3) -> DVec3 {
        self.linear() * point + self.position
    }

    /// The linear part: scale, then rotation.
    pub fn linear(&self) -> DMat3 {
        rotation(self.rotation) * DMat3::from_diagonal(self.scale)
    }
}

/// The rotation about the fixed axes x, y, z in turn, by degrees.
///
/// Sines and cosines come from pure Rust, so the matrix is the same on every machine, and quarter turns are exact.
pub(crate) fn rotation(degrees: DVec3) -> DMat3 {
    let (sx, cx) = sin_cos_degrees(degrees.x);
    let (sy, cy) = sin_cos_degrees(degrees.y);
    let (sz, cz) = sin_cos_degrees(degrees.z);
    let x = DMat3::from_cols(DVec3::X, DVec3::new(0.0, cx, sx), DVec3::new(0.0, -sx, cx));
    let y = DMat3::from_cols(DVec3::new(cy, 0.0, -sy), DVec3::Y, DVec3::new(sy, 0.0, cy));
    let z = DMat3::from_cols(DVec3::new(cz, sz, 0.0), DVec3::new(-sz, cz, 0.0), DVec3::Z);
    z * y * x
}

/// Sine and cosine of an angle in degrees, exact at multiples of 90.
fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let turned = libm::fmod(degrees, 360.0);
    let turned = if turned < 0.0 { turned + 360.0 } else { turned };
    let quarter = libm::floor(turned / 90.0 + 0.5);
    let (sin, cos) = libm::sincos((turned - 90.0 * quarter).to_radians());
    match quarter as i32 & 3 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// Tangent of an angle in degrees, exact at 45.
pub fn tan_degrees(degrees: f64) -> f64 {
    if degrees == 45.0 { 1.0 } else { libm::tan(degrees.to_radians()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axes_turn_one_after_the_other() {
        // about x: y → z; then about z: the z axis stays, x → y
        assert_eq!(rotation(DVec3::new(90.0, 0.0, 0.0)) * DVec3::Y, DVec3::Z);
        assert_eq!(rotation(DVec3::new(0.0, 90.0, 0.0)) * DVec3::Z, DVec3::X);
        assert_eq!(rotation(DVec3::new(0.0, 0.0, 90.0)) * DVec3::X, DVec3::Y);
        assert_eq!(rotation(DVec3::new(90.0, 0.0, 90.0)) * DVec3::Y, DVec3::Z);
        assert_eq!(rotation(DVec3::new(90.0, 90.0, 0.0)) * DVec3::Y, DVec3::X);
    }

    #[test]
    fn whole_turns_change_nothing() {
        for turns in [-720.0, -360.0, 360.0, 3600.0] {
            assert_eq!(rotation(DVec3::splat(turns)), DMat3::IDENTITY);
        }
    }

    #[test]
    fn a_placement_scales_first_and_translates_last() {
        let placement = Placement {
            scale: DVec3::new(2.0, 1.0, 1.0),
            rotation: DVec3::new(0.0, 0.0, 90.0),
            position: DVec3::new(0.0, 0.0, 5.0),
        };
        assert_eq!(placement.apply(DVec3::X), DVec3::new(0.0, 2.0, 5.0));
    }
}
