//! What the reader of the Neutral File Format says.

phrases! {
    coordinate() { "a coordinate", "une coordonnée" }
    channel() { "a colour's channel", "une composante de couleur" }
    radius() { "a radius", "un rayon" }
    diffuse() { "the fill's Kd", "le Kd de la matière" }
    specular() { "the fill's Ks", "le Ks de la matière" }
    shine() { "the fill's exponent of the highlight", "l'exposant du reflet de la matière" }
    transmittance() { "the fill's T", "le T de la matière" }
    index() { "the fill's index of refraction", "l'indice de réfraction de la matière" }
    angle() { "the view's angle", "l'angle de la vue" }
    hither() { "the distance of the hither plane", "la distance du plan proche" }
    pixels() { "the number of pixels in a row or a column", "le nombre de pixels d'une ligne ou d'une colonne" }
    corners() { "the number of corners", "le nombre de coins" }
    unknown_entity(word) { "`{word}` begins no entity", "« {word} » n'introduit aucune entité" }
    entities_help() {
        "entities are `v` view, `b` background, `l` light, `f` fill, `s` sphere, `c` cone, `p` polygon, `pp` patch",
        "les entités sont « v » vue, « b » fond, « l » source, « f » matière, « s » sphère, « c » cône, « p » polygone, « pp » carreau",
    }
    unknown_of_view(word) { "`{word}` is no part of a view", "« {word} » n'est pas une partie de la vue" }
    view_lacks(word) { "the view lacks its `{word}`", "il manque « {word} » à la vue" }
    view_help() {
        "a view is `v`, then `from x y z`, `at x y z`, `up x y z`, `angle degrees`, `hither distance`, `resolution width height`",
        "une vue est « v », puis « from x y z », « at x y z », « up x y z », « angle degrés », « hither distance », « resolution largeur hauteur »",
    }
    not_a_number(found, due) {
        "`{found}` stands where {due} is due, which is a number",
        "« {found} » se trouve là où l'on attend {due}, un nombre",
    }
    number_help() {
        "numbers are written like -12, 0.5 or 1e-3; `#` begins a comment",
        "les nombres s'écrivent comme -12, 0.5 ou 1e-3 ; « # » commence un commentaire",
    }
    ended(due) { "the file ends where {due} is due", "le fichier se termine là où l'on attend {due}" }
    ended_help() { "perhaps the file is cut: copy it again", "le fichier est peut-être tronqué : recopiez-le" }
    out_of_range(what, found) { "{what} is {found}", "{what} vaut {found}" }
    least_help(what, least) { "{what} is at least {least}", "{what} vaut au moins {least}" }
    range_help(what, least, greatest) { "{what} lies between {least} and {greatest}", "{what} va de {least} à {greatest}" }
    clamped(what, found, taken) { "{what} is {found}; {taken} is taken for it", "{what} vaut {found} ; {taken} est pris à sa place" }
    clamped_help() {
        "colours and coefficients lie between 0 and 1, an exponent between 0 and 10000",
        "couleurs et coefficients vont de 0 à 1, un exposant de 0 à 10000",
    }
    count(what, found) { "{what} is `{found}`", "{what} vaut « {found} »" }
    count_help(what, least, greatest) {
        "{what} is a whole number from {least} to {greatest}",
        "{what} est un entier de {least} à {greatest}",
    }
    inside_only() {
        "a negative radius: only the inside would be seen, but here both sides are",
        "un rayon négatif : seul l'intérieur serait vu, mais ici les deux côtés le sont",
    }
    inside_only_help() {
        "the sign is dropped; every surface has two sides here",
        "le signe est abandonné ; ici, toute surface a deux côtés",
    }
    second_view() { "a second view is left out", "une seconde vue est omise" }
    second_view_help() { "a file has one view: the first counts", "un fichier a une vue : la première compte" }
    no_view() { "the file has no view", "le fichier n'a pas de vue" }
    no_view_help() {
        "add an entity `v`, or give a document of views as the second argument",
        "ajoutez une entité « v », ou donnez un document de vues en second argument",
    }
    too_much_memory(most) {
        "the objects would take more than {most} MiB, more than a file of this size may",
        "les objets prendraient plus de {most} Mio, plus que n'en permet un fichier de cette taille",
    }
    too_much_memory_help() {
        "a file may take ten times its own size and 64 MiB",
        "un fichier peut prendre dix fois sa taille et 64 Mio",
    }
    more() { "there are more errors", "il y a d'autres erreurs" }
}
