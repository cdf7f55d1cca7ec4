//! Attributes as values: what the properties panel shows and sets, by the names that the documents give them.
//!
//! The vocabulary of the documents says which attributes an element has; here stands how each is read from the model
//! and put into it. A field is a value of a few types, so a widget is made once a type.

use lancer_document::{Item, attribute};
use lancer_scene::{
    Compose, DVec3, Edit, Environment, Highlight, MaterialRef, Mesh, Object, PointLight, Reflectance, Rgb, Screen,
    ScreenSpec, Shape, Stage, Steps, Surface, View,
};
use std::sync::Arc;

/// The value of an attribute.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// `true` or `false`.
    Flag(bool),
    /// A whole number; `None` where the attribute need not stand.
    Integer(Option<u32>),
    /// One number.
    Number(f64),
    /// Three coordinates, directions, degrees or factors.
    Point(DVec3),
    /// A colour in 0..1.
    Color(Rgb),
    /// One number or three.
    Channels(Rgb),
    /// A width and a height.
    Size([f64; 2]),
    /// Four corners.
    Corners([DVec3; 4]),
    /// One of several words: its place among them.
    Choice(usize),
    /// A material.
    Material(MaterialRef),
    /// The steps of the algorithm.
    Steps(Steps),
}

/// What a field belongs to: the item itself, or the surface of its own that an object carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Home {
    /// The item.
    Item,
    /// The object's own surface.
    Inline,
}

/// The value of an attribute of an item; `None` if it has no such attribute now.
pub fn get(stage: &Stage, item: &Item, home: Home, name: &str) -> Option<Value> {
    let scene = &stage.scene;
    let place = item.place(stage);
    match item {
        Item::World => world(&scene.world, name),
        Item::Light(_) => light(scene.lights.get(place?)?, name),
        Item::Material(_) => surface(&scene.materials.get(place?)?.surface, name),
        Item::View(_) => view(stage.views.get(place?)?, name),
        Item::Object(_) => {
            let object = scene.objects.get(place?)?;
            match (home, &object.material) {
                (Home::Item, _) => self::object(object, name),
                (Home::Inline, MaterialRef::Inline(own)) => surface(own, name),
                (Home::Inline, MaterialRef::Default | MaterialRef::Named(_)) => None,
            }
        }
    }
}

/// The edit that sets an attribute; `None` where the item has no such attribute.
pub fn set(stage: &Stage, item: &Item, home: Home, name: &str, value: &Value) -> Option<Edit> {
    get(stage, item, home, name)?;
    match item {
        Item::World => Some(attribute::edit_world(stage, |world| set_world(world, name, value))),
        Item::Light(light) => attribute::edit_light(stage, light, |light| set_light(light, name, value)),
        Item::Material(material) => {
            attribute::edit_material(stage, material, |material| set_surface(&mut material.surface, name, value))
        }
        Item::View(view) => attribute::edit_view(stage, view, |view| set_view(view, name, value)),
        Item::Object(object) => attribute::edit_object(stage, object, |object| match (home, &mut object.material) {
            (Home::Item, _) => set_object(object, name, value),
            (Home::Inline, MaterialRef::Inline(own)) => set_surface(Arc::make_mut(own), name, value),
            (Home::Inline, MaterialRef::Default | MaterialRef::Named(_)) => {}
        }),
    }
}

/// The value that an attribute has where a document does not say; `None` where it must.
pub fn default(item: &Item, home: Home, name: &str) -> Option<Value> {
    match (item, home) {
        (Item::World, _) => world(&Environment::default(), name),
        (Item::Material(_), _) | (Item::Object(_), Home::Inline) => surface(&Surface::default(), name),
        (Item::Light(_) | Item::Object(_), _) => match name {
            "visible" => Some(Value::Flag(true)),
            "color" => Some(Value::Color(Rgb::WHITE)),
            "rotation" => Some(Value::Point(DVec3::ZERO)),
            "scale" => Some(Value::Point(DVec3::ONE)),
            "smooth" => Some(Value::Flag(false)),
            "material" => Some(Value::Material(MaterialRef::Default)),
            _ => None,
        },
        (Item::View(_), _) => match name {
            "width" => Some(Value::Integer(Some(640))),
            "height" => Some(Value::Integer(Some(480))),
            "samples" => Some(Value::Integer(Some(1))),
            "depth" => Some(Value::Integer(None)),
            "without" => Some(Value::Steps(Steps::default())),
            "up" => Some(Value::Point(DVec3::Y)),
            "fov" => Some(Value::Number(45.0)),
            _ => None,
        },
    }
}

