//! The explanation of a pixel: its whole text, and that it tells the truth: it ends in the picture's bytes, and every
//! number in it follows from those before by the formulas of the subject.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::{folder, run};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A glazed ball seen along the axis: every number can be had in one's head.
const BALL: &str = r#"<scene version="1" name="One ball">
  <world ambient="0.5" background="0.1 0.2 0.4" depth="1"/>
  <material name="glazed" ka="0.2" kd="0.4 0.5 0.6" ks="0.25" n="2" kr="0.5"/>
  <light name="lamp" position="0 0 4" color="0.8"/>
  <light name="behind" position="0 0 -4"/>
  <light name="shaded" position="0 3 4"/>
  <sphere name="ball" center="0 0 0" radius="1" material="glazed"/>
  <sphere name="lid" center="0 1 2" radius="0.5"/>
</scene>
"#;

/// A picture of three by three pixels; the ray of the middle one goes along the axis.
const AXIS: &str = r#"<view version="1" name="front" width="3" height="3">
  <eye at="0 0 5"/>
  <screen origin="-1 1 4" u="2 0 0" v="0 -2 0"/>
</view>
"#;

const BALL_TEXT: &str = "\
pixel 1, 1 of view `front`, 3×3 pixels
scene: One ball
composition: screen, a ⊕ b = 1 - (1-a)(1-b); depth limit: 1

primary ray · level 0 · in the surrounding medium, index 1
│ from S = (0 0 5) along I = (0 0 -1)
│ meets sphere `ball` at distance 4, from outside, material `glazed`
│ P = (0 0 1), N = (0 0 1), angle of incidence i = 0°
│
│                                              red     green      blue
│ ambient      Ka                          0.20000   0.20000   0.20000
│            × Ia                          0.50000   0.50000   0.50000
│ E          = Ka·Ia                       0.10000   0.10000   0.10000
│ reflected    Kr                          0.50000   0.50000   0.50000
│            × Ir seen along R1            0.10000   0.20000   0.40000
│            = Kr·Ir                       0.05000   0.10000   0.20000
│ E          ⊕ Kr·Ir                       0.14500   0.19000   0.28000
│ refracted    Kt = 0, opaque
│ lamp `lamp`, 3 away:
│   lights the point: cos l = N·L = 1.00000 (l = 0°), cos s = R_L·V = 1.00000 (s = 0°)
│ diffuse      Kd                          0.40000   0.50000   0.60000
│            × cos l                       1.00000   1.00000   1.00000
│ highlight  + W = Ks                      0.25000   0.25000   0.25000
│            × cosⁿ s, n = 2               1.00000   1.00000   1.00000
│            × I_L                         0.80000   0.80000   0.80000
│            = (Kd·cos l + W·cosⁿ s)·I_L   0.52000   0.60000   0.68000
│ E          ⊕ lamp                        0.58960   0.67600   0.76960
│ lamp `behind`, 5 away:
│   behind the surface: N·L = -1.00000 is not more than 0
│ lamp `shaded`, 4.2426 away:
│   in shadow: `lid` stands between
│ colour: E clamped to 0..1                0.58960   0.67600   0.76960
│
└─ R1, reflected ray · level 1 · in the surrounding medium, index 1
     from S = (0 0 1) along I = (0 0 1)
     meets nothing: the colour of infinity

                              red     green      blue
     colour of infinity   0.10000   0.20000   0.40000

                                red     green      blue
colour of the pixel, c      0.58960   0.67600   0.76960
byte = floor(255·c + 0.5)       150       172       196
c of the engine             0.58960   0.67600   0.76960
byte of the engine              150       172       196
";

const BALL_TEXT_FRENCH: &str = "\
pixel 1, 1 de la vue « front », 3×3 pixels
scène : One ball
composition : screen, a ⊕ b = 1 - (1-a)(1-b) ; profondeur limite : 1
étapes omises : ombres

