//! The documents of 2009: every rule of SPEC §4, and what writing them keeps and loses.

#![allow(clippy::unwrap_used, reason = "the helpers of tests may panic")]

#[path = "../../scene/tests/arbitrary/mod.rs"]
mod arbitrary;

use arbitrary::{Extent, scene, views};
use lancer_formats::n7_2009::{Feature, Loss, N7Problem, Points, read_scene, read_views, write_scene, write_views};
use lancer_formats::xml::{Document, DocumentKind, XmlProblem};
use lancer_formats::{Describe, Outcome, Problem, Severity};
use lancer_scene::{
    Compose, DVec3, Environment, Highlight, Invalid, Material, MaterialRef, Mesh, MeshGeometry, Object, Part,
    Placement, PointLight, Reflectance, Rgb, Scene, Screen, ScreenSpec, Shape, Stage, Steps, Surface, View, Views,
};
use lancer_words::Lang;
use proptest::prelude::*;
use std::sync::Arc;

const fn at(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

fn outcome_of_scene(text: &str) -> (Document, Outcome<Scene>) {
    let document = Document::read("scene.xml", text.as_bytes()).unwrap();
    assert_eq!(document.kind(), Some(DocumentKind::Scene2009));
    let outcome = read_scene(&document);
    (document, outcome)
}

/// The scene of a document that nothing is said of.
fn clean(text: &str) -> Scene {
    let (_, outcome) = outcome_of_scene(text);
    assert_eq!(outcome.diagnostics, []);
    outcome.value.unwrap()
}

/// What is said: severity, underlined text, problem.
fn said(document: &Document, diagnostics: &[lancer_formats::Diagnostic]) -> Vec<(Severity, String, Problem)> {
    let text = |span: lancer_formats::Span| document.text()[span.start..span.end].to_owned();
    diagnostics
        .iter()
        .map(|diagnostic| (diagnostic.severity, text(diagnostic.span.unwrap()), diagnostic.problem.clone()))
        .collect()
}

fn said_of_scene(text: &str) -> Vec<(Severity, String, Problem)> {
    let (document, outcome) = outcome_of_scene(text);
    said(&document, &outcome.diagnostics)
}

fn warning(text: &str, problem: N7Problem) -> (Severity, String, Problem) {
    (Severity::Warning, text.to_owned(), Problem::N7(problem))
}

fn error(text: &str, problem: N7Problem) -> (Severity, String, Problem) {
    (Severity::Error, text.to_owned(), Problem::N7(problem))
}

fn rule(text: &str, rule: Invalid) -> (Severity, String, Problem) {
    (Severity::Error, text.to_owned(), Problem::Xml(XmlProblem::Rule(rule)))
}

const GREY: &str = "<Matiere><Diffuse><Couleur r='51' v='51' b='51'/></Diffuse></Matiere>";
const COLOUR: &str = "<Couleur r='51' v='102' b='255'/>";
const SPHERE: &str = "<Sphere rayon='2'><Point x='1' y='2' z='3'/></Sphere>";

fn object(material: &str, shape: &str) -> String {
    format!("<Scene><ObjetGraphique>{material}{shape}</ObjetGraphique>{COLOUR}</Scene>")
}

fn surface(material: &str) -> Surface {
    let scene = clean(&object(material, SPHERE));
    scene.surface(&scene.objects[0].material)
}

#[test]
fn the_example_documents_are_read() {
    let bytes = include_bytes!("../../../tests/n7_2009/scene.xml");
    let document = Document::read("scene.xml", bytes).unwrap();
    let outcome = read_scene(&document);
    assert_eq!(outcome.diagnostics, []);
    let scene = outcome.value.unwrap();
    assert_eq!(scene.check(), Ok(()));
    let names: Vec<&str> = scene.objects.iter().map(|object| &*object.name).collect();
    assert_eq!(names, ["plane 1", "sphere 1", "sphere 2", "box 1", "mesh 1"]);
    assert_eq!(scene.lights.iter().map(|light| &*light.name).collect::<Vec<_>>(), ["light 1", "light 2"]);
    assert_eq!(scene.world.ambient, Rgb::from_bytes([80, 100, 130]));
    let glass = scene.surface(&scene.objects[1].material);
    assert_eq!((glass.index, glass.shininess), (Rgb::splat(1.5), Rgb::splat(80.0)));

    let document = Document::read("views.xml", include_bytes!("../../../tests/n7_2009/views.xml")).unwrap();
    assert_eq!(document.kind(), Some(DocumentKind::Views2009));
    let outcome = read_views(&document);
    assert_eq!(outcome.diagnostics, []);
    assert_eq!(outcome.value.unwrap().len(), 2);
}

#[test]
fn the_last_colour_is_ambient_light_and_background() {
    let scene = clean(&format!("<Scene>{COLOUR}</Scene>"));
    let colour = Rgb::new(0.2, 0.4, 1.0);
    let world = Environment { ambient: colour, background: colour, depth: 6, ..Environment::default() };
    assert_eq!(scene, Scene { world, ..Scene::default() });

    let two = "<Scene>\n<Couleur r='1' v='2' b='3'/>\n<Couleur r='255' v='0' b='0'/></Scene>";
    let (_, outcome) = outcome_of_scene(two);
    assert_eq!(outcome.value.unwrap().world.ambient, Rgb::new(1.0, 0.0, 0.0));
    assert_eq!(said_of_scene(two), [warning("Couleur", N7Problem::EarlierColour { line: 3 })]);

    let none = N7Problem::MissingElement { parent: "Scene", due: &["Couleur"] };
    assert_eq!(said_of_scene("<Scene></Scene>"), [error("Scene", none)]);
}

#[test]
fn elements_may_stand_in_any_order() {
    let lamp = "<Source><Couleur r='255' v='255' b='255'/><Point z='3' y='2' x='1'/></Source>";
    let scene = clean(&format!("<Scene>{COLOUR}{lamp}<ObjetGraphique>{SPHERE}{GREY}</ObjetGraphique></Scene>"));
    assert_eq!(*scene.lights[0], PointLight::new("light 1", at(1.0, 2.0, 3.0)));
    assert_eq!(scene.objects[0].shape, Shape::Sphere { center: at(1.0, 2.0, 3.0), radius: 2.0 });
}

#[test]
fn a_material_is_counted_in_255ths_and_64ths() {
    let full = "<Matiere n='96'>
        <Ambiante><Couleur r='51' v='0' b='127.5'/></Ambiante><Diffuse><Couleur r='0' v='255' b='0'/></Diffuse>
        <Speculaire n='1280'><Couleur r='102' v='102' b='102'/></Speculaire>
        <Reflection><Couleur r='0' v='0' b='51'/></Reflection><Refraction><Couleur r='204' v='204' b='204'/></Refraction>
        </Matiere>";
    let expected = Surface {
        ka: Rgb::new(0.2, 0.0, 0.5),
        kd: Rgb::new(0.0, 1.0, 0.0),
        ks: Rgb::splat(0.4),
        w: Reflectance::Constant,
        shininess: Rgb::splat(20.0),
        kr: Rgb::new(0.0, 0.0, 0.2),
        kt: Rgb::splat(0.8),
        index: Rgb::splat(1.5),
        highlight: Highlight::Phong,
    };
    assert_eq!(surface(full), expected);
    // What is missing is black, and 64 is the default of both numbers.
    let empty = Surface { ka: Rgb::BLACK, kd: Rgb::BLACK, shininess: Rgb::WHITE, ..Surface::default() };
    assert_eq!(surface("<Matiere/>"), empty);
    assert_eq!(surface("<Matiere><Speculaire><Couleur r='0' v='0' b='0'/></Speculaire></Matiere>"), empty);
}

#[test]
fn an_index_of_0_is_1_where_nothing_refracts() {
    let refraction = |n: &str, t: u8| {
        object(
            &format!("<Matiere n='{n}'><Refraction><Couleur r='{t}' v='{t}' b='{t}'/></Refraction></Matiere>"),
            SPHERE,
        )
    };
    assert_eq!(surface("<Matiere n='0'/>").index, Rgb::WHITE);
    assert!(outcome_of_scene(&refraction("0", 0)).1.diagnostics.is_empty());
    assert_eq!(said_of_scene(&refraction("0", 1)), [error("0", N7Problem::BadIndex { found: 0.0 })]);
    assert_eq!(said_of_scene(&refraction("-64", 0)), [error("-64", N7Problem::BadIndex { found: -64.0 })]);
}

#[test]
fn values_outside_their_range_are_clamped_with_a_warning() {
    let text = object("<Matiere><Speculaire n='-1'><Couleur r='300' v='-2' b='255'/></Speculaire></Matiere>", SPHERE);
    let clamped = |name, found, max| N7Problem::Clamped { name, found, min: 0.0, max };
    assert_eq!(
        said_of_scene(&text),
        [
            warning("-1", clamped("n", -1.0, 640_000.0)),
            warning("300", clamped("r", 300.0, 255.0)),
            warning("-2", clamped("v", -2.0, 255.0)),
        ]
    );
    let scene = outcome_of_scene(&text).1.value.unwrap();
    let surface = scene.surface(&scene.objects[0].material);
    assert_eq!((surface.ks, surface.shininess), (Rgb::new(1.0, 0.0, 1.0), Rgb::BLACK));
}

#[test]
fn every_shape_is_read() {
    let shape = |text: &str| clean(&object(GREY, text)).objects[0].shape.clone();
    let points = |points: &[[i32; 3]]| -> String {
        points.iter().map(|[x, y, z]| format!("<Point x='{x}' y='{y}' z='{z}'/>")).collect()
    };
    let plan = format!("<Plan>{}</Plan>", points(&[[0, 0, 0], [0, 0, 1], [1, 0, 0]]));
    assert_eq!(shape(&plan), Shape::Plane { p0: DVec3::ZERO, p1: DVec3::Z, p2: DVec3::X });
    let cube = format!("<Cube>{}</Cube>", points(&[[1, 1, 1], [3, 1, 1], [1, 2, 1], [1, 1, 0]]));
    let edges = [at(2.0, 0.0, 0.0), DVec3::Y, -DVec3::Z];
    assert_eq!(shape(&cube), Shape::Parallelepiped { origin: DVec3::ONE, edges });
    let facet = |corners: &[[i32; 3]]| format!("<Facette>{}</Facette>", points(corners));
    let (near, far) = (facet(&[[0, 0, 0], [1, 0, 0], [0, 1, 0]]), facet(&[[0, 1, 0], [1, 0, 0], [0, 0, 5]]));
    let one = shape(&format!("<ObjetFacette>{near}</ObjetFacette>"));
    assert_eq!(one, Shape::Facet { p0: DVec3::ZERO, p1: DVec3::X, p2: DVec3::Y });
    // Equal points are one vertex.
    let Shape::Mesh(mesh) = shape(&format!("<ObjetFacette>{near}{far}</ObjetFacette>")) else { panic!() };
    assert_eq!(mesh.geometry.positions, [DVec3::ZERO, DVec3::X, DVec3::Y, at(0.0, 0.0, 5.0)]);
    assert_eq!(mesh.geometry.facets, [[0, 1, 2], [2, 1, 3]]);
    // Facets without area, and none at all, are legal.
    for facets in [String::new(), facet(&[[0, 0, 0], [1, 0, 0], [2, 0, 0]])] {
        assert!(matches!(shape(&format!("<ObjetFacette>{facets}</ObjetFacette>")), Shape::Mesh(_)));
    }
}

#[test]
fn what_the_format_does_not_know_is_a_warning() {
    let text = format!(
        "<Scene nom='x' xmlns:a='b'><Objet/>bonjour<Source><Point x='0' y='0' z='0' w='1'/><Coleur/>{COLOUR}</Source>\
         {COLOUR}<!-- rien --></Scene>"
    );
    let (_, outcome) = outcome_of_scene(&text);
    assert_eq!(outcome.value.unwrap().lights.len(), 1);
    let messages: Vec<(Severity, String, String)> = said_of_scene(&text)
        .into_iter()
        .map(|(severity, underlined, problem)| (severity, underlined, problem.message(Lang::French)))
        .collect();
    let warning = |underlined: &str, message: &str| (Severity::Warning, underlined.to_owned(), message.to_owned());
    assert_eq!(
        messages,
        [
            warning("nom", "« <Scene> » n'a aucun attribut : « nom » est ignoré"),
            warning("Objet", "« <Scene> » ne contient pas de « <Objet> » : il est ignoré"),
            warning("bonjour", "ce texte dans « <Scene> » est ignoré"),
            warning("w", "« <Point> » n'a pas d'attribut « w » : il est ignoré"),
            warning("Coleur", "« <Source> » ne contient pas de « <Coleur> » : il est ignoré"),
        ]
    );
}

#[test]
fn all_errors_are_told_at_once_and_in_place() {
    let text = "<Scene>
  <ObjetGraphique><Sphere rayon='0'><Point x='1' y='2'/></Sphere></ObjetGraphique>
  <ObjetGraphique><Matiere/><Matiere n='x'/><Plan><Point x='0' y='0' z='0'/></Plan><Cube/></ObjetGraphique>
  <ObjetGraphique><Matiere><Diffuse/></Matiere><Plan>
    <Point x='0' y='0' z='0'/><Point x='1' y='1' z='1'/><Point x='2' y='2' z='2'/></Plan></ObjetGraphique>
  <Source><Point x='2e9' y='0,5' z='0'/></Source>
  <Couleur r='1' v='2' b='3'/>
</Scene>";
    let said: Vec<(String, &str)> = said_of_scene(text)
        .into_iter()
        .map(|(severity, underlined, problem)| {
            assert_eq!(severity, Severity::Error);
            (underlined, problem.code())
        })
        .collect();
    let expected = [
        ("ObjetGraphique", "n7::missing-element"),
        ("0", "rule::not-positive"),
        ("Point", "n7::missing-attribute"),
        ("Matiere", "n7::second-element"),
        ("Plan", "n7::point-count"),
        ("Cube", "n7::second-shape"),
        ("Diffuse", "n7::missing-element"),
        ("Plan", "rule::collinear"),
        ("Source", "n7::missing-element"),
        ("2e9", "rule::out-of-range"),
        ("0,5", "xml::decimal-comma"),
    ];
    assert_eq!(said, expected.map(|(underlined, code)| (underlined.to_owned(), code)));
    assert!(outcome_of_scene(text).1.value.is_none());
}

#[test]
fn points_are_counted() {
    let problem = N7Problem::PointCount { parent: "Sphere", found: 2, due: 1, meaning: Points::OfSphere };
    let two = "<Sphere rayon='1'><Point x='1' y='2' z='3'/><Point x='1' y='2' z='3'/></Sphere>";
    assert_eq!(said_of_scene(&object(GREY, two)), [error("Sphere", problem)]);
    let radius = Invalid::OutOfRange { field: "rayon", value: -1.0, min: 1e-9, max: 1e9 };
    let inside_out = "<Sphere rayon='-1'><Point x='1' y='2' z='3'/></Sphere>";
    assert_eq!(said_of_scene(&object(GREY, inside_out)), [rule("-1", radius)]);
}

fn vue(attributes: &str, eye: &str, corners: [[f64; 3]; 4]) -> String {
    let points: String = corners.into_iter().map(|[x, y, z]| format!("<Point x='{x}' y='{y}' z='{z}'/>")).collect();
    format!("<Rendu><Vue {attributes}><PointVue>{eye}</PointVue>{points}</Vue></Rendu>")
}

const EYE: &str = "<Point x='0' y='0' z='5'/>";
/// Four units wide and two high, at the origin.
const CORNERS: [[f64; 3]; 4] = [[-2.0, -1.0, 0.0], [2.0, -1.0, 0.0], [2.0, 1.0, 0.0], [-2.0, 1.0, 0.0]];

fn outcome_of_views(text: &str) -> (Document, Outcome<Views>) {
    let document = Document::read("views.xml", text.as_bytes()).unwrap();
    assert_eq!(document.kind(), Some(DocumentKind::Views2009));
    let outcome = read_views(&document);
    (document, outcome)
}

/// The sample of pixel `(i, j)` was `TL + i·û + j·v̂`; natively it is at `(i+½)/width` and `(j+½)/height`.
#[test]
fn a_pixel_is_sampled_at_its_corner() {
    let (_, outcome) = outcome_of_views(&vue("largeur='4' hauteur='2'", EYE, CORNERS));
    assert_eq!(outcome.diagnostics, []);
    let views = outcome.value.unwrap();
    assert_eq!(&*views[0].name, "view 1");
    let screen = Screen { origin: at(-2.5, 1.5, 0.0), u: at(4.0, 0.0, 0.0), v: at(0.0, -2.0, 0.0) };
    assert_eq!(views[0].screen, ScreenSpec::Frame(screen));
    for (i, j) in [(0.0, 0.0), (3.0, 1.0), (2.0, 0.0)] {
        let sample = screen.point((i + 0.5) / 4.0, (j + 0.5) / 2.0);
        assert_eq!(sample, at(-2.0 + i, 1.0 - j, 0.0));
    }
}

/// The corners give the directions, the counts of pixels the size.
#[test]
fn the_extent_counts_scene_units() {
    let (document, outcome) = outcome_of_views(&vue("largeur='8' hauteur='2'", EYE, CORNERS));
    let wide = N7Problem::Extent { name: "largeur", extent: 8.0, apart: 4.0 };
    assert_eq!(said(&document, &outcome.diagnostics), [warning("8", wide)]);
    let screen = outcome.value.unwrap()[0].resolved_screen().unwrap();
    assert_eq!(screen.u, at(8.0, 0.0, 0.0));
    let mut crooked = CORNERS;
    crooked[1][0] = 3.0;
    let (document, outcome) = outcome_of_views(&vue("largeur='4' hauteur='2'", EYE, crooked));
    assert_eq!(said(&document, &outcome.diagnostics), [warning("Point", N7Problem::CrookedCorner)]);
    assert_eq!(outcome.value.unwrap()[0].resolved_screen().unwrap().u, at(4.0, 0.0, 0.0));
}

#[test]
fn errors_of_views() {
    let said = |text: &str| {
        let (document, outcome) = outcome_of_views(text);
        assert!(outcome.value.is_none());
        said(&document, &outcome.diagnostics)
    };
    let pixels = Invalid::OutOfRange { field: "largeur", value: 0.0, min: 1.0, max: 65_535.0 };
    assert_eq!(said(&vue("largeur='0' hauteur='2'", EYE, CORNERS)), [rule("0", pixels)]);
    let missing = N7Problem::MissingAttribute { name: "hauteur", element: "Vue" };
    assert_eq!(said(&vue("largeur='4'", EYE, CORNERS)), [error("Vue", missing)]);
    let in_plane = "<Point x='5' y='5' z='0'/>";
    assert_eq!(said(&vue("largeur='4' hauteur='2'", in_plane, CORNERS)), [rule("Vue", Invalid::EyeInScreen)]);
    let point = said(&vue("largeur='4' hauteur='2'", EYE, [[1.0; 3]; 4]));
    assert!(point.contains(&rule("Vue", Invalid::ScreenCollinear)), "{point:?}");
    let [(severity, underlined, problem)] = &said(&vue("largeur='4.5' hauteur='2'", EYE, CORNERS))[..] else {
        panic!()
    };
    assert_eq!((*severity, underlined.as_str(), problem.code()), (Severity::Error, "4.5", "xml::not-whole"));

    let (document, outcome) = outcome_of_views("<Rendu/>");
    assert_eq!(self::said(&document, &outcome.diagnostics), [warning("Rendu", N7Problem::NoViews)]);
    assert!(outcome.value.unwrap().is_empty());
}

#[test]
fn a_document_of_the_other_kind_is_refused() {
    let views = Document::read("a.xml", b"<Rendu/>").unwrap();
    assert_eq!(
        read_scene(&views).diagnostics[0].problem.message(Lang::English),
        "this is a `<Rendu>`, but a `<Scene>` is due"
    );
    let scene = Document::read("a.xml", b"<Scene/>").unwrap();
    assert_eq!(read_views(&scene).diagnostics[0].problem.code(), "n7::wrong-root");
}

/// Hostile documents: too many facets would be too large a file first; everything else is passed over or refused, and
/// nothing is guessed of the thousands of names after the first.
#[test]
fn a_large_document_is_read_whatever_it_holds() {
    let facet = "<Facette><Point x='0' y='0' z='0'/><Point x='1' y='0' z='0'/><Point x='0' y='1' z='0'/></Facette>";
    let text = object(GREY, &format!("<ObjetFacette>{}</ObjetFacette>", facet.repeat(50_000)));
    let scene = clean(&text);
    assert_eq!(scene.objects[0].shape.geometry().unwrap().positions.len(), 3);
    let wrong = format!("<Scene>{}</Scene>", "<Objet_Graphique/>".repeat(100_000));
    let diagnostics = outcome_of_scene(&wrong).1.diagnostics;
    assert_eq!(diagnostics.len(), 10_001);
    let guessed = |found: &lancer_formats::Diagnostic| found.problem.label(Lang::English).contains("did you mean");
    assert_eq!(diagnostics.iter().filter(|found| guessed(found)).count(), 1000);
}

// ---- writing ---------------------------------------------------------------------------------------------------------

/// What a document of 2009 can hold is written and read again without a loss.
#[test]
fn what_was_read_is_written_again() {
    let document = Document::read("scene.xml", include_bytes!("../../../tests/n7_2009/scene.xml")).unwrap();
    let scene = read_scene(&document).value.unwrap();
    let (text, losses) = write_scene(&scene);
    assert_eq!(losses, []);
    assert_eq!(clean(&text), scene);
    assert_eq!(write_scene(&clean(&text)).0, text);

    let document = Document::read("views.xml", include_bytes!("../../../tests/n7_2009/views.xml")).unwrap();
    let views = read_views(&document).value.unwrap();
    let (text, losses) = write_views(&views);
    assert_eq!(losses, []);
    let again = outcome_of_views(&text).1;
    assert_eq!(again.diagnostics, []);
    for (view, again) in views.iter().zip(&again.value.unwrap()) {
        let (screen, again) = (view.resolved_screen().unwrap(), again.resolved_screen().unwrap());
        assert!((screen.origin - again.origin).length() < 1e-12 * screen.origin.length());
        assert!((screen.u - again.u).length() < 1e-12 * screen.u.length());
    }
}

fn paint(name: &str, surface: Surface) -> Material {
    Material { name: name.into(), surface }
}

fn lost(feature: Feature, first: &str, count: usize) -> Loss {
    Loss::Of { feature, first: first.into(), count }
}

#[test]
fn every_loss_is_told() {
    let ball = |name: &str, material: &str| Object {
        material: MaterialRef::Named(material.into()),
        ..Object::new(name, Shape::Sphere { center: DVec3::ZERO, radius: 1.0 })
    };
    let prism = Surface {
        index: Rgb::new(1.5, 1.625, 1.75),
        shininess: Rgb::new(1.0, 2.0, 6.0),
        w: Reflectance::Schlick,
        highlight: Highlight::Blinn,
        ..Surface::default()
    };
    let geometry = MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Z, DVec3::Y],
        facets: vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]],
        parts: vec![Part { material: MaterialRef::Named("red".into()), first: 1, count: 2 }],
        ..MeshGeometry::default()
    };
    let mesh = Mesh {
        geometry: Arc::new(geometry),
        source: Some("pyramid.obj".into()),
        placement: Placement { position: at(0.0, 0.0, 2.0), ..Placement::default() },
        smooth: true,
    };
    let cube = Shape::Cube { center: DVec3::ZERO, edge: 2.0, rotation: at(0.0, 90.0, 0.0) };
    let scene = Scene {
        name: "Prism".into(),
        world: Environment { index: Rgb::splat(1.33), depth: 9, compose: Compose::Add, ..Environment::default() },
        materials: [paint("red", Surface::default()), paint("prism", prism), paint("spare", Surface::default())]
            .into_iter()
            .collect(),
        lights: [
            PointLight::new("lamp", DVec3::ONE),
            PointLight { visible: false, ..PointLight::new("off", DVec3::ONE) },
        ]
        .into_iter()
        .collect(),
        objects: [
            ball("sphere 1", "red"),
            ball("pearl", "prism"),
            Object { visible: false, ..ball("absent", "red") },
            Object::new("die", cube.clone()),
            Object::new("box 3", cube),
            Object::new("pyramid", Shape::Mesh(mesh)),
        ]
        .into_iter()
        .collect(),
    };
    let (text, losses) = write_scene(&scene);
    assert_eq!(
        losses,
        [
            Loss::Title { title: "Prism".into() },
            Loss::Background,
            Loss::WorldIndex,
            Loss::Depth { depth: 9 },
            Loss::Compose { compose: Compose::Add },
            lost(Feature::Hidden, "off", 2),
            lost(Feature::Name, "pearl", 7),
            lost(Feature::Law, "prism", 1),
            lost(Feature::Highlight, "prism", 1),
            lost(Feature::Shininess, "prism", 1),
            lost(Feature::Dispersion, "prism", 1),
            lost(Feature::Unused, "spare", 1),
            lost(Feature::Cube, "die", 2),
            lost(Feature::Placement, "pyramid", 1),
            lost(Feature::File, "pyramid", 1),
            lost(Feature::Smooth, "pyramid", 1),
            lost(Feature::Parts, "pyramid", 1),
        ]
    );
    let messages: Vec<String> = losses.iter().map(|loss| loss.message(Lang::English)).collect();
    assert_eq!(messages[6], "names left out: `pearl` and 6 others");
    assert_eq!(losses[5].message(Lang::French), "masqué, donc omis : « off » et 1 autre");

    let read = clean(&text);
    assert_eq!(read.objects.len(), 6);
    let prism = read.surface(&read.objects[1].material);
    assert_eq!((prism.index, prism.shininess), (Rgb::splat(1.625), Rgb::splat(3.0)));
    // The pyramid's own two facets, where they stand, and then its red ones.
    let facets = |object: &Object| object.shape.geometry().unwrap().facets.len();
    assert_eq!((facets(&read.objects[4]), facets(&read.objects[5])), (2, 2));
    assert_eq!(read.objects[4].shape.geometry().unwrap().positions[0], at(0.0, 0.0, 2.0));
    assert_eq!(read.objects[2].shape.bounds(), Some((DVec3::NEG_ONE, DVec3::ONE)));
}

