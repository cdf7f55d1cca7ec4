//! The sum of a point as somebody works it out by hand (subject §2.5, §2.6): the factors of each term, their product, and
//! the running sum after it. Whoever shows an explanation words these entries and lays them out.

use crate::observe::{Composed, GlassPath, GlassTerm, LampLight, MirrorTerm, Omitted, RayNode, SurfaceNode, Term};
use crate::reference::light::{self, Lit};
use crate::{Channels, RayKind, RayTree};
use lancer_scene::{Color, Compose, Highlight, Name, Reflectance, Rgb};

/// An entry of a point's account.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry<'a> {
    /// A term, or a part of one, begins.
    Begin(Part<'a>),
    /// The term is 0, and no ray is cast for it.
    Omitted {
        /// The mirror or the glass term.
        part: Part<'a>,
        /// Why.
        why: Omitted,
    },
    /// A way that light goes through the surface.
    Way(Way),
    /// What the lamp gives.
    Lamp {
        /// Whether it lights the point, or why it does not.
        light: &'a LampLight,
        /// What `cos s` is: `R_L·V` or `N·H`, and `max(0, …)` of it where that makes it 0.
        cos_s: &'static str,
    },
    /// A factor or a product, and how it goes together with what stands before it.
    Value {
        /// `×`, `+`, `=`, or nothing for what begins.
        sign: &'static str,
        /// What it is.
        factor: Factor,
        /// Its value in each channel.
        value: Rgb,
    },
    /// The running sum `E` after a term or a part.
    Sum {
        /// `=`, `⊕` or `+`.
        sign: &'static str,
        /// What was added.
        part: Part<'a>,
        /// The sum, before the final clamp.
        so_far: Color,
    },
}

/// A term of the sum, or a part of a lamp's term.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Part<'a> {
    /// `Ka·Ia`.
    Ambient,
    /// `Kr·Ir`.
    Mirror,
    /// `Kt·It`.
    Glass,
    /// What a lamp gives.
    Lamp {
        /// Its name.
        name: &'a Name,
        /// How far it is.
        distance: f64,
    },
    /// Its share that is scattered.
    Diffuse,
    /// Its share that shines.
    Highlight,
}

/// A factor or a product.
#[derive(Clone, Debug, PartialEq)]
pub enum Factor {
    /// In the subject's notation, such as `Ka` or `W = Ks`.
    Symbol(&'static str),
    /// `cosⁿ s`.
    Power {
        /// The shininess `n`.
        n: Rgb,
    },
    /// `Ir` or `It`: what is seen along rays.
    Seen {
        /// `Ir` or `It`.
        symbol: &'static str,
        /// The numbers of the rays in the tree.
        rays: Vec<usize>,
    },
    /// The term, clamped to 0..1 before it is composed.
    Clamped,
}

/// A way that channels go through a surface (subject §1.3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    /// The channels that go it, where they are not all of the ray's.
    pub channels: Option<Channels>,
    /// How it goes.
    pub course: Course,
}

/// How light goes through a surface. Angles are given by their cosines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Course {
    /// Straight on, through a sheet.
    Straight,
    /// Refracted: `n·sin i = n'·sin r`.
    Bent {
        /// `n` and `n'`.
        indices: [f64; 2],
        /// Of the angle of incidence.
        cos_i: f64,
        /// Of the angle of refraction.
        cos_r: f64,
    },
    /// Totally reflected.
    Reflected {
        /// `n` and `n'`.
        indices: [f64; 2],
        /// Of the angle of incidence.
        cos_i: f64,
        /// Of the critical angle, whose sine is `n'/n`.
        cos_critical: f64,
    },
}

/// The account of the point that a ray of a tree sees.
pub fn account<'a>(tree: &RayTree, node: &RayNode, surface: &'a SurfaceNode, compose: Compose) -> Vec<Entry<'a>> {
    let mut book = Book { tree, node, surface, compose, so_far: Rgb::BLACK, entries: Vec::new() };
    for Composed { term, so_far } in &surface.terms {
        match term {
            Term::Ambient { ka, ia, .. } => book.ambient(*ka, *ia, *so_far),
            Term::Mirror(mirror) => book.mirror(mirror, *so_far),
            Term::Glass(glass) => book.glass(glass, *so_far),
            Term::Lamp { name, color, distance, light, .. } => {
                book.lamp(Part::Lamp { name, distance: *distance }, *color, light, *so_far);
            }
        }
        book.so_far = *so_far;
    }
    book.entries
}

struct Book<'a, 't> {
    tree: &'t RayTree,
    node: &'t RayNode,
    surface: &'a SurfaceNode,
    compose: Compose,
    /// The running sum before the term.
    so_far: Color,
    entries: Vec<Entry<'a>>,
}

