//! The writer of `Rendu` documents.
//!
//! The format has one unit of length for each pixel. A screen can be brought to that size without changing the picture:
//! seen from the eye, a screen twice as large and twice as far shows the same, and objects between eye and screen are
//! seen, too.

use super::loss::Losses;
use super::writer::{Writer, point};
use super::{Feature, Loss};
use crate::xml::AutomaticNames;
use lancer_scene::{Screen, ScreenSpec, Steps, View, Views};

/// The views as a document of 2009, and what it could not hold.
pub fn write_views(views: &Views) -> (String, Vec<Loss>) {
    let mut losses = Losses::default();
    let mut names = AutomaticNames::new([]);
    let mut writer = Writer::new();
    writer.around("Rendu", "", |writer| {
        for view in views {
            if names.next("view") != view.name {
                losses.of(Feature::Name, &view.name);
            }
            lost_of_view(view, &mut losses);
            // A view that breaks a rule has no screen, and is not written.
            let Ok(screen) = view.resolved_screen() else { continue };
            let attributes = format!(" largeur=\"{}\" hauteur=\"{}\"", view.width, view.height);
            writer.around("Vue", &attributes, |writer| {
                writer.line(&format!("<PointVue>{}</PointVue>", point(view.eye)));
                for corner in corners(view, &screen) {
                    writer.line(&point(corner));
                }
            });
        }
    });
    (writer.text, losses.0)
}

/// Bottom left, bottom right, top right, top left, as far from the eye as it takes for one unit a pixel, and half a
/// pixel further in: the pixels of 2009 are sampled at their corner.
fn corners(view: &View, screen: &Screen) -> [lancer_scene::DVec3; 4] {
    let (width, height) = (f64::from(view.width), f64::from(view.height));
    let larger = width / screen.u.length();
    let (right, down) = (screen.u.normalize(), screen.v.normalize());
    let top_left = view.eye + (screen.origin - view.eye) * larger + (right + down) * 0.5;
    let (u, v) = (right * width, down * height);
    [top_left + v, top_left + u + v, top_left + u, top_left]
}

fn lost_of_view(view: &View, losses: &mut Losses) {
    let Ok(screen) = view.resolved_screen() else { return };
    let pixel = [screen.u.length() / f64::from(view.width), screen.v.length() / f64::from(view.height)];
    let lost = [
        (!matches!(view.screen, ScreenSpec::Frame(_)) || (pixel[0] - 1.0).abs() > 1e-9, Feature::Screen),
        ((pixel[0] / pixel[1] - 1.0).abs() > 1e-9, Feature::Proportion),
        (view.samples != 1, Feature::Samples),
        (view.depth.is_some_and(|depth| depth != super::DEPTH), Feature::ViewDepth),
        (view.steps != Steps::default(), Feature::Steps),
    ];
    lost.into_iter().filter(|(lost, _)| *lost).for_each(|(_, feature)| losses.of(feature, &view.name));
}
