//! The screen of a view: a parallelogram in space, given in one of four ways (SPEC §3).

use crate::placement::tan_degrees;
use crate::{Invalid, limits};
use glam::DVec3;

/// A screen as the rays need it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screen {
    /// The top-left corner.
    pub origin: DVec3,
    /// The edge from the top left to the right.
    pub u: DVec3,
    /// The edge from the top left downwards.
    pub v: DVec3,
}

/// A screen as a document gives it, kept so that it can be edited and written back.
#[derive(Clone, Debug, PartialEq)]
pub enum ScreenSpec {
    /// Corner and edges.
    Frame(Screen),
    /// Perpendicular to the line of sight from the eye to its centre.
    Centered {
        /// Where the line of sight meets it.
        center: DVec3,
        /// Its width and height.
        size: [f64; 2],
        /// The direction that is up in the picture, not along the sight.
        up: DVec3,
    },
    /// Bottom left, bottom right, top right, top left: a parallelogram.
    Corners([DVec3; 4]),
    /// Derived from a point that the eye looks at.
    LookAt {
        /// The point that is in the middle of the picture.
        look_at: DVec3,
        /// The direction that is up in the picture, not along the sight.
        up: DVec3,
        /// The horizontal field of view in degrees, 1..179.
        fov: f64,
    },
}

impl ScreenSpec {
    /// The screen that an eye at `eye` looks through at a picture of `width` by `height` pixels.
    ///
    /// # Errors
    /// The rule that the screen breaks.
    pub fn resolve(&self, eye: DVec3, width: u32, height: u32) -> Result<Screen, Invalid> {
        let screen = match self {
            ScreenSpec::Frame(screen) => *screen,
            ScreenSpec::Centered { center, size: [width, height], up } => {
                let (right, top, _) = sight(eye, *center, *up)?;
                let (u, v) = (right * *width, top * -*height);
                Screen { origin: *center - u * 0.5 - v * 0.5, u, v }
            }
            ScreenSpec::Corners([bottom_left, bottom_right, top_right, top_left]) => {
                let (u, v) = (*top_right - *top_left, *bottom_left - *top_left);
                let gap = (*top_left + u + v - *bottom_right).length();
                if gap > 1e-6 * u.length().max(v.length()) {
                    return Err(Invalid::NotParallelogram);
                }
                Screen { origin: *top_left, u, v }
            }
            ScreenSpec::LookAt { look_at, up, fov } => {
                let (right, top, forward) = sight(eye, *look_at, *up)?;
                let half_width = tan_degrees(fov / 2.0);
                let half_height = half_width * f64::from(height) / f64::from(width);
                let (u, v) = (right * (2.0 * half_width), top * (-2.0 * half_height));
                Screen { origin: eye + forward - u * 0.5 - v * 0.5, u, v }
            }
        };
        screen.check(eye)?;
        Ok(screen)
    }
}

/// The unit vectors to the right, to the top and forward of an eye that looks at a point.
fn sight(eye: DVec3, target: DVec3, up: DVec3) -> Result<(DVec3, DVec3, DVec3), Invalid> {
    let forward = (target - eye).try_normalize().ok_or(Invalid::LookAtIsEye)?;
    let upward = up.try_normalize().ok_or(Invalid::UpAlongSight)?;
    let right = forward.cross(upward);
    if right.length() <= limits::SMALLEST_SINE {
        return Err(Invalid::UpAlongSight);
    }
    let right = right.normalize();
    Ok((right, right.cross(forward), forward))
}

impl Screen {
    /// Whether the edges span a parallelogram and the eye is not in its plane.
    fn check(&self, eye: DVec3) -> Result<(), Invalid> {
        let normal = self.u.cross(self.v);
        if normal.length() <= limits::SMALLEST_SINE * self.u.length() * self.v.length() {
            return Err(Invalid::ScreenCollinear);
        }
        let sight = self.origin + self.u * 0.5 + self.v * 0.5 - eye;
        if sight.dot(normal).abs() <= limits::SMALLEST_SINE * sight.length() * normal.length() {
            return Err(Invalid::EyeInScreen);
        }
        Ok(())
    }

