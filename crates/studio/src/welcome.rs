//! What the first start shows: a still life with two views of it, held in the program itself.

use lancer_formats::mesh::{MeshFault, MeshFile, MeshFiles, MeshProblem};
use lancer_formats::xml::{Document, read_scene, read_views};
use lancer_scene::{DVec3, Environment, PointLight, Rgb, Scene, ScreenSpec, Stage, Steps, View};

const SCENE: &str = include_str!("../../../scenes/first/first.xml");
const VIEWS: &str = include_str!("../../../scenes/first/first.view.xml");

/// The scene names no mesh file.
struct NoFiles;

impl MeshFiles for NoFiles {
    fn read(&mut self, path: &str) -> Result<MeshFile, MeshProblem> {
        Err(MeshProblem { file: path.into(), line: None, fault: MeshFault::Missing })
    }
}

/// The scene of the first start.
pub fn stage() -> Stage {
    let document = |name: &str, text: &str| Document::read(name, text.as_bytes()).ok();
    let scene = document("first.xml", SCENE).and_then(|document| read_scene(&document, &mut NoFiles).value);
    let views = document("first.view.xml", VIEWS).and_then(|document| read_views(&document).value);
    Stage { scene: scene.unwrap_or_default(), views: views.unwrap_or_default() }
}

/// A new scene: a lamp, a grey background, and a view of the place where the first things will stand.
pub fn empty() -> Stage {
    let lamp = PointLight::new("light 1", DVec3::new(-3.0, 5.0, 4.0));
    let scene = Scene {
        world: Environment { background: Rgb::splat(0.3), ..Environment::default() },
        lights: std::iter::once(lamp).collect(),
        ..Scene::default()
    };
    let view = View {
        name: "view 1".into(),
        width: 640,
        height: 480,
        eye: DVec3::new(2.5, 2.0, 5.0),
        screen: ScreenSpec::LookAt { look_at: DVec3::new(0.0, 0.5, 0.0), up: DVec3::Y, fov: 45.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    };
    Stage { scene, views: std::iter::once(view).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_scene_has_objects_and_two_views() {
        let stage = stage();
        assert!(stage.scene.objects.len() > 5 && stage.scene.lights.len() == 2 && stage.views.len() == 2);
    }
}
