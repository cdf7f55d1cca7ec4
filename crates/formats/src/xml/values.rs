//! The attributes that the model's parts have in a document: what the readers do, the other way round.

use super::kind::Value;
use super::vocabulary::{AttributeRule, BOX, CONE, CUBE, ElementRule, FACET, MESH, PLANE, Presence, SPHERE};
use lancer_scene::{
    DVec3, Environment, Material, MaterialRef, Object, Part, PointLight, Rgb, Scene, ScreenSpec, Shape, Surface, View,
};

/// The values of an element's attributes by their names; one that is missing does not stand in the document.
pub(super) type Values<'m> = Vec<(&'static str, Value<'m>)>;

/// The rule of a shape's element.
pub(super) fn shape_rule(shape: &Shape) -> &'static ElementRule {
    match shape {
        Shape::Sphere { .. } => &SPHERE,
        Shape::Plane { .. } => &PLANE,
        Shape::Facet { .. } => &FACET,
        Shape::Cube { .. } => &CUBE,
        Shape::Parallelepiped { .. } => &BOX,
        Shape::Cone { .. } => &CONE,
        Shape::Mesh(_) => &MESH,
    }
}

/// The attributes of an element that must stand, in the vocabulary's order, each with its text without escapes.
pub(super) fn written(rule: &'static ElementRule, values: &Values<'_>) -> Vec<(&'static str, String)> {
    let written = |attribute: &'static AttributeRule| {
        let (_, value) = values.iter().find(|(name, _)| *name == attribute.name)?;
        let text = attribute.kind.write(value);
        let is_default = matches!(attribute.presence, Presence::Default(default) if default == text);
        (!is_default).then_some((attribute.name, text))
    };
    rule.attributes.iter().filter_map(written).collect()
}

pub(super) fn scene(scene: &Scene) -> Values<'_> {
    vec![("version", Value::Integer(1)), ("name", text(&scene.name))]
}

pub(super) fn world(world: &Environment) -> Values<'static> {
    vec![
        ("ambient", channels(world.ambient)),
        ("background", channels(world.background)),
        ("index", channels(world.index)),
        ("depth", Value::Integer(world.depth)),
        ("compose", Value::Word(world.compose.word())),
    ]
}

pub(super) fn surface(surface: &Surface) -> Values<'static> {
    vec![
        ("ka", channels(surface.ka)),
        ("kd", channels(surface.kd)),
        ("ks", channels(surface.ks)),
        ("w", Value::Word(surface.w.word())),
        ("n", channels(surface.shininess)),
        ("kr", channels(surface.kr)),
        ("kt", channels(surface.kt)),
        ("index", channels(surface.index)),
        ("highlight", Value::Word(surface.highlight.word())),
    ]
}

pub(super) fn material(material: &Material) -> Values<'_> {
    let mut values = vec![("name", text(&material.name))];
    values.extend(surface(&material.surface));
    values
}

pub(super) fn light(light: &PointLight) -> Values<'_> {
    vec![
        ("name", text(&light.name)),
        ("position", point(light.position)),
        ("color", channels(light.color)),
        ("visible", flag(light.visible)),
    ]
}

pub(super) fn object(object: &Object) -> Values<'_> {
    let mut values = vec![("name", text(&object.name)), ("visible", flag(object.visible))];
    values.extend(material_name(&object.material));
    match &object.shape {
        Shape::Sphere { center, radius } => {
            values.extend([("center", point(*center)), ("radius", Value::Number(*radius))]);
        }
        Shape::Plane { p0, p1, p2 } | Shape::Facet { p0, p1, p2 } => {
            values.extend([("p0", point(*p0)), ("p1", point(*p1)), ("p2", point(*p2))]);
        }
        Shape::Cube { center, edge, rotation } => {
            values.extend([("center", point(*center)), ("edge", Value::Number(*edge)), ("rotation", point(*rotation))])
        }
        Shape::Parallelepiped { origin, edges: [u, v, w] } => {
            values.extend([("origin", point(*origin)), ("u", point(*u)), ("v", point(*v)), ("w", point(*w))]);
        }
        Shape::Cone { base, top, base_radius, top_radius, capped } => values.extend([
            ("base", point(*base)),
            ("top", point(*top)),
            ("base-radius", Value::Number(*base_radius)),
            ("top-radius", Value::Number(*top_radius)),
            ("capped", flag(*capped)),
        ]),
        Shape::Mesh(mesh) => {
            values.extend(mesh.source.as_deref().map(|source| ("src", text(source))));
            values.extend([
                ("scale", point(mesh.placement.scale)),
                ("rotation", point(mesh.placement.rotation)),
                ("position", point(mesh.placement.position)),
                ("smooth", flag(mesh.smooth)),
            ]);
        }
    }
    values
}

pub(super) fn part(part: &Part) -> Values<'_> {
    let mut values = vec![("facets", Value::Run(part.first, part.count))];
    values.extend(material_name(&part.material));
    values
}

pub(super) fn view(view: &View) -> Values<'_> {
    let mut values = vec![
        ("name", text(&view.name)),
        ("width", Value::Integer(view.width)),
        ("height", Value::Integer(view.height)),
        ("samples", Value::Integer(view.samples)),
        ("without", Value::Steps(view.steps)),
    ];
    values.extend(view.depth.map(|depth| ("depth", Value::Integer(depth))));
    values
}

pub(super) fn eye(view: &View) -> Values<'static> {
    let mut values = vec![("at", point(view.eye))];
    if let ScreenSpec::LookAt { look_at, up, fov } = &view.screen {
        values.extend([("look-at", point(*look_at)), ("up", point(*up)), ("fov", Value::Number(*fov))]);
    }
    values
}

/// The attributes of `screen`; `None` where the eye gives it.
pub(super) fn screen(view: &View) -> Option<Values<'static>> {
    Some(match &view.screen {
        ScreenSpec::Frame(screen) => {
            vec![("origin", point(screen.origin)), ("u", point(screen.u)), ("v", point(screen.v))]
        }
        ScreenSpec::Centered { center, size, up } => {
            vec![("center", point(*center)), ("size", Value::Pair(*size)), ("up", point(*up))]
        }
        ScreenSpec::Corners(corners) => {
            vec![("corners", Value::Corners(Box::new(corners.map(|corner| corner.to_array()))))]
        }
        ScreenSpec::LookAt { .. } => return None,
    })
}

fn text(text: &str) -> Value<'_> {
    Value::Text(text.into())
}

fn point(point: DVec3) -> Value<'static> {
    Value::Triple(point.to_array())
}

fn channels(channels: Rgb) -> Value<'static> {
    Value::Triple(channels.to_array())
}

fn flag(flag: bool) -> Value<'static> {
    Value::Word(if flag { "true" } else { "false" })
}

fn material_name(material: &MaterialRef) -> Option<(&'static str, Value<'_>)> {
    material.name().map(|name| ("material", text(name)))
}
