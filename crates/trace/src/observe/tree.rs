//! The tree of rays of one sample, with every term of every sum.

use super::{GlassTerm, LampState, LampTerm, MirrorTerm, Observer, SeenRay, SeenSurface};
use crate::reference::light::Lit;
use crate::{Channels, Ray, RayKind};
use glam::DVec3;
use lancer_scene::{Color, Name, Rgb, Surface};

/// A tree of rays, recorded while it is traced. The nodes stand in the order in which the rays were cast; node 0 is
/// the primary ray.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RayTree {
    /// The rays.
    pub nodes: Vec<RayNode>,
    /// The rays that are not finished yet, innermost last.
    open: Vec<usize>,
}

/// One ray and what it sees.
#[derive(Clone, Debug, PartialEq)]
pub struct RayNode {
    /// Where it comes from.
    pub kind: RayKind,
    /// 0 for the primary ray, one more at each bounce.
    pub level: u32,
    /// The channels that it carries.
    pub channels: Channels,
    /// Its start and direction.
    pub ray: Ray,
    /// The index of the medium that it travels in.
    pub index: Rgb,
    /// The transparent objects that it is inside of, outermost first.
    pub media: Vec<Name>,
    /// What it meets.
    pub seen: Seen,
    /// Its colour, 0 in the channels that it does not carry.
    pub color: Color,
    /// The rays that it gave rise to: first the mirrored one, then the refracted ones in the order of the glass term's
    /// paths, as far as they were cast.
    pub children: Vec<usize>,
}

/// What a ray meets.
#[derive(Clone, Debug, PartialEq)]
pub enum Seen {
    /// Nothing: the colour of infinity.
    Background(Color),
    /// A point of a surface.
    Surface(Box<SurfaceNode>),
}

/// A point of a surface and the terms of its sum.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceNode {
    /// The object.
    pub object: Name,
    /// The facet's number, 0 for a sphere and a plane.
    pub facet: u32,
    /// `t`.
    pub distance: f64,
    /// The point `P`.
    pub point: DVec3,
    /// The geometry's normal, turned against the ray.
    pub geometric_normal: DVec3,
    /// The normal of the lamp terms, turned likewise.
    pub normal: DVec3,
    /// Whether the ray comes from outside of what the object encloses.
    pub entering: bool,
    /// Whether the object is a sheet without thickness.
    pub sheet: bool,
    /// The coefficients of the light model there.
    pub surface: Surface,
    /// The terms in their order, each with the running sum after it.
    pub terms: Vec<Composed>,
}

/// A term and the sum after it.
#[derive(Clone, Debug, PartialEq)]
pub struct Composed {
    /// The term.
    pub term: Term,
    /// The running sum, before the final clamp.
    pub so_far: Color,
}

/// A term of the sum.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    /// `Ka·Ia`.
    Ambient {
        /// `Ka`.
        ka: Rgb,
        /// `Ia`.
        ia: Color,
        /// The product.
        value: Color,
    },
    /// `Kr·Ir`.
    Mirror(MirrorTerm),
    /// `Kt·It`.
    Glass(GlassTerm),
    /// A lamp.
    Lamp {
        /// Its name.
        name: Name,
        /// Its intensity `I_L`.
        color: Color,
        /// How far it is.
        distance: f64,
        /// The unit direction `L` to it.
        to_lamp: DVec3,
        /// What it gives.
        light: LampLight,
    },
}

/// What a lamp gives to a point.
#[derive(Clone, Debug, PartialEq)]
pub enum LampLight {
    /// It lights the point.
    Lit(Lit),
    /// It is behind the surface.
    Behind {
        /// `N·L`.
        cos_l: f64,
    },
    /// An object stands between.
    Blocked {
        /// The object.
        by: Name,
        /// `N·L`.
        cos_l: f64,
    },
    /// It stands at the very point.
    AtPoint,
}

impl RayTree {
    /// The primary ray, once something was traced.
    pub fn root(&self) -> Option<&RayNode> {
        self.nodes.first()
    }

    /// The surface of the ray that is being traced.
    fn current(&mut self) -> Option<&mut SurfaceNode> {
        let node = *self.open.last()?;
        match &mut self.nodes.get_mut(node)?.seen {
            Seen::Surface(surface) => Some(surface),
            Seen::Background(_) => None,
        }
    }

    fn add(&mut self, term: Term, so_far: Color) {
        if let Some(surface) = self.current() {
            surface.terms.push(Composed { term, so_far });
        }
    }
}

impl Observer for RayTree {
    const EXPLAINS: bool = true;

    fn enter(&mut self, ray: &SeenRay<'_>) {
        let number = self.nodes.len();
        if let Some(&parent) = self.open.last() {
            self.nodes[parent].children.push(number);
        }
        self.nodes.push(RayNode {
            kind: ray.kind,
            level: ray.level,
            channels: ray.channels,
            ray: ray.ray,
            index: ray.index,
            media: ray.media.to_vec(),
            seen: Seen::Background(Rgb::BLACK),
            color: Rgb::BLACK,
            children: Vec::new(),
        });
        self.open.push(number);
    }

    fn background(&mut self, color: Color) {
        if let Some(&number) = self.open.last() {
            self.nodes[number].seen = Seen::Background(color);
        }
    }

    fn surface(&mut self, surface: &SeenSurface<'_>) {
        if let Some(&number) = self.open.last() {
            self.nodes[number].seen = Seen::Surface(Box::new(SurfaceNode {
                object: surface.object.clone(),
                facet: surface.facet,
                distance: surface.distance,
                point: surface.point,
                geometric_normal: surface.geometric_normal,
                normal: surface.normal,
                entering: surface.entering,
                sheet: surface.sheet,
                surface: surface.surface.clone(),
                terms: Vec::new(),
            }));
        }
    }

    fn ambient(&mut self, ka: Rgb, ia: Color, value: Color, so_far: Color) {
        self.add(Term::Ambient { ka, ia, value }, so_far);
    }

    fn mirror(&mut self, term: &MirrorTerm, so_far: Color) {
        self.add(Term::Mirror(term.clone()), so_far);
    }

    fn glass(&mut self, term: &GlassTerm, so_far: Color) {
        self.add(Term::Glass(term.clone()), so_far);
    }

    fn lamp(&mut self, term: &LampTerm<'_>, so_far: Color) {
        let light = match &term.state {
            LampState::Lit(lit) => LampLight::Lit(*lit),
            LampState::Behind { cos_l } => LampLight::Behind { cos_l: *cos_l },
            LampState::Blocked { by, cos_l } => LampLight::Blocked { by: Name::clone(by), cos_l: *cos_l },
            LampState::AtPoint => LampLight::AtPoint,
        };
        let LampTerm { name, color, distance, to_lamp, .. } = term;
        let term = Term::Lamp { name: Name::clone(name), color: *color, distance: *distance, to_lamp: *to_lamp, light };
        self.add(term, so_far);
    }

    fn leave(&mut self, color: Color) {
        if let Some(number) = self.open.pop() {
            self.nodes[number].color = color;
        }
    }
}
