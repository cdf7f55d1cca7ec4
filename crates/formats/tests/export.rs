//! Scenes for other programs: the text of each shape, and what is told to be lost.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use lancer_formats::Describe;
use lancer_formats::export::{Container, gltf_losses, obj_losses, povray_losses, write_gltf, write_obj, write_povray};
use lancer_formats::mesh::{self, FilesBeside, MeshFault};
use lancer_formats::xml::{Document, read_scene, read_views};
use lancer_scene::{MaterialRef, Scene, Shape, View};
use lancer_words::Lang;

/// Reads a scene that names no files.
fn scene(objects: &str) -> Scene {
    let text = format!("<scene version='1'>{objects}</scene>");
    let document = Document::read("scene.xml", text.as_bytes()).unwrap();
    let read = read_scene(&document, &mut NoFiles);
    read.value.unwrap_or_else(|| panic!("{:?}", read.diagnostics))
}

fn view(attributes: &str) -> View {
    let text = format!(
        "<view version='1' name='front' width='200' height='100' {attributes}><eye at='0 0 5'/>\
         <screen origin='-1 0.5 4' u='2 0 0' v='0 -1 0'/></view>"
    );
    let views = read_views(&Document::read("view.xml", text.as_bytes()).unwrap()).value.unwrap();
    View::clone(views.first().unwrap())
}

struct NoFiles;

impl mesh::MeshFiles for NoFiles {
    fn read(&mut self, _: &str) -> Result<mesh::MeshFile, mesh::MeshProblem> {
        unreachable!("no scene of these tests names a file")
    }
}

fn povray(scene: &Scene, view: &View) -> String {
    let mut text = Vec::new();
    write_povray(scene, view, &mut text).unwrap();
    String::from_utf8(text).unwrap()
}

fn told(losses: &[lancer_formats::export::Loss], lang: Lang) -> Vec<String> {
    losses.iter().map(|loss| loss.message(lang)).collect()
}

const EVERY_SHAPE: &str = "<world ambient='0.5' background='0 0 0.5' depth='3' compose='add' index='1.25'/>\
    <material name='glass' ka='0.25 0.25 0' kd='0.5 0.25 0' ks='0.5' n='20' kr='0.25' kt='0.5' index='1.5'/>\
    <material name='gloss' ka='0' kd='0.5' ks='0.25' n='50' highlight='blinn'/>\
    <light name='lamp' position='1 2 3' color='1 0.5 0.25'/><light name='off' position='9 9 9' visible='false'/>\
    <sphere name='ball' center='1 2 3' radius='0.5' material='glass'/>\
    <plane name='floor' p0='0 -2 0' p1='0 -2 1' p2='1 -2 0'/>\
    <cube name='die' center='0 0 0' edge='2' material='gloss'/>\
    <box name='slab' origin='0 0 0' u='1 0 0' v='1 1 0' w='0 0 1' material='gloss'/>\
    <cone name='tube' base='0 0 0' top='0 1 0' base-radius='1' top-radius='0.5' capped='false' material='glass'/>\
    <cone name='post' base='0 0 0' top='0 1 0' base-radius='1' top-radius='1' material='gloss'/>\
    <facet name='flag' p0='0 0 0' p1='1 0 0' p2='0 1 0' material='glass'/>\
    <mesh name='sheet' position='0 0 7' scale='2' material='gloss' smooth='true'>\
    <vertices>0 0 0 1 0 0 0 1 0</vertices><facets>0 1 2</facets></mesh>\
    <mesh name='two'><vertices>0 0 0 1 0 0 0 1 0 1 1 0</vertices><facets>0 1 2 1 3 2</facets>\
    <part material='glass' facets='1 1'/></mesh>\
    <sphere name='gone' center='0 0 0' radius='1' visible='false'/>";