rayon primaire · niveau 0 · dans le milieu environnant, indice 1
│ part de S = (0 0 5) dans la direction I = (0 0 -1)
│ rencontre la sphère « ball » à la distance 4, de l'extérieur, matière « glazed »
│ P = (0 0 1), N = (0 0 1), angle d'incidence i = 0°
│
│                                            rouge      vert      bleu
│ ambiante     Ka                          0.20000   0.20000   0.20000
│            × Ia                          0.50000   0.50000   0.50000
│ E          = Ka·Ia                       0.10000   0.10000   0.10000
│ réfléchie    Kr                          0.50000   0.50000   0.50000
│            × Ir vue le long de R1        0.10000   0.20000   0.40000
│            = Kr·Ir                       0.05000   0.10000   0.20000
│ E          ⊕ Kr·Ir                       0.14500   0.19000   0.28000
│ réfractée    Kt = 0, opaque
│ source « lamp », à la distance 3 :
│   éclaire le point : cos l = N·L = 1.00000 (l = 0°), cos s = R_L·V = 1.00000 (s = 0°)
│ diffuse      Kd                          0.40000   0.50000   0.60000
│            × cos l                       1.00000   1.00000   1.00000
│ spéculaire + W = Ks                      0.25000   0.25000   0.25000
│            × cosⁿ s, n = 2               1.00000   1.00000   1.00000
│            × I_L                         0.80000   0.80000   0.80000
│            = (Kd·cos l + W·cosⁿ s)·I_L   0.52000   0.60000   0.68000
│ E          ⊕ source                      0.58960   0.67600   0.76960
│ source « behind », à la distance 5 :
│   derrière la surface : N·L = -1.00000 n'est pas supérieur à 0
│ source « shaded », à la distance 4.2426 :
│   éclaire le point : cos l = N·L = 0.70711 (l = 45°), cos s = R_L·V = 0.70711 (s = 45°)
│ diffuse      Kd                          0.40000   0.50000   0.60000
│            × cos l                       0.70711   0.70711   0.70711
│ spéculaire + W = Ks                      0.25000   0.25000   0.25000
│            × cosⁿ s, n = 2               0.50000   0.50000   0.50000
│            × I_L                         1.00000   1.00000   1.00000
│            = (Kd·cos l + W·cosⁿ s)·I_L   0.40784   0.47855   0.54926
│ E          ⊕ source                      0.75698   0.83105   0.89615
│ couleur : E borné à 0..1                 0.75698   0.83105   0.89615
└─ … 1 autre rayon plus bas (--levels)

                               rouge      vert      bleu
couleur du pixel, c          0.75698   0.83105   0.89615
octet = floor(255·c + 0.5)       193       212       229
c du moteur                  0.75698   0.83105   0.89615
octet du moteur                  193       212       229
";

/// A prism of dispersing glass with a mirror behind it, in a fog-coloured void.
const PRISM: &str = r#"<scene version="1" name="Prism">
  <world ambient="0.3" background="0.4 0.5 0.6" depth="5"/>
  <material name="flint" ka="0.1" kd="0.1" ks="0.6" n="40 50 60" kr="0.2" kt="0.8 0.9 0.9" index="1.5 1.6 1.7"/>
  <material name="silver" ka="0.1" kd="0.2" ks="0.8" w="schlick" kr="0.7" highlight="blinn"/>
  <light name="left" position="-3 2 3" color="0.9 0.8 0.7"/>
  <light name="right" position="4 1 5"/>
  <cube name="prism" center="0 0 0" edge="1" rotation="20 30 10" material="flint"/>
  <box name="mirror" origin="-2 -2 -2" u="4 0 0" v="0 4 0" w="0 0 0.1" material="silver"/>
</scene>
"#;

fn stage(scene: &str, view: &str) -> TempDir {
    let folder = folder();
    fs::write(folder.path().join("scene.xml"), scene).unwrap();
    fs::write(folder.path().join("view.xml"), view).unwrap();
    folder
}

