//! Measuring one scene: building, rays of each kind by themselves, the whole picture; each several times, and the
//! median counts.

use super::case::Case;
use super::cast;
use super::rays::RaySets;
use super::timing::{Timer, Took};
use crate::{Context, Failure, progress};
use lancer_render::{RenderError, RenderOptions, Tracing, render_still};
use lancer_scene::{DVec3, Scene, Shape, View};
use lancer_trace::{Camera, Simd, World};
use rayon::ThreadPool;
use serde::Serialize;
use std::num::NonZeroUsize;

/// How everything is measured.
#[derive(Debug)]
pub(super) struct Conditions<'c> {
    /// Columns and rows of the picture.
    pub(super) size: (u32, u32),
    /// How often each thing is measured, at least once.
    pub(super) repeat: usize,
    /// The threads that build and cast.
    pub(super) pool: &'c ThreadPool,
    /// The instructions that the engine uses.
    pub(super) simd: Simd,
    /// Where the program speaks, and whether it is to stop.
    pub(super) context: &'c Context,
}

/// What was found out about a scene. What things took are medians.
#[derive(Debug)]
pub(super) struct Measured {
    pub(super) case: Case,
    /// Spheres, planes and facets.
    pub(super) primitives: u64,
    /// Compiling the scene for rays.
    pub(super) build: Took,
    /// The memory of the hierarchies and what is packed into their leaves.
    pub(super) bytes: usize,
    pub(super) primary: Cast,
    pub(super) shadow: Cast,
    pub(super) reflected: Cast,
    pub(super) diffuse: Cast,
    pub(super) frame: Frame,
}

/// A set of rays that was cast.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Cast {
    pub(super) rays: u64,
    /// Those that met something.
    pub(super) hits: u64,
    #[serde(flatten)]
    pub(super) took: Took,
}

/// A picture that was rendered.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Frame {
    /// Rays of all kinds.
    pub(super) rays: u64,
    #[serde(flatten)]
    pub(super) took: Took,
}

/// The scene of a case, and its view in the size of the measurement.
///
/// # Errors
/// None for the sizes that a case can have.
pub(super) fn generated(case: Case, (width, height): (u32, u32)) -> Result<(Scene, View), Failure> {
    let (scene, view) = case.family.generate(case.size).map_err(|rule| broken(case, rule))?;
    Ok((scene, View { width, height, ..view }))
}

/// The camera of a generated view, and where the scene's first lamp stands.
///
/// # Errors
/// None for generated views.
pub(super) fn camera_and_lamp(case: Case, scene: &Scene, view: &View) -> Result<(Camera, DVec3), Failure> {
    let camera = Camera::new(view).map_err(|rule| broken(case, rule))?;
    Ok((camera, scene.lights.first().map_or(view.eye, |light| light.position)))
}

fn broken(case: Case, rule: lancer_scene::Invalid) -> Failure {
    Failure::ViewInvalid { view: case.name().into(), rule }
}

/// Measures a scene.
///
/// # Errors
/// Too little memory, or the wish to stop.
pub(super) fn measure(case: Case, conditions: &Conditions<'_>) -> Result<Measured, Failure> {
    let Conditions { size, repeat, pool, simd, context } = *conditions;
    let bar = progress::bar(&context.console, &case.name());
    // each of four sets is cast once more than it is timed
    bar.set_length(1 + 6 * repeat as u64 + 4);
    let (scene, view) = generated(case, size)?;
    let (camera, lamp) = camera_and_lamp(case, &scene, &view)?;
    bar.inc(1);

    let timer = Timer { repeat, context, bar: &bar };
    let (world, build) = timer.median(|| Ok(pool.install(|| World::compile(&scene))))?;
    let sets =
        RaySets::new(&world, &camera, lamp, pool).map_err(|_| Failure::Memory { width: size.0, height: size.1 })?;
    let cast = |rays: usize, count: &dyn Fn() -> u64| {
        // once before: the first touches memory that nobody has touched
        timer.once(|| Ok(count()))?;
        let (hits, took) = timer.median(|| Ok(count()))?;
        Ok(Cast { rays: rays as u64, hits, took })
    };
    let primary = cast(sets.primary.len(), &|| cast::count_hits(&world, &sets.primary, pool, simd))?;
    let shadow = cast(sets.shadow.points.len(), &|| {
        cast::count_blocked(&world, sets.shadow.lamp, &sets.shadow.points, pool, simd)
    })?;
    let reflected = cast(sets.reflected.len(), &|| cast::count_hits(&world, &sets.reflected, pool, simd))?;
    let diffuse = cast(sets.diffuse.len(), &|| cast::count_hits(&world, &sets.diffuse, pool, simd))?;
    drop(sets);
    let stats = world.build_stats();

    let threads = NonZeroUsize::new(pool.current_num_threads());
    let options = RenderOptions { threads, tracing: Tracing::Engine(simd), ..RenderOptions::default() };
    let render = || {
        render_still(&world, &view, &options, &context.cancel, |_, _| {})
            .map_err(|error: RenderError| Failure::render(error, &view))
    };
    let (still, took) = timer.median(render)?;
    bar.finish_and_clear();
    Ok(Measured {
        case,
        primitives: primitives(&scene),
        build,
        bytes: usize::try_from(stats.node_bytes + stats.leaf_bytes + stats.top_bytes).unwrap_or(usize::MAX),
        primary,
        shadow,
        reflected,
        diffuse,
        frame: Frame { rays: still.counts.total(), took },
    })
}

/// Spheres, planes, cones and facets: what rays are tried against.
pub(super) fn primitives(scene: &Scene) -> u64 {
    let of_shape = |shape: &Shape| match shape {
        Shape::Sphere { .. } | Shape::Plane { .. } | Shape::Facet { .. } | Shape::Cone { .. } => 1,
        Shape::Cube { .. } | Shape::Parallelepiped { .. } => 12,
        Shape::Mesh(mesh) => mesh.geometry.facets.len() as u64,
    };
    scene.objects.iter().map(|object| of_shape(&object.shape)).sum()
}
