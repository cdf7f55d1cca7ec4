//! The types of the vocabulary: how a value of each is read from a document and how it is written into one.

use super::vocabulary::{Kind, STEPS, VERSION};
use super::{Due, Excerpt, Guess, Number, StructureProblem, ValueProblem, Written, shortest};
use crate::{Diagnostic, Span};
use lancer_scene::{Invalid, Steps, limits};
use std::borrow::Cow;

/// A value of an attribute.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value<'d> {
    Text(Cow<'d, str>),
    Number(f64),
    Integer(u32),
    Pair([f64; 2]),
    /// A point, a colour, channels or factors.
    Triple([f64; 3]),
    Corners(Box<[[f64; 3]; 4]>),
    Word(&'static str),
    Steps(Steps),
    Run(u32, u32),
}

type Read<'d> = Result<Value<'d>, Box<Diagnostic>>;

impl Kind {
    /// The value of a text, or what is wrong with it; `field` is the attribute's name.
    pub(super) fn read<'d>(self, field: &'static str, written: &Written<'d>) -> Read<'d> {
        const FAR: f64 = limits::COORDINATE;
        let within = |numbers: &[Number], min, max| in_range(field, numbers, min, max);
        Ok(match self {
            Kind::Version => return version(written),
            Kind::Text => Value::Text(on_one_line(written)),
            Kind::Name | Kind::MaterialName | Kind::Path => return name(written),
            Kind::Color => return color(field, written),
            Kind::Channels(min, max) => {
                let numbers = written.one_or_three()?;
                within(&numbers, min, max)?;
                triple(numbers)
            }
            Kind::Factors => {
                let numbers = written.one_or_three()?;
                within(&numbers, -FAR, FAR)?;
                triple(numbers)
            }
            Kind::Point => {
                let numbers = written.triple()?;
                within(&numbers, -FAR, FAR)?;
                triple(numbers)
            }
            Kind::Length => {
                let number = written.number()?;
                within(&[number], limits::LEAST, FAR)?;
                Value::Number(number.value)
            }
            Kind::Number(min, max) => {
                let number = written.number()?;
                within(&[number], min, max)?;
                Value::Number(number.value)
            }
            Kind::Integer(min, max) => {
                let number = written.number()?;
                if number.value.fract() != 0.0 {
                    return fault(number.span, ValueProblem::NotWhole { found: Excerpt::new(written.text.trim()) });
                }
                within(&[number], f64::from(min), f64::from(max))?;
                Value::Integer(number.value as u32)
            }
            Kind::Size => {
                let mut numbers = written.blank::<2>();
                written.fill(&mut numbers, Due::Two)?;
                within(&numbers, limits::LEAST, FAR)?;
                Value::Pair(numbers.map(|number| number.value))
            }
            Kind::Corners => {
                let mut numbers = written.blank::<12>();
                written.fill(&mut numbers, Due::Twelve)?;
                within(&numbers, -FAR, FAR)?;
                let corner = |from: usize| std::array::from_fn(|axis| numbers[from + axis].value);
                Value::Corners(Box::new([corner(0), corner(3), corner(6), corner(9)]))
            }
            Kind::Choice(legal) => Value::Word(word(legal, written.text.trim(), written.span)?),
            Kind::Steps => return steps(written),
            Kind::Run => return run(written),
        })
    }

    /// A value as the canonical layout writes it, without escapes.
    pub(super) fn write(self, value: &Value<'_>) -> String {
        let equal_as_one = match self {
            Kind::Color | Kind::Channels(..) | Kind::Factors => true,
            Kind::Version
            | Kind::Text
            | Kind::Name
            | Kind::MaterialName
            | Kind::Path
            | Kind::Point
            | Kind::Length
            | Kind::Number(..)
            | Kind::Integer(..)
            | Kind::Size
            | Kind::Corners
            | Kind::Choice(_)
            | Kind::Steps
            | Kind::Run => false,
        };
        match value {
            Value::Text(text) => text.clone().into_owned(),
            Value::Number(number) => shortest(*number),
            Value::Integer(number) => number.to_string(),
            Value::Pair(numbers) => in_a_row(numbers),
            Value::Triple([x, y, z]) if equal_as_one && x.to_bits() == y.to_bits() && y.to_bits() == z.to_bits() => {
                shortest(*x)
            }
            Value::Triple(numbers) => in_a_row(numbers),
            Value::Corners(corners) => corners.map(|corner| in_a_row(&corner)).join("  "),
            Value::Word(word) => (*word).to_owned(),
            Value::Steps(steps) => {
                let left_out = [!steps.shadows, !steps.reflection, !steps.transparency];
                let words: Vec<&str> =
                    STEPS.iter().zip(left_out).filter(|(_, out)| *out).map(|(word, _)| *word).collect();
                words.join(" ")
            }
            Value::Run(first, count) => format!("{first} {count}"),
        }
    }
}

/// Numbers with a blank between them.
pub(super) fn in_a_row(numbers: &[f64]) -> String {
    numbers.iter().map(|number| shortest(*number)).collect::<Vec<_>>().join(" ")
}

fn fault<T>(span: Span, problem: impl Into<crate::Problem>) -> Result<T, Box<Diagnostic>> {
    Err(Box::new(Diagnostic::error(span, problem)))
}

/// The first number outside the range.
pub(super) fn in_range(field: &'static str, numbers: &[Number], min: f64, max: f64) -> Result<(), Box<Diagnostic>> {
    match numbers.iter().find(|number| !(min..=max).contains(&number.value)) {
        None => Ok(()),
        Some(Number { value, span }) => fault(*span, Invalid::OutOfRange { field, value: *value, min, max }),
    }
}

fn triple<'d>(numbers: [Number; 3]) -> Value<'d> {
    Value::Triple(numbers.map(|number| number.value))
}

fn version<'d>(written: &Written<'d>) -> Read<'d> {
    match written.text.trim() {
        VERSION => Ok(Value::Integer(1)),
        other => fault(written.span, StructureProblem::BadVersion { found: Excerpt::new(other) }),
    }
}