#[test]
fn every_shape_in_the_language_of_pov_ray() {
    let text = "\
// povray +W200 +H100 -A File_Gamma=1 THIS_FILE
#version 3.7;
global_settings { charset utf8 assumed_gamma 1 ambient_light rgb 1 adc_bailout 0 max_trace_level 4 }
background { rgb <0, 0, 0.5> }
camera { perspective location <0, 0, 5> direction <0, 0, -1> right <2, 0, 0> up <0, 1, 0> }
light_source { <1, 2, 3> rgb <1, 0.5, 0.25> }
#declare Texture1 = texture { pigment { rgb <1, 0.5, 0> transmit 0.5 } finish { ambient rgb <0.25, 0.5, 0> diffuse 1 \
phong 0.5 phong_size 20 reflection { rgb <0.25, 0.25, 0.25> } } } // glass
sphere { <1, 2, 3>, 0.5 texture { Texture1 } interior { ior 1.2 } } // ball
#declare Texture2 = texture { pigment { rgb <0.6, 0.6, 0.6> } finish { \
ambient rgb <0.16666666666666669, 0.16666666666666669, 0.16666666666666669> diffuse 1 } }
plane { <0, 1, 0>, -2 texture { Texture2 } } // floor
#declare Texture3 = texture { pigment { rgb <0.5, 0.5, 0.5> } finish { ambient rgb <0, 0, 0> diffuse 1 specular 0.25 \
roughness 0.02 } } // gloss
box { 0, 1 matrix <2, 0, 0, 0, 2, 0, 0, 0, 2, -1, -1, -1> texture { Texture3 } } // die
box { 0, 1 matrix <1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0> texture { Texture3 } } // slab
cone { <0, 0, 0>, 1, <0, 1, 0>, 0.5 open texture { Texture1 } } // tube
cone { <0, 0, 0>, 1, <0, 1, 0>, 1 texture { Texture3 } } // post
triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> texture { Texture1 } } // flag
mesh2 { vertex_vectors { 3
,<0,0,7>
,<2,0,7>
,<0,2,7>
} normal_vectors { 3
,<0,0,1>
,<0,0,1>
,<0,0,1>
} face_indices { 1
,<0,1,2>
} inside_vector <0.3142, 0.5772, 0.7537> texture { Texture3 } } // sheet
mesh2 { vertex_vectors { 4
,<0,0,0>
,<1,0,0>
,<0,1,0>
,<1,1,0>
} texture_list { 2
, texture { Texture2 }
, texture { Texture1 }
} face_indices { 2
,<0,1,2>,0
,<1,3,2>,1
} inside_vector <0.3142, 0.5772, 0.7537> } // two
";
    assert_eq!(povray(&scene(EVERY_SHAPE), &view("")), text);
}

#[test]
fn what_a_view_leaves_out_is_left_out_of_pov_ray_s_scene() {
    let text = povray(&scene(EVERY_SHAPE), &view("without='shadows reflection transparency' depth='1'"));
    assert!(text.contains("max_trace_level 2 ") && text.contains("rgb <1, 0.5, 0.25> shadowless }"), "{text}");
    assert!(!text.contains("transmit") && !text.contains("ior") && !text.contains("reflection"), "{text}");
}

/// What scatters nothing still gives back ambient light.
#[test]
fn ambient_light_needs_no_diffuse_share() {
    let glow = scene("<material name='glow' ka='0.5' kd='0'/><sphere center='0 0 0' radius='1' material='glow'/>");
    let text = povray(&glow, &view(""));
    assert!(text.contains("pigment { rgb <1e-6, 1e-6, 1e-6> } finish { ambient rgb <100000"), "{text}");
}

/// Meshes of one geometry are declared once and placed.
#[test]
fn instances_share_one_mesh() {
    let one = scene("<mesh name='a'><vertices>0 0 0 1 0 0 0 1 0</vertices><facets>0 1 2</facets></mesh>");
    let Shape::Mesh(mesh) = &one.objects.first().unwrap().shape else { panic!("a mesh") };
    let placed = |number: u32| {
        let mut mesh = mesh.clone();
        mesh.placement.position.x = f64::from(number);
        lancer_scene::Object::new(format!("m{number}"), Shape::Mesh(mesh))
    };
    let many = Scene { objects: (0..1000).map(placed).collect(), ..one.clone() };
    let text = povray(&many, &view(""));
    assert_eq!((text.matches("mesh2").count(), text.matches("object { Mesh1 matrix").count()), (1, 1000));
    assert!(text.contains("object { Mesh1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 7, 0, 0> texture { Texture1 } } // m7\n"));
    let glb = write_gltf(&many, Container::Binary);
    let text = String::from_utf8_lossy(&glb);
    assert_eq!((text.matches("primitives").count(), text.matches("\"mesh\":0").count()), (1, 1000));
}

