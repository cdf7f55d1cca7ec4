//! Roughness: noise between the points of a lattice, in octaves (K. Perlin 1985, F. K. Musgrave's sum of octaves).

use super::Random;
use glam::DVec3;

/// A smooth function of space with one random value in -1..1 at each point with whole coordinates.
fn value(at: DVec3, seed: u64) -> f64 {
    let low = at.floor();
    let part = at - low;
    // 3t² - 2t³: level at the points of the lattice, so that cells join smoothly
    let ease = part * part * (DVec3::splat(3.0) - part * 2.0);
    let [x, y, z] = low.to_array().map(|coordinate| coordinate as i64 as u64);
    let corner = |i: u64, j: u64, k: u64| {
        let place = x.wrapping_add(i).wrapping_mul(0x9E37_79B9_7F4A_7C15)
            ^ y.wrapping_add(j).wrapping_mul(0xC2B2_AE3D_27D4_EB4F)
            ^ z.wrapping_add(k).wrapping_mul(0x1656_67B1_9E37_79F9);
        Random::new(place ^ seed).unit() * 2.0 - 1.0
    };
    let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
    let row = |j, k| mix(corner(0, j, k), corner(1, j, k), ease.x);
    let layer = |k| mix(row(0, k), row(1, k), ease.y);
    // in a plane of the lattice one layer is enough
    if part.z == 0.0 { layer(0) } else { mix(layer(0), layer(1), ease.z) }
}

/// The sum of octaves of noise, each twice as fine and half as high as the one before it: within -2..2.
pub(super) fn octaves(at: DVec3, count: u32, seed: u64) -> f64 {
    let (mut sum, mut height, mut at) = (0.0, 1.0, at);
    for octave in 0..count {
        sum += height * value(at, seed.wrapping_add(u64::from(octave)));
        height *= 0.5;
        at *= 2.0;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_continuous_bounded_and_not_constant() {
        let mut random = Random::new(7);
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for _ in 0..10_000 {
            let at = DVec3::new(random.unit(), random.unit(), random.unit()) * 20.0 - 10.0;
            let here = value(at, 1);
            // the slope of 3t² - 2t³ is at most 1.5, of a difference of at most 2, along three axes
            assert!((value(at + DVec3::splat(1e-6), 1) - here).abs() < 1e-5, "{at}");
            least = least.min(here);
            greatest = greatest.max(here);
            assert!(octaves(at, 8, 1).abs() <= 2.0);
        }
        assert!((-1.0..-0.7).contains(&least) && (0.7..1.0).contains(&greatest), "{least} {greatest}");
    }

    #[test]
    fn a_plane_of_the_lattice_is_no_exception() {
        let at = DVec3::new(3.25, -1.75, 2.0);
        assert!((value(at, 5) - value(at + DVec3::Z * 1e-9, 5)).abs() < 1e-8);
        assert!((value(at, 5) - value(at - DVec3::Z * 1e-9, 5)).abs() < 1e-8);
    }
}
