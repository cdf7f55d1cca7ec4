//! What is said of files that cannot be read or written.

phrases! {
    /// A file that cannot be read, and why.
    cannot_read(path, cause) {
        "`{path}` cannot be read: {cause}",
        "impossible de lire « {path} » : {cause}",
    }
    /// Standard input cannot be read.
    cannot_read_standard(cause) {
        "standard input cannot be read: {cause}",
        "impossible de lire l'entrée standard : {cause}",
    }
    /// There is no such file.
    missing() { "there is no such file", "ce fichier n'existe pas" }
    /// What to do about it.
    missing_help() { "check the name and the folder", "vérifiez le nom et le dossier" }
    /// A pipe or a device.
    not_a_file() { "it is no regular file", "ce n'est pas un fichier ordinaire" }
    /// What to do instead.
    not_a_file_help() {
        "name a file, or send its content to standard input and name `-`",
        "nommez un fichier, ou envoyez son contenu sur l'entrée standard et nommez « - »",
    }
    /// The user must not read it.
    forbidden() { "you have no permission to read it", "vous n'avez pas le droit de le lire" }
    /// The file has too many bytes.
    larger_than(most) { "it is larger than {most} MiB", "il dépasse {most} Mio" }
    /// Symbolic links that end nowhere.
    links_in_a_circle() {
        "the symbolic links on its way lead in a circle",
        "les liens symboliques qui y mènent forment un cycle",
    }
    /// A path that the system does not take.
    name_too_long() {
        "its name is longer than the system allows",
        "son nom est plus long que le système ne le permet",
    }
    /// There is no memory.
    no_memory() { "there is not enough memory", "la mémoire ne suffit pas" }

    /// An extension that means no scene format.
    unknown_scene_extension(extension) {
        "no scene format has the extension .{extension}; known are .xml and .lancer",
        "aucun format de scène n'a l'extension .{extension} ; sont connues .xml et .lancer",
    }
    /// A file that cannot be written, and why.
    cannot_write(path, cause) {
        "`{path}` cannot be written: {cause}",
        "impossible d'écrire « {path} » : {cause}",
    }
    /// Standard output cannot be written.
    cannot_write_standard(cause) {
        "standard output cannot be written: {cause}",
        "impossible d'écrire sur la sortie standard : {cause}",
    }
    /// The folder of the path is missing.
    missing_folder(folder) { "there is no folder `{folder}`", "le dossier « {folder} » n'existe pas" }
    /// What to do about it.
    missing_folder_help() { "make the folder first, or check its name", "créez d'abord le dossier, ou vérifiez son nom" }
    /// Something else stands where a folder is due.
    not_a_folder(folder) { "`{folder}` is no folder", "« {folder} » n'est pas un dossier" }
    /// The path names a folder.
    is_a_folder() { "it is a folder", "c'est un dossier" }
    /// What to do about it.
    is_a_folder_help() {
        "name a file: a folder is never replaced",
        "nommez un fichier : un dossier n'est jamais remplacé",
    }
    /// The file is write-protected.
    read_only() { "the file is read-only", "le fichier est en lecture seule" }
    /// What to do about it.
    read_only_help() {
        "allow writing it (chmod u+w), or choose another name",
        "autorisez l'écriture (chmod u+w), ou choisissez un autre nom",
    }
    /// The folder is write-protected.
    read_only_folder(folder) {
        "no file can be made in the folder `{folder}`",
        "aucun fichier ne peut être créé dans le dossier « {folder} »",
    }
    /// Why the folder matters.
    read_only_folder_help() {
        "the file is written beside its place and moved there when it is whole, so its folder must be writable",
        "le fichier est écrit à côté de sa place et y est déplacé une fois complet : son dossier doit être accessible en écriture",
    }
    /// The disk or the quota is full.
    no_space() { "the disk is full", "le disque est plein" }
    /// The file would exceed a limit of the system.
    too_large() {
        "the file would be larger than the system allows",
        "le fichier dépasserait la taille permise par le système",
    }
    /// Nothing was lost.
    old_file_whole() { "a file that stood there before is unchanged", "un fichier déjà présent est resté inchangé" }
    /// The reading end of a pipe is closed.
    closed() { "the reader has closed it", "le lecteur l'a fermée" }
}
