//! What stands under a point of a picture, and where a point of space stands in it.

use crate::{Camera, Ray, World};
use glam::DVec3;
use lancer_scene::Name;

/// What a ray meets first.
#[derive(Clone, Debug, PartialEq)]
pub struct Picked {
    /// The object.
    pub object: Name,
    /// The facet's number, 0 for a sphere and a plane, of a cone the number of its [face](lancer_scene::ConeFace).
    pub facet: u32,
    /// The distance from the ray's start.
    pub distance: f64,
    /// The point.
    pub point: DVec3,
    /// The unit normal there, turned against the ray.
    pub normal: DVec3,
}

impl World {
    /// The nearest object along a ray that starts in free space.
    pub fn pick(&self, ray: &Ray) -> Option<Picked> {
        let hit = self.nearest(ray, None)?;
        let seen = self.surface_point(ray, &hit);
        Some(Picked {
            object: self.body(hit.body).name.clone(),
            facet: hit.facet,
            distance: hit.t,
            point: seen.point,
            normal: seen.geometric,
        })
    }
}

impl Camera {
    /// Where a point of space stands in the picture, in pixels from the top left; `None` unless it is in front of the
    /// eye. It may lie outside of the picture.
    pub fn project(&self, point: DVec3) -> Option<(f64, f64)> {
        let screen = self.screen();
        let sight = point - self.eye();
        let normal = screen.u.cross(screen.v);
        let (distance, along) = (normal.dot(screen.origin - self.eye()), normal.dot(sight));
        if along * distance <= 0.0 {
            return None;
        }
        let on_screen = self.eye() + sight * (distance / along) - screen.origin;
        let x = on_screen.cross(screen.v).dot(normal) / normal.length_squared();
        let y = screen.u.cross(on_screen).dot(normal) / normal.length_squared();
        Some((x * f64::from(self.width()), y * f64::from(self.height())))
    }
}
