//! What lint found, in words. The rules know no language, and the formats tell everything else that is said of a scene.

use crate::Describe;
use crate::xml::Excerpt;
use lancer_scene::{Bounce, Finding, Name, Owner};
use lancer_words::{Lang, lint as words};

/// A name as a sentence quotes it.
fn quoted(name: &Name) -> Excerpt {
    Excerpt::new(name)
}

/// Three digits are enough for a reader.
fn rounded(number: f64) -> String {
    let fixed = format!("{number:.3}");
    fixed.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn depth_message(lang: Lang, view: Option<&Name>, sentence: String) -> String {
    match view {
        Some(view) => words::depth_of_view(lang, quoted(view), sentence),
        None => sentence,
    }
}

impl Describe for Finding {
    fn code(&self) -> &'static str {
        match self {
            Finding::NoLamp { .. } => "lint::no-lamp",
            Finding::NoObject { .. } => "lint::no-object",
            Finding::DarkLamp { .. } => "lint::dark-lamp",
            Finding::LampInside { .. } => "lint::lamp-inside",
            Finding::LampBehindPlane { .. } => "lint::lamp-behind-plane",
            Finding::EyeInside { .. } => "lint::eye-inside",
            Finding::EyeInGlass { .. } => "lint::eye-in-glass",
            Finding::EyeBehindGlassPlane { .. } => "lint::eye-behind-glass-plane",
            Finding::EyeBehindPlane { .. } => "lint::eye-behind-plane",
            Finding::PlaneThroughEye { .. } => "lint::plane-through-eye",
            Finding::MirroredView { .. } => "lint::mirrored-view",
            Finding::PixelsNotSquare { .. } => "lint::pixels-not-square",
            Finding::DepthTooSmall { .. } => "lint::depth-too-small",
            Finding::FacingMirrors { .. } => "lint::facing-mirrors",
            Finding::HiddenBehindPlane { .. } => "lint::hidden-behind-plane",
            Finding::CoincidentFaces { .. } => "lint::coincident-faces",
            Finding::OpenGlass { .. } => "lint::open-glass",
            Finding::SheetGlass { .. } => "lint::sheet-glass",
            Finding::EmptyMesh { .. } => "lint::empty-mesh",
            Finding::UnusedMaterial { .. } => "lint::unused-material",
            Finding::WorldIndexBelowOne { .. } | Finding::IndexBelowOne { .. } => "lint::index-below-one",
            Finding::AlwaysWhite { .. } => "lint::always-white",
        }
    }

    fn message(&self, lang: Lang) -> String {
        match self {
            Finding::NoLamp { hidden: 0 } => words::no_lamp(lang),
            Finding::NoLamp { .. } => words::all_lamps_hidden(lang),
            Finding::NoObject { hidden: 0 } => words::no_object(lang),
            Finding::NoObject { .. } => words::all_objects_hidden(lang),
            Finding::DarkLamp { lamp } => words::dark_lamp(lang, quoted(lamp)),
            Finding::LampInside { lamp, object } => words::lamp_inside(lang, quoted(lamp), quoted(object)),
            Finding::LampBehindPlane { lamp, plane } => words::lamp_behind_plane(lang, quoted(lamp), quoted(plane)),
            Finding::EyeInside { view, object } => words::eye_inside(lang, quoted(view), quoted(object)),
            Finding::EyeInGlass { view, object } => words::eye_in_glass(lang, quoted(view), quoted(object)),
            Finding::EyeBehindGlassPlane { view, plane } => {
                words::eye_behind_glass_plane(lang, quoted(view), quoted(plane))
            }
            Finding::EyeBehindPlane { view, plane } => words::eye_behind_plane(lang, quoted(view), quoted(plane)),
            Finding::PlaneThroughEye { view, plane } => words::plane_through_eye(lang, quoted(view), quoted(plane)),
            Finding::MirroredView { view } => words::mirrored_view(lang, quoted(view)),
            Finding::PixelsNotSquare { view, ratio } if *ratio > 1.0 => {
                words::pixels_too_wide(lang, quoted(view), rounded(*ratio))
            }
            Finding::PixelsNotSquare { view, ratio } => {
                words::pixels_too_high(lang, quoted(view), rounded(1.0 / ratio))
            }
            Finding::DepthTooSmall { view, depth, object, bounce, .. } => {
                let sentence = match bounce {
                    Bounce::Reflection => words::depth_too_small_for_mirror(lang, depth, quoted(object)),
                    Bounce::Transparency => words::depth_too_small_for_glass(lang, depth, quoted(object)),
                };
                depth_message(lang, view.as_ref(), sentence)
            }
            Finding::FacingMirrors { view, depth, first, second, .. } => {
                let sentence = words::facing_mirrors(lang, depth, quoted(first), quoted(second));
                depth_message(lang, view.as_ref(), sentence)
            }
            Finding::HiddenBehindPlane { plane, object, count: 1 } => {
                words::one_hidden_behind_plane(lang, quoted(plane), quoted(object))
            }
            Finding::HiddenBehindPlane { plane, object, count } => {
                words::hidden_behind_plane(lang, quoted(plane), quoted(object), count)
            }
            Finding::CoincidentFaces { first, second } => words::coincident_faces(lang, quoted(first), quoted(second)),
            Finding::OpenGlass { object } => words::open_glass(lang, quoted(object)),
            Finding::SheetGlass { object } => words::sheet_glass(lang, quoted(object)),
            Finding::EmptyMesh { object } => words::empty_mesh(lang, quoted(object)),
            Finding::UnusedMaterial { material } => words::unused_material(lang, quoted(material)),
            Finding::WorldIndexBelowOne { index } => words::world_index_below_one(lang, index),
            Finding::IndexBelowOne { owner, index } => match owner {
                Owner::Material(name) => words::material_index_below_one(lang, quoted(name), index),
                Owner::Object(name) => words::object_index_below_one(lang, quoted(name), index),
            },
            Finding::AlwaysWhite { owner: Owner::Material(name) } => words::material_always_white(lang, quoted(name)),
            Finding::AlwaysWhite { owner: Owner::Object(name) } => words::object_always_white(lang, quoted(name)),
        }
    }

    fn label(&self, _lang: Lang) -> String {
        String::new()
    }

    fn help(&self, lang: Lang) -> Option<String> {
        Some(match self {
            Finding::NoLamp { hidden: 0 } => words::no_lamp_help(lang),
            Finding::NoObject { hidden: 0 } => words::no_object_help(lang),
            Finding::NoLamp { .. } | Finding::NoObject { .. } => words::show_one_help(lang),
            Finding::DarkLamp { .. } => words::dark_lamp_help(lang),
            Finding::LampInside { .. } => words::lamp_inside_help(lang),
            Finding::LampBehindPlane { .. } => words::lamp_behind_plane_help(lang),
            Finding::EyeInside { .. } => words::eye_inside_help(lang),
            Finding::EyeInGlass { .. } => words::eye_in_glass_help(lang),
            Finding::EyeBehindGlassPlane { .. } => words::eye_behind_glass_plane_help(lang),
            Finding::EyeBehindPlane { .. } => words::eye_behind_plane_help(lang),
            Finding::PlaneThroughEye { .. } => words::plane_through_eye_help(lang),
            Finding::MirroredView { .. } => words::mirrored_view_help(lang),
            Finding::PixelsNotSquare { .. } => words::pixels_not_square_help(lang),
            Finding::DepthTooSmall { enough: 2.., bounce: Bounce::Transparency, .. } => words::glass_depth_help(lang),
            Finding::DepthTooSmall { enough, .. } => words::depth_too_small_help(lang, enough),
            Finding::FacingMirrors { enough, .. } => words::facing_mirrors_help(lang, enough),
            Finding::HiddenBehindPlane { .. } => words::hidden_behind_plane_help(lang),
            Finding::CoincidentFaces { .. } => words::coincident_faces_help(lang),
            Finding::OpenGlass { .. } => words::open_glass_help(lang),
            Finding::SheetGlass { .. } => words::sheet_glass_help(lang),
            Finding::EmptyMesh { .. } => words::empty_mesh_help(lang),
            Finding::UnusedMaterial { material } => words::unused_material_help(lang, quoted(material)),
            Finding::WorldIndexBelowOne { .. } | Finding::IndexBelowOne { .. } => words::index_below_one_help(lang),
            Finding::AlwaysWhite { .. } => words::always_white_help(lang),
        })
    }
}
