//! Arithmetic in number fields: `1/3`, `2*pi`, `sqrt(2)`, `+=0.5`.
//!
//! ```text
//! field = ["+=" | "-=" | "*=" | "/="] sum        relative to the value that the field has
//! sum   = product {("+" | "-") product}
//! product = power {("*" | "/") power}
//! power = ("+" | "-") power | atom ["^" power]     -2^2 is -4, 2^-1 is 0.5, 2^3^2 is 512
//! atom  = number | "pi" | function "(" sum ")" | "(" sum ")"
//! ```
//! Angles of `sin`, `cos`, `tan` and their inverses are in degrees, as in the documents.

use lancer_words::{Lang, arithmetic as words, xml::value};

/// Why a text is no number.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NumberError {
    /// There is nothing.
    #[error("a number is due")]
    Empty,
    /// A sign that has no place there.
    #[error("`{found}` has no place at character {at}")]
    Unexpected {
        /// The sign.
        found: char,
        /// Its place, from 1, in characters.
        at: usize,
    },
    /// The text ends where a number is due.
    #[error("something is missing at the end")]
    Unfinished,
    /// A comma between digits.
    #[error("decimal comma? write `{suggestion}`")]
    DecimalComma {
        /// The text with points.
        suggestion: String,
    },
    /// A word that is neither a function nor a constant.
    #[error("`{word}` is not known")]
    UnknownWord {
        /// The word.
        word: String,
    },
    /// A parenthesis is not closed.
    #[error("a parenthesis is not closed")]
    Unclosed,
    /// Too many nested parentheses, signs or powers, or too long a text.
    #[error("too deep")]
    TooDeep,
    /// The result is not finite: a division by 0, a root of a negative number.
    #[error("no finite number")]
    NotFinite,
}

impl NumberError {
    /// What is wrong and what to write.
    pub fn text(&self, lang: Lang) -> String {
        match self {
            NumberError::Empty => words::empty(lang),
            NumberError::Unexpected { found, at } => words::unexpected(lang, found, at),
            NumberError::Unfinished => words::unfinished(lang),
            // the same hint as in documents
            NumberError::DecimalComma { suggestion } => value::decimal_comma(lang, "", suggestion).label,
            NumberError::UnknownWord { word } => words::unknown_word(lang, word, KNOWN),
            NumberError::Unclosed => words::unclosed(lang),
            NumberError::TooDeep => words::too_deep(lang),
            NumberError::NotFinite => words::not_finite(lang),
        }
    }
}

/// The words that may be used.
const KNOWN: &str = "pi, sqrt, abs, sin, cos, tan, asin, acos, atan";
/// Nested parentheses, signs and powers.
const MOST_DEPTH: u32 = 64;
/// Bytes of a text: nobody types more.
const MOST_BYTES: usize = 1000;

/// The number that a text means in a field that has the value `old`.
///
/// # Errors
/// Why it means none.
pub fn evaluate(text: &str, old: f64) -> Result<f64, NumberError> {
    if text.len() > MOST_BYTES {
        return Err(NumberError::TooDeep);
    }
    let trimmed = text.trim();
    let relative = ["+=", "-=", "*=", "/="].into_iter().find_map(|sign| {
        trimmed.strip_prefix(sign).map(|rest| (sign, rest, text.len() - text.trim_start().len() + sign.len()))
    });
    let (sign, rest, skipped) = relative.unwrap_or(("", trimmed, text.len() - text.trim_start().len()));
    let mut parser = Parser { text, place: skipped, depth: 0 };
    if rest.trim().is_empty() {
        return Err(if sign.is_empty() { NumberError::Empty } else { NumberError::Unfinished });
    }
    let number = parser.sum()?;
    if let Some(found) = parser.peek() {
        return Err(parser.unexpected(found));
    }
    let value = match sign {
        "+=" => old + number,
        "-=" => old - number,
        "*=" => old * number,
        "/=" => old / number,
        _ => number,
    };
    if value.is_finite() { Ok(value) } else { Err(NumberError::NotFinite) }
}

struct Parser<'a> {
    text: &'a str,
    /// The byte that is read next.
    place: usize,
    depth: u32,
}

