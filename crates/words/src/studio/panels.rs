//! Words of the outliner, the properties, and the tabs at the bottom.

use crate::Lang;

phrases! {
    /// A section of the outliner.
    world() { "World", "Monde" }
    /// A section of the outliner.
    lamps() { "Lamps", "Sources" }
    /// A section of the outliner.
    objects() { "Objects", "Objets" }
    /// A section of the outliner.
    materials() { "Materials", "Matières" }
    /// A section of the outliner.
    views() { "Views", "Vues" }
    /// The field that filters the outliner.
    filter() { "Filter by name", "Filtrer par nom" }
    /// Empties the filter.
    clear_filter() { "Clear the filter", "Effacer le filtre" }
    /// Nothing matches the filter.
    nothing_matches(filter) { "Nothing is named like “{filter}”.", "Rien ne porte un nom comme « {filter} »." }
    /// Adds to a section.
    add_to(section) { "Add to {section}", "Ajouter à {section}" }
    /// Adds a lamp.
    add_lamp() { "Add a lamp", "Ajouter une source" }
    /// Adds an object.
    add_object() { "Add an object", "Ajouter un objet" }
    /// Adds a material.
    add_material() { "Add a material", "Ajouter une matière" }
    /// Adds a view.
    add_view() { "Add a view", "Ajouter une vue" }
    /// Adds one kind.
    sphere() { "Sphere", "Sphère" }
    /// Adds one kind.
    plane() { "Plane", "Plan" }
    /// Adds one kind.
    cube() { "Cube", "Cube" }
    /// Adds one kind.
    parallelepiped() { "Box", "Parallélépipède" }
    /// Adds one kind.
    cone() { "Cone", "Cône" }
    /// Adds one kind.
    facet() { "Facet", "Facette" }
    /// Adds one kind.
    mesh() { "Mesh from a file…", "Maillage depuis un fichier…" }
    /// Adds one kind.
    plain_material() { "Plain grey", "Gris uni" }
    /// A menu entry.
    rename() { "Rename", "Renommer" }
    /// A menu entry.
    duplicate() { "Duplicate", "Dupliquer" }
    /// A menu entry.
    delete() { "Delete", "Supprimer" }
    /// A menu entry.
    move_up() { "Move up", "Monter" }
    /// A menu entry.
    move_down() { "Move down", "Descendre" }
    /// A menu entry.
    show_view() { "Show in a pane", "Afficher dans un volet" }
    /// A switch of a row.
    hide(name) { "Hide {name} from the picture", "Retirer {name} de l'image" }
    /// A switch of a row.
    show(name) { "Show {name} in the picture", "Remettre {name} dans l'image" }
    /// The field for a new name.
    new_name(name) { "New name of {name}", "Nouveau nom de {name}" }

    /// Nothing is selected.
    nothing_selected() {
        "Select something in the scene or click it in a view.",
        "Sélectionnez un élément de la scène ou cliquez dessus dans une vue.",
    }
    /// Several things are selected.
    several(count, name) { "{count} selected; shown: {name}", "{count} sélectionnés ; affiché : {name}" }
    /// The name of a thing.
    name() { "name", "nom" }
    /// The title of the scene.
    title() { "title", "titre" }
    /// Puts an attribute back.
    reset(attribute) { "Set {attribute} to its default", "Remettre {attribute} à sa valeur par défaut" }
    /// The link of channels.
    linked(attribute) { "{attribute}: one number for all channels", "{attribute} : un seul nombre pour tous les canaux" }
    /// What an attribute means, after its letter in the subject or its word in the documents.
    meaning(term, sentence) { "{term}: {sentence}", "{term} : {sentence}" }
    /// A material that several objects have.
    shared(count) { "shared by {count} objects", "partagée par {count} objets" }
    /// A range.
    range(least, greatest) { "from {least} to {greatest}", "de {least} à {greatest}" }
    /// The built-in grey.
    built_in() { "built-in grey", "gris par défaut" }
    /// A surface of its own.
    own_material() { "its own", "propre à l'objet" }
    /// A new material.
    new_material() { "New material", "Nouvelle matière" }
    /// New materials from presets.
    new_from_preset() { "New from a preset", "Nouvelle d'après un modèle" }
    /// Overwrites a material.
    apply_preset() { "Preset", "Modèle" }
    /// Says what a preset does.
    apply_preset_hint() {
        "Gives this material the values of a well-known one",
        "Donne à cette matière les valeurs d'une matière connue",
    }
    /// A heading.
    eye() { "Eye", "Point de vue" }
    /// A heading.
    screen() { "Screen", "Écran" }
    /// A heading.
    picture() { "Picture", "Image" }
    /// A heading.
    geometry() { "Geometry", "Géométrie" }
    /// A heading.
    material() { "Material", "Matière" }
    /// How a screen is given.
    screen_by() { "given by", "donné par" }
    /// By a look-at point.
    by_look_at() { "a point that is looked at", "un point visé" }
    /// By its centre.
    by_center() { "its centre and size", "son centre et sa taille" }
    /// By corner and edges.
    by_frame() { "a corner and two edges", "un coin et deux arêtes" }
    /// By four corners.
    by_corners() { "four corners", "quatre coins" }
    /// The world's depth instead of an own one.
    world_depth() { "the world's", "celle du monde" }
    /// What a mesh is made of.
    mesh_summary(vertices, facets) { "{vertices}, {facets}", "{vertices}, {facets}" }
    /// Where a mesh comes from.
    mesh_source(path) { "from {path}", "lu dans {path}" }
    /// One part of a mesh.
    mesh_part(number, facets) { "part {number}: {facets}", "partie {number} : {facets}" }

    /// A button.
    copy() { "Copy", "Copier" }
    /// A button.
    save_text() { "Save as a file…", "Enregistrer dans un fichier…" }
    /// Which document is shown.
    document_of_scene() { "Scene", "Scène" }
    /// Which document is shown.
    document_of_views() { "Views", "Vues" }
    /// The scene is being looked through.
    looking() { "Looking through the scene…", "Examen de la scène…" }
    /// The text is being made.
    preparing() { "Preparing the text…", "Préparation du texte…" }
    /// A line that is not shown whole.
    folded(characters) { "… ({characters} more characters)", "… ({characters} caractères de plus)" }
    /// Nothing is wrong.
    no_problems() { "No problems found.", "Aucun problème trouvé." }
    /// A heading.
    in_scene() { "In this scene", "Dans cette scène" }
    /// Selects what a finding is about.
    select(name) { "Select {name}", "Sélectionner {name}" }
}

