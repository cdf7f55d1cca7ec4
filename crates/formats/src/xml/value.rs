//! What is wrong with an attribute's value or a list of numbers.

use super::{Excerpt, Guess};
use lancer_words::xml::{Report, value as words};
use lancer_words::{Lang, number};

/// A value that is not written as it must be.
#[derive(Clone, Debug, PartialEq)]
pub enum ValueProblem {
    /// A token that is no number.
    NotANumber {
        /// The token.
        found: Excerpt,
    },
    /// A number in another notation.
    NumberForm {
        /// The token.
        found: Excerpt,
        /// The same number in the right notation.
        suggestion: Excerpt,
    },
    /// Commas that were probably meant as decimal points.
    DecimalComma {
        /// The numbers around the comma.
        found: Excerpt,
        /// The number with a point.
        suggestion: Excerpt,
    },
    /// A wrong count of numbers.
    NumberCount {
        /// How many there are.
        found: usize,
        /// How many there should be.
        due: Due,
    },
    /// A comma with nothing on one side.
    StrayComma,
    /// A number beyond what a double holds.
    TooLarge {
        /// The number as it is written.
        found: Excerpt,
    },
    /// A number that is not whole, or is negative.
    NotWhole {
        /// The number as it is written.
        found: Excerpt,
    },
    /// `#` and something else than six hexadecimal digits.
    NotAColor {
        /// What is written.
        found: Excerpt,
    },
    /// A colour in 0..255.
    ColorInBytes {
        /// What is written.
        found: Excerpt,
        /// The same colour as `#rrggbb`.
        suggestion: Excerpt,
    },
    /// A word that is none of those due.
    NotOneOf {
        /// The word.
        found: Excerpt,
        /// What was probably meant.
        guess: Guess,
        /// The legal words.
        legal: &'static [&'static str],
    },
    /// A name of white space.
    EmptyName,
}

/// How many numbers are due.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Due {
    /// One.
    One,
    /// Two.
    Two,
    /// Three.
    Three,
    /// Three, or one that stands for three equal ones.
    OneOrThree,
    /// Twelve: four corners.
    Twelve,
    /// Any multiple of three.
    Triples,
}

impl Due {
    /// Whether so many numbers are due.
    pub fn is_met_by(self, count: usize) -> bool {
        match self {
            Due::One => count == 1,
            Due::Two => count == 2,
            Due::Three => count == 3,
            Due::OneOrThree => count == 1 || count == 3,
            Due::Twelve => count == 12,
            Due::Triples => count.is_multiple_of(3),
        }
    }

    fn word(self, lang: Lang) -> String {
        match self {
            Due::One => words::due_one(lang),
            Due::Two => words::due_two(lang),
            Due::Three => words::due_three(lang),
            Due::OneOrThree => words::due_one_or_three(lang),
            Due::Twelve => words::due_twelve(lang),
            Due::Triples => words::due_triples(lang),
        }
    }

    /// How so many numbers are written.
    fn sample(self, lang: Lang) -> String {
        match self {
            Due::One => words::sample_one(lang),
            Due::Two => words::sample_two(lang),
            Due::Three => words::sample_three(lang),
            Due::OneOrThree => words::sample_one_or_three(lang),
            Due::Twelve => words::sample_twelve(lang),
            Due::Triples => words::sample_triples(lang),
        }
    }
}

impl ValueProblem {
    pub(super) fn told(&self, lang: Lang) -> (&'static str, Report) {
        match self {
            ValueProblem::NotANumber { found } => ("xml::not-a-number", words::not_a_number(lang, found)),
            ValueProblem::NumberForm { found, suggestion } => {
                ("xml::number-form", words::number_form(lang, found, suggestion))
            }
            ValueProblem::DecimalComma { found, suggestion } => {
                ("xml::decimal-comma", words::decimal_comma(lang, found, suggestion))
            }
            ValueProblem::NumberCount { found, due } => {
                let but = words::but_found(lang, *found);
                let found = number::numbers(lang, *found);
                ("xml::number-count", words::number_count(lang, due.word(lang), but, found, due.sample(lang)))
            }
            ValueProblem::StrayComma => ("xml::stray-comma", words::stray_comma(lang)),
            ValueProblem::TooLarge { found } => ("xml::too-large-number", words::too_large_number(lang, found)),
            ValueProblem::NotWhole { found } => ("xml::not-whole", words::not_whole(lang, found)),
            ValueProblem::NotAColor { found } => ("xml::not-a-color", words::not_a_color(lang, found)),
            ValueProblem::ColorInBytes { found, suggestion } => {
                ("xml::color-in-bytes", words::color_in_bytes(lang, found, suggestion))
            }
            ValueProblem::NotOneOf { found, legal, .. } if found.as_ref().is_empty() => {
                ("xml::not-one-of", words::no_word(lang, words::any_of(lang, legal)))
            }
            ValueProblem::NotOneOf { found, guess, legal } => {
                ("xml::not-one-of", words::not_one_of(lang, found, guess.word(lang), words::any_of(lang, legal)))
            }
            ValueProblem::EmptyName => ("xml::empty-name", words::empty_name(lang)),
        }
    }
}
