//! A scene and a view in the language of POV-Ray 3.7, as one would write them there by hand: its own spheres, planes,
//! boxes and cones, one `mesh2` a mesh, and one for all meshes of one geometry.
//!
//! The picture is the same wherever both can say what is meant: `compose="add"`, no node's sum above 1, coefficients
//! that POV-Ray has one number for equal in all channels, constant reflectance, no transparent object between a point
//! and a lamp. [`losses`] lists the rest.

mod geometry;
mod texture;

use super::loss::{Feature, Loss, Losses};
use crate::xml::shortest;
use geometry::Geometries;
use lancer_scene::{Compose, DVec3, Reflectance, Rgb, Scene, Screen, Shape, Surface, View};
use std::io::{self, BufWriter, Write};
use texture::Textures;

/// Writes the scene as one file, with the view as its camera.
///
/// # Errors
/// Those of the writer, and a view that breaks a rule.
pub fn write(scene: &Scene, view: &View, out: &mut dyn Write) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    let Screen { origin, u, v } = view.resolved_screen().map_err(io::Error::other)?;
    let (environment, depth) = (&scene.world, view.depth.unwrap_or(scene.world.depth));
    if !scene.name.is_empty() {
        writeln!(out, "// {}", scene.name.replace(char::is_control, " "))?;
    }
    writeln!(out, "// povray +W{} +H{} -A File_Gamma=1 THIS_FILE", view.width, view.height)?;
    writeln!(out, "#version 3.7;")?;
    // its first level is the primary ray's own
    writeln!(
        out,
        "global_settings {{ charset utf8 assumed_gamma 1 ambient_light rgb 1 adc_bailout 0 max_trace_level {} }}",
        depth + 1
    )?;
    writeln!(out, "background {{ rgb {} }}", channels(environment.background))?;
    writeln!(
        out,
        "camera {{ perspective location {} direction {} right {} up {} }}",
        vector(view.eye),
        vector(origin + (u + v) * 0.5 - view.eye),
        vector(u),
        vector(-v)
    )?;
    let shadowless = if view.steps.shadows { "" } else { " shadowless" };
    for light in scene.lights.iter().filter(|light| light.visible) {
        writeln!(out, "light_source {{ {} rgb {}{shadowless} }}", vector(light.position), channels(light.color))?;
    }
    let mut textures = Textures::new(scene, view.steps);
    let mut geometries = Geometries::of(scene);
    for object in scene.objects.iter().filter(|object| object.visible) {
        geometry::write(object, &mut textures, &mut geometries, &mut out)?;
    }
    out.flush()
}

/// What POV-Ray's scene cannot say of the scene and the view.
pub fn losses(scene: &Scene, view: &View) -> Vec<Loss> {
    let mut losses = Losses::default();
    if scene.world.compose != Compose::Add {
        losses.0.push(Loss::Compose { compose: scene.world.compose });
    }
    super::loss::hidden(scene, &mut losses);
    let lit = view.steps.shadows && scene.lights.iter().any(|light| light.visible);
    for (surface, owner) in super::loss::surfaces_in_use(scene) {
        let Surface { ks, shininess, kt, w, .. } = surface;
        let shines = ks.max_channel() > 0.0;
        let clear = surface.is_transparent() && view.steps.transparency;
        let refracts = surface.index.zip(scene.world.index, |inside, outside| inside / outside);
        losses.of_each(
            [
                (shines && w != Reflectance::Constant, Feature::Law),
                (!ks.is_uniform(), Feature::HighlightColour),
                (shines && !shininess.is_uniform(), Feature::Shininess),
                (clear && !kt.is_uniform(), Feature::Filter),
                (clear && !refracts.is_uniform(), Feature::Dispersion),
                (clear && lit, Feature::Shadows),
            ],
            &owner,
        );
    }
    for object in scene.objects.iter().filter(|object| object.visible) {
        if let Shape::Mesh(mesh) = &object.shape {
            let mut indices = texture::surfaces(object, mesh).map(|material| scene.surface(material));
            let first = indices.by_ref().find(Surface::is_transparent).map(|surface| surface.index);
            let other = indices.any(|surface| surface.is_transparent() && Some(surface.index) != first);
            losses.of_each([(other, Feature::PartIndices)], &object.name);
        }
    }
    losses.of_each([(view.samples > 1, Feature::Samples)], &view.name);
    losses.0
}

fn vector(vector: DVec3) -> String {
    // adding zero makes -0 and 0 the same
    let [x, y, z] = vector.to_array().map(|coordinate| shortest(coordinate + 0.0));
    format!("<{x}, {y}, {z}>")
}

fn channels(values: Rgb) -> String {
    vector(DVec3::from(values.to_array()))
}

/// What stands for three channels where POV-Ray has one number.
fn mean(values: Rgb) -> f64 {
    if values.is_uniform() { values.r } else { values.to_array().iter().sum::<f64>() / 3.0 }
}
