//! The vocabulary of the native documents as one table.
//!
//! It says of each element which attributes and elements it takes, and of each attribute its type, default, range and
//! meaning. The readers check by it, the writer follows its order and leaves its defaults out, messages list from it,
//! and the published schema and the manual are made of it.

use lancer_scene::{Compose, Highlight, Reflectance, limits};
use lancer_words::Lang;
use lancer_words::xml::vocabulary as words;

/// An element of the native documents.
#[derive(Debug)]
pub struct ElementRule {
    /// Its name.
    pub name: &'static str,
    /// Its attributes, in the order in which they are written.
    pub attributes: &'static [AttributeRule],
    /// The elements within it.
    pub children: &'static [Child],
    /// What its text is; no text is due in most.
    pub text: TextRule,
    /// What it is, in one sentence without a full stop.
    pub sentence: fn(Lang) -> String,
}

/// An attribute of an element.
#[derive(Debug)]
pub struct AttributeRule {
    /// Its name.
    pub name: &'static str,
    /// The subject's symbol for it; may be empty.
    pub term: &'static str,
    /// Its type and range.
    pub kind: Kind,
    /// Whether it must stand, and what holds if it does not.
    pub presence: Presence,
    /// What it is, in one sentence without a full stop.
    pub sentence: fn(Lang) -> String,
}

/// The type of an attribute's value, with its range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// The version of the format: 1.
    Version,
    /// Any text.
    Text,
    /// A name: trimmed and not empty.
    Name,
    /// The name of a material of the document.
    MaterialName,
    /// The path of a file, relative to the document.
    Path,
    /// A colour in 0..1: three numbers, one for grey, or `#rrggbb`.
    Color,
    /// One or three numbers within a range.
    Channels(f64, f64),
    /// Three coordinates.
    Point,
    /// Three factors, or one for all.
    Factors,
    /// One length, greater than 0.
    Length,
    /// One number within a range.
    Number(f64, f64),
    /// A whole number within a range.
    Integer(u32, u32),
    /// A width and a height, greater than 0.
    Size,
    /// Four corners.
    Corners,
    /// One of several words.
    Choice(&'static [&'static str]),
    /// Steps of the algorithm, any of [`STEPS`].
    Steps,
    /// The first facet and how many.
    Run,
}

/// Whether an attribute must stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Presence {
    /// It must; with a sample value for the message.
    Required(&'static str),
    /// It need not; with the value that then holds, as it would be written.
    Default(&'static str),
    /// It need not; a free name is then found.
    Automatic,
    /// It need not, and then nothing is said.
    Optional,
    /// It must if the element is the document's root, and must not elsewhere.
    AtRoot(&'static str),
}

/// An element within another.
#[derive(Clone, Copy, Debug)]
pub struct Child {
    /// Its rule.
    pub rule: &'static ElementRule,
    /// How often it stands.
    pub times: Times,
}

/// How often an element stands within another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Times {
    /// Exactly once.
    Once,
    /// Once or not at all.
    AtMostOnce,
    /// Any number of times.
    Any,
}

/// What the text of an element is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextRule {
    /// No text is due.
    Nothing,
    /// Coordinates, by threes.
    Coordinates,
    /// Vertex numbers, by threes.
    Indices,
}

/// `true` and `false`.
pub const FLAG: Kind = Kind::Choice(&["true", "false"]);
/// The steps that a view can leave out.
pub const STEPS: &[&str] = &["shadows", "reflection", "transparency"];
/// The version of the format that is read and written.
pub const VERSION: &str = "1";

const COMPOSE: &[&str] = &[Compose::Screen.word(), Compose::ScreenEach.word(), Compose::Add.word()];
const LAWS: &[&str] = &[Reflectance::Constant.word(), Reflectance::Schlick.word(), Reflectance::Grazing.word()];
const HIGHLIGHTS: &[&str] = &[Highlight::Phong.word(), Highlight::Blinn.word()];

/// More than 0, so far as a length is told from 0.
const POSITIVE: Kind = Kind::Channels(limits::LEAST, limits::COORDINATE);

/// A radius that may be 0.
const RADIUS: Kind = Kind::Number(0.0, limits::COORDINATE);

