//! Laws of the whole recursion with values that do not come from this program.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod common;

use common::{black, cone, glass, object, open, pixel, plane, scene, sphere, surface};
use lancer_scene::{
    Color, Compose, DVec3, Environment, List, Material, MaterialRef, Mesh, MeshGeometry, Object, Placement, PointLight,
    Rgb, Scene, Shape, Steps, Surface, View,
};
use lancer_trace::observe::{LampLight, Omitted, Term};
use lancer_trace::{Camera, Cancel, Engine, RayCounts, RayKind, Settings, Simd, TraceError, Tracer, World};
use std::sync::Arc;

/// Two facing mirrors of own colour `a` and coefficient `k`: after `d` bounces `c = a ⊕ k·c'`, in the end
/// `a/(1-(1-a)k)`.
#[test]
fn two_facing_mirrors_at_every_depth() {
    let (a, k) = (0.4, 0.5);
    let mirror = Surface { ka: Rgb::splat(a), kr: Rgb::splat(k), ..black() };
    let mirrors = |depth| {
        scene(
            vec![
                plane("back", DVec3::ZERO, DVec3::Z, mirror.clone()),
                plane("front", DVec3::Z, DVec3::NEG_Z, mirror.clone()),
            ],
            Environment { ambient: Rgb::WHITE, depth, ..Environment::default() },
        )
    };
    let view = pixel(DVec3::new(0.0, 0.0, 0.5), DVec3::ZERO);
    let mut expected = a;
    for depth in 0..=64 {
        let tree = open(&mirrors(depth), &view);
        assert_eq!(tree.samples[0].tree.nodes.len(), depth as usize + 1);
        assert!((tree.color.r - expected).abs() < 1e-14, "depth {depth}: {} {expected}", tree.color.r);
        expected = a + k * expected * (1.0 - a);
    }
    assert!((expected - 0.571_428_6).abs() < 1e-7);
}

/// 65 levels with both kinds of rays fit on a small stack.
#[test]
fn depth_64_does_not_overflow_the_stack() {
    let glass = Surface { kr: Rgb::splat(0.5), kt: Rgb::splat(0.5), index: Rgb::splat(1.5), ..black() };
    let scene = scene(
        vec![sphere("ball", DVec3::ZERO, 1.0, glass)],
        Environment { depth: 64, background: Rgb::WHITE, ..Environment::default() },
    );
    let deep = move || {
        let world = World::compile(&scene);
        let camera = Camera::new(&pixel(DVec3::new(0.3, 0.2, -4.0), DVec3::new(0.3, 0.2, 0.0))).unwrap();
        let settings = Settings { depth: 64, steps: Steps::default(), max_rays: 100_000 };
        let cancel = Cancel::default();
        let mut counts = RayCounts::default();
        let seen = Tracer::new(&world, &camera, settings, &cancel).pixel(0, 0, &mut counts);
        (seen, counts)
    };
    let (seen, counts) = std::thread::Builder::new().stack_size(256 << 10).spawn(deep).unwrap().join().unwrap();
    assert!(seen.unwrap().is_finite());
    assert_eq!(counts.reflected, 64, "one mirrored ray a level, the refracted ones leave: {counts:?}");
}

/// A budget ends what would never end, and says so.
#[test]
fn facing_glass_and_mirrors_end_at_the_budget() {
    let pane = Surface { kr: Rgb::splat(0.5), kt: Rgb::splat(0.5), ..black() };
    let facet = |z: f64| Shape::Facet {
        p0: DVec3::new(-9.0, -9.0, z),
        p1: DVec3::new(9.0, -9.0, z),
        p2: DVec3::new(0.0, 9.0, z),
    };
    let panes = (0..8).map(|n| object(&format!("pane {n}"), facet(f64::from(n)), pane.clone())).collect();
    let scene = scene(panes, Environment { depth: 64, ..Environment::default() });
    let world = World::compile(&scene);
    let view = pixel(DVec3::new(0.1, 0.2, -4.0), DVec3::new(0.1, 0.2, 0.0));
    let camera = Camera::new(&view).unwrap();
    let settings = Settings { max_rays: 5000, ..Settings::of(&world, &view) };
    let cancel = Cancel::default();
    let tracer = Tracer::new(&world, &camera, settings, &cancel);
    assert_eq!(tracer.pixel(0, 0, &mut ()), Err(TraceError::Budget { limit: 5000 }));
    cancel.cancel();
    assert_eq!(tracer.pixel(0, 0, &mut ()), Err(TraceError::Cancelled), "polled inside a pixel");
}

