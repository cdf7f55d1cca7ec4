//! What is told of a pixel, line by line: below each ray what it meets, every factor of every term, the running sum
//! after each (subject §2.5, §2.6), then the rays that it gives rise to. A ray that is folded is one line.

use crate::explainer::Explanation;
use lancer_scene::{Color, Compose, DVec3, Highlight, Object, Reflectance, Rgb, Shape};
use lancer_trace::observe::{Composed, GlassPath, GlassTerm, LampLight, MirrorTerm, Omitted, RayNode, Seen, Term};
use lancer_trace::observe::{RayTree, SurfaceNode};
use lancer_trace::reference::intersect::ConeFace;
use lancer_trace::reference::light::Lit;
use lancer_trace::{Channels, RayKind};
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
    let mut parents = vec![0; tree.nodes.len()];
    for (number, node) in tree.nodes.iter().enumerate() {
        for &child in &node.children {
            parents[child] = number;
        }
    }
    let mut teller =
        Teller { explanation, tree, open, parents, lang, indent: 0, channels: Channels::ALL, lines: vec![] };
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
    parents: Vec<usize>,
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

    fn values(&mut self, label: impl Into<String>, value: Rgb) {
        let cells = self.cells(value);
        self.add(What::Values(label.into(), cells));
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
            let (origin, direction) = (vector(node.ray.origin), vector(node.ray.direction));
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

    /// The ray's name as in figure 3 of the subject: `R1` is mirrored at the first surface, `T1·R2` where `T1` ends.
    fn name(&self, ray: usize) -> String {
        let (mut steps, mut ray) = (Vec::new(), ray);
        while ray != 0 {
            let Some(node) = self.tree.nodes.get(ray) else { break };
            let letter = match node.kind {
                RayKind::Primary => "",
                RayKind::Reflected => "R",
                RayKind::Refracted => "T",
            };
            steps.push(format!("{letter}{}", node.level));
            ray = self.parents[ray];
        }
        steps.reverse();
        steps.join("·")
    }

    fn heading(&self, ray: usize, node: &RayNode) -> String {
        let (lang, name) = (self.lang, self.name(ray));
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
        let side = match surface {
            SurfaceNode { sheet: true, .. } => words::a_sheet(lang),
            SurfaceNode { entering: true, .. } => words::from_outside(lang),
            SurfaceNode { .. } => words::from_inside(lang),
        };
        let called = object.map_or_else(|| surface.object.to_string(), |object| called(object, surface.facet, lang));
        let mut meets = vec![words::meets(lang, called, length(surface.distance)), side];
        if let Some(name) = object.and_then(|object| object.material.name()) {
            meets.push(words::material(lang, name));
        }
        let medium = node.media.last().map_or_else(|| words::surroundings(lang), |object| words::inside(lang, object));
        meets.push(words::travels_in(lang, medium, triple(node.index)));
        self.text(meets.join(", "));
        let mut place = vec![
            format!("P = {}", vector(surface.point)),
            format!("N = {}", vector(surface.geometric_normal)),
            words::incidence(lang, degrees(-node.ray.direction.dot(surface.geometric_normal))),
        ];
        if surface.normal != surface.geometric_normal {
            place.push(words::smooth_normal(lang, vector(surface.normal)));
        }
        self.text(place.join(", "));
    }

    fn terms(&mut self, node: &RayNode, surface: &SurfaceNode) {
        let lang = self.lang;
        let mut before = Rgb::BLACK;
        for Composed { term, so_far } in &surface.terms {
            match term {
                Term::Ambient { ka, ia, .. } => {
                    self.add(What::Term(words::ambient(lang)));
                    self.values("Ka", *ka);
                    self.values("× Ia", *ia);
                    let cells = self.cells(*so_far);
                    self.add(What::Sum("E = Ka·Ia".to_owned(), cells));
                }
                Term::Mirror(mirror) => {
                    self.add(What::Term(words::mirror(lang)));
                    self.mirror(node, mirror, *so_far);
                }
                Term::Glass(glass) => {
                    self.add(What::Term(words::glass(lang)));
                    self.glass(node, surface, glass, *so_far);
                }
                Term::Lamp { name, color, distance, light, .. } => {
                    self.add(What::Term(words::lamp(lang, name, length(*distance))));
                    self.lamp(surface, *color, light, (before, *so_far));
                }
            }
            before = *so_far;
        }
    }

    /// The running sum after a term; for `⊕` the term is clamped first.
    fn sum(&mut self, what: &str, term: Color, so_far: Color) {
        let sign = match self.explanation.scene.world.compose {
            Compose::Add => "+",
            Compose::Screen | Compose::ScreenEach => {
                if term.clamp01() != term {
                    self.values(words::clamped_term(self.lang), term.clamp01());
                }
                "⊕"
            }
        };
        let cells = self.cells(so_far);
        self.add(What::Sum(format!("E {sign} {what}"), cells));
    }

    fn mirror(&mut self, node: &RayNode, mirror: &MirrorTerm, so_far: Color) {
        if let Some(omitted) = mirror.omitted {
            return self.omitted(node, omitted, words::no_mirror(self.lang));
        }
        self.values("Kr", mirror.kr);
        let along = self.seen_along(node, "Ir", |kind| kind == RayKind::Reflected);
        self.values(format!("× {along}"), mirror.ir);
        self.values("= Kr·Ir", mirror.value);
        self.sum("Kr·Ir", mirror.value, so_far);
    }

    fn glass(&mut self, node: &RayNode, surface: &SurfaceNode, glass: &GlassTerm, so_far: Color) {
        if let Some(omitted) = glass.omitted {
            return self.omitted(node, omitted, words::no_glass(self.lang));
        }
        for path in &glass.paths {
            let way = self.way(node, surface, path);
            self.text(way);
        }
        self.values("Kt", glass.kt);
        let total = glass.paths.iter().any(|path| path.total_reflection);
        let along = self.seen_along(node, "It", |kind| kind == RayKind::Refracted || total);
        self.values(format!("× {along}"), glass.it);
        self.values("= Kt·It", glass.value);
        self.sum("Kt·It", glass.value, so_far);
    }

    fn omitted(&mut self, node: &RayNode, omitted: Omitted, no_coefficient: String) {
        let reason = match omitted {
            Omitted::NoCoefficient => no_coefficient,
            Omitted::DepthReached => words::depth_reached(self.lang, node.level),
            Omitted::StepLeftOut => words::step_left_out(self.lang),
        };
        self.text(reason);
    }

    /// `Ir seen along R1`, with every ray of those kinds.
    fn seen_along(&self, node: &RayNode, symbol: &str, serves: impl Fn(RayKind) -> bool) -> String {
        let kind = |ray: &&usize| self.tree.nodes.get(**ray).is_some_and(|node| serves(node.kind));
        let names: Vec<String> = node.children.iter().filter(kind).map(|ray| self.name(*ray)).collect();
        words::seen_along(self.lang, symbol, names.join(", "))
    }

    /// A way that channels go through the surface, with its angles (subject §1.3: n·sin i = n'·sin r).
    fn way(&self, node: &RayNode, surface: &SurfaceNode, path: &GlassPath) -> String {
        let lang = self.lang;
        let cos_i = -node.ray.direction.dot(surface.geometric_normal);
        let GlassPath { channels, n, n_prime, total_reflection } = *path;
        let told = if surface.sheet {
            words::straight_on(lang)
        } else if total_reflection {
            let critical = (n_prime / n).clamp(0.0, 1.0).asin().cos();
            words::total_reflection(lang, length(n), length(n_prime), degrees(cos_i), degrees(critical))
        } else {
            let sin_r = n / n_prime * (1.0 - cos_i * cos_i).max(0.0).sqrt();
            let cos_r = (1.0 - sin_r * sin_r).max(0.0).sqrt();
            words::refraction(lang, length(n), length(n_prime), degrees(cos_i), degrees(cos_r))
        };
        if channels.iter().eq(node.channels.iter()) {
            return told;
        }
        let names = [words::red(lang), words::green(lang), words::blue(lang)];
        let carried: Vec<&str> = channels.iter().map(|channel| names[channel].as_str()).collect();
        format!("{} · {told}", words::carries(lang, carried.join(", ")))
    }

    fn lamp(&mut self, surface: &SurfaceNode, color: Color, light: &LampLight, (before, so_far): (Color, Color)) {
        let lang = self.lang;
        match light {
            LampLight::Lit(lit) => {
                let law = match surface.surface.highlight {
                    Highlight::Phong => "R_L·V",
                    Highlight::Blinn => "N·H",
                };
                let (cos_l, cos_s) = (lit.cos_l, lit.cos_s);
                self.text(words::lit(lang, channel(cos_l), degrees(cos_l), law, channel(cos_s), degrees(cos_s)));
                self.lit(surface, color, lit, (before, so_far));
            }
            LampLight::Blocked { by, .. } => self.text(words::blocked(lang, by)),
            LampLight::Behind { cos_l } => self.text(words::behind(lang, channel(*cos_l))),
            LampLight::AtPoint => self.text(words::at_point(lang)),
        }
    }

    /// `(Kd·cos l + W(l)·cosⁿ s)·I_L`, factor by factor.
    fn lit(&mut self, surface: &SurfaceNode, color: Color, lit: &Lit, (before, so_far): (Color, Color)) {
        let (lang, surface) = (self.lang, &surface.surface);
        let law = match surface.w {
            Reflectance::Constant => "W = Ks",
            Reflectance::Schlick => "W = Ks + (1-Ks)(1-cos l)⁵",
            Reflectance::Grazing => "W = Ks·(1-cos l)",
        };
        let shine = surface.shininess.map(|n| if lit.cos_s == 0.0 { 0.0 } else { lit.cos_s.powf(n) });
        self.values("Kd", surface.kd);
        self.values("× cos l", Rgb::splat(lit.cos_l));
        self.values(format!("+ {law}"), lit.w);
        self.values(format!("× cosⁿ s, n = {}", triple(surface.shininess)), shine);
        self.values("× I_L", color);
        match self.explanation.scene.world.compose {
            Compose::Screen | Compose::Add => {
                let both = lit.diffuse + lit.highlight;
                self.values("= (Kd·cos l + W·cosⁿ s)·I_L", both);
                self.sum(&words::lamp_term(lang), both, so_far);
            }
            Compose::ScreenEach => {
                self.values("= Kd·cos l·I_L", lit.diffuse);
                self.sum(&words::diffuse(lang), lit.diffuse, before.screen(lit.diffuse.clamp01()));
                self.values("= W·cosⁿ s·I_L", lit.highlight);
                self.sum(&words::highlight(lang), lit.highlight, so_far);
            }
        }
    }
}

