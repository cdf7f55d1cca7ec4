//! The reader of `Rendu` documents.

use super::reader::{EYE, Reader, Rule, VIEW, VIEWS};
use super::{N7Problem, Points};
use crate::Outcome;
use crate::xml::{AutomaticNames, Document, Element, Excerpt, ValueProblem, shortest};
use lancer_scene::{DVec3, Invalid, Name, Screen, ScreenSpec, Steps, View, Views, limits};

/// Reads views of 2009.
pub fn read_views(document: &Document) -> Outcome<Views> {
    let mut reader = Reader::new(document);
    let root = document.root();
    let views = reader.check_root(root, VIEWS.name).then(|| reader.views(root)).flatten();
    reader.sink.finish(views)
}

impl<'d> Reader<'d> {
    fn views(&mut self, root: Element<'d>) -> Option<Views> {
        let mut names = AutomaticNames::new([]);
        let elements = self.open(root, &VIEWS);
        if elements.is_empty() {
            self.sink.warning(root.name_span(), N7Problem::NoViews);
        }
        let views: Vec<Option<View>> =
            elements.into_iter().map(|(_, element)| self.view(element, names.next("view"))).collect();
        views.into_iter().collect()
    }

    fn view(&mut self, element: Element<'d>, name: Name) -> Option<View> {
        let within = self.open(element, &VIEW);
        let width = self.pixels(element, &VIEW, "largeur");
        let height = self.pixels(element, &VIEW, "hauteur");
        let eye = self.only((element, &VIEW), &within, &[EYE.name]).and_then(|eye| {
            let points = self.open(eye, &EYE);
            self.points((eye, &EYE), &points, Points::OfEye)
        });
        let corners = self.points((element, &VIEW), &within, Points::OfScreen);
        let ([eye], corners, width, height) = (eye?, corners?, width?, height?);
        self.check_corners(element, corners, [width, height]);
        let screen = screen(corners, width, height);
        let view = screen.map(|screen| View {
            name,
            width,
            height,
            eye,
            screen: ScreenSpec::Frame(screen),
            samples: 1,
            depth: None,
            steps: Steps::default(),
        });
        match view.and_then(|view| view.check().map(|()| view)) {
            Ok(view) => Some(view),
            Err(rule) => {
                self.sink.error(element.name_span(), rule);
                None
            }
        }
    }

    fn pixels(&mut self, element: Element<'d>, rule: &Rule, name: &'static str) -> Option<u32> {
        let number = self.number(element, rule, name)?;
        let count = self.within(number, name, 1.0, f64::from(limits::PIXELS))?;
        if count.fract() != 0.0 {
            let found = Excerpt::new(&shortest(count));
            self.sink.error(number.span, ValueProblem::NotWhole { found });
            return None;
        }
        Some(count as u32)
    }

    /// Warns of corners that say something else than what is taken from them.
    fn check_corners(&mut self, element: Element<'d>, corners: [DVec3; 4], pixels: [u32; 2]) {
        let [bottom_left, bottom_right, top_right, top_left] = corners;
        let (u, v) = (top_right - top_left, bottom_left - top_left);
        if (top_left + u + v - bottom_right).length() > 1e-6 * u.length().max(v.length()) {
            let second = element.elements().filter(|child| child.name() == "Point").nth(1).unwrap_or(element);
            self.sink.warning(second.name_span(), N7Problem::CrookedCorner);
        }
        for ((name, pixels), edge) in ["largeur", "hauteur"].into_iter().zip(pixels).zip([u, v]) {
            let (extent, apart) = (f64::from(pixels), edge.length());
            if (apart - extent).abs() > 0.01 * extent {
                let span = element.attribute(name).map_or(element.name_span(), |attribute| attribute.value_span);
                self.sink.warning(span, N7Problem::Extent { name, extent, apart });
            }
        }
    }
}

/// The screen that four corners and the extent mean: the corners give its place and its directions, the counts of
/// pixels its size. Pixels were sampled at their corner, and native ones are at their centre, so the screen lies half a
/// pixel further up and left.
fn screen(corners: [DVec3; 4], width: u32, height: u32) -> Result<Screen, Invalid> {
    let [bottom_left, _, top_right, top_left] = corners;
    let right = (top_right - top_left).try_normalize().ok_or(Invalid::ScreenCollinear)?;
    let down = (bottom_left - top_left).try_normalize().ok_or(Invalid::ScreenCollinear)?;
    let origin = top_left - (right + down) * 0.5;
    Ok(Screen { origin, u: right * f64::from(width), v: down * f64::from(height) })
}
