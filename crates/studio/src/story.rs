//! What is told of a pixel, line by line: below each ray what it meets, every factor of every term, the running sum
//! after each (subject §2.5, §2.6), then the rays that it gives rise to. A ray that is folded is one line.

use crate::explainer::Explanation;
use lancer_formats::text::called;
use lancer_scene::Rgb;
use lancer_trace::explain::{Course, Entry, Factor, Part, RayNames, Way, account};
use lancer_trace::observe::{LampLight, Omitted, RayNode, RayTree, Seen, SurfaceNode};
use lancer_trace::{Channels, RayKind};
use lancer_words::digits::{channel, length, triple, vector};
use lancer_words::{Lang, explain as words};
use std::collections::BTreeSet;

/// A line.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// How far it is indented: the level of its ray, one more below the ray's own line.
    pub indent: usize,
    /// What it says.
    pub what: What,
}

/// What a line says.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// A ray with its colour.
    Ray {
        /// Its number in the tree.
        ray: usize,
        /// Whether what it sees stands below it.
        open: bool,
        /// Its name, level and medium.
        heading: String,
        /// Its colour.
        cells: [String; 3],
    },
    /// The name of a term.
    Term(String),
    /// A sentence.
    Text(String),
    /// A factor or a product: red, green, blue.
    Values(String, [String; 3]),
    /// The running sum after a term.
    Sum(String, [String; 3]),
}

/// The lines of one sample; the rays in `open` are unfolded.
pub fn lines(explanation: &Explanation, tree: &RayTree, open: &BTreeSet<usize>, lang: Lang) -> Vec<Line> {
    let names = RayNames::new(tree);
    let mut teller = Teller { explanation, tree, open, names, lang, indent: 0, channels: Channels::ALL, lines: vec![] };
    teller.ray(0);
    teller.lines
}

/// The lines as text, for the clipboard.
pub fn text(lines: &[Line]) -> String {
    let widest = |line: &Line| match &line.what {
        What::Values(label, _) | What::Sum(label, _) => line.indent * 2 + label.chars().count(),
        What::Ray { .. } | What::Term(_) | What::Text(_) => 0,
    };
    let width = lines.iter().map(widest).max().unwrap_or(0);
    let mut text = String::new();
    for line in lines {
        let lead = "  ".repeat(line.indent);
        let (label, cells) = match &line.what {
            What::Term(label) | What::Text(label) => (label, None),
            What::Ray { heading, cells, .. } => (heading, Some(cells)),
            What::Values(label, cells) | What::Sum(label, cells) => (label, Some(cells)),
        };
        match cells {
            None => text += &format!("{lead}{label}\n"),
            Some([r, g, b]) => {
                let room = width.saturating_sub(lead.len() + label.chars().count());
                text += &format!("{lead}{label}{}  {r:>9} {g:>9} {b:>9}\n", " ".repeat(room));
            }
        }
    }
    text
}

struct Teller<'a> {
    explanation: &'a Explanation,
    tree: &'a RayTree,
    open: &'a BTreeSet<usize>,
    names: RayNames<'a>,
    lang: Lang,
    indent: usize,
    /// The channels of the ray that is told of.
    channels: Channels,
    lines: Vec<Line>,
}

impl<'a> Teller<'a> {
    fn add(&mut self, what: What) {
        self.lines.push(Line { indent: self.indent, what });
    }

    fn text(&mut self, text: String) {
        self.add(What::Text(text));
    }

    /// A dash stands in the channels that the ray does not carry.
    fn cells(&self, value: Rgb) -> [String; 3] {
        [0, 1, 2].map(|index| if self.channels.contains(index) { channel(value[index]) } else { "–".to_owned() })
    }

    fn values(&mut self, label: String, value: Rgb) {
        let cells = self.cells(value);
        self.add(What::Values(label, cells));
    }

    /// A ray and what stands below it; the stack of a deep tree is bounded by the depth limit.
    fn ray(&mut self, ray: usize) {
        let (tree, lang) = (self.tree, self.lang);
        let Some(node) = tree.nodes.get(ray) else { return };
        let before = std::mem::replace(&mut self.channels, node.channels);
        let (open, heading, cells) = (self.open.contains(&ray), self.heading(ray, node), self.cells(node.color));
        self.add(What::Ray { ray, open, heading, cells });
        self.indent += 1;
        if open {
            let (origin, direction) = (vector(node.ray.origin.to_array()), vector(node.ray.direction.to_array()));
            self.text(words::from_along(lang, origin, direction));
            match &node.seen {
                Seen::Background(_) => self.text(words::meets_nothing(lang)),
                Seen::Surface(surface) => {
                    self.meeting(node, surface);
                    self.terms(node, surface);
                }
            }
            for &child in &node.children {
                self.ray(child);
            }
        }
        self.indent -= 1;
        self.channels = before;
    }

