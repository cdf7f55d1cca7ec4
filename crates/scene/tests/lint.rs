//! Lint: each rule speaks where it must, and is silent on what is as it should be.

#![allow(clippy::unwrap_used, reason = "the helpers of tests may panic")]

mod arbitrary;

use lancer_scene::{
    Bounce, DVec3, Finding, List, Material, MaterialRef, Mesh, MeshGeometry, Name, NameKind, Object, Owner, Part,
    Placement, PointLight, Rgb, Scene, Screen, ScreenSpec, Shape, Steps, Surface, View, Views, Weight, lint,
};
use proptest::prelude::*;
use std::sync::Arc;

const fn at(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

fn sphere(center: DVec3, radius: f64) -> Shape {
    Shape::Sphere { center, radius }
}

fn cube(center: DVec3, edge: f64) -> Shape {
    Shape::Cube { center, edge, rotation: DVec3::ZERO }
}

/// An upright cone of height 1 from a point.
fn cone(base: DVec3, base_radius: f64, top_radius: f64, capped: bool) -> Shape {
    Shape::Cone { base, top: base + DVec3::Y, base_radius, top_radius, capped }
}

/// The plane at a height, its normal upwards.
fn level(height: f64) -> Shape {
    Shape::Plane { p0: at(0.0, height, 0.0), p1: at(0.0, height, 1.0), p2: at(1.0, height, 0.0) }
}

/// The wall at a place on the x axis.
fn wall(x: f64) -> Shape {
    Shape::Plane { p0: at(x, 0.0, 0.0), p1: at(x, 1.0, 0.0), p2: at(x, 0.0, 1.0) }
}

fn facet(p0: DVec3, p1: DVec3, p2: DVec3) -> Shape {
    Shape::Facet { p0, p1, p2 }
}

fn tetrahedron() -> MeshGeometry {
    MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Z, DVec3::Y],
        facets: vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]],
        ..MeshGeometry::default()
    }
}

fn mesh(geometry: &Arc<MeshGeometry>, position: DVec3, scale: f64) -> Shape {
    let placement = Placement { position, scale: DVec3::splat(scale), ..Placement::default() };
    Shape::Mesh(Mesh { geometry: Arc::clone(geometry), source: None, placement, smooth: false })
}

fn glass() -> Surface {
    Surface { kt: Rgb::splat(0.9), index: Rgb::splat(1.5), ..Surface::default() }
}

fn mirror() -> Surface {
    Surface { kr: Rgb::splat(0.8), ..Surface::default() }
}

fn of(surface: Surface, name: &str, shape: Shape) -> Object {
    Object { material: MaterialRef::Inline(Arc::new(surface)), ..Object::new(name, shape) }
}

fn scene(objects: impl IntoIterator<Item = Object>) -> Scene {
    let lights = [PointLight::new("lamp", at(-3.0, 5.0, 4.0))].into_iter().collect();
    Scene { lights, objects: objects.into_iter().collect(), ..Scene::default() }
}

fn with_lamp(scene: Scene, position: DVec3) -> Scene {
    Scene { lights: [PointLight::new("lamp", position)].into_iter().collect(), ..scene }
}

/// A view from a point towards the origin.
fn from(eye: DVec3) -> View {
    View {
        name: "front".into(),
        width: 64,
        height: 48,
        eye,
        screen: ScreenSpec::LookAt { look_at: at(0.0, 0.5, 0.0), up: DVec3::Y, fov: 45.0 },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    }
}

fn front() -> View {
    from(at(0.0, 1.0, 6.0))
}

fn views(views: impl IntoIterator<Item = View>) -> Views {
    views.into_iter().collect()
}

fn found(scene: &Scene, view: View) -> Vec<Finding> {
    assert_eq!(scene.check(), Ok(()));
    assert_eq!(view.check(), Ok(()));
    lint(scene, &views([view]))
}

fn blind(scene: &Scene) -> Vec<Finding> {
    assert_eq!(scene.check(), Ok(()));
    lint(scene, &[])
}

fn name(name: &str) -> Name {
    name.into()
}