/// What tracer and engine say of the one pixel of a view, which may cost so many rays.
fn colors(scene: &Scene, view: &View, max_rays: u64) -> Vec<Result<Color, TraceError>> {
    let world = World::compile(scene);
    let (camera, cancel) = (Camera::new(view).unwrap(), Cancel::default());
    let settings = Settings { max_rays, ..Settings::of(&world, view) };
    let mut said = Vec::new();
    for simd in Simd::ALL.into_iter().filter(|simd| simd.is_available()) {
        let mut colors = Vec::new();
        Engine::new(&world, &camera, settings, &cancel, simd).pixels(&[(0, 0)], &mut colors, &mut RayCounts::default());
        said.extend(colors);
    }
    said.push(Tracer::new(&world, &camera, settings, &cancel).pixel(0, 0, &mut ()));
    said
}

/// Rays of every kind count, in all samples together: here a primary, a shadow and a mirrored ray for each of four.
#[test]
fn the_budget_is_exact() {
    let floor = Surface { ka: Rgb::splat(0.5), kr: Rgb::splat(0.5), ..black() };
    let mut scene = scene(vec![plane("floor", DVec3::ZERO, DVec3::Y, floor)], Environment::default());
    scene.lights = [PointLight::new("lamp", DVec3::Y * 2.0)].into_iter().collect::<List<PointLight>>();
    let view = View { samples: 2, ..pixel(DVec3::Y * 4.0, DVec3::ZERO) };
    let near = |color: &Result<Color, TraceError>| color.is_ok_and(|color| (color.r - 0.1).abs() < 1e-12);
    assert!(colors(&scene, &view, 12).iter().all(near), "{:?}", colors(&scene, &view, 12));
    for limit in [0, 1, 2, 3, 11] {
        assert!(colors(&scene, &view, limit).iter().all(|said| *said == Err(TraceError::Budget { limit })), "{limit}");
    }
}

/// A scene that nobody checked: what is not a number is an error of its pixel, and never a colour.
#[test]
fn a_colour_that_is_no_number_is_an_error() {
    let objects = vec![plane("floor", DVec3::ZERO, DVec3::Y, Surface::default())];
    let scene = scene(objects, Environment { ambient: Rgb::new(0.1, f64::NAN, 0.1), ..Environment::default() });
    let said = colors(&scene, &pixel(DVec3::Y * 4.0, DVec3::ZERO), 100);
    assert!(said.iter().all(|said| *said == Err(TraceError::NotFinite)), "{said:?}");
}

/// A ray carries the channels that its term needs and no others: a red mirror and a blue one show nothing of each other.
#[test]
fn a_mirrored_ray_carries_the_channels_that_are_mirrored() {
    let own = |kr: Rgb| Surface { ka: Rgb::splat(0.5), kr, ..black() };
    let objects = vec![
        plane("red", DVec3::ZERO, DVec3::Z, own(Rgb::new(0.5, 0.0, 0.0))),
        plane("blue", DVec3::Z, DVec3::NEG_Z, own(Rgb::new(0.0, 0.0, 0.5))),
    ];
    let environment = Environment { ambient: Rgb::WHITE, ..Environment::default() };
    let tree = open(&scene(objects, environment), &pixel(DVec3::Z * 0.5, DVec3::ZERO));
    let nodes = &tree.samples[0].tree.nodes;
    assert_eq!(nodes.len(), 2);
    assert_eq!(nodes[1].channels.iter().collect::<Vec<_>>(), [0]);
    assert_eq!(nodes[1].color, Rgb::new(0.5, 0.0, 0.0));
    // .5 ⊕ .5·.5
    assert_eq!(tree.color, Rgb::new(0.625, 0.5, 0.5));
}

