//! The view of a file.
//!
//! Its angle reaches «from the center of top pixel row to bottom pixel row»: the screen is higher than that by one pixel.
//! Pixels are square, so its width follows from the resolution.

use super::NffProblem;
use super::entities::{Sink, View};
use crate::Diagnostic;
use lancer_scene::{ScreenSpec, Steps, Views, tan_degrees};

/// The name of the one view.
const NAME: &str = "view";

/// The views of a file: one, unless there is none or it is not legal, which is told.
pub(super) fn read(view: Option<View>, sink: &mut Sink) -> Option<Views> {
    let Some(View { span, from, at, up, angle, resolution: [width, height] }) = view else {
        if sink.of_view.is_empty() {
            sink.of_view.push(Diagnostic::error(None, NffProblem::NoView));
        }
        return None;
    };
    let rows = f64::from(height);
    let pixel = 2.0 * tan_degrees(angle / 2.0) / (rows - 1.0).max(1.0);
    let size = [pixel * f64::from(width), pixel * rows];
    // a screen at distance 1
    let screen = ScreenSpec::Centered { center: from + (at - from).normalize_or_zero(), size, up };
    let view = lancer_scene::View {
        name: NAME.into(),
        width,
        height,
        eye: from,
        screen,
        samples: 1,
        depth: None,
        steps: Steps::default(),
    };
    match view.check() {
        Ok(()) => Some([view].into_iter().collect()),
        Err(rule) => {
            sink.of_view.push(Diagnostic::error(span, NffProblem::Broken(rule)));
            None
        }
    }
}
