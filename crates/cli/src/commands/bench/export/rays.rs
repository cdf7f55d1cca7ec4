//! The four sets of rays of a scene as numbers, little-endian, with what they meet: `lancer rays 1\n\n\n`, then for the
//! primary, shadow, reflected and diffuse rays in turn how many there are in 64 bits, and for each ray eight numbers of 32
//! bits: its origin, its direction, its length (infinite but for shadow rays), the distance of what it meets (infinite if
//! it is nothing; of a shadow ray 0 if it is blocked).

use super::super::cast;
use super::super::rays::RaySets;
use lancer_trace::{Ray, World};
use rayon::ThreadPool;
use std::io::{self, BufWriter, Write};

/// What the rays of each set meet, as it is written.
pub(super) struct Met([Vec<f64>; 4]);

impl Met {
    pub(super) fn new(world: &World, sets: &RaySets, pool: &ThreadPool) -> Met {
        let blocked = cast::blocked(world, sets.shadow.lamp, &sets.shadow.points, pool);
        Met([
            cast::distances(world, &sets.primary, pool),
            blocked.into_iter().map(|blocked| if blocked { 0.0 } else { f64::INFINITY }).collect(),
            cast::distances(world, &sets.reflected, pool),
            cast::distances(world, &sets.diffuse, pool),
        ])
    }
}

pub(super) fn write(
    sets: &RaySets,
    Met([primary, shadow, reflected, diffuse]): &Met,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    out.write_all(b"lancer rays 1\n\n\n")?;
    write_set(&mut out, endless(&sets.primary), primary)?;
    write_set(&mut out, sets.shadow.rays(), shadow)?;
    write_set(&mut out, endless(&sets.reflected), reflected)?;
    write_set(&mut out, endless(&sets.diffuse), diffuse)?;
    out.flush()
}

/// Rays that end nowhere.
fn endless(rays: &[Ray]) -> impl Iterator<Item = (Ray, f64)> {
    rays.iter().map(|ray| (*ray, f64::INFINITY))
}

fn write_set(out: &mut impl Write, rays: impl Iterator<Item = (Ray, f64)>, met: &[f64]) -> io::Result<()> {
    out.write_all(&(met.len() as u64).to_le_bytes())?;
    for ((ray, length), met) in rays.zip(met) {
        let numbers = [ray.origin.to_array(), ray.direction.to_array()].concat();
        for number in numbers.into_iter().chain([length, *met]) {
            out.write_all(&(number as f32).to_le_bytes())?;
        }
    }
    Ok(())
}