/// What a run that succeeds prints.
fn told(folder: &Path, args: &[&str]) -> String {
    let (code, told, said) = run(folder, args);
    assert_eq!((code, said.as_str()), (0, ""), "{args:?}");
    told
}

#[test]
fn the_whole_text_in_english_and_french() {
    let folder = stage(BALL, AXIS);
    assert_eq!(told(folder.path(), &["explain", "scene.xml", "view.xml", "1", "1"]), BALL_TEXT);
    let french =
        ["explain", "scene.xml", "view.xml", "1", "1", "--lang", "fr", "--levels", "0", "--without", "shadows"];
    assert_eq!(told(folder.path(), &french), BALL_TEXT_FRENCH);
}

#[test]
fn refraction_dispersion_and_total_reflection_are_told_with_their_angles() {
    let folder = stage(PRISM, AXIS);
    let text = told(folder.path(), &["explain", "scene.xml", "view.xml", "1", "1"]);
    for part in [
        "│ refracted    red: n = 1 → n' = 1.5: i = ",
        "│              green: n = 1 → n' = 1.6: i = ",
        "│            × It seen along T1[r], T1[g], T1[b]  ",
        "├─ T1[r], refracted ray · level 1 · red only · in `prism`, index 1.5 1.6 1.7\n",
        "meets cube `prism` (facet ",
        "W = Ks + (1-Ks)(1-cos l)⁵",
        "cos s = N·H = ",
        " is beyond the critical angle ",
        "0: level 5 is the depth limit, no further ray\n",
    ] {
        assert!(text.contains(part), "`{part}` in\n{text}");
    }
    // a ray of one channel shows dashes in the others
    let red = text.split("├─ T1[r]").nth(1).unwrap();
    let ka = red.lines().find(|line| line.contains(" Ka ")).unwrap();
    assert!(ka.ends_with("0.10000         –         –"), "{ka}");
}

#[test]
fn the_other_compositions_are_told() {
    let text = |compose: &str| {
        let folder = stage(&BALL.replace("<world ", &format!("<world compose=\"{compose}\" ")), AXIS);
        told(folder.path(), &["explain", "scene.xml", "view.xml", "1", "1"])
    };
    let add = text("add");
    assert!(add.contains("composition: add, a + b, clamped to 0..1 at each ray; depth limit: 1\n"), "{add}");
    assert!(add.contains("│ E          + lamp                        0.67000   0.80000   0.98000\n"), "{add}");
    let each = text("screen-each");
    // .145 ⊕ .32 = .4186, ⊕ .2 = .53488
    assert!(each.contains("│ E          ⊕ diffuse            0.41860 "), "{each}");
    assert!(each.contains("│ E          ⊕ highlight          0.53488 "), "{each}");
}

/// The bytes at the end are those of the picture, for every pixel, with one sample and with several.
#[test]
fn the_explanation_ends_in_the_pictures_bytes() {
    for (scene, samples) in [(BALL, "1"), (PRISM, "1"), (PRISM, "2")] {
        let folder = stage(scene, &AXIS.replace("\"3\"", "\"5\""));
        let picture = told(folder.path(), &["scene.xml", "view.xml", "-", "--samples", samples]);
        let picture = lancer_formats::picture::read(picture.as_bytes()).unwrap();
        for (place, bytes) in picture.bytes.iter().enumerate() {
            let (x, y) = ((place % 5).to_string(), (place / 5).to_string());
            let args = ["explain", "scene.xml", "view.xml", &x, &y, "--json", "--samples", samples];
            let pixel: Value = serde_json::from_str(&told(folder.path(), &args)).unwrap();
            assert_eq!(pixel["bytes"], serde_json::json!(bytes), "{x} {y}");
            assert_eq!(pixel["engine"]["bytes"], pixel["bytes"], "{x} {y}");
            let (color, engine) = (triple(&pixel["color"]), triple(&pixel["engine"]["color"]));
            assert!((0..3).all(|channel| near(color[channel], engine[channel])), "{color:?} {engine:?}");
            assert_eq!(pixel["samples"].as_array().unwrap().len(), if samples == "1" { 1 } else { 4 });
            pixel["samples"].as_array().unwrap().iter().for_each(check_sample);
        }
    }
}

