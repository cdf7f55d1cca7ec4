//! Small pictures of materials: a ball on a floor, rendered beside the window and kept.

use egui::{ColorImage, TextureHandle, TextureOptions};
use lancer_render::{RenderOptions, Tracing, render_still};
use lancer_scene::{
    DVec3, Environment, List, MaterialRef, Object, Picture, PointLight, Rgb, Scene, ScreenSpec, Shape, Steps, Surface,
    View,
};
use lancer_trace::{Cancel, World};
use std::cell::RefCell;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

/// Pixels along a swatch's side: twice what menus show, for screens of double density.
const SIDE: u32 = 64;
/// How many swatches are kept; a drag of a slider asks for many.
const KEPT: usize = 256;

/// The swatches of all materials that were asked for.
pub struct Swatches {
    known: RefCell<Vec<(Surface, Option<TextureHandle>)>>,
    orders: Sender<Surface>,
    done: Receiver<(Surface, Picture)>,
}

impl std::fmt::Debug for Swatches {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Swatches").field("known", &self.known.borrow().len()).finish_non_exhaustive()
    }
}

impl Swatches {
    /// Swatches that wake the window when one is ready.
    pub fn new(ctx: egui::Context, tracing: Tracing) -> Swatches {
        let (orders, inbox) = channel::<Surface>();
        let (results, done) = channel();
        std::thread::spawn(move || {
            for surface in inbox {
                let Some(picture) = render(&surface, tracing) else { continue };
                if results.send((surface, picture)).is_err() {
                    return;
                }
                ctx.request_repaint_of(egui::ViewportId::ROOT);
            }
        });
        Swatches { known: RefCell::default(), orders, done }
    }

    /// The picture of a material; `None` while it is rendered: the window is woken when it is there.
    pub fn get(&self, ctx: &egui::Context, surface: &Surface) -> Option<TextureHandle> {
        let mut known = self.known.borrow_mut();
        for (surface, picture) in self.done.try_iter() {
            let size = [picture.width as usize, picture.height as usize];
            let image = ColorImage::from_rgb(size, picture.bytes.as_flattened());
            let texture = ctx.load_texture("swatch", image, TextureOptions::LINEAR);
            if let Some((_, place)) = known.iter_mut().find(|(known, _)| *known == surface) {
                *place = Some(texture);
            }
        }
        if let Some((_, texture)) = known.iter().find(|(known, _)| known == surface) {
            return texture.clone();
        }
        if known.len() >= KEPT {
            known.remove(0);
        }
        known.push((surface.clone(), None));
        // the thread lives as long as this
        let _ = self.orders.send(surface.clone());
        None
    }
}

/// A ball of the material above a two-coloured floor, lit from the left.
fn render(surface: &Surface, tracing: Tracing) -> Option<Picture> {
    let plain = |gray: f64| {
        let surface = Surface { ka: Rgb::splat(gray * 0.5), kd: Rgb::splat(gray), ..Surface::default() };
        MaterialRef::Inline(Arc::new(surface))
    };
    let tile = |x: f64, z: f64| Shape::Parallelepiped {
        origin: DVec3::new(x, -0.1, z),
        edges: [DVec3::X * 0.5, DVec3::Y * 0.1, DVec3::Z * 0.5],
    };
    let ball = Shape::Sphere { center: DVec3::new(0.0, 1.0, 0.0), radius: 1.0 };
    let mut objects =
        vec![Object { material: MaterialRef::Inline(Arc::new(surface.clone())), ..Object::new("ball", ball) }];
    for (row, column) in (-6..6).flat_map(|row| (-6..6).map(move |column| (row, column))) {
        let material = plain(if (row + column) % 2 == 0 { 0.75 } else { 0.3 });
        let shape = tile(f64::from(column) * 0.5, f64::from(row) * 0.5);
        objects.push(Object { material, ..Object::new(format!("tile {row} {column}"), shape) });
    }
    let scene = Scene {
        world: Environment {
            ambient: Rgb::splat(0.5),
            background: Rgb::new(0.55, 0.6, 0.66),
            ..Environment::default()
        },
        objects: objects.into_iter().collect::<List<Object>>(),
        lights: [PointLight::new("lamp", DVec3::new(-3.0, 4.5, 3.5))].into_iter().collect::<List<PointLight>>(),
        ..Scene::default()
    };
    let view = View {
        name: "swatch".into(),
        width: SIDE,
        height: SIDE,
        eye: DVec3::new(0.0, 2.0, 4.6),
        screen: ScreenSpec::LookAt { look_at: DVec3::new(0.0, 0.93, 0.0), up: DVec3::Y, fov: 30.0 },
        samples: 2,
        depth: Some(8),
        steps: Steps::default(),
    };
    let options = RenderOptions { tracing, ..RenderOptions::default() };
    render_still(&World::compile(&scene), &view, &options, &Cancel::default(), |_, _| ())
        .ok()
        .map(|still| still.picture)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The material is seen: swatches of different materials differ, and the ball stands in the middle.
    #[test]
    fn a_swatch_shows_its_material() {
        let red = Surface { kd: Rgb::new(0.8, 0.1, 0.1), ka: Rgb::new(0.5, 0.0, 0.0), ..Surface::default() };
        let render = |surface| render(surface, Tracing::default()).unwrap();
        let (gray, red) = (render(&Surface::default()), render(&red));
        let [r, g, b] = red.pixel(SIDE / 2, SIDE / 2).unwrap();
        assert!(r > g && r > b, "{r} {g} {b}");
        let [r, g, b] = gray.pixel(SIDE / 2, SIDE / 2).unwrap();
        assert!(r == g && g == b, "{r} {g} {b}");
    }
}
