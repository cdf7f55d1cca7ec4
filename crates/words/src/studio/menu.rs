//! Words of the editor's menus, tool bar and shortcuts.

phrases! {
    /// The menu of files.
    file() { "File", "Fichier" }
}
