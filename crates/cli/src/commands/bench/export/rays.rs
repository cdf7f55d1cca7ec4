//! The four sets of rays of a scene as numbers, little-endian, with what they meet: `lancer rays 1\n\n\n`, then for the
//! primary, shadow, reflected and diffuse rays in turn how many there are in 64 bits, and for each ray eight numbers of 32
//! bits: its origin, its direction, its length (infinite but for shadow rays), the distance of what it meets (infinite if
//! it is nothing; of a shadow ray 0 if it is blocked).

use super::super::cast;
use super::super::rays::RaySets;
use lancer_trace::{Ray, World};
use rayon::ThreadPool;
use std::io::{self, BufWriter, Write};

pub(super) fn write(world: &World, sets: &RaySets, pool: &ThreadPool, out: &mut dyn Write) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    out.write_all(b"lancer rays 1\n\n\n")?;
    let nearest = |out: &mut BufWriter<_>, rays: &[Ray]| {
        let distances = cast::distances(world, rays, pool);
        write_set(out, rays.len(), rays.iter().map(|ray| (*ray, f64::INFINITY)), distances)
    };
    nearest(&mut out, &sets.primary)?;
    let blocked = cast::blocked(world, sets.shadow.lamp, &sets.shadow.points, pool);
    let met = blocked.into_iter().map(|blocked| if blocked { 0.0 } else { f64::INFINITY });
    write_set(&mut out, sets.shadow.points.len(), sets.shadow.rays(), met)?;
    nearest(&mut out, &sets.reflected)?;
    nearest(&mut out, &sets.diffuse)?;
    out.flush()
}

fn write_set(
    out: &mut impl Write,
    count: usize,
    rays: impl Iterator<Item = (Ray, f64)>,
    met: impl IntoIterator<Item = f64>,
) -> io::Result<()> {
    out.write_all(&(count as u64).to_le_bytes())?;
    for ((ray, length), met) in rays.zip(met) {
        let numbers = [ray.origin.to_array(), ray.direction.to_array()].concat();
        for number in numbers.into_iter().chain([length, met]) {
            out.write_all(&(number as f32).to_le_bytes())?;
        }
    }
    Ok(())
}
