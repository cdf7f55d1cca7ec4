//! Measures how fast hierarchies are built, and how good they are: `cargo run --release -p lancer-trace --example build`.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program that measures")]

use lancer_scene::{DVec3, Mesh, MeshGeometry, Object, Placement, Scene, Shape};
use lancer_trace::{BuildStats, World};
use std::f64::consts::PI;
use std::sync::Arc;

fn noise(x: u32) -> f64 {
    let mut x = x;
    x = (x ^ x >> 16).wrapping_mul(0x7feb_352d);
    x = (x ^ x >> 15).wrapping_mul(0x846c_a68b);
    f64::from((x ^ x >> 16) & 0xffff) / 65536.0 - 0.5
}

/// A rough height field of `2·n²` facets.
fn field(n: u32) -> MeshGeometry {
    let at = |place: u32| (place % (n + 1), place / (n + 1));
    let position = |place: u32| {
        let (i, j) = at(place);
        let (x, z) = (f64::from(i) / f64::from(n), f64::from(j) / f64::from(n));
        let rough = noise(i.wrapping_mul(7919).wrapping_add(j.wrapping_mul(104_729)));
        let y = 0.12 * (9.0 * x + 1.0).sin() * (7.0 * z).cos() + 0.04 * (31.0 * x + 17.0 * z).sin();
        DVec3::new(x, y + 0.3 / f64::from(n) * rough, z)
    };
    let facets = |cell: u32| {
        let a = cell / n * (n + 1) + cell % n;
        [[a, a + n + 1, a + 1], [a + 1, a + n + 1, a + n + 2]]
    };
    MeshGeometry {
        positions: (0..(n + 1) * (n + 1)).map(position).collect(),
        facets: (0..n * n).flat_map(facets).collect(),
        ..MeshGeometry::default()
    }
}

/// A sphere of `4·n·(n-1)` facets.
fn sphere(n: u32) -> MeshGeometry {
    let m = 2 * n;
    let position = |place: u32| {
        let (a, b) = (PI * f64::from(place / m) / f64::from(n), 2.0 * PI * f64::from(place % m) / f64::from(m));
        DVec3::new(a.sin() * b.cos(), a.cos(), a.sin() * b.sin())
    };
    let mut facets = Vec::new();
    for place in 0..n * m {
        let (i, j) = (place / m, place % m);
        let (a, b) = (place, i * m + (j + 1) % m);
        if i > 0 {
            facets.push([a, b, b + m]);
        }
        if i < n - 1 {
            facets.push([a, b + m, a + m]);
        }
    }
    MeshGeometry { positions: (0..(n + 1) * m).map(position).collect(), facets, ..MeshGeometry::default() }
}

/// Random facets of sizes from a point to a hundredth of the whole.
fn soup(n: u32) -> MeshGeometry {
    let random = |k: u32| DVec3::new(noise(k), noise(k ^ 0x5555_0000), noise(k ^ 0x00aa_aaaa));
    let position = |place: u32| {
        let size = 0.01 * (noise((place / 3) ^ 0x1234_5678) + 0.5).powi(4);
        random(place / 3) + random(place.wrapping_add(0x8000_0000)) * size
    };
    MeshGeometry {
        positions: (0..3 * n).map(position).collect(),
        facets: (0..n).map(|facet| [3 * facet, 3 * facet + 1, 3 * facet + 2]).collect(),
        ..MeshGeometry::default()
    }
}

/// What all threads of the process have worked, in seconds; only Linux tells.
fn worked() -> Option<f64> {
    let tasks = std::fs::read_dir("/proc/self/task").ok()?;
    let times = tasks.map(|task| {
        let text = std::fs::read_to_string(task.ok()?.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse::<f64>().ok()
    });
    times.sum::<Option<f64>>().map(|nanoseconds| nanoseconds * 1e-9)
}

fn main() {
    let times: u32 = std::env::args().nth(1).map_or(3, |times| times.parse().unwrap());
    for (name, geometry) in [
        ("height field 1M", field(724)),
        ("sphere 1M", sphere(501)),
        ("soup 1M", soup(1_000_000)),
        ("height field 4M", field(1448)),
        ("sphere 4M", sphere(1001)),
    ] {
        let mesh = Mesh { geometry: Arc::new(geometry), source: None, placement: Placement::default(), smooth: false };
        let scene = Scene { objects: [Object::new(name, Shape::Mesh(mesh))].into_iter().collect(), ..Scene::default() };
        let mut best = (f64::INFINITY, f64::INFINITY, BuildStats::default());
        for _ in 0..times {
            let before = worked();
            let world = World::compile(&scene);
            let work = before.zip(worked()).map_or(f64::NAN, |(before, after)| after - before);
            let stats = world.build_stats();
            best = (best.0.min(stats.build.as_secs_f64()), best.1.min(work), stats);
        }
        let (time, work, stats) = best;
        let facets = stats.facets as f64;
        println!(
            "{name}: {:.0} ms, {:.2} Mfacets/s, {:.2} Mfacets per second of work; {:.1} + {:.1} bytes a facet; cost {:.3}",
            time * 1e3,
            facets / time * 1e-6,
            facets / work * 1e-6,
            stats.node_bytes as f64 / facets,
            stats.leaf_bytes as f64 / facets,
            stats.cost
        );
    }
}
