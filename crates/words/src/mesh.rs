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
    /// What is due instead.
    not_a_file_help() {
        "name an OBJ, PLY, STL or glTF file",
        "nommez un fichier OBJ, PLY, STL ou glTF",
    }
    /// Outside the document's folder.
    outside() {
        "the file lies outside the folder of the scene document",
        "le fichier est hors du dossier du document de scène",
    }
    /// How to allow it.
    outside_help() {
        "move it beside the document or below its folder, or allow such files with --allow-outside",
        "placez-le à côté du document ou dans un sous-dossier, ou autorisez de tels fichiers par --allow-outside",
    }
}