/// A point is recomputed from its primitive: it lies on it to the last digits, however far it was seen from.
#[test]
fn a_point_lies_on_its_primitive() {
    let normal = DVec3::new(0.31, 0.93, 0.17).normalize();
    for step in 0..50 {
        let (eye, step) = (DVec3::new(0.3, 1.234e6, 0.7e6), f64::from(step));
        let tree = open(
            &scene(vec![plane("slope", DVec3::ZERO, normal, black())], Environment::default()),
            &pixel(eye, DVec3::new(0.031 * step, 0.0, 0.17 - 0.01 * step)),
        );
        let point = surface(&tree.samples[0].tree.nodes[0]).point;
        assert!(normal.dot(point).abs() < 1e-15, "{point}: {}", normal.dot(point));
    }
}

/// Beyond the critical angle `It` is what is seen along `R`, by one ray, though `Kr = 0`.
#[test]
fn total_reflection_casts_one_ray_along_r() {
    // the eye is in glass below the plane y = 0 and looks up at 60° from the normal: critical angle 41.8°
    let glass_sea = plane("sea", DVec3::ZERO, DVec3::Y, glass(1.5));
    let view = pixel(DVec3::new(0.0, -1.0, 0.0), DVec3::new(3.0_f64.sqrt(), 0.0, 0.0));
    let environment = Environment { background: Rgb::splat(0.5), ..Environment::default() };
    for steps in [Steps::default(), Steps { reflection: false, ..Steps::default() }] {
        for kr in [0.0, 0.5] {
            let mut surface = glass(1.5);
            surface.kr = Rgb::splat(kr);
            let sea = Object { material: MaterialRef::Inline(Arc::new(surface)), ..glass_sea.clone() };
            let tree = open(&scene(vec![sea], environment.clone()), &View { steps, ..view.clone() });
            let nodes = &tree.samples[0].tree.nodes;
            assert_eq!(nodes.len(), 2);
            assert_eq!(nodes[0].media, ["sea".into()], "the eye starts in the glass");
            assert_eq!(nodes[1].kind, RayKind::Reflected);
            assert_eq!(nodes[1].media, ["sea".into()], "a mirrored ray keeps the stack");
            let mirrored = if steps.reflection { kr * 0.5 } else { 0.0 };
            let expected = mirrored + 0.5 * (1.0 - mirrored);
            assert!((tree.color.r - expected).abs() < 1e-15);
        }
    }
}

/// A sheet passes the ray straight on and leaves the stack alone; a closed mesh refracts.
#[test]
fn a_sheet_has_no_thickness() {
    let positions = vec![DVec3::new(-9.0, 0.0, -9.0), DVec3::new(9.0, 0.0, -9.0), DVec3::new(0.0, 0.0, 9.0)];
    let geometry = Arc::new(MeshGeometry { positions, facets: vec![[0, 1, 2]], ..MeshGeometry::default() });
    let sheet = Shape::Mesh(Mesh { geometry, source: None, placement: Placement::default(), smooth: false });
    let floor = Surface { ka: Rgb::splat(0.5), ..black() };
    let scene = scene(
        vec![object("sheet", sheet, glass(1.5)), plane("floor", DVec3::NEG_Y, DVec3::Y, floor)],
        Environment { ambient: Rgb::WHITE, ..Environment::default() },
    );
    let tree = open(&scene, &pixel(DVec3::new(0.0, 1.0, 0.0), DVec3::new(0.5, 0.0, 0.25)));
    let nodes = &tree.samples[0].tree.nodes;
    assert_eq!(nodes.len(), 2);
    assert!(surface(&nodes[0]).sheet);
    assert!((nodes[0].ray.direction - nodes[1].ray.direction).length() < 1e-15);
    assert_eq!(nodes[1].index, Rgb::WHITE);
    assert_eq!(tree.color, Rgb::splat(0.5));
}

