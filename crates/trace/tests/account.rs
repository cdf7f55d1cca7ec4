//! An account can be worked out by hand: from its factors alone follow every product, every running sum and the colour.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that fails says so by panicking")]

mod common;

use common::{black, object, open, pixel, plane, scene, sphere};
use lancer_scene::{Compose, DVec3, Environment, Highlight, List, PointLight, Reflectance, Rgb, Shape, Surface};
use lancer_trace::PixelTree;
use lancer_trace::explain::{Course, Entry, Factor, Part, RayNames, account};
use lancer_trace::observe::Seen;

fn near(what: &str, got: Rgb, due: Rgb) {
    assert!((0..3).all(|channel| (got[channel] - due[channel]).abs() < 1e-12), "{what}: {got:?} is not {due:?}");
}

/// Works the accounts of a tree out; gives how many sums there were.
fn work_out(pixel: &PixelTree, compose: Compose) -> usize {
    let mut sums = 0;
    for sample in &pixel.samples {
        for node in &sample.tree.nodes {
            let Seen::Surface(surface) = &node.seen else { continue };
            let mut sum = Rgb::BLACK;
            // the product so far, a lamp's scattered share, its intensity
            let (mut product, mut diffuse, mut intensity) = (Rgb::BLACK, Rgb::BLACK, Rgb::BLACK);
            let mut term = Rgb::BLACK;
            for entry in account(&sample.tree, node, surface, compose) {
                match entry {
                    Entry::Begin(part) => match part {
                        Part::Highlight => diffuse = product,
                        Part::Ambient | Part::Mirror | Part::Glass | Part::Lamp { .. } | Part::Diffuse => {
                            product = Rgb::BLACK;
                        }
                    },
                    Entry::Value { sign: "=", factor: Factor::Symbol(symbol), value } => {
                        let due = match symbol {
                            "(Kd·cos l + W·cosⁿ s)·I_L" => (diffuse + product) * intensity,
                            "Kd·cos l·I_L" => diffuse * intensity,
                            "W·cosⁿ s·I_L" => product * intensity,
                            _ => product,
                        };
                        near(symbol, value, due);
                        term = value;
                    }
                    Entry::Value { factor: Factor::Symbol("I_L"), value, .. } => intensity = value,
                    Entry::Value { factor: Factor::Clamped, value, .. } => near("clamped", value, term.clamp01()),
                    Entry::Value { factor: Factor::Seen { rays, .. }, value, .. } => {
                        for ray in rays {
                            let seen = &sample.tree.nodes[ray];
                            seen.channels.iter().for_each(|channel| assert_eq!(value[channel], seen.color[channel]));
                        }
                        product = product * value;
                    }
                    Entry::Value { sign: "×", value, .. } => product = product * value,
                    Entry::Value { value, .. } => product = value,
                    Entry::Sum { sign, so_far, .. } => {
                        let due = match sign {
                            "=" => product,
                            "⊕" => sum.screen(term.clamp01()),
                            _ => sum + term,
                        };
                        near("E", so_far, due);
                        sum = so_far;
                        sums += 1;
                    }
                    Entry::Omitted { .. } | Entry::Way(_) | Entry::Lamp { .. } => {}
                }
            }
            let seen = sum.clamp01();
            node.channels.iter().for_each(|channel| assert!((node.color[channel] - seen[channel]).abs() < 1e-12));
        }
    }
    sums
}

/// A pixel with every kind of term: a mirror, dispersion, total reflection, lamps before, behind and blocked, more than 1.
fn everything(compose: Compose, highlight: Highlight, w: Reflectance) -> PixelTree {
    let prism = Surface {
        ka: Rgb::splat(0.1),
        kd: Rgb::new(0.9, 0.5, 0.7),
        ks: Rgb::splat(0.8),
        shininess: Rgb::new(2.0, 5.0, 9.0),
        kr: Rgb::new(0.2, 0.3, 0.0),
        kt: Rgb::splat(0.6),
        index: Rgb::new(1.4, 1.5, 1.6),
        highlight,
        w,
    };
    let floor = Surface { kd: Rgb::splat(0.5), ks: Rgb::splat(0.9), kr: Rgb::splat(0.3), highlight, w, ..black() };
    let cube = Shape::Cube { center: DVec3::ZERO, edge: 2.0, rotation: DVec3::new(10.0, 40.0, 5.0) };
    let objects = vec![
        object("prism", cube, prism),
        plane("floor", DVec3::NEG_Y * 2.0, DVec3::Y, floor),
        sphere("blocker", DVec3::new(4.0, 4.0, 4.0), 0.5, black()),
    ];
    let mut scene =
        scene(objects, Environment { compose, depth: 5, background: Rgb::splat(0.3), ..Environment::default() });
    scene.lights = [("near", [0.5, 1.5, 9.0]), ("far", [-30.0, 40.0, 20.0]), ("blocked", [8.0, 8.0, 8.0])]
        .into_iter()
        .map(|(name, at)| PointLight::new(name, DVec3::from(at)))
        .collect::<List<PointLight>>();
    open(&scene, &pixel(DVec3::new(0.4, 0.6, 9.0), DVec3::new(0.3, 0.2, 0.0)))
}

