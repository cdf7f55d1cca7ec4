//! The table of a ray's sum: every factor of every term, and the running sum after each (subject §2.5, §2.6).

use super::number::{channel, degrees, length, triple};
use lancer_scene::{Color, Compose, Highlight, Reflectance, Rgb};
use lancer_trace::observe::{
    Composed, GlassPath, GlassTerm, LampLight, MirrorTerm, Omitted, RayNode, SurfaceNode, Term,
};
use lancer_trace::reference::light::Lit;
use lancer_trace::{Channels, RayKind};
use lancer_words::cli::usage;
use lancer_words::{Lang, explain as words};

/// A line of a ray's story.
pub(super) enum Line {
    /// A sentence.
    Text(String),
    /// A label and a value for each channel.
    Row {
        /// What the values are.
        label: String,
        /// Red, green, blue.
        cells: [String; 3],
    },
    /// An empty line.
    Blank,
}

impl Line {
    /// A row of channel values.
    pub(super) fn values(label: String, value: Rgb) -> Line {
        Line::Row { label, cells: value.to_array().map(channel) }
    }

    /// A row of the values of some channels, with a dash in the others.
    pub(super) fn carried(label: String, value: Rgb, channels: Channels) -> Line {
        let cell = |index: usize| match channels.contains(index) {
            true => channel(value[index]),
            false => "–".to_owned(),
        };
        Line::Row { label, cells: [cell(0), cell(1), cell(2)] }
    }

    /// A row of anything.
    pub(super) fn cells(label: String, cells: [String; 3]) -> Line {
        Line::Row { label, cells }
    }
}

/// The rows of a sum. `children` are the rays that the point gives rise to, with their names.
pub(super) fn terms(
    node: &RayNode,
    surface: &SurfaceNode,
    children: &[(&RayNode, String)],
    compose: Compose,
    lang: Lang,
) -> Vec<Line> {
    let mut table = Table { node, surface, children, compose, lang, so_far: Rgb::BLACK, lines: Vec::new() };
    for Composed { term, so_far } in &surface.terms {
        match term {
            Term::Ambient { ka, ia, .. } => table.ambient(*ka, *ia, *so_far),
            Term::Mirror(mirror) => table.mirror(mirror, *so_far),
            Term::Glass(glass) => table.glass(glass, *so_far),
            Term::Lamp { name, color, distance, light, .. } => {
                table.lines.push(Line::Text(words::lamp(lang, name, length(*distance)) + &usage::colon(lang)));
                table.lamp(*color, light, *so_far);
            }
        }
        table.so_far = *so_far;
    }
    table.lines
}

struct Table<'a> {
    node: &'a RayNode,
    surface: &'a SurfaceNode,
    children: &'a [(&'a RayNode, String)],
    compose: Compose,
    lang: Lang,
    /// The running sum before the term.
    so_far: Color,
    lines: Vec<Line>,
}

