//! Laws of the media that a ray travels in: the stack, nested glass, an eye inside of things, dispersion.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that fails says so by panicking")]

mod common;

use common::{black, cone, crossings, glass, object, open, pixel, plane, scene, sphere};
use lancer_scene::{DVec3, Environment, MaterialRef, Mesh, MeshGeometry, Part, Placement, Rgb, Shape, Surface};
use lancer_trace::{Channels, PixelTree};
use std::sync::Arc;

/// The Ray Tracer Challenge (J. Buck), chapter 11: two overlapping spheres within a third.
#[test]
fn nested_glass_has_these_pairs_of_indices() {
    let scene = scene(
        vec![
            sphere("A", DVec3::ZERO, 2.0, glass(1.5)),
            sphere("B", DVec3::new(0.0, 0.0, -0.25), 1.0, glass(2.0)),
            sphere("C", DVec3::new(0.0, 0.0, 0.25), 1.0, glass(2.5)),
        ],
        Environment { background: Rgb::splat(0.75), ..Environment::default() },
    );
    let tree = open(&scene, &pixel(DVec3::new(0.0, 0.0, -4.0), DVec3::ZERO));
    let expected = [(1.0, 1.5), (1.5, 2.0), (2.0, 2.5), (2.5, 2.5), (2.5, 1.5), (1.5, 1.0)];
    assert_eq!(crossings(&tree), expected);
    // clear glass all the way: the background is seen (the ambient terms are 0)
    assert_eq!(tree.color, Rgb::splat(0.75));
}

/// Channels with equal `n/n'` share a ray; the others get their own, which carries them alone.
#[test]
fn dispersion_splits_the_channels() {
    let ball = |index: Rgb| {
        let surface = Surface { index, ..glass(1.0) };
        let scene = scene(
            vec![sphere("ball", DVec3::ZERO, 1.0, surface)],
            Environment { depth: 1, background: Rgb::WHITE, ..Environment::default() },
        );
        open(&scene, &pixel(DVec3::new(0.5, 0.0, -4.0), DVec3::new(0.5, 0.0, 0.0)))
    };
    let channels = |tree: &PixelTree| -> Vec<Channels> {
        tree.samples[0].tree.nodes.iter().skip(1).map(|node| node.channels).collect()
    };
    let set = |channels: &[usize]| channels.iter().copied().collect::<Channels>();
    assert_eq!(channels(&ball(Rgb::splat(1.5))), [Channels::ALL]);
    assert_eq!(channels(&ball(Rgb::new(1.5, 1.6, 1.5))), [set(&[0, 2]), set(&[1])]);
    let split = ball(Rgb::new(1.4, 1.5, 1.6));
    assert_eq!(channels(&split), [set(&[0]), set(&[1]), set(&[2])]);
    // each computes its channel alone; the white background would be seen in all
    let colors: Vec<Rgb> = split.samples[0].tree.nodes.iter().skip(1).map(|node| node.color).collect();
    assert!(colors.iter().enumerate().all(|(own, color)| (0..3).all(|other| other == own || color[other] == 0.0)));
}

/// Not the indices but their ratio decides which channels go together: 1 → 1.5 and 2 → 3 are bent alike.
#[test]
fn channels_of_equal_ratio_share_a_ray() {
    let ball = sphere("ball", DVec3::ZERO, 1.0, Surface { index: Rgb::new(1.5, 3.0, 1.5), ..glass(1.0) });
    let environment = Environment { index: Rgb::new(1.0, 2.0, 1.0), ..Environment::default() };
    let tree = open(&scene(vec![ball], environment), &pixel(DVec3::new(0.5, 0.0, -4.0), DVec3::new(0.5, 0.0, 0.0)));
    let nodes = &tree.samples[0].tree.nodes;
    assert_eq!(nodes.iter().map(|node| node.channels).collect::<Vec<_>>(), [Channels::ALL; 3]);
    assert_eq!(nodes[1].index, Rgb::new(1.5, 3.0, 1.5));
}

