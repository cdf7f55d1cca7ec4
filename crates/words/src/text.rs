//! The text display of a whole scene (the subject's §5.1).

phrases! {
    /// The title of a scene without a name.
    untitled() { "Scene without a name", "Scène sans nom" }
    counts(objects, lights, materials) { "{objects}, {lights}, {materials}", "{objects}, {lights}, {materials}" }
    /// A section without entries.
    none() { "none", "aucun" }
    none_feminine() { "none", "aucune" }
    hidden(name) { "{name} (hidden)", "{name} (masqué)" }
    hidden_lamp(name) { "{name} (hidden)", "{name} (masquée)" }
    /// The material of an object without one.
    grey() { "(grey)", "(gris)" }
    /// The material of an object with a surface of its own.
    own() { "(own)", "(propre)" }
    own_surface_of(object) { "(own: {object})", "(propre : {object})" }
    own_surface_of_part(object, part) { "(own: {object}, part {part})", "(propre : {object}, partie {part})" }
    compose_screen() { "screen: a ⊕ b = 1 - (1-a)(1-b)", "screen : a ⊕ b = 1 - (1-a)(1-b)" }
    compose_screen_each() {
        "screen-each: a ⊕ b = 1 - (1-a)(1-b), diffuse and highlight apart",
        "screen-each : a ⊕ b = 1 - (1-a)(1-b), diffus et spéculaire séparés",
    }
    compose_add() { "add: a + b, at most 1", "add : a + b, au plus 1" }
    closed() { "closed", "fermé" }
    closed_inwards() { "closed, facing inwards", "fermé, tourné vers l'intérieur" }
    /// A cone whose ends discs close.
    capped() { "capped", "fermé" }
    /// A cone whose ends are open.
    open() { "open", "ouvert" }
    sheet() { "not closed", "non fermé" }
    smooth() { "smooth normals", "normales lissées" }
    file_normals() { "smooth normals of the file", "normales lissées du fichier" }
    from_file(path) { "from {path}", "de {path}" }
    bounds(x0, x1, y0, y1, z0, z1) {
        "x {x0} to {x1}   y {y0} to {y1}   z {z0} to {z1}",
        "x de {x0} à {x1}   y de {y0} à {y1}   z de {z0} à {z1}",
    }
    part(first, last, material) { "facets {first} to {last}: {material}", "facettes {first} à {last} : {material}" }
    part_of_one(first, material) { "facet {first}: {material}", "facette {first} : {material}" }
    vertices() { "vertices", "sommets" }
    facets() { "facets", "facettes" }
    pixels(width, height) { "{width} × {height} pixels", "{width} × {height} pixels" }
    /// The heading of how a view is computed, where that is unusual.
    computed() { "computed", "calcul" }
    samples(count) { "{count} × {count} samples a pixel", "{count} × {count} échantillons par pixel" }
    view_depth(depth) { "depth limit {depth}", "profondeur limite {depth}" }
    without(steps) { "without {steps}", "sans {steps}" }
    top_left() { "top left", "haut gauche" }
    to_the_right() { "to the right", "vers la droite" }
    downwards() { "downwards", "vers le bas" }
    perpendicular() { "perpendicular, centre", "perpendiculaire, centre" }
    extent(width, height) { "{width} by {height}", "{width} sur {height}" }
    up() { "up", "haut" }
    corners() { "corners", "coins" }
    looks_at() { "looks at", "regarde" }
    field_of_view(degrees) { "{degrees}° wide", "{degrees}° de large" }
}
