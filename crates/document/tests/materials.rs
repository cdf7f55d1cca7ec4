//! The material presets: legal, told apart, and true to the sources that they name.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use lancer_document::presets::{Family, Preset};
use lancer_scene::{Rgb, Surface};
use lancer_words::Lang;
use std::collections::HashSet;

#[test]
fn every_preset_is_legal_named_and_listed_once() {
    let mut surfaces: Vec<Surface> = Vec::new();
    for lang in Lang::ALL {
        let names: HashSet<String> = Preset::ALL.iter().map(|preset| preset.text(lang)).collect();
        assert_eq!(names.len(), Preset::ALL.len(), "{lang:?}");
        assert!(names.iter().all(|name| !name.is_empty() && name.trim() == name));
    }
    for preset in Preset::ALL {
        let surface = preset.surface();
        assert_eq!(surface.check(), Ok(()), "{preset:?}");
        assert!(!surfaces.contains(&surface), "{preset:?} is like another one");
        assert_eq!(surface.is_transparent(), preset.family() == Family::Transparent, "{preset:?}");
        surfaces.push(surface);
    }
    // grouped as menus show them
    let families: Vec<Family> = Preset::ALL.iter().map(|preset| preset.family()).collect();
    let mut grouped = families.clone();
    grouped.sort_by_key(|family| Family::ALL.iter().position(|known| known == family));
    assert_eq!(families, grouped);
}

/// `n² = 1 + Σ B·λ²/(λ²-C)`, λ in micrometres (Sellmeier 1871).
fn sellmeier(terms: [(f64, f64); 3], micrometres: f64) -> f64 {
    let squared = micrometres * micrometres;
    (1.0 + terms.iter().map(|(b, c)| b * squared / (squared - c)).sum::<f64>()).sqrt()
}

/// The Fraunhofer lines C, d and F for red, green and blue.
const LINES: [f64; 3] = [0.6562725, 0.5875618, 0.4861327];

/// The coefficients are Schott's for N-BK7 and N-SF10, and Peter's (1923) for diamond.
#[test]
fn indices_are_the_published_ones() {
    let near = |found: f64, expected: f64, tolerance: f64| {
        assert!((found - expected).abs() <= tolerance, "{found} {expected}");
    };
    let bk7 = [(1.03961212, 0.00600069867), (0.231792344, 0.0200179144), (1.01046945, 103.560653)];
    near(Preset::Glass.surface().index.g, sellmeier(bk7, LINES[1]), 5e-5);
    let sf10 = [(1.62153902, 0.0122241457), (0.256287842, 0.0595736775), (1.64447552, 147.468793)];
    let flint = Preset::FlintGlass.surface().index;
    for (index, line) in flint.to_array().into_iter().zip(LINES) {
        near(index, sellmeier(sf10, line), 5e-5);
    }
    let diamond = [(0.3306, 0.175 * 0.175), (4.3356, 0.106 * 0.106), (0.0, 0.0)];
    near(Preset::Diamond.surface().index.g, sellmeier(diamond, 0.5893), 3e-3);
    assert_eq!(Preset::Water.surface().index, Rgb::splat(1.333));
    assert_eq!(Preset::Diamond.surface().index, Rgb::splat(2.419));
}

/// What is clear mirrors Fresnel's share at normal incidence and lets through no more than the rest.
#[test]
fn clear_things_keep_the_energy() {
    for preset in [Preset::Glass, Preset::FlintGlass, Preset::BottleGlass, Preset::Water, Preset::Ice, Preset::Diamond]
    {
        let surface = preset.surface();
        for channel in 0..3 {
            let n = surface.index[channel];
            let share = ((n - 1.0) / (n + 1.0)).powi(2);
            assert!((surface.kr[channel] - share).abs() < 1e-3, "{preset:?}");
            assert!(surface.kr[channel] + surface.kt[channel] <= 1.0 + 1e-9, "{preset:?}");
        }
        assert!(preset.source(Lang::English).is_some_and(|source| source.contains(": ")), "{preset:?}");
    }
}
