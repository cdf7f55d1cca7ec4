//! An explanation as text: the rays as a tree of lines, below each ray what it meets and the table of its sum.

use super::Explanation;
use super::table::{Line, terms};
use lancer_formats::text::called;
use lancer_scene::Compose;
use lancer_trace::explain::RayNames;
use lancer_trace::observe::{RayNode, Seen, SurfaceNode};
use lancer_trace::{Channels, RayKind, RayTree};
use lancer_words::digits::{length, triple, vector};
use lancer_words::{Lang, explain as words, number};
use std::io::{self, Write};
use unicode_width::UnicodeWidthStr;

/// The width of a column of channel values.
const CHANNEL_WIDTH: usize = 9;

/// Writes the whole explanation. Rays below `levels` are only counted.
///
/// # Errors
/// What `out` says.
pub(super) fn write(
    explanation: &Explanation<'_>,
    levels: Option<u32>,
    lang: Lang,
    out: &mut dyn Write,
) -> io::Result<()> {
    let Explanation { scene, view, settings, pixel, x, y, .. } = explanation;
    writeln!(out, "{}", words::title(lang, x, y, &view.name, view.width, view.height))?;
    if !scene.name.is_empty() {
        writeln!(out, "{}", words::scene_title(lang, one_line(&scene.name)))?;
    }
    let compose = match scene.world.compose {
        Compose::Screen => words::compose_screen(lang),
        Compose::ScreenEach => words::compose_screen_each(lang),
        Compose::Add => words::compose_add(lang),
    };
    writeln!(out, "{}", words::rules(lang, compose, settings.depth))?;
    let steps = [
        (settings.steps.shadows, words::step_shadows(lang)),
        (settings.steps.reflection, words::step_reflection(lang)),
        (settings.steps.transparency, words::step_transparency(lang)),
    ];
    let left_out: Vec<String> = steps.into_iter().filter(|(done, _)| !done).map(|(_, step)| step).collect();
    if !left_out.is_empty() {
        writeln!(out, "{}", words::left_out(lang, left_out.join(", ")))?;
    }
    let count = pixel.samples.len();
    for (number, sample) in (1..).zip(&pixel.samples) {
        writeln!(out)?;
        if count > 1 {
            writeln!(out, "{}\n", words::sample(lang, number, count, length(sample.x), length(sample.y)))?;
        }
        let teller = Teller { explanation, tree: &sample.tree, names: RayNames::new(&sample.tree), levels, lang };
        teller.ray(0, "", "", out)?;
    }
    write!(out, "\n{}", end(explanation, lang))
}

/// A title on one line, whatever characters it holds.
fn one_line(title: &str) -> String {
    title.chars().map(|character| if character.is_control() { '\u{FFFD}' } else { character }).collect()
}

/// The last table: samples, their mean, the bytes.
fn end(explanation: &Explanation<'_>, lang: Lang) -> String {
    let pixel = &explanation.pixel;
    let mut lines = vec![heads(lang)];
    if pixel.samples.len() > 1 {
        for (number, sample) in (1..).zip(&pixel.samples) {
            lines.push(Line::values(words::sample_color(lang, number), sample.color));
        }
        lines.push(Line::values(words::mean(lang), pixel.color));
    } else {
        lines.push(Line::values(words::pixel_color(lang), pixel.color));
    }
    let (color, _) = explanation.engine;
    let bytes = color.to_bytes();
    lines.push(Line::cells(words::bytes(lang), pixel.bytes.map(|byte| byte.to_string())));
    lines.push(Line::values(words::engine_color(lang), color));
    lines.push(Line::cells(words::engine_bytes(lang), bytes.map(|byte| byte.to_string())));
    let most = pixel.bytes.iter().zip(bytes).map(|(own, other)| own.abs_diff(other)).max();
    let remark = match most.unwrap_or(0) {
        0 => None,
        1 => Some(words::engine_rounds(lang)),
        most => Some(words::engine_differs(lang, most)),
    };
    lines.extend(remark.into_iter().flat_map(|remark| [Line::Blank, Line::Text(remark)]));
    laid_out(&lines).join("\n") + "\n"
}

/// The names of the channels, above their columns.
fn heads(lang: Lang) -> Line {
    Line::cells(String::new(), words::channels(lang))
}

/// Writes one sample's tree.
struct Teller<'a> {
    explanation: &'a Explanation<'a>,
    tree: &'a RayTree,
    names: RayNames<'a>,
    levels: Option<u32>,
    lang: Lang,
}

