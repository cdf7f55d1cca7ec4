//! A scene and a view in the language of POV-Ray 3.7, as one would write them there by hand: its own spheres, planes and
//! boxes, one `mesh2` a mesh.
//!
//! What it cannot say: terms are summed, not composed by ⊕; a highlight has one strength and one shininess for all
//! channels; transparent objects filter shadows instead of blocking them, and let all channels through alike.

use super::placed;
use lancer_scene::{DVec3, MaterialRef, Object, Rgb, Scene, Screen, Shape, Surface, View};
use std::io::{self, BufWriter, Write};

pub(super) fn write(scene: &Scene, view: &View, out: &mut dyn Write) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    let Screen { origin, u, v } = view.resolved_screen().map_err(io::Error::other)?;
    let (environment, depth) = (&scene.world, view.depth.unwrap_or(scene.world.depth));
    writeln!(out, "#version 3.7;")?;
    // its first level is the primary ray's own
    writeln!(out, "global_settings {{ assumed_gamma 1 ambient_light rgb 1 max_trace_level {} }}", depth + 1)?;
    writeln!(out, "background {{ rgb {} }}", channels(environment.background))?;
    writeln!(
        out,
        "camera {{ perspective location {} direction {} right {} up {} }}",
        vector(view.eye),
        vector(origin + (u + v) * 0.5 - view.eye),
        vector(u),
        vector(-v)
    )?;
    for light in &scene.lights {
        writeln!(out, "light_source {{ {} rgb {} }}", vector(light.position), channels(light.color))?;
    }
    for (number, material) in scene.materials.iter().enumerate() {
        writeln!(out, "#declare Material{number} = {}", material_of(&material.surface, environment.ambient))?;
    }
    for object in &scene.objects {
        let material = match &object.material {
            MaterialRef::Named(name) => scene.materials.iter().position(|material| material.name == *name),
            MaterialRef::Default | MaterialRef::Inline(_) => None,
        };
        let material = match material {
            Some(number) => format!("material {{ Material{number} }}"),
            None => material_of(&scene.surface(&object.material), environment.ambient),
        };
        write_object(object, &material, &mut out)?;
    }
    out.flush()
}

fn write_object(object: &Object, material: &str, out: &mut impl Write) -> io::Result<()> {
    match &object.shape {
        Shape::Sphere { center, radius } => {
            writeln!(out, "sphere {{ {}, {radius} {material} }}", vector(*center))
        }
        Shape::Plane { p0, p1, p2 } => {
            let normal = (p1 - p0).cross(p2 - p0).normalize();
            writeln!(out, "plane {{ {}, {} {material} }}", vector(normal), normal.dot(*p0))
        }
        Shape::Facet { p0, p1, p2 } => {
            writeln!(out, "triangle {{ {}, {}, {} {material} }}", vector(*p0), vector(*p1), vector(*p2))
        }
        Shape::Cube { .. } | Shape::Parallelepiped { .. } => {
            let Some((origin, [a, b, c])) = object.shape.frame() else { return Ok(()) };
            let rows = [a, b, c, origin].map(|row| format!("{}, {}, {}", row.x, row.y, row.z)).join(", ");
            writeln!(out, "box {{ 0, 1 matrix <{rows}> {material} }}")
        }
        Shape::Cone { base, top, base_radius, top_radius, capped } => {
            let open = if *capped { "" } else { "open " };
            let (base, top) = (vector(*base), vector(*top));
            writeln!(out, "cone {{ {base}, {base_radius}, {top}, {top_radius} {open}{material} }}")
        }
        Shape::Mesh(_) => {
            let Some((positions, geometry)) = placed(&object.shape) else { return Ok(()) };
            writeln!(out, "mesh2 {{ vertex_vectors {{ {}", positions.len())?;
            for position in &positions {
                writeln!(out, ",<{},{},{}>", position.x as f32, position.y as f32, position.z as f32)?;
            }
            writeln!(out, "}} face_indices {{ {}", geometry.facets.len())?;
            for [a, b, c] in &geometry.facets {
                writeln!(out, ",<{a},{b},{c}>")?;
            }
            writeln!(out, "}} {material} }}")
        }
    }
}

/// The material of a surface. What it scatters and its ambient term are shares of what it does not let through.
fn material_of(surface: &Surface, ambient: Rgb) -> String {
    let mean = |values: Rgb| values.to_array().iter().sum::<f64>() / 3.0;
    let through = mean(surface.kt);
    let opaque = 1.0 - through;
    let color = if opaque > 0.0 { surface.kd * (1.0 / opaque) } else { surface.kd };
    let given_back = (surface.ka * ambient).zip(surface.kd, |term, kd| if kd > 0.0 { term / kd } else { 0.0 });
    let mut finish = format!("ambient rgb {} diffuse 1", channels(given_back));
    if surface.ks.max_channel() > 0.0 {
        finish += &format!(" phong {} phong_size {}", mean(surface.ks), mean(surface.shininess));
    }
    if surface.is_mirror() {
        finish += &format!(" reflection {{ rgb {} }}", channels(surface.kr));
    }
    let texture =
        format!("texture {{ pigment {{ rgb {} transmit {through} }} finish {{ {finish} }} }}", channels(color));
    let interior = match surface.is_transparent() {
        true => format!(" interior {{ ior {} }}", mean(surface.index)),
        false => String::new(),
    };
    format!("material {{ {texture}{interior} }}")
}

fn vector(vector: DVec3) -> String {
    format!("<{}, {}, {}>", vector.x, vector.y, vector.z)
}

fn channels(values: Rgb) -> String {
    format!("<{}, {}, {}>", values.r, values.g, values.b)
}

#[cfg(test)]
mod tests {
    use super::super::every_shape;

    #[test]
    fn every_shape_and_every_coefficient() {
        let (scene, view) = every_shape();
        let mut text = Vec::new();
        super::write(&scene, &view, &mut text).unwrap();
        assert_eq!(
            String::from_utf8(text).unwrap(),
            "\
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb 1 max_trace_level 4 }
background { rgb <0, 0, 0.5> }
camera { perspective location <0, 0, 5> direction <0, 0, -1> right <2, 0, 0> up <0, 1, 0> }
light_source { <1, 2, 3> rgb <1, 0.5, 0.25> }
#declare Material0 = material { texture { pigment { rgb <1, 0.5, 0> transmit 0.5 } finish { ambient rgb <0.25, 0.5, 0> \
diffuse 1 phong 0.5 phong_size 20 reflection { rgb <0.25, 0.25, 0.25> } } } interior { ior 1.5 } }
sphere { <1, 2, 3>, 0.5 material { Material0 } }
plane { <0, 1, 0>, -2 material { texture { pigment { rgb <0.6, 0.6, 0.6> transmit 0 } finish { \
ambient rgb <0.16666666666666669, 0.16666666666666669, 0.16666666666666669> diffuse 1 } } } }
box { 0, 1 matrix <2, 0, 0, 0, 2, 0, 0, 0, 2, -1, -1, -1> material { Material0 } }
box { 0, 1 matrix <1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0> material { Material0 } }
cone { <0, 0, 0>, 1, <0, 1, 0>, 0.5 open material { Material0 } }
triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> material { Material0 } }
mesh2 { vertex_vectors { 3
,<0,0,7>
,<2,0,7>
,<0,2,7>
} face_indices { 1
,<0,1,2>
} material { Material0 } }
"
        );
    }
}
