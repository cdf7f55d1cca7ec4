//! Objects as a Wavefront OBJ file, and their materials as the library beside it. The library says what `mesh::mtl`
//! reads, the other way round:
//!
//! | library | surface |
//! |---|---|
//! | `d`, `Tf` | opacity is 1 less the greatest channel of `Kt`; `Tf` is `Kt` by that channel |
//! | `Ka`, `Kd` | their shares of the opacity |
//! | `Ks`, `Ns`, `Ni` | `W`, the mean of `n`, the mean of the index |
//! | `illum` | 3 where there is a mirror, whose `Kr` is then `Ks`; else 2 |

use super::facetted::{self, Numbering, facetted, runs};
use super::loss::{Feature, Loss, surfaces_in_use};
use crate::xml::shortest;
use lancer_scene::{DMat3, DVec3, Highlight, Placement, Reflectance, Rgb, Scene, Shape, Surface};
use std::fmt::Write as _;

/// The least opacity: of something that is not there no share can be told.
const LEAST: f64 = 1e-6;

/// The two files.
#[derive(Clone, Debug)]
pub struct Files {
    /// The `.obj`.
    pub objects: String,
    /// The `.mtl`.
    pub materials: String,
}

/// The scene's objects; `library` is the name by which the first file names the second.
pub fn write(scene: &Scene, library: &str) -> Files {
    let mut out = format!("mtllib {library}\n");
    let mut numbering = Numbering::default();
    let (mut vertices, mut directions) = (1, 1);
    for object in scene.objects.iter().filter(|object| object.visible) {
        let Some(shape) = facetted(&object.shape) else { continue };
        let placement = match &object.shape {
            Shape::Mesh(mesh) => mesh.placement.clone(),
            Shape::Sphere { .. }
            | Shape::Plane { .. }
            | Shape::Facet { .. }
            | Shape::Cube { .. }
            | Shape::Parallelepiped { .. }
            | Shape::Cone { .. } => Placement::default(),
        };
        let linear = placement.linear();
        let DMat3 { x_axis: x, y_axis: y, z_axis: z } = linear;
        let turned = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
        let _ = writeln!(out, "o {}", object.name);
        let geometry = &shape.geometry;
        for vertex in &geometry.positions {
            let _ = writeln!(out, "v {}", triple(linear * *vertex + placement.position));
        }
        for normal in shape.normals.iter() {
            let _ = writeln!(out, "vn {}", triple((turned * *normal).normalize_or(DVec3::Y)));
        }
        for (material, first, end) in runs(object, geometry) {
            let number = numbering.number(material);
            let _ = writeln!(out, "usemtl {}", numbering.name(number));
            for facet in &geometry.facets[first..end] {
                let corner = |vertex: u32| match shape.normals.is_empty() {
                    true => format!(" {}", vertex as usize + vertices),
                    false => format!(" {}//{}", vertex as usize + vertices, vertex as usize + directions),
                };
                let _ = writeln!(out, "f{}", facet.map(corner).concat());
            }
        }
        vertices += geometry.positions.len();
        directions += shape.normals.len();
    }
    let mut materials = String::new();
    for (number, material) in numbering.0.iter().enumerate() {
        write_material(&numbering.name(number), &scene.surface(material), &mut materials);
    }
    Files { objects: out, materials }
}

/// What the files cannot say of the scene.
pub fn losses(scene: &Scene) -> Vec<Loss> {
    let mut losses = facetted::losses(scene);
    for (surface, owner) in surfaces_in_use(scene) {
        let opacity = opacity(&surface);
        let too_bright = (surface.ka * (1.0 / opacity)).max_channel().max((surface.kd * (1.0 / opacity)).max_channel());
        losses.of_each(
            [
                (surface.w != Reflectance::Constant, Feature::Law),
                (surface.highlight != Highlight::Phong, Feature::Highlight),
                (!surface.shininess.is_uniform(), Feature::Shininess),
                (!surface.index.is_uniform(), Feature::Dispersion),
                (too_bright > 1.0 || surface.is_mirror() && surface.kr != surface.ks, Feature::Coefficients),
            ],
            &owner,
        );
    }
    losses.0
}

fn opacity(surface: &Surface) -> f64 {
    (1.0 - surface.kt.max_channel()).max(LEAST)
}

fn write_material(name: &str, surface: &Surface, out: &mut String) {
    let mean = |values: Rgb| values.to_array().iter().sum::<f64>() / 3.0;
    let opacity = opacity(surface);
    let share = |color: Rgb| triple(DVec3::from((color * (1.0 / opacity)).to_array()).min(DVec3::ONE));
    let plain = |color: Rgb| triple(DVec3::from(color.to_array()));
    let _ = writeln!(out, "newmtl {name}\nKa {}\nKd {}", share(surface.ka), share(surface.kd));
    let ks = if surface.ks == Rgb::BLACK { surface.kr } else { surface.ks };
    let _ = writeln!(out, "Ks {}\nNs {}", plain(ks), shortest(mean(surface.shininess)));
    let _ = writeln!(out, "Ni {}", shortest(mean(surface.index)));
    if surface.is_transparent() {
        let filter = surface.kt * (1.0 / surface.kt.max_channel());
        let _ = writeln!(out, "d {}\nTf {}", shortest(opacity), plain(filter));
    }
    let _ = writeln!(out, "illum {}\n", if surface.is_mirror() { 3 } else { 2 });
}

fn triple(point: DVec3) -> String {
    point.to_array().map(shortest).join(" ")
}
