//! Counted things: the plural rule of each language in one place.

use crate::Lang;

/// `count` with the noun in the right number: English takes the singular for 1 alone, French for 0 and 1.
pub fn counted(lang: Lang, count: usize, english: [&str; 2], french: [&str; 2]) -> String {
    let noun = match lang {
        Lang::English => english[usize::from(count != 1)],
        Lang::French => french[usize::from(count > 1)],
    };
    format!("{count} {noun}")
}

macro_rules! counts {
    ($($name:ident: $en1:literal $en2:literal, $fr1:literal $fr2:literal;)*) => {$(
        #[doc = concat!("`count ", $en2, "`.")]
        pub fn $name(lang: Lang, count: usize) -> String {
            counted(lang, count, [$en1, $en2], [$fr1, $fr2])
        }
    )*};
}

counts! {
    objects: "object" "objects", "objet" "objets";
    lights: "lamp" "lamps", "source" "sources";
    materials: "material" "materials", "matière" "matières";
    views: "view" "views", "vue" "vues";
    vertices: "vertex" "vertices", "sommet" "sommets";
    normals: "normal" "normals", "normale" "normales";
    facets: "facet" "facets", "facette" "facettes";
    points: "point" "points", "point" "points";
    parts: "part" "parts", "partie" "parties";
    errors: "error" "errors", "erreur" "erreurs";
    warnings: "warning" "warnings", "avertissement" "avertissements";
    numbers: "number" "numbers", "nombre" "nombres";
    files: "file" "files", "fichier" "fichiers";
    threads: "thread" "threads", "fil d'exécution" "fils d'exécution";
    rays: "ray" "rays", "rayon" "rayons";
    more_rays: "more ray" "more rays", "autre rayon" "autres rayons";
    pixels: "pixel" "pixels", "pixel" "pixels";
}
