//! The Neutral File Format: what its entities become, what is said of broken files.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use lancer_formats::load::{LoadOptions, load_scene, load_views};
use lancer_formats::nff::{NffFile, is_nff, read};
use lancer_formats::{Describe, Severity};
use lancer_scene::{
    Compose, DVec3, Enclosure, Material, Mesh, MeshGeometry, Rgb, Scene, Screen, ScreenSpec, Shape, Surface, View,
};
use lancer_words::Lang;
use std::path::Path;

const VIEW: &str = "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 90\nhither 0.1\nresolution 5 3\n";

fn scene(text: &str) -> Scene {
    let NffFile { scene, .. } = read("test.nff", text.as_bytes());
    assert_eq!(scene.diagnostics, []);
    let scene = scene.value.unwrap();
    scene.check().unwrap();
    scene
}

fn view(text: &str) -> View {
    let NffFile { views, .. } = read("test.nff", text.as_bytes());
    assert_eq!(views.diagnostics, []);
    View::clone(views.value.unwrap().first().unwrap())
}

/// `line:column: message | label | help` of everything that is said of the scene, errors marked by `!`.
fn told(text: &str) -> Vec<String> {
    let file = read("test.nff", text.as_bytes());
    let told = |found: &lancer_formats::Diagnostic| {
        let place = found.span.map_or(String::new(), |span| {
            let (line, column) = file.source.position(span.start);
            format!("{line}:{column}: ")
        });
        let mark = if found.severity == Severity::Error { "!" } else { "" };
        let help = found.problem.help(Lang::English).unwrap_or_default();
        format!(
            "{mark}{place}{} | {} | {help}",
            found.problem.message(Lang::English),
            found.problem.label(Lang::English)
        )
    };
    assert_eq!(file.scene.value.is_none(), file.scene.diagnostics.iter().any(|d| d.severity == Severity::Error));
    for found in file.scene.diagnostics.iter().chain(&file.views.diagnostics) {
        let french = found.problem.message(Lang::French);
        assert!(!french.is_empty() && french != found.problem.message(Lang::English), "{french}");
        if let Some(span) = found.span {
            assert!(span.start <= span.end && file.source.text.get(span.start..span.end).is_some());
        }
    }
    file.scene.diagnostics.iter().map(told).collect()
}

fn mesh(shape: &Shape) -> &Mesh {
    let Shape::Mesh(mesh) = shape else { panic!("{shape:?}") };
    mesh
}

#[test]
fn every_entity_becomes_what_it_is() {
    let scene = scene(&format!(
        "# a comment\nb 0.1 0.2 0.3\n{VIEW}l 1 2 3\nl 4 5 6 1 0.5 0\nf 1 0.5 0 0.8 0.4 10 0.5 1.5\ns 1 2 3 0.5 # a ball\n\
         c\n0 0 0 2\n0 3 0 0\ns 0 0 0 1\nf 1 1 1 1 0 0 0 0\np 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\npp 3\n0 0 1 0 0 1\n1 0 1 0 0 1\n0 1 1 0 1 1\n\
         f 1 0.5 0 0.8 0.4 10 0.5 1.5\ns 9 9 9 1"
    ));
    assert_eq!(scene.world.background, Rgb::new(0.1, 0.2, 0.3));
    assert_eq!((scene.world.compose, scene.world.depth), (Compose::Add, 4));
    // √2/(2·2)
    let intensity = 2.0_f64.sqrt() / 4.0;
    assert!((scene.world.ambient.r - intensity).abs() < 1e-15 && scene.world.ambient.is_uniform());
    assert_eq!(scene.lights[0].color, scene.world.ambient);
    assert_eq!(scene.lights[1].color, Rgb::new(1.0, 0.5, 0.0));
    assert_eq!(scene.lights[1].position, DVec3::new(4.0, 5.0, 6.0));
    let glassy = Surface {
        ka: Rgb::new(0.8, 0.4, 0.0),
        kd: Rgb::new(0.8, 0.4, 0.0),
        ks: Rgb::splat(0.4),
        shininess: Rgb::splat(10.0),
        kr: Rgb::splat(0.4),
        kt: Rgb::splat(0.5),
        index: Rgb::splat(1.5),
        ..Surface::default()
    };
    let plain = Surface { ka: Rgb::WHITE, kd: Rgb::WHITE, shininess: Rgb::BLACK, ..Surface::default() };
    let materials: Vec<Material> = scene.materials.iter().map(|material| Material::clone(material)).collect();
    assert_eq!(
        materials,
        [Material { name: "fill 1".into(), surface: glassy }, Material { name: "fill 2".into(), surface: plain }]
    );
    let objects: Vec<_> =
        scene.objects.iter().map(|object| (&*object.name, object.material.name().unwrap().as_ref())).collect();
    assert_eq!(
        objects,
        [
            ("sphere 1", "fill 1"),
            ("cone 1", "fill 1"),
            ("sphere 2", "fill 1"),
            ("polygons 1", "fill 2"),
            ("patches 1", "fill 2"),
            ("sphere 3", "fill 1"),
        ]
    );
    assert_eq!(scene.objects[0].shape, Shape::Sphere { center: DVec3::new(1.0, 2.0, 3.0), radius: 0.5 });
    let cone = Shape::Cone { base: DVec3::ZERO, top: DVec3::Y * 3.0, base_radius: 2.0, top_radius: 0.0, capped: false };
    assert_eq!(scene.objects[1].shape, cone);
    assert_eq!(mesh(&scene.objects[3].shape).geometry.facets, [[0, 1, 2], [0, 2, 3]]);
    let patches = mesh(&scene.objects[4].shape);
    assert!(patches.smooth);
    assert_eq!(patches.geometry.normals[2], DVec3::new(0.0, 1.0, 1.0));
}

