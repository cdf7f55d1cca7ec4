//! Lint: what is legal in a scene and its views, but probably not what was meant.
//!
//! One function a rule, grouped by what they look at. A rule speaks only when it is sure: it follows from the model
//! (SPEC §1) that something takes no part in the picture, cannot look right, or depends on rounding. The cost is
//! bounded: nothing is compared with everything, and [`scenery::Scenery`] counts the effort.

mod coincide;
mod contents;
mod depth;
mod eye;
mod inside;
mod lamp;
mod material;
mod scenery;

use crate::{Name, NameKind, Scene, View};
use scenery::Scenery;
use std::sync::Arc;

/// What lint found, with the names that it is about. Hidden objects and lamps are passed over.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// No lamp is visible: there is ambient light only.
    NoLamp {
        /// How many hidden lamps there are.
        hidden: usize,
    },
    /// No object is visible: the picture shows the background only.
    NoObject {
        /// How many hidden objects there are.
        hidden: usize,
    },
    /// The lamp is black.
    DarkLamp {
        /// The lamp.
        lamp: Name,
    },
    /// The lamp is inside an object, which shadows everything outside; every eye is outside.
    LampInside {
        /// The lamp.
        lamp: Name,
        /// The object around it.
        object: Name,
    },
    /// An opaque plane parts the lamp from all that is seen.
    LampBehindPlane {
        /// The lamp.
        lamp: Name,
        /// The plane.
        plane: Name,
    },
    /// The eye is inside an opaque object and sees nothing of what is outside.
    EyeInside {
        /// The view.
        view: Name,
        /// The object around its eye.
        object: Name,
    },
    /// The eye is inside a transparent object: its rays start in that medium.
    EyeInGlass {
        /// The view.
        view: Name,
        /// The object around its eye.
        object: Name,
    },
    /// The eye is behind a transparent plane: its rays start in that medium.
    EyeBehindGlassPlane {
        /// The view.
        view: Name,
        /// The plane.
        plane: Name,
    },
    /// An opaque plane parts the eye from every other object.
    EyeBehindPlane {
        /// The view.
        view: Name,
        /// The plane.
        plane: Name,
    },
    /// The plane passes through the eye, which therefore does not see it.
    PlaneThroughEye {
        /// The view.
        view: Name,
        /// The plane.
        plane: Name,
    },
    /// The picture shows the scene mirrored.
    MirroredView {
        /// The view.
        view: Name,
    },
    /// The pixels are not square: the picture is stretched.
    PixelsNotSquare {
        /// The view.
        view: Name,
        /// A pixel's width on the screen over its height.
        ratio: f64,
    },
    /// With this depth limit an object cannot show what it mirrors or lets through.
    DepthTooSmall {
        /// The view whose own depth it is; `None` for the world's.
        view: Option<Name>,
        /// The depth limit.
        depth: u32,
        /// The least depth at which the object can.
        enough: u32,
        /// The object.
        object: Name,
        /// What it cannot show.
        bounce: Bounce,
    },
    /// Two parallel mirrors face each other, and at this depth limit most of the light is still on its way.
    FacingMirrors {
        /// The view whose own depth it is; `None` for the world's.
        view: Option<Name>,
        /// The depth limit.
        depth: u32,
        /// A depth at which at most a twentieth is left, or the greatest legal one.
        enough: u32,
        /// One mirror.
        first: Name,
        /// The other mirror.
        second: Name,
    },
    /// An opaque plane parts objects from every eye, though not all objects: they take no part in any picture.
    HiddenBehindPlane {
        /// The plane.
        plane: Name,
        /// The first of the objects.
        object: Name,
        /// How many there are.
        count: usize,
    },
    /// Faces of two objects lie in one place where both are met: which one is seen depends on rounding.
    CoincidentFaces {
        /// The object that comes first in the scene.
        first: Name,
        /// The other object.
        second: Name,
    },
    /// A transparent mesh is not closed, so it is taken for a sheet without thickness and does not refract.
    OpenGlass {
        /// The mesh.
        object: Name,
    },
    /// A lone facet has a refraction index of its own, which a sheet without thickness never shows.
    SheetGlass {
        /// The facet.
        object: Name,
    },
    /// A mesh has no facets.
    EmptyMesh {
        /// The mesh.
        object: Name,
    },
    /// No object has the material.
    UnusedMaterial {
        /// The material.
        material: Name,
    },
    /// The refraction index around the objects is less than that of empty space.
    WorldIndexBelowOne {
        /// The least of the three.
        index: f64,
    },
    /// A transparent surface has a refraction index less than that of empty space.
    IndexBelowOne {
        /// What has it.
        owner: Owner,
        /// The least of the three.
        index: f64,
    },
    /// `Ka·Ia` is 1 in every channel: whatever else reaches the surface, it is white everywhere.
    AlwaysWhite {
        /// What has it.
        owner: Owner,
    },
}

/// Whose surface it is.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Owner {
    /// A named material.
    Material(Name),
    /// An object with a surface of its own.
    Object(Name),
}

