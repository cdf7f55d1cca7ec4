//! Numbers as they are written in documents: `[+-]digits[.digits][e±digits]`, parted by white space or one comma with
//! white space around it, and nothing else. Both XML readers use it.

use super::document::{Attribute, Text};
use super::reference::is_blank;
use super::{Due, Excerpt, ValueProblem};
use crate::{Diagnostic, Span};
use lancer_scene::Invalid;
use std::borrow::Cow;

/// A text and its place: an attribute's value or an element's text.
#[derive(Clone, Debug)]
pub struct Written<'d> {
    /// What is meant, references resolved.
    pub text: Cow<'d, str>,
    /// Where it stands.
    pub span: Span,
    /// Whether every byte of the text stands in the source at its own place.
    literal: bool,
}

impl<'d> Attribute<'d> {
    /// The value and its place.
    pub fn written(&self) -> Written<'d> {
        // Line ends and tabs part numbers as blanks do, so only references need another text.
        let literal = !self.raw.contains('&');
        let text = if literal { Cow::Borrowed(self.raw) } else { self.value() };
        Written { text, span: self.value_span, literal }
    }
}

impl<'d> Text<'d> {
    /// The text and its place.
    pub fn written(&self) -> Written<'d> {
        let literal = !self.raw.contains('&');
        let text = if literal { Cow::Borrowed(self.raw) } else { self.value() };
        Written { text, span: self.span, literal }
    }
}

/// Faults of one value or list that are told: one in another notation would give a fault for every number.
pub(super) const MOST_FAULTS: usize = 5;

/// A number and its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number {
    /// The value, always finite.
    pub value: f64,
    /// Where it stands.
    pub span: Span,
}

impl<'d> Written<'d> {
    /// A text that stands in no document, such as a default.
    pub(super) fn new(text: &'d str) -> Written<'d> {
        Written { text: Cow::Borrowed(text), span: Span { start: 0, end: text.len() }, literal: true }
    }

    /// The numbers in turn, and the faults between them.
    pub fn numbers(&self) -> Numbers<'_> {
        Numbers { written: self, at: 0, after_comma: false, begun: false }
    }

    /// Exactly one number.
    ///
    /// # Errors
    /// What is no number, or how many there are instead of one.
    pub fn number(&self) -> Result<Number, Box<Diagnostic>> {
        let ([number], _) = self.counted(Due::One, |_| None).map_err(|mut faults| Box::new(faults.swap_remove(0)))?;
        Ok(number)
    }

    /// As many numbers as are due, of which there is room for `N`, and how many; or everything that is wrong with them:
    /// what is no number, what a rule says of each, or their count. There is at least one fault then.
    pub(super) fn counted<const N: usize>(
        &self,
        due: Due,
        rule: impl Fn(f64) -> Option<Invalid>,
    ) -> Result<([Number; N], usize), Vec<Diagnostic>> {
        let mut found = [Number { value: 0.0, span: self.span }; N];
        let (mut count, mut faults, mut broken) = (0, Vec::new(), Vec::new());
        for number in self.numbers() {
            match number {
                Ok(number) => {
                    if let Some(place) = found.get_mut(count) {
                        *place = number;
                        broken.extend(rule(number.value).map(|rule| Diagnostic::error(number.span, rule)));
                    }
                }
                Err(fault) if faults.len() < MOST_FAULTS => faults.push(*fault),
                Err(_) => {}
            }
            count += 1;
        }
        if due.is_met_by(count) {
            faults.append(&mut broken);
        } else if faults.is_empty() {
            faults.push(*self.miscounted(count, due));
        }
        if faults.is_empty() { Ok((found, count)) } else { Err(faults) }
    }

    /// The fault of a wrong count of numbers. If the count is legal once commas between digits are read as decimal ones,
    /// that is the fault.
    pub(super) fn miscounted(&self, found: usize, due: Due) -> Box<Diagnostic> {
        if let Some((start, end)) = self.decimal_comma(due) {
            let numbers = &self.text[start..end];
            let parts: Vec<&str> = numbers.split(',').collect();
            let suggestion = parts.chunks(2).map(|number| number.join(".")).collect::<Vec<_>>().join(" ");
            let (found, suggestion) = (Excerpt::new(numbers), Excerpt::new(&suggestion));
            let problem = ValueProblem::DecimalComma { found, suggestion };
            return Box::new(Diagnostic::error(self.place(start, end), problem));
        }
        Box::new(Diagnostic::error(self.span, ValueProblem::NumberCount { found, due }))
    }

