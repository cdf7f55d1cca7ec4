//! The names of the steps in the editor's history.

phrases! {
    /// The document as it was opened.
    opened() { "Open", "Ouverture" }
    /// A new document.
    new() { "New scene", "Nouvelle scène" }
    /// Something was added.
    added(name) { "Add {name}", "Ajout de {name}" }
    /// Something was taken out.
    deleted(name) { "Delete {name}", "Suppression de {name}" }
    /// Several things were taken out.
    deleted_many(count) { "Delete {count} items", "Suppression de {count} éléments" }
    /// Something was copied.
    duplicated(name) { "Duplicate {name}", "Copie de {name}" }
    /// Something got a new name.
    renamed(from, to) { "Rename {from} to {to}", "Renommage de {from} en {to}" }
    /// Something stands elsewhere in its list.
    reordered(name) { "Reorder {name}", "Déplacement de {name} dans la liste" }
    /// Something takes part in the picture again.
    shown(name) { "Show {name}", "Affichage de {name}" }
    /// Something takes no part in the picture any more.
    hidden(name) { "Hide {name}", "Masquage de {name}" }
    /// Several things were copied.
    duplicated_many(count) { "Duplicate {count} items", "Copie de {count} éléments" }
    /// Several things take part in the picture again.
    shown_many(count) { "Show {count} items", "Affichage de {count} éléments" }
    /// Several things take no part in the picture any more.
    hidden_many(count) { "Hide {count} items", "Masquage de {count} éléments" }
    /// Several things were moved in space.
    moved_many(count) { "Move {count} items", "Déplacement de {count} éléments" }
    /// The scene's file was read again.
    reloaded() { "Reload", "Relecture du fichier" }
    /// Views were read from a file.
    views_loaded() { "Load views", "Chargement de vues" }
    /// What a journal kept after a crash.
    recovered() { "Recover", "Récupération" }
    /// Something was moved in space.
    moved(name) { "Move {name}", "Déplacement de {name}" }
    /// An attribute was set.
    set(item, attribute) { "{item}: set {attribute}", "{item} : modification de {attribute}" }
    /// An attribute of the world was set.
    set_world(attribute) { "World: set {attribute}", "Monde : modification de {attribute}" }
    /// A view looks from elsewhere.
    navigated(name) { "Move the eye of {name}", "Déplacement du point de vue de {name}" }
    /// The title of the scene was set.
    titled() { "Set the title", "Modification du titre" }
}