impl<'a> Book<'a, '_> {
    fn value(&mut self, sign: &'static str, factor: Factor, value: Rgb) {
        self.entries.push(Entry::Value { sign, factor, value });
    }

    fn symbol(&mut self, sign: &'static str, symbol: &'static str, value: Rgb) {
        self.value(sign, Factor::Symbol(symbol), value);
    }

    /// The running sum after a term; for `⊕` the term is clamped first.
    fn sum(&mut self, part: Part<'a>, term: Color, so_far: Color) {
        let sign = match self.compose {
            Compose::Add => "+",
            Compose::Screen | Compose::ScreenEach => {
                if term.clamp01() != term {
                    self.value("", Factor::Clamped, term.clamp01());
                }
                "⊕"
            }
        };
        self.entries.push(Entry::Sum { sign, part, so_far });
    }

    fn ambient(&mut self, ka: Rgb, ia: Color, so_far: Color) {
        self.entries.push(Entry::Begin(Part::Ambient));
        self.symbol("", "Ka", ka);
        self.symbol("×", "Ia", ia);
        self.entries.push(Entry::Sum { sign: "=", part: Part::Ambient, so_far });
    }

    fn mirror(&mut self, mirror: &MirrorTerm, so_far: Color) {
        self.entries.push(Entry::Begin(Part::Mirror));
        if let Some(why) = mirror.omitted {
            return self.entries.push(Entry::Omitted { part: Part::Mirror, why });
        }
        self.symbol("", "Kr", mirror.kr);
        self.seen("Ir", mirror.ir, |kind| kind == RayKind::Reflected);
        self.symbol("=", "Kr·Ir", mirror.value);
        self.sum(Part::Mirror, mirror.value, so_far);
    }

    fn glass(&mut self, glass: &GlassTerm, so_far: Color) {
        self.entries.push(Entry::Begin(Part::Glass));
        if let Some(why) = glass.omitted {
            return self.entries.push(Entry::Omitted { part: Part::Glass, why });
        }
        for path in &glass.paths {
            self.entries.push(Entry::Way(self.way(path)));
        }
        self.symbol("", "Kt", glass.kt);
        let total = glass.paths.iter().any(|path| path.total_reflection);
        self.seen("It", glass.it, |kind| kind == RayKind::Refracted || total);
        self.symbol("=", "Kt·It", glass.value);
        self.sum(Part::Glass, glass.value, so_far);
    }

    /// What is seen along every ray of those kinds.
    fn seen(&mut self, symbol: &'static str, value: Color, serves: impl Fn(RayKind) -> bool) {
        let kind = |ray: &usize| self.tree.nodes.get(*ray).is_some_and(|node| serves(node.kind));
        let rays = self.node.children.iter().copied().filter(kind).collect();
        self.value("×", Factor::Seen { symbol, rays }, value);
    }

    fn way(&self, path: &GlassPath) -> Way {
        let cos_i = -self.node.ray.direction.dot(self.surface.geometric_normal);
        let GlassPath { channels, n, n_prime, total_reflection } = *path;
        let indices = [n, n_prime];
        let cosine = |sine: f64| (1.0 - sine * sine).max(0.0).sqrt();
        let course = if self.surface.sheet {
            Course::Straight
        } else if total_reflection {
            Course::Reflected { indices, cos_i, cos_critical: cosine(n_prime / n) }
        } else {
            Course::Bent { indices, cos_i, cos_r: cosine(n / n_prime * cosine(cos_i)) }
        };
        Way { channels: (channels != self.node.channels).then_some(channels), course }
    }

    fn lamp(&mut self, part: Part<'a>, color: Color, light: &'a LampLight, so_far: Color) {
        self.entries.push(Entry::Begin(part));
        let shines = matches!(light, LampLight::Lit(lit) if lit.cos_s > 0.0);
        let cos_s = match (self.surface.surface.highlight, shines) {
            (Highlight::Phong, true) => "R_L·V",
            (Highlight::Phong, false) => "max(0, R_L·V)",
            (Highlight::Blinn, true) => "N·H",
            (Highlight::Blinn, false) => "max(0, N·H)",
        };
        self.entries.push(Entry::Lamp { light, cos_s });
        match light {
            LampLight::Lit(lit) => self.lit(part, color, lit, so_far),
            LampLight::Behind { .. } | LampLight::Blocked { .. } | LampLight::AtPoint => {}
        }
    }

    /// `(Kd·cos l + W(l)·cosⁿ s)·I_L`, factor by factor.
    fn lit(&mut self, part: Part<'a>, color: Color, lit: &Lit, so_far: Color) {
        let surface = &self.surface.surface;
        let (kd, n) = (surface.kd, surface.shininess);
        let law = match surface.w {
            Reflectance::Constant => "W = Ks",
            Reflectance::Schlick => "W = Ks + (1-Ks)(1-cos l)⁵",
            Reflectance::Grazing => "W = Ks·(1-cos l)",
        };
        self.entries.push(Entry::Begin(Part::Diffuse));
        self.symbol("", "Kd", kd);
        self.symbol("×", "cos l", Rgb::splat(lit.cos_l));
        self.entries.push(Entry::Begin(Part::Highlight));
        self.symbol("+", law, lit.w);
        self.value("×", Factor::Power { n }, light::highlight(Rgb::WHITE, lit.cos_s, n));
        self.symbol("×", "I_L", color);
        match self.compose {
            Compose::Screen | Compose::Add => {
                let both = lit.diffuse + lit.highlight;
                self.symbol("=", "(Kd·cos l + W·cosⁿ s)·I_L", both);
                self.sum(part, both, so_far);
            }
            Compose::ScreenEach => {
                self.symbol("=", "Kd·cos l·I_L", lit.diffuse);
                self.sum(Part::Diffuse, lit.diffuse, self.so_far.screen(lit.diffuse.clamp01()));
                self.symbol("=", "W·cosⁿ s·I_L", lit.highlight);
                self.sum(Part::Highlight, lit.highlight, so_far);
            }
        }
    }
}
