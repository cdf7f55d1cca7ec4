//! A scene and a view in the language of Tachyon 0.99, whose axes are left-handed: every z is written with the other
//! sign.
//!
//! What it cannot say: refraction (light goes straight through); coefficients for each channel, which become one colour
//! and one strength each; and ⊕.

use super::placed;
use lancer_scene::{DVec3, Object, Rgb, Scene, Screen, Shape, Surface, View, box_facets, cone_facets};
use std::io::{self, BufWriter, Write};

pub(super) fn write(scene: &Scene, view: &View, out: &mut dyn Write) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    let Screen { origin, u, v } = view.resolved_screen().map_err(io::Error::other)?;
    // it samples pixels at their upper right corner; aimed half a pixel to the left and down it sees their centres
    let aim = (v / f64::from(view.height) - u / f64::from(view.width)) * 0.5;
    let sight = origin + (u + v) * 0.5 + aim - view.eye;
    // its screen stands at distance 1 and is as high as 1 over the zoom
    let zoom = sight.length() / v.length();
    writeln!(out, "BEGIN_SCENE")?;
    writeln!(out, "RESOLUTION {} {}", view.width, view.height)?;
    writeln!(
        out,
        "CAMERA ZOOM {zoom} ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH {}",
        view.depth.unwrap_or(scene.world.depth) + 1
    )?;
    let (sight, up) = (sight.normalize(), -v.normalize());
    writeln!(out, "CENTER {} VIEWDIR {} UPDIR {} END_CAMERA", vector(view.eye), vector(sight), vector(up))?;
    writeln!(out, "BACKGROUND {}", channels(scene.world.background))?;
    for light in &scene.lights {
        writeln!(out, "LIGHT CENTER {} RAD 0.01 COLOR {}", vector(light.position), channels(light.color))?;
    }
    for (number, material) in scene.materials.iter().enumerate() {
        writeln!(out, "TEXDEF material{number} {}", texture_of(&material.surface, scene.world.ambient))?;
    }
    for object in &scene.objects {
        let named = object.material.name();
        let material = scene.materials.iter().position(|material| Some(&material.name) == named);
        let texture = match material {
            Some(number) => format!("material{number}"),
            None => format!("TEXTURE {}", texture_of(&scene.surface(&object.material), scene.world.ambient)),
        };
        write_object(object, &texture, &mut out)?;
    }
    writeln!(out, "END_SCENE")?;
    out.flush()
}

/// How many facets go around a cone, which it knows no primitive for.
const CONE_FACETS: u32 = 64;

fn write_object(object: &Object, texture: &str, out: &mut impl Write) -> io::Result<()> {
    let mut facet = |[a, b, c]: [DVec3; 3]| {
        // the other way round, because the mirrored axes turn it
        writeln!(out, "TRI V0 {} V1 {} V2 {} {texture}", vector(a), vector(c), vector(b))
    };
    match &object.shape {
        Shape::Sphere { center, radius } => {
            writeln!(out, "SPHERE CENTER {} RAD {radius} {texture}", vector(*center))
        }
        Shape::Plane { p0, p1, p2 } => {
            let normal = (p1 - p0).cross(p2 - p0).normalize();
            writeln!(out, "PLANE CENTER {} NORMAL {} {texture}", vector(*p0), vector(normal))
        }
        Shape::Facet { p0, p1, p2 } => facet([*p0, *p1, *p2]),
        Shape::Cube { .. } | Shape::Parallelepiped { .. } => match object.shape.frame() {
            Some((origin, edges)) => box_facets(origin, edges).into_iter().try_for_each(facet),
            None => Ok(()),
        },
        Shape::Cone { base, top, base_radius, top_radius, capped } => {
            cone_facets([*base, *top], [*base_radius, *top_radius], *capped, CONE_FACETS)
                .into_iter()
                .try_for_each(facet)
        }
        Shape::Mesh(_) => match placed(&object.shape) {
            Some((positions, geometry)) => {
                geometry.facets.iter().try_for_each(|corners| facet(corners.map(|vertex| positions[vertex as usize])))
            }
            None => Ok(()),
        },
    }
}

/// The texture of a surface: one colour, and how much of it each term has.
fn texture_of(surface: &Surface, ambient: Rgb) -> String {
    let mean = |values: Rgb| values.to_array().iter().sum::<f64>() / 3.0;
    let scattered = surface.kd.max_channel();
    let color = if scattered > 0.0 { surface.kd * (1.0 / scattered) } else { Rgb::WHITE };
    let given_back = mean(surface.ka * ambient) / mean(color);
    let (mirrored, opacity) = (mean(surface.kr), 1.0 - mean(surface.kt));
    let mut texture = format!("AMBIENT {given_back} DIFFUSE {scattered} SPECULAR {mirrored} OPACITY {opacity}");
    if surface.ks.max_channel() > 0.0 {
        texture += &format!(" PHONG PLASTIC {} PHONG_SIZE {}", mean(surface.ks), mean(surface.shininess));
    }
    texture + &format!(" COLOR {} TEXFUNC 0", channels(color))
}

/// A point or direction in its axes.
fn vector(vector: DVec3) -> String {
    // a negative zero and a zero make a zero
    let [x, y, z] = [vector.x, vector.y, -vector.z].map(|coordinate| coordinate as f32 + 0.0);
    format!("{x} {y} {z}")
}

fn channels(values: Rgb) -> String {
    format!("{} {} {}", values.r, values.g, values.b)
}

#[cfg(test)]
mod tests {
    use super::super::every_shape;

    #[test]
    fn every_shape_and_every_coefficient() {
        let (scene, view) = every_shape();
        let mut text = Vec::new();
        super::write(&scene, &view, &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        let (boxes, rest): (Vec<&str>, Vec<&str>) = text.lines().partition(|line| line.starts_with("TRI "));
        // the eye at (0 0 5) looks at a screen of 2 by 1 at distance 1, of 200 by 100 pixels: half of one is 1/200
        assert_eq!(
            rest.join("\n"),
            "\
BEGIN_SCENE
RESOLUTION 200 100
CAMERA ZOOM 1.000024999687508 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 4
CENTER 0 0 -5 VIEWDIR -0.004999875 -0.004999875 0.999975 UPDIR 0 1 0 END_CAMERA
BACKGROUND 0 0 0.5
LIGHT CENTER 1 2 -3 RAD 0.01 COLOR 1 0.5 0.25
TEXDEF material0 AMBIENT 0.16666666666666666 DIFFUSE 0.5 SPECULAR 0.25 OPACITY 0.5 PHONG PLASTIC 0.5 PHONG_SIZE 20 \
COLOR 1 0.5 0 TEXFUNC 0
SPHERE CENTER 1 2 -3 RAD 0.5 material0
PLANE CENTER 0 -2 0 NORMAL 0 1 0 TEXTURE AMBIENT 0.10000000000000002 DIFFUSE 0.6 SPECULAR 0 OPACITY 1 COLOR 1 1 1 \
TEXFUNC 0
END_SCENE"
        );
        // two boxes of twelve facets, an open cone of twice 64, the facet and the mesh's, which stands at z = 7
        assert_eq!(boxes.len(), 26 + 128);
        assert_eq!(boxes[152], "TRI V0 0 0 0 V1 0 1 0 V2 1 0 0 material0");
        assert_eq!(boxes[153], "TRI V0 0 0 -7 V1 0 2 -7 V2 2 0 -7 material0");
    }
}
