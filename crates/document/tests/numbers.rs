//! Arithmetic in number fields: values that anybody can check, and every refusal with its sentence.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use lancer_document::number::{NumberError, evaluate};
use lancer_words::Lang;
use proptest::prelude::*;
use std::f64::consts::PI;

fn is(text: &str, value: f64) {
    assert_eq!(evaluate(text, 4.0), Ok(value), "{text}");
}

#[test]
fn numbers_are_themselves() {
    is("0", 0.0);
    is(" 12 ", 12.0);
    is("-0.5", -0.5);
    is("+2.5e-3", 0.0025);
    is("1E3", 1000.0);
    is(".5", 0.5);
    is("5.", 5.0);
}

#[test]
fn precedence_is_that_of_mathematics() {
    is("1+2*3", 7.0);
    is("(1+2)*3", 9.0);
    is("10-4-3", 3.0);
    is("24/4/2", 3.0);
    is("2^3^2", 512.0);
    is("-2^2", -4.0);
    is("(-2)^2", 4.0);
    is("2^-1", 0.5);
    is("2*-3", -6.0);
    is("--3", 3.0);
    is("1/3", 1.0 / 3.0);
    is("2*pi", 2.0 * PI);
    is("2 * π", 2.0 * PI);
}

#[test]
fn functions_take_degrees() {
    is("sqrt(2)", 2.0_f64.sqrt());
    is("SQRT(16)", 4.0);
    is("abs(-3)", 3.0);
    is("sin(30)", 0.5);
    is("cos(60)", 0.5);
    is("sin(90)+cos(180)", 0.0);
    is("cos(90)", 0.0);
    is("sin(-30)", -0.5);
    is("sin(750)", 0.5);
    let near = |text: &str, value: f64| {
        let found = evaluate(text, 0.0).unwrap();
        assert!((found - value).abs() < 1e-12, "{text}: {found}");
    };
    near("tan(45)", 1.0);
    near("asin(0.5)", 30.0);
    near("acos(-1)", 180.0);
    near("atan(1)", 45.0);
    near("sin(20)^2 + cos(20)^2", 1.0);
}

#[test]
fn a_sign_before_an_equals_is_relative_to_the_old_value() {
    is("+=2", 6.0);
    is("-= 1", 3.0);
    is("*=2+1", 12.0);
    is("/=8", 0.5);
    is("-=-1", 5.0);
    is("-1", -1.0);
}

#[test]
fn every_refusal_says_what_to_do() {
    let says = |text: &str, english: &str, french: &str| {
        let error = evaluate(text, 1.0).unwrap_err();
        assert_eq!(error.text(Lang::English), english, "{text}");
        assert_eq!(error.text(Lang::French), french, "{text}");
    };
    says("", "write a number, such as 0.5 or 1/3", "écrivez un nombre, par exemple 0.5 ou 1/3");
    says("0,5", "decimal comma? write `0.5`", "virgule décimale ? écrivez « 0.5 »");
    says("1,5*2,5", "decimal comma? write `1.5*2.5`", "virgule décimale ? écrivez « 1.5*2.5 »");
    says("1,", "decimal comma? write `1.`", "virgule décimale ? écrivez « 1. »");
    says("(1,,2)", "`,` has no place there (character 3)", "« , » n'a pas sa place ici (caractère 3)");
    says("1+", "something is missing at the end", "il manque quelque chose à la fin");
    says("+=", "something is missing at the end", "il manque quelque chose à la fin");
    says("(1", "a parenthesis is not closed: write `)`", "une parenthèse n'est pas fermée : écrivez « ) »");
    says("1)", "`)` has no place there (character 2)", "« ) » n'a pas sa place ici (caractère 2)");
    says("  2 3", "`3` has no place there (character 5)", "« 3 » n'a pas sa place ici (caractère 5)");
    says("2é", "`é` has no place there (character 2)", "« é » n'a pas sa place ici (caractère 2)");
    let known = "pi, sqrt, abs, sin, cos, tan, asin, acos, atan";
    says(
        "log(2)",
        &format!("`log` is not known; known: {known}"),
        &format!("« log » est inconnu ; sont connus : {known}"),
    );
    says(
        "1/0",
        "this is no finite number: a division by 0, or a root of a negative number",
        "ce n'est pas un nombre fini : une division par 0, ou la racine d'un nombre négatif",
    );
    for text in ["sqrt(-1)", "1e999", "tan(90)", "(-8)^0.5", "asin(2)", "10^400"] {
        assert_eq!(evaluate(text, 1.0), Err(NumberError::NotFinite), "{text}");
    }
    says("sqrt 2", "`2` has no place there (character 6)", "« 2 » n'a pas sa place ici (caractère 6)");
    says(
        "nan",
        &format!("`nan` is not known; known: {known}"),
        &format!("« nan » est inconnu ; sont connus : {known}"),
    );
    says("1__0", "`_` has no place there (character 2)", "« _ » n'a pas sa place ici (caractère 2)");
}

#[test]
fn depth_and_length_are_bounded() {
    let nested = |depth: usize| format!("{}1{}", "(".repeat(depth), ")".repeat(depth));
    assert_eq!(evaluate(&nested(60), 0.0), Ok(1.0));
    for text in [nested(65), "-".repeat(70) + "1", "2^".repeat(70) + "1", "1+".repeat(600) + "1"] {
        assert_eq!(evaluate(&text, 0.0), Err(NumberError::TooDeep));
    }
    assert_eq!(NumberError::TooDeep.text(Lang::English), "too long or too deeply nested: write it shorter");
}

proptest! {
    #[test]
    fn any_text_gives_a_finite_number_or_a_reason(text in "[0-9.,()+*/^ esqrtpixπ-]{0,30}", old in -1e9..1e9_f64) {
        match evaluate(&text, old) {
            Ok(value) => prop_assert!(value.is_finite()),
            Err(error) => prop_assert!(!error.text(Lang::French).is_empty()),
        }
    }

    #[test]
    fn anything_at_all_is_survived(text in any::<String>()) {
        let _ = evaluate(&text, 1.0);
    }

    /// Every number as Rust writes it is read as itself.
    #[test]
    fn written_numbers_are_read_back(value in -1e12..1e12_f64) {
        prop_assert_eq!(evaluate(&value.to_string(), 0.0), Ok(value));
        prop_assert_eq!(evaluate(&format!("{value:e}"), 0.0), Ok(value));
    }
}