/// A lamp overhead, beside, behind an object, behind the surface, and at the point itself.
#[test]
fn lamps_light_or_do_not() {
    let floor = Surface { kd: Rgb::splat(0.5), ..black() };
    let lamp = |name: &str, at: DVec3| PointLight::new(name, at);
    let mut scene = scene(
        vec![
            plane("floor", DVec3::ZERO, DVec3::Y, floor),
            sphere("O2", DVec3::new(3.0, 3.0, 0.0), 0.5, black()),
            Object { visible: false, ..sphere("ghost", DVec3::Y, 0.5, black()) },
        ],
        Environment::default(),
    );
    scene.lights = [
        lamp("overhead", DVec3::Y * 2.0),
        lamp("aslant", DVec3::new(-1.0, 1.0, 0.0)),
        lamp("blocked", DVec3::new(6.0, 6.0, 0.0)),
        lamp("before the object", DVec3::new(1.0, 1.0, 0.0)),
        lamp("below", DVec3::NEG_Y),
        lamp("here", DVec3::ZERO),
        PointLight { visible: false, ..lamp("off", DVec3::Y) },
    ]
    .into_iter()
    .collect::<List<PointLight>>();
    let tree = open(&scene, &pixel(DVec3::Y * 4.0, DVec3::ZERO));
    let terms = &surface(&tree.samples[0].tree.nodes[0]).terms;
    let states: Vec<String> = terms
        .iter()
        .filter_map(|composed| match &composed.term {
            Term::Lamp { name, light, .. } => Some(match light {
                LampLight::Lit(lit) => format!("{name}: {:.6}", lit.diffuse.r),
                LampLight::Behind { .. } => format!("{name}: behind"),
                LampLight::Blocked { by, .. } => format!("{name}: blocked by {by}"),
                LampLight::AtPoint => format!("{name}: at the point"),
            }),
            Term::Ambient { .. } | Term::Mirror(_) | Term::Glass(_) => None,
        })
        .collect();
    let slanting = 0.5 * 0.5_f64.sqrt();
    assert_eq!(
        states,
        [
            "overhead: 0.500000".to_owned(),
            format!("aslant: {slanting:.6}"),
            "blocked: blocked by O2".to_owned(),
            format!("before the object: {slanting:.6}"),
            "below: behind".to_owned(),
            "here: at the point".to_owned(),
        ]
    );
    let expected = [0.5, slanting, slanting].into_iter().fold(0.0, |sum, term| sum + term * (1.0 - sum));
    assert!((tree.color.r - expected).abs() < 1e-15);
}

/// The terms say why they are 0.
#[test]
fn omitted_terms_have_a_reason() {
    let both = Surface { kr: Rgb::splat(0.5), ..glass(1.5) };
    let reasons = |steps: Steps, depth: u32, surface: Surface| {
        let scene =
            scene(vec![sphere("ball", DVec3::ZERO, 1.0, surface)], Environment { depth, ..Environment::default() });
        let tree = open(&scene, &View { steps, ..pixel(DVec3::Z * 4.0, DVec3::ZERO) });
        let node = &tree.samples[0].tree.nodes[0];
        let mut reasons = (None, None);
        for composed in &self::surface(node).terms {
            match &composed.term {
                Term::Mirror(mirror) => reasons.0 = mirror.omitted,
                Term::Glass(glass) => reasons.1 = glass.omitted,
                Term::Ambient { .. } | Term::Lamp { .. } => {}
            }
        }
        reasons
    };
    let all = Steps::default();
    assert_eq!(reasons(all, 1, both.clone()), (None, None));
    assert_eq!(reasons(all, 0, both.clone()), (Some(Omitted::DepthReached), Some(Omitted::DepthReached)));
    assert_eq!(reasons(all, 1, black()), (Some(Omitted::NoCoefficient), Some(Omitted::NoCoefficient)));
    let none = Steps { reflection: false, transparency: false, ..all };
    assert_eq!(reasons(none, 1, both), (Some(Omitted::StepLeftOut), Some(Omitted::StepLeftOut)));
}

