//! Colours and every other triple of one number per channel, and the subject's composition of colours (§2.6).

use std::ops::{Add, Index, IndexMut, Mul};

/// One number for each of the channels red, green and blue: a colour, a coefficient, a shininess or an index.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb {
    /// Red.
    pub r: f64,
    /// Green.
    pub g: f64,
    /// Blue.
    pub b: f64,
}

/// A colour: three linear intensities in 0..1. There is no gamma anywhere.
pub type Color = Rgb;

impl Rgb {
    /// Zero in every channel: black, and the neutral element of [`Rgb::screen`].
    pub const BLACK: Rgb = Rgb::splat(0.0);
    /// One in every channel: white, and the absorbing element of [`Rgb::screen`].
    pub const WHITE: Rgb = Rgb::splat(1.0);

    /// The three numbers of the channels.
    pub const fn new(r: f64, g: f64, b: f64) -> Rgb {
        Rgb { r, g, b }
    }

    /// The same number in every channel.
    pub const fn splat(value: f64) -> Rgb {
        Rgb::new(value, value, value)
    }

    /// The colour of three bytes, each divided by 255.
    pub fn from_bytes(bytes: [u8; 3]) -> Color {
        Rgb::from(bytes.map(|byte| f64::from(byte) / 255.0))
    }

    /// The numbers as an array, red first.
    pub const fn to_array(self) -> [f64; 3] {
        [self.r, self.g, self.b]
    }

    /// `f` of every channel.
    pub fn map(self, f: impl FnMut(f64) -> f64) -> Rgb {
        Rgb::from(self.to_array().map(f))
    }

    /// `f` of every channel of two triples.
    pub fn zip(self, other: Rgb, mut f: impl FnMut(f64, f64) -> f64) -> Rgb {
        Rgb::new(f(self.r, other.r), f(self.g, other.g), f(self.b, other.b))
    }

    /// The subject's composition `a ⊕ b = 1 - (1-a)(1-b)` (§2.6), evaluated as `a + b·(1-a)`, which keeps 0 neutral
    /// and 1 absorbing to the last bit.
    pub fn screen(self, other: Color) -> Color {
        self.zip(other, |a, b| a + b * (1.0 - a))
    }

    /// Every channel brought into 0..1. A NaN stays one: it is an error, not a colour.
    pub fn clamp01(self) -> Color {
        self.map(|value| value.clamp(0.0, 1.0))
    }

    /// Whether every channel holds a finite number.
    pub fn is_finite(self) -> bool {
        self.to_array().into_iter().all(f64::is_finite)
    }

    /// The largest of the three numbers.
    pub fn max_channel(self) -> f64 {
        self.r.max(self.g).max(self.b)
    }

    /// Whether the three channels hold the same number.
    pub fn is_uniform(self) -> bool {
        self.r == self.g && self.g == self.b
    }

    /// The bytes of a colour: `floor(255·c + 0.5)` with `c` clamped to 0..1.
    pub fn to_bytes(self) -> [u8; 3] {
        // of what is not negative, the conversion to an integer is the floor
        self.to_array().map(|value| (255.0 * value.clamp(0.0, 1.0) + 0.5) as u8)
    }
}

impl From<[f64; 3]> for Rgb {
    fn from([r, g, b]: [f64; 3]) -> Rgb {
        Rgb { r, g, b }
    }
}

impl Add for Rgb {
    type Output = Rgb;
    fn add(self, other: Rgb) -> Rgb {
        self.zip(other, |a, b| a + b)
    }
}

impl Mul for Rgb {
    type Output = Rgb;
    fn mul(self, other: Rgb) -> Rgb {
        self.zip(other, |a, b| a * b)
    }
}

impl Mul<f64> for Rgb {
    type Output = Rgb;
    fn mul(self, factor: f64) -> Rgb {
        self.map(|value| value * factor)
    }
}

/// Channel 0 is red, 1 green, 2 blue.
impl Index<usize> for Rgb {
    type Output = f64;
    fn index(&self, channel: usize) -> &f64 {
        match channel {
            0 => &self.r,
            1 => &self.g,
            _ => &self.b,
        }
    }
}

impl IndexMut<usize> for Rgb {
    fn index_mut(&mut self, channel: usize) -> &mut f64 {
        match channel {
            0 => &mut self.r,
            1 => &mut self.g,
            _ => &mut self.b,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn color() -> impl Strategy<Value = Color> {
        [0.0..=1.0, 0.0..=1.0, 0.0..=1.0].prop_map(Rgb::from)
    }

    #[test]
    fn the_composition_of_the_subject() {
        let sum = Rgb::splat(0.2).screen(Rgb::splat(0.3)).screen(Rgb::splat(0.5));
        assert!((sum.r - 0.72).abs() < 1e-15, "{sum:?}");
    }

    #[test]
    fn bytes_round_half_up() {
        assert_eq!(Rgb::new(-0.5, 0.5, 1.5).to_bytes(), [0, 128, 255]);
        assert_eq!(Rgb::splat(0.5 / 255.0).to_bytes(), [1; 3]);
        for byte in 0..=255 {
            assert_eq!(Rgb::from_bytes([byte; 3]).to_bytes(), [byte; 3]);
        }
    }

    proptest! {
        #[test]
        fn screen_is_commutative_and_associative_within_a_few_ulp(a in color(), b in color(), c in color()) {
            let near = |x: Color, y: Color| x.zip(y, |x, y| (x - y).abs()).max_channel() <= 4.0 * f64::EPSILON;
            prop_assert!(near(a.screen(b), b.screen(a)));
            prop_assert!(near(a.screen(b).screen(c), a.screen(b.screen(c))));
        }

        #[test]
        fn screen_has_zero_neutral_and_one_absorbing(a in color()) {
            prop_assert_eq!(a.screen(Rgb::BLACK), a);
            prop_assert_eq!(Rgb::BLACK.screen(a), a);
            prop_assert_eq!(Rgb::WHITE.screen(a), Rgb::WHITE);
            prop_assert!(a.screen(Rgb::WHITE).zip(Rgb::WHITE, |x, y| (x - y).abs()).max_channel() <= f64::EPSILON);
        }

        #[test]
        fn screen_stays_a_colour(a in color(), b in color()) {
            let sum = a.screen(b);
            prop_assert!(sum.to_array().into_iter().all(|v| (0.0..=1.0).contains(&v)), "{sum:?}");
        }
    }
}
