//! Short decimals for numbers that a pointer chose: nobody wants to read 0.42000000000000004 in a document.

use lancer_scene::DVec3;

/// The decimal places after which nothing as large as `unit` is lost: 2 for 0.01 to 0.0999.
pub(crate) fn places(unit: f64) -> i32 {
    let places = -libm::floor(libm::log10(unit));
    // 10 to the power 22 is the last one that a double holds exactly
    places.clamp(-22.0, 22.0) as i32
}

/// The multiple of `10^-places` nearest to the value, which prints as a short decimal.
pub(crate) fn rounded(value: f64, places: i32) -> f64 {
    let power = 10.0_f64.powi(places.abs());
    // a quotient of two whole numbers is the double nearest to the decimal; a product would not be
    let rounded = if places >= 0 { (value * power).round() / power } else { (value / power).round() * power };
    // adding zero makes -0 a 0
    if rounded.is_finite() { rounded + 0.0 } else { value }
}

/// Every coordinate rounded.
pub(crate) fn rounded_point(point: DVec3, places: i32) -> DVec3 {
    DVec3::from(point.to_array().map(|coordinate| rounded(coordinate, places)))
}

/// `value + by` without the last digits that only rounding made; the value itself where `by` is 0.
pub(crate) fn sum(value: f64, by: f64) -> f64 {
    let sum = value + by;
    if by == 0.0 || sum == 0.0 { sum } else { rounded(sum, places(value.abs().max(by.abs()) * 1e-13)) }
}

/// [`sum`] of every coordinate.
pub(crate) fn sum_point(point: DVec3, by: DVec3) -> DVec3 {
    DVec3::new(sum(point.x, by.x), sum(point.y, by.y), sum(point.z, by.z))
}

/// The largest of 1, 2 and 5 times a power of ten that is not above the value; 1 for what is not positive and finite.
pub(crate) fn round_length(value: f64) -> f64 {
    if !(value.is_finite() && value > 0.0) {
        return 1.0;
    }
    let places = places(value);
    let power = rounded(10.0_f64.powi(-places), places);
    // a little leeway, so that 0.999… of a step counts as the step
    let factor = [5.0, 2.0].into_iter().find(|factor| value >= factor * power * (1.0 - 1e-9)).unwrap_or(1.0);
    rounded(factor * power, places)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounded_numbers_print_short() {
        assert_eq!(rounded(0.1 + 0.2, 3).to_string(), "0.3");
        assert_eq!(rounded(-0.0004, 3).to_string(), "0");
        assert_eq!(rounded(12_345.0, -2), 12_300.0);
        assert_eq!(sum(0.3, 0.12).to_string(), "0.42");
        assert_eq!(sum(1.1, 2.2).to_string(), "3.3");
        assert_eq!(sum(0.1, -0.1), 0.0);
        let exact = 1.0 / 3.0;
        assert_eq!(sum(exact, 0.0), exact);
        assert!((sum(exact, 1e-7) - (exact + 1e-7)).abs() < 1e-12);
    }

    #[test]
    fn lengths_are_rounded_down_to_one_two_and_five() {
        for (value, length) in [(1.0, 1.0), (1.99, 1.0), (2.0, 2.0), (0.49, 0.2), (0.5, 0.5), (9.0, 5.0), (70.0, 50.0)]
        {
            assert_eq!(round_length(value), length, "{value}");
        }
        assert_eq!(round_length(0.0), 1.0);
        assert_eq!(round_length(f64::NAN), 1.0);
    }
}