impl Parser<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.place..).unwrap_or("")
    }

    /// The next character that is no white space.
    fn peek(&mut self) -> Option<char> {
        let blanks = self.rest().len() - self.rest().trim_start().len();
        self.place += blanks;
        self.rest().chars().next()
    }

    /// Takes the character if it comes next.
    fn take(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.place += wanted.len_utf8();
        }
        found
    }

    fn unexpected(&self, found: char) -> NumberError {
        let suggestion = self.text.trim().replace(',', ".");
        if found == ',' && evaluate_without_commas(&suggestion) {
            return NumberError::DecimalComma { suggestion };
        }
        let at = self.text.get(..self.place).unwrap_or("").chars().count() + 1;
        NumberError::Unexpected { found, at }
    }

    /// Runs `inner` one level deeper.
    fn deeper(&mut self, inner: impl FnOnce(&mut Self) -> Result<f64, NumberError>) -> Result<f64, NumberError> {
        self.depth += 1;
        if self.depth > MOST_DEPTH {
            return Err(NumberError::TooDeep);
        }
        let value = inner(self);
        self.depth -= 1;
        value
    }

    fn sum(&mut self) -> Result<f64, NumberError> {
        let mut value = self.product()?;
        loop {
            if self.take('+') {
                value += self.product()?;
            } else if self.take('-') {
                value -= self.product()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn product(&mut self) -> Result<f64, NumberError> {
        let mut value = self.power()?;
        loop {
            if self.take('*') {
                value *= self.power()?;
            } else if self.take('/') {
                value /= self.power()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn power(&mut self) -> Result<f64, NumberError> {
        if self.take('-') {
            return self.deeper(|parser| parser.power().map(|value| -value));
        }
        if self.take('+') {
            return self.deeper(Parser::power);
        }
        let base = self.atom()?;
        if self.take('^') {
            let exponent = self.deeper(Parser::power)?;
            return Ok(libm::pow(base, exponent));
        }
        Ok(base)
    }

    fn atom(&mut self) -> Result<f64, NumberError> {
        match self.peek() {
            None => Err(NumberError::Unfinished),
            Some('(') => self.parenthesis(),
            Some(found) if found.is_ascii_digit() || found == '.' => self.literal(found),
            Some(found) if found.is_alphabetic() || found == 'π' => self.word(),
            Some(found) => Err(self.unexpected(found)),
        }
    }

    fn parenthesis(&mut self) -> Result<f64, NumberError> {
        if !self.take('(') {
            return Err(self.peek().map_or(NumberError::Unfinished, |found| self.unexpected(found)));
        }
        let value = self.deeper(Parser::sum)?;
        match self.peek() {
            Some(')') => {
                self.place += 1;
                Ok(value)
            }
            Some(found) => Err(self.unexpected(found)),
            None => Err(NumberError::Unclosed),
        }
    }

    /// `digits[.digits][e±digits]`; a missing zero on either side of the point is let pass.
    fn literal(&mut self, found: char) -> Result<f64, NumberError> {
        let bytes = self.rest().as_bytes();
        let digits = |from: usize| from + bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
        let mut end = digits(0);
        if bytes.get(end) == Some(&b'.') {
            end = digits(end + 1);
        }
        if bytes.get(end).is_some_and(|byte| byte.eq_ignore_ascii_case(&b'e')) {
            let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            let exponent = digits(end + 1 + sign);
            if exponent > end + 1 + sign {
                end = exponent;
            }
        }
        let value = self.rest().get(..end).unwrap_or("").parse::<f64>().map_err(|_| self.unexpected(found))?;
        self.place += end;
        Ok(value)
    }

    fn word(&mut self) -> Result<f64, NumberError> {
        let rest = self.rest();
        let end = rest.find(|letter: char| !letter.is_alphanumeric()).unwrap_or(rest.len());
        let word = rest.get(..end).unwrap_or("").to_owned();
        let function: fn(f64) -> f64 = match word.to_ascii_lowercase().as_str() {
            "pi" | "π" => {
                self.place += end;
                return Ok(std::f64::consts::PI);
            }
            "sqrt" => f64::sqrt,
            "abs" => f64::abs,
            "sin" => |degrees| sin_cos(degrees).0,
            "cos" => |degrees| sin_cos(degrees).1,
            "tan" => |degrees| {
                let (sin, cos) = sin_cos(degrees);
                sin / cos
            },
            "asin" => |value| libm::asin(value).to_degrees(),
            "acos" => |value| libm::acos(value).to_degrees(),
            "atan" => |value| libm::atan(value).to_degrees(),
            _ => return Err(NumberError::UnknownWord { word }),
        };
        self.place += end;
        self.parenthesis().map(function)
    }
}

/// Whether a text with its commas as points is a number.
fn evaluate_without_commas(text: &str) -> bool {
    !text.contains(',') && evaluate(text, 1.0).is_ok()
}

/// Sine and cosine of degrees, exact at multiples of 30 where they are 0, ½ or 1.
fn sin_cos(degrees: f64) -> (f64, f64) {
    let turned = libm::fmod(degrees, 360.0);
    let (mut sin, mut cos) = libm::sincos(turned.to_radians());
    for (value, whole) in [(&mut sin, turned), (&mut cos, turned)] {
        // of the values at multiples of 30 these are the only short ones
        let doubled = (*value * 2.0).round();
        if whole % 30.0 == 0.0 && (*value * 2.0 - doubled).abs() < 1e-12 {
            *value = doubled / 2.0 + 0.0;
        }
    }
    (sin, cos)
}
