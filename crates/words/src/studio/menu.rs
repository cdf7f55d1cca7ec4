//! Words of the editor's menus, tool bar and shortcuts.

use crate::Lang;

phrases! {
    /// The menu of files.
    file() { "File", "Fichier" }
    /// The menu of edits.
    edit() { "Edit", "Édition" }
    /// The menu of new things.
    add() { "Add", "Ajouter" }
    /// The menu of views and panels.
    view() { "View", "Affichage" }
    /// The menu of pictures.
    render() { "Render", "Rendu" }
    /// The menu of help.
    help() { "Help", "Aide" }

    /// Begins a new scene.
    new() { "New scene", "Nouvelle scène" }
    /// Opens a file.
    open() { "Open…", "Ouvrir…" }
    /// The files that were opened last.
    open_recent() { "Open recent", "Fichiers récents" }
    /// There are no such files.
    no_recent() { "No recent files", "Aucun fichier récent" }
    /// Saves the scene.
    save() { "Save", "Enregistrer" }
    /// Saves the scene elsewhere.
    save_as() { "Save as…", "Enregistrer sous…" }
    /// Loads views.
    load_views() { "Load views…", "Charger des vues…" }
    /// Saves the views.
    save_views() { "Save views", "Enregistrer les vues" }
    /// Saves the views elsewhere.
    save_views_as() { "Save views as…", "Enregistrer les vues sous…" }
    /// The menu of exports.
    export() { "Export", "Exporter" }
    /// What is exported.
    export_povray() { "Scene for POV-Ray (.pov)", "Scène pour POV-Ray (.pov)" }
    /// What is exported.
    export_obj() { "Objects as OBJ (.obj)", "Objets en OBJ (.obj)" }
    /// What is exported.
    export_gltf() { "Objects as glTF (.gltf)", "Objets en glTF (.gltf)" }
    /// What is exported.
    export_glb() { "Objects as binary glTF (.glb)", "Objets en glTF binaire (.glb)" }
    /// What is exported.
    export_scene_2009() { "Scene in the format of 2009 (.xml)", "Scène au format de 2009 (.xml)" }
    /// What is exported.
    export_views_2009() { "Views in the format of 2009 (.xml)", "Vues au format de 2009 (.xml)" }
    /// A format, at the beginning of a sentence.
    format_2009() { "The format of 2009", "Le format de 2009" }
    /// A format, at the beginning of a sentence.
    format_povray() { "POV-Ray", "POV-Ray" }
    /// A format, at the beginning of a sentence.
    format_obj() { "OBJ", "OBJ" }
    /// A format, at the beginning of a sentence.
    format_gltf() { "glTF", "glTF" }
    /// The tabs at the bottom.
    show_tab() { "Show tab", "Afficher l'onglet" }
    /// Saves a picture.
    save_picture() { "Save picture…", "Enregistrer l'image…" }
    /// Ends the program.
    quit() { "Quit", "Quitter" }

    /// Takes a step back.
    undo() { "Undo", "Annuler" }
    /// Brings a step back.
    redo() { "Redo", "Rétablir" }
    /// Takes that step back.
    undo_step(step) { "Undo: {step}", "Annuler : {step}" }
    /// Brings that step back.
    redo_step(step) { "Redo: {step}", "Rétablir : {step}" }
    /// Copies the selection.
    duplicate() { "Duplicate", "Dupliquer" }
    /// Deletes the selection.
    delete() { "Delete", "Supprimer" }
    /// Renames the selection.
    rename() { "Rename", "Renommer" }
    /// Hides the selection from the picture, or shows it.
    toggle_visible() { "Hide or show in the picture", "Masquer ou afficher dans l'image" }
    /// Selects every object and lamp.
    select_all() { "Select all", "Tout sélectionner" }
    /// Selects nothing.
    select_none() { "Select nothing", "Ne rien sélectionner" }

    /// Adds a sphere.
    sphere() { "Sphere", "Sphère" }
    /// Adds a plane.
    plane() { "Plane", "Plan" }
    /// Adds a cube.
    cube() { "Cube", "Cube" }
    /// Adds a box.
    parallelepiped() { "Box", "Parallélépipède" }
    /// Adds a cone.
    cone() { "Cone", "Cône" }
    /// Adds a facet.
    facet() { "Facet", "Facette" }
    /// Adds a mesh from a file.
    mesh() { "Mesh from a file…", "Maillage depuis un fichier…" }
    /// Adds a lamp.
    light() { "Lamp", "Source de lumière" }
    /// Adds a material.
    material() { "Material", "Matière" }
    /// Adds a view.
    new_view() { "View", "Vue" }
    /// What the button of a kind does.
    add_kind(kind) { "Add: {kind}", "Ajouter : {kind}" }

    /// A new view beside the active one.
    split_right() { "New view on the right", "Nouvelle vue à droite" }
    /// A new view below the active one.
    split_below() { "New view below", "Nouvelle vue en dessous" }
    /// Shows a view.
    show_view() { "Show view", "Afficher la vue" }
    /// A window of its own.
    detach() { "Open in its own window", "Ouvrir dans sa propre fenêtre" }
    /// Back into the main window.
    attach() { "Back into the main window", "Remettre dans la fenêtre principale" }
    /// Closes the pane.
    close_view() { "Close view pane", "Fermer le volet de la vue" }
    /// The pane after the active one.
    next_view() { "Next view", "Vue suivante" }
    /// From where it is looked.
    look_from() { "Look from", "Regarder depuis" }
    /// Along -z.
    front() { "Front", "Face" }
    /// Along +z.
    back() { "Back", "Arrière" }
    /// Along -x.
    right() { "Right", "Droite" }
    /// Along +x.
    left() { "Left", "Gauche" }
    /// Along -y.
    top() { "Top", "Dessus" }
    /// Along +y.
    bottom() { "Bottom", "Dessous" }
    /// Makes the selection fill the view.
    frame() { "Frame the selection", "Cadrer la sélection" }
    /// The ground grid and the axes.
    grid() { "Ground grid and axes", "Grille du sol et axes" }
    /// Whether pictures fit their panes.
    fit() { "Fit the picture to the pane", "Adapter l'image au volet" }
    /// The outliner.
    show_outliner() { "Scene panel", "Panneau de la scène" }
    /// The properties.
    show_properties() { "Properties panel", "Panneau des propriétés" }
    /// The tabs at the bottom.
    show_tabs() { "Bottom panel", "Panneau du bas" }
    /// Everything larger.
    zoom_in() { "Larger text", "Texte plus grand" }
    /// Everything smaller.
    zoom_out() { "Smaller text", "Texte plus petit" }
    /// The usual size.
    zoom_reset() { "Normal text size", "Taille de texte normale" }
    /// The panels where they were in the beginning.
    reset_layout() { "Reset the layout", "Réinitialiser la disposition" }
    /// Light or dark.
    theme() { "Theme", "Thème" }
    /// The light theme.
    light_theme() { "Light", "Clair" }
    /// The dark theme.
    dark_theme() { "Dark", "Sombre" }
    /// The system's theme.
    system_theme() { "As the system", "Comme le système" }
    /// The language.
    language() { "Language", "Langue" }
    /// The other theme.
    switch_theme() { "Switch between light and dark", "Basculer entre clair et sombre" }
    /// The other language, in its own words.
    switch_language() { "Passer en français", "Switch to English" }

    /// Rests.
    pause() { "Pause", "Pause" }
    /// Goes on.
    resume() { "Go on", "Reprendre" }
    /// Begins again.
    restart() { "Render again", "Relancer le rendu" }
    /// Puts the picture on the clipboard.
    copy_picture() { "Copy picture", "Copier l'image" }
    /// Refines everything evenly again.
    no_region() { "No rectangle first", "Sans rectangle prioritaire" }

    /// The sheet of shortcuts.
    shortcuts() { "Keyboard and mouse", "Clavier et souris" }
    /// What the program is.
    about() { "About lancer", "À propos de lancer" }
    /// What the program is, in words.
    about_text() {
        "An exact, explainable Whitted ray tracer for the course «Synthèse d'images par lancer de rayon».",
        "Un lanceur de rayons de Whitted exact et explicable, pour le cours «Synthèse d'images par lancer de rayon».",
    }
    /// The version.
    version(version) { "Version {version}", "Version {version}" }
    /// The licence.
    licence() { "Licence: MIT or Apache 2.0", "Licence : MIT ou Apache 2.0" }

    /// The sheet's part on the mouse.
    in_a_view() { "In a view", "Dans une vue" }
    /// A gesture.
    click() { "Click", "Clic" }
    /// What it does.
    click_does() { "Select the object", "Sélectionner l'objet" }
    /// A gesture.
    shift_click() { "Shift + click", "Maj + clic" }
    /// What it does.
    shift_click_does() { "Add to the selection, or take out", "Ajouter à la sélection, ou retirer" }
    /// A gesture.
    drag_selected() { "Drag a selected object", "Glisser un objet sélectionné" }
    /// What it does.
    drag_selected_does() { "Move it in the view's plane", "Le déplacer dans le plan de la vue" }
    /// A gesture.
    drag_axis() { "X, Y, Z while moving", "X, Y, Z pendant le déplacement" }
    /// What it does.
    drag_axis_does() { "Move along that axis only", "Ne déplacer que selon cet axe" }
    /// A gesture.
    drag_snap() { "Ctrl while moving", "Ctrl pendant le déplacement" }
    /// What it does.
    drag_snap_does() { "Snap to the grid", "Aligner sur la grille" }
    /// A gesture.
    drag_escape() { "Esc while dragging", "Échap pendant un glissement" }
    /// What it does.
    drag_escape_does() { "Take the drag back", "Annuler le glissement" }
    /// A gesture.
    orbit() { "Drag with the right button, or Alt + drag", "Glisser avec le bouton droit, ou Alt + glisser" }
    /// What it does.
    orbit_does() { "Turn around what is in the middle", "Tourner autour du centre de la vue" }
    /// A gesture.
    pan() { "Drag with the middle button, or Shift + drag", "Glisser avec le bouton du milieu, ou Maj + glisser" }
    /// What it does.
    pan_does() { "Shift the view", "Décaler la vue" }
    /// A gesture.
    wheel() { "Wheel, or two fingers", "Molette, ou deux doigts" }
    /// What it does.
    wheel_does() { "Go nearer or farther", "S'approcher ou s'éloigner" }
    /// A gesture.
    arrows() { "Arrow keys", "Flèches" }
    /// What it does.
    arrows_does() { "Turn the view; with Shift: shift it", "Tourner la vue ; avec Maj : la décaler" }
    /// A gesture.
    page_keys() { "Page up, page down", "Page préc., page suiv." }
    /// What it does.
    page_keys_does() { "Go nearer or farther", "S'approcher ou s'éloigner" }
    /// A gesture.
    explain_click() { "Click with the Explain tab open", "Clic, l'onglet Explication étant ouvert" }
    /// What it does.
    explain_click_does() { "Explain that pixel, ray by ray", "Expliquer ce pixel, rayon par rayon" }
    /// A gesture.
    region() { "Ctrl + drag, or R then drag", "Ctrl + glisser, ou R puis glisser" }
    /// What it does.
    region_does() { "Render that rectangle first", "Calculer d'abord ce rectangle" }
}

/// The name of a shortcut such as `Ctrl+Shift+S` as keyboards of that language have it, from the toolkit's English name.
pub fn keys(lang: Lang, english: &str) -> String {
    let name = |key: &str| -> String {
        let (english, french) = match key {
            "Shift" => ("Shift", "Maj"),
            "Delete" => ("Del", "Suppr"),
            "Escape" => ("Esc", "Échap"),
            "Space" => ("Space", "Espace"),
            "Backslash" => ("\\", "\\"),
            "Plus" => ("+", "+"),
            "Minus" => ("-", "-"),
            other => (other, other),
        };
        match lang {
            Lang::English => english,
            Lang::French => french,
        }
        .to_owned()
    };
    english.split('+').map(name).collect::<Vec<_>>().join("+")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_named_as_the_keyboard_has_them() {
        assert_eq!(keys(Lang::French, "Ctrl+Shift+S"), "Ctrl+Maj+S");
        assert_eq!(keys(Lang::French, "Delete"), "Suppr");
        assert_eq!(keys(Lang::English, "Ctrl+Plus"), "Ctrl++");
        assert_eq!(keys(Lang::English, "Ctrl+Backslash"), "Ctrl+\\");
    }
}