/// «from the center of top pixel row to bottom pixel row»: with three rows and 90° those centres are at -1, 0 and 1 on a
/// screen at distance 1, and the five columns, of square pixels, at -2 to 2.
#[test]
fn the_angle_reaches_from_the_first_row_to_the_last() {
    let view = view(VIEW);
    assert_eq!((view.width, view.height, view.eye), (5, 3, DVec3::new(0.0, 0.0, 5.0)));
    let Screen { origin, u, v } = view.resolved_screen().unwrap();
    let near = |a: DVec3, b: DVec3| assert!((a - b).length() < 1e-12, "{a} {b}");
    near(origin, DVec3::new(-2.5, 1.5, 4.0));
    near(u, DVec3::X * 5.0);
    near(v, DVec3::Y * -3.0);
    assert!(matches!(view.screen, ScreenSpec::Centered { .. }), "it can be edited by its middle");
    // one row has no last one: the angle is the pixel's
    let one = self::view(&VIEW.replace("5 3", "1 1")).resolved_screen().unwrap();
    near(one.v, DVec3::Y * -2.0);
}

/// A pyramid of separate polygons is closed once equal corners are one vertex; a polygon with a dent is cut inside it.
#[test]
fn polygons_under_one_fill_are_one_mesh() {
    let pyramid = "f 1 1 1 1 0 0 0.5 1.5\np 4\n0 0 0\n0 1 0\n1 1 0\n1 0 0\np 3\n0 0 0 1 0 0 .5 .5 1\np 3\n1 0 0 1 1 0 .5 .5 1\n\
                   p 3\n1 1 0 0 1 0 .5 .5 1\np 3\n0 1 0 0 0 -0 .5 .5 1\n";
    let solid = scene(pyramid);
    let geometry = &mesh(&solid.objects[0].shape).geometry;
    assert_eq!((geometry.positions.len(), geometry.facets.len()), (5, 6));
    assert_eq!(geometry.enclosure(), Enclosure::Volume { inverted: false });
    let dart = scene("p 4\n0 0 0\n4 2 0\n0 4 0\n1 2 0\n");
    let MeshGeometry { positions, facets, .. } = &*mesh(&dart.objects[0].shape).geometry;
    let area: f64 = facets
        .iter()
        .map(|facet| facet.map(|vertex| positions[vertex as usize]))
        .map(|[a, b, c]| (b - a).cross(c - a).z / 2.0)
        .inspect(|area| assert!(*area > 0.0))
        .sum();
    // the triangle of base 4 and height 4 less the one of base 4 and height 1
    assert_eq!(area, 6.0);
}

#[test]
fn a_file_is_known_by_its_first_word() {
    for text in ["b 0 0 0", "# x\n\n  # y\nv\nfrom 1 2 3", "v from 0 0 0", "s 1 2 3 4", "pp 3\n", "l 1 2 3"] {
        assert!(is_nff(text.as_bytes()), "{text}");
    }
    for text in
        ["", "# only a comment", "v 1 2 3\n", "vn 1 2 3", "<scene/>", "solid x", "ply\n", "\u{89}LSC", "mtllib a"]
    {
        assert!(!is_nff(text.as_bytes()), "{text}");
    }
}