/// The eye starts inside of planes first, then of what has the longer diagonal, then of what stands first.
#[test]
fn the_stack_of_an_eye_goes_from_the_outside_in() {
    let ball = |name: &str, x: f64, radius: f64| sphere(name, DVec3::X * x, radius, glass(1.5));
    let half_space = |name: &str, normal: DVec3| plane(name, normal * 9.0, normal, glass(1.5));
    let cube = Shape::Cube { center: DVec3::ZERO, edge: 3.0, rotation: DVec3::ZERO };
    let objects = vec![
        ball("small", 0.0, 1.0),
        ball("equal one", 0.1, 2.0),
        half_space("below", DVec3::Y),
        object("cube", cube, glass(1.5)),
        ball("large", 0.2, 3.0),
        ball("equal two", -0.1, 2.0),
        half_space("beside", DVec3::X),
        ball("elsewhere", 50.0, 1.0),
        // its normal points to the eye's side
        plane("in front", DVec3::NEG_Z * 9.0, DVec3::Z, glass(1.5)),
    ];
    let tree = open(&scene(objects, Environment::default()), &pixel(DVec3::ZERO, DVec3::NEG_X));
    let media: Vec<&str> = tree.samples[0].tree.nodes[0].media.iter().map(|name| &**name).collect();
    // the cube's diagonal is 3·√3 = 5.2, that of the box around a ball of radius r is 2r·√3
    assert_eq!(media, ["below", "beside", "large", "equal one", "equal two", "cube", "small"]);
}

/// A ray that leaves what it never entered keeps its stack: the eye is on B's surface, and so outside of it.
#[test]
fn leaving_what_is_not_there_changes_nothing() {
    let objects = vec![sphere("A", DVec3::ZERO, 5.0, glass(1.5)), sphere("B", DVec3::NEG_Z, 1.0, glass(2.0))];
    let tree = open(&scene(objects, Environment::default()), &pixel(DVec3::ZERO, DVec3::NEG_Z));
    assert_eq!(crossings(&tree), [(1.5, 1.5), (1.5, 1.0)]);
    assert_eq!(tree.samples[0].tree.nodes[1].media, ["A".into()]);
}

/// One channel of one part that lets light through makes the whole closed mesh a medium.
#[test]
fn one_transparent_channel_of_one_part_is_enough() {
    let corners = lancer_scene::box_facets(DVec3::NEG_ONE, [DVec3::X * 2.0, DVec3::Y * 2.0, DVec3::Z * 2.0]);
    let positions: Vec<DVec3> = corners.into_iter().flatten().collect();
    let facets: Vec<[u32; 3]> = (0..12).map(|facet| [3 * facet, 3 * facet + 1, 3 * facet + 2]).collect();
    let green = Surface { kt: Rgb::new(0.0, 1.0, 0.0), ..glass(1.5) };
    let front = |facet: usize| (0..3).all(|corner| positions[3 * facet + corner].z == 1.0);
    let parts = (0..12).filter(|facet| front(*facet)).map(|facet| Part {
        material: MaterialRef::Inline(Arc::new(green.clone())),
        first: facet as u32,
        count: 1,
    });
    let parts: Vec<Part> = parts.collect();
    assert_eq!(parts.len(), 2);
    let geometry = Arc::new(MeshGeometry { positions: positions.clone(), facets, parts, ..MeshGeometry::default() });
    let mesh = Shape::Mesh(Mesh { geometry, source: None, placement: Placement::default(), smooth: false });
    let case = scene(vec![object("case", mesh, black())], Environment::default());
    assert_eq!(crossings(&open(&case, &pixel(DVec3::new(0.1, 0.2, 9.0), DVec3::ZERO))), [(1.0, 1.5)]);
    let tree = open(&case, &pixel(DVec3::ZERO, DVec3::new(0.1, 0.2, 1.0)));
    assert_eq!(tree.samples[0].tree.nodes[0].media, ["case".into()]);
    assert_eq!(crossings(&tree), [(1.5, 1.0)]);
}

/// Leaving removes an object's last entry, wherever it stands: entered twice, it has to be left twice. Two shells of one
/// mesh, one within the other, are entered one after the other.
#[test]
fn an_object_that_is_entered_twice_is_left_twice() {
    let cube = |edge: f64| {
        let edges = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| axis * edge);
        lancer_scene::box_facets(DVec3::splat(-edge / 2.0), edges)
    };
    let corners: Vec<DVec3> = [cube(4.0), cube(2.0)].into_iter().flatten().flatten().collect();
    let facets = (0..corners.len() as u32 / 3).map(|facet| [3 * facet, 3 * facet + 1, 3 * facet + 2]).collect();
    let geometry = Arc::new(MeshGeometry { positions: corners, facets, ..MeshGeometry::default() });
    let shells = Shape::Mesh(Mesh { geometry, source: None, placement: Placement::default(), smooth: false });
    let objects = vec![object("shells", shells, glass(1.5)), sphere("ball", DVec3::ZERO, 1.5, glass(2.0))];
    let tree =
        open(&scene(objects, Environment::default()), &pixel(DVec3::new(0.1, 0.2, 9.0), DVec3::new(0.1, 0.2, 0.0)));
    let media: Vec<String> = tree.samples[0].tree.nodes.iter().map(|node| node.media.join(" ")).collect();
    let expected = [
        "",
        "shells",
        "shells ball",
        "shells ball shells",
        // out of the inner shell, within the ball
        "shells ball",
        "shells",
        "",
    ];
    assert_eq!(media, expected);
}

