//! The menus of the bar: which entries stand where.

use crate::entry::Entry;
use crate::kind::Kind;
use crate::{Exported, Tab};
use lancer_document::navigate::Side;
use lancer_words::{Lang, studio::menu as words};

/// The entries of a menu, in groups.
pub type Groups = &'static [&'static [Entry]];

/// A name in each language.
type Words = fn(Lang) -> String;

/// The menus of the bar: their names, the letter that opens them with Alt, their entries.
pub const MENUS: &[(Words, Menu, Groups)] = &[
    (
        words::file,
        Menu::File,
        &[
            &[Entry::New, Entry::Open],
            &[Entry::Save, Entry::SaveAs],
            &[Entry::LoadViews, Entry::SaveViews, Entry::SaveViewsAs],
            &[Entry::SavePicture],
            &[
                Entry::Export(Exported::Povray),
                Entry::Export(Exported::Obj),
                Entry::Export(Exported::Gltf),
                Entry::Export(Exported::Glb),
                Entry::Export(Exported::Scene2009),
                Entry::Export(Exported::Views2009),
            ],
            &[Entry::Quit],
        ],
    ),
    (
        words::edit,
        Menu::Edit,
        &[
            &[Entry::Undo, Entry::Redo],
            &[Entry::Duplicate, Entry::Delete, Entry::Rename, Entry::ToggleVisible],
            &[Entry::SelectAll, Entry::SelectNone],
        ],
    ),
    (
        words::add,
        Menu::Add,
        &[
            &[
                Entry::Add(Kind::Sphere),
                Entry::Add(Kind::Plane),
                Entry::Add(Kind::Cube),
                Entry::Add(Kind::Parallelepiped),
                Entry::Add(Kind::Cone),
                Entry::Add(Kind::Facet),
                Entry::Add(Kind::Mesh),
            ],
            &[Entry::Add(Kind::Light), Entry::Add(Kind::Material), Entry::Add(Kind::View)],
        ],
    ),
    (
        words::view,
        Menu::View,
        &[
            &[Entry::SplitRight, Entry::SplitBelow, Entry::Detach, Entry::CloseView, Entry::NextView],
            &[
                Entry::Look(Side::Front),
                Entry::Look(Side::Back),
                Entry::Look(Side::Right),
                Entry::Look(Side::Left),
                Entry::Look(Side::Top),
                Entry::Look(Side::Bottom),
            ],
            &[Entry::Frame, Entry::Grid, Entry::Fit],
            &[Entry::Outliner, Entry::Properties, Entry::Tabs],
            &[
                Entry::ShowTab(Tab::Text),
                Entry::ShowTab(Tab::Xml),
                Entry::ShowTab(Tab::Explain),
                Entry::ShowTab(Tab::Problems),
                Entry::ShowTab(Tab::History),
            ],
            &[Entry::ZoomIn, Entry::ZoomOut, Entry::ZoomReset, Entry::ResetLayout],
        ],
    ),
    (
        words::render,
        Menu::Render,
        &[&[Entry::Pause, Entry::Restart, Entry::NoRegion], &[Entry::CopyPicture, Entry::SavePicture]],
    ),
    (words::help, Menu::Help, &[&[Entry::Shortcuts, Entry::About]]),
];

/// The menus of the bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Menu {
    /// Files.
    File,
    /// The document.
    Edit,
    /// New things.
    Add,
    /// Views and panels.
    View,
    /// Pictures.
    Render,
    /// Help.
    Help,
}
