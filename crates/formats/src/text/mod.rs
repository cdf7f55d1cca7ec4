//! The text display of a whole scene and of its views, for a person to read (subject §5.1: «l'ensemble de la scène devra
//! pouvoir être affichée dans un format texte»).
//!
//! Everything is shown in document order, in the subject's terms, with aligned columns that fit 100 characters unless
//! numbers are very long; a very long name stands on a line of its own. A colour of three equal numbers is shown as one.

mod called;
mod materials;
mod number;
mod objects;
mod table;
mod views;

use lancer_scene::{Compose, Environment, List, PointLight, Rgb, Scene};
use lancer_words::{Lang, number as count, term, text as words};
use number::shown;
use table::{Cell, Table};
use unicode_width::UnicodeWidthStr;

pub use called::called;
pub use views::describe_views;

/// Lists are broken into lines of at most that many characters.
const COLUMNS: usize = 100;

/// The whole scene as text; every line ends with a line feed.
pub fn describe(scene: &Scene, lang: Lang) -> String {
    let title = scene.name.trim_matches(' ');
    let title = if title.is_empty() { words::untitled(lang) } else { clean(title) };
    let counts = words::counts(
        lang,
        count::objects(lang, scene.objects.len()),
        count::lights(lang, scene.lights.len()),
        count::materials(lang, scene.materials.len()),
    );
    let mut text = format!("{title}\n{}\n{counts}\n", "═".repeat(title.width().min(COLUMNS)));
    section(&mut text, term::world(lang), world(&scene.world, lang));
    section(&mut text, term::lamps(lang), lamps(&scene.lights, lang));
    section(&mut text, term::materials(lang), materials::lines(scene, lang));
    section(&mut text, term::objects(lang), objects::lines(scene, lang));
    text
}

/// Appends a heading and its lines, with an empty line before them if there is something before them.
fn section(text: &mut String, heading: String, lines: Vec<String>) {
    if !text.is_empty() {
        text.push('\n');
    }
    for line in [heading.clone(), "─".repeat(heading.width())].into_iter().chain(lines) {
        text.push_str(&line);
        text.push('\n');
    }
}

fn world(world: &Environment, lang: Lang) -> Vec<String> {
    let mut table = Table::new([2, 2, 3, 1, 1]);
    let mut colour = |label: String, symbol: &str, value: Rgb| {
        table.push([vec![Cell::text(label), Cell::text(symbol)], triple(value)].concat());
    };
    colour(term::ambient_light(lang), "Ia", world.ambient);
    colour(term::colour_of_infinity(lang), "", world.background);
    colour(term::refraction_index(lang), "", world.index);
    table.push(vec![Cell::text(term::depth_limit(lang)), Cell::Blank, Cell::number(f64::from(world.depth))]);
    let compose = match world.compose {
        Compose::Screen => words::compose_screen(lang),
        Compose::ScreenEach => words::compose_screen_each(lang),
        Compose::Add => words::compose_add(lang),
    };
    table.push(vec![Cell::text(term::composition(lang)), Cell::Blank, Cell::Over(compose)]);
    table.lines()
}

fn lamps(lamps: &List<PointLight>, lang: Lang) -> Vec<String> {
    if lamps.is_empty() {
        return vec![format!("  {}", words::none_feminine(lang))];
    }
    let mut table = Table::new([2, 2, 3, 1, 1, 4, 1, 1]);
    let (position, colour) = (Cell::Over(term::position(lang)), Cell::Over("I_L".into()));
    table.push(vec![Cell::Blank, Cell::Text(term::name(lang)), position, Cell::Blank, Cell::Blank, colour]);
    for (lamp, number) in lamps.iter().zip(1_u32..) {
        let name = clean(&lamp.name);
        let name = if lamp.visible { name } else { words::hidden_lamp(lang, name) };
        let position = lamp.position.to_array().map(Cell::number);
        table.push([&[Cell::number(number.into()), Cell::text(name)][..], &position, &triple(lamp.color)].concat());
    }
    table.lines()
}

/// A colour or coefficient: one number if the channels are equal.
fn triple(value: Rgb) -> Vec<Cell> {
    let channels = if value.is_uniform() { vec![value.r] } else { value.to_array().to_vec() };
    channels.into_iter().map(Cell::number).collect()
}

/// Numbers in a row.
fn row(numbers: impl IntoIterator<Item = f64>) -> String {
    numbers.into_iter().map(shown).collect::<Vec<_>>().join(" ")
}

/// A name or a title as a terminal may show it: control characters could move its cursor or change its colours.
fn clean(name: &str) -> String {
    name.chars().map(|character| if character.is_control() { '\u{fffd}' } else { character }).collect()
}