/// A floor, a ball that stands on it, a glass ball and a mirror beside it, a box and a mesh.
fn ordinary() -> Scene {
    scene([
        Object::new("floor", level(0.0)),
        Object::new("ball", sphere(at(0.0, 0.5, 0.0), 0.5)),
        of(glass(), "glass ball", sphere(at(1.2, 0.5, 0.5), 0.5)),
        of(mirror(), "mirror ball", sphere(at(-1.2, 0.5, 0.5), 0.5)),
        Object::new("die", cube(at(0.0, 0.25, 2.0), 0.5)),
        Object::new("pyramid", mesh(&Arc::new(tetrahedron()), at(2.0, 0.0, 0.0), 1.0)),
    ])
}

#[test]
fn an_ordinary_scene_has_nothing_to_be_said_of() {
    assert_eq!(blind(&ordinary()), []);
    assert_eq!(found(&ordinary(), front()), []);
    let centered = ScreenSpec::Centered { center: at(0.0, 0.5, 0.0), size: [4.0, 3.0], up: DVec3::Y };
    assert_eq!(found(&ordinary(), View { screen: centered, ..front() }), []);
}

proptest! {
    /// Whatever the scene, lint ends and names only what there is.
    #[test]
    fn findings_name_what_there_is(stage in arbitrary::stage()) {
        for finding in lint(&stage.scene, &stage.views) {
            for (kind, name) in finding.names() {
                let scene = &stage.scene;
                prop_assert!(match kind {
                    NameKind::ObjectOrLight => scene.has_object_or_light(name),
                    NameKind::Material => scene.material(name).is_some(),
                    NameKind::View => stage.views.iter().any(|view| view.name == *name),
                }, "{finding:?}");
            }
        }
    }

    /// Hidden objects and lamps are as if they were not there, but for what counts them and for unused materials.
    #[test]
    fn hidden_things_change_nothing(stage in arbitrary::stage()) {
        let shown = Scene {
            lights: stage.scene.lights.iter().filter(|light| light.visible).cloned().collect(),
            objects: stage.scene.objects.iter().filter(|object| object.visible).cloned().collect(),
            ..stage.scene.clone()
        };
        let rest = |scene: &Scene| -> Vec<Finding> {
            lint(scene, &stage.views)
                .into_iter()
                .filter(|finding| !matches!(
                    finding,
                    Finding::NoLamp { .. } | Finding::NoObject { .. } | Finding::UnusedMaterial { .. }
                ))
                .collect()
        };
        prop_assert_eq!(rest(&stage.scene), rest(&shown));
    }
}

#[test]
fn an_empty_scene() {
    assert_eq!(blind(&Scene::default()), [Finding::NoObject { hidden: 0 }]);
    let hidden = Object { visible: false, ..Object::new("ball", sphere(DVec3::ZERO, 1.0)) };
    assert_eq!(blind(&scene([hidden])), [Finding::NoObject { hidden: 1 }]);
}

#[test]
fn lamps_that_are_missing_hidden_or_black() {
    let dark = |lights: List<PointLight>| blind(&Scene { lights, ..ordinary() });
    assert_eq!(dark(List::default()), [Finding::NoLamp { hidden: 0 }]);
    let lamp = PointLight::new("lamp", at(-3.0, 5.0, 4.0));
    let hidden = PointLight { visible: false, ..lamp.clone() };
    assert_eq!(dark([hidden].into_iter().collect()), [Finding::NoLamp { hidden: 1 }]);
    let black = PointLight { color: Rgb::BLACK, ..lamp };
    assert_eq!(dark([black].into_iter().collect()), [Finding::DarkLamp { lamp: name("lamp") }]);
}

