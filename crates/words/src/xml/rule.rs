//! The rules that make a scene or a view legal, as they are told when one is broken.

reports! {
    /// A number that is not finite.
    not_finite(field) {
        "`{field}` is not finite", "", "every number is finite";
        "« {field} » n'est pas fini", "", "tous les nombres sont finis";
    }
    /// A number below its range.
    too_small(field, value, min, max) {
        "`{field}` is {value}, less than {min}", "at least {min}", "`{field}` lies between {min} and {max}";
        "« {field} » vaut {value}, c'est moins que {min}", "au moins {min}", "« {field} » va de {min} à {max}";
    }
    /// A number above its range.
    too_great(field, value, min, max) {
        "`{field}` is {value}, more than {max}", "at most {max}", "`{field}` lies between {min} and {max}";
        "« {field} » vaut {value}, c'est plus que {max}", "au plus {max}", "« {field} » va de {min} à {max}";
    }
    /// A number that is not greater than 0.
    not_positive(field, value, min) {
        "`{field}` is {value}, but must be greater than 0", "more than 0", "`{field}` is at least {min}";
        "« {field} » vaut {value}, mais doit être strictement positif", "plus grand que 0",
        "« {field} » vaut au moins {min}";
    }
    /// A number that is greater than 0, but so little that it could not be told from 0.
    too_near_zero(field, value, min) {
        "`{field}` is {value}, too small to be told from 0", "at least {min}", "`{field}` is at least {min}";
        "« {field} » vaut {value}, trop petit pour être distingué de 0", "au moins {min}",
        "« {field} » vaut au moins {min}";
    }
    /// The points of a plane or a facet lie on one line.
    collinear() {
        "the three points lie on one line", "they span no surface",
        "move one of the three points off the line through the others";
        "les trois points sont alignés", "ils n'engendrent aucune surface",
        "écartez l'un des trois points de la droite qui passe par les deux autres";
    }
    /// The edges of a box lie in one plane.
    coplanar() {
        "the three edges of the box lie in one plane", "it would have no volume",
        "turn one of the three edges out of the plane of the others; none may be 0";
        "les trois arêtes de la boîte sont dans un même plan", "elle n'aurait pas de volume",
        "tournez l'une des trois arêtes hors du plan des deux autres ; aucune ne peut être nulle";
    }
    /// The ends of a cone are in one place.
    cone_flat() {
        "the ends of the cone are in one place", "it would have no height", "move `base` and `top` apart";
        "les deux bouts du cône sont au même endroit", "il n'aurait pas de hauteur", "écartez « base » et « top »";
    }
    /// Both radii of a cone are 0.
    cone_thin() {
        "both radii of the cone are 0", "it would be a line", "make `base-radius` or `top-radius` greater than 0";
        "les deux rayons du cône sont nuls", "ce serait un segment",
        "donnez une valeur strictement positive à « base-radius » ou à « top-radius »";
    }
    /// A factor 0.
    scale_zero() {
        "a `scale` of 0 would flatten the mesh", "a factor is 0", "1 keeps the size, 2 doubles it, -1 mirrors";
        "un « scale » de 0 aplatirait le maillage", "un facteur est nul",
        "1 garde la taille, 2 la double, -1 renverse comme un miroir";
    }
    /// A facet that names a vertex that does not exist.
    facet_vertex(facet, vertex, vertices) {
        "facet {facet} names vertex {vertex}, which does not exist", "{vertices}",
        "vertices and facets are counted from 0";
        "la facette {facet} nomme le sommet {vertex}, qui n'existe pas", "{vertices}",
        "sommets et facettes sont comptés à partir de 0";
    }
    /// Normals that are not one for each vertex.
    normal_count(normals, vertices) {
        "{normals} for {vertices}", "", "give one normal for each vertex, or none at all";
        "{normals} pour {vertices}", "", "donnez une normale par sommet, ou aucune";
    }
    /// A part that names no facets of its own.
    part_range(part, facets) {
        "part {part} does not name facets of its own", "{facets}",
        "`facets=\"first count\"`: parts follow one another, do not overlap, and are not empty; facets count from 0";
        "la partie {part} ne nomme pas de facettes qui lui soient propres", "{facets}",
        "« facets=\"première nombre\" » : les parties se suivent sans se recouvrir et ne sont pas vides ; la première facette est la 0";
    }
    /// A name with white space around it or control characters in it.
    bad_name() {
        "this name is not legal", "",
        "a name is not empty, does not begin or end with a blank, and holds no control characters";
        "ce nom est illégal", "",
        "un nom n'est pas vide, ne commence ni ne finit par un blanc, et n'a pas de caractère de contrôle";
    }
    /// A name that is taken.
    name_taken(name) {
        "the name `{name}` is taken", "", "choose another name";
        "le nom « {name} » est déjà pris", "", "choisissez un autre nom";
    }
    /// A material that does not exist.
    unknown_material(name) {
        "there is no material `{name}`", "", "name a material of the scene";
        "il n'y a pas de matière « {name} »", "", "nommez une matière de la scène";
    }
    /// The screen's edges are parallel or zero.
    screen_collinear() {
        "the screen has no surface", "its two edges are parallel, or one is 0",
        "`u` runs along the upper edge, `v` down the left one";
        "l'écran n'a pas de surface", "ses deux côtés sont parallèles, ou l'un est nul",
        "« u » suit le bord supérieur, « v » descend le bord gauche";
    }
    /// The four corners are no parallelogram.
    not_parallelogram() {
        "the four corners are no parallelogram", "",
        "they stand in the order bottom left, bottom right, top right, top left; opposite edges are equal";
        "les quatre coins ne forment pas un parallélogramme", "",
        "dans l'ordre : bas gauche, bas droite, haut droite, haut gauche ; les côtés opposés sont égaux";
    }
    /// The eye lies in the screen's plane.
    eye_in_screen() {
        "the eye lies in the plane of the screen", "it would see the screen edge-on",
        "move the eye or the screen: the eye looks through the screen";
        "l'œil est dans le plan de l'écran", "il verrait l'écran par la tranche",
        "déplacez l'œil ou l'écran : l'œil regarde à travers l'écran";
    }
    /// The eye looks at itself.
    look_at_is_eye() {
        "the eye looks at its own place", "", "look at another point than the eye's own";
        "l'œil regarde l'endroit où il est", "", "regardez un autre point que celui de l'œil";
    }
    /// `up` is zero or along the sight.
    up_along_sight() {
        "`up` is 0 or points along the line of sight", "then no direction is up",
        "choose another `up`, for example `up=\"0 0 1\"` for an eye that looks straight down";
        "« up » est nul ou dans l'axe du regard", "aucune direction n'est alors le haut",
        "choisissez un autre « up », par exemple « up=\"0 0 1\" » pour un œil qui regarde droit vers le bas";
    }
}

phrases! {
    /// How many vertices there are, and their numbers.
    vertices_to(vertices, last) { "{vertices}: 0 to {last}", "{vertices} : de 0 à {last}" }
    /// How many facets there are.
    facets_of_mesh(facets) { "the mesh has {facets}", "le maillage a {facets}" }
}
