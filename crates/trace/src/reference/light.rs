//! The model of light (subject §2): ambient, diffuse and specular parts of Phong 1975 and Blinn 1977, per channel.

use glam::DVec3;
use lancer_scene::{Color, Highlight, Reflectance, Rgb, Surface};

/// `Ea = Ka·Ia` (§2.1).
pub fn ambient(ka: Rgb, ia: Color) -> Color {
    ka * ia
}

/// The share of a lamp's light that is scattered: `Kd·cos l` (§2.2, Lambert's law).
pub fn diffuse(kd: Rgb, cos_l: f64) -> Rgb {
    kd * cos_l
}

/// The mirror image of the direction to a lamp: `R_L = 2(N·L)N - L`.
pub fn mirror_image(normal: DVec3, to_lamp: DVec3) -> DVec3 {
    normal * (2.0 * normal.dot(to_lamp)) - to_lamp
}

/// `cos s` of the highlight: Phong's `max(0, R_L·V)` or Blinn's `max(0, N·H)` with `H = unit(L+V)`.
pub fn cos_s(law: Highlight, normal: DVec3, to_lamp: DVec3, to_viewer: DVec3) -> f64 {
    let cosine = match law {
        Highlight::Phong => mirror_image(normal, to_lamp).dot(to_viewer),
        Highlight::Blinn => normal.dot((to_lamp + to_viewer).normalize_or_zero()),
    };
    cosine.max(0.0)
}

/// The reflectance `W(l)` (§2.3): `Ks`, or Schlick's `Ks + (1-Ks)(1-cos l)⁵`, or `Ks·(1-cos l)`.
pub fn reflectance(law: Reflectance, ks: Rgb, cos_l: f64) -> Rgb {
    let grazing = 1.0 - cos_l;
    match law {
        Reflectance::Constant => ks,
        Reflectance::Schlick => {
            let fifth = grazing * grazing * grazing * grazing * grazing;
            ks.map(|ks| ks + (1.0 - ks) * fifth)
        }
        Reflectance::Grazing => ks * grazing,
    }
}

/// The share of a lamp's light that shines: `W(l)·cosⁿ s` (§2.3). Where `cos s = 0` there is no highlight, whatever `n`.
pub fn highlight(w: Rgb, cos_s: f64, shininess: Rgb) -> Rgb {
    if cos_s == 0.0 { Rgb::BLACK } else { w.zip(shininess, |w, n| w * libm::pow(cos_s, n)) }
}

/// A lamp's light as a surface gives it back: diffuse and highlight parts, each times `I_L`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lit {
    /// `N·L`.
    pub cos_l: f64,
    /// `R_L·V` or `N·H`, at least 0.
    pub cos_s: f64,
    /// `W(l)`.
    pub w: Rgb,
    /// `Kd·cos l·I_L`.
    pub diffuse: Color,
    /// `W(l)·cosⁿ s·I_L`.
    pub highlight: Color,
}

/// The light of a lamp in front of a point that sees it: `(Kd·cos l + W(l)·cosⁿ s)·I_L`, in its two parts.
///
/// All directions are unit vectors that leave the point; `N·L` must be more than 0.
pub fn lamp(surface: &Surface, normal: DVec3, to_lamp: DVec3, to_viewer: DVec3, color: Color) -> Lit {
    let cos_l = normal.dot(to_lamp);
    let cos_s = cos_s(surface.highlight, normal, to_lamp, to_viewer);
    let w = reflectance(surface.w, surface.ks, cos_l);
    Lit {
        cos_l,
        cos_s,
        w,
        diffuse: diffuse(surface.kd, cos_l) * color,
        highlight: highlight(w, cos_s, surface.shininess) * color,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A direction at `degrees` from the normal (z), on the side of +x.
    fn at(degrees: f64) -> DVec3 {
        let (sin, cos) = degrees.to_radians().sin_cos();
        DVec3::new(sin, 0.0, cos)
    }

    fn near(a: f64, b: f64) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }

    #[test]
    fn phong_and_blinn_at_given_angles() {
        let cos = |degrees: f64| degrees.to_radians().cos();
        // lamp 30° on one side, viewer 50° on the other: the mirror image is 20° from the viewer,
        // the half vector is 10° from the normal
        near(cos_s(Highlight::Phong, DVec3::Z, at(30.0), at(-50.0)), cos(20.0));
        near(cos_s(Highlight::Blinn, DVec3::Z, at(30.0), at(-50.0)), cos(10.0));
        // in the mirror direction both are 1
        near(cos_s(Highlight::Phong, DVec3::Z, at(30.0), at(-30.0)), 1.0);
        near(cos_s(Highlight::Blinn, DVec3::Z, at(30.0), at(-30.0)), 1.0);
        // more than 90° from the mirror image: nothing
        assert_eq!(cos_s(Highlight::Phong, DVec3::Z, at(60.0), at(45.0)), 0.0);
    }

    #[test]
    fn a_lamp_overhead_gives_all_its_light() {
        let surface = Surface { kd: Rgb::splat(0.5), ks: Rgb::splat(0.25), ..Surface::default() };
        let lit = lamp(&surface, DVec3::Z, DVec3::Z, DVec3::Z, Rgb::new(1.0, 0.5, 0.0));
        assert_eq!(lit.diffuse, Rgb::new(0.5, 0.25, 0.0));
        assert_eq!(lit.highlight, Rgb::new(0.25, 0.125, 0.0));
    }

    #[test]
    fn shininess_is_an_exponent_per_channel() {
        let cos60 = 0.5;
        let shine = highlight(Rgb::WHITE, cos60, Rgb::new(0.0, 1.0, 3.0));
        assert_eq!(shine, Rgb::new(1.0, 0.5, 0.125));
        assert_eq!(highlight(Rgb::WHITE, 0.0, Rgb::BLACK), Rgb::BLACK, "no highlight whatever n");
    }

    #[test]
    fn reflectance_laws() {
        let ks = Rgb::splat(0.04);
        assert_eq!(reflectance(Reflectance::Constant, ks, 0.3), ks);
        assert_eq!(reflectance(Reflectance::Schlick, ks, 1.0), ks);
        assert_eq!(reflectance(Reflectance::Schlick, ks, 0.0).r, 1.0);
        near(reflectance(Reflectance::Schlick, ks, 0.5).r, 0.04 + 0.96 / 32.0);
        assert_eq!(reflectance(Reflectance::Grazing, ks, 1.0), Rgb::BLACK);
        near(reflectance(Reflectance::Grazing, ks, 0.25).r, 0.03);
    }
}
