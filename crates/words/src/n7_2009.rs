//! What is said of the documents of 2009 (SPEC §4).

use crate::xml::reports;

reports! {
    /// An element that the format does not have there.
    unknown_element(name, parent, guess, legal) {
        "`<{parent}>` holds no `<{name}>`: it is ignored", "{guess}", "`<{parent}>` holds {legal}";
        "« <{parent}> » ne contient pas de « <{name}> » : il est ignoré", "{guess}", "« <{parent}> » contient {legal}";
    }
    /// An element within one that holds none.
    no_elements(name, parent) {
        "`<{parent}>` holds no elements: `<{name}>` is ignored", "here", "everything of `<{parent}>` is in its attributes";
        "« <{parent}> » ne contient aucun élément : « <{name}> » est ignoré", "ici",
        "tout ce que dit « <{parent}> » est dans ses attributs";
    }
    /// An attribute that the element does not have.
    unknown_attribute(name, element, guess, legal) {
        "`<{element}>` has no attribute `{name}`: it is ignored", "{guess}", "`<{element}>` has {legal}";
        "« <{element}> » n'a pas d'attribut « {name} » : il est ignoré", "{guess}", "« <{element}> » a {legal}";
    }
    /// An attribute of an element that has none.
    no_attributes(name, element) {
        "`<{element}>` has no attributes: `{name}` is ignored", "here", "take it out";
        "« <{element}> » n'a aucun attribut : « {name} » est ignoré", "ici", "ôtez-le";
    }
    /// Text within an element.
    stray_text(parent) {
        "this text within `<{parent}>` is ignored", "here",
        "the format keeps everything in attributes: put remarks into `<!-- -->`";
        "ce texte dans « <{parent}> » est ignoré", "ici",
        "le format garde tout dans les attributs : mettez les remarques dans « <!-- --> »";
    }
    /// An element is missing.
    missing_element(parent, due, sample) {
        "{due} is missing in `<{parent}>`", "in this one", "for example `{sample}`";
        "il manque {due} dans « <{parent}> »", "dans celui-ci", "par exemple « {sample} »";
    }
    /// An attribute is missing.
    missing_attribute(name, element) {
        "`<{element}>` needs the attribute `{name}`", "it is missing here", "add `{name}=\"…\"`";
        "« <{element}> » demande l'attribut « {name} »", "il manque ici", "ajoutez « {name}=\"…\" »";
    }
    /// An element that may stand once stands again.
    second_element(name, parent, line) {
        "a second `<{name}>` within `<{parent}>`", "the first stands on line {line}", "keep one of them";
        "un second « <{name}> » dans « <{parent}> »", "le premier est à la ligne {line}", "n'en gardez qu'un";
    }
    /// A second shape in one object.
    second_shape(name, first, line) {
        "an object has one shape, but here `<{name}>` follows `<{first}>`", "the first stands on line {line}",
        "give each shape an `<ObjetGraphique>` of its own";
        "un objet a une seule forme, mais « <{name}> » suit ici « <{first}> »", "la première est à la ligne {line}",
        "donnez à chaque forme son propre « <ObjetGraphique> »";
    }
    /// Not as many points as are due.
    point_count(parent, found, due, meaning) {
        "`<{parent}>` holds {found} instead of {due}", "{meaning}", "one `<Point x=\"…\" y=\"…\" z=\"…\"/>` for each";
        "« <{parent}> » contient {found} au lieu de {due}", "{meaning}",
        "un « <Point x=\"…\" y=\"…\" z=\"…\"/> » pour chacun";
    }
    /// A colour of the scene before the last one.
    earlier_colour(line) {
        "only the last `Couleur` of the scene counts", "that of line {line} is taken instead",
        "it is the ambient light and the background";
        "seule la dernière « Couleur » de la scène compte", "celle de la ligne {line} est prise à sa place",
        "c'est la lumière ambiante et le fond";
    }
    /// A number outside its range.
    clamped(name, found, taken, min, max) {
        "`{name}` is {found}, outside {min} to {max}", "{taken} is taken instead", "`{name}` lies between {min} and {max}";
        "« {name} » vaut {found}, hors de l'intervalle de {min} à {max}", "{taken} est pris à sa place",
        "« {name} » va de {min} à {max}";
    }
    /// An index that is not above 0.
    bad_index(found) {
        "the refraction index `n` is {found}, but must be greater than 0", "more than 0",
        "it counts 64ths: 64 is 1 (air), 85.12 is 1.33 (water), 96 is 1.5 (glass)";
        "l'indice de réfraction « n » vaut {found}, mais doit être strictement positif", "plus grand que 0",
        "il compte des 64ᵉˢ : 64 vaut 1 (air), 85.12 vaut 1.33 (eau), 96 vaut 1.5 (verre)";
    }
    /// The bottom right corner is not where the others put it.
    crooked_corner() {
        "the screen's corners are no parallelogram: the second one is not used", "the second point is the bottom right",
        "they stand in the order bottom left, bottom right, top right, top left";
        "les coins de l'écran ne forment pas un parallélogramme : le deuxième ne sert pas",
        "le deuxième point est en bas à droite",
        "dans l'ordre : bas gauche, bas droite, haut droite, haut gauche";
    }
    /// The corners lie apart by something else than the extent.
    extent(name, extent, apart) {
        "`{name}` makes the screen {extent} long, but its corners are {apart} apart", "this extent counts",
        "`largeur` and `hauteur` are both the pixels and the screen's extent in scene units";
        "« {name} » donne à l'écran une longueur de {extent}, mais ses coins sont distants de {apart}",
        "c'est cette longueur qui compte",
        "« largeur » et « hauteur » sont à la fois les pixels et l'étendue de l'écran en unités de la scène";
    }
    /// Views that are none.
    no_views() {
        "there is no view here", "this document is empty", "add a `<Vue largeur=\"640\" hauteur=\"480\">`";
        "il n'y a pas de vue ici", "ce document est vide", "ajoutez une « <Vue largeur=\"640\" hauteur=\"480\"> »";
    }
    /// A document of another kind.
    wrong_root(found, due) {
        "this is a `<{found}>`, but a `<{due}>` is due", "here", "scenes of 2009 begin with `<Scene>`, views with `<Rendu>`";
        "ceci est un « <{found}> », mais il faut un « <{due}> »", "ici",
        "les scènes de 2009 commencent par « <Scene> », les vues par « <Rendu> »";
    }
}