    fn heading(&self, ray: usize, node: &RayNode) -> String {
        let (lang, name) = (self.lang, self.names.of(ray));
        let what = match node.kind {
            RayKind::Primary => words::primary(lang),
            RayKind::Reflected => words::reflected(lang, name),
            RayKind::Refracted => words::refracted(lang, name),
        };
        let seen = match &node.seen {
            Seen::Background(_) => words::background(lang),
            Seen::Surface(surface) => words::inside(lang, &surface.object),
        };
        format!("{what} → {seen}")
    }

    /// What is met, where, and at which angle.
    fn meeting(&mut self, node: &RayNode, surface: &SurfaceNode) {
        let lang = self.lang;
        let object = self.explanation.scene.objects.iter().find(|object| object.name == surface.object);
        let side = words::side_met(lang, surface.sheet, surface.entering);
        let called = object.map_or_else(|| surface.object.to_string(), |object| called(object, surface.facet, lang));
        let mut meets = vec![words::meets(lang, called, length(surface.distance)), side];
        if let Some(name) = object.and_then(|object| object.material.name()) {
            meets.push(words::material(lang, name));
        }
        let medium = node.media.last().map_or_else(|| words::surroundings(lang), |object| words::inside(lang, object));
        meets.push(words::travels_in(lang, medium, triple(node.index.to_array())));
        self.text(meets.join(", "));
        let normal = surface.geometric_normal;
        let smooth = (surface.normal != normal).then(|| surface.normal.to_array());
        let cos_i = -node.ray.direction.dot(normal);
        self.text(words::place(lang, surface.point.to_array(), normal.to_array(), cos_i, smooth));
    }

    fn terms(&mut self, node: &RayNode, surface: &SurfaceNode) {
        for entry in account(self.tree, node, surface, self.explanation.scene.world.compose) {
            self.entry(node, entry);
        }
    }

    fn entry(&mut self, node: &RayNode, entry: Entry<'_>) {
        let lang = self.lang;
        match entry {
            Entry::Begin(part) => match part {
                Part::Ambient => self.add(What::Term(words::ambient(lang))),
                Part::Mirror => self.add(What::Term(words::mirror(lang))),
                Part::Glass => self.add(What::Term(words::glass(lang))),
                Part::Lamp { name, distance } => self.add(What::Term(words::lamp(lang, name, length(distance)))),
                Part::Diffuse | Part::Highlight => {}
            },
            Entry::Omitted { part, why } => self.text(match why {
                Omitted::NoCoefficient if part == Part::Mirror => words::no_mirror(lang),
                Omitted::NoCoefficient => words::no_glass(lang),
                Omitted::DepthReached => words::depth_reached(lang, node.level),
                Omitted::StepLeftOut => words::step_left_out(lang),
            }),
            Entry::Way(way) => self.way(&way),
            Entry::Lamp { light, cos_s } => self.text(match light {
                LampLight::Lit(lit) => words::lights(lang, lit.cos_l, cos_s, lit.cos_s),
                LampLight::Blocked { by, .. } => words::blocked(lang, by),
                LampLight::Behind { cos_l } => words::behind(lang, channel(*cos_l)),
                LampLight::AtPoint => words::at_point(lang),
            }),
            Entry::Value { sign, factor, value } => {
                let what = self.factor(&factor);
                self.values(signed(sign, &what), value);
            }
            Entry::Sum { sign, part, so_far } => {
                let what = match part {
                    Part::Ambient => "Ka·Ia".to_owned(),
                    Part::Mirror => "Kr·Ir".to_owned(),
                    Part::Glass => "Kt·It".to_owned(),
                    Part::Lamp { .. } => words::lamp_term(lang),
                    Part::Diffuse => words::diffuse(lang),
                    Part::Highlight => words::highlight(lang),
                };
                let cells = self.cells(so_far);
                self.add(What::Sum(format!("E {sign} {what}"), cells));
            }
        }
    }

