//! The sphereflake: each sphere carries nine of a third of its radius. E. Haines, Standard Procedural Databases,
//! «balls» (IEEE CG&A 7(11), 1987), with its floor, its three lamps and its view.

use super::{SKY, lamp, list, material, matte, mesh, object, view};
use crate::{Environment, Rgb, Scene, Shape, Surface, View};
use glam::{DMat3, DVec3};
use std::f64::consts::TAU;

/// How much smaller a sphere is than the one that carries it.
const SHRINKING: f64 = 1.0 / 3.0;

/// The flake of `Σ 9ⁿ` spheres, `n` from 0 to the size: 7381 for the published size 4.
pub(super) fn sphereflake(size: u32) -> (Scene, View) {
    let mut spheres = Vec::new();
    grow(&mut spheres, &directions(), size, DVec3::ZERO, 0.5, DVec3::Z);

    let floor_color = Rgb::new(1.0, 0.75, 0.33) * 0.8;
    let ball_color = Rgb::new(1.0, 0.9, 0.7) * 0.5;
    let ball = Surface { ks: Rgb::splat(0.5), shininess: Rgb::splat(3.0827), kr: Rgb::splat(0.5), ..matte(ball_color) };
    let corners = [(12.0, 12.0), (-12.0, 12.0), (-12.0, -12.0), (12.0, -12.0)];
    let floor = mesh(corners.map(|(x, y)| DVec3::new(x, y, -0.5)).to_vec(), vec![[0, 1, 2], [2, 3, 0]]);
    let spheres = (1..)
        .zip(spheres)
        .map(|(number, (center, radius))| object(format!("ball {number}"), "ball", Shape::Sphere { center, radius }));
    // a database of n lamps has each at 1/√n
    let light = Rgb::splat(1.0 / 3.0_f64.sqrt());
    let scene = Scene {
        name: format!("Sphereflake of size {size}"),
        world: Environment { ambient: Rgb::splat(0.1), background: SKY, depth: 4, ..Environment::default() },
        materials: list([material("floor", matte(floor_color)), material("ball", ball)]),
        lights: list([
            lamp("lamp 1", DVec3::new(4.0, 3.0, 2.0), light),
            lamp("lamp 2", DVec3::new(1.0, -4.0, 4.0), light),
            lamp("lamp 3", DVec3::new(-3.0, 1.0, 5.0), light),
        ]),
        objects: list(std::iter::once(object("floor", "floor", floor)).chain(spheres)),
    };
    (scene, view([512, 512], DVec3::new(2.1, 1.3, 1.7), DVec3::ZERO, DVec3::Z, 45.0))
}

/// Where the nine spheres stand on one whose own direction is +z: three around its head, six around its waist.
fn directions() -> [DVec3; 9] {
    let side = 1.0 / 2.0_f64.sqrt();
    let trio = [DVec3::new(side, side, 0.0), DVec3::new(side, 0.0, -side), DVec3::new(0.0, side, -side)];
    let axis = DVec3::new(1.0, -1.0, 0.0).normalize();
    // the plane of the three is brought level with the z axis
    let sine = 2.0 / 6.0_f64.sqrt();
    let raised = turn(axis, sine, (1.0 - sine * sine).sqrt());
    let mut directions = [DVec3::ZERO; 9];
    for (place, direction) in directions.iter_mut().enumerate() {
        let (sin, cos) = libm::sincos((place / 3) as f64 * TAU / 3.0);
        *direction = turn(DVec3::Z, sin, cos) * raised * trio[place % 3];
    }
    directions
}

/// The rotation about a unit axis by the angle of that sine and cosine (Rodrigues).
fn turn(axis: DVec3, sin: f64, cos: f64) -> DMat3 {
    let column = |v: DVec3| v * cos + axis.cross(v) * sin + axis * (axis.dot(v) * (1.0 - cos));
    DMat3::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z))
}

/// Adds a sphere and, `levels` deep, those that it carries, turned from +z to its own direction.
fn grow(
    spheres: &mut Vec<(DVec3, f64)>,
    directions: &[DVec3; 9],
    levels: u32,
    center: DVec3,
    radius: f64,
    direction: DVec3,
) {
    spheres.push((center, radius));
    if levels == 0 {
        return;
    }
    let axis = DVec3::Z.cross(direction);
    // so near to the axis the turn is left out or is half of a full one, as in the database
    let turned = if direction.z >= 0.9999 {
        DMat3::IDENTITY
    } else if direction.z <= -0.9999 {
        turn(DVec3::Y, 0.0, -1.0)
    } else {
        turn(axis.normalize(), axis.length(), direction.z)
    };
    for carried in directions {
        let direction = turned * *carried;
        let distance = radius * (1.0 + SHRINKING);
        grow(spheres, directions, levels - 1, center + direction * distance, radius * SHRINKING, direction);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines of the published file `balls.nff`: the first branch down to its tip, and the last sphere of the file.
    #[test]
    fn the_spheres_stand_where_the_database_has_them() {
        let mut spheres = Vec::new();
        grow(&mut spheres, &directions(), 4, DVec3::ZERO, 0.5, DVec3::Z);
        assert_eq!(spheres.len(), 7381);
        let published = [
            (0, [0.0, 0.0, 0.0], 0.5),
            (1, [0.272166, 0.272166, 0.544331], 0.166667),
            (2, [0.420314, 0.420314, 0.618405], 0.0555556),
            (3, [0.470715, 0.470715, 0.598245], 0.0185185),
            (4, [0.481689, 0.481689, 0.57904], 0.00617284),
            (5, [0.475329, 0.45787, 0.577669], 0.00617284),
            (11, [0.48356, 0.4661, 0.618821], 0.00617284),
            (7379, [0.427756, -0.532513, -0.243606], 0.00617284),
            (7380, [0.436486, -0.541242, -0.222222], 0.00617284),
        ];
        for (place, center, radius) in published {
            let (found, found_radius) = spheres[place];
            assert!((found - DVec3::from(center)).length() < 2e-6, "{place}: {found}");
            assert!((found_radius - radius).abs() < 1e-6, "{place}: {found_radius}");
        }
    }

    /// A sphere touches the one that carries it and none of its siblings reaches into another.
    #[test]
    fn spheres_touch_and_do_not_overlap() {
        let mut spheres = Vec::new();
        grow(&mut spheres, &directions(), 2, DVec3::ZERO, 0.5, DVec3::Z);
        assert_eq!(spheres.len(), 91);
        let mut touching = 0;
        for (place, (a, ra)) in spheres.iter().enumerate() {
            for (b, rb) in &spheres[..place] {
                let gap = (*a - *b).length() - ra - rb;
                assert!(gap > -1e-9, "{gap}");
                touching += usize::from(gap < 1e-9);
            }
        }
        assert!(touching >= 90, "{touching}");
    }
}