/// The name of one channel of an attribute: `ka red`.
pub fn channel(lang: Lang, attribute: &str, channel: usize) -> String {
    let names = match lang {
        Lang::English => ["red", "green", "blue"],
        Lang::French => ["rouge", "vert", "bleu"],
    };
    format!("{attribute} {}", names.get(channel).copied().unwrap_or_default())
}

/// The formula of the subject in which an attribute stands; empty where there is none.
pub fn formula(element: &str, attribute: &str) -> &'static str {
    match (element, attribute) {
        ("world", "ambient") | ("material", "ka") => "Ea = Ka·Ia",
        ("material", "kd") => "Ed = Kd·cos l·I_L",
        ("material", "ks" | "n" | "highlight") | ("light", "color") => "Es = W(l)·cosⁿ s·I_L",
        ("material", "w") => "W(l) = Ks   |   Ks + (1-Ks)(1-cos l)⁵   |   Ks·(1-cos l)",
        ("material", "kr") => "Er = Kr·Ir,   R = I - 2(I·N)N",
        ("material", "kt") => "Et = Kt·It",
        ("material" | "world", "index") => "n·sin i = n'·sin r",
        ("world", "compose") => "a ⊕ b = 1 - (1-a)(1-b)",
        ("sphere", "center" | "radius") => "Δ = R² + (d·SC)² - |SC|²",
        ("plane" | "facet", "p0" | "p1" | "p2") => "α·P0P1 + β·P0P2 - γ·d = P0S",
        _ => "",
    }
}
