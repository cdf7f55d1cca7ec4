//! What is said of attribute values and lists of numbers.

use crate::Lang;

reports! {
    /// A token that is no number.
    not_a_number(found) {
        "`{found}` is not a number", "a number is due here", "a number is written `12`, `-0.5` or `2.5e-3`";
        "« {found} » n'est pas un nombre", "un nombre est attendu ici",
        "un nombre s'écrit « 12 », « -0.5 » ou « 2.5e-3 »";
    }
    /// A number in another notation.
    number_form(found, suggestion) {
        "`{found}` is not written as numbers are here", "write `{suggestion}`",
        "a number is written `12`, `-0.5` or `2.5e-3`: digits on both sides of the point, and nothing around them";
        "« {found} » n'est pas écrit comme le sont ici les nombres", "écrivez « {suggestion} »",
        "un nombre s'écrit « 12 », « -0.5 » ou « 2.5e-3 » : des chiffres de chaque côté du point, et rien autour";
    }
    /// A comma that separates numbers where a point was meant.
    decimal_comma(found, suggestion) {
        "a comma separates numbers: `{found}` is more than one", "decimal comma? write `{suggestion}`",
        "decimals are written with a point";
        "une virgule sépare des nombres : « {found} » en fait plusieurs", "virgule décimale ? écrivez « {suggestion} »",
        "les décimales s'écrivent avec un point";
    }
    /// A wrong count of numbers.
    number_count(due, but, found, sample) {
        "{due}, {but}", "{found}", "{sample}";
        "{due}, {but}", "{found}", "{sample}";
    }
    /// A comma with nothing on one side.
    stray_comma() {
        "nothing stands on one side of this comma", "", "take it out: blanks, or one comma, separate two values";
        "il n'y a rien d'un côté de cette virgule", "",
        "ôtez-la : des blancs, ou une seule virgule, séparent deux valeurs";
    }
    /// A number beyond what a double holds.
    too_large_number(found) {
        "`{found}` is too large", "", "every number lies between -1000000000 and 1000000000";
        "« {found} » est trop grand", "", "tous les nombres vont de -1000000000 à 1000000000";
    }
    /// A fraction or a negative number where a count is due.
    not_whole(found) {
        "`{found}` is not a whole number", "a whole number from 0 on is due here", "write it without a sign or fraction";
        "« {found} » n'est pas un nombre entier", "un entier positif ou nul est attendu ici",
        "écrivez-le sans signe ni décimales";
    }
    /// A `#` and something else than six hexadecimal digits.
    not_a_color(found) {
        "`{found}` is not a colour", "", "a colour is `0.2 0.4 1`, one number for grey, or `#3366ff` with six digits";
        "« {found} » n'est pas une couleur", "",
        "une couleur s'écrit « 0.2 0.4 1 », un seul nombre pour un gris, ou « #3366ff » avec six chiffres";
    }
    /// A colour in 0..255.
    color_in_bytes(found, suggestion) {
        "the colour `{found}` goes beyond 1", "bytes of 0 to 255? write `{suggestion}`", "colours lie between 0 and 1";
        "la couleur « {found} » dépasse 1", "des octets de 0 à 255 ? écrivez « {suggestion} »",
        "les couleurs vont de 0 à 1";
    }
    /// A word that is none of those due.
    not_one_of(found, guess, legal) {
        "`{found}` is not known here", "{guess}", "write {legal}";
        "« {found} » est inconnu ici", "{guess}", "écrivez {legal}";
    }
    /// A word is due, and there is none.
    no_word(legal) {
        "a word is missing here", "", "write {legal}";
        "il manque un mot ici", "", "écrivez {legal}";
    }
    /// A name of white space.
    empty_name() {
        "a name must not be empty", "", "write a name, or take the attribute out where none is needed";
        "un nom ne doit pas être vide", "", "écrivez un nom, ou ôtez l'attribut là où il n'en faut pas";
    }
}