    /// The first numbers with decimal commas, such as `0,5` or `0,2,0,3`, if as many numbers as are due stand there once
    /// every second comma between two blanks is read as a decimal one.
    fn decimal_comma(&self, due: Due) -> Option<(usize, usize)> {
        let (mut count, mut first) = (0, None);
        for token in self.text.split(|character: char| u8::try_from(character).is_ok_and(is_blank)) {
            let token = token.trim_matches(',');
            let digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit()) && !part.is_empty();
            let parts = token.split(',').count();
            if parts == 1 {
                count += usize::from(!token.is_empty());
            } else if parts % 2 == 0 && token.split(',').skip(1).step_by(2).all(digits) {
                let start = token.as_ptr() as usize - self.text.as_ptr() as usize;
                first = first.or(Some((start, start + token.len())));
                count += parts / 2;
            } else {
                return None;
            }
        }
        first.filter(|_| due.is_met_by(count))
    }

    /// Whether the text is the source's own: line ends and tabs in it are not yet blanks.
    pub(super) fn is_literal(&self) -> bool {
        self.literal
    }

    /// The place in the source of a stretch of the text.
    pub(super) fn place(&self, start: usize, end: usize) -> Span {
        if self.literal { Span { start: self.span.start + start, end: self.span.start + end } } else { self.span }
    }
}

/// The numbers of a text, in turn. Nothing is allocated but for a fault.
#[derive(Clone, Debug)]
pub struct Numbers<'w> {
    written: &'w Written<'w>,
    at: usize,
    after_comma: bool,
    begun: bool,
}

impl Numbers<'_> {
    /// The place of the next token, or a fault; `None` at the end.
    pub(super) fn token(&mut self) -> Option<Result<(usize, usize), Box<Diagnostic>>> {
        let bytes = self.written.text.as_bytes();
        loop {
            while bytes.get(self.at).is_some_and(|&byte| is_blank(byte)) {
                self.at += 1;
            }
            match bytes.get(self.at) {
                Some(b',') if self.after_comma || !self.begun => {
                    (self.begun, self.after_comma, self.at) = (true, true, self.at + 1);
                    return Some(self.stray_comma(self.at - 1));
                }
                Some(b',') => {
                    self.after_comma = true;
                    self.at += 1;
                }
                None if self.after_comma => {
                    self.after_comma = false;
                    let comma = bytes.iter().rposition(|&byte| byte == b',').unwrap_or_default();
                    return Some(self.stray_comma(comma));
                }
                None => return None,
                Some(_) => break,
            }
        }
        let start = self.at;
        while bytes.get(self.at).is_some_and(|&byte| !is_blank(byte) && byte != b',') {
            self.at += 1;
        }
        (self.begun, self.after_comma) = (true, false);
        Some(Ok((start, self.at)))
    }

    fn stray_comma(&self, at: usize) -> Result<(usize, usize), Box<Diagnostic>> {
        self.fault(at, at + 1, ValueProblem::StrayComma)
    }

    /// A fault at a token.
    fn fault<T>(&self, start: usize, end: usize, problem: ValueProblem) -> Result<T, Box<Diagnostic>> {
        Err(Box::new(Diagnostic::error(self.written.place(start, end), problem)))
    }

    /// The next number, which must be a whole one from 0 to `u32::MAX`: `None` at the end.
    pub(super) fn next_index(&mut self) -> Option<Result<(u32, Span), Box<Diagnostic>>> {
        let (start, end) = match self.token()? {
            Ok(token) => token,
            Err(fault) => return Some(Err(fault)),
        };
        let token = &self.written.text[start..end];
        if token.bytes().all(|byte| byte.is_ascii_digit())
            && let Ok(index) = token.parse()
        {
            return Some(Ok((index, self.written.place(start, end))));
        }
        let found = Excerpt::new(token);
        let problem = match parse(token) {
            // a sign has no business here, not even that of -0
            Some(value) if value.fract() == 0.0 && value <= f64::from(u32::MAX) && !token.contains('-') => {
                return Some(Ok((value as u32, self.written.place(start, end))));
            }
            Some(_) => ValueProblem::NotWhole { found },
            None => not_a_number(token),
        };
        Some(self.fault(start, end, problem))
    }
}

impl Iterator for Numbers<'_> {
    type Item = Result<Number, Box<Diagnostic>>;

    fn next(&mut self) -> Option<Self::Item> {
        let (start, end) = match self.token()? {
            Ok(token) => token,
            Err(fault) => return Some(Err(fault)),
        };
        let token = &self.written.text[start..end];
        Some(match parse(token) {
            Some(value) if value.is_finite() => Ok(Number { value, span: self.written.place(start, end) }),
            Some(_) => self.fault(start, end, ValueProblem::TooLarge { found: Excerpt::new(token) }),
            None => self.fault(start, end, not_a_number(token)),
        })
    }
}

