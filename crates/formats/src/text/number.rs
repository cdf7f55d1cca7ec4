//! Numbers as a person reads them.

use crate::xml::shortest;

/// The length up to which the exact number is shown.
const SHORT: usize = 8;

/// The exact decimal where it is short, else six significant digits (or all before the point): `0.2`, `0.333333`,
/// `1234567.891` as `1234568`, `1e-9`.
pub(super) fn shown(value: f64) -> String {
    // Adding zero makes -0 a plain 0.
    let exact = shortest(value + 0.0);
    if exact.trim_start_matches('-').len() <= SHORT { exact } else { rounded(value, 6) }
}

/// The number with so many significant digits, or with all before the point.
pub(super) fn rounded(value: f64, digits: usize) -> String {
    let magnitude = value.abs().log10().floor();
    if value == 0.0 || !value.is_finite() {
        return shortest(value + 0.0);
    }
    if !(-5.0..15.0).contains(&magnitude) {
        let scientific = format!("{value:.*e}", digits - 1);
        let (mantissa, exponent) = scientific.split_at(scientific.find('e').unwrap_or(scientific.len()));
        return format!("{}{exponent}", without_zeros(mantissa));
    }
    let decimals = (digits as f64 - 1.0 - magnitude).max(0.0) as usize;
    without_zeros(&format!("{value:.decimals$}")).to_owned()
}

/// A decimal without zeros that mean nothing.
fn without_zeros(decimal: &str) -> &str {
    if decimal.contains('.') { decimal.trim_end_matches('0').trim_end_matches('.') } else { decimal }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_exact_where_short_and_round_elsewhere() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (0.2, "0.2"),
            (-12.5, "-12.5"),
            (1.0 / 3.0, "0.333333"),
            (-200.0 / 3.0, "-66.6667"),
            (51.0 / 255.0, "0.2"),
            (52.0 / 255.0, "0.203922"),
            (0.1 + 0.2, "0.3"),
            (1_234_567.891, "1234568"),
            (999_999.999_9, "1000000"),
            (1e9, "1000000000"),
            (1e-9, "1e-9"),
            (1.23456789e-7, "1.23457e-7"),
            (0.000_123_456_789, "0.000123457"),
        ] {
            assert_eq!(shown(value), text);
        }
    }

    #[test]
    fn fewer_digits_still_keep_those_before_the_point() {
        let four = [0.0, -0.327_927, 2.490_47, 1234.5, 12345.6, 1.0, 1.5e-7].map(|value| rounded(value, 4));
        assert_eq!(four, ["0", "-0.3279", "2.49", "1234", "12346", "1", "1.5e-7"]);
    }
}