/// Equal distances: document order, then facet order.
#[test]
fn the_first_in_the_document_wins_a_tie() {
    let own = |value: f64| Surface { ka: Rgb::splat(value), ..black() };
    let facet = |dx: f64| Shape::Facet {
        p0: DVec3::new(-1.0 + dx, -1.0, 0.0),
        p1: DVec3::new(1.0 + dx, -1.0, 0.0),
        p2: DVec3::new(dx, 1.0, 0.0),
    };
    let view = pixel(DVec3::Z * 4.0, DVec3::ZERO);
    let white = Environment { ambient: Rgb::WHITE, ..Environment::default() };
    for (first, second) in [(0.25, 0.75), (0.75, 0.25)] {
        let objects = vec![
            object("one", facet(0.0), own(first)),
            object("two", facet(0.125), own(second)),
            plane("three", DVec3::ZERO, DVec3::Z, own(1.0)),
        ];
        assert_eq!(open(&scene(objects, white.clone()), &view).color, Rgb::splat(first));
    }
}

/// Hits between the eye and the screen are seen too, and several samples are averaged.
#[test]
fn the_screen_hides_nothing_and_samples_are_a_mean() {
    let white = Environment { ambient: Rgb::WHITE, ..Environment::default() };
    let near = sphere("near", DVec3::Z * 3.5, 0.1, Surface { ka: Rgb::splat(0.5), ..black() });
    let view = pixel(DVec3::Z * 4.0, DVec3::ZERO);
    assert_eq!(open(&scene(vec![near], white.clone()), &view).color, Rgb::splat(0.5));

    // a half-plane of facets covers the left half of the picture: two of four samples
    let left = Shape::Facet {
        p0: DVec3::new(0.0, -50.0, 0.0),
        p1: DVec3::new(0.0, 50.0, 0.0),
        p2: DVec3::new(-50.0, 0.0, 0.0),
    };
    let half = object("half", left, Surface { ka: Rgb::WHITE, ..black() });
    let tree = open(&scene(vec![half], white), &View { samples: 2, ..view });
    assert_eq!(tree.samples.len(), 4);
    assert_eq!(tree.color, Rgb::splat(0.5));
}

/// `add` is a plain sum clamped once; `screen-each` composes a lamp's two parts apart.
#[test]
fn the_three_compositions_of_one_point() {
    let surface = Surface {
        ka: Rgb::splat(0.25),
        kd: Rgb::splat(0.5),
        ks: Rgb::splat(0.5),
        shininess: Rgb::splat(1.0),
        ..Surface::default()
    };
    let color = |compose: Compose| -> Color {
        let mut scene = scene(
            vec![plane("floor", DVec3::ZERO, DVec3::Y, surface.clone())],
            Environment { ambient: Rgb::splat(0.5), compose, ..Environment::default() },
        );
        scene.lights = [PointLight::new("lamp", DVec3::Y * 2.0)].into_iter().collect::<List<PointLight>>();
        // straight from above: cos l = cos s = 1
        open(&scene, &pixel(DVec3::Y * 4.0, DVec3::ZERO)).color
    };
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
    near(color(Compose::Screen).r, 1.0);
    near(color(Compose::ScreenEach).r, 1.0 - 0.875 * 0.5 * 0.5);
    near(color(Compose::Add).r, 1.0);
}