#[test]
fn what_views_lose() {
    let view = |name: &str, screen| View {
        name: name.into(),
        width: 40,
        height: 30,
        eye: at(0.0, 1.0, 5.0),
        screen,
        samples: 1,
        depth: None,
        steps: Steps::default(),
    };
    let look = || ScreenSpec::LookAt { look_at: DVec3::ZERO, up: DVec3::Y, fov: 45.0 };
    let flat = Screen { origin: at(-20.0, 20.0, 0.0), u: at(40.0, 0.0, 0.0), v: at(0.0, -40.0, 0.0) };
    let views: Views = [
        view("view 1", look()),
        View { samples: 3, depth: Some(6), ..view("front", look()) },
        View { depth: Some(2), ..view("view 3", ScreenSpec::Frame(flat)) },
        View { steps: Steps { shadows: false, ..Steps::default() }, ..view("view 4", look()) },
    ]
    .into_iter()
    .collect();
    assert_eq!(
        write_views(&views).1,
        [
            lost(Feature::Screen, "view 1", 3),
            lost(Feature::Name, "front", 1),
            lost(Feature::Samples, "front", 1),
            lost(Feature::Proportion, "view 3", 1),
            lost(Feature::ViewDepth, "view 3", 1),
            lost(Feature::Steps, "view 4", 1),
        ]
    );
}

