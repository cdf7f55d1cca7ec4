//! What can be added to a scene: its words, its picture, and what the document makes of it.

use crate::Context;
use egui_material_icons::MaterialIcon;
use egui_material_icons::icons as icon;
use lancer_document::insert::NewItem;
use lancer_scene::Surface;
use lancer_words::{Lang, studio::menu as words};

/// What the menu can add.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A sphere.
    Sphere,
    /// A plane.
    Plane,
    /// A cube.
    Cube,
    /// A box.
    Parallelepiped,
    /// A cone.
    Cone,
    /// A facet.
    Facet,
    /// A mesh from a file.
    Mesh,
    /// A lamp.
    Light,
    /// A material.
    Material,
    /// A view.
    View,
}

impl Kind {
    /// Every kind in the order of the menu.
    pub const ALL: [Kind; 10] = [
        Kind::Sphere,
        Kind::Plane,
        Kind::Cube,
        Kind::Parallelepiped,
        Kind::Cone,
        Kind::Facet,
        Kind::Mesh,
        Kind::Light,
        Kind::Material,
        Kind::View,
    ];

    pub(crate) fn words(self) -> (fn(Lang) -> String, MaterialIcon) {
        match self {
            Kind::Sphere => (words::sphere, icon::ICON_CIRCLE),
            Kind::Plane => (words::plane, icon::ICON_CROP_LANDSCAPE),
            Kind::Cube => (words::cube, icon::ICON_DEPLOYED_CODE),
            Kind::Parallelepiped => (words::parallelepiped, icon::ICON_VIEW_IN_AR),
            Kind::Cone => (words::cone, icon::ICON_ICECREAM),
            Kind::Facet => (words::facet, icon::ICON_CHANGE_HISTORY),
            Kind::Mesh => (words::mesh, icon::ICON_POLYLINE),
            Kind::Light => (words::light, icon::ICON_LIGHTBULB),
            Kind::Material => (words::material, icon::ICON_PALETTE),
            Kind::View => (words::new_view, icon::ICON_VIDEOCAM),
        }
    }

    /// The picture of the kind, the same wherever it stands.
    pub fn icon(self) -> MaterialIcon {
        self.words().1
    }

    /// What the document adds; `None` for a mesh, whose file is asked for first.
    pub(crate) fn item(self, context: &Context<'_>) -> Option<NewItem> {
        Some(match self {
            Kind::Sphere => NewItem::Sphere,
            Kind::Plane => NewItem::Plane,
            Kind::Cube => NewItem::Cube,
            Kind::Parallelepiped => NewItem::Parallelepiped,
            Kind::Cone => NewItem::Cone,
            Kind::Facet => NewItem::Facet,
            Kind::Mesh => return None,
            Kind::Light => NewItem::Light,
            Kind::Material => NewItem::Material { stem: String::new(), surface: Surface::default() },
            Kind::View => NewItem::View(context.active_view().map(|view| view.as_ref().clone())),
        })
    }
}