fn place<T: PartialEq>(all: &[T], value: &T) -> Value {
    Value::Choice(all.iter().position(|known| known == value).unwrap_or(0))
}

fn world(world: &Environment, name: &str) -> Option<Value> {
    Some(match name {
        "ambient" => Value::Color(world.ambient),
        "background" => Value::Color(world.background),
        "index" => Value::Channels(world.index),
        "depth" => Value::Integer(Some(world.depth)),
        "compose" => place(&Compose::ALL, &world.compose),
        _ => return None,
    })
}

fn set_world(world: &mut Environment, name: &str, value: &Value) {
    match (name, value) {
        ("ambient", Value::Color(color)) => world.ambient = *color,
        ("background", Value::Color(color)) => world.background = *color,
        ("index", Value::Channels(index)) => world.index = *index,
        ("depth", Value::Integer(Some(depth))) => world.depth = *depth,
        ("compose", Value::Choice(place)) => pick(&Compose::ALL, *place, &mut world.compose),
        _ => {}
    }
}

fn light(light: &PointLight, name: &str) -> Option<Value> {
    Some(match name {
        "position" => Value::Point(light.position),
        "color" => Value::Color(light.color),
        "visible" => Value::Flag(light.visible),
        _ => return None,
    })
}

fn set_light(light: &mut PointLight, name: &str, value: &Value) {
    match (name, value) {
        ("position", Value::Point(position)) => light.position = *position,
        ("color", Value::Color(color)) => light.color = *color,
        ("visible", Value::Flag(visible)) => light.visible = *visible,
        _ => {}
    }
}

fn surface(surface: &Surface, name: &str) -> Option<Value> {
    Some(match name {
        "ka" => Value::Color(surface.ka),
        "kd" => Value::Color(surface.kd),
        "ks" => Value::Color(surface.ks),
        "kr" => Value::Color(surface.kr),
        "kt" => Value::Color(surface.kt),
        "n" => Value::Channels(surface.shininess),
        "index" => Value::Channels(surface.index),
        "w" => place(&Reflectance::ALL, &surface.w),
        "highlight" => place(&Highlight::ALL, &surface.highlight),
        _ => return None,
    })
}

fn set_surface(surface: &mut Surface, name: &str, value: &Value) {
    match (name, value) {
        ("ka", Value::Color(color)) => surface.ka = *color,
        ("kd", Value::Color(color)) => surface.kd = *color,
        ("ks", Value::Color(color)) => surface.ks = *color,
        ("kr", Value::Color(color)) => surface.kr = *color,
        ("kt", Value::Color(color)) => surface.kt = *color,
        ("n", Value::Channels(shininess)) => surface.shininess = *shininess,
        ("index", Value::Channels(index)) => surface.index = *index,
        ("w", Value::Choice(place)) => pick(&Reflectance::ALL, *place, &mut surface.w),
        ("highlight", Value::Choice(place)) => pick(&Highlight::ALL, *place, &mut surface.highlight),
        _ => {}
    }
}