/// The value of a token that follows the grammar; infinite where it is too large for a double.
fn parse(token: &str) -> Option<f64> {
    let digits = |bytes: &[u8]| bytes.iter().position(|byte| !byte.is_ascii_digit()).unwrap_or(bytes.len());
    let signed = |bytes: &[u8]| usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let bytes = token.as_bytes();
    let mut at = signed(bytes);
    for lead in [None, Some(b"..".as_slice()), Some(b"eE")] {
        match lead {
            Some(lead) if !bytes.get(at).is_some_and(|byte| lead.contains(byte)) => continue,
            Some(lead) => at += 1 + if lead == b"eE" { signed(&bytes[at + 1..]) } else { 0 },
            None => {}
        }
        let length = digits(&bytes[at..]);
        if length == 0 {
            return None;
        }
        at += length;
    }
    if at == bytes.len() { token.parse().ok() } else { None }
}

/// What to say of a token that is no number: the number that was probably meant, if a small change makes one.
fn not_a_number(token: &str) -> ValueProblem {
    let found = Excerpt::new(token);
    let plain: String = token.chars().take(64).filter(|character| !matches!(character, '_' | '\'')).collect();
    let plain = plain.trim_end_matches(['f', 'd', '%', '°', ';']).replace('−', "-");
    let (sign, size) = plain.split_at(usize::from(plain.starts_with(['+', '-'])));
    let (mantissa, exponent) = size.split_at(size.find(['e', 'E']).unwrap_or(size.len()));
    let zero = if mantissa.starts_with('.') && mantissa.len() > 1 { "0" } else { "" };
    let meant = format!("{sign}{zero}{}{exponent}", mantissa.trim_end_matches('.'));
    if parse(&meant).is_some_and(f64::is_finite) {
        ValueProblem::NumberForm { found, suggestion: Excerpt::new(&meant) }
    } else {
        ValueProblem::NotANumber { found }
    }
}