#[test]
fn a_lamp_inside_an_object() {
    let inside = |object: &str| [Finding::LampInside { lamp: name("lamp"), object: name(object) }];
    assert_eq!(found(&with_lamp(ordinary(), at(0.0, 0.5, 0.1)), front()), inside("ball"));
    assert_eq!(found(&with_lamp(ordinary(), at(1.2, 0.5, 0.5)), front()), inside("glass ball"));
    assert_eq!(found(&with_lamp(ordinary(), at(0.2, 0.4, 2.2)), front()), inside("die"));
    assert_eq!(blind(&with_lamp(ordinary(), at(2.1, 0.1, 0.1))), inside("pyramid"));
    let lantern = |capped| {
        let lantern = Object::new("lantern", cone(at(-1.0, 0.0, 3.0), 0.5, 0.1, capped));
        with_lamp(scene([lantern]), at(-1.2, 0.5, 3.0))
    };
    assert_eq!(blind(&lantern(true)), inside("lantern"));
    assert_eq!(blind(&lantern(false)), []);
    assert_eq!(blind(&with_lamp(lantern(true), at(-1.4, 0.5, 3.0))), [], "beside its side");
    // On the surface is outside, and a corner of the box around it is not the mesh.
    assert_eq!(found(&with_lamp(ordinary(), at(0.0, 1.0, 0.0)), front()), []);
    assert_eq!(found(&with_lamp(ordinary(), at(2.9, 0.9, 0.9)), front()), []);
    // Without shadows every lamp lights.
    let flat = View { steps: Steps { shadows: false, ..Steps::default() }, ..front() };
    assert_eq!(found(&with_lamp(ordinary(), at(0.0, 0.5, 0.1)), flat), []);
}

#[test]
fn a_room_may_hold_lamp_and_eye() {
    let room = scene([
        Object::new("room", cube(at(0.0, 5.0, 0.0), 20.0)),
        Object::new("ball", sphere(at(0.0, 0.5, 0.0), 0.5)),
    ]);
    assert_eq!(found(&room, front()), []);
    assert_eq!(blind(&room), []);
    assert_eq!(
        found(&room, from(at(0.0, 1.0, 60.0))),
        [Finding::LampInside { lamp: name("lamp"), object: name("room") }]
    );
}

#[test]
fn a_lamp_below_the_floor() {
    let below = with_lamp(ordinary(), at(-3.0, -5.0, 4.0));
    let finding = [Finding::LampBehindPlane { lamp: name("lamp"), plane: name("floor") }];
    assert_eq!(found(&below, front()), finding);
    assert_eq!(blind(&below), finding);
    // From below, that lamp is the right one, and what stands on the floor is hidden.
    let seen = found(&below, from(at(0.0, -1.0, 6.0)));
    assert!(!seen.contains(&finding[0]), "{seen:?}");
    // A floor of glass lets the sight through to what that lamp lights.
    let mut objects: Vec<Object> = ordinary().objects.iter().map(|object| Object::clone(object)).collect();
    objects[0] = of(glass(), "floor", level(0.0));
    let water = Scene { objects: objects.into_iter().collect(), ..below };
    let seen = found(&water, front());
    assert!(!seen.contains(&finding[0]), "{seen:?}");
}

#[test]
fn an_eye_inside_an_object() {
    let inside = |object: &str| Finding::EyeInside { view: name("front"), object: name(object) };
    assert_eq!(found(&ordinary(), from(at(0.0, 0.5, 0.2))), [inside("ball")]);
    assert_eq!(found(&ordinary(), from(at(2.1, 0.1, 0.1))), [inside("pyramid")]);
    let in_glass = Finding::EyeInGlass { view: name("front"), object: name("glass ball") };
    assert_eq!(in_glass.weight(), Weight::Note);
    assert_eq!(found(&ordinary(), from(at(1.2, 0.5, 0.6))), [in_glass]);
}

#[test]
fn an_eye_under_water() {
    let pool = |height| scene([of(glass(), "water", level(height)), Object::new("fish", sphere(DVec3::ZERO, 0.5))]);
    let below = Finding::EyeBehindGlassPlane { view: name("front"), plane: name("water") };
    assert_eq!(found(&pool(3.0), front()), [below]);
    assert_eq!(found(&pool(0.9), front()), []);
}

#[test]
fn planes_between_the_eye_and_the_objects() {
    let behind = Finding::EyeBehindPlane { view: name("front"), plane: name("floor") };
    let under = found(&ordinary(), from(at(0.0, -1.0, 6.0)));
    assert!(under.contains(&behind), "{under:?}");
    // One object of several is hidden behind a wall.
    let mut stage = ordinary();
    stage.objects = stage.objects.with(|objects| objects.push(Arc::new(Object::new("wall", wall(-6.0)))));
    assert_eq!(found(&stage, front()), []);
    let lost = |x: f64, y: f64, name: &str| Arc::new(Object::new(name, sphere(at(x, y, 0.0), 0.5)));
    stage.objects = stage.objects.with(|objects| objects.extend([lost(-8.0, 1.0, "lost"), lost(-9.0, 2.0, "found")]));
    let hidden = Finding::HiddenBehindPlane { plane: name("wall"), object: name("lost"), count: 2 };
    assert_eq!(found(&stage, front()), [hidden]);
    // What looks through the wall on one side is enough, and so is not to know where the eyes are.
    assert_eq!(blind(&stage), []);
    let other = View { name: name("other"), ..from(at(-12.0, 1.0, 6.0)) };
    let both = lint(&stage, &views([front(), other]));
    assert!(!both.iter().any(|finding| matches!(finding, Finding::HiddenBehindPlane { .. })), "{both:?}");
}