fn object(object: &Object, name: &str) -> Option<Value> {
    match name {
        "material" => return Some(Value::Material(object.material.clone())),
        "visible" => return Some(Value::Flag(object.visible)),
        _ => {}
    }
    Some(match (&object.shape, name) {
        (Shape::Sphere { center, .. } | Shape::Cube { center, .. }, "center") => Value::Point(*center),
        (Shape::Sphere { radius, .. }, "radius") => Value::Number(*radius),
        (Shape::Plane { p0, .. } | Shape::Facet { p0, .. }, "p0") => Value::Point(*p0),
        (Shape::Plane { p1, .. } | Shape::Facet { p1, .. }, "p1") => Value::Point(*p1),
        (Shape::Plane { p2, .. } | Shape::Facet { p2, .. }, "p2") => Value::Point(*p2),
        (Shape::Cube { edge, .. }, "edge") => Value::Number(*edge),
        (Shape::Cube { rotation, .. }, "rotation") => Value::Point(*rotation),
        (Shape::Parallelepiped { origin, .. }, "origin") => Value::Point(*origin),
        (Shape::Parallelepiped { edges: [u, _, _], .. }, "u") => Value::Point(*u),
        (Shape::Parallelepiped { edges: [_, v, _], .. }, "v") => Value::Point(*v),
        (Shape::Parallelepiped { edges: [_, _, w], .. }, "w") => Value::Point(*w),
        (Shape::Cone { base, .. }, "base") => Value::Point(*base),
        (Shape::Cone { top, .. }, "top") => Value::Point(*top),
        (Shape::Cone { base_radius, .. }, "base-radius") => Value::Number(*base_radius),
        (Shape::Cone { top_radius, .. }, "top-radius") => Value::Number(*top_radius),
        (Shape::Cone { capped, .. }, "capped") => Value::Flag(*capped),
        (Shape::Mesh(Mesh { placement, .. }), "scale") => Value::Point(placement.scale),
        (Shape::Mesh(Mesh { placement, .. }), "rotation") => Value::Point(placement.rotation),
        (Shape::Mesh(Mesh { placement, .. }), "position") => Value::Point(placement.position),
        (Shape::Mesh(Mesh { smooth, .. }), "smooth") => Value::Flag(*smooth),
        _ => return None,
    })
}

fn set_object(object: &mut Object, name: &str, value: &Value) {
    match (name, value) {
        ("material", Value::Material(material)) => object.material = material.clone(),
        ("visible", Value::Flag(visible)) => object.visible = *visible,
        _ => set_shape(&mut object.shape, name, value),
    }
}

fn set_shape(shape: &mut Shape, name: &str, value: &Value) {
    match (shape, name, value) {
        (Shape::Sphere { center, .. } | Shape::Cube { center, .. }, "center", Value::Point(point)) => *center = *point,
        (Shape::Sphere { radius, .. }, "radius", Value::Number(length)) => *radius = *length,
        (Shape::Plane { p0, .. } | Shape::Facet { p0, .. }, "p0", Value::Point(point)) => *p0 = *point,
        (Shape::Plane { p1, .. } | Shape::Facet { p1, .. }, "p1", Value::Point(point)) => *p1 = *point,
        (Shape::Plane { p2, .. } | Shape::Facet { p2, .. }, "p2", Value::Point(point)) => *p2 = *point,
        (Shape::Cube { edge, .. }, "edge", Value::Number(length)) => *edge = *length,
        (Shape::Cube { rotation, .. }, "rotation", Value::Point(point)) => *rotation = *point,
        (Shape::Parallelepiped { origin, .. }, "origin", Value::Point(point)) => *origin = *point,
        (Shape::Parallelepiped { edges: [u, _, _], .. }, "u", Value::Point(point)) => *u = *point,
        (Shape::Parallelepiped { edges: [_, v, _], .. }, "v", Value::Point(point)) => *v = *point,
        (Shape::Parallelepiped { edges: [_, _, w], .. }, "w", Value::Point(point)) => *w = *point,
        (Shape::Cone { base, .. }, "base", Value::Point(point)) => *base = *point,
        (Shape::Cone { top, .. }, "top", Value::Point(point)) => *top = *point,
        (Shape::Cone { base_radius, .. }, "base-radius", Value::Number(length)) => *base_radius = *length,
        (Shape::Cone { top_radius, .. }, "top-radius", Value::Number(length)) => *top_radius = *length,
        (Shape::Cone { capped, .. }, "capped", Value::Flag(flag)) => *capped = *flag,
        (Shape::Mesh(mesh), "scale", Value::Point(point)) => mesh.placement.scale = *point,
        (Shape::Mesh(mesh), "rotation", Value::Point(point)) => mesh.placement.rotation = *point,
        (Shape::Mesh(mesh), "position", Value::Point(point)) => mesh.placement.position = *point,
        (Shape::Mesh(mesh), "smooth", Value::Flag(smooth)) => mesh.smooth = *smooth,
        _ => {}
    }
}

