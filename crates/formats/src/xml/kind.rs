//! The types of the vocabulary: how a value of each is read from a document and how it is written into one.

use super::number::MOST_FAULTS;
use super::reference::is_blank;
use super::vocabulary::{Kind, STEPS, VERSION};
use super::{Due, Excerpt, Guess, StructureProblem, ValueProblem, Written, shortest};
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

/// The value, or everything that is wrong with it.
type Read<'d> = Result<Value<'d>, Vec<Diagnostic>>;

impl Kind {
    /// The value of a text, or what is wrong with it; `field` is the attribute's name.
    pub(super) fn read<'d>(self, field: &'static str, written: &Written<'d>) -> Read<'d> {
        const FAR: f64 = limits::COORDINATE;
        let triple = |due, min, max| {
            let (numbers, count) = written.counted::<3>(due, in_range(field, min, max))?;
            let numbers = numbers.map(|number| number.value);
            Ok(Value::Triple(if count == 1 { [numbers[0]; 3] } else { numbers }))
        };
        let one = |min, max| {
            let ([number], _) = written.counted(Due::One, in_range(field, min, max))?;
            Ok(Value::Number(number.value))
        };
        match self {
            Kind::Version => version(written),
            Kind::Text => Ok(Value::Text(on_one_line(written))),
            Kind::Name | Kind::MaterialName | Kind::Path => name(written),
            Kind::Color => color(field, written),
            Kind::Channels(min, max) => triple(Due::OneOrThree, min, max),
            Kind::Factors => triple(Due::OneOrThree, -FAR, FAR),
            Kind::Point => triple(Due::Three, -FAR, FAR),
            Kind::Length => one(limits::LEAST, FAR),
            Kind::Number(min, max) => one(min, max),
            Kind::Integer(min, max) => {
                let ([number], _) = written.counted(Due::One, |_| None)?;
                if number.value.fract() != 0.0 {
                    return fault(number.span, ValueProblem::NotWhole { found: Excerpt::new(written.text.trim()) });
                }
                match in_range(field, f64::from(min), f64::from(max))(number.value) {
                    None => Ok(Value::Integer(number.value as u32)),
                    Some(rule) => fault(number.span, rule),
                }
            }
            Kind::Size => {
                let (numbers, _) = written.counted::<2>(Due::Two, in_range(field, limits::LEAST, FAR))?;
                Ok(Value::Pair(numbers.map(|number| number.value)))
            }
            Kind::Corners => {
                let (numbers, _) = written.counted::<12>(Due::Twelve, in_range(field, -FAR, FAR))?;
                let corner = |from: usize| std::array::from_fn(|axis| numbers[from + axis].value);
                Ok(Value::Corners(Box::new([corner(0), corner(3), corner(6), corner(9)])))
            }
            Kind::Choice(legal) => word(legal, trimmed(&written.text), written.span).map(Value::Word),
            Kind::Steps => steps(written),
            Kind::Run => run(written),
        }
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

fn fault<T>(span: Span, problem: impl Into<crate::Problem>) -> Result<T, Vec<Diagnostic>> {
    Err(vec![Diagnostic::error(span, problem)])
}

/// The rule that a number lies within a range.
fn in_range(field: &'static str, min: f64, max: f64) -> impl Fn(f64) -> Option<Invalid> {
    move |value| (!(min..=max).contains(&value)).then_some(Invalid::OutOfRange { field, value, min, max })
}

/// A text without XML's white space around it; other blanks separate no values either.
fn trimmed(text: &str) -> &str {
    text.trim_matches(|character| u8::try_from(character).is_ok_and(is_blank))
}

fn version<'d>(written: &Written<'d>) -> Read<'d> {
    match trimmed(&written.text) {
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
    let text = trimmed(&written.text);
    if let Some(digits) = text.strip_prefix('#') {
        let byte = |at: usize| u8::from_str_radix(digits.get(at..at + 2)?, 16).ok();
        let six = digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
        return match (byte(0), byte(2), byte(4)) {
            (Some(r), Some(g), Some(b)) if six => Ok(Value::Triple([r, g, b].map(|byte| f64::from(byte) / 255.0))),
            _ => fault(written.span, ValueProblem::NotAColor { found: Excerpt::new(text) }),
        };
    }
    // The names of colours are none of ours, and "no number" would not say what is due.
    if text.starts_with(|first: char| first.is_alphabetic()) {
        return fault(written.span, ValueProblem::NotAColor { found: Excerpt::new(text) });
    }
    let one_or_three = |rule: &dyn Fn(f64) -> Option<Invalid>| {
        let (numbers, count) = written.counted::<3>(Due::OneOrThree, rule)?;
        let values = numbers.map(|number| number.value);
        Ok(if count == 1 { [values[0]; 3] } else { values })
    };
    let bytes = |values: [f64; 3]| {
        let byte = |value: f64| (value.fract() == 0.0 && (0.0..=255.0).contains(&value)).then_some(value as u8);
        match values.map(byte) {
            [Some(r), Some(g), Some(b)] if values.iter().any(|value| *value >= 16.0) => Some([r, g, b]),
            _ => None,
        }
    };
    let whole = |faults: Vec<Diagnostic>| match one_or_three(&|_| None).ok().and_then(bytes) {
        Some([r, g, b]) => {
            let suggestion = Excerpt::new(&format!("#{r:02x}{g:02x}{b:02x}"));
            let problem = ValueProblem::ColorInBytes { found: Excerpt::new(text), suggestion };
            vec![Diagnostic::error(written.span, problem)]
        }
        None => faults,
    };
    one_or_three(&in_range(field, 0.0, 1.0)).map(Value::Triple).map_err(whole)
}

fn word(legal: &'static [&'static str], found: &str, span: Span) -> Result<&'static str, Vec<Diagnostic>> {
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
    let (mut steps, mut faults) = (Steps::default(), Vec::new());
    let mut tokens = written.numbers();
    while let Some(token) = tokens.token() {
        let found = match token {
            Ok((start, end)) => word(STEPS, &written.text[start..end], written.place(start, end)),
            Err(fault) => Err(vec![*fault]),
        };
        match found {
            Ok("shadows") => steps.shadows = false,
            Ok("reflection") => steps.reflection = false,
            Ok(_) => steps.transparency = false,
            Err(_) if faults.len() >= MOST_FAULTS => {}
            Err(fault) => faults.extend(fault),
        }
    }
    if faults.is_empty() { Ok(Value::Steps(steps)) } else { Err(faults) }
}

fn run<'d>(written: &Written<'d>) -> Read<'d> {
    let mut numbers = written.numbers();
    let (mut found, mut count, mut faults) = ([0; 2], 0, Vec::new());
    while let Some(number) = numbers.next_index() {
        match (number, found.get_mut(count)) {
            (Ok((number, _)), Some(place)) => *place = number,
            (Err(fault), _) if faults.len() < MOST_FAULTS => faults.push(*fault),
            (Ok(_) | Err(_), _) => {}
        }
        count += 1;
    }
    match count {
        _ if !faults.is_empty() => Err(faults),
        2 => Ok(Value::Run(found[0], found[1])),
        _ => Err(vec![*written.miscounted(count, Due::Two)]),
    }
}