/// An object by its shape and name, with the facet where there are several.
fn called(object: &Object, facet: u32, lang: Lang) -> String {
    match &object.shape {
        Shape::Sphere { .. } => words::object(lang, words::sphere(lang), &object.name),
        Shape::Plane { .. } => words::object(lang, words::plane(lang), &object.name),
        Shape::Facet { .. } => words::object(lang, words::facet(lang), &object.name),
        Shape::Cube { .. } => words::object_facet(lang, words::cube(lang), &object.name, facet),
        Shape::Parallelepiped { .. } => words::object_facet(lang, words::parallelepiped(lang), &object.name, facet),
        Shape::Cone { .. } => {
            let face = match ConeFace::of(facet) {
                ConeFace::Side => words::side(lang),
                ConeFace::Base => words::base_cap(lang),
                ConeFace::Top => words::top_cap(lang),
            };
            words::object_face(lang, words::cone(lang), &object.name, face)
        }
        Shape::Mesh(_) => words::object_facet(lang, words::mesh(lang), &object.name, facet),
    }
}

/// A channel's value: five decimals, because a byte's step is 0.0039; a power of ten where they would all be 0.
pub fn channel(value: f64) -> String {
    match value.abs() {
        0.0 => "0.00000".to_owned(),
        ..1e-12 => "≈ 0".to_owned(),
        ..5e-6 => format!("{value:.1e}"),
        _ => format!("{value:.5}"),
    }
}

/// A length, an index or a coordinate: at most four decimals.
fn length(value: f64) -> String {
    decimals(value, 4)
}

/// An angle in degrees from its cosine: two decimals.
fn degrees(cosine: f64) -> String {
    decimals(cosine.clamp(-1.0, 1.0).acos().to_degrees(), 2)
}

/// A point or a direction.
fn vector(value: DVec3) -> String {
    let [x, y, z] = value.to_array().map(length);
    format!("({x} {y} {z})")
}

/// One number for three equal ones, as in a document.
fn triple(value: Rgb) -> String {
    if value.is_uniform() { length(value.r) } else { value.to_array().map(length).join(" ") }
}

/// At most so many decimals, without zeros at the end; a power of ten where they would all be 0.
fn decimals(value: f64, count: usize) -> String {
    let smallest = 0.5 * 0.1_f64.powi(count.try_into().unwrap_or(i32::MAX));
    if value != 0.0 && value.abs() < smallest {
        return format!("{value:.2e}");
    }
    let text = format!("{:.count$}", value + 0.0);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use lancer_scene::{List, PointLight, Scene, ScreenSpec, Steps, Surface, View};
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
