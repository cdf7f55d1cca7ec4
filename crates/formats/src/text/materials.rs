//! The materials: a line each, or three where the channels differ, with the numbers of red, green and blue below each
//! other as the subject writes its formulas (§2.6).

use super::clean;
use super::table::{Cell, Table};
use lancer_scene::{MaterialRef, Name, Rgb, Scene, Surface};
use lancer_words::{Lang, term, text as words};
use std::collections::HashMap;
use std::sync::Arc;

pub(super) fn lines(scene: &Scene, lang: Lang) -> Vec<String> {
    let mut table = Table::new([2, 2, 3, 3, 3, 2, 3, 3, 3, 3, 3]);
    let symbols = ["Ka", "Kd", "W"].map(Cell::text);
    let rest = [term::law(lang), "n".into(), "Kr".into(), "Kt".into(), term::index(lang), term::highlight(lang)];
    let heading = [vec![Cell::text(term::name(lang)), Cell::Blank], symbols.to_vec(), rest.map(Cell::Text).to_vec()];
    table.push(heading.concat());
    let named = scene.materials.iter().map(|material| (clean(&material.name), &material.surface));
    let built_in = Surface::default();
    let uses_built_in = scene
        .objects
        .iter()
        .flat_map(|object| object.material_refs())
        .any(|material| matches!(material, MaterialRef::Default));
    let grey = uses_built_in.then(|| (words::grey(lang), &built_in));
    let own = OwnSurfaces::of(scene, lang).rows;
    let rows: Vec<_> = named.chain(own).chain(grey).collect();
    if rows.is_empty() {
        return vec![format!("  {}", words::none_feminine(lang))];
    }
    for (name, surface) in rows {
        push(&mut table, name, surface, lang);
    }
    table.lines()
}

/// The surfaces without a name, each once, under the object or the part that has it first.
pub(super) struct OwnSurfaces<'a> {
    rows: Vec<(String, &'a Surface)>,
    /// The first object with each of them, and its row.
    places: HashMap<*const Surface, (&'a Name, usize)>,
}

impl<'a> OwnSurfaces<'a> {
    pub(super) fn of(scene: &'a Scene, lang: Lang) -> OwnSurfaces<'a> {
        let mut own = OwnSurfaces { rows: Vec::new(), places: HashMap::new() };
        for object in &scene.objects {
            // The object's own material is the first of these, then come those of its parts.
            for (material, part) in object.material_refs().zip(0_usize..) {
                let MaterialRef::Inline(surface) = material else { continue };
                own.places.entry(Arc::as_ptr(surface)).or_insert_with(|| {
                    let name = match part.checked_sub(1) {
                        None => words::own_surface_of(lang, clean(&object.name)),
                        Some(part) => words::own_surface_of_part(lang, clean(&object.name), part),
                    };
                    own.rows.push((name, &**surface));
                    (&object.name, own.rows.len() - 1)
                });
            }
        }
        own
    }

    /// How the object of that name says which material it or a part of it has.
    pub(super) fn label(&self, material: &MaterialRef, object: &Name, lang: Lang) -> String {
        match material {
            MaterialRef::Default => words::grey(lang),
            MaterialRef::Named(name) => clean(name),
            MaterialRef::Inline(surface) => match self.places.get(&Arc::as_ptr(surface)) {
                Some((first, row)) if *first != object => self.rows[*row].0.clone(),
                Some(_) | None => words::own(lang),
            },
        }
    }
}

fn push(table: &mut Table, name: String, surface: &Surface, lang: Lang) {
    let Surface { ka, kd, ks, w, shininess, kr, kt, index, highlight } = surface;
    let uniform = [ka, kd, ks, shininess, kr, kt, index].into_iter().all(|value| value.is_uniform());
    for (channel, letter) in term::channels(lang).into_iter().enumerate().take(if uniform { 1 } else { 3 }) {
        let first = channel == 0;
        let once = |text: &str| if first { Cell::text(text) } else { Cell::Blank };
        // Where the channels agree, the first line says it for all.
        let number =
            |value: &Rgb| if first || !value.is_uniform() { Cell::number(value[channel]) } else { Cell::Blank };
        table.push(vec![
            once(&name),
            if uniform { Cell::Blank } else { Cell::text(letter) },
            number(ka),
            number(kd),
            number(ks),
            once(w.word()),
            number(shininess),
            number(kr),
            number(kt),
            number(index),
            once(highlight.word()),
        ]);
    }
}
