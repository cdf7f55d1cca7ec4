//! Surfaces as POV-Ray's textures. Each is declared once, where it is first needed.

use super::{channels, mean};
use crate::xml::shortest;
use lancer_scene::{Highlight, MaterialRef, Mesh, Object, Rgb, Scene, Steps, Surface};
use std::collections::HashMap;
use std::io::{self, Write};

/// Of what is transparent something must be left for the pigment to have a share of.
const LEAST: f64 = 1e-6;

/// The textures of a scene.
pub(super) struct Textures<'a> {
    scene: &'a Scene,
    steps: Steps,
    named: HashMap<&'a str, &'a Surface>,
    /// The declared surfaces and their numbers, by name or by place in memory.
    declared: HashMap<Key, usize>,
}

/// What makes two references the same surface.
#[derive(PartialEq, Eq, Hash)]
enum Key {
    Default,
    Named(lancer_scene::Name),
    Inline(*const Surface),
}

impl<'a> Textures<'a> {
    pub(super) fn new(scene: &'a Scene, steps: Steps) -> Textures<'a> {
        let named = scene.materials.iter().map(|material| (&*material.name, &material.surface)).collect();
        Textures { scene, steps, named, declared: HashMap::new() }
    }

    /// What a reference means, without the steps that are left out.
    pub(super) fn surface(&self, material: &MaterialRef) -> Surface {
        let mut surface = match material {
            MaterialRef::Default => Surface::default(),
            MaterialRef::Named(name) => self.named.get(&**name).map(|found| Surface::clone(found)).unwrap_or_default(),
            MaterialRef::Inline(surface) => Surface::clone(surface),
        };
        surface.kr = if self.steps.reflection { surface.kr } else { Rgb::BLACK };
        surface.kt = if self.steps.transparency { surface.kt } else { Rgb::BLACK };
        surface
    }

    /// The name of the texture of a reference, declared before.
    pub(super) fn name(&mut self, material: &MaterialRef, out: &mut impl Write) -> io::Result<String> {
        let key = match material {
            MaterialRef::Default => Key::Default,
            MaterialRef::Named(name) => Key::Named(name.clone()),
            MaterialRef::Inline(surface) => Key::Inline(std::sync::Arc::as_ptr(surface)),
        };
        if let Some(number) = self.declared.get(&key) {
            return Ok(format!("Texture{number}"));
        }
        let number = self.declared.len() + 1;
        let comment = match material.name() {
            Some(name) => format!(" // {name}"),
            None => String::new(),
        };
        let texture = texture(&self.surface(material), self.scene.world.ambient);
        writeln!(out, "#declare Texture{number} = {texture}{comment}")?;
        self.declared.insert(key, number);
        Ok(format!("Texture{number}"))
    }

    /// The interior of a body of this surface; nothing for what light does not enter. Only ratios of indices count, so
    /// that the medium around the objects can be 1.
    pub(super) fn interior(&self, surface: &Surface) -> String {
        if !surface.is_transparent() {
            return String::new();
        }
        let ratio = surface.index.zip(self.scene.world.index, |inside, outside| inside / outside);
        format!(" interior {{ ior {} }}", shortest(mean(ratio)))
    }
}

/// The materials that the facets of a mesh have, in their order; the object's own if some facet is in no part.
pub(super) fn surfaces<'a>(object: &'a Object, mesh: &'a Mesh) -> impl Iterator<Item = &'a MaterialRef> {
    let geometry = &mesh.geometry;
    let in_parts: u64 = geometry.parts.iter().map(|part| u64::from(part.count)).sum();
    let own = (in_parts < geometry.facets.len() as u64).then_some(&object.material);
    own.into_iter().chain(geometry.parts.iter().map(|part| &part.material))
}

/// The texture of a surface. What it scatters and its ambient term are shares of what it does not let through.
fn texture(surface: &Surface, ambient: Rgb) -> String {
    let through = mean(surface.kt).min(1.0 - LEAST);
    let opaque = 1.0 - through;
    let given_back = surface.ka * ambient;
    // where nothing is scattered the ambient term still needs a pigment
    let color = surface.kd.zip(given_back, |kd, term| if kd > 0.0 || term == 0.0 { kd } else { LEAST });
    let factor = given_back.zip(color, |term, color| if color > 0.0 { term / color } else { 0.0 });
    let mut finish = format!("ambient rgb {} diffuse 1", channels(factor));
    let strength = shortest(mean(surface.ks));
    let shininess = mean(surface.shininess);
    if surface.ks.max_channel() > 0.0 {
        finish += &match surface.highlight {
            Highlight::Phong => format!(" phong {strength} phong_size {}", shortest(shininess)),
            // its exponent is 1/roughness
            Highlight::Blinn => format!(" specular {strength} roughness {}", shortest(1.0 / shininess.max(LEAST))),
        };
    }
    if surface.is_mirror() {
        finish += &format!(" reflection {{ rgb {} }}", channels(surface.kr));
    }
    let transmit = if through > 0.0 { format!(" transmit {}", shortest(through)) } else { String::new() };
    let color = channels(if through > 0.0 { color * (1.0 / opaque) } else { color });
    format!("texture {{ pigment {{ rgb {color}{transmit} }} finish {{ {finish} }} }}")
}
