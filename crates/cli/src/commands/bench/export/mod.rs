//! `lancer bench --export FOLDER`: the generated scenes as files for other programs, so that they are measured with the
//! same pictures and, where they answer single rays, with the very same rays.
//!
//! docs/performance.md says what each file holds; `scenes.json` lists them.

mod facets;
mod rays;
mod tachyon;

use super::case::Case;
use super::measure::{camera_and_lamp, generated, primitives};
use super::rays::RaySets;
use crate::{Context, Failure, console, target};
use lancer_formats::{binary, export, save, xml};
use lancer_scene::{Compose, DVec3, Environment, MeshGeometry, Scene, Shape, View, Views};
use lancer_trace::World;
use rayon::ThreadPool;
use rays::Met;
use serde::Serialize;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

/// Scenes of more primitives are written in binary form.
const MOST_AS_TEXT: u64 = 20_000;

/// What was written. Version 1; later versions may add members.
#[derive(Serialize)]
struct Manifest {
    version: u32,
    width: u32,
    height: u32,
    scenes: Vec<Entry>,
}

/// The files of one scene, all in the folder.
#[derive(Serialize)]
struct Entry {
    name: String,
    primitives: u64,
    /// The scene's depth limit.
    depth: u32,
    /// Our own documents.
    scene: String,
    view: String,
    povray: String,
    tachyon: String,
    /// Facets and rays; only of scenes that are facets alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    facets: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rays: Option<String>,
}

/// Writes the files of all cases and the list of them.
///
/// # Errors
/// A file that cannot be written, too little memory, or the wish to stop.
pub(super) fn export(
    folder: &Path,
    cases: &[Case],
    size: (u32, u32),
    pool: &ThreadPool,
    context: &Context,
) -> Result<(), Failure> {
    let list = folder.join("scenes.json");
    // a folder that is not there is told before anything is computed
    save::check(&list).map_err(Failure::Save)?;
    let scenes = cases.iter().map(|case| entry(folder, *case, size, pool, context)).collect::<Result<_, _>>()?;
    let manifest = Manifest { version: 1, width: size.0, height: size.1, scenes };
    target::write(&list, context, |out| out.write_all(console::json(&manifest).as_bytes()))
}

fn entry(folder: &Path, case: Case, size: (u32, u32), pool: &ThreadPool, context: &Context) -> Result<Entry, Failure> {
    let (scene, view) = generated(case, size)?;
    // the others know no ⊕, so that pictures can be compared
    let scene = Scene { world: Environment { compose: Compose::Add, ..scene.world }, ..scene };
    let stem = case.name().replace(':', "-");
    let write = |extension: &str, write: &dyn Fn(&mut dyn Write) -> io::Result<()>| {
        let name = format!("{stem}.{extension}");
        target::write(&folder.join(&name), context, |out| write(out)).map(|()| name)
    };
    let primitives = primitives(&scene);
    let as_text = primitives <= MOST_AS_TEXT;
    let views: Views = std::iter::once(view.clone()).collect();
    let facets_alone = scene.objects.iter().all(|object| matches!(object.shape, Shape::Mesh(_)));
    let (facets, rays) = match facets_alone {
        true => {
            let (sets, met) = cast_sets(case, &scene, &view, pool)?;
            (
                Some(write("facets", &|out| facets::write(&scene, out))?),
                Some(write("rays", &|out| rays::write(&sets, &met, out))?),
            )
        }
        false => (None, None),
    };
    Ok(Entry {
        name: case.name(),
        primitives,
        depth: scene.world.depth,
        scene: match as_text {
            true => write("xml", &|out| out.write_all(xml::write_scene(&scene).as_bytes()))?,
            false => write("lancer", &|out| out.write_all(&binary::write_scene(&scene)))?,
        },
        view: write("view.xml", &|out| out.write_all(xml::write_views(&views).as_bytes()))?,
        povray: write("pov", &|out| export::write_povray(&scene, &view, out))?,
        tachyon: write("dat", &|out| tachyon::write(&scene, &view, out))?,
        facets,
        rays,
    })
}