fn view(view: &View, name: &str) -> Option<Value> {
    match name {
        "width" => return Some(Value::Integer(Some(view.width))),
        "height" => return Some(Value::Integer(Some(view.height))),
        "samples" => return Some(Value::Integer(Some(view.samples))),
        "depth" => return Some(Value::Integer(view.depth)),
        "without" => return Some(Value::Steps(view.steps)),
        "at" => return Some(Value::Point(view.eye)),
        _ => {}
    }
    Some(match (&view.screen, name) {
        (ScreenSpec::LookAt { look_at, .. }, "look-at") => Value::Point(*look_at),
        (ScreenSpec::LookAt { fov, .. }, "fov") => Value::Number(*fov),
        (ScreenSpec::LookAt { up, .. } | ScreenSpec::Centered { up, .. }, "up") => Value::Point(*up),
        (ScreenSpec::Centered { center, .. }, "center") => Value::Point(*center),
        (ScreenSpec::Centered { size, .. }, "size") => Value::Size(*size),
        (ScreenSpec::Frame(screen), "origin") => Value::Point(screen.origin),
        (ScreenSpec::Frame(screen), "u") => Value::Point(screen.u),
        (ScreenSpec::Frame(screen), "v") => Value::Point(screen.v),
        (ScreenSpec::Corners(corners), "corners") => Value::Corners(*corners),
        _ => return None,
    })
}

fn set_view(view: &mut View, name: &str, value: &Value) {
    match (name, value) {
        ("width", Value::Integer(Some(width))) => view.width = *width,
        ("height", Value::Integer(Some(height))) => view.height = *height,
        ("samples", Value::Integer(Some(samples))) => view.samples = *samples,
        ("depth", Value::Integer(depth)) => view.depth = *depth,
        ("without", Value::Steps(steps)) => view.steps = *steps,
        ("at", Value::Point(eye)) => view.eye = *eye,
        _ => set_screen(&mut view.screen, name, value),
    }
}

fn set_screen(screen: &mut ScreenSpec, name: &str, value: &Value) {
    match (screen, name, value) {
        (ScreenSpec::LookAt { look_at, .. }, "look-at", Value::Point(point)) => *look_at = *point,
        (ScreenSpec::LookAt { fov, .. }, "fov", Value::Number(degrees)) => *fov = *degrees,
        (ScreenSpec::LookAt { up, .. } | ScreenSpec::Centered { up, .. }, "up", Value::Point(point)) => *up = *point,
        (ScreenSpec::Centered { center, .. }, "center", Value::Point(point)) => *center = *point,
        (ScreenSpec::Centered { size, .. }, "size", Value::Size(extent)) => *size = *extent,
        (ScreenSpec::Frame(screen), "origin", Value::Point(point)) => screen.origin = *point,
        (ScreenSpec::Frame(screen), "u", Value::Point(point)) => screen.u = *point,
        (ScreenSpec::Frame(screen), "v", Value::Point(point)) => screen.v = *point,
        (ScreenSpec::Corners(corners), "corners", Value::Corners(new)) => *corners = *new,
        _ => {}
    }
}

fn pick<T: Copy>(all: &[T], place: usize, value: &mut T) {
    if let Some(found) = all.get(place) {
        *value = *found;
    }
}

/// The four ways of giving a screen, in the order in which menus show them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScreenKind {
    /// By a point that the eye looks at.
    LookAt,
    /// By its centre and size.
    Centered,
    /// By a corner and two edges.
    Frame,
    /// By its four corners.
    Corners,
}

