//! Wrong use of the command line.

phrases! {
    /// --size is no size.
    bad_size() {
        "a size is two whole numbers from 1 to 65535 with an x between them, such as 640x480",
        "une taille est formée de deux entiers de 1 à 65535 séparés par un x, par exemple 640x480",
    }
    /// --region is no region.
    bad_region() {
        "a region is four whole numbers: left column, top row, width and height, such as 10,20,64,48; \
width and height are at least 1",
        "une région est formée de quatre entiers : colonne de gauche, ligne du haut, largeur et hauteur, par exemple \
10,20,64,48 ; largeur et hauteur valent au moins 1",
    }
    /// A number is outside its range.
    bad_number(min, max) {
        "a whole number from {min} to {max} is due",
        "on attend un nombre entier de {min} à {max}",
    }
    /// A number has only a lower bound.
    bad_count(min) { "a whole number of {min} or more is due", "on attend un nombre entier d'au moins {min}" }
    /// --without names something else.
    bad_step() {
        "the steps are shadows, reflection and transparency, separated by commas",
        "les étapes sont shadows, reflection et transparency, séparées par des virgules",
    }
    /// --adaptive is no threshold.
    bad_threshold() { "a number from 0 to 1 is due, such as 0.05", "on attend un nombre de 0 à 1, par exemple 0.05" }
    /// --all-views with `-`.
    all_views_to_stdout() {
        "--all-views writes several pictures; they cannot all go to standard output",
        "--all-views écrit plusieurs images ; elles ne peuvent pas toutes aller sur la sortie standard",
    }
    /// `-` and `-`.
    stdin_twice() {
        "`-` is standard input, which can be read only once: name a file for one of the two",
        "« - » est l'entrée standard, qui ne se lit qu'une fois : nommez un fichier pour l'une des deux",
    }

    // ---- clap's own complaints, for those who read French ---------------------------------------------------------

    /// Before an error.
    error_prefix() { "error:", "erreur :" }
    /// Before the way out.
    help_prefix() { "help:", "aide :" }
    /// Between a complaint and its cause.
    colon() { ":", " :" }
    /// Where to read more.
    see_help() { "For more information, try '--help'.", "Pour en savoir plus, essayez « --help »." }
    /// An option that does not exist.
    unknown_argument(argument) {
        "unexpected argument '{argument}' found",
        "argument inattendu « {argument} »",
    }
    /// One that looks alike.
    similar(word) { "did you mean '{word}'?", "vouliez-vous dire « {word} » ?" }
    /// A mistyped command.
    meant_command(command) {
        "did you mean the command `{command}`? What stands there is taken for the name of a scene",
        "vouliez-vous la commande « {command} » ? Ce mot est pris pour le nom d'une scène",
    }
    /// A value that is no legal one.
    invalid_value(value, argument) {
        "invalid value '{value}' for '{argument}'",
        "valeur invalide « {value} » pour « {argument} »",
    }
    /// An option without its value.
    missing_value(argument) {
        "a value is required for '{argument}' but none was supplied",
        "« {argument} » demande une valeur, mais aucune n'est donnée",
    }
    /// The legal values.
    legal_values(values) { "possible values: {values}", "valeurs possibles : {values}" }
    /// An option twice.
    repeated_argument(argument) {
        "the argument '{argument}' cannot be used multiple times",
        "l'argument « {argument} » ne peut être donné qu'une fois",
    }
    /// Two options that exclude each other.
    conflicting_arguments(argument, other) {
        "the argument '{argument}' cannot be used with '{other}'",
        "l'argument « {argument} » ne va pas avec « {other} »",
    }
    /// Arguments that are due.
    missing_arguments(arguments) {
        "the following required arguments were not provided: {arguments}",
        "il manque des arguments obligatoires : {arguments}",
    }
    /// No such command.
    unknown_command(command) { "unrecognized subcommand '{command}'", "commande inconnue « {command} »" }
    /// An argument that is not UTF-8 where text is due.
    not_unicode() { "an argument is not valid UTF-8", "un argument n'est pas de l'UTF-8 valide" }
    /// Anything else.
    wrong_use() { "wrong use of the command line", "mauvais emploi de la ligne de commande" }
}
