//! The terms of the subject, as labels and headings use them.

phrases! {
    scene() { "scene", "scène" }
    world() { "World", "Monde" }
    lamps() { "Lamps", "Sources" }
    materials() { "Materials", "Matières" }
    objects() { "Objects", "Objets" }
    views() { "Views", "Vues" }
    ambient_light() { "ambient light", "lumière ambiante" }
    colour_of_infinity() { "colour of infinity", "couleur de l'infini" }
    refraction_index() { "refraction index", "indice de réfraction" }
    depth_limit() { "depth limit", "profondeur limite" }
    composition() { "composition", "composition" }
    name() { "name", "nom" }
    shape() { "shape", "forme" }
    material() { "material", "matière" }
    geometry() { "geometry", "géométrie" }
    position() { "position", "position" }
    index() { "index", "indice" }
    law() { "law of W", "loi de W" }
    highlight() { "highlight", "reflet" }
    sphere() { "sphere", "sphère" }
    plane() { "plane", "plan" }
    facet() { "facet", "facette" }
    cube() { "cube", "cube" }
    /// A parallelepiped, the `box` of the documents.
    parallelepiped() { "box", "boîte" }
    cone() { "cone", "cône" }
    mesh() { "mesh", "maillage" }
    centre() { "centre", "centre" }
    edge() { "edge", "arête" }
    /// The first circle of a cone.
    base() { "base", "base" }
    /// The second circle of a cone.
    top() { "top", "sommet" }
    rotation() { "rotation", "rotation" }
    scale() { "scale", "échelle" }
    corner() { "corner", "coin" }
    size() { "size", "taille" }
    eye() { "eye", "œil" }
    screen() { "screen", "écran" }
    shadows() { "shadows", "ombres" }
    reflection() { "reflection", "réflexion" }
    transparency() { "transparency", "transparence" }
}

/// The letters of the channels red, green, blue: the subject writes RVB.
pub fn channels(lang: crate::Lang) -> [&'static str; 3] {
    match lang {
        crate::Lang::English => ["R", "G", "B"],
        crate::Lang::French => ["R", "V", "B"],
    }
}