impl Table<'_> {
    /// A row of a term: its name (or nothing), a sign, what the values are, the values in the ray's channels.
    fn row(&mut self, term: &str, sign: &str, what: &str, value: Rgb) {
        self.lines.push(Line::carried(format!("{term:<10} {sign:>1} {what}"), value, self.node.channels));
    }

    /// What is to be said of a term beside its values.
    fn remark(&mut self, term: &str, remark: &str) {
        self.lines.push(Line::Text(format!("{term:<10}   {remark}")));
    }

    /// The running sum after a term; for `⊕` the term is clamped first.
    fn sum(&mut self, what: &str, term: Color, so_far: Color) {
        let sign = match self.compose {
            Compose::Add => "+",
            Compose::Screen | Compose::ScreenEach => {
                if term.clamp01() != term {
                    self.row("", "", &words::clamped_term(self.lang), term.clamp01());
                }
                "⊕"
            }
        };
        self.row("E", sign, what, so_far);
    }

    fn ambient(&mut self, ka: Rgb, ia: Color, so_far: Color) {
        self.row(&words::ambient(self.lang), "", "Ka", ka);
        self.row("", "×", "Ia", ia);
        self.row("E", "=", "Ka·Ia", so_far);
    }

    fn mirror(&mut self, mirror: &MirrorTerm, so_far: Color) {
        let name = words::mirror(self.lang);
        match mirror.omitted {
            Some(Omitted::NoCoefficient) => self.remark(&name, &words::no_mirror(self.lang)),
            Some(omitted) => self.omitted(&name, omitted),
            None => {
                self.row(&name, "", "Kr", mirror.kr);
                let along = self.seen_along("Ir", |kind| kind == RayKind::Reflected);
                self.row("", "×", &along, mirror.ir);
                self.row("", "=", "Kr·Ir", mirror.value);
                self.sum("Kr·Ir", mirror.value, so_far);
            }
        }
    }

    fn glass(&mut self, glass: &GlassTerm, so_far: Color) {
        let name = words::glass(self.lang);
        match glass.omitted {
            Some(Omitted::NoCoefficient) => self.remark(&name, &words::no_glass(self.lang)),
            Some(omitted) => self.omitted(&name, omitted),
            None => {
                for (number, path) in glass.paths.iter().enumerate() {
                    let way = self.way(path);
                    self.remark(if number == 0 { &name } else { "" }, &way);
                }
                self.row("", "", "Kt", glass.kt);
                let total = glass.paths.iter().any(|path| path.total_reflection);
                let along = self.seen_along("It", |kind| kind == RayKind::Refracted || total);
                self.row("", "×", &along, glass.it);
                self.row("", "=", "Kt·It", glass.value);
                self.sum("Kt·It", glass.value, so_far);
            }
        }
    }

    /// Why there is no ray although there is a coefficient.
    fn omitted(&mut self, name: &str, omitted: Omitted) {
        let reason = match omitted {
            Omitted::NoCoefficient => return,
            Omitted::DepthReached => words::depth_reached(self.lang, self.node.level),
            Omitted::StepLeftOut => words::step_left_out(self.lang),
        };
        self.remark(name, &reason);
    }

    /// `Ir seen along R1`, with every ray of those kinds.
    fn seen_along(&self, symbol: &str, serves: impl Fn(RayKind) -> bool) -> String {
        let names: Vec<&str> =
            self.children.iter().filter(|(child, _)| serves(child.kind)).map(|(_, name)| name.as_str()).collect();
        words::seen_along(self.lang, symbol, names.join(", "))
    }

    /// A way that channels go through the surface, with its angles (subject §1.3: n·sin i = n'·sin r).
    fn way(&self, path: &GlassPath) -> String {
        let lang = self.lang;
        let cos_i = -self.node.ray.direction.dot(self.surface.geometric_normal);
        let GlassPath { channels, n, n_prime, total_reflection } = *path;
        let told = if self.surface.sheet {
            words::straight_on(lang)
        } else if total_reflection {
            let critical = (n_prime / n).clamp(0.0, 1.0).asin().cos();
            words::total_reflection(lang, length(n), length(n_prime), degrees(cos_i), degrees(critical))
        } else {
            let sin_r = n / n_prime * (1.0 - cos_i * cos_i).max(0.0).sqrt();
            let cos_r = (1.0 - sin_r * sin_r).max(0.0).sqrt();
            words::refraction(lang, length(n), length(n_prime), degrees(cos_i), degrees(cos_r))
        };
        if channels.iter().eq(self.node.channels.iter()) {
            return told;
        }
        let names = [words::red(lang), words::green(lang), words::blue(lang)];
        let carried: Vec<&str> = channels.iter().map(|channel| names[channel].as_str()).collect();
        format!("{}{} {told}", carried.join(", "), usage::colon(lang))
    }

    fn lamp(&mut self, color: Color, light: &LampLight, so_far: Color) {
        let lang = self.lang;
        let told = match light {
            LampLight::Lit(lit) => {
                let law = match self.surface.surface.highlight {
                    Highlight::Phong => "R_L·V",
                    Highlight::Blinn => "N·H",
                };
                let (cos_l, cos_s) = (lit.cos_l, lit.cos_s);
                words::lit(lang, channel(cos_l), degrees(cos_l), law, channel(cos_s), degrees(cos_s))
            }
            LampLight::Blocked { by, .. } => words::blocked(lang, by),
            LampLight::Behind { cos_l } => words::behind(lang, channel(*cos_l)),
            LampLight::AtPoint => words::at_point(lang),
        };
        self.lines.push(Line::Text(format!("  {told}")));
        if let LampLight::Lit(lit) = light {
            self.lit(color, lit, so_far);
        }
    }

    /// `(Kd·cos l + W(l)·cosⁿ s)·I_L`, factor by factor.
    fn lit(&mut self, color: Color, lit: &Lit, so_far: Color) {
        let lang = self.lang;
        let surface = &self.surface.surface;
        let law = match surface.w {
            Reflectance::Constant => "W = Ks",
            Reflectance::Schlick => "W = Ks + (1-Ks)(1-cos l)⁵",
            Reflectance::Grazing => "W = Ks·(1-cos l)",
        };
        let shine = surface.shininess.map(|n| if lit.cos_s == 0.0 { 0.0 } else { lit.cos_s.powf(n) });
        self.row(&words::diffuse(lang), "", "Kd", surface.kd);
        self.row("", "×", "cos l", Rgb::splat(lit.cos_l));
        self.row(&words::highlight(lang), "+", law, lit.w);
        self.row("", "×", &format!("cosⁿ s, n = {}", triple(surface.shininess)), shine);
        self.row("", "×", "I_L", color);
        match self.compose {
            Compose::Screen | Compose::Add => {
                let both = lit.diffuse + lit.highlight;
                self.row("", "=", "(Kd·cos l + W·cosⁿ s)·I_L", both);
                self.sum(&words::lamp_term(lang), both, so_far);
            }
            Compose::ScreenEach => {
                self.row("", "=", "Kd·cos l·I_L", lit.diffuse);
                let between = self.so_far.screen(lit.diffuse.clamp01());
                self.sum(&words::diffuse(lang), lit.diffuse, between);
                self.row("", "=", "W·cosⁿ s·I_L", lit.highlight);
                self.sum(&words::highlight(lang), lit.highlight, so_far);
            }
        }
    }
}