    fn factor(&self, factor: &Factor) -> String {
        match factor {
            Factor::Symbol(symbol) => (*symbol).to_owned(),
            Factor::Power { n } => format!("cosⁿ s, n = {}", triple(n.to_array())),
            Factor::Seen { symbol, rays } => {
                let names: Vec<String> = rays.iter().map(|&ray| self.names.of(ray)).collect();
                words::seen_along(self.lang, symbol, names.join(", "))
            }
            Factor::Clamped => words::clamped_term(self.lang),
        }
    }

    fn way(&mut self, way: &Way) {
        let lang = self.lang;
        let told = match way.course {
            Course::Straight => words::straight_on(lang),
            Course::Bent { indices, cos_i, cos_r } => words::bent(lang, indices, cos_i, cos_r),
            Course::Reflected { indices, cos_i, cos_critical } => words::not_bent(lang, indices, cos_i, cos_critical),
        };
        let Some(channels) = way.channels else { return self.text(told) };
        let names = words::channels(lang);
        let carried: Vec<&str> = channels.iter().map(|channel| names[channel].as_str()).collect();
        self.text(format!("{} · {told}", words::carries(lang, carried.join(", "))));
    }
}

/// A label behind its sign, if it has one.
fn signed(sign: &str, what: &str) -> String {
    if sign.is_empty() { what.to_owned() } else { format!("{sign} {what}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lancer_scene::{DVec3, List, Object, PointLight, Scene, ScreenSpec, Shape, Steps, Surface, View};
    use lancer_trace::{Camera, Cancel, Settings, World, explain};
    use std::sync::Arc;

    /// A mirror ball before a background, lit from the eye.
    fn explanation() -> Explanation {
        let surface = Surface { kr: Rgb::splat(0.5), ..Surface::default() };
        let ball = Object {
            material: lancer_scene::MaterialRef::Inline(Arc::new(surface)),
            ..Object::new("ball", Shape::Sphere { center: DVec3::ZERO, radius: 1.0 })
        };
        let scene = Scene {
            objects: std::iter::once(ball).collect::<List<Object>>(),
            lights: std::iter::once(PointLight::new("lamp", DVec3::Z * 5.0)).collect::<List<PointLight>>(),
            ..Scene::default()
        };
        let view = View {
            name: "front".into(),
            width: 3,
            height: 3,
            eye: DVec3::Z * 4.0,
            screen: ScreenSpec::LookAt { look_at: DVec3::ZERO, up: DVec3::Y, fov: 40.0 },
            samples: 1,
            depth: None,
            steps: Steps::default(),
        };
        let (world, camera) = (World::compile(&scene), Camera::new(&view).unwrap());
        let pixel = explain(&world, &camera, Settings::of(&world, &view), (1, 1), &Cancel::default()).unwrap();
        Explanation { scene, view, pixel: (1, 1), outcome: Ok(pixel) }
    }

    /// Ka·Ia = 0.2·0.2, a black background in the mirror, and (0.6·1 + 0)·1 of the lamp in front.
    #[test]
    fn every_term_of_the_sum_is_told() {
        let explanation = explanation();
        let tree = &explanation.outcome.as_ref().unwrap().samples[0].tree;
        let told = lines(&explanation, tree, &BTreeSet::from([0]), Lang::English);
        let sums: Vec<(&str, &str)> = told
            .iter()
            .filter_map(|line| match &line.what {
                What::Sum(label, [red, ..]) => Some((label.as_str(), red.as_str())),
                What::Ray { .. } | What::Term(_) | What::Text(_) | What::Values(..) => None,
            })
            .collect();
        // 0.04 ⊕ 0 = 0.04; 0.04 ⊕ 0.6 = 1 - 0.96·0.4 = 0.616
        assert_eq!(sums, [("E = Ka·Ia", "0.04000"), ("E ⊕ Kr·Ir", "0.04000"), ("E ⊕ lamp", "0.61600")]);
        let text = text(&told);
        for due in
            ["primary ray → `ball`", "× Ir seen along R1", "R1, reflected ray → colour of infinity", "Kt = 0, opaque"]
        {
            assert!(text.contains(due), "{due} in {text}");
        }
        // a folded ray is one line
        assert_eq!(lines(&explanation, tree, &BTreeSet::new(), Lang::French).len(), 1);
    }
}