phrases! {
    /// The question of a probable meaning.
    did_you_mean(name) { "did you mean `{name}`?", "vouliez-vous dire « {name} » ?" }
    /// Where there is no probable meaning.
    unknown() { "unknown", "inconnu" }
    /// A name or a value in the middle of a sentence.
    quoted(name) { "`{name}`", "« {name} »" }
    /// The last two of several, of which one is meant.
    or(first, last) { "{first} or {last}", "{first} ou {last}" }
    /// The last two of several, all of which are meant.
    and(first, last) { "{first} and {last}", "{first} et {last}" }
    /// One number is due.
    due_one() { "one number is due here", "un nombre est attendu ici" }
    /// Two numbers are due.
    due_two() { "two numbers are due here", "deux nombres sont attendus ici" }
    /// Three numbers are due.
    due_three() { "three numbers are due here", "trois nombres sont attendus ici" }
    /// One or three numbers are due.
    due_one_or_three() { "one or three numbers are due here", "un ou trois nombres sont attendus ici" }
    /// Twelve numbers are due.
    due_twelve() { "twelve numbers, four corners, are due here", "douze nombres, quatre coins, sont attendus ici" }
    /// Triples of numbers are due.
    due_triples() {
        "the numbers here go by threes",
        "les nombres vont ici par trois",
    }
    /// How one number is written.
    sample_one() { "write one number, such as `0.5`", "écrivez un seul nombre, par exemple « 0.5 »" }
    /// How two numbers are written.
    sample_two() {
        "write two numbers with a blank between them, such as `4 3`",
        "écrivez deux nombres séparés par un blanc, par exemple « 4 3 »",
    }
    /// How three numbers are written.
    sample_three() {
        "write three numbers with blanks between them, such as `0 1 2.5`",
        "écrivez trois nombres séparés par des blancs, par exemple « 0 1 2.5 »",
    }
    /// How one or three numbers are written.
    sample_one_or_three() {
        "write one number for all three, such as `0.5`, or three, such as `0.2 0.4 1`",
        "écrivez un nombre pour les trois, par exemple « 0.5 », ou trois, par exemple « 0.2 0.4 1 »",
    }
    /// How twelve numbers are written.
    sample_twelve() {
        "each corner is three numbers: bottom left, bottom right, top right, top left",
        "chaque coin est formé de trois nombres : bas gauche, bas droite, haut droite, haut gauche",
    }
    /// How triples of numbers are written.
    sample_triples() {
        "a vertex, a normal or a facet is three numbers: one is missing, or one too many",
        "il faut trois nombres par sommet, par normale et par facette : il en manque, ou il y en a trop",
    }
    /// So many numbers were found, more than one.
    but_several(found) { "but there are {found}", "mais il y en a {found}" }
}

/// How many numbers were found, after what is due.
pub fn but_found(lang: Lang, found: usize) -> String {
    match (lang, found) {
        (Lang::English, 0) => "but there is none".to_owned(),
        (Lang::English, 1) => "but there is one".to_owned(),
        (Lang::French, 0) => "mais il n'y en a aucun".to_owned(),
        (Lang::French, 1) => "mais il n'y en a qu'un".to_owned(),
        (_, several) => but_several(lang, several),
    }
}

/// Several names in a row, each quoted, of which one is meant: `a`, `b` or `c`.
pub fn any_of<S: AsRef<str>>(lang: Lang, names: &[S]) -> String {
    in_a_row(lang, names, or)
}

/// Several names in a row, each quoted, all of which are meant: `a`, `b` and `c`.
pub fn all_of<S: AsRef<str>>(lang: Lang, names: &[S]) -> String {
    in_a_row(lang, names, and)
}

fn in_a_row<S: AsRef<str>>(lang: Lang, names: &[S], join: fn(Lang, String, String) -> String) -> String {
    match names {
        [] => String::new(),
        [name] => quoted(lang, name.as_ref()),
        [first @ .., last] => {
            let first: Vec<String> = first.iter().map(|name| quoted(lang, name.as_ref())).collect();
            join(lang, first.join(", "), quoted(lang, last.as_ref()))
        }
    }
}
