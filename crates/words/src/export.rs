//! What is said of scenes that are written for other programs.

phrases! {
    /// The other program sums.
    compose(word) {
        "the composition `{word}` becomes a plain sum, which is not cut off at 1 on the way: bright places differ",
        "la composition « {word} » devient une simple somme, sans écrêtage à 1 en chemin : les endroits clairs diffèrent",
    }
    /// Formats of bodies alone.
    lights() {
        "lamps, ambient light and background are left out: the format holds objects alone",
        "les sources, la lumière ambiante et le fond sont omis : le format ne contient que des objets",
    }
    hidden(those) { "left out because hidden: {those}", "masqué, donc omis : {those}" }
    law(those) { "the reflectance becomes constant: {those}", "la réflectance devient constante : {those}" }
    highlight(those) { "the highlight becomes Phong's: {those}", "le reflet devient celui de Phong : {those}" }
    highlight_colour(those) {
        "the strength of the highlight becomes the mean of its channels: {those}",
        "l'intensité du reflet devient la moyenne de ses composantes : {those}",
    }
    shininess(those) {
        "the shininess becomes the mean of its channels: {those}",
        "la brillance devient la moyenne de ses composantes : {those}",
    }
    filter(those) {
        "the transparency becomes the mean of its channels: {those}",
        "la transparence devient la moyenne de ses composantes : {those}",
    }
    dispersion(those) {
        "the refraction index becomes the mean of its channels, and light is no longer dispersed: {those}",
        "l'indice de réfraction devient la moyenne de ses composantes, sans dispersion : {those}",
    }
    shadows(those) {
        "light passes through to what is in the shadow of transparent objects: {those}",
        "la lumière traverse jusqu'à ce qui est dans l'ombre des objets transparents : {those}",
    }
    part_indices(those) {
        "the refraction index of a mesh's first transparent part counts for all of it: {those}",
        "l'indice de réfraction de la première partie transparente vaut pour tout le maillage : {those}",
    }
    samples(those) {
        "the samples of each pixel are left out, the other program has options for them: {those}",
        "les échantillons par pixel sont omis, l'autre programme a des options pour cela : {those}",
    }
    plane(those) { "planes are left out, for they have no end: {those}", "les plans, sans fin, sont omis : {those}" }
    roundness(those) {
        "round shapes become facets, sixty-four around: {those}",
        "les formes rondes deviennent des facettes, soixante-quatre par tour : {those}",
    }
    coefficients(those) {
        "coefficients are brought to the nearest material that the format can describe: {those}",
        "les coefficients sont ramenés à la matière la plus proche que le format sait décrire : {those}",
    }

    /// A POV-Ray scene needs a camera.
    needs_views(path) {
        "`{path}` needs a camera, but no view is given",
        "« {path} » demande une caméra, mais aucune vue n'est donnée",
    }
    /// What to do.
    needs_views_help(path) {
        "name the document of the views: --views FILE; without it, `{path}` beside the scene is taken if it is there",
        "nommez le document des vues : --views FICHIER ; sans lui, « {path} » à côté de la scène est pris s'il existe",
    }
    /// Views alone have no such form.
    needs_scene(path) {
        "`{path}` holds objects, but the input is a document of views",
        "« {path} » contient des objets, mais l'entrée est un document de vues",
    }
    /// What to do.
    needs_scene_help() {
        "give the scene as IN, and the views with --views FILE",
        "donnez la scène comme ENTRÉE, et les vues avec --views FICHIER",
    }
    /// A material library goes beside its file, and standard output has no beside.
    no_stdout() {
        "a .obj file has a .mtl file beside it, so it cannot go to standard output",
        "un fichier .obj a un fichier .mtl à côté de lui : il ne peut pas aller sur la sortie standard",
    }
}
