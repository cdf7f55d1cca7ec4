//! How the editor labels the attributes of the documents: in English as the documents spell them, or by the subject's
//! letter; in French in the subject's words.

use crate::Lang;

/// The label of an attribute. `element` tells apart what two elements call alike; it may be empty.
pub fn label<'a>(lang: Lang, element: &str, attribute: &'a str) -> &'a str {
    let (english, french) = match (element, attribute) {
        ("material", "w") => ("W(l)", "W(l)"),
        (_, "ka") => ("Ka", "Ka"),
        (_, "kd") => ("Kd", "Kd"),
        (_, "ks") => ("Ks", "Ks"),
        (_, "kr") => ("Kr", "Kr"),
        (_, "kt") => ("Kt", "Kt"),
        (_, "n") => ("shininess", "brillance"),
        (_, "index") => ("index", "indice"),
        (_, "highlight") => ("highlight", "reflet"),
        (_, "ambient") => ("ambient", "ambiante"),
        (_, "background") => ("background", "infini"),
        (_, "depth") => ("depth", "profondeur"),
        (_, "compose") => ("compose", "composition"),
        (_, "color") => ("color", "couleur"),
        (_, "center") => ("center", "centre"),
        (_, "radius") => ("radius", "rayon"),
        (_, "edge") => ("edge", "arête"),
        (_, "top") => ("top", "sommet"),
        (_, "base-radius") => ("base-radius", "R base"),
        (_, "top-radius") => ("top-radius", "R sommet"),
        (_, "capped") => ("capped", "fermé"),
        (_, "origin") => ("origin", "origine"),
        (_, "scale") => ("scale", "échelle"),
        (_, "smooth") => ("smooth", "lissé"),
        (_, "material") => ("material", "matière"),
        (_, "width") => ("width", "largeur"),
        (_, "height") => ("height", "hauteur"),
        (_, "samples") => ("samples", "échantillons"),
        // the switches say which steps are carried out
        (_, "without") => ("steps", "étapes"),
        (_, "at") => ("at", "position"),
        (_, "look-at") => ("look-at", "point visé"),
        (_, "up") => ("up", "haut"),
        (_, "fov") => ("fov", "angle"),
        (_, "size") => ("size", "taille"),
        (_, "screen") => ("screen", "écran"),
        (_, "corners") => ("corners", "coins"),
        (_, "part") => ("part", "partie"),
        (_, "src") => ("src", "fichier"),
        (_, same) => (same, same),
    };
    match lang {
        Lang::English => english,
        Lang::French => french,
    }
}

/// One of the words that an attribute can hold.
pub fn choice(lang: Lang, word: &str) -> &str {
    match (lang, word) {
        (Lang::French, "constant") => "constante",
        (Lang::French, "grazing") => "rasante",
        (_, "schlick") => "Schlick",
        (_, "phong") => "Phong",
        (_, "blinn") => "Blinn",
        (Lang::English | Lang::French, same) => same,
    }
}