const fn attribute(
    name: &'static str,
    term: &'static str,
    kind: Kind,
    presence: Presence,
    sentence: fn(Lang) -> String,
) -> AttributeRule {
    AttributeRule { name, term, kind, presence, sentence }
}

const fn required(
    name: &'static str,
    term: &'static str,
    kind: Kind,
    sample: &'static str,
    sentence: fn(Lang) -> String,
) -> AttributeRule {
    attribute(name, term, kind, Presence::Required(sample), sentence)
}

const fn default(
    name: &'static str,
    term: &'static str,
    kind: Kind,
    value: &'static str,
    sentence: fn(Lang) -> String,
) -> AttributeRule {
    attribute(name, term, kind, Presence::Default(value), sentence)
}

const fn optional(name: &'static str, kind: Kind, sentence: fn(Lang) -> String) -> AttributeRule {
    attribute(name, "", kind, Presence::Optional, sentence)
}

const OBJECT_NAME: AttributeRule = attribute("name", "", Kind::Name, Presence::Automatic, words::object_name);
const OBJECT_MATERIAL: AttributeRule = optional("material", Kind::MaterialName, words::object_material);
const VISIBLE: AttributeRule = default("visible", "", FLAG, "true", words::visible);
const INLINE_MATERIAL: &[Child] = &[Child { rule: &MATERIAL, times: Times::AtMostOnce }];

const fn any(rule: &'static ElementRule) -> Child {
    Child { rule, times: Times::Any }
}

const fn at_most_once(rule: &'static ElementRule) -> Child {
    Child { rule, times: Times::AtMostOnce }
}

/// The root of a scene document.
pub static SCENE: ElementRule = ElementRule {
    name: "scene",
    attributes: &[
        required("version", "", Kind::Version, VERSION, words::version),
        default("name", "", Kind::Text, "", words::scene_name),
    ],
    children: &[
        at_most_once(&WORLD),
        any(&MATERIAL),
        any(&LIGHT),
        any(&SPHERE),
        any(&PLANE),
        any(&CUBE),
        any(&BOX),
        any(&CONE),
        any(&FACET),
        any(&MESH),
    ],
    text: TextRule::Nothing,
    sentence: words::scene,
};

/// `world`.
pub static WORLD: ElementRule = ElementRule {
    name: "world",
    attributes: &[
        default("ambient", "Ia", Kind::Color, "0.2", words::ambient),
        default("background", "", Kind::Color, "0", words::background),
        default("index", "n", POSITIVE, "1", words::world_index),
        default("depth", "", Kind::Integer(0, limits::DEPTH), "6", words::world_depth),
        default("compose", "⊕", Kind::Choice(COMPOSE), Compose::Screen.word(), words::compose),
    ],
    children: &[],
    text: TextRule::Nothing,
    sentence: words::world,
};

/// `material`, named beside the objects or inline in one.
pub static MATERIAL: ElementRule = ElementRule {
    name: "material",
    attributes: &[
        required("name", "", Kind::Name, "red", words::material_name),
        default("ka", "Ka", Kind::Color, "0.2", words::ka),
        default("kd", "Kd", Kind::Color, "0.6", words::kd),
        default("ks", "W", Kind::Color, "0", words::ks),
        default("w", "W(l)", Kind::Choice(LAWS), Reflectance::Constant.word(), words::w),
        default("n", "n", Kind::Channels(0.0, limits::SHININESS), "30", words::shininess),
        default("kr", "Kr", Kind::Color, "0", words::kr),
        default("kt", "Kt", Kind::Color, "0", words::kt),
        default("index", "n'", POSITIVE, "1", words::material_index),
        default("highlight", "cos s", Kind::Choice(HIGHLIGHTS), Highlight::Phong.word(), words::highlight),
    ],
    children: &[],
    text: TextRule::Nothing,
    sentence: words::material,
};

/// `light`.
pub static LIGHT: ElementRule = ElementRule {
    name: "light",
    attributes: &[
        OBJECT_NAME,
        required("position", "", Kind::Point, "0 5 0", words::light_position),
        default("color", "I_L", Kind::Color, "1", words::light_color),
        VISIBLE,
    ],
    children: &[],
    text: TextRule::Nothing,
    sentence: words::light,
};

