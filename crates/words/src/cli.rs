//! What the command-line program says: its help, its failures, its tables.

pub mod bench;
pub mod generate;
pub mod help;
pub mod usage;

phrases! {
    // ---- the input is wrong ---------------------------------------------------------------------------------------

    /// A name within a sentence.
    quoted(name) { "`{name}`", "« {name} »" }
    /// A document has no view.
    no_view(path) { "`{path}` holds no view", "« {path} » ne contient aucune vue" }
    /// There is no view of that name.
    unknown_view(name, path) {
        "there is no view `{name}` in `{path}`",
        "il n'y a pas de vue « {name} » dans « {path} »",
    }
    /// The names that exist.
    known_views(names) { "its views are {names}", "ses vues sont {names}" }
    /// The names nearest to the one given.
    nearest_views(names, count) {
        "the nearest names of its {count} views are {names}",
        "les noms les plus proches parmi ses {count} vues sont {names}",
    }
    /// The region leaves the picture.
    region_outside(x, y, width, height) {
        "the region {x},{y},{width},{height} does not lie in the picture",
        "la région {x},{y},{width},{height} sort de l'image",
    }
    /// The picture's size.
    picture_size(view, width, height, right, bottom) {
        "the picture of view `{view}` has {width}×{height} pixels: columns 0 to {right}, rows 0 to {bottom}",
        "l'image de la vue « {view} » a {width}×{height} pixels : colonnes 0 à {right}, lignes 0 à {bottom}",
    }
    /// The pixel lies outside the picture.
    pixel_outside(x, y) { "pixel {x}, {y} does not lie in the picture", "le pixel {x}, {y} sort de l'image" }
    /// The view breaks a rule after options changed it.
    view_invalid(view, rule) {
        "view `{view}` cannot be rendered: {rule}",
        "la vue « {view} » ne peut pas être calculée : {rule}",
    }
    /// Two views would be written to one file.
    same_output(first, second, path) {
        "views `{first}` and `{second}` would both be written to `{path}`",
        "les vues « {first} » et « {second} » seraient toutes deux écrites dans « {path} »",
    }
    /// What to do.
    same_output_help() {
        "rename one of them, or render them one at a time with --view",
        "renommez l'une d'elles, ou calculez-les une à une avec --view",
    }
    /// Adaptive samples of a view of one sample a pixel.
    adaptive_of_one(view) {
        "view `{view}` takes one sample a pixel, so --adaptive has none to add",
        "la vue « {view} » prend un échantillon par pixel, donc --adaptive n'en a pas à ajouter",
    }
    /// What to do.
    adaptive_of_one_help() {
        "say how many with --samples, such as --samples 4",
        "dites combien avec --samples, par exemple --samples 4",
    }
    /// A pixel costs too many rays.
    budget(view, x, y, rays) {
        "pixel {x}, {y} of view `{view}` needs more than {rays}",
        "le pixel {x}, {y} de la vue « {view} » demande plus de {rays}",
    }
    /// What to do.
    budget_help() {
        "lower the depth limit (--depth), or allow more rays with --max-rays",
        "diminuez la profondeur limite (--depth), ou autorisez plus de rayons avec --max-rays",
    }
    /// A pixel's colour is no number.
    not_finite(view, x, y) {
        "pixel {x}, {y} of view `{view}` has no colour: a term is not a finite number",
        "le pixel {x}, {y} de la vue « {view} » n'a pas de couleur : un terme n'est pas un nombre fini",
    }
    /// What to do.
    not_finite_help() {
        "this is a fault of lancer; please report it with the scene and the view",
        "c'est un défaut de lancer ; merci de le signaler avec la scène et la vue",
    }

    // ---- the system -----------------------------------------------------------------------------------------------

    /// The film does not fit.
    no_memory(width, height) {
        "there is not enough memory for a picture of {width}×{height} pixels",
        "la mémoire ne suffit pas pour une image de {width}×{height} pixels",
    }
    /// What to do.
    no_memory_help() {
        "render it in parts with --region, or smaller with --size",
        "calculez-la par parties avec --region, ou plus petite avec --size",
    }
    /// Threads cannot be started.
    no_threads(reason) {
        "the threads could not be started: {reason}",
        "les fils d'exécution n'ont pas pu démarrer : {reason}",
    }
    /// What to do.
    no_threads_help() { "ask for fewer with --threads", "demandez-en moins avec --threads" }
    /// The handler of Ctrl-C cannot be set.
    no_signals(reason) {
        "the handler of interruptions could not be installed: {reason}",
        "la gestion des interruptions n'a pas pu être installée : {reason}",
    }
    // ---- what a rendering tells -----------------------------------------------------------------------------------

    /// After a picture, for somebody who looks.
    picture_done(path, width, height, seconds) {
        "{path}: {width}×{height}, {seconds} s",
        "{path} : {width}×{height}, {seconds} s",
    }
    /// Reading and checking the documents.
    stage_read() { "read", "lecture" }
    /// Compiling the scene.
    stage_compile() { "compile", "préparation" }
    /// Computing the picture.
    stage_render() { "render", "calcul" }
    /// Writing the picture.
    stage_write() { "write", "écriture" }
    /// Which picture.
    picture_of(view, path, width, height, threads, engine) {
        "view `{view}` to {path}, {width}×{height}, {threads}, engine {engine}",
        "vue « {view} » dans {path}, {width}×{height}, {threads}, moteur {engine}",
    }
    /// Pixels that got all samples.
    refined() { "refined", "affinés" }
    /// What they are.
    refined_pixels(total) {
        "of {total} pixels: they differ from a neighbour and got all samples",
        "sur {total} pixels : ils diffèrent d'un voisin et ont eu tous les échantillons",
    }
    /// All rays.
    rays_total() { "rays", "rayons" }
    /// From the eye.
    rays_primary() { "  primary", "  primaires" }
    /// Mirrored.
    rays_reflected() { "  reflected", "  réfléchis" }
    /// Refracted.
    rays_refracted() { "  refracted", "  réfractés" }
    /// To a lamp.
    rays_shadow() { "  shadow", "  d'ombre" }
    /// Primary rays that met an object.
    rays_hits(count) { "{count} met an object", "{count} ont rencontré un objet" }
    /// Rays per second.
    rays_rate(millions) { "{millions} million per second", "{millions} millions par seconde" }

    // ---- diff -----------------------------------------------------------------------------------------------------

    /// No pixel differs.
    diff_same() { "the pictures are the same", "les images sont identiques" }
    /// No pixel differs by more than the tolerance.
    diff_within(pixels, tolerance, max) {
        "{pixels}: none differs by more than {tolerance}; the greatest difference is {max} of 255",
        "{pixels} : aucun ne diffère de plus de {tolerance} ; le plus grand écart est {max} sur 255",
    }
    /// How many pixels differ.
    diff_count(differing, pixels, percent) {
        "{differing} of {pixels} differ ({percent} %)",
        "{differing} sur {pixels} diffèrent ({percent} %)",
    }
    /// By how much.
    diff_amount(max, mean) {
        "greatest difference {max} of 255, mean {mean}",
        "plus grand écart {max} sur 255, écart moyen {mean}",
    }
    /// Where.
    diff_bounds(left, right, top, bottom) {
        "in columns {left} to {right}, rows {top} to {bottom}",
        "dans les colonnes {left} à {right}, les lignes {top} à {bottom}",
    }
    /// Above the list of places.
    diff_first(count) { "the first {count}:", "les {count} premiers :" }
    /// Heads of the list.
    diff_column() { "column", "colonne" }
    /// Heads of the list.
    diff_row() { "row", "ligne" }

    // ---- check ----------------------------------------------------------------------------------------------------

    /// The last line.
    check_summary(files, errors, warnings) { "{files}: {errors}, {warnings}", "{files} : {errors}, {warnings}" }

    // ---- convert --------------------------------------------------------------------------------------------------

    /// A picture was asked for from a scene or views.
    convert_needs_rendering(path) {
        "`{path}` is a picture's name, but the input is no picture",
        "« {path} » est un nom d'image, mais l'entrée n'est pas une image",
    }
    /// What to do.
    convert_needs_rendering_help() {
        "a scene becomes a picture by rendering it: lancer SCENE VIEW OUTPUT",
        "une scène devient une image quand on la calcule : lancer SCÈNE VUE IMAGE",
    }
    /// The extension means nothing.
    convert_unknown(path) {
        "the name `{path}` does not say which format to write",
        "le nom « {path} » ne dit pas quel format écrire",
    }
    /// What to do.
    convert_unknown_help() {
        "scenes: .xml, .lancer, .pov, .obj, .gltf or .glb; views: .xml; or choose with --to",
        "scènes : .xml, .lancer, .pov, .obj, .gltf ou .glb ; vues : .xml ; ou choisissez avec --to",
    }
    /// Views have no binary form.
    convert_views_binary() {
        "views have no binary form",
        "les vues n'ont pas de forme binaire",
    }
    /// What to do.
    convert_views_binary_help() { "write them as .xml", "écrivez-les en .xml" }
}
