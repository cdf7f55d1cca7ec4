//! Where the pixels of a view stand on the screen.

use egui::{Pos2, Rect, Vec2, pos2};
use lancer_render::Region;
use lancer_scene::View;

/// Where the picture of a view stands on the screen. Geometry is worked out in the pixels of the view as the document
/// has it, whatever the size at which it is rendered.
#[derive(Clone, Copy, Debug)]
pub struct Mapping {
    /// The picture's place on the screen, in points.
    pub rect: Rect,
    /// Pixels of the view.
    size: (f64, f64),
}

impl Mapping {
    /// The mapping of a view whose picture stands there.
    pub fn new(rect: Rect, view: &View) -> Mapping {
        Mapping { rect, size: (f64::from(view.width), f64::from(view.height)) }
    }

    /// The place on the screen of a point in pixels of the view.
    pub fn to_screen(&self, (x, y): (f64, f64)) -> Pos2 {
        let (across, down) = ((x / self.size.0) as f32, (y / self.size.1) as f32);
        pos2(self.rect.left() + across * self.rect.width(), self.rect.top() + down * self.rect.height())
    }

    /// The point in pixels of the view at a place on the screen.
    pub fn to_view(&self, place: Pos2) -> (f64, f64) {
        self.movement(place - self.rect.min)
    }

    /// A movement on the screen in pixels of the view.
    pub fn movement(&self, by: Vec2) -> (f64, f64) {
        let part = |by: f32, whole: f32| f64::from(by) / f64::from(whole);
        (part(by.x, self.rect.width()) * self.size.0, part(by.y, self.rect.height()) * self.size.1)
    }

    /// The pixel of a picture of that size at a place on the screen; `None` outside.
    pub fn pixel(&self, place: Pos2, [width, height]: [u32; 2]) -> Option<(u32, u32)> {
        if !self.rect.contains(place) || width == 0 || height == 0 {
            return None;
        }
        let by = place - self.rect.min;
        let cell = |by: f32, whole: f32, count: u32| {
            ((f64::from(by) * f64::from(count) / f64::from(whole)) as u32).min(count - 1)
        };
        Some((cell(by.x, self.rect.width(), width), cell(by.y, self.rect.height(), height)))
    }

    /// The pixels of a picture of that size between two places on the screen; `None` where there is none.
    pub fn region(&self, from: Pos2, to: Pos2, [width, height]: [u32; 2]) -> Option<Region> {
        let inside = Rect::from_two_pos(from, to).intersect(self.rect);
        if !inside.is_positive() {
            return None;
        }
        let (x0, y0) = self.pixel(inside.min, [width, height])?;
        let (x1, y1) = self.pixel(inside.max, [width, height])?;
        Some(Region { x: x0, y: y0, width: x1 - x0 + 1, height: y1 - y0 + 1 })
    }

    /// The place on the screen of a region of a picture of that size.
    pub fn region_rect(&self, region: Region, [width, height]: [u32; 2]) -> Rect {
        let scale = self.rect.size() / Vec2::new(width as f32, height as f32);
        let min = self.rect.min + Vec2::new(region.x as f32, region.y as f32) * scale;
        Rect::from_min_size(min, Vec2::new(region.width as f32, region.height as f32) * scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lancer_scene::{DVec3, ScreenSpec, Steps};

    fn mapping() -> Mapping {
        let view = View {
            name: "front".into(),
            width: 640,
            height: 480,
            eye: DVec3::Z,
            screen: ScreenSpec::LookAt { look_at: DVec3::ZERO, up: DVec3::Y, fov: 45.0 },
            samples: 1,
            depth: None,
            steps: Steps::default(),
        };
        Mapping::new(Rect::from_min_size(pos2(100.0, 50.0), Vec2::new(320.0, 240.0)), &view)
    }

    #[test]
    fn there_and_back() {
        let mapping = mapping();
        assert_eq!(mapping.to_screen((320.0, 240.0)), pos2(260.0, 170.0));
        assert_eq!(mapping.to_view(pos2(260.0, 170.0)), (320.0, 240.0));
        assert_eq!(mapping.movement(Vec2::new(1.0, -2.0)), (2.0, -4.0));
    }

    #[test]
    fn pixels_of_another_size() {
        let mapping = mapping();
        assert_eq!(mapping.pixel(pos2(100.0, 50.0), [160, 120]), Some((0, 0)));
        assert_eq!(mapping.pixel(pos2(420.0, 290.0), [160, 120]), Some((159, 119)));
        assert_eq!(mapping.pixel(pos2(421.0, 290.0), [160, 120]), None);
        let region = mapping.region(pos2(200.0, 100.0), pos2(50.0, 60.0), [320, 240]);
        assert_eq!(region, Some(Region { x: 0, y: 10, width: 101, height: 41 }));
        assert_eq!(mapping.region(pos2(0.0, 0.0), pos2(50.0, 60.0), [320, 240]), None);
        let all = Region::whole(320, 240);
        assert_eq!(mapping.region_rect(all, [320, 240]), mapping.rect);
    }
}