impl ScreenKind {
    /// Every way.
    pub const ALL: [ScreenKind; 4] = [ScreenKind::LookAt, ScreenKind::Centered, ScreenKind::Frame, ScreenKind::Corners];

    /// How a view gives its screen.
    pub fn of(view: &View) -> ScreenKind {
        match view.screen {
            ScreenSpec::LookAt { .. } => ScreenKind::LookAt,
            ScreenSpec::Centered { .. } => ScreenKind::Centered,
            ScreenSpec::Frame(_) => ScreenKind::Frame,
            ScreenSpec::Corners(_) => ScreenKind::Corners,
        }
    }

    /// The view's screen given in this way, showing the same picture where this way can say it; `None` where the screen
    /// is broken.
    pub fn convert(self, view: &View) -> Option<ScreenSpec> {
        let screen @ Screen { origin, u, v } = view.resolved_screen().ok()?;
        let center = screen.point(0.5, 0.5);
        let up = match view.screen {
            ScreenSpec::LookAt { up, .. } | ScreenSpec::Centered { up, .. } => up,
            ScreenSpec::Frame(_) | ScreenSpec::Corners(_) => -v.normalize_or_zero(),
        };
        Some(match self {
            ScreenKind::LookAt => {
                let look_at = match view.screen {
                    ScreenSpec::LookAt { look_at, .. } => look_at,
                    ScreenSpec::Centered { .. } | ScreenSpec::Frame(_) | ScreenSpec::Corners(_) => center,
                };
                let half = (u.length() / 2.0 / (center - view.eye).length()).atan().to_degrees();
                ScreenSpec::LookAt { look_at, up, fov: ((2.0 * half * 1e6).round() / 1e6).clamp(1.0, 179.0) }
            }
            ScreenKind::Centered => ScreenSpec::Centered { center, size: [u.length(), v.length()], up },
            ScreenKind::Frame => ScreenSpec::Frame(screen),
            ScreenKind::Corners => ScreenSpec::Corners([origin + v, origin + u + v, origin + u, origin]),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lancer_formats::xml::vocabulary::{self, ElementRule};
    use lancer_scene::{List, Material, MeshGeometry, Placement};

    /// An item with its home and the elements that describe it.
    type Described = (Item, Home, Vec<&'static ElementRule>);

    /// One item of every kind.
    fn stage() -> (Stage, Vec<Described>) {
        let shapes = [
            (Shape::Sphere { center: DVec3::ONE, radius: 2.0 }, &vocabulary::SPHERE),
            (Shape::Plane { p0: DVec3::ZERO, p1: DVec3::X, p2: DVec3::Y }, &vocabulary::PLANE),
            (Shape::Facet { p0: DVec3::ZERO, p1: DVec3::X, p2: DVec3::Y }, &vocabulary::FACET),
            (Shape::Cube { center: DVec3::ONE, edge: 2.0, rotation: DVec3::ZERO }, &vocabulary::CUBE),
            (Shape::Parallelepiped { origin: DVec3::ONE, edges: [DVec3::X, DVec3::Y, DVec3::Z] }, &vocabulary::BOX),
            (
                Shape::Cone { base: DVec3::ZERO, top: DVec3::Y, base_radius: 0.5, top_radius: 0.25, capped: true },
                &vocabulary::CONE,
            ),
            (
                Shape::Mesh(Mesh {
                    geometry: Arc::new(MeshGeometry::default()),
                    source: None,
                    placement: Placement::default(),
                    smooth: false,
                }),
                &vocabulary::MESH,
            ),
        ];
        let mut items = vec![
            (Item::World, Home::Item, vec![&vocabulary::WORLD]),
            (Item::Light("lamp".into()), Home::Item, vec![&vocabulary::LIGHT]),
            (Item::Material("red".into()), Home::Item, vec![&vocabulary::MATERIAL]),
        ];
        let mut stage = Stage::default();
        let mut objects = Vec::new();
        for (shape, rule) in shapes {
            let object = Object::new(shape.element(), shape);
            items.push((Item::Object(object.name.clone()), Home::Item, vec![rule]));
            items.push((Item::Object(object.name.clone()), Home::Inline, vec![&vocabulary::MATERIAL]));
            objects.push(Object { material: MaterialRef::Inline(Arc::default()), ..object });
        }
        stage.scene.objects = objects.into_iter().collect::<List<Object>>();
        stage.scene.lights = [PointLight::new("lamp", DVec3::Y)].into_iter().collect::<List<PointLight>>();
        stage.scene.materials =
            [Material { name: "red".into(), surface: Surface::default() }].into_iter().collect::<List<Material>>();
        let mut views = Vec::new();
        for (name, kind) in [("a", 0), ("b", 1), ("c", 2), ("d", 3)] {
            let mut view = View {
                name: name.into(),
                width: 64,
                height: 48,
                eye: DVec3::new(0.0, 1.0, 5.0),
                screen: ScreenSpec::LookAt { look_at: DVec3::ZERO, up: DVec3::Y, fov: 40.0 },
                samples: 1,
                depth: Some(3),
                steps: Steps::default(),
            };
            view.screen = ScreenKind::ALL[kind].convert(&view).unwrap();
            items.push((
                Item::View(name.into()),
                Home::Item,
                vec![&vocabulary::VIEW, &vocabulary::EYE, &vocabulary::SCREEN],
            ));
            views.push(view);
        }
        stage.views = views.into_iter().collect();
        (stage, items)
    }

    /// Every attribute of the vocabulary can be read of some item, and setting it to what it is changes nothing.
    #[test]
    fn every_attribute_of_the_vocabulary_is_a_field() {
        let (stage, items) = stage();
        let mut seen = std::collections::BTreeSet::new();
        for (item, home, rules) in &items {
            for rule in rules {
                for attribute in rule.attributes {
                    let Some(value) = get(&stage, item, *home, attribute.name) else { continue };
                    seen.insert((rule.name, attribute.name));
                    let edit = set(&stage, item, *home, attribute.name, &value).unwrap();
                    assert_eq!(stage.apply(&edit).unwrap().0, stage, "{item:?} {}", attribute.name);
                }
            }
        }
        for (_, _, rules) in &items {
            for rule in rules {
                for attribute in rule.attributes {
                    // names are changed by renaming; versions and files are the readers' matter
                    if !["name", "version", "src"].contains(&attribute.name) {
                        assert!(seen.contains(&(rule.name, attribute.name)), "{} @ {}", rule.name, attribute.name);
                    }
                }
            }
        }
    }

    #[test]
    fn a_field_that_is_set_has_its_value() {
        let (stage, _) = stage();
        let item = Item::Object("sphere".into());
        let edit = set(&stage, &item, Home::Item, "radius", &Value::Number(3.5)).unwrap();
        let (after, _) = stage.apply(&edit).unwrap();
        assert_eq!(get(&after, &item, Home::Item, "radius"), Some(Value::Number(3.5)));
        let edit = set(&stage, &item, Home::Inline, "kr", &Value::Color(Rgb::splat(0.5))).unwrap();
        let (after, _) = stage.apply(&edit).unwrap();
        assert_eq!(get(&after, &item, Home::Inline, "kr"), Some(Value::Color(Rgb::splat(0.5))));
    }

    /// A screen that is given in another way shows the same picture.
    #[test]
    fn screens_convert_into_each_other() {
        let (stage, _) = stage();
        for view in &stage.views {
            let expected = view.resolved_screen().unwrap();
            for kind in ScreenKind::ALL {
                let converted = View { screen: kind.convert(view).unwrap(), ..View::clone(view) };
                let screen = converted.resolved_screen().unwrap();
                for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.3, 0.9)] {
                    let direction = |screen: &Screen| (screen.point(x, y) - view.eye).normalize();
                    assert!((direction(&screen) - direction(&expected)).length() < 1e-6, "{kind:?}");
                }
            }
        }
    }
}
