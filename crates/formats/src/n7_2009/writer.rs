//! What the writers of scenes and of views share: lines, points and colours.

use super::FULL;
use crate::xml::shortest;
use lancer_scene::{Color, DVec3};

/// A document that grows line by line.
pub(super) struct Writer {
    pub(super) text: String,
    depth: usize,
}

impl Writer {
    pub(super) fn new() -> Writer {
        Writer { text: "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n".to_owned(), depth: 0 }
    }

    /// A whole element on a line.
    pub(super) fn line(&mut self, element: &str) {
        for _ in 0..self.depth {
            self.text.push_str("  ");
        }
        self.text.push_str(element);
        self.text.push('\n');
    }

    /// An element around lines.
    pub(super) fn around(&mut self, name: &str, attributes: &str, content: impl FnOnce(&mut Writer)) {
        self.line(&format!("<{name}{attributes}>"));
        self.depth += 1;
        content(self);
        self.depth -= 1;
        self.line(&format!("</{name}>"));
    }
}

pub(super) fn point(point: DVec3) -> String {
    let [x, y, z] = point.to_array().map(shortest);
    format!("<Point x=\"{x}\" y=\"{y}\" z=\"{z}\"/>")
}

pub(super) fn colour(colour: Color) -> String {
    let [r, v, b] = colour.to_array().map(in_255ths);
    format!("<Couleur r=\"{r}\" v=\"{v}\" b=\"{b}\"/>")
}

/// The shortest decimal that gives the intensity again when it is divided by 255. Some intensities are none of a
/// double's 255ths; for those it is the nearest one.
fn in_255ths(intensity: f64) -> String {
    let exact = intensity * FULL;
    let rounded = |digits: usize| format!("{exact:.digits$}");
    let again = |text: &String| text.parse::<f64>().is_ok_and(|value| value / FULL == intensity);
    match (0..17).map(rounded).find(again) {
        Some(text) => text,
        None => shortest(exact),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn bytes_and_friendly_fractions_stay_short() {
        for byte in 0..=255_u8 {
            assert_eq!(in_255ths(f64::from(byte) / 255.0), byte.to_string());
        }
        assert_eq!([0.2, 0.5, 0.7, 0.25, 1.0 / 3.0].map(in_255ths), ["51", "127.5", "178.5", "63.75", "85"]);
    }

    proptest! {
        #[test]
        fn every_intensity_comes_back_to_the_last_bit_or_the_one_before(intensity in 0.0..=1.0_f64) {
            let back = in_255ths(intensity).parse::<f64>().unwrap() / FULL;
            prop_assert!((back - intensity).abs() <= f64::EPSILON * intensity, "{back} {intensity}");
        }
    }
}