fn triple(value: &Value) -> [f64; 3] {
    let value = value.as_array().unwrap();
    [0, 1, 2].map(|channel| value[channel].as_f64().unwrap())
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-12
}

/// Every number of a sample's tree follows from those before it (subject §2, §1.3).
fn check_sample(sample: &Value) {
    let rays = sample["rays"].as_array().unwrap();
    assert_eq!(triple(&rays[0]["color"]), triple(&sample["color"]));
    for ray in rays {
        let children: Vec<&Value> =
            ray["children"].as_array().unwrap().iter().map(|child| &rays[child.as_u64().unwrap() as usize]).collect();
        for child in &children {
            assert_eq!(child["level"].as_u64().unwrap(), ray["level"].as_u64().unwrap() + 1);
        }
        let Some(hit) = ray.get("hit") else {
            assert!(children.is_empty());
            continue;
        };
        let channels: Vec<usize> =
            ray["channels"].as_array().unwrap().iter().map(|channel| channel.as_u64().unwrap() as usize).collect();
        let surface = &hit["surface"];
        let mut sum = [0.0; 3];
        for term in hit["terms"].as_array().unwrap() {
            let value = match term["term"].as_str().unwrap() {
                "ambient" => product(&term["ka"], &term["ia"]),
                "reflected" => product(&term["kr"], &term["ir"]),
                "refracted" => product(&term["kt"], &term["it"]),
                "lamp" if term["state"] == "lit" => {
                    let (cos_l, cos_s) = (term["cos_l"].as_f64().unwrap(), term["cos_s"].as_f64().unwrap());
                    let (kd, w, n) = (triple(&surface["kd"]), triple(&term["w"]), triple(&surface["n"]));
                    let lamp = triple(&term["color"]);
                    [0, 1, 2].map(|c| (kd[c] * cos_l + w[c] * cos_s.powf(n[c])) * lamp[c])
                }
                "lamp" => [0.0; 3],
                other => panic!("{other}"),
            };
            let so_far = triple(&term["so_far"]);
            for &channel in &channels {
                sum[channel] = 1.0 - (1.0 - sum[channel]) * (1.0 - value[channel].clamp(0.0, 1.0));
                assert!(near(sum[channel], so_far[channel]), "{term} in {ray}");
            }
        }
        let color = triple(&ray["color"]);
        assert!(channels.iter().all(|&channel| near(color[channel], sum[channel])), "{ray}");
        for path in hit["terms"][2]["paths"].as_array().unwrap() {
            check_path(ray, hit, path, &children);
        }
    }
}

fn product(a: &Value, b: &Value) -> [f64; 3] {
    let (a, b) = (triple(a), triple(b));
    [0, 1, 2].map(|channel| a[channel] * b[channel])
}

/// n·sin i = n'·sin r, or more than the critical angle.
fn check_path(ray: &Value, hit: &Value, path: &Value, children: &[&Value]) {
    let sine = |direction: [f64; 3]| {
        let normal = triple(&hit["geometric_normal"]);
        let cosine: f64 = (0..3).map(|axis| direction[axis] * normal[axis]).sum();
        (1.0 - cosine * cosine).max(0.0).sqrt()
    };
    let (n, n_prime) = (path["n"].as_f64().unwrap(), path["n_prime"].as_f64().unwrap());
    let sin_i = sine(triple(&ray["direction"]));
    if path["total_reflection"] == true {
        assert!(n * sin_i > n_prime - 1e-9);
        return;
    }
    let refracted = children
        .iter()
        .find(|child| child["kind"] == "refracted" && child["channels"] == path["channels"])
        .unwrap_or_else(|| panic!("no ray for {path} in {ray}"));
    assert!((n * sin_i - n_prime * sine(triple(&refracted["direction"]))).abs() < 1e-7, "{path} in {ray}");
}
