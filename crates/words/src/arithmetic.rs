//! What is said of the arithmetic in number fields.

phrases! {
    /// Nothing was written.
    empty() { "write a number, such as 0.5 or 1/3", "écrivez un nombre, par exemple 0.5 ou 1/3" }
    /// A sign in the wrong place.
    unexpected(found, at) {
        "`{found}` has no place there (character {at})", "« {found} » n'a pas sa place ici (caractère {at})"
    }
    /// The text ends too early.
    unfinished() { "something is missing at the end", "il manque quelque chose à la fin" }
    /// An unknown word.
    unknown_word(word, known) {
        "`{word}` is not known; known: {known}", "« {word} » est inconnu ; sont connus : {known}"
    }
    /// An open parenthesis.
    unclosed() { "a parenthesis is not closed: write `)`", "une parenthèse n'est pas fermée : écrivez « ) »" }
    /// Too deep or too long.
    too_deep() { "too long or too deeply nested: write it shorter", "trop long ou trop imbriqué : écrivez plus court" }
    /// Not finite.
    not_finite() {
        "this is no finite number: a division by 0, or a root of a negative number",
        "ce n'est pas un nombre fini : une division par 0, ou la racine d'un nombre négatif"
    }
}