#[test]
fn a_plane_through_the_eye() {
    let edge_on = Finding::PlaneThroughEye { view: name("front"), plane: name("floor") };
    assert_eq!(found(&ordinary(), from(at(0.0, 0.0, 6.0))), [edge_on]);
    assert_eq!(found(&ordinary(), from(at(0.0, 1e-3, 6.0))), []);
}

#[test]
fn screens_that_mirror_or_stretch() {
    let screen = |u: f64, v: f64| {
        let (u, v) = (DVec3::X * u, DVec3::NEG_Y * v);
        ScreenSpec::Frame(Screen { origin: at(0.0, 1.0, 4.0) - (u + v) * 0.5, u, v })
    };
    let seen = |u, v| found(&ordinary(), View { screen: screen(u, v), ..front() });
    assert_eq!(seen(2.0, 1.5), []);
    assert_eq!(seen(2.0, 1.49), []);
    assert_eq!(seen(-2.0, 1.5), [Finding::MirroredView { view: name("front") }]);
    assert_eq!(seen(2.0, 1.0), [Finding::PixelsNotSquare { view: name("front"), ratio: 1.5 }]);
    assert_eq!(seen(2.0, 3.0), [Finding::PixelsNotSquare { view: name("front"), ratio: 0.5 }]);
}

#[test]
fn depths_that_show_no_reflection() {
    let depth = |world: u32, own: Option<u32>| {
        let mut scene = ordinary();
        scene.world.depth = world;
        found(&scene, View { depth: own, ..front() })
    };
    let too_small = |view: Option<&str>, depth| Finding::DepthTooSmall {
        view: view.map(Name::from),
        depth,
        enough: 2,
        object: name("glass ball"),
        bounce: Bounce::Transparency,
    };
    assert_eq!(depth(2, None), []);
    assert_eq!(depth(1, None), [too_small(None, 1)]);
    assert_eq!(depth(0, None), [too_small(None, 0)]);
    assert_eq!(depth(6, Some(0)), [too_small(Some("front"), 0)]);
    assert_eq!(depth(0, Some(6)), []);
    // Where the step is left out, its depth does not matter.
    let mut shallow = ordinary();
    shallow.world.depth = 0;
    let steps = Steps { transparency: false, ..Steps::default() };
    let mirror = Finding::DepthTooSmall {
        view: None,
        depth: 0,
        enough: 1,
        object: name("mirror ball"),
        bounce: Bounce::Reflection,
    };
    assert_eq!(found(&shallow, View { steps, ..front() }), [mirror]);
    let steps = Steps { reflection: false, ..steps };
    assert_eq!(found(&shallow, View { steps, ..front() }), []);
}

#[test]
fn mirrors_that_face_each_other() {
    let corridor = |kr: f64, depth: u32| {
        let shiny = || Surface { kr: Rgb::splat(kr), ..Surface::default() };
        let mut scene = scene([
            of(shiny(), "left", wall(-4.0)),
            Object::new("ball", sphere(DVec3::ZERO, 0.5)),
            of(shiny(), "right", wall(4.0)),
        ]);
        scene.world.depth = depth;
        scene
    };
    let facing = |depth, enough| Finding::FacingMirrors {
        view: None,
        depth,
        enough,
        first: name("left"),
        second: name("right"),
    };
    // .9⁶ = .53 of the light is left; .9²⁹ < .05.
    assert_eq!(found(&corridor(0.9, 6), front()), [facing(6, 29)]);
    assert_eq!(blind(&corridor(1.0, 10)), [facing(10, 64)]);
    assert_eq!(found(&corridor(0.8, 6), front()), []);
    assert_eq!(found(&corridor(1.0, 64), front()), []);
    // Seen from outside they do not face each other.
    let aside = View { eye: at(8.0, 1.0, 6.0), ..front() };
    assert!(!found(&corridor(0.9, 6), aside).contains(&facing(6, 29)));
}

