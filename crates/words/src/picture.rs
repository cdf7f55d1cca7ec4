//! What is said of picture files, and of files that cannot be written.

phrases! {
    /// The width of a picture.
    width() { "width", "largeur" }
    /// The height of a picture.
    height() { "height", "hauteur" }
    /// The value of full intensity in a pixmap.
    maxval() { "maximal value", "valeur maximale" }
    /// One channel of one pixel.
    sample() { "sample", "composante" }

    /// An extension that means no format.
    unknown_extension(extension, known) {
        "no picture format has the extension .{extension}; known are {known}",
        "aucun format d'image n'a l'extension .{extension} ; sont connues {known}",
    }
    /// The first bytes of the file mean nothing.
    unknown_format() {
        "the file is no picture of a known format",
        "le fichier n'est pas une image d'un format connu",
    }
    /// A netpbm format other than P3 and P6.
    other_netpbm(kind) {
        "the file is a netpbm file of kind P{kind}, not a colour pixmap",
        "le fichier est un fichier netpbm de type P{kind}, pas une image en couleurs",
    }
    /// What can be read.
    formats_help() {
        "PPM (P3 or P6), PNG, QOI, BMP, TIFF and OpenEXR can be read",
        "les formats lus sont PPM (P3 ou P6), PNG, QOI, BMP, TIFF et OpenEXR",
    }
    /// The file ends before a number.
    missing_number(count) {
        "the header ends before the {count}",
        "l'en-tête s'arrête avant la {count}",
    }
    /// No number.
    junk(count) {
        "a decimal number is due for the {count}",
        "un nombre décimal est attendu pour la {count}",
    }
    /// The words under what is no number.
    not_a_number() { "not a number", "pas un nombre" }
    /// The words at the end of a file.
    ends_here() { "the file ends here", "le fichier s'arrête ici" }
    /// A number that is 0 or too large.
    out_of_range(count, value, max) {
        "the {count} is {value}, but must be 1 to {max}",
        "la {count} vaut {value} au lieu de 1 à {max}",
    }
    /// What a pixmap's header holds.
    header_help() {
        "a PPM header is P3 or P6, then width, height and maximal value, separated by white space",
        "un en-tête PPM est P3 ou P6, puis la largeur, la hauteur et la valeur maximale, séparées par des blancs",
    }
    /// A truncated raster.
    too_short(due, found) {
        "the picture needs {due} samples, but the file ends after {found}",
        "l'image compte {due} composantes, mais le fichier s'arrête après {found}",
    }
    /// Why a raster may be truncated.
    too_short_help() {
        "the file was cut, or its header gives a wrong size",
        "le fichier a été coupé, ou son en-tête donne une taille fausse",
    }
    /// A sample brighter than full intensity.
    sample_above_maxval(sample, maxval) {
        "the sample {sample} is above the maximal value {maxval}",
        "la composante {sample} dépasse la valeur maximale {maxval}",
    }
    /// Another decoder's words.
    undecodable(cause) {
        "the picture cannot be decoded: {cause}",
        "l'image ne peut pas être décodée : {cause}",
    }
    /// Too large to be decoded.
    too_much_memory(most) {
        "the picture would take more than {most} MiB of memory",
        "l'image prendrait plus de {most} Mio de mémoire",
    }
    /// Two sizes.
    different_sizes(width1, height1, width2, height2) {
        "the pictures differ in size: {width1}×{height1} and {width2}×{height2} pixels",
        "les images n'ont pas la même taille : {width1}×{height1} et {width2}×{height2} pixels",
    }
}
