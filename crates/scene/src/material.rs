//! What a surface does with light: the coefficients of the subject's §2, each with one value per channel.

use crate::{Name, Rgb};
use std::sync::Arc;

/// A named surface that several objects may share.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Unique among the materials.
    pub name: Name,
    /// What the material does with light.
    pub surface: Surface,
}

/// The coefficients of the light model.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// `Ka`: the share of the ambient light that the surface gives back, 0..1.
    pub ka: Rgb,
    /// `Kd`: the share of a lamp's light that it scatters, 0..1.
    pub kd: Rgb,
    /// `Ks`: the scale of the reflectance `W`, 0..1.
    pub ks: Rgb,
    /// The law of the reflectance `W(l)`.
    pub w: Reflectance,
    /// Shininess `n`, the exponent of the highlight, 0..10000.
    pub shininess: Rgb,
    /// `Kr`: the share of the light seen along the mirrored ray, 0..1.
    pub kr: Rgb,
    /// `Kt`: the share of the light seen along the refracted ray, 0..1.
    pub kt: Rgb,
    /// Refraction index of what the surface encloses, greater than 0.
    pub index: Rgb,
    /// Phong's or Blinn's highlight.
    pub highlight: Highlight,
}

impl Surface {
    /// Whether some channel lets light through: such an object is a medium.
    pub fn is_transparent(&self) -> bool {
        self.kt.max_channel() > 0.0
    }

    /// Whether some channel mirrors.
    pub fn is_mirror(&self) -> bool {
        self.kr.max_channel() > 0.0
    }
}

/// The built-in grey of an object without a material.
impl Default for Surface {
    fn default() -> Surface {
        Surface {
            ka: Rgb::splat(0.2),
            kd: Rgb::splat(0.6),
            ks: Rgb::BLACK,
            w: Reflectance::Constant,
            shininess: Rgb::splat(30.0),
            kr: Rgb::BLACK,
            kt: Rgb::BLACK,
            index: Rgb::WHITE,
            highlight: Highlight::Phong,
        }
    }
}

/// The law of `W(l)`, the reflectance at the angle `l` between normal and lamp.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Reflectance {
    /// `Ks`.
    #[default]
    Constant,
    /// `Ks + (1-Ks)(1-cos l)⁵`, Schlick 1994.
    Schlick,
    /// `Ks·(1-cos l)`.
    Grazing,
}

impl Reflectance {
    /// Every law, in the order in which menus show them.
    pub const ALL: [Reflectance; 3] = [Reflectance::Constant, Reflectance::Schlick, Reflectance::Grazing];

    /// The word for it in the documents.
    pub const fn word(self) -> &'static str {
        match self {
            Reflectance::Constant => "constant",
            Reflectance::Schlick => "schlick",
            Reflectance::Grazing => "grazing",
        }
    }
}

/// What `cos s` of the highlight is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Highlight {
    /// `max(0, R_L·V)`, Phong 1975.
    #[default]
    Phong,
    /// `max(0, N·H)` with `H = unit(L+V)`, Blinn 1977.
    Blinn,
}

impl Highlight {
    /// Both highlights, in the order in which menus show them.
    pub const ALL: [Highlight; 2] = [Highlight::Phong, Highlight::Blinn];

    /// The word for it in the documents.
    pub const fn word(self) -> &'static str {
        match self {
            Highlight::Phong => "phong",
            Highlight::Blinn => "blinn",
        }
    }
}

/// Which surface an object or a part of a mesh has.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum MaterialRef {
    /// The built-in grey.
    #[default]
    Default,
    /// A material of the scene, by its name.
    Named(Name),
    /// A surface of its own.
    Inline(Arc<Surface>),
}

impl MaterialRef {
    /// The name, if a material is named.
    pub fn name(&self) -> Option<&Name> {
        match self {
            MaterialRef::Named(name) => Some(name),
            MaterialRef::Default | MaterialRef::Inline(_) => None,
        }
    }
}
