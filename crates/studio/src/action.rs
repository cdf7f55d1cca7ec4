//! What a panel asks for. A panel changes nothing itself: it returns actions, and `perform` carries them out in one
//! place.

use crate::explainer::Target;
use crate::toasts::Toast;
use egui_tiles::LinearDir;
use lancer_document::insert::NewItem;
use lancer_document::navigate::Side;
use lancer_document::{Command, Item, Selection, StepName};
use lancer_formats::picture::Format;
use lancer_render::Region;
use lancer_scene::{Edit, Name};
use lancer_words::{Lang, studio::menu as words};
use std::path::PathBuf;

/// Something that the user wants.
#[derive(Clone, Debug)]
pub enum Action {
    /// One edit, one step.
    Apply(StepName, Edit),
    /// One step as the document's functions make it, and what is selected after it.
    Run(Command),
    /// Adds something in front of the active view.
    Add(NewItem),
    /// A drag begins: everything previewed until [`Action::Commit`] is one step.
    Begin(StepName),
    /// What the drag has come to: an edit of the stage before the drag (`Document::base`).
    Preview(Edit),
    /// The drag ends and becomes a step.
    Commit,
    /// The drag ends and is taken back.
    Cancel,
    /// Selects exactly these things.
    Select(Selection),
    /// Takes the last step back.
    Undo,
    /// Brings the last undone step back.
    Redo,
    /// Goes to a step of the history.
    Jump(usize),
    /// Something about files.
    File(FileAction),
    /// Something about one view.
    View(Name, ViewAction),
    /// Begins to rename something in the outliner.
    Rename(Item),
    /// The renaming in the outliner is over, done or not.
    EndRename,
    /// Explains a pixel.
    Explain(Target),
    /// Brings a tab at the bottom to the front.
    ShowTab(Tab),
    /// Puts text on the clipboard.
    CopyText(String),
    /// Says something in a corner of the window.
    Say(Toast),
    /// Something about the window itself.
    Window(WindowAction),
}

/// What happens to files.
#[derive(Clone, Debug, PartialEq)]
pub enum FileAction {
    /// A new scene.
    New,
    /// Opens a scene or views; without a path a dialog asks for one.
    Open(Option<PathBuf>),
    /// Saves the scene where it came from.
    Save,
    /// Saves the scene elsewhere.
    SaveAs,
    /// Loads a document of views into the scene.
    LoadViews,
    /// Saves the views.
    SaveViews,
    /// Saves the views elsewhere.
    SaveViewsAs,
    /// Saves a text such as the scene in words; the name is proposed.
    SaveText {
        /// The proposed file name.
        name: String,
        /// What the file will hold.
        text: String,
    },
    /// Writes the scene or the views for another program.
    Export(Exported),
    /// Reads a mesh file and adds it as an object.
    AddMesh,
    /// Ends the program.
    Quit,
}

/// What is written for another program, and in which format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Exported {
    /// The scene with the active view, for POV-Ray.
    Povray,
    /// The objects, as Wavefront's OBJ with the library of their materials.
    Obj,
    /// The objects, as glTF 2.0 in text.
    Gltf,
    /// The objects, as glTF 2.0 in one binary file.
    Glb,
    /// The scene, in the format of 2009.
    Scene2009,
    /// The views, in the format of 2009.
    Views2009,
}

impl Exported {
    /// The name of what is exported.
    pub(crate) fn name(self, lang: Lang) -> String {
        match self {
            Exported::Povray => words::export_povray(lang),
            Exported::Obj => words::export_obj(lang),
            Exported::Gltf => words::export_gltf(lang),
            Exported::Glb => words::export_glb(lang),
            Exported::Scene2009 => words::export_scene_2009(lang),
            Exported::Views2009 => words::export_views_2009(lang),
        }
    }

    /// The name of the format, at the beginning of a sentence.
    pub(crate) fn format(self, lang: Lang) -> String {
        match self {
            Exported::Povray => words::format_povray(lang),
            Exported::Obj => words::format_obj(lang),
            Exported::Gltf | Exported::Glb => words::format_gltf(lang),
            Exported::Scene2009 | Exported::Views2009 => words::format_2009(lang),
        }
    }

    /// What follows the document's name in the name that is proposed, and the extension.
    pub(crate) fn ending(self) -> (&'static str, &'static str) {
        match self {
            Exported::Povray => ("", "pov"),
            Exported::Obj => ("", "obj"),
            Exported::Gltf => ("", "gltf"),
            Exported::Glb => ("", "glb"),
            Exported::Scene2009 => ("-2009", "xml"),
            Exported::Views2009 => ("-2009.view", "xml"),
        }
    }
}

/// What happens to one view.
#[derive(Clone, Debug, PartialEq)]
pub enum ViewAction {
    /// Shows it in a pane, or brings its pane to the front.
    Show,
    /// Closes its panes; the view stays in the document.
    Close,
    /// Shows it in a window of its own.
    Detach,
    /// Brings it back into the main window.
    Attach,
    /// Shows a copy of it beside or below it.
    Split(LinearDir),
    /// The pane is the one that is worked in.
    Focus,
    /// The pane after it is the one that is worked in.
    FocusNext,
    /// Looks along an axis.
    Look(Side),
    /// Rests or goes on.
    Pause(bool),
    /// The picture has the size of the view, or is made to fit the pane.
    Fit(bool),
    /// Shows or hides grid and axes.
    Grid(bool),
    /// Refines a rectangle of the picture first.
    First(Option<Region>),
    /// Begins the picture again.
    Restart,
    /// Saves the picture; a dialog asks where, beginning with that format.
    SavePicture(Format),
    /// Puts the picture on the clipboard.
    CopyPicture,
    /// Makes the selection, or everything, fill the view.
    Frame,
}

/// What happens to the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WindowAction {
    /// Speaks another language.
    Language(lancer_words::Lang),
    /// Light, dark, or as the system says.
    Theme(egui::ThemePreference),
    /// Makes everything larger or smaller: a factor, 0.5..=3.
    Zoom(f32),
    /// Shows or hides the outliner.
    Outliner(bool),
    /// Shows or hides the properties.
    Properties(bool),
    /// Shows or hides the tabs at the bottom.
    Tabs(bool),
    /// Shows or hides the sheet of shortcuts.
    Shortcuts(bool),
    /// Shows or hides what the program is.
    About(bool),
    /// Puts the panels where they were in the beginning.
    ResetLayout,
}

/// The tabs at the bottom.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
pub enum Tab {
    /// The scene as text.
    #[default]
    Text,
    /// The scene as a document.
    Xml,
    /// A pixel with all its rays.
    Explain,
    /// What is wrong with the last file.
    Problems,
    /// The steps.
    History,
}

impl Tab {
    /// Every tab in its order.
    pub const ALL: [Tab; 5] = [Tab::Text, Tab::Xml, Tab::Explain, Tab::Problems, Tab::History];
}