proptest! {
    /// Whatever a scene holds, what is written is a legal document, and writing what was read again changes nothing
    /// more: the losses are all told the first time.
    #[test]
    fn writing_is_legal_and_loses_nothing_twice(scene in scene(Extent::Whole)) {
        let (text, _) = write_scene(&scene);
        let (_, outcome) = outcome_of_scene(&text);
        // Numbers at the ends of their ranges may leave them where points are added or 64ths are taken.
        let Some(read) = outcome.value else { return Ok(()) };
        prop_assert_eq!(read.check(), Ok(()));
        let (again, losses) = write_scene(&read);
        prop_assert_eq!(losses, []);
        let visible = scene.lights.iter().filter(|light| light.visible).count();
        prop_assert_eq!(read.lights.len(), visible);
        let (_, outcome) = outcome_of_scene(&again);
        prop_assert_eq!(outcome.value.as_ref().map(|scene| scene.objects.len()), Some(read.objects.len()));
    }

    /// The picture is the same: every pixel of a view with square pixels is seen along the same ray.
    #[test]
    fn written_views_show_the_same(views in views()) {
        let (text, losses) = write_views(&views);
        let (_, outcome) = outcome_of_views(&text);
        let Some(read) = outcome.value else { return Ok(()) };
        prop_assert_eq!(read.len(), views.len());
        for (view, read) in views.iter().zip(&read) {
            let (screen, again) = (view.resolved_screen().unwrap(), read.resolved_screen().unwrap());
            let pixel = [screen.u.length() / f64::from(view.width), screen.v.length() / f64::from(view.height)];
            let square = (pixel[0] / pixel[1] - 1.0).abs() < 1e-9;
            let told = losses.iter().any(|loss| matches!(loss, Loss::Of { feature: Feature::Proportion, .. }));
            prop_assert!(square || told);
            for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.3, 0.7)] {
                let ray = (screen.point(x, y) - view.eye).normalize();
                let again = (again.point(x, y) - read.eye).normalize();
                prop_assert!(!square || (ray - again).length() < 1e-6, "{ray} {again}");
            }
        }
    }
}

/// A document of 2009 is a scene like any other.
#[test]
fn what_was_read_can_be_saved_in_binary() {
    let document = Document::read("scene.xml", include_bytes!("../../../tests/n7_2009/scene.xml")).unwrap();
    let scene = read_scene(&document).value.unwrap();
    let stage = Stage { scene, ..Stage::default() };
    let file = lancer_formats::binary::write_scene(&stage.scene);
    assert_eq!(lancer_formats::binary::read_scene(&file), Ok(stage.scene));
}