/// The text with blanks for the tabs and line ends that stand in the source; those written as references stay.
fn on_one_line<'d>(written: &Written<'d>) -> Cow<'d, str> {
    if written.is_literal() && written.text.contains(['\t', '\n', '\r']) {
        Cow::Owned(written.text.replace("\r\n", " ").replace(['\t', '\n', '\r'], " "))
    } else {
        written.text.clone()
    }
}

/// A trimmed text that is not empty; names and paths hold no control characters.
fn name<'d>(written: &Written<'d>) -> Read<'d> {
    let name = match on_one_line(written) {
        Cow::Borrowed(text) => Cow::Borrowed(text.trim()),
        Cow::Owned(text) => Cow::Owned(text.trim().to_owned()),
    };
    if name.is_empty() {
        fault(written.span, ValueProblem::EmptyName)
    } else if name.chars().any(char::is_control) {
        fault(written.span, Invalid::BadName)
    } else {
        Ok(Value::Text(name))
    }
}

fn color<'d>(field: &'static str, written: &Written<'d>) -> Read<'d> {
    let text = written.text.trim();
    if let Some(digits) = text.strip_prefix('#') {
        let byte = |at: usize| u8::from_str_radix(digits.get(at..at + 2)?, 16).ok();
        let six = digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
        return match (byte(0), byte(2), byte(4)) {
            (Some(r), Some(g), Some(b)) if six => Ok(Value::Triple([r, g, b].map(|byte| f64::from(byte) / 255.0))),
            _ => fault(written.span, ValueProblem::NotAColor { found: Excerpt::new(text) }),
        };
    }
    let numbers = written.one_or_three()?;
    let values = numbers.map(|number| number.value);
    let bytes = values.map(|value| (value.fract() == 0.0 && (0.0..=255.0).contains(&value)).then_some(value as u8));
    if let ([Some(r), Some(g), Some(b)], true) = (bytes, values.iter().any(|value| *value >= 16.0)) {
        let suggestion = Excerpt::new(&format!("#{r:02x}{g:02x}{b:02x}"));
        return fault(written.span, ValueProblem::ColorInBytes { found: Excerpt::new(text), suggestion });
    }
    in_range(field, &numbers, 0.0, 1.0)?;
    Ok(Value::Triple(values))
}

fn word(legal: &'static [&'static str], found: &str, span: Span) -> Result<&'static str, Box<Diagnostic>> {
    match legal.iter().find(|word| **word == found) {
        Some(word) => Ok(word),
        None => {
            let guess = match (legal, found.to_lowercase().as_str()) {
                (["true", "false"], "1" | "yes" | "on" | "oui" | "vrai") => Guess(Some(Excerpt::new("true"))),
                (["true", "false"], "0" | "no" | "off" | "non" | "faux") => Guess(Some(Excerpt::new("false"))),
                _ => Guess::among(found, legal.iter().copied()),
            };
            fault(span, ValueProblem::NotOneOf { found: Excerpt::new(found), guess, legal })
        }
    }
}

fn steps<'d>(written: &Written<'d>) -> Read<'d> {
    let mut steps = Steps::default();
    let parted = |character: char| character.is_whitespace() || character == ',';
    for name in written.text.split(parted).filter(|name| !name.is_empty()) {
        let start = name.as_ptr() as usize - written.text.as_ptr() as usize;
        match word(STEPS, name, written.place(start, start + name.len()))? {
            "shadows" => steps.shadows = false,
            "reflection" => steps.reflection = false,
            _ => steps.transparency = false,
        }
    }
    Ok(Value::Steps(steps))
}

fn run<'d>(written: &Written<'d>) -> Read<'d> {
    let mut numbers = written.numbers();
    let (mut found, mut count) = ([0; 2], 0);
    while let Some(number) = numbers.next_index() {
        let (number, _) = number?;
        if let Some(place) = found.get_mut(count) {
            *place = number;
        }
        count += 1;
    }
    match count {
        2 => Ok(Value::Run(found[0], found[1])),
        _ => Err(written.miscounted(count, Due::Two)),
    }
}
