//! The rays that are cast by themselves, without light: four sets over one picture, from orderly to scattered.
//!
//! The rays are those of a picture's hits, so they are what a tracer meets: from the eye through every pixel; from what
//! is seen there to a lamp; mirrored; and in a random direction, as light is scattered. They stand in the order of
//! pixels that lie together, 4×4 in 8×8 in 16×16. Origins and directions are rounded to 32 bits, and rays start a little
//! above their surface, so that other programs can be given the very same rays.

use lancer_scene::DVec3;
use lancer_scene::generate::Random;
use lancer_trace::{Camera, Ray, World};
use rayon::ThreadPool;
use rayon::prelude::*;
use std::collections::TryReserveError;
use std::f64::consts::TAU;

/// Pixels along the side of a tile.
const TILE: u32 = 16;
/// How far above its surface a ray starts, in units of the greatest coordinate in sight: about two hundred roundings of
/// 32 bits, and far less than a facet.
const ABOVE: f64 = 2e-5;

/// The four sets.
#[derive(Debug)]
pub(super) struct RaySets {
    /// From the eye through the centres of all pixels.
    pub(super) primary: Vec<Ray>,
    /// From what is seen and faces the first lamp, to that lamp.
    pub(super) shadow: Segments,
    /// From what is seen, mirrored.
    pub(super) reflected: Vec<Ray>,
    /// From what is seen, in random directions, more often near the normal, as Lambert's law scatters light.
    pub(super) diffuse: Vec<Ray>,
}

/// Segments with one end in common.
#[derive(Debug)]
pub(super) struct Segments {
    /// The common end.
    pub(super) lamp: DVec3,
    /// The other ends.
    pub(super) points: Vec<DVec3>,
}

/// A point that is seen, and the ray that sees it.
struct Seen {
    point: DVec3,
    normal: DVec3,
    direction: DVec3,
}

impl RaySets {
    /// The rays of a picture.
    ///
    /// # Errors
    /// Where there is not enough memory for them.
    pub(super) fn new(
        world: &World,
        camera: &Camera,
        lamp: DVec3,
        pool: &ThreadPool,
    ) -> Result<RaySets, TryReserveError> {
        let mut primary = Vec::new();
        primary.try_reserve_exact(camera.width() as usize * camera.height() as usize)?;
        primary.extend(places(camera.width(), camera.height()).map(|(i, j)| {
            let ray = camera.ray(f64::from(i) + 0.5, f64::from(j) + 0.5);
            single(ray.origin, ray.direction)
        }));
        let pick = |ray: &Ray| {
            let picked = world.pick(ray)?;
            Some(Seen { point: picked.point, normal: picked.normal, direction: ray.direction })
        };
        let seen: Vec<Seen> = pool.install(|| primary.par_iter().filter_map(pick).collect());
        let size = seen.iter().map(|seen| seen.point.abs().max_element()).fold(0.0, f64::max);
        let above = |seen: &Seen| seen.point + seen.normal * (ABOVE * size);

        let faces = |seen: &&Seen| seen.normal.dot(lamp - seen.point) > 0.0;
        let mut shadow = Segments { lamp: rounded(lamp), points: Vec::new() };
        shadow.points.try_reserve_exact(seen.len())?;
        shadow.points.extend(seen.iter().filter(faces).map(|seen| rounded(above(seen))));

        let mut reflected = Vec::new();
        reflected.try_reserve_exact(seen.len())?;
        reflected.extend(
            seen.iter().map(|seen| {
                single(above(seen), seen.direction - seen.normal * (2.0 * seen.normal.dot(seen.direction)))
            }),
        );

        let mut random = Random::new(1977);
        let mut diffuse = Vec::new();
        diffuse.try_reserve_exact(seen.len())?;
        diffuse.extend(seen.iter().map(|seen| single(above(seen), scattered(seen.normal, &mut random))));
        Ok(RaySets { primary, shadow, reflected, diffuse })
    }
}

impl Segments {
    /// The ray from each point to the lamp, and its length.
    pub(super) fn rays(&self) -> impl Iterator<Item = (Ray, f64)> + '_ {
        self.points.iter().map(|&point| {
            let way = self.lamp - point;
            (Ray { origin: point, direction: way.normalize() }, way.length())
        })
    }
}

/// The pixels of a picture, tile by tile, in each in Morton's order: any 4, 16, 64 of them from such a place on are a
/// square.
fn places(width: u32, height: u32) -> impl Iterator<Item = (u32, u32)> {
    let tiles = move |pixels: u32| (0..pixels.div_ceil(TILE)).map(|tile| tile * TILE);
    tiles(height)
        .flat_map(move |y| tiles(width).map(move |x| (x, y)))
        .flat_map(|(x, y)| {
            (0..TILE * TILE).map(move |number| (x + every_second(number), y + every_second(number >> 1)))
        })
        .filter(move |&(x, y)| x < width && y < height)
}

/// The number of four bits that stand in every second place of a number of eight.
fn every_second(number: u32) -> u32 {
    (0..4).map(|bit| ((number >> (2 * bit)) & 1) << bit).sum()
}

/// A direction about a normal, as often as its cosine is great (Malley: a point of the disc, raised to the sphere).
fn scattered(normal: DVec3, random: &mut Random) -> DVec3 {
    let (square, turn) = (random.unit(), random.unit());
    let (sin, cos) = libm::sincos(turn * TAU);
    let (aside, across) = normal.any_orthonormal_pair();
    (aside * cos + across * sin) * square.sqrt() + normal * (1.0 - square).sqrt()
}

/// A ray whose origin and direction have 32 bits, but for the direction's length, which is 1 again.
fn single(origin: DVec3, direction: DVec3) -> Ray {
    Ray { origin: rounded(origin), direction: rounded(direction.normalize()).normalize() }
}

/// The nearest point with coordinates of 32 bits.
fn rounded(point: DVec3) -> DVec3 {
    DVec3::from(point.to_array().map(|coordinate| f64::from(coordinate as f32)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn every_pixel_is_there_once_and_sixteen_are_a_square() {
        for (width, height) in [(16, 16), (1, 1), (33, 20), (5, 40)] {
            let all: Vec<_> = places(width, height).collect();
            assert_eq!(all.len(), (width * height) as usize);
            assert_eq!(all.iter().collect::<HashSet<_>>().len(), all.len());
            assert!(all.iter().all(|&(x, y)| x < width && y < height));
        }
        for square in places(64, 32).collect::<Vec<_>>().chunks(16) {
            let (x, y) = square[0];
            assert!(square.iter().all(|&(i, j)| (x..x + 4).contains(&i) && (y..y + 4).contains(&j)));
        }
    }

    #[test]
    fn scattered_directions_follow_lambert() {
        let mut random = Random::new(3);
        let normal = DVec3::new(0.48, -0.6, 0.64);
        let cosines: Vec<f64> = (0..20_000).map(|_| scattered(normal, &mut random).dot(normal)).collect();
        assert!(cosines.iter().all(|cosine| (-1e-12..1.0 + 1e-12).contains(cosine)));
        // the mean cosine of a density cos/π over the hemisphere is 2/3; its deviation here 0.24/√20000
        let mean = cosines.iter().sum::<f64>() / 20_000.0;
        assert!((mean - 2.0 / 3.0).abs() < 0.007, "{mean}");
    }
}
