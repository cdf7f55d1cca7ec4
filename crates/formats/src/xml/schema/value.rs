//! What the published schema says of a value: XML Schema's types and regular expressions.
//!
//! A range is told for every number by itself, and for those of a list as far as a pattern can tell it: a number with an
//! exponent is let pass there. What the schema refuses the reader refuses, and nothing that the reader takes is refused.

use super::super::shortest;
use super::super::vocabulary::{Kind, STEPS};
use super::Writer;
use lancer_scene::limits;

/// A number as the documents write it.
const NUMBER: &str = r"[+\-]?[0-9]+(\.[0-9]+)?([eE][+\-]?[0-9]+)?";
/// The same without an exponent.
const DECIMAL: &str = r"\s*[+\-]?[0-9]+(\.[0-9]+)?\s*";
/// The same with one.
const SCIENTIFIC: &str = r"\s*[+\-]?[0-9]+(\.[0-9]+)?[eE][+\-]?[0-9]+\s*";
/// A whole number: what is behind its point is 0.
const WHOLE: &str = r"\s*[+\-]?[0-9]+(\.0+)?\s*";
/// A number greater than 0.
const POSITIVE: &str = r"\+?(0*[1-9][0-9]*(\.[0-9]+)?|0+\.0*[1-9][0-9]*)([eE][+\-]?[0-9]+)?";
/// Zero.
const ZERO: &str = r"[+\-]?0+(\.0+)?([eE][+\-]?[0-9]+)?";
/// What separates two values: white space, or one comma with white space around it.
const BETWEEN: &str = r"(\s+|\s*,\s*)";

impl Writer {
    /// How a value is written.
    pub(super) fn value(&mut self, kind: Kind) {
        let one_or_three = |number: &str| format!("{number}|{}", in_a_row(number, 3));
        match kind {
            Kind::Version => self.pattern(&blanks("1")),
            Kind::Text => self.line("<text/>"),
            Kind::Name | Kind::MaterialName | Kind::Path => self.pattern(r".*\S.*"),
            Kind::Color => {
                let share = one_or_three(&format!("({})", up_to(1.0)));
                self.pattern(&blanks(&format!("#[0-9a-fA-F]{{6}}|{share}")));
            }
            Kind::Channels(min, _) if min > 0.0 => self.pattern(&blanks(&one_or_three(&format!("({POSITIVE})")))),
            Kind::Channels(_, max) => self.pattern(&blanks(&one_or_three(&format!("({})", up_to(max))))),
            Kind::Factors => self.pattern(&blanks(&one_or_three(&format!(r"(-?{POSITIVE})")))),
            Kind::Point => self.pattern(&blanks(&in_a_row(NUMBER, 3))),
            Kind::Length => self.number(limits::LEAST, limits::COORDINATE, DECIMAL),
            Kind::Number(min, max) => self.number(min, max, DECIMAL),
            Kind::Integer(min, max) => self.number(f64::from(min), f64::from(max), WHOLE),
            Kind::Size => self.pattern(&blanks(&in_a_row(&format!("({POSITIVE})"), 2))),
            Kind::Corners => self.pattern(&blanks(&in_a_row(NUMBER, 12))),
            // none of no facets
            Kind::Run => {
                let exact = r"(\.[0-9]+)?([eE]\+?[0-9]+)?";
                self.pattern(&blanks(&format!(r"\+?[0-9]+{exact}{BETWEEN}\+?0*[1-9][0-9]*{exact}")));
            }
            Kind::Choice(words) => self.pattern(&blanks(&words.join("|"))),
            Kind::Steps => {
                let word = STEPS.join("|");
                self.pattern(&blanks(&format!("(({word})({BETWEEN}({word}))*)?")));
            }
        }
    }

    /// One number within a range. XML Schema's decimals have no exponent; what has one is let pass.
    fn number(&mut self, min: f64, max: f64, written: &str) {
        self.within("choice", |out| {
            out.within("data type=\"decimal\"", |out| {
                // 1e-9 has an exponent, and is a range's least number only where it means "more than 0"
                let least = if min == limits::LEAST { "0.000000001".to_owned() } else { shortest(min) };
                out.parameter("minInclusive", &least);
                out.parameter("maxInclusive", &shortest(max));
                out.parameter("pattern", written);
            });
            out.pattern(SCIENTIFIC);
        });
    }
}

/// White space may stand around a value.
fn blanks(pattern: &str) -> String {
    format!(r"\s*({pattern})\s*")
}

/// So many numbers of a pattern.
fn in_a_row(number: &str, count: usize) -> String {
    format!("{number}({BETWEEN}{number}){{{}}}", count - 1)
}

/// A number from 0 to a power of ten.
fn up_to(max: f64) -> String {
    let text = shortest(max);
    let digits = text.len() - 1;
    let below = if digits == 0 { "0+".to_owned() } else { format!("0*[0-9]{{1,{digits}}}") };
    format!(r"\+?({below}(\.[0-9]+)?|0*{text}(\.0+)?|[0-9]+(\.[0-9]+)?[eE][+\-]?[0-9]+)|{ZERO}")
}