/// Named materials, parts of a mesh with their own, and the built-in grey.
#[test]
fn parts_have_their_own_materials() {
    let positions = [-1.0, 1.0]
        .into_iter()
        .flat_map(|x| [(x - 1.0, -1.0), (x + 1.0, -1.0), (x, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0)))
        .collect();
    let part = lancer_scene::Part { material: MaterialRef::Named("red".into()), first: 1, count: 1 };
    let geometry =
        MeshGeometry { positions, facets: vec![[0, 1, 2], [3, 4, 5]], parts: vec![part], ..Default::default() };
    let mesh = Mesh { geometry: Arc::new(geometry), source: None, placement: Placement::default(), smooth: false };
    let mut scene = scene(
        vec![Object::new("two", Shape::Mesh(mesh))],
        Environment { ambient: Rgb::WHITE, ..Environment::default() },
    );
    let red = Surface { ka: Rgb::new(1.0, 0.0, 0.0), ..black() };
    scene.materials = [Material { name: "red".into(), surface: red }].into_iter().collect::<List<Material>>();
    let at = |x: f64| open(&scene, &pixel(DVec3::new(x, 0.0, 9.0), DVec3::new(x, 0.0, 0.0))).color;
    assert_eq!(at(-1.0), Rgb::splat(0.2));
    assert_eq!(at(1.0), Rgb::new(1.0, 0.0, 0.0));
}

/// A lamp that lies on a surface is hidden neither by that surface nor by rounding, and does not light it.
#[test]
fn a_lamp_on_a_surface_lights_everything_else() {
    let floor = Surface { kd: Rgb::splat(0.5), ..black() };
    let gloss = Surface { ks: Rgb::WHITE, shininess: Rgb::BLACK, ..black() };
    let lamp = DVec3::new(0.3, 2.1, -0.7);
    let slanting = DVec3::new(0.31, -0.93, 0.17).normalize();
    let (u, v) = slanting.any_orthonormal_pair();
    let facet = Shape::Facet { p0: lamp - u - v, p1: lamp + 2.0 * u - v, p2: lamp - u + 2.0 * v };
    let carriers = [
        plane("ceiling", lamp, slanting, gloss.clone()),
        object("tile", facet, gloss.clone()),
        sphere("globe", lamp - slanting * 0.8, 0.8, gloss.clone()),
        object("case", Shape::Cube { center: lamp + DVec3::Y * 0.5, edge: 1.0, rotation: DVec3::ZERO }, gloss.clone()),
        object("funnel", cone([lamp, lamp - slanting], [0.7, 0.9], true), gloss.clone()),
        object("tube", cone([lamp - slanting * 0.8 - u, lamp - slanting * 0.8 + u], [0.8, 0.8], false), gloss.clone()),
        object("roll", cone([lamp - slanting * 0.8 - u, lamp - slanting * 0.8 + u], [0.8, 0.8], true), gloss),
    ];
    for carrier in carriers {
        let name = carrier.name.clone();
        let objects = vec![plane("floor", DVec3::ZERO, DVec3::Y, floor.clone()), carrier];
        let mut scene = scene(objects, Environment::default());
        scene.lights = [PointLight::new("lamp", lamp)].into_iter().collect::<List<PointLight>>();
        let seen = |eye, target| open(&scene, &pixel(eye, target)).color.r;
        for step in 0..400 {
            let place = DVec3::new(f64::from(step % 20) * 0.17 - 1.6, 0.0, f64::from(step / 20) * 0.17 - 1.6);
            let cosine = (lamp - place).normalize().y;
            let color = seen(place + DVec3::new(0.0, 0.1, 0.0), place);
            assert!((color - 0.5 * cosine).abs() < 1e-12, "{name}: the floor at {place} is {color}");
            // up to the carrier: the lamp stands in its own surface, or behind what is seen of it
            let up = place + DVec3::new(0.0, 0.01, 0.0);
            let color = seen(up, lamp + DVec3::new(f64::from(step % 7) * 0.03, 0.0, f64::from(step % 11) * 0.02));
            assert_eq!(color, 0.0, "{name}: from {up}");
        }
    }
}