/// What a depth limit cuts off.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bounce {
    /// What a mirror shows.
    Reflection,
    /// What is behind something transparent.
    Transparency,
}

/// How much a finding matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Weight {
    /// Worth knowing; it may well be meant.
    Note,
    /// The picture is hardly what was meant.
    Warning,
}

impl Finding {
    /// The names that the finding is about, the most important first.
    pub fn names(&self) -> Vec<(NameKind, &Name)> {
        use NameKind::{Material, ObjectOrLight, View};
        match self {
            Finding::NoLamp { .. } | Finding::NoObject { .. } | Finding::WorldIndexBelowOne { .. } => vec![],
            Finding::DarkLamp { lamp } => vec![(ObjectOrLight, lamp)],
            Finding::LampInside { lamp, object } => vec![(ObjectOrLight, lamp), (ObjectOrLight, object)],
            Finding::LampBehindPlane { lamp, plane } => vec![(ObjectOrLight, lamp), (ObjectOrLight, plane)],
            Finding::EyeInside { view, object } | Finding::EyeInGlass { view, object } => {
                vec![(View, view), (ObjectOrLight, object)]
            }
            Finding::EyeBehindGlassPlane { view, plane }
            | Finding::EyeBehindPlane { view, plane }
            | Finding::PlaneThroughEye { view, plane } => vec![(View, view), (ObjectOrLight, plane)],
            Finding::MirroredView { view } | Finding::PixelsNotSquare { view, .. } => vec![(View, view)],
            Finding::DepthTooSmall { view, object, .. } => {
                view.iter().map(|view| (View, view)).chain([(ObjectOrLight, object)]).collect()
            }
            Finding::FacingMirrors { view, first, second, .. } => {
                let mirrors = [(ObjectOrLight, first), (ObjectOrLight, second)];
                view.iter().map(|view| (View, view)).chain(mirrors).collect()
            }
            Finding::HiddenBehindPlane { plane, object, .. } => vec![(ObjectOrLight, object), (ObjectOrLight, plane)],
            Finding::CoincidentFaces { first, second } => vec![(ObjectOrLight, first), (ObjectOrLight, second)],
            Finding::OpenGlass { object } | Finding::SheetGlass { object } | Finding::EmptyMesh { object } => {
                vec![(ObjectOrLight, object)]
            }
            Finding::UnusedMaterial { material } => vec![(Material, material)],
            Finding::IndexBelowOne { owner, .. } | Finding::AlwaysWhite { owner } => match owner {
                Owner::Material(name) => vec![(Material, name)],
                Owner::Object(name) => vec![(ObjectOrLight, name)],
            },
        }
    }

    /// How much it matters.
    pub fn weight(&self) -> Weight {
        match self {
            Finding::EyeInGlass { .. }
            | Finding::EyeBehindGlassPlane { .. }
            | Finding::SheetGlass { .. }
            | Finding::FacingMirrors { .. }
            | Finding::UnusedMaterial { .. }
            | Finding::WorldIndexBelowOne { .. }
            | Finding::IndexBelowOne { .. }
            | Finding::AlwaysWhite { .. } => Weight::Note,
            Finding::NoLamp { .. }
            | Finding::NoObject { .. }
            | Finding::DarkLamp { .. }
            | Finding::LampInside { .. }
            | Finding::LampBehindPlane { .. }
            | Finding::EyeInside { .. }
            | Finding::EyeBehindPlane { .. }
            | Finding::PlaneThroughEye { .. }
            | Finding::MirroredView { .. }
            | Finding::PixelsNotSquare { .. }
            | Finding::DepthTooSmall { .. }
            | Finding::HiddenBehindPlane { .. }
            | Finding::CoincidentFaces { .. }
            | Finding::OpenGlass { .. }
            | Finding::EmptyMesh { .. } => Weight::Warning,
        }
    }
}

/// Everything that probably is not meant in a legal scene and its legal views, rule by rule in document order.
///
/// Some rules need to know where the eyes are; without views they speak only if it holds for every eye.
pub fn lint(scene: &Scene, views: &[Arc<View>]) -> Vec<Finding> {
    let scenery = Scenery::new(scene, views);
    let rules: &[fn(&Scenery<'_>, &mut Vec<Finding>)] = &[
        contents::no_object,
        contents::empty_mesh,
        lamp::no_lamp,
        lamp::dark_lamp,
        lamp::lamp_inside,
        lamp::lamp_behind_plane,
        eye::eye_inside,
        eye::eye_behind_plane,
        eye::plane_through_eye,
        eye::mirrored_view,
        eye::pixels_not_square,
        depth::depth_too_small,
        depth::facing_mirrors,
        contents::hidden_behind_plane,
        coincide::coincident_faces,
        contents::open_glass,
        contents::sheet_glass,
        material::index_below_one,
        material::always_white,
        material::unused_material,
    ];
    let mut findings = Vec::new();
    for rule in rules {
        rule(&scenery, &mut findings);
    }
    findings
}