/// A number as documents write it: the shortest decimal that reads back as the same double.
pub fn shortest(value: f64) -> String {
    let text = format!("{value:?}");
    match text.strip_suffix(".0") {
        Some(whole) => whole.to_owned(),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Describe;
    use proptest::prelude::*;

    fn written(text: &str) -> Written<'_> {
        Written { span: Span { start: 100, end: 100 + text.len() }, ..Written::new(text) }
    }

    fn values(text: &str) -> Result<Vec<f64>, (&'static str, Span)> {
        written(text)
            .numbers()
            .map(|number| number.map(|number| number.value))
            .collect::<Result<_, _>>()
            .map_err(|fault| (fault.problem.code(), fault.span.unwrap()))
    }

    #[test]
    fn numbers_are_parted_by_blanks_or_one_comma() {
        for text in ["1 2 3", "1,2,3", " 1 , 2\n,\t3 ", "1, 2 3", "+1 2.0 3e0", "1 20e-1 0.3E+1"] {
            assert_eq!(values(text).unwrap(), [1.0, 2.0, 3.0], "{text}");
        }
        assert_eq!(values(" ").unwrap(), [0.0; 0]);
        for (text, start) in [(",1", 0), ("1,,2", 2), ("1 , ,2", 4), ("1,", 1), ("1 2 , ", 4)] {
            let span = Span { start: 100 + start, end: 101 + start };
            assert_eq!(values(text), Err(("xml::stray-comma", span)), "{text}");
        }
    }

    #[test]
    fn nothing_else_is_a_number() {
        for (text, meant) in [
            ("nan", None),
            ("inf", None),
            ("-Infinity", None),
            ("0x10", None),
            ("1e", None),
            ("1e+", None),
            ("-", None),
            (".", None),
            ("1.2.3", None),
            ("1-2", None),
            ("½", None),
            ("１", None),
            (".5", Some("0.5")),
            ("-.5e3", Some("-0.5e3")),
            ("5.", Some("5")),
            ("1_000", Some("1000")),
            ("0.5f", Some("0.5")),
            ("−2", Some("-2")),
        ] {
            let fault = written(text).number().unwrap_err();
            let found = Excerpt::new(text);
            let expected = match meant {
                None => ValueProblem::NotANumber { found },
                Some(meant) => ValueProblem::NumberForm { found, suggestion: Excerpt::new(meant) },
            };
            assert_eq!(fault.problem, expected.into(), "{text}");
        }
        assert_eq!(values("1e999").unwrap_err().0, "xml::too-large-number");
        assert_eq!(values("1e-999").unwrap(), [0.0]);
    }

    #[test]
    fn a_decimal_comma_is_seen() {
        let comma = |fault: Box<Diagnostic>| {
            let crate::Problem::Xml(crate::xml::XmlProblem::Value(problem)) = fault.problem else { return None };
            let ValueProblem::DecimalComma { suggestion, .. } = problem else { return None };
            Some((suggestion.to_string(), fault.span.unwrap()))
        };
        let one = comma(written("0,5").number().unwrap_err()).unwrap();
        assert_eq!(one, ("0.5".to_owned(), Span { start: 100, end: 103 }));
        let of = |text: &str, due| comma(Box::new(written(text).counted::<3>(due, |_| None).err()?.swap_remove(0)));
        for (text, due, meant) in [
            ("0,25 2,5 3", Due::Three, Some(("0.25", 4))),
            ("0,5", Due::OneOrThree, Some(("0.5", 3))),
            ("0,2,0,3,0,4", Due::OneOrThree, Some(("0.2 0.3 0.4", 11))),
            ("0,2, 0,3, 0,4", Due::Three, Some(("0.2", 3))),
            ("0,5,1", Due::OneOrThree, None),
            ("0, 5", Due::One, None),
            ("1,2,3", Due::One, None),
            ("1,-5", Due::One, None),
            ("0,5 0,5", Due::Three, None),
        ] {
            let meant = meant.map(|(meant, length)| (meant.to_owned(), Span { start: 100, end: 100 + length }));
            assert_eq!(of(text, due), meant, "{text}");
        }
    }

    /// Everything that is wrong with a value is told at once, in the order of the text, and a few of very many.
    #[test]
    fn every_fault_of_a_value_is_told() {
        let negative = |value: f64| (value < 0.0).then_some(Invalid::Collinear);
        let faults = |text: &str, due| -> Vec<(&'static str, usize)> {
            let faults = written(text).counted::<3>(due, negative).unwrap_err();
            faults.iter().map(|fault| (fault.problem.code(), fault.span.unwrap().start - 100)).collect()
        };
        assert_eq!(faults(".5 x 5.", Due::Three).len(), 3);
        assert_eq!(faults("x -1 2", Due::Three), [("xml::not-a-number", 0), ("rule::collinear", 2)]);
        assert_eq!(faults("1,,-2,", Due::Three), [("xml::stray-comma", 2), ("xml::stray-comma", 5)]);
        assert_eq!(faults("x -1", Due::Three), [("xml::not-a-number", 0)]);
        assert_eq!(faults("-1 -1", Due::Three), [("xml::number-count", 0)]);
        assert_eq!(faults(&"x ".repeat(1000), Due::Three).len(), MOST_FAULTS);
    }

    #[test]
    fn whole_numbers() {
        let list = written("0, 7 4294967295 3.0 1e3");
        let mut numbers = list.numbers();
        let indices: Vec<u32> = std::iter::from_fn(|| numbers.next_index()).map(|index| index.unwrap().0).collect();
        assert_eq!(indices, [0, 7, u32::MAX, 3, 1000]);
        for text in ["-1", "-0", "1.5", "4294967296", "x"] {
            assert!(written(text).numbers().next_index().unwrap().is_err(), "{text}");
        }
    }

    #[test]
    fn the_shortest_text() {
        for (value, text) in
            [(1.0, "1"), (0.1, "0.1"), (-0.0, "-0"), (1e-9, "1e-9"), (1e9, "1000000000"), (0.001, "0.001")]
        {
            assert_eq!(shortest(value), text);
        }
    }

    proptest! {
        #[test]
        fn what_is_written_reads_back(value in any::<f64>().prop_filter("finite", |value| value.is_finite())) {
            let text = shortest(value);
            let read = written(&text).number().unwrap().value;
            prop_assert_eq!(read.to_bits(), value.to_bits());
        }

        #[test]
        fn any_text_is_read_or_refused(text in "[-+0-9.,eE x_\\n]{0,12}") {
            let tokens: Vec<&str> = text.split([' ', '\n', ',']).filter(|token| !token.is_empty()).collect();
            if let Ok(values) = values(&text) {
                let expected: Vec<f64> = tokens.iter().map(|token| token.parse().unwrap()).collect();
                prop_assert_eq!(values, expected);
            }
        }
    }
}
