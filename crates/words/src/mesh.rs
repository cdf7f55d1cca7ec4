//! What is said of mesh files.

phrases! {
    /// A fault and its file.
    in_file(file, fault) {
        "mesh file `{file}`: {fault}",
        "fichier de maillage « {file} » : {fault}",
    }
    /// A fault, its file and its line.
    in_line(file, line, fault) {
        "mesh file `{file}`, line {line}: {fault}",
        "fichier de maillage « {file} », ligne {line} : {fault}",
    }
    /// The words under the underlined path.
    named_here() { "named here", "nommé ici" }
    /// There is no such file.
    missing() { "there is no such file", "ce fichier n'existe pas" }
    /// The rule for paths.
    missing_help() {
        "the path is relative to the folder of the scene document",
        "le chemin part du dossier du document de scène",
    }
    /// The system refuses.
    unreadable(cause) { "the file cannot be read: {cause}", "le fichier est illisible : {cause}" }
    /// A folder, a pipe or a device.
    not_a_file() { "this is not a regular file", "ce n'est pas un fichier ordinaire" }
    /// The formats that can be read.
    formats_help() {
        "name an OBJ, PLY, STL or glTF file: .obj .ply .stl .gltf .glb",
        "nommez un fichier OBJ, PLY, STL ou glTF : .obj .ply .stl .gltf .glb",
    }
    /// Outside the document's folder.
    outside() {
        "the path is absolute or leads out of the folder of the scene document",
        "le chemin est absolu ou sort du dossier du document de scène",
    }
    /// How to allow it.
    outside_help() {
        "move it beside the document or below its folder, or allow such files with --allow-outside",
        "placez-le à côté du document ou dans un sous-dossier, ou autorisez de tels fichiers par --allow-outside",
    }
    /// The file is larger than what is read.
    too_large(most) {
        "the file is larger than {most} MiB",
        "le fichier dépasse {most} Mio",
    }
    /// The extension means nothing.
    unknown_format(extension) {
        "no mesh format has the extension `{extension}`",
        "aucun format de maillage n'a l'extension « {extension} »",
    }
    /// The mesh would be much larger than its file.
    too_much_memory(most) {
        "the mesh would take more than {most} MiB of memory, far more than its file",
        "le maillage prendrait plus de {most} Mio de mémoire, bien plus que son fichier",
    }
    /// An empty mesh.
    no_facets() { "there is not one facet", "il n'y a aucune facette" }
    /// Why a mesh may be empty.
    no_facets_help() {
        "perhaps the file was cut, is of another format, or holds only points or lines",
        "le fichier est peut-être coupé, d'un autre format, ou ne contient que des points ou des lignes",
    }
    /// A truncated file.
    ends_early() { "the file ends where more is due", "le fichier s'arrête avant la fin attendue" }
    /// Why it may be so.
    ends_early_help() {
        "the file was cut, or its header promises more than there is",
        "le fichier a été coupé, ou son en-tête promet plus que son contenu",
    }
    /// No number.
    not_a_number(found) { "a number is due, not `{found}`", "un nombre est attendu, pas « {found} »" }
    /// A word where another is due.
    unexpected(found, due) { "`{due}` is due, not `{found}`", "« {due} » est attendu, pas « {found} »" }
    /// Too few numbers behind a keyword.
    too_few_numbers(word) {
        "`{word}` needs three numbers",
        "« {word} » demande trois nombres",
    }
    /// A coordinate that no scene may have.
    coordinate(value) {
        "the coordinate {value} is not allowed",
        "la coordonnée {value} n'est pas permise",
    }
    /// The rule for coordinates.
    coordinate_help() {
        "coordinates are finite and lie within ±1e9",
        "les coordonnées sont finies et comprises entre -1e9 et 1e9",
    }
    /// A facet names a vertex that does not exist.
    no_such_vertex(named, vertices) {
        "a facet names vertex {named}, but there are {vertices} vertices",
        "une facette nomme le sommet {named}, mais il y a {vertices} sommets",
    }
    /// A facet names a normal that does not exist.
    no_such_normal(named, normals) {
        "a facet names normal {named}, but there are {normals} normals",
        "une facette nomme la normale {named}, mais il y a {normals} normales",
    }
    /// A face that is no surface.
    too_few_corners(corners) {
        "a facet needs three corners, not {corners}",
        "une facette demande trois sommets, pas {corners}",
    }
    /// A face that is too large to be cut.
    too_many_corners(corners, most) {
        "a facet has {corners} corners, more than {most}",
        "une facette a {corners} sommets, plus que {most}",
    }
    /// What to do about it.
    too_many_corners_help() {
        "cut it into triangles in the program that made the file",
        "découpez-la en triangles dans le logiciel qui a produit le fichier",
    }
    /// More than 32 bits count.
    too_many_items() {
        "there are more than 4294967295 vertices or facets",
        "il y a plus de 4294967295 sommets ou facettes",
    }
    /// Something that the format demands.
    lacks(what) { "`{what}` is missing", "« {what} » manque" }
    /// A PLY file of an unknown form.
    unknown_encoding(encoding) {
        "the PLY form `{encoding}` is not known; known are ascii, binary_little_endian and binary_big_endian",
        "la forme PLY « {encoding} » n'est pas connue ; sont connues ascii, binary_little_endian et binary_big_endian",
    }
    /// Broken JSON, or JSON of another shape.
    bad_document(cause) { "this is no glTF document: {cause}", "ce n'est pas un document glTF : {cause}" }
    /// A dangling reference.
    no_such_entry(list, index) { "there is no entry {index} in `{list}`", "il n'y a pas d'élément {index} dans « {list} »" }
    /// A contradiction.
    bad_entry(list, index) {
        "entry {index} of `{list}` contradicts the rest of the file",
        "l'élément {index} de « {list} » contredit le reste du fichier",
    }
    /// An extension that the file needs.
    unknown_extension(name) {
        "the file needs the glTF extension `{name}`, which is not known",
        "le fichier exige l'extension glTF « {name} », qui n'est pas connue",
    }
    /// What to do about it.
    unknown_extension_help() {
        "save it again without compression or extensions, or as OBJ, PLY or STL",
        "enregistrez-le sans compression ni extension, ou en OBJ, PLY ou STL",
    }
    /// Warning: a material that no library defines.
    unknown_material(name) {
        "no library defines the material `{name}`",
        "aucune bibliothèque ne définit la matière « {name} »",
    }
    /// What happens instead.
    unknown_material_help() {
        "its facets get the object's own material",
        "ses facettes prennent la matière de l'objet",
    }
    /// Warning: normals that cannot be used.
    normals_left_out() {
        "its normals are not used: some are missing or have no direction",
        "ses normales ne sont pas utilisées : certaines manquent ou n'ont pas de direction",
    }
    /// What happens instead.
    normals_left_out_help() {
        "smooth normals are computed from the facets",
        "les normales lissées sont calculées à partir des facettes",
    }
    /// Warning: textures.
    textures_left_out() { "its textures are not used", "ses textures ne sont pas utilisées" }
    /// What happens instead.
    textures_left_out_help() {
        "every part has one colour",
        "chaque partie a une seule couleur",
    }
    /// Warning: a coefficient out of range.
    clamped(word) {
        "`{word}` was out of range and is brought into it",
        "« {word} » était hors limites et y est ramené",
    }
}
