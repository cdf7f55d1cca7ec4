//! What `lancer bench` says.

phrases! {
    // ---- help -----------------------------------------------------------------------------------------------------

    /// `lancer bench`.
    about_bench() {
        "Measure the tracer on generated scenes: building, rays of each kind, whole pictures",
        "Mesure le lancer de rayon sur des scènes engendrées : préparation, rayons de chaque sorte, images entières",
    }
    /// Its form.
    usage_bench() { "lancer bench [OPTIONS] [NAME…]", "lancer bench [OPTIONS] [NOM…]" }
    /// More about it.
    after_bench(fixed) {
        "Without a name the fixed set is measured: {fixed}.
Figures are medians. They mean something only on an idle machine, and only beside others of the same machine.",
        "Sans nom, c'est la série fixe qui est mesurée : {fixed}.
Les valeurs sont des médianes. Elles n'ont de sens que sur une machine au repos, et à côté d'autres de la même machine.",
    }
    /// NAME…
    names_help(names) {
        "Scenes to measure: NAME with the sizes of the fixed set, or NAME:SIZE; the names are {names}",
        "Les scènes à mesurer : NOM avec les tailles de la série fixe, ou NOM:TAILLE ; les noms sont {names}",
    }
    /// --size
    size_help(width, height) {
        "Width and height of the pictures in pixels (default {width}x{height})",
        "Largeur et hauteur des images en pixels ({width}x{height} par défaut)",
    }
    /// --repeat
    repeat_help(default) {
        "How often each thing is measured; the median counts (default {default})",
        "Nombre de fois que chaque chose est mesurée ; la médiane compte ({default} par défaut)",
    }
    /// --json
    json_help() { "Print the figures as JSON, in seconds", "Affiche les valeurs en JSON, en secondes" }
    /// --export
    export_help() {
        "Measure nothing; write scenes and rays into this folder, for other programs (see docs/performance.md)",
        "Ne mesure rien ; écrit les scènes et les rayons dans ce dossier, pour d'autres programmes (voir \
docs/performance.md)",
    }

    // ---- wrong use ------------------------------------------------------------------------------------------------

    /// NAME is none.
    unknown_scene(names) {
        "the scenes are {names}; a size may follow a colon, as in field:708",
        "les scènes sont {names} ; une taille peut suivre deux-points, par exemple field:708",
    }
    /// The size of a family is outside its range.
    bad_size_of(name, min, max) {
        "the size of {name} is a whole number from {min} to {max}",
        "la taille de {name} est un nombre entier de {min} à {max}",
    }
    /// The picture is too large to hold its rays.
    too_many_pixels(most) {
        "a size is two whole numbers with an x between them, such as 640x480, and gives at most {most} pixels: \
their rays are held in memory",
        "une taille est formée de deux entiers séparés par un x, par exemple 640x480, et donne au plus {most} pixels : \
leurs rayons sont gardés en mémoire",
    }

    // ---- the table ------------------------------------------------------------------------------------------------

    /// Above the table.
    title(version, engine, width, height, threads, repeat) {
        "lancer {version}, {engine}; {width}×{height}, {threads}, median of {repeat}",
        "lancer {version}, {engine} ; {width}×{height}, {threads}, médiane de {repeat}",
    }
    /// The tracer that follows the subject's text.
    reference() { "reference tracer", "traceur de référence" }
    /// Above the columns of building.
    building() { "building", "préparation" }
    /// Above the columns of rays.
    casting() { "million rays per second", "millions de rayons par seconde" }
    /// Above the columns of pictures.
    frame() { "picture", "image" }
    /// The scene.
    scene() { "scene", "scène" }
    /// Spheres, planes and facets.
    primitives() { "primitives", "primitives" }
    /// Milliseconds.
    milliseconds() { "ms", "ms" }
    /// Millions of primitives a second.
    build_rate() { "M/s", "M/s" }
    /// Bytes of the hierarchy for each primitive.
    bytes() { "B each", "o/prim." }
    /// From the eye.
    primary() { "primary", "primaires" }
    /// To a lamp.
    shadow() { "shadow", "d'ombre" }
    /// Mirrored.
    reflected() { "reflected", "réfléchis" }
    /// In any direction.
    diffuse() { "diffuse", "diffus" }
    /// Millions of rays of a picture a second.
    frame_rate() { "M rays/s", "M rayons/s" }
    /// The program was built for finding faults.
    unoptimised() {
        "this lancer was built without optimisation; build it with `cargo build --release` to measure it",
        "ce lancer a été construit sans optimisation ; construisez-le avec « cargo build --release » pour le mesurer",
    }
}