#[test]
fn losses_are_told_in_both_languages() {
    let lossy = scene(
        "<material name='m' ks='0.1 0.2 0.3' n='1 2 3' w='schlick' kt='0.1 0.2 0.3' index='1.5 1.6 1.7'/>\
         <light name='l' position='0 9 0'/><plane name='p' p0='0 0 0' p1='0 0 1' p2='1 0 0'/>\
         <sphere name='s' center='0 1 0' radius='1' material='m'/><sphere name='t' center='3 1 0' radius='1'/>\
         <cube name='h' center='0 0 0' edge='1' visible='false'/>",
    );
    let losses = povray_losses(&lossy, &view("samples='3'"));
    assert_eq!(
        told(&losses, Lang::English),
        [
            "the composition `screen` becomes a plain sum, which is not cut off at 1 on the way: bright places differ",
            "left out because hidden: `h`",
            "the reflectance becomes constant: `m`",
            "the strength of the highlight becomes the mean of its channels: `m`",
            "the shininess becomes the mean of its channels: `m`",
            "the transparency becomes the mean of its channels: `m`",
            "the refraction index becomes the mean of its channels, and light is no longer dispersed: `m`",
            "light passes through to what is in the shadow of transparent objects: `m`",
            "the samples of each pixel are left out, the other program has options for them: `front`",
        ]
    );
    assert_eq!(told(&losses, Lang::French)[1], "masqué, donc omis : « h »");
    assert_eq!(
        told(&obj_losses(&lossy), Lang::French),
        [
            "les sources, la lumière ambiante et le fond sont omis : le format ne contient que des objets",
            "masqué, donc omis : « h »",
            "les plans, sans fin, sont omis : « p »",
            "les formes rondes deviennent des facettes, soixante-quatre par tour : « s » et 1 autre",
            "la réflectance devient constante : « m »",
            "la brillance devient la moyenne de ses composantes : « m »",
            "l'indice de réfraction devient la moyenne de ses composantes, sans dispersion : « m »",
        ]
    );
    assert_eq!(told(&gltf_losses(&lossy), Lang::English).len(), 5);
    // what both can say loses nothing
    let plain = scene("<world compose='add'/><light position='0 9 0'/><sphere center='0 0 0' radius='1'/>");
    assert_eq!(povray_losses(&plain, &view("")), []);
}

struct Library(String);

impl FilesBeside for Library {
    fn read(&mut self, path: &str) -> Result<Vec<u8>, MeshFault> {
        assert_eq!(path, "out.mtl");
        Ok(self.0.clone().into_bytes())
    }
}

/// The reader of OBJ gives the facets and, to the last bit but rounding, the surfaces again.
#[test]
fn obj_comes_back() {
    let scene = scene(EVERY_SHAPE);
    let files = write_obj(&scene, "out.mtl");
    let read = mesh::read("out.obj", files.objects.as_bytes(), &mut Library(files.materials)).unwrap();
    // two cubes, two cones (the open one without caps), a sphere of 64 by 32, a facet, a mesh of one and one of two
    let round = 64 * 2 * 31 + 64 * 2 + 64 * 4;
    assert_eq!(read.geometry.facets.len(), 24 + round + 1 + 1 + 2);
    let surfaces: Vec<_> = read.geometry.parts.iter().map(|part| scene_surface(&part.material)).collect();
    let glass = &scene.material("glass").unwrap().surface;
    let found = surfaces.iter().find(|surface| surface.is_transparent()).unwrap();
    for (found, expected) in
        [(found.kd, glass.kd), (found.ka, glass.ka), (found.kt, glass.kt), (found.index, glass.index)]
    {
        assert!(found.zip(expected, |a, b| (a - b).abs()).max_channel() < 1e-12, "{found:?} {expected:?}");
    }
}

fn scene_surface(material: &MaterialRef) -> lancer_scene::Surface {
    match material {
        MaterialRef::Inline(surface) => lancer_scene::Surface::clone(surface),
        MaterialRef::Default | MaterialRef::Named(_) => panic!("a file's own surface"),
    }
}

/// Both containers hold the same, and the reader of glTF takes them.
#[test]
fn gltf_comes_back() {
    let scene = scene(EVERY_SHAPE);
    for (name, container) in [("out.glb", Container::Binary), ("out.gltf", Container::Text)] {
        let bytes = write_gltf(&scene, container);
        let read = mesh::read(name, &bytes, &mut Library(String::new())).unwrap();
        // here some facets have normals and others none, which the reader says
        assert!(read.warnings.iter().all(|warning| warning.fault == MeshFault::NormalsLeftOut), "{:?}", read.warnings);
        let objects = write_obj(&scene, "out.mtl");
        let by_obj = mesh::read("out.obj", objects.objects.as_bytes(), &mut Library(objects.materials)).unwrap();
        assert_eq!(read.geometry.facets.len(), by_obj.geometry.facets.len(), "{name}");
    }
    assert!(write_gltf(&Scene::default(), Container::Binary).starts_with(b"glTF"));
}
