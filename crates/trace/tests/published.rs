//! The rays of E. Haines' Standard Procedural Databases, as the table of his article counts them («A Proposal for
//! Standard Graphics Environments», IEEE CG&A 7(11), 1987): many programs have printed these numbers since.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lancer_scene::generate::Family;
use lancer_scene::{Screen, ScreenSpec, View};
use lancer_trace::{Camera, Cancel, RayCounts, Settings, Tracer, World};

/// The published counts: eye rays that hit, reflected, refracted and shadow rays.
struct Published {
    family: Family,
    hits: u64,
    reflected: u64,
    refracted: u64,
    shadow: u64,
}

const TABLE: [Published; 3] = [
    Published { family: Family::Sphereflake, hits: 263_169, reflected: 175_095, refracted: 0, shadow: 954_368 },
    Published { family: Family::Mountain, hits: 173_125, reflected: 354_769, refracted: 354_769, shadow: 412_922 },
    Published { family: Family::Tetrahedron, hits: 49_788, reflected: 0, refracted: 0, shadow: 46_112 },
];

/// The view whose 513×513 pixel centres are the corners of the given view's 512×512 pixels, as the table has it.
fn through_corners(view: &View) -> View {
    let Screen { origin, u, v } = view.resolved_screen().unwrap();
    let pixels = f64::from(view.width);
    let screen = Screen {
        origin: origin - (u + v) / (2.0 * pixels),
        u: u * ((pixels + 1.0) / pixels),
        v: v * ((pixels + 1.0) / pixels),
    };
    View { width: view.width + 1, height: view.height + 1, screen: ScreenSpec::Frame(screen), ..view.clone() }
}

#[test]
fn the_databases_cast_the_rays_of_the_published_table() {
    for published in TABLE {
        let (scene, view) = published.family.generate(published.family.usual_size()).unwrap();
        let view = through_corners(&view);
        let world = World::compile(&scene);
        let camera = Camera::new(&view).unwrap();
        let tracer = Tracer::new(&world, &camera, Settings::of(&world, &view), &Cancel::default());
        let mut counts = RayCounts::default();
        for j in 0..view.height {
            for i in 0..view.width {
                tracer.pixel(i, j, &mut counts).unwrap();
            }
        }
        assert_eq!(counts.primary, 513 * 513);
        for (found, expected) in [
            (counts.primary_hits, published.hits),
            (counts.reflected, published.reflected),
            (counts.refracted, published.refracted),
            (counts.shadow, published.shadow),
        ] {
            // a hundredth: rays along an edge or beyond the tables' own precision fall either way
            let slack = expected / 100;
            assert!(found.abs_diff(expected) <= slack, "{:?}: {counts:?}, published {expected}", published.family);
        }
    }
}
