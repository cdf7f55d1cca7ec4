//! How numbers stand in an explanation: few enough digits to read, enough to compute the next line by hand.
//!
//! The decimal point is a point in every language, so that a number can be copied into a document.

/// A channel's value: five decimals, because a byte's step is 0.0039; a power of ten where they would all be 0, as long
/// as it means anything.
pub fn channel(value: f64) -> String {
    match value.abs() {
        0.0 => "0.00000".to_owned(),
        ..1e-12 => "≈ 0".to_owned(),
        ..5e-6 => format!("{value:.1e}"),
        _ => format!("{value:.5}"),
    }
}

/// A length, an index or a coordinate: at most four decimals.
pub fn length(value: f64) -> String {
    decimals(value, 4)
}

/// An angle in degrees from its cosine: two decimals.
pub fn degrees(cosine: f64) -> String {
    decimals(cosine.clamp(-1.0, 1.0).acos().to_degrees(), 2)
}

/// A point or a direction.
pub fn vector(value: [f64; 3]) -> String {
    let [x, y, z] = value.map(length);
    format!("({x} {y} {z})")
}

/// The values of three channels; one number for three equal ones, as in a document.
pub fn triple(value: [f64; 3]) -> String {
    let [r, g, b] = value;
    if r == g && g == b { length(r) } else { value.map(length).join(" ") }
}

/// At most so many decimals, without zeros at the end; a power of ten where they would all be 0.
fn decimals(value: f64, count: usize) -> String {
    let smallest = 0.5 * 0.1_f64.powi(count.try_into().unwrap_or(i32::MAX));
    if value != 0.0 && value.abs() < smallest {
        return format!("{value:.2e}");
    }
    let text = format!("{:.count$}", value + 0.0);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_never_lose_all_digits() {
        assert_eq!(length(1.5), "1.5");
        assert_eq!(length(-0.0), "0");
        assert_eq!(length(100.0), "100");
        assert_eq!(length(0.123456), "0.1235");
        assert_eq!(length(1e-9), "1.00e-9");
        assert_eq!(length(-1e9), "-1000000000");
        assert_eq!(channel(0.5), "0.50000");
        assert_eq!(channel(-0.0), "0.00000");
        assert_eq!(channel(3e-7), "3.0e-7");
        assert_eq!(channel(5e-144), "≈ 0");
        assert_eq!(degrees(0.5), "60");
        assert_eq!(degrees(1.0 + 1e-16), "0");
        assert_eq!(triple([1.5; 3]), "1.5");
        assert_eq!(triple([1.0, 1.25, 1.5]), "1 1.25 1.5");
    }
}