/// `sphere`.
pub static SPHERE: ElementRule = ElementRule {
    name: "sphere",
    attributes: &[
        OBJECT_NAME,
        required("center", "C", Kind::Point, "0 0 0", words::sphere_center),
        required("radius", "R", Kind::Length, "1", words::radius),
        OBJECT_MATERIAL,
        VISIBLE,
    ],
    children: INLINE_MATERIAL,
    text: TextRule::Nothing,
    sentence: words::sphere,
};

const THREE_POINTS: &[AttributeRule] = &[
    OBJECT_NAME,
    required("p0", "P0", Kind::Point, "0 0 0", words::p0),
    required("p1", "P1", Kind::Point, "0 0 1", words::p1),
    required("p2", "P2", Kind::Point, "1 0 0", words::p2),
    OBJECT_MATERIAL,
    VISIBLE,
];

/// `plane`.
pub static PLANE: ElementRule = ElementRule {
    name: "plane",
    attributes: THREE_POINTS,
    children: INLINE_MATERIAL,
    text: TextRule::Nothing,
    sentence: words::plane,
};

/// `cube`.
pub static CUBE: ElementRule = ElementRule {
    name: "cube",
    attributes: &[
        OBJECT_NAME,
        required("center", "", Kind::Point, "0 0 0", words::cube_center),
        required("edge", "", Kind::Length, "1", words::edge),
        default("rotation", "", Kind::Point, "0 0 0", words::cube_rotation),
        OBJECT_MATERIAL,
        VISIBLE,
    ],
    children: INLINE_MATERIAL,
    text: TextRule::Nothing,
    sentence: words::cube,
};

/// `box`.
pub static BOX: ElementRule = ElementRule {
    name: "box",
    attributes: &[
        OBJECT_NAME,
        required("origin", "", Kind::Point, "0 0 0", words::box_origin),
        required("u", "", Kind::Point, "1 0 0", words::box_u),
        required("v", "", Kind::Point, "0 1 0", words::box_v),
        required("w", "", Kind::Point, "0 0 1", words::box_w),
        OBJECT_MATERIAL,
        VISIBLE,
    ],
    children: INLINE_MATERIAL,
    text: TextRule::Nothing,
    sentence: words::parallelepiped,
};

/// `facet`.
pub static FACET: ElementRule = ElementRule {
    name: "facet",
    attributes: THREE_POINTS,
    children: INLINE_MATERIAL,
    text: TextRule::Nothing,
    sentence: words::facet,
};

/// `cone`.
pub static CONE: ElementRule = ElementRule {
    name: "cone",
    attributes: &[
        OBJECT_NAME,
        required("base", "", Kind::Point, "0 0 0", words::cone_base),
        required("top", "", Kind::Point, "0 1 0", words::cone_top),
        required("base-radius", "", RADIUS, "0.5", words::base_radius),
        required("top-radius", "", RADIUS, "0", words::top_radius),
        default("capped", "", FLAG, "true", words::capped),
        OBJECT_MATERIAL,
        VISIBLE,
    ],
    children: INLINE_MATERIAL,
    text: TextRule::Nothing,
    sentence: words::cone,
};

/// `mesh`.
pub static MESH: ElementRule = ElementRule {
    name: "mesh",
    attributes: &[
        OBJECT_NAME,
        optional("src", Kind::Path, words::src),
        default("scale", "", Kind::Factors, "1", words::scale),
        default("rotation", "", Kind::Point, "0 0 0", words::mesh_rotation),
        default("position", "", Kind::Point, "0 0 0", words::mesh_position),
        OBJECT_MATERIAL,
        default("smooth", "", FLAG, "false", words::smooth),
        VISIBLE,
    ],
    children: &[
        at_most_once(&MATERIAL),
        at_most_once(&VERTICES),
        at_most_once(&NORMALS),
        at_most_once(&FACETS),
        any(&PART),
    ],
    text: TextRule::Nothing,
    sentence: words::mesh,
};