impl Teller<'_> {
    /// A ray and all below it. `first` stands before its first line, `rest` before all others.
    fn ray(&self, ray: usize, first: &str, rest: &str, out: &mut dyn Write) -> io::Result<()> {
        let lang = self.lang;
        let Some(node) = self.tree.nodes.get(ray) else { return Ok(()) };
        writeln!(out, "{first}{}", self.heading(ray, node))?;
        let cut = self.levels.is_some_and(|levels| node.level >= levels) && !node.children.is_empty();
        let stem = if node.children.is_empty() { "  " } else { "│ " };
        for line in laid_out(&self.body(ray, node)) {
            writeln!(out, "{}", format!("{rest}{stem}{line}").trim_end())?;
        }
        if cut {
            let more = number::more_rays(lang, self.rays_below(ray));
            return writeln!(out, "{rest}└─ {}", words::rays_below(lang, more));
        }
        for (place, &child) in (1..).zip(&node.children) {
            writeln!(out, "{rest}│")?;
            let (branch, stem) = if place == node.children.len() { ("└─ ", "   ") } else { ("├─ ", "│  ") };
            self.ray(child, &format!("{rest}{branch}"), &format!("{rest}{stem}"), out)?;
        }
        Ok(())
    }

    /// How many rays stem from a ray.
    fn rays_below(&self, ray: usize) -> usize {
        let mut open = vec![ray];
        let mut count = 0;
        while let Some(ray) = open.pop() {
            let children = self.tree.nodes.get(ray).map_or(&[][..], |node| &node.children);
            count += children.len();
            open.extend(children);
        }
        count
    }

    /// The ray's name, its level and the medium that it travels in.
    fn heading(&self, ray: usize, node: &RayNode) -> String {
        let lang = self.lang;
        let name = self.names.of(ray);
        let what = match node.kind {
            RayKind::Primary => words::primary(lang),
            RayKind::Reflected => words::reflected(lang, name),
            RayKind::Refracted => words::refracted(lang, name),
        };
        let medium = node.media.last().map_or_else(|| words::surroundings(lang), |object| words::inside(lang, object));
        let mut parts = vec![what, words::level(lang, node.level)];
        if node.channels != Channels::ALL {
            let names = words::channels(lang);
            let carried: Vec<&str> = node.channels.iter().map(|channel| names[channel].as_str()).collect();
            parts.push(words::carries(lang, carried.join(", ")));
        }
        parts.push(words::travels_in(lang, medium, triple(node.index.to_array())));
        parts.join(" · ")
    }

    /// What the ray meets and how its colour comes about.
    fn body(&self, ray: usize, node: &RayNode) -> Vec<Line> {
        let lang = self.lang;
        let mut lines = vec![Line::Text(words::from_along(
            lang,
            vector(node.ray.origin.to_array()),
            vector(node.ray.direction.to_array()),
        ))];
        match &node.seen {
            Seen::Background(_) => {
                lines.push(Line::Text(words::meets_nothing(lang)));
                lines.push(Line::Blank);
                lines.push(heads(lang));
                lines.push(Line::carried(words::background(lang), node.color, node.channels));
            }
            Seen::Surface(surface) => {
                lines.extend(self.meeting(node, surface));
                lines.push(Line::Blank);
                lines.push(heads(lang));
                let compose = self.explanation.scene.world.compose;
                lines.extend(terms((self.tree, &self.names), node, surface, compose, lang));
                let what = match node.kind {
                    RayKind::Primary => words::clamped_sum(lang),
                    RayKind::Reflected | RayKind::Refracted => words::seen_color(lang, self.names.of(ray)),
                };
                lines.push(Line::carried(what, node.color, node.channels));
            }
        }
        lines
    }

    /// What is met, where and at which angle.
    fn meeting(&self, node: &RayNode, surface: &SurfaceNode) -> Vec<Line> {
        let lang = self.lang;
        let object = self.explanation.scene.objects.iter().find(|object| object.name == surface.object);
        let side = words::side_met(lang, surface.sheet, surface.entering);
        let called = object.map_or_else(|| surface.object.to_string(), |object| called(object, surface.facet, lang));
        let mut meets = vec![words::meets(lang, called, length(surface.distance)), side];
        if let Some(name) = object.and_then(|object| object.material.name()) {
            meets.push(words::material(lang, name));
        }
        let normal = surface.geometric_normal;
        let smooth = (surface.normal != normal).then(|| surface.normal.to_array());
        let cos_i = -node.ray.direction.dot(normal);
        let place = words::place(lang, surface.point.to_array(), normal.to_array(), cos_i, smooth);
        vec![Line::Text(meets.join(", ")), Line::Text(place)]
    }
}

/// The lines with the tables' columns one below the other.
fn laid_out(lines: &[Line]) -> Vec<String> {
    let widest = lines
        .iter()
        .map(|line| match line {
            Line::Row { label, .. } => label.width(),
            Line::Text(_) | Line::Blank => 0,
        })
        .max()
        .unwrap_or(0);
    lines
        .iter()
        .map(|line| match line {
            Line::Blank => String::new(),
            Line::Text(text) => text.clone(),
            Line::Row { label, cells } => {
                let mut row = format!("{label}{}", " ".repeat(widest - label.width()));
                for cell in cells {
                    row += &format!(" {}{cell}", " ".repeat(CHANNEL_WIDTH.saturating_sub(cell.width())));
                }
                row
            }
        })
        .collect()
}