/// An eye on a surface is outside of what it encloses and does not see that surface: through glass without air around
/// it, the ray goes straight on.
#[test]
fn an_eye_on_a_surface_is_outside() {
    let glass = glass(1.5);
    let slanting = DVec3::new(0.31, -0.93, 0.17).normalize();
    let (u, v) = slanting.any_orthonormal_pair();
    let eye = DVec3::new(0.3, 2.1, -0.7);
    let ball = sphere("ball", eye + slanting * 0.83, 0.83, glass.clone());
    let half_space = plane("half-space", eye, -slanting, glass.clone());
    let origin = eye - u * 0.37 - v * 0.41;
    let slab = object("slab", Shape::Parallelepiped { origin, edges: [u, v, slanting] }, glass.clone());
    let peg = object("peg", cone([eye, eye + slanting], [0.7, 0.6], true), glass.clone());
    let middle = eye + slanting * 0.6;
    let roll = object("roll", cone([middle - u, middle + u * 2.0], [0.6, 0.6], true), glass);
    for body in [ball, half_space, slab, peg, roll] {
        let name = body.name.clone();
        let crossings_of_surfaces = usize::from(&*name != "half-space");
        let scene = scene(vec![body], Environment { background: Rgb::splat(0.75), ..Environment::default() });
        for step in 0..200 {
            let aside = u * (f64::from(step % 20) * 0.01 - 0.1) + v * (f64::from(step / 20) * 0.02 - 0.1);
            let tree = open(&scene, &pixel(eye, eye + slanting + aside));
            let nodes = &tree.samples[0].tree.nodes;
            assert_eq!(nodes[0].media.len(), 0, "{name} {step}");
            assert_eq!(nodes.len(), 1 + crossings_of_surfaces, "{name} {step}");
            assert!(nodes.iter().all(|node| (node.ray.direction - nodes[0].ray.direction).length() < 1e-15));
            assert_eq!(tree.color, Rgb::splat(0.75));
        }
    }
}

/// A capped cone is entered and left, through side and caps; an open one is a sheet, through which light goes straight
/// on, also out of the side that is seen from within.
#[test]
fn a_capped_cone_encloses_a_medium_and_an_open_one_does_not() {
    let ends = [DVec3::NEG_Y, DVec3::Y];
    for (eye, target) in [
        (DVec3::new(0.1, 9.0, 0.2), DVec3::new(0.2, 0.0, 0.1)),
        (DVec3::new(9.0, 0.1, 0.2), DVec3::new(0.0, 0.1, 0.1)),
        (DVec3::new(9.0, 9.0, 0.2), DVec3::new(0.0, 0.7, 0.1)),
    ] {
        for radii in [[1.0, 1.0], [1.5, 0.5], [1.0, 1.5]] {
            let solid = scene(vec![object("cone", cone(ends, radii, true), glass(1.5))], Environment::default());
            assert_eq!(crossings(&open(&solid, &pixel(eye, target))), [(1.0, 1.5), (1.5, 1.0)], "{eye} {radii:?}");
            let sheet = scene(vec![object("cone", cone(ends, radii, false), glass(1.5))], Environment::default());
            let tree = open(&sheet, &pixel(eye, target));
            let nodes = &tree.samples[0].tree.nodes;
            assert!(nodes.iter().all(|node| (node.ray.direction - nodes[0].ray.direction).length() < 1e-15));
            assert!(crossings(&tree).iter().all(|crossing| *crossing == (1.0, 1.0)));
        }
    }
    // an eye within a capped cone is in its medium, and within an open one in none
    let inside = |capped| {
        let scene = scene(vec![object("cone", cone(ends, [1.0, 0.5], capped), glass(1.5))], Environment::default());
        crossings(&open(&scene, &pixel(DVec3::new(0.1, 0.2, 0.0), DVec3::new(5.0, 0.3, 0.0))))
    };
    assert_eq!(inside(true), [(1.5, 1.0)]);
    assert_eq!(inside(false), [(1.0, 1.0)]);
}
