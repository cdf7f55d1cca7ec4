//! An explanation as JSON, with all digits: for programs, and for those who check a term to the last bit.
//!
//! Version 1. Colours, coefficients, points and directions are arrays of three numbers. `rays` is a list in the order
//! in which the rays were cast, the primary ray first; `children` holds places in that list. Members that do not apply
//! are left out. Later versions may add members; they never change the meaning of these.

use super::Explanation;
use lancer_scene::{Compose, DVec3, Highlight, Reflectance, Rgb};
use lancer_trace::explain::{RayNames, SampleTree};
use lancer_trace::observe::{Composed, GlassPath, LampLight, Omitted, RayNode, Seen, Term};
use lancer_trace::{RayKind, RayTree};
use serde::{Serialize, Serializer};

type Triple = [f64; 3];

#[derive(Serialize)]
struct Pixel<'a> {
    version: u32,
    scene: &'a str,
    view: &'a str,
    width: u32,
    height: u32,
    x: u32,
    y: u32,
    /// `screen`, `screen-each` or `add`.
    compose: &'static str,
    depth: u32,
    /// The steps that are left out: `shadows`, `reflection`, `transparency`.
    without: Vec<&'static str>,
    samples: Vec<Sample<'a>>,
    /// The mean of the samples.
    color: Triple,
    bytes: [u8; 3],
    engine: Engine,
}

/// What the engine computes for the pixel: `bytes` are those of a picture.
#[derive(Serialize)]
struct Engine {
    /// `portable`, `avx2` or `avx512`.
    instructions: &'static str,
    color: Triple,
    bytes: [u8; 3],
}

#[derive(Serialize)]
struct Sample<'a> {
    /// In pixels from the top left of the picture.
    x: f64,
    y: f64,
    color: Triple,
    rays: Rays<'a>,
}

/// The rays of a tree, put together one by one while they are written: there may be a million.
struct Rays<'a>(&'a RayTree);

impl Serialize for Rays<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let names = RayNames::new(self.0);
        serializer.collect_seq(self.0.nodes.iter().enumerate().map(|(number, node)| ray(node, names.of(number))))
    }
}

#[derive(Serialize)]
struct Ray<'a> {
    /// As in the text: `T1·R2`; empty for the primary ray.
    name: String,
    /// `primary`, `reflected` or `refracted`.
    kind: &'static str,
    level: u32,
    /// 0 red, 1 green, 2 blue.
    channels: Vec<usize>,
    origin: Triple,
    direction: Triple,
    /// The index of the medium that the ray travels in.
    index: Triple,
    /// The transparent objects around it, outermost first.
    media: Vec<&'a str>,
    /// Nothing for a ray that meets nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    hit: Option<Hit<'a>>,
    /// The colour that the ray sees, 0 in channels that it does not carry.
    color: Triple,
    children: &'a [usize],
}

#[derive(Serialize)]
struct Hit<'a> {
    object: &'a str,
    facet: u32,
    distance: f64,
    point: Triple,
    geometric_normal: Triple,
    normal: Triple,
    entering: bool,
    sheet: bool,
    surface: Surface,
    terms: Vec<Sum<'a>>,
}

#[derive(Serialize)]
struct Surface {
    ka: Triple,
    kd: Triple,
    ks: Triple,
    /// `constant`, `schlick` or `grazing`.
    w: &'static str,
    n: Triple,
    kr: Triple,
    kt: Triple,
    index: Triple,
    /// `phong` or `blinn`.
    highlight: &'static str,
}

#[derive(Serialize)]
struct Sum<'a> {
    #[serde(flatten)]
    term: Told<'a>,
    /// The running sum after the term.
    so_far: Triple,
}

#[derive(Serialize)]
#[serde(tag = "term", rename_all = "snake_case")]
enum Told<'a> {
    Ambient {
        ka: Triple,
        ia: Triple,
        value: Triple,
    },
    Reflected {
        kr: Triple,
        ir: Triple,
        value: Triple,
        /// `coefficient`, `depth` or `step`: why there is no ray.
        #[serde(skip_serializing_if = "Option::is_none")]
        omitted: Option<&'static str>,
    },
    Refracted {
        kt: Triple,
        it: Triple,
        value: Triple,
        paths: Vec<Way>,
        #[serde(skip_serializing_if = "Option::is_none")]
        omitted: Option<&'static str>,
    },
    Lamp {
        name: &'a str,
        color: Triple,
        distance: f64,
        to_lamp: Triple,
        #[serde(flatten)]
        light: Light<'a>,
    },
}

#[derive(Serialize)]
struct Way {
    channels: Vec<usize>,
    n: f64,
    n_prime: f64,
    total_reflection: bool,
}

#[derive(Serialize)]
#[serde(tag = "state", rename_all = "snake_case")]
enum Light<'a> {
    Lit { cos_l: f64, cos_s: f64, w: Triple, diffuse: Triple, highlight: Triple },
    Behind { cos_l: f64 },
    Blocked { by: &'a str, cos_l: f64 },
    AtPoint,
}

