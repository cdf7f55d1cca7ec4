//! A glTF material translated into the coefficients of the subject, as well as two models of light allow.
//!
//! With base colour `b`, metalness `m`, roughness `r`, opacity `a` and transmission `t`, all in 0..1:
//!
//! | coefficient | value |
//! |---|---|
//! | `Kd` | `b·a·(1-t)·(1 - m·(1-r))`: a rough metal scatters what a smooth one mirrors |
//! | `Ka` | a third of `Kd`, as in the built-in grey |
//! | `W` | `(1-r)·(½(1-m) + b·m)` |
//! | `n` | `2/r⁴ - 2`, the exponent of Blinn's model with the same width (Karis 2013) |
//! | `Kr` | `b·m·(1-r)` |
//! | `Kt` | `(1-a) + a·b·t·(1-m)` |
//! | index | that of `KHR_materials_ior`, 1.5 without, where `t > 0`; else 1 |

use super::document::{AlphaMode, Material};
use lancer_scene::{Rgb, Surface, limits};

pub(super) fn of(material: &Material) -> Surface {
    // A factor out of its range is brought into it; a NaN cannot be written in JSON.
    let share = |value: f64| value.clamp(0.0, 1.0);
    let factors = &material.pbr_metallic_roughness;
    let [r, g, b, opacity] = factors.base_color_factor.map(share);
    let base = Rgb::new(r, g, b);
    let metal = share(factors.metallic_factor);
    let rough = share(factors.roughness_factor);
    let opacity = if material.alpha_mode == AlphaMode::Blend { opacity } else { 1.0 };
    let through = material.extensions.transmission.as_ref().map_or(0.0, |it| share(it.transmission_factor));
    let index = material.extensions.ior.as_ref().and_then(|it| it.ior).unwrap_or(1.5);
    let kd = base * (opacity * (1.0 - through) * (1.0 - metal * (1.0 - rough)));
    let clear = base.map(|base| share(1.0 - opacity + opacity * base * through * (1.0 - metal)));
    Surface {
        ka: kd * (1.0 / 3.0),
        kd,
        ks: base.map(|base| (1.0 - rough) * (0.5 * (1.0 - metal) + base * metal)),
        shininess: Rgb::splat((2.0 / rough.powi(4) - 2.0).clamp(0.0, limits::SHININESS)),
        kr: base * (metal * (1.0 - rough)),
        kt: clear,
        index: Rgb::splat(if through > 0.0 && (0.01..=100.0).contains(&index) { index } else { 1.0 }),
        ..Surface::default()
    }
}

pub(super) fn has_texture(material: &Material) -> bool {
    let factors = &material.pbr_metallic_roughness;
    factors.base_color_texture.is_some() || factors.metallic_roughness_texture.is_some()
}