#[test]
fn a_broken_file_says_everything_at_once() {
    const ENTITIES: &str =
        "entities are `v` view, `b` background, `l` light, `f` fill, `s` sphere, `c` cone, `p` polygon, `pp` patch";
    const NUMBERS: &str = "numbers are written like -12, 0.5 or 1e-3; `#` begins a comment";
    let text = "b 0 0 2\ns 0 0 0 x1\ns 0 0 0\ns 1 1 1 0\nq 1 2\nfoo bar\nc 0 0 0 1\n0 0 0 1\np 2\n1 1 1\ns 0 0 nan 1\ns 2e9 0 0 1\n\
                f 1 1 1 1 1 -1 0 1\ns 0 0 0 -1\np 99999999999\ns 0 é 0 1";
    assert_eq!(
        told(text),
        [
            "1:7: a colour's channel is 2; 1 is taken for it |  | colours and coefficients lie between 0 and 1, an \
             exponent between 0 and 10000"
                .to_owned(),
            format!("!2:9: `x1` stands where a radius is due, which is a number |  | {NUMBERS}"),
            format!("!4:1: `s` stands where a radius is due, which is a number |  | {NUMBERS}"),
            "!4:1: `radius` is 0, but must be greater than 0 | more than 0 | `radius` is at least 1e-9".to_owned(),
            format!("!5:1: `q` begins no entity |  | {ENTITIES}"),
            "!7:1: the ends of the cone are in one place | it would have no height | move `base` and `top` apart"
                .to_owned(),
            "!9:3: the number of corners is `2` |  | the number of corners is a whole number from 3 to 4096".to_owned(),
            format!("!11:7: `nan` stands where a coordinate is due, which is a number |  | {NUMBERS}"),
            "!12:3: a coordinate is 2000000000 |  | a coordinate lies between -1000000000 and 1000000000".to_owned(),
            "!13:13: the fill's exponent of the highlight is -1 |  | the fill's exponent of the highlight is at least 0"
                .to_owned(),
            "14:9: a negative radius: only the inside would be seen, but here both sides are |  | the sign is dropped; \
             every surface has two sides here"
                .to_owned(),
            "!15:3: the number of corners is `99999999999` |  | the number of corners is a whole number from 3 to 4096"
                .to_owned(),
            format!("!16:5: `é` stands where a coordinate is due, which is a number |  | {NUMBERS}"),
        ]
    );
    assert_eq!(
        told("pp 3\n1 1 1 0 0"),
        ["!2:10: the file ends where a coordinate is due |  | perhaps the file is cut: copy it again"]
    );
    let many = told(&"s x\n".repeat(500));
    assert_eq!(many.len(), 101, "no more are told");
    assert_eq!(many[100], "!101:3: there are more errors |  | ");
}

#[test]
fn a_broken_view_is_told_once_and_leaves_the_scene() {
    let views = |text: &str| {
        let file = read("test.nff", text.as_bytes());
        assert!(file.views.value.is_none());
        let message = |found: &lancer_formats::Diagnostic| found.problem.message(Lang::English);
        (file.scene.value.is_some(), file.views.diagnostics.iter().map(message).collect::<Vec<_>>())
    };
    assert_eq!(views("s 0 0 0 1"), (true, vec!["the file has no view".to_owned()]));
    let along = VIEW.replace("up 0 1 0", "up 0 0 1");
    assert_eq!(views(&along), (true, vec!["`up` is 0 or points along the line of sight".to_owned()]));
    assert_eq!(views(&VIEW.replace("at 0 0 0", "")), (false, vec!["the view lacks its `at`".to_owned()]));
    assert_eq!(views(&VIEW.replace("angle", "angel")), (false, vec!["`angel` is no part of a view".to_owned()]));
    assert_eq!(views(&VIEW.replace("90", "180")), (false, vec!["the view's angle is 180".to_owned()]));
    assert_eq!(
        told(&format!("{VIEW}{VIEW}")),
        ["8:1: a second view is left out |  | a file has one view: the first counts"]
    );
}

/// One file is scene and view.
#[test]
fn one_file_serves_as_both_arguments() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/gallery/molecule.nff");
    let scene = load_scene(&path, &LoadOptions::default()).unwrap();
    let views = load_views(&path, &LoadOptions::default()).unwrap();
    assert!(!scene.has_errors() && !views.has_errors());
    let scene = scene.value.unwrap();
    for kind in ["sphere", "cone", "mesh"] {
        assert!(scene.objects.iter().any(|object| object.shape.element() == kind), "{kind}");
    }
    assert_eq!(views.value.unwrap().len(), 1);
}