/// The explanation, to be written as one line of JSON.
pub(super) fn json<'a>(explanation: &'a Explanation<'_>) -> impl Serialize + use<'a> {
    let Explanation { scene, view, settings, pixel, engine: (color, simd), x, y } = explanation;
    let steps = [
        (settings.steps.shadows, "shadows"),
        (settings.steps.reflection, "reflection"),
        (settings.steps.transparency, "transparency"),
    ];
    Pixel {
        version: 1,
        scene: &scene.name,
        view: &view.name,
        width: view.width,
        height: view.height,
        x: *x,
        y: *y,
        compose: match scene.world.compose {
            Compose::Screen => "screen",
            Compose::ScreenEach => "screen-each",
            Compose::Add => "add",
        },
        depth: settings.depth,
        without: steps.into_iter().filter(|(done, _)| !done).map(|(_, step)| step).collect(),
        samples: pixel.samples.iter().map(sample).collect(),
        color: pixel.color.to_array(),
        bytes: pixel.bytes,
        engine: Engine { instructions: simd.name(), color: color.to_array(), bytes: color.to_bytes() },
    }
}

fn sample(sample: &SampleTree) -> Sample<'_> {
    Sample { x: sample.x, y: sample.y, color: sample.color.to_array(), rays: Rays(&sample.tree) }
}

fn ray(node: &RayNode, name: String) -> Ray<'_> {
    Ray {
        name,
        kind: match node.kind {
            RayKind::Primary => "primary",
            RayKind::Reflected => "reflected",
            RayKind::Refracted => "refracted",
        },
        level: node.level,
        channels: node.channels.iter().collect(),
        origin: node.ray.origin.to_array(),
        direction: node.ray.direction.to_array(),
        index: node.index.to_array(),
        media: node.media.iter().map(|name| &**name).collect(),
        hit: match &node.seen {
            Seen::Background(_) => None,
            Seen::Surface(at) => Some(Hit {
                object: &at.object,
                facet: at.facet,
                distance: at.distance,
                point: at.point.to_array(),
                geometric_normal: at.geometric_normal.to_array(),
                normal: at.normal.to_array(),
                entering: at.entering,
                sheet: at.sheet,
                surface: surface(&at.surface),
                terms: at.terms.iter().map(sum).collect(),
            }),
        },
        color: node.color.to_array(),
        children: &node.children,
    }
}

fn surface(surface: &lancer_scene::Surface) -> Surface {
    Surface {
        ka: surface.ka.to_array(),
        kd: surface.kd.to_array(),
        ks: surface.ks.to_array(),
        w: match surface.w {
            Reflectance::Constant => "constant",
            Reflectance::Schlick => "schlick",
            Reflectance::Grazing => "grazing",
        },
        n: surface.shininess.to_array(),
        kr: surface.kr.to_array(),
        kt: surface.kt.to_array(),
        index: surface.index.to_array(),
        highlight: match surface.highlight {
            Highlight::Phong => "phong",
            Highlight::Blinn => "blinn",
        },
    }
}

fn sum(Composed { term, so_far }: &Composed) -> Sum<'_> {
    let term = match term {
        Term::Ambient { ka, ia, value } => {
            Told::Ambient { ka: ka.to_array(), ia: ia.to_array(), value: value.to_array() }
        }
        Term::Mirror(mirror) => Told::Reflected {
            kr: mirror.kr.to_array(),
            ir: mirror.ir.to_array(),
            value: mirror.value.to_array(),
            omitted: mirror.omitted.map(reason),
        },
        Term::Glass(glass) => Told::Refracted {
            kt: glass.kt.to_array(),
            it: glass.it.to_array(),
            value: glass.value.to_array(),
            paths: glass.paths.iter().map(way).collect(),
            omitted: glass.omitted.map(reason),
        },
        Term::Lamp { name, color, distance, to_lamp, light } => Told::Lamp {
            name,
            color: color.to_array(),
            distance: *distance,
            to_lamp: DVec3::to_array(to_lamp),
            light: match light {
                LampLight::Lit(lit) => Light::Lit {
                    cos_l: lit.cos_l,
                    cos_s: lit.cos_s,
                    w: Rgb::to_array(lit.w),
                    diffuse: lit.diffuse.to_array(),
                    highlight: lit.highlight.to_array(),
                },
                LampLight::Behind { cos_l } => Light::Behind { cos_l: *cos_l },
                LampLight::Blocked { by, cos_l } => Light::Blocked { by, cos_l: *cos_l },
                LampLight::AtPoint => Light::AtPoint,
            },
        },
    };
    Sum { term, so_far: so_far.to_array() }
}

fn reason(omitted: Omitted) -> &'static str {
    match omitted {
        Omitted::NoCoefficient => "coefficient",
        Omitted::DepthReached => "depth",
        Omitted::StepLeftOut => "step",
    }
}

fn way(path: &GlassPath) -> Way {
    Way {
        channels: path.channels.iter().collect(),
        n: path.n,
        n_prime: path.n_prime,
        total_reflection: path.total_reflection,
    }
}