phrases! {
    points_of_sphere() { "its centre", "son centre" }
    points_of_plane() { "three points of it", "trois de ses points" }
    points_of_box() { "one corner and the ends of its three edges", "un coin et les bouts de ses trois arêtes" }
    points_of_facet() { "its corners", "ses sommets" }
    points_of_lamp() { "its position", "sa position" }
    points_of_eye() { "the eye", "l'œil" }
    points_of_screen() {
        "its corners: bottom left, bottom right, top right, top left",
        "ses coins : bas gauche, bas droite, haut droite, haut gauche",
    }

    that(name) { "`{name}`", "« {name} »" }
    that_and_another(name) { "`{name}` and 1 other", "« {name} » et 1 autre" }
    those(name, others) { "`{name}` and {others} others", "« {name} » et {others} autres" }

    loss_title(title) { "the scene's title `{title}` is left out", "le titre de la scène « {title} » est omis" }
    loss_background() {
        "the background becomes the ambient light: the format has one colour for both",
        "le fond prend la couleur de la lumière ambiante : le format n'en a qu'une pour les deux",
    }
    loss_world_index() {
        "the refraction index around the objects becomes 1",
        "l'indice de réfraction du milieu ambiant devient 1",
    }
    loss_depth(depth) { "the depth limit {depth} becomes 6", "la profondeur limite {depth} devient 6" }
    loss_compose(word) { "the composition `{word}` becomes `screen`", "la composition « {word} » devient « screen »" }
    loss_hidden(those) { "left out because hidden: {those}", "masqué, donc omis : {those}" }
    loss_name(those) { "names left out: {those}", "noms omis : {those}" }
    loss_unused(those) { "materials left out because no object has them: {those}", "matières omises, faute d'objet : {those}" }
    loss_law(those) { "the reflectance becomes constant: {those}", "la réflectance devient constante : {those}" }
    loss_highlight(those) { "the highlight becomes Phong's: {those}", "le reflet devient celui de Phong : {those}" }
    loss_shininess(those) {
        "the shininess becomes the mean of its channels: {those}",
        "la brillance devient la moyenne de ses composantes : {those}",
    }
    loss_dispersion(those) {
        "the refraction index becomes the mean of its channels, and light is no longer dispersed: {those}",
        "l'indice de réfraction devient la moyenne de ses composantes, sans dispersion : {those}",
    }
    loss_cube(those) {
        "cubes become a corner and three edges, without centre and rotation: {those}",
        "les cubes deviennent un coin et trois arêtes, sans centre ni rotation : {those}",
    }
    loss_cone(those) {
        "cones become facets, sixty-four around: {those}",
        "les cônes deviennent des facettes, soixante-quatre par tour : {those}",
    }
    loss_placement(those) {
        "facets are written where they stand, without position, rotation and scale: {those}",
        "les facettes sont écrites à leur place, sans position, rotation ni échelle : {those}",
    }
    loss_file(those) { "the facets of mesh files are written out: {those}", "les facettes des fichiers sont écrites une à une : {those}" }
    loss_smooth(those) { "smooth normals left out: {those}", "normales lissées omises : {those}" }
    loss_parts(those) {
        "meshes of several materials become an object for each, none of them closed: {those}",
        "les maillages de plusieurs matières deviennent un objet par matière, dont aucun n'est fermé : {those}",
    }
    loss_screen(those) {
        "screens become four corners, one unit for each pixel; the picture is the same: {those}",
        "les écrans deviennent quatre coins, une unité par pixel ; l'image est la même : {those}",
    }
    loss_proportion(those) {
        "pixels become square, which stretches the picture: {those}",
        "les pixels deviennent carrés, ce qui déforme l'image : {those}",
    }
    loss_samples(those) { "each pixel gets one sample: {those}", "chaque pixel n'a qu'un échantillon : {those}" }
    loss_view_depth(those) { "the view's own depth limit becomes 6: {those}", "la profondeur limite propre devient 6 : {those}" }
    loss_steps(those) { "the steps left out are carried out: {those}", "les étapes omises sont faites : {those}" }
    loss_help() { "to keep everything, save as XML or `.lancer`", "pour tout garder, enregistrez en XML ou en « .lancer »" }
}