/// The rays of a scene's picture, and what they meet.
fn cast_sets(case: Case, scene: &Scene, view: &View, pool: &ThreadPool) -> Result<(RaySets, Met), Failure> {
    let world = pool.install(|| World::compile(scene));
    let (camera, lamp) = camera_and_lamp(case, scene, view)?;
    let sets = RaySets::new(&world, &camera, lamp, pool)
        .map_err(|_| Failure::Memory { width: view.width, height: view.height })?;
    let met = Met::new(&world, &sets, pool);
    Ok((sets, met))
}

/// Where the corners of an object's facets stand: of meshes, and of nothing else.
fn placed(shape: &Shape) -> Option<(Vec<DVec3>, Arc<MeshGeometry>)> {
    let Shape::Mesh(mesh) = shape else { return None };
    let linear = mesh.placement.linear();
    let positions = mesh.geometry.positions.iter().map(|at| linear * *at + mesh.placement.position).collect();
    Some((positions, Arc::clone(&mesh.geometry)))
}

/// One object of every shape, with a material that has every coefficient, and one that has none.
#[cfg(test)]
fn every_shape() -> (Scene, View) {
    use lancer_scene::{
        Material, MaterialRef, Mesh, Object, Placement, PointLight, Rgb, Screen, ScreenSpec, Steps, Surface,
    };
    let glass = Surface {
        ka: Rgb::new(0.25, 0.25, 0.0),
        kd: Rgb::new(0.5, 0.25, 0.0),
        ks: Rgb::new(0.25, 0.5, 0.75),
        shininess: Rgb::splat(20.0),
        kr: Rgb::splat(0.25),
        kt: Rgb::splat(0.5),
        index: Rgb::splat(1.5),
        ..Surface::default()
    };
    let geometry = MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
        facets: vec![[0, 1, 2]],
        ..MeshGeometry::default()
    };
    let placement = Placement { scale: DVec3::splat(2.0), position: DVec3::Z * 7.0, ..Placement::default() };
    let (p0, p1, p2) = (DVec3::ZERO, DVec3::X, DVec3::Y);
    let below = DVec3::Y * -2.0;
    let shapes = [
        Shape::Sphere { center: DVec3::new(1.0, 2.0, 3.0), radius: 0.5 },
        Shape::Plane { p0: below, p1: below + DVec3::Z, p2: below + DVec3::X },
        Shape::Cube { center: DVec3::ZERO, edge: 2.0, rotation: DVec3::ZERO },
        Shape::Parallelepiped { origin: DVec3::ZERO, edges: [DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Z] },
        Shape::Cone { base: DVec3::ZERO, top: DVec3::Y, base_radius: 1.0, top_radius: 0.5, capped: false },
        Shape::Facet { p0, p1, p2 },
        Shape::Mesh(Mesh { geometry: Arc::new(geometry), source: None, placement, smooth: false }),
    ];
    let objects = (0..).zip(shapes).map(|(number, shape)| Object {
        material: if number == 1 { MaterialRef::Default } else { MaterialRef::Named("glass".into()) },
        ..Object::new(format!("object {number}"), shape)
    });
    let light = PointLight { color: Rgb::new(1.0, 0.5, 0.25), ..PointLight::new("lamp", DVec3::new(1.0, 2.0, 3.0)) };
    let scene = Scene {
        name: String::new(),
        world: Environment {
            ambient: Rgb::splat(0.5),
            background: Rgb::new(0.0, 0.0, 0.5),
            depth: 3,
            ..Environment::default()
        },
        materials: std::iter::once(Material { name: "glass".into(), surface: glass }).collect(),
        lights: std::iter::once(light).collect(),
        objects: objects.collect(),
    };
    let screen = Screen { origin: DVec3::new(-1.0, 0.5, 4.0), u: DVec3::X * 2.0, v: -DVec3::Y };
    let view = View {
        name: "front".into(),
        width: 200,
        height: 100,
        eye: DVec3::Z * 5.0,
        screen: ScreenSpec::Frame(screen),
        samples: 1,
        depth: None,
        steps: Steps::default(),
    };
    (scene, view)
}