    /// Whether the picture shows the scene mirrored: legal, with a warning.
    pub fn is_mirrored(&self, eye: DVec3) -> bool {
        self.u.cross(self.v).dot(self.origin - eye) < 0.0
    }

    /// The point of the screen at `x` of its width from the left and `y` of its height from the top.
    pub fn point(&self, x: f64, y: f64) -> DVec3 {
        self.origin + self.u * x + self.v * y
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn look_at(at: DVec3, target: DVec3, fov: f64, size: (u32, u32)) -> Screen {
        ScreenSpec::LookAt { look_at: target, up: DVec3::Y, fov }.resolve(at, size.0, size.1).unwrap()
    }

    #[test]
    fn right_is_x_when_looking_along_minus_z() {
        let screen = look_at(DVec3::ZERO, DVec3::NEG_Z, 90.0, (800, 400));
        let near = |a: DVec3, b: DVec3| assert!((a - b).length() < 1e-15, "{a} {b}");
        near(screen.origin, DVec3::new(-1.0, 0.5, -1.0));
        near(screen.u, DVec3::new(2.0, 0.0, 0.0));
        near(screen.v, DVec3::new(0.0, -1.0, 0.0));
        assert!(!screen.is_mirrored(DVec3::ZERO));
    }

    #[test]
    fn a_centered_screen_is_perpendicular_to_the_sight() {
        let eye = DVec3::new(3.0, 2.0, 5.0);
        let center = DVec3::new(0.0, 0.5, 0.0);
        let spec = ScreenSpec::Centered { center, size: [4.0, 3.0], up: DVec3::Y };
        let screen = spec.resolve(eye, 640, 480).unwrap();
        assert!((screen.point(0.5, 0.5) - center).length() < 1e-14);
        assert!(screen.u.dot(center - eye).abs() < 1e-13 && screen.v.dot(center - eye).abs() < 1e-13);
        assert!((screen.u.length() - 4.0).abs() < 1e-14 && (screen.v.length() - 3.0).abs() < 1e-14);
    }

    #[test]
    fn each_rule_of_a_screen_is_kept() {
        let frame = |u, v| ScreenSpec::Frame(Screen { origin: DVec3::new(0.0, 0.0, -1.0), u, v });
        let broken = |spec: ScreenSpec| spec.resolve(DVec3::ZERO, 4, 3).unwrap_err();
        assert_eq!(broken(frame(DVec3::X, DVec3::X)), Invalid::ScreenCollinear);
        assert_eq!(broken(frame(DVec3::X, DVec3::Z)), Invalid::EyeInScreen);
        let look = |target, up| ScreenSpec::LookAt { look_at: target, up, fov: 45.0 };
        assert_eq!(broken(look(DVec3::ZERO, DVec3::Y)), Invalid::LookAtIsEye);
        assert_eq!(broken(look(DVec3::Y, DVec3::Y)), Invalid::UpAlongSight);
        assert_eq!(broken(look(DVec3::X, DVec3::ZERO)), Invalid::UpAlongSight);
        let z = DVec3::NEG_Z;
        let corners = [z, z + DVec3::X, z + DVec3::X + DVec3::Y, z + DVec3::Y * 2.0];
        assert_eq!(broken(ScreenSpec::Corners(corners)), Invalid::NotParallelogram);
    }

    #[test]
    fn a_mirrored_screen_is_seen() {
        let spec =
            ScreenSpec::Frame(Screen { origin: DVec3::new(1.0, 1.0, -1.0), u: -DVec3::X * 2.0, v: -DVec3::Y * 2.0 });
        assert!(spec.resolve(DVec3::ZERO, 4, 3).unwrap().is_mirrored(DVec3::ZERO));
    }
}
