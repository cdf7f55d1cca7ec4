//! The sum of a point's terms (subject §2.5, §2.6): `E = Ka·Ia ⊕ Kr·Ir ⊕ Kt·It ⊕ lamp 1 ⊕ lamp 2 …`.

use lancer_scene::{Color, Compose, Rgb};

/// The running sum of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sum {
    compose: Compose,
    total: Color,
}

impl Sum {
    /// The empty sum: black, neutral in every composition.
    pub fn new(compose: Compose) -> Sum {
        Sum { compose, total: Rgb::BLACK }
    }

    /// Adds a term. For `⊕` it is clamped to 0..1 first.
    pub fn add(&mut self, term: Color) {
        self.total = match self.compose {
            Compose::Screen | Compose::ScreenEach => self.total.screen(term.clamp01()),
            Compose::Add => self.total + term,
        };
    }

    /// Adds a lamp's two parts: one term, or one each for `screen-each`.
    pub fn add_lamp(&mut self, diffuse: Color, highlight: Color) {
        match self.compose {
            Compose::Screen | Compose::Add => self.add(diffuse + highlight),
            Compose::ScreenEach => {
                self.add(diffuse);
                self.add(highlight);
            }
        }
    }

    /// The sum so far, before the clamp of `add`.
    pub fn so_far(&self) -> Color {
        self.total
    }

    /// The colour: the sum clamped to 0..1.
    pub fn color(&self) -> Color {
        self.total.clamp01()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sum(compose: Compose, terms: &[f64], lamp: (f64, f64)) -> f64 {
        let mut sum = Sum::new(compose);
        terms.iter().for_each(|&term| sum.add(Rgb::splat(term)));
        sum.add_lamp(Rgb::splat(lamp.0), Rgb::splat(lamp.1));
        sum.color().r
    }

    #[test]
    fn each_composition() {
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-15, "{a} {b}");
        // .2 ⊕ .3 ⊕ (.25 + .25) = .72
        near(sum(Compose::Screen, &[0.2, 0.3], (0.25, 0.25)), 0.72);
        // .2 ⊕ .3 ⊕ .25 ⊕ .25 = 1 - .8·.7·.75·.75
        near(sum(Compose::ScreenEach, &[0.2, 0.3], (0.25, 0.25)), 1.0 - 0.8 * 0.7 * 0.75 * 0.75);
        near(sum(Compose::Add, &[0.2, 0.3], (0.25, 0.125)), 0.875);
        near(sum(Compose::Add, &[0.9, 0.3], (0.25, 0.125)), 1.0);
        near(sum(Compose::Screen, &[0.5], (0.75, 0.75)), 1.0);
    }
}