#[test]
fn every_product_and_sum_follows_from_the_factors() {
    for compose in [Compose::Screen, Compose::ScreenEach, Compose::Add] {
        for highlight in [Highlight::Phong, Highlight::Blinn] {
            for w in [Reflectance::Constant, Reflectance::Schlick, Reflectance::Grazing] {
                let sums = work_out(&everything(compose, highlight, w), compose);
                assert!(sums > 60, "{sums} sums are too few to show anything");
            }
        }
    }
}

/// The sines of the angles of every way are as n' to n, and a way of some channels says which.
#[test]
fn ways_obey_snells_law() {
    let pixel = everything(Compose::Screen, Highlight::Phong, Reflectance::Constant);
    let tree = &pixel.samples[0].tree;
    let sine = |cosine: f64| (1.0 - cosine * cosine).sqrt();
    let (mut bent, mut reflected) = (0, 0);
    for node in &tree.nodes {
        let Seen::Surface(surface) = &node.seen else { continue };
        for entry in account(tree, node, surface, Compose::Screen) {
            let Entry::Way(way) = entry else { continue };
            match way.course {
                Course::Straight => panic!("there is no sheet"),
                Course::Bent { indices: [n, n_prime], cos_i, cos_r } => {
                    assert!((n * sine(cos_i) - n_prime * sine(cos_r)).abs() < 1e-9);
                    bent += 1;
                }
                Course::Reflected { indices: [n, n_prime], cos_i, cos_critical } => {
                    assert!((n * sine(cos_critical) - n_prime).abs() < 1e-9 && cos_i < cos_critical);
                    reflected += 1;
                }
            }
        }
    }
    assert!(bent > 3 && reflected > 0, "{bent} {reflected}");
    // the three colours part at the first surface: each has its ray, and its name says so
    let names = RayNames::new(tree);
    let first: Vec<String> = tree.nodes[0].children.iter().map(|&ray| names.of(ray)).collect();
    assert_eq!(first, ["R1[rg]", "T1[r]", "T1[g]", "T1[b]"]);
}

/// A highlight that faces away: `R_L·V` is less than 0 there, so it is not what `cos s` is.
#[test]
fn a_cosine_of_zero_is_told_as_a_maximum() {
    let mut scene = scene(vec![plane("floor", DVec3::ZERO, DVec3::Y, Surface::default())], Environment::default());
    // the viewer stands at 60° from the normal, one lamp beside it, at 50°
    let at = |degrees: f64| DVec3::new(degrees.to_radians().sin(), degrees.to_radians().cos(), 0.0) * 4.0;
    let told = |scene: &lancer_scene::Scene| -> Vec<&'static str> {
        let pixel = open(scene, &pixel(at(60.0), DVec3::ZERO));
        let tree = &pixel.samples[0].tree;
        let Seen::Surface(surface) = &tree.nodes[0].seen else { panic!("the floor is seen") };
        let entries = account(tree, &tree.nodes[0], surface, Compose::Screen);
        entries
            .iter()
            .filter_map(|entry| if let Entry::Lamp { cos_s, .. } = entry { Some(*cos_s) } else { None })
            .collect()
    };
    scene.lights = [("beside the eye", 50.0), ("opposite", -50.0)]
        .into_iter()
        .map(|(name, degrees)| PointLight::new(name, at(degrees)))
        .collect::<List<PointLight>>();
    assert_eq!(told(&scene), ["max(0, R_L·V)", "R_L·V"]);
}
