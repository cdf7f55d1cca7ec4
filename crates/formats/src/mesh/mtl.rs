//! Wavefront material libraries, translated into the coefficients of the subject.
//!
//! | library | surface |
//! |---|---|
//! | `Ka`, `Kd`, `Ks`, `Ns`, `Ni` | `Ka`, `Kd`, `W`, `n`, refraction index; without `Ka`, a third of `Kd` |
//! | `d` (or `Tr` = 1 - `d`), `Tf` | `Kt` is `Tf·(1-d)`; `Ka` and `Kd` are scaled by `d`, what is left of them |
//! | `illum` 0, 1 | no highlight |
//! | `illum` 3 to 9 | `Kr` is `Ks` |
//!
//! A library never makes a mesh useless: what is wrong in it is a warning, and the coefficient keeps its default.

use super::words::{Words, number, quoted};
use super::{MeshFault, MeshProblem};
use lancer_scene::{Rgb, Surface, limits};
use std::collections::HashMap;
use std::sync::Arc;

/// The share of `Kd` that stands for a missing `Ka`, as in the built-in grey.
const AMBIENT_SHARE: f64 = 1.0 / 3.0;

/// The materials of a library, and the warnings about it.
pub(super) fn read(file: &Arc<str>, bytes: &[u8]) -> (HashMap<Vec<u8>, Arc<Surface>>, Vec<MeshProblem>) {
    let mut warnings = Vec::new();
    let mut materials = HashMap::new();
    let mut current: Option<(Vec<u8>, Entry)> = None;
    let mut textures = false;
    for (line, text) in (1..).zip(bytes.split(|byte| *byte == b'\n')) {
        let text = text.trim_ascii();
        let mut words = Words::new(text, line);
        let Some(keyword) = words.next() else { continue };
        let warning = |fault| MeshProblem { file: Arc::clone(file), line: Some(line), fault };
        if keyword == b"newmtl" {
            materials.extend(current.take().map(Entry::finish));
            current = Some((text[6..].trim_ascii().to_owned(), Entry::default()));
        } else if keyword.starts_with(b"map_") && !textures {
            textures = true;
            warnings.push(warning(MeshFault::TexturesLeftOut));
        } else if let Some((_, entry)) = &mut current {
            warnings.extend(entry.set(keyword, words).err().map(warning));
        }
    }
    materials.extend(current.map(Entry::finish));
    (materials, warnings)
}

/// A material as the library gives it.
struct Entry {
    ka: Option<Rgb>,
    kd: Rgb,
    ks: Rgb,
    shininess: f64,
    index: f64,
    /// `d`, the opacity.
    opacity: f64,
    /// `Tf`.
    filter: Rgb,
    /// `illum`; 2 is the plain model.
    model: f64,
}

impl Default for Entry {
    fn default() -> Entry {
        let Surface { kd, ks, shininess, index, .. } = Surface::default();
        Entry { ka: None, kd, ks, shininess: shininess.r, index: index.r, opacity: 1.0, filter: Rgb::WHITE, model: 2.0 }
    }
}

impl Entry {
    fn set(&mut self, keyword: &[u8], mut words: Words<'_>) -> Result<(), MeshFault> {
        let name = quoted(keyword);
        let missing = || MeshFault::TooFewNumbers(name.clone());
        let mut scalar = |least: f64, greatest: f64, value: &mut f64| {
            // `d -halo 0.5`: the number is the last word.
            let given = number(words.by_ref().last().ok_or_else(missing)?)?;
            *value = if given.is_nan() { *value } else { given.clamp(least, greatest) };
            if *value == given { Ok(()) } else { Err(MeshFault::Clamped(name.clone())) }
        };
        match keyword {
            b"Ns" => scalar(0.0, limits::SHININESS, &mut self.shininess),
            b"Ni" => scalar(0.001, 1000.0, &mut self.index),
            b"d" => scalar(0.0, 1.0, &mut self.opacity),
            b"Tr" => {
                let mut clear = 1.0 - self.opacity;
                let result = scalar(0.0, 1.0, &mut clear);
                self.opacity = 1.0 - clear;
                result
            }
            b"illum" => scalar(0.0, 10.0, &mut self.model),
            b"Ka" => color(words, &name, self.ka.get_or_insert_default()),
            b"Kd" => color(words, &name, &mut self.kd),
            b"Ks" => color(words, &name, &mut self.ks),
            b"Tf" => color(words, &name, &mut self.filter),
            _ => Ok(()),
        }
    }

    fn finish((name, entry): (Vec<u8>, Entry)) -> (Vec<u8>, Arc<Surface>) {
        let Entry { ka, kd, ks, shininess, index, opacity, filter, model } = entry;
        let mirrors = (3.0..=9.0).contains(&model);
        let surface = Surface {
            ka: ka.unwrap_or(kd * AMBIENT_SHARE) * opacity,
            kd: kd * opacity,
            ks: if model < 2.0 { Rgb::BLACK } else { ks },
            shininess: Rgb::splat(shininess),
            kr: if mirrors { ks } else { Rgb::BLACK },
            kt: filter * (1.0 - opacity),
            index: Rgb::splat(index),
            ..Surface::default()
        };
        (name, Arc::new(surface))
    }
}

/// One number or three, brought into 0..1. The forms `spectral` and `xyz` are no numbers.
fn color(words: Words<'_>, name: &str, value: &mut Rgb) -> Result<(), MeshFault> {
    let numbers = words.take(3).map(number).collect::<Result<Vec<f64>, _>>()?;
    let given = match numbers[..] {
        [grey] => Rgb::splat(grey),
        [r, g, b] => Rgb::new(r, g, b),
        _ => return Err(MeshFault::TooFewNumbers(name.to_owned())),
    };
    *value = given.map(|channel| if channel.is_nan() { 0.0 } else { channel.clamp(0.0, 1.0) });
    if *value == given { Ok(()) } else { Err(MeshFault::Clamped(name.to_owned())) }
}
