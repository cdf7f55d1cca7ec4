//! Views: an eye, a screen, and how the picture is computed.

use crate::{Invalid, List, Name, Screen, ScreenSpec};
use glam::DVec3;

/// The views of a document, in its order.
pub type Views = List<View>;

/// One picture of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// Unique among the views of a document.
    pub name: Name,
    /// Pixels per row, 1..65535.
    pub width: u32,
    /// Rows of pixels, 1..65535.
    pub height: u32,
    /// The point of view.
    pub eye: DVec3,
    /// The screen that it looks through.
    pub screen: ScreenSpec,
    /// `k`: each pixel is the mean of `k×k` samples, 1..64.
    pub samples: u32,
    /// Depth limit instead of the world's, 0..64.
    pub depth: Option<u32>,
    /// The steps of the algorithm that are carried out.
    pub steps: Steps,
}

impl View {
    /// The screen in the form that the rays need.
    ///
    /// # Errors
    /// The rule of SPEC §3 that eye and screen break.
    pub fn resolved_screen(&self) -> Result<Screen, Invalid> {
        self.screen.resolve(self.eye, self.width, self.height)
    }
}

/// The steps of the subject that can be left out (§5.2); hidden surfaces are always computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Steps {
    /// Shadow rays; left out, every lamp in front lights the point.
    pub shadows: bool,
    /// Mirrored rays; left out, the mirror term is 0.
    pub reflection: bool,
    /// Refracted rays; left out, the glass term is 0.
    pub transparency: bool,
}

impl Default for Steps {
    fn default() -> Steps {
        Steps { shadows: true, reflection: true, transparency: true }
    }
}
