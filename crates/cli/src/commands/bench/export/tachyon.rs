//! A scene and a view in the language of Tachyon 0.99, whose axes are left-handed: every z is written with the other
//! sign.
//!
//! What it cannot say: refraction (light goes straight through); coefficients for each channel, which become one colour
//! and one strength each; and ⊕.

use super::placed;
use lancer_scene::{DVec3, Object, Rgb, Scene, Screen, Shape, Surface, View, box_facets};
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
    format!("{} {} {}", vector.x as f32, vector.y as f32, -vector.z as f32)
}

fn channels(values: Rgb) -> String {
    format!("{} {} {}", values.r, values.g, values.b)
}
