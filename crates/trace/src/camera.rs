//! From a view to rays through its pixels.

use crate::Ray;
use glam::DVec3;
use lancer_scene::{Invalid, Screen, View};

/// An eye, a screen, and a raster of pixels on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    eye: DVec3,
    screen: Screen,
    width: u32,
    height: u32,
    samples: u32,
}

impl Camera {
    /// The camera of a view.
    ///
    /// # Errors
    /// The rule of SPEC §3 that eye and screen break.
    pub fn new(view: &View) -> Result<Camera, Invalid> {
        let View { eye, width, height, samples, .. } = *view;
        Ok(Camera { eye, screen: view.resolved_screen()?, width, height, samples: samples.max(1) })
    }

    /// Where every primary ray starts.
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// The screen that the eye looks through.
    pub fn screen(&self) -> &Screen {
        &self.screen
    }

    /// Pixels per row.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows of pixels.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// `k`: a pixel has `k×k` samples.
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// The ray through the point at `x` pixels from the left and `y` from the top; the centre of pixel `(i, j)` is at
    /// `(i+½, j+½)`.
    pub fn ray(&self, x: f64, y: f64) -> Ray {
        let point = self.screen.point(x / f64::from(self.width), y / f64::from(self.height));
        Ray { origin: self.eye, direction: (point - self.eye).normalize() }
    }

    /// The sample positions of pixel `(i, j)` in pixels from the top left, in row order: the centres of `k×k` equal
    /// squares.
    pub fn sample_positions(&self, i: u32, j: u32) -> impl Iterator<Item = (f64, f64)> {
        let k = f64::from(self.samples);
        let samples = self.samples;
        (0..samples).flat_map(move |row| {
            (0..samples).map(move |column| {
                (f64::from(i) + (f64::from(column) + 0.5) / k, f64::from(j) + (f64::from(row) + 0.5) / k)
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lancer_scene::{ScreenSpec, Steps};

    fn camera(samples: u32) -> Camera {
        Camera::new(&View {
            name: "front".into(),
            width: 201,
            height: 101,
            eye: DVec3::ZERO,
            screen: ScreenSpec::LookAt { look_at: DVec3::NEG_Z, up: DVec3::Y, fov: 90.0 },
            samples,
            depth: None,
            steps: Steps::default(),
        })
        .unwrap()
    }

    /// The numbers of The Ray Tracer Challenge (J. Buck), chapter 7, for 201×101 pixels and 90°.
    #[test]
    fn rays_through_the_middle_and_the_corner() {
        let near = |a: DVec3, b: DVec3| assert!((a - b).length() < 1e-5, "{a} {b}");
        near(camera(1).ray(100.5, 50.5).direction, DVec3::NEG_Z);
        // the book's screen faces the other way along x
        near(camera(1).ray(0.5, 0.5).direction, DVec3::new(-0.66519, 0.33259, -0.66851));
    }

    #[test]
    fn a_point_on_a_ray_is_projected_to_the_rays_pixel() {
        let camera = camera(1);
        for (x, y) in [(0.0, 0.0), (13.25, 77.5), (201.0, 101.0), (-40.0, 500.0)] {
            let (px, py) = camera.project(camera.ray(x, y).at(7.0)).unwrap();
            assert!((px - x).abs() < 1e-9 && (py - y).abs() < 1e-9, "{px} {py}");
        }
        assert_eq!(camera.project(DVec3::Z), None, "behind the eye");
    }

    #[test]
    fn samples_stand_at_the_centres_of_equal_squares_in_row_order() {
        let positions: Vec<_> = camera(2).sample_positions(3, 7).collect();
        assert_eq!(positions, [(3.25, 7.25), (3.75, 7.25), (3.25, 7.75), (3.75, 7.75)]);
        assert_eq!(camera(1).sample_positions(3, 7).collect::<Vec<_>>(), [(3.5, 7.5)]);
    }
}
