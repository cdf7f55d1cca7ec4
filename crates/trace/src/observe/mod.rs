//! What a tracer tells of its work: an observer counts it, records it, or ignores it at no cost.

mod counts;
mod tree;

pub use counts::RayCounts;
pub use tree::{Composed, LampLight, RayNode, RayTree, Seen, SurfaceNode, Term};

use crate::reference::light::Lit;
use crate::{Channels, Ray, RayKind};
use glam::DVec3;
use lancer_scene::{Color, Name, Rgb, Surface};

/// Is told everything that a tracer computes for a ray, in this order: `enter`, then either `background`, or `surface`
/// and `ambient`, the whole stories of the mirrored and the refracted rays, `mirror`, `glass` and each lamp; at last
/// `leave`. `so_far` is the running sum after the term.
pub trait Observer {
    /// Whether the names of media are wanted.
    const EXPLAINS: bool = false;

    /// A ray begins.
    fn enter(&mut self, _ray: &SeenRay<'_>) {}
    /// It meets nothing and sees the colour of infinity.
    fn background(&mut self, _color: Color) {}
    /// It meets a surface.
    fn surface(&mut self, _surface: &SeenSurface<'_>) {}
    /// `Ka`, `Ia` and their product.
    fn ambient(&mut self, _ka: Rgb, _ia: Color, _value: Color, _so_far: Color) {}
    /// The mirror term.
    fn mirror(&mut self, _term: &MirrorTerm, _so_far: Color) {}
    /// The glass term.
    fn glass(&mut self, _term: &GlassTerm, _so_far: Color) {}
    /// A shadow ray is cast.
    fn shadow_ray(&mut self) {}
    /// A lamp's term.
    fn lamp(&mut self, _term: &LampTerm<'_>, _so_far: Color) {}
    /// The ray's colour is known.
    fn leave(&mut self, _color: Color) {}
}

/// Ignores everything.
impl Observer for () {}

/// A ray as it begins.
#[derive(Clone, Debug)]
pub struct SeenRay<'a> {
    /// Where it comes from.
    pub kind: RayKind,
    /// 0 for a primary ray, one more at each bounce.
    pub level: u32,
    /// The channels that it carries.
    pub channels: Channels,
    /// Its start and direction.
    pub ray: Ray,
    /// The index of the medium that it travels in.
    pub index: Rgb,
    /// The transparent objects that it is inside of, outermost first, if the observer explains.
    pub media: &'a [Name],
}

/// A surface as a ray meets it.
#[derive(Clone, Debug)]
pub struct SeenSurface<'a> {
    /// The level of the ray.
    pub level: u32,
    /// The object.
    pub object: &'a Name,
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
    pub surface: &'a Surface,
}

/// Why a mirror or glass term is 0 without a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Omitted {
    /// The coefficient is 0 in every channel of the ray.
    NoCoefficient,
    /// The ray's level is the depth limit.
    DepthReached,
    /// The step of the algorithm is left out.
    StepLeftOut,
}

/// `Kr·Ir`.
#[derive(Clone, Debug, PartialEq)]
pub struct MirrorTerm {
    /// `Kr`.
    pub kr: Rgb,
    /// `Ir`: what is seen along `R`, 0 in channels without a ray.
    pub ir: Color,
    /// `Kr·Ir`.
    pub value: Color,
    /// Why there is no ray.
    pub omitted: Option<Omitted>,
}

impl MirrorTerm {
    pub(crate) fn none(kr: Rgb) -> MirrorTerm {
        MirrorTerm { kr, ir: Rgb::BLACK, value: Rgb::BLACK, omitted: None }
    }
}

/// `Kt·It`.
#[derive(Clone, Debug, PartialEq)]
pub struct GlassTerm {
    /// `Kt`.
    pub kt: Rgb,
    /// `It`: what is seen along `T`, or along `R` where the light is totally reflected.
    pub it: Color,
    /// `Kt·It`.
    pub value: Color,
    /// The ways that the channels go.
    pub paths: Vec<GlassPath>,
    /// Why there is no ray.
    pub omitted: Option<Omitted>,
}

impl GlassTerm {
    pub(crate) fn none(kt: Rgb) -> GlassTerm {
        GlassTerm { kt, it: Rgb::BLACK, value: Rgb::BLACK, paths: Vec::new(), omitted: None }
    }
}

/// Channels that go one way through a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlassPath {
    /// The channels.
    pub channels: Channels,
    /// `n`, the index of the medium that the ray travels in.
    pub n: f64,
    /// `n'`, the index of the medium beyond.
    pub n_prime: f64,
    /// Whether the light cannot leave and goes along `R`.
    pub total_reflection: bool,
}

/// A lamp's term.
#[derive(Clone, Debug)]
pub struct LampTerm<'a> {
    /// The lamp.
    pub name: &'a Name,
    /// Its intensity `I_L`.
    pub color: Color,
    /// How far it is.
    pub distance: f64,
    /// The unit direction `L` to it.
    pub to_lamp: DVec3,
    /// What it gives.
    pub state: LampState<'a>,
}

/// What a lamp gives to a point.
#[derive(Clone, Debug)]
pub enum LampState<'a> {
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
        by: &'a Name,
        /// `N·L`.
        cos_l: f64,
    },
    /// It stands at the very point.
    AtPoint,
}
