//! What surrounds the objects: ambient light, colour of infinity, medium, and the limits of the computation.

use crate::{Color, Rgb};

/// The `world` of a scene document.
#[derive(Clone, Debug, PartialEq)]
pub struct Environment {
    /// Ambient light `Ia` (subject §2.1), 0..1.
    pub ambient: Color,
    /// Colour of infinity: what every ray that meets nothing sees, 0..1.
    pub background: Color,
    /// Refraction index of the medium around the objects, greater than 0.
    pub index: Rgb,
    /// Depth limit: a ray of this level casts no further ray, 0..64.
    pub depth: u32,
    /// How the terms of a point are composed.
    pub compose: Compose,
}

impl Default for Environment {
    fn default() -> Environment {
        Environment {
            ambient: Rgb::splat(0.2),
            background: Rgb::BLACK,
            index: Rgb::WHITE,
            depth: 6,
            compose: Compose::Screen,
        }
    }
}

/// How the terms of the light at a point are put together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Compose {
    /// The subject's `⊕` (§2.6), one term for each lamp.
    #[default]
    Screen,
    /// `⊕` too, but a lamp's diffuse and highlight parts are two separate terms.
    ScreenEach,
    /// Plain sum, clamped once at each node.
    Add,
}

impl Compose {
    /// Every way of composing, in the order in which menus show them.
    pub const ALL: [Compose; 3] = [Compose::Screen, Compose::ScreenEach, Compose::Add];

    /// The word for it in the documents.
    pub const fn word(self) -> &'static str {
        match self {
            Compose::Screen => "screen",
            Compose::ScreenEach => "screen-each",
            Compose::Add => "add",
        }
    }
}