fn coincident(first: Object, second: Object) -> bool {
    let names = (first.name.clone(), second.name.clone());
    let found = lint(&scene([first, second]), &[]);
    let pairs: Vec<_> = found.iter().filter(|finding| matches!(finding, Finding::CoincidentFaces { .. })).collect();
    assert!(pairs.len() <= 1, "each pair is reported once: {pairs:?}");
    pairs.first().is_some_and(|pair| **pair == Finding::CoincidentFaces { first: names.0, second: names.1 })
}

#[test]
fn coincident_faces_of_equal_objects() {
    let tetrahedron = Arc::new(tetrahedron());
    let large = Arc::new(MeshGeometry {
        facets: tetrahedron.facets.iter().copied().cycle().take(10_000).collect(),
        ..MeshGeometry::clone(&tetrahedron)
    });
    for shape in [
        sphere(at(0.1, 0.2, 0.3), 0.7),
        level(0.3),
        cube(at(0.1, 0.2, 0.3), 0.7),
        Shape::Cube { center: at(0.1, 0.2, 0.3), edge: 0.7, rotation: at(10.0, 20.0, 30.0) },
        facet(DVec3::X, DVec3::Y, DVec3::Z),
        cone(at(0.1, 0.2, 0.3), 0.7, 0.2, true),
        cone(at(0.1, 0.2, 0.3), 0.0, 0.2, false),
        mesh(&tetrahedron, at(0.1, 0.2, 0.3), 0.7),
        mesh(&large, at(0.1, 0.2, 0.3), 0.7),
    ] {
        assert!(coincident(Object::new("a", shape.clone()), Object::new("b", shape.clone())), "{shape:?}");
        let hidden = Object { visible: false, ..Object::new("b", shape.clone()) };
        assert!(!coincident(Object::new("a", shape), hidden));
    }
    assert!(!coincident(Object::new("a", sphere(DVec3::ZERO, 1.0)), Object::new("b", sphere(DVec3::ZERO, 0.999))));
}

#[test]
fn coincident_faces_that_show() {
    let die = || Object::new("die", cube(DVec3::ZERO, 1.0));
    let on_top = |x: f64, y: f64| facet(at(x - 0.3, y, -0.2), at(x + 0.3, y, -0.2), at(x, y, 0.3));
    let sticker = |x, y| Object::new("sticker", on_top(x, y));
    assert!(coincident(die(), sticker(0.0, 0.5)));
    assert!(coincident(die(), sticker(0.7, 0.5)), "it overlaps the edge");
    assert!(!coincident(die(), sticker(0.8, 0.5)), "it only touches the edge");
    assert!(!coincident(die(), sticker(0.0, 0.500_001)), "it lies a hair above");
    assert!(coincident(Object::new("floor", level(0.0)), Object::new("carpet", on_top(5.0, 0.0))));
    assert!(coincident(Object::new("floor", level(0.0)), Object::new("water", level(0.0))));
    assert!(!coincident(Object::new("floor", level(0.0)), Object::new("ceiling", level(2.0))));
    // Two boxes whose sides are flush show both; the lower one's top is covered.
    assert!(coincident(die(), Object::new("shelf", cube(at(0.25, 0.0, 0.25), 0.5))));
    // Rotated and computed, the faces are equal only up to rounding.
    let turned = |center: DVec3| Shape::Cube { center, edge: 1.0, rotation: at(0.0, 45.0, 0.0) };
    let side = at(0.5_f64.sqrt(), 0.0, -(0.5_f64.sqrt()));
    assert!(coincident(of(glass(), "a", turned(DVec3::ZERO)), of(glass(), "b", turned(side))));
    // The corners of the first are in the second's plane, though neither overlaps the other.
    let triangle = |x: f64| facet(at(x, 0.0, 0.0), at(x + 1.0, 0.0, 0.0), at(x, 0.0, 1.0));
    let half = facet(at(1.0, 0.0, 1.0), at(1.0, 0.0, 0.0), at(0.0, 0.0, 1.0));
    assert!(!coincident(Object::new("a", triangle(0.0)), Object::new("b", half)), "two halves of a square");
    assert!(coincident(Object::new("a", triangle(0.0)), Object::new("b", triangle(0.5))));
}