/// `vertices` of a mesh.
pub static VERTICES: ElementRule = ElementRule {
    name: "vertices",
    attributes: &[],
    children: &[],
    text: TextRule::Coordinates,
    sentence: words::vertices,
};

/// `normals` of a mesh.
pub static NORMALS: ElementRule = ElementRule {
    name: "normals",
    attributes: &[],
    children: &[],
    text: TextRule::Coordinates,
    sentence: words::normals,
};

/// `facets` of a mesh.
pub static FACETS: ElementRule =
    ElementRule { name: "facets", attributes: &[], children: &[], text: TextRule::Indices, sentence: words::facets };

/// `part` of a mesh.
pub static PART: ElementRule = ElementRule {
    name: "part",
    attributes: &[
        optional("material", Kind::MaterialName, words::part_material),
        required("facets", "", Kind::Run, "0 1", words::part_facets),
    ],
    children: INLINE_MATERIAL,
    text: TextRule::Nothing,
    sentence: words::part,
};

/// The root of a document of views.
pub static VIEWS: ElementRule = ElementRule {
    name: "views",
    attributes: &[required("version", "", Kind::Version, VERSION, words::version)],
    children: &[any(&VIEW)],
    text: TextRule::Nothing,
    sentence: words::views,
};

/// `view`, within `views` or as a root of its own.
pub static VIEW: ElementRule = ElementRule {
    name: "view",
    attributes: &[
        attribute("version", "", Kind::Version, Presence::AtRoot(VERSION), words::version),
        attribute("name", "", Kind::Name, Presence::Automatic, words::view_name),
        default("width", "", Kind::Integer(1, limits::PIXELS), "640", words::width),
        default("height", "", Kind::Integer(1, limits::PIXELS), "480", words::height),
        default("samples", "", Kind::Integer(1, limits::SAMPLES), "1", words::samples),
        optional("depth", Kind::Integer(0, limits::DEPTH), words::view_depth),
        default("without", "", Kind::Steps, "", words::without),
    ],
    children: &[Child { rule: &EYE, times: Times::Once }, at_most_once(&SCREEN)],
    text: TextRule::Nothing,
    sentence: words::view,
};

/// `eye` of a view.
pub static EYE: ElementRule = ElementRule {
    name: "eye",
    attributes: &[
        required("at", "S", Kind::Point, "0 1 5", words::at),
        optional("look-at", Kind::Point, words::look_at),
        default("up", "", Kind::Point, "0 1 0", words::up),
        default("fov", "", Kind::Number(limits::FOV.0, limits::FOV.1), "45", words::fov),
    ],
    children: &[],
    text: TextRule::Nothing,
    sentence: words::eye,
};

/// `screen` of a view.
pub static SCREEN: ElementRule = ElementRule {
    name: "screen",
    attributes: &[
        optional("origin", Kind::Point, words::screen_origin),
        optional("u", Kind::Point, words::screen_u),
        optional("v", Kind::Point, words::screen_v),
        optional("center", Kind::Point, words::screen_center),
        optional("size", Kind::Size, words::screen_size),
        default("up", "", Kind::Point, "0 1 0", words::up),
        optional("corners", Kind::Corners, words::corners),
    ],
    children: &[],
    text: TextRule::Nothing,
    sentence: words::screen,
};

/// Every element, each after those that hold it.
pub static ELEMENTS: [&ElementRule; 19] = [
    &SCENE, &WORLD, &MATERIAL, &LIGHT, &SPHERE, &PLANE, &CUBE, &BOX, &CONE, &FACET, &MESH, &VERTICES, &NORMALS,
    &FACETS, &PART, &VIEWS, &VIEW, &EYE, &SCREEN,
];

impl ElementRule {
    /// The attribute of that name.
    pub fn attribute(&self, name: &str) -> Option<&'static AttributeRule> {
        self.attributes.iter().find(|attribute| attribute.name == name)
    }

    /// The elements that may hold it.
    pub fn homes(&'static self) -> Vec<&'static str> {
        let holds = |parent: &&&'static ElementRule| parent.children.iter().any(|child| child.rule.name == self.name);
        ELEMENTS.iter().filter(holds).map(|parent| parent.name).collect()
    }
}
