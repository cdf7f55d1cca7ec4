//! The model of light over lanes (subject §2): the reference's, with the power of `engine::power`.

use super::lanes::{Lanes, Mask, Real};
use super::packet::Colors;
use super::power::power;
use super::vector::Vector;
use lancer_scene::{Color, Compose, Highlight, Reflectance, Rgb, Surface};

/// A number brought into 0..1; a NaN stays one.
#[inline(always)]
pub(super) fn clamp01<R: Real>(value: R) -> R {
    R::splat(1.0).min(R::splat(0.0).max(value))
}

/// Composes a term with the sum so far (subject §2.6).
#[inline(always)]
pub(super) fn add<L: Lanes>(compose: Compose, sum: &Colors<L>, term: &Colors<L>) -> Colors<L> {
    let mut total = *sum;
    for channel in 0..3 {
        total[channel] = match compose {
            Compose::Screen | Compose::ScreenEach => {
                let (a, b) = (sum[channel], clamp01(term[channel]));
                a + b * (L::Real::splat(1.0) - a)
            }
            Compose::Add => sum[channel] + term[channel],
        };
    }
    total
}

/// The same colour in every lane.
#[inline(always)]
pub(super) fn splat<L: Lanes>(color: Rgb) -> Colors<L> {
    [L::Real::splat(color.r), L::Real::splat(color.g), L::Real::splat(color.b)]
}

/// `yes` in the lanes of the mask, `no` in the others.
#[inline(always)]
pub(super) fn select<L: Lanes>(mask: L::Mask, yes: &Colors<L>, no: &Colors<L>) -> Colors<L> {
    [L::Real::select(mask, yes[0], no[0]), L::Real::select(mask, yes[1], no[1]), L::Real::select(mask, yes[2], no[2])]
}

/// Adds the light of a lamp to a sum: `(Kd·cos l + W(l)·cosⁿ s)·I_L` (subject §2.2, §2.3).
#[inline(always)]
pub(super) fn add_lamp<L: Lanes>(
    compose: Compose,
    sum: &Colors<L>,
    surface: &Surface,
    [normal, to_lamp, to_viewer]: [Vector<L::Real>; 3],
    color: Color,
) -> Colors<L> {
    let cos_l = normal.dot(to_lamp);
    let mut diffuse = [L::Real::splat(0.0); 3];
    for channel in 0..3 {
        diffuse[channel] = L::Real::splat(surface.kd[channel]) * cos_l * L::Real::splat(color[channel]);
    }
    let shine = highlight::<L>(surface, normal, to_lamp, to_viewer, cos_l);
    let mut specular = [L::Real::splat(0.0); 3];
    if let Some(shine) = shine {
        for channel in 0..3 {
            specular[channel] = shine[channel] * L::Real::splat(color[channel]);
        }
    }
    match compose {
        Compose::Screen | Compose::Add => {
            let both = [diffuse[0] + specular[0], diffuse[1] + specular[1], diffuse[2] + specular[2]];
            add::<L>(compose, sum, &both)
        }
        Compose::ScreenEach => add::<L>(compose, &add::<L>(compose, sum, &diffuse), &specular),
    }
}

/// `W(l)·cosⁿ s`, 0 where `cos s = 0`; `None` where it is 0 in every lane.
#[inline(always)]
fn highlight<L: Lanes>(
    surface: &Surface,
    normal: Vector<L::Real>,
    to_lamp: Vector<L::Real>,
    to_viewer: Vector<L::Real>,
    cos_l: L::Real,
) -> Option<Colors<L>> {
    let (zero, one) = (L::Real::splat(0.0), L::Real::splat(1.0));
    if surface.ks == Rgb::BLACK && surface.w != Reflectance::Schlick {
        return None;
    }
    let cosine = match surface.highlight {
        Highlight::Phong => {
            let mirrored = normal * (L::Real::splat(2.0) * normal.dot(to_lamp)) - to_lamp;
            mirrored.dot(to_viewer)
        }
        Highlight::Blinn => {
            let half = to_lamp + to_viewer;
            let shrink = one / half.length();
            // opposite directions have no half vector
            let exists = shrink.lt(L::Real::splat(f64::INFINITY)) & shrink.gt(zero);
            normal.dot(Vector::select(exists, half * shrink, Vector { x: zero, y: zero, z: zero }))
        }
    };
    let shines = cosine.gt(zero);
    if shines.bits() == 0 {
        return None;
    }
    let cos_s = L::Real::select(shines, cosine, one);
    let grazing = one - cos_l;
    let fifth = grazing * grazing * grazing * grazing * grazing;
    let mut light = [zero; 3];
    let mut shine = zero;
    for channel in 0..3 {
        if channel == 0 || surface.shininess[channel] != surface.shininess[channel - 1] {
            shine = power(cos_s, L::Real::splat(surface.shininess[channel]));
        }
        let ks = L::Real::splat(surface.ks[channel]);
        let w = match surface.w {
            Reflectance::Constant => ks,
            Reflectance::Schlick => ks + (one - ks) * fifth,
            Reflectance::Grazing => ks * grazing,
        };
        light[channel] = L::Real::select(shines, w * shine, zero);
    }
    Some(light)
}