#[test]
fn contacts_that_nobody_sees() {
    let die = |surface: Surface| of(surface, "die", cube(at(0.0, 0.5, 0.0), 1.0));
    let floor = || Object::new("floor", level(0.0));
    let grey = Surface::default;
    assert!(!coincident(floor(), die(grey())), "a die stands on the floor");
    assert!(coincident(floor(), die(glass())), "light passes where they touch");
    let tower = |surface: Surface| of(surface, "tower", cone(DVec3::ZERO, 0.5, 0.0, true));
    assert!(!coincident(floor(), tower(grey())), "a cone stands on the floor");
    assert!(coincident(floor(), tower(glass())), "light passes where they touch");
    assert!(!coincident(floor(), of(glass(), "tube", cone(DVec3::ZERO, 0.5, 0.0, false))), "it has no cap");
    let upper = Object::new("upper", cube(at(0.2, 1.5, 0.2), 1.0));
    assert!(!coincident(die(grey()), upper.clone()), "a die stands on a die");
    assert!(coincident(die(glass()), upper), "the contact is seen through the glass");
    // From below, the floor and the die's lower face are in one place.
    let stage = scene([floor(), die(grey())]);
    let below = found(&stage, from(at(0.0, -1.0, 6.0)));
    let both = Finding::CoincidentFaces { first: name("floor"), second: name("die") };
    assert!(below.contains(&both), "{below:?}");
    assert_eq!(found(&stage, front()), []);
}

/// Ten thousand dice on one floor, side by side: 60 001 faces in 203 planes.
#[test]
fn a_field_of_dice_is_looked_at() {
    let dice = (0..10_000).map(|number| {
        let (x, z) = (f64::from(number % 100), f64::from(number / 100));
        Object::new(format!("die {number}"), cube(at(x, 0.5, z), 1.0))
    });
    let field = scene(dice.chain([Object::new("floor", level(0.0))]));
    // all pairs of their facets would be seven thousand million
    let found = lint(&field, &[]);
    // Their tops are flush, but touch along edges only; their sides touch, but are hidden.
    assert_eq!(found, []);
}

/// Everything in one place: the effort is bounded, and so is what is said.
#[test]
fn a_hostile_scene_is_given_up() {
    let same = (0..20_000).map(|number| Object::new(format!("{number}"), facet(DVec3::X, DVec3::Y, DVec3::Z)));
    let found = lint(&scene(same), &[]);
    assert_eq!(found.len(), 100);
    let large = Arc::new(MeshGeometry {
        facets: tetrahedron().facets.iter().copied().cycle().take(1_000_000).collect(),
        ..tetrahedron()
    });
    let many = (0..1000).map(|number| Object::new(format!("{number}"), mesh(&large, DVec3::ZERO, 1.0)));
    let lamps = (0..1000).map(|number| PointLight::new(format!("lamp {number}"), DVec3::splat(0.1)));
    let hostile = Scene { lights: lamps.collect(), ..scene(many) };
    // a thousand lamps in a thousand meshes of a million facets: without a bound, this would take days
    lint(&hostile, &views([front()]));
}

#[test]
fn glass_without_thickness() {
    let mut open = tetrahedron();
    open.facets.pop();
    let (open, closed) = (Arc::new(open), Arc::new(tetrahedron()));
    let pane = || facet(DVec3::X, DVec3::Y, DVec3::Z);
    assert_eq!(
        blind(&scene([of(glass(), "open", mesh(&open, DVec3::ZERO, 1.0))])),
        [Finding::OpenGlass { object: name("open") }]
    );
    assert_eq!(blind(&scene([of(glass(), "closed", mesh(&closed, DVec3::ZERO, 1.0))])), []);
    assert_eq!(blind(&scene([Object::new("opaque", mesh(&open, DVec3::ZERO, 1.0))])), []);
    let tube = |capped| cone(at(0.0, 0.5, 0.0), 1.0, 0.5, capped);
    assert_eq!(blind(&scene([of(glass(), "tube", tube(false))])), [Finding::SheetGlass { object: name("tube") }]);
    assert_eq!(blind(&scene([of(glass(), "rod", tube(true))])), []);
    assert_eq!(blind(&scene([of(glass(), "pane", pane())])), [Finding::SheetGlass { object: name("pane") }]);
    let thin = Surface { index: Rgb::WHITE, ..glass() };
    assert_eq!(blind(&scene([of(thin, "pane", pane())])), []);
}

#[test]
fn parts_that_cover_a_mesh_decide_what_it_is() {
    let open = |count| {
        let mut geometry = tetrahedron();
        geometry.facets.pop();
        geometry.parts = vec![Part { material: MaterialRef::Default, first: 0, count }];
        Arc::new(geometry)
    };
    let covered = scene([of(glass(), "open", mesh(&open(3), DVec3::ZERO, 1.0))]);
    assert_eq!(blind(&covered), []);
    let half = scene([of(glass(), "open", mesh(&open(2), DVec3::ZERO, 1.0))]);
    assert_eq!(blind(&half), [Finding::OpenGlass { object: name("open") }]);
}

#[test]
fn a_mesh_without_facets() {
    let empty = Arc::new(MeshGeometry::default());
    assert_eq!(
        blind(&scene([Object::new("nothing", mesh(&empty, DVec3::ZERO, 1.0))])),
        [Finding::EmptyMesh { object: name("nothing") }]
    );
}

#[test]
fn materials_that_are_odd() {
    let material = |name: &str, surface| Material { name: name.into(), surface };
    let with = |surface: Surface, ambient: f64| {
        let ball =
            Object { material: MaterialRef::Named("paint".into()), ..Object::new("ball", sphere(DVec3::ZERO, 1.0)) };
        let mut scene = scene([ball]);
        scene.materials = [material("paint", surface)].into_iter().collect();
        scene.world.ambient = Rgb::splat(ambient);
        scene
    };
    let owner = || Owner::Material(name("paint"));

    let thin = Surface { index: Rgb::new(1.0, 1.0, 0.9), ..glass() };
    assert_eq!(blind(&with(thin.clone(), 0.2)), [Finding::IndexBelowOne { owner: owner(), index: 0.9 }]);
    assert_eq!(blind(&with(Surface { kt: Rgb::BLACK, ..thin }, 0.2)), [], "an opaque surface has no index");
    let mut world = with(glass(), 0.2);
    world.world.index = Rgb::splat(0.5);
    assert_eq!(blind(&world), [Finding::WorldIndexBelowOne { index: 0.5 }]);
    world.objects = [Object::new("ball", sphere(DVec3::ZERO, 1.0))].into_iter().collect();
    assert_eq!(blind(&world), [Finding::UnusedMaterial { material: name("paint") }]);

    let white = Surface { ka: Rgb::WHITE, ..Surface::default() };
    assert_eq!(blind(&with(white.clone(), 1.0)), [Finding::AlwaysWhite { owner: owner() }]);
    assert_eq!(blind(&with(white.clone(), 0.99)), []);
    assert_eq!(blind(&with(Surface { ka: Rgb::new(1.0, 1.0, 0.9), ..white.clone() }, 1.0)), []);
    let mut inline = with(Surface::default(), 1.0);
    inline.objects = inline.objects.with(|objects| {
        objects.push(Arc::new(of(white, "lampshade", sphere(at(3.0, 0.0, 0.0), 1.0))));
    });
    assert_eq!(blind(&inline), [Finding::AlwaysWhite { owner: Owner::Object(name("lampshade")) }]);
}

/// A material is used by a hidden object and by a part, too.
#[test]
fn materials_that_are_used() {
    let paints = ["a", "b", "c"].map(|name| Material { name: name.into(), surface: Surface::default() });
    let mut geometry = tetrahedron();
    geometry.parts = vec![Part { material: MaterialRef::Named("b".into()), first: 0, count: 1 }];
    let hidden = Object {
        visible: false,
        material: MaterialRef::Named("a".into()),
        ..Object::new("hidden", sphere(DVec3::ZERO, 1.0))
    };
    let stage = scene([hidden, Object::new("pyramid", mesh(&Arc::new(geometry), DVec3::ZERO, 1.0))]);
    let stage = Scene { materials: paints.into_iter().collect(), ..stage };
    assert_eq!(blind(&stage), [Finding::UnusedMaterial { material: name("c") }]);
}
