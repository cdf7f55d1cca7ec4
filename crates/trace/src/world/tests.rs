//! What must hold of a compiled world: an updated one is the compiled one, and what stays is not made again.

use super::*;
use crate::Ray;
use crate::bvh::Bounds;
use crate::reference::intersect::intersect_facet;
use glam::DVec3;
use lancer_scene::{
    Edit, Enclosure, List, ListEdit, Material, MaterialRef, Mesh, MeshGeometry, Object, Part, Placement, PointLight,
    Rgb, Shape, Stage,
};
use proptest::prelude::*;

/// A wavy sheet of `2·n²` facets over the unit square, in two parts.
fn sheet(n: u32) -> Arc<MeshGeometry> {
    let side = n + 1;
    let position = |place: u32| {
        let (x, z) = (f64::from(place % side) / f64::from(n), f64::from(place / side) / f64::from(n));
        DVec3::new(x, 0.1 * (7.0 * x + 3.0 * z).fract(), z)
    };
    let corner = |cell: u32| cell / n * side + cell % n;
    let facets = |cell| [[0, side, 1], [1, side, side + 1]].map(|facet| facet.map(|step| corner(cell) + step));
    Arc::new(MeshGeometry {
        positions: (0..side * side).map(position).collect(),
        facets: (0..n * n).flat_map(facets).collect(),
        parts: vec![Part { material: MaterialRef::Named("b".into()), first: 3, count: n }],
        ..MeshGeometry::default()
    })
}

fn tetrahedron() -> Arc<MeshGeometry> {
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Z, DVec3::Y];
    let facets = vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
    Arc::new(MeshGeometry { positions, facets, ..MeshGeometry::default() })
}

fn mesh(geometry: &Arc<MeshGeometry>, placement: Placement, smooth: bool) -> Shape {
    Shape::Mesh(Mesh { geometry: Arc::clone(geometry), source: None, placement, smooth })
}

fn at(x: f64, y: f64, z: f64) -> Placement {
    Placement { position: DVec3::new(x, y, z), ..Placement::default() }
}

fn stage() -> Stage {
    let (sheet, tetrahedron) = (sheet(9), tetrahedron());
    let shapes = [
        mesh(&sheet, Placement::default(), false),
        mesh(&sheet, Placement { rotation: DVec3::new(10.0, 20.0, 30.0), ..at(0.5, 1.0, 0.0) }, true),
        mesh(&tetrahedron, Placement { scale: DVec3::new(-1.0, 2.0, 0.5), ..at(1.0, 0.0, 1.0) }, false),
        // this placement distorts so much that the vertices are baked
        mesh(&tetrahedron, Placement { scale: DVec3::new(1.0, 1e-6, 1e3), ..at(0.0, -0.5, 0.0) }, false),
        Shape::Sphere { center: DVec3::new(0.5, 0.5, 0.5), radius: 0.3 },
        Shape::Plane { p0: DVec3::NEG_Y, p1: DVec3::new(0.0, -1.0, 1.0), p2: DVec3::new(1.0, -1.0, 0.0) },
        Shape::Cube { center: DVec3::new(-0.5, 0.2, 0.3), edge: 0.5, rotation: DVec3::new(0.0, 30.0, 0.0) },
        Shape::Parallelepiped { origin: DVec3::ONE, edges: [DVec3::X, DVec3::new(0.1, 0.5, 0.0), DVec3::Z] },
        Shape::Facet { p0: DVec3::X * 2.0, p1: DVec3::Y, p2: DVec3::Z },
        Shape::Cone { base: DVec3::NEG_ONE, top: DVec3::Y, base_radius: 0.4, top_radius: 0.1, capped: true },
    ];
    let mut stage = Stage::default();
    let glass = Surface { kt: Rgb::splat(0.5), ..Surface::default() };
    stage.scene.materials = [("a", Surface::default()), ("b", glass)]
        .map(|(name, surface)| Material { name: name.into(), surface })
        .into_iter()
        .collect::<List<Material>>();
    stage.scene.lights = [PointLight::new("lamp", DVec3::Y * 3.0)].into_iter().collect::<List<PointLight>>();
    let objects = shapes.into_iter().enumerate().map(|(number, shape)| {
        let material = MaterialRef::Named(if number % 3 == 0 { "b" } else { "a" }.into());
        Object { material, ..Object::new(format!("object {number}"), shape) }
    });
    stage.scene.objects = objects.collect::<List<Object>>();
    assert_eq!(stage.scene.check(), Ok(()));
    stage
}

/// An edit that some number stands for, wherever it is possible.
fn edit(stage: &Stage, kind: u8, place: usize, amount: f64) -> Edit {
    let scene = &stage.scene;
    let index = place % scene.objects.len();
    let object = Object::clone(&scene.objects[index]);
    let set = |item: Object| Edit::Objects(ListEdit::Set { index, item: Arc::new(item) });
    match kind % 11 {
        0 => Edit::World(Environment { ambient: Rgb::splat(amount), ..scene.world.clone() }),
        1 => {
            let item = PointLight::new("lamp", DVec3::splat(amount * 5.0));
            Edit::Lights(ListEdit::Set { index: 0, item: Arc::new(item) })
        }
        2 | 3 => {
            let index = place % scene.materials.len();
            let mut item = Material::clone(&scene.materials[index]);
            match kind % 11 {
                2 => item.surface.ka = Rgb::splat(amount),
                _ => item.surface.kt = Rgb::splat(if amount < 0.5 { 0.0 } else { amount }),
            }
            Edit::Materials(ListEdit::Set { index, item: Arc::new(item) })
        }
        4 => {
            let index = place % scene.materials.len();
            let name = format!("material {amount}").into();
            let item = Arc::new(Material { name, ..Material::clone(&scene.materials[index]) });
            Edit::Materials(ListEdit::Set { index, item })
        }
        5 => set(Object { visible: !object.visible, ..object }),
        6 => set(Object { material: MaterialRef::Inline(Arc::default()), ..object }),
        7 => Edit::Objects(ListEdit::Move { from: index, to: (place / 16) % scene.objects.len() }),
        8 if scene.objects.len() > 3 => Edit::Objects(ListEdit::Remove { index }),
        9 => {
            let name = format!("copy {amount}").into();
            Edit::Objects(ListEdit::Insert { index, item: Arc::new(Object { name, ..object }) })
        }
        _ => {
            let shift = DVec3::new(amount - 0.5, 0.1, 0.0);
            let shape = match object.shape {
                Shape::Mesh(mut mesh) => {
                    mesh.placement.position += shift;
                    Shape::Mesh(mesh)
                }
                Shape::Sphere { center, radius } => Shape::Sphere { center: center + shift, radius },
                Shape::Cube { center, edge, rotation } => Shape::Cube { center: center + shift, edge, rotation },
                Shape::Parallelepiped { origin, edges } => Shape::Parallelepiped { origin: origin + shift, edges },
                Shape::Cone { base, top, base_radius, top_radius, capped } => {
                    Shape::Cone { base: base + shift, top: top + shift, base_radius, top_radius, capped }
                }
                shape @ (Shape::Plane { .. } | Shape::Facet { .. }) => shape,
            };
            set(Object { shape, ..object })
        }
    }
}

fn rays() -> impl Iterator<Item = Ray> {
    (0..60).map(|n| {
        let n = f64::from(n);
        let origin = DVec3::new(3.0 * (n * 0.7).sin(), 2.0 * (n * 1.3).cos(), 3.0 * (n * 0.9).cos());
        let target = DVec3::new((n * 0.37).fract(), (n * 0.61).fract() - 0.2, (n * 0.83).fract());
        Ray { origin, direction: (target - origin).normalize() }
    })
}

/// Whether two worlds are one to every ray.
fn assert_same(a: &World, b: &World) {
    assert_eq!(a.environment(), b.environment());
    assert_eq!(a.surfaces, b.surfaces);
    assert_eq!(a.lamps().len(), b.lamps().len());
    for (a, b) in a.lamps().iter().zip(b.lamps()) {
        assert_eq!((&a.name, a.position, a.color), (&b.name, b.position, b.color));
    }
    assert_eq!((a.bodies.len(), a.unbounded()), (b.bodies.len(), b.unbounded()));
    for (a, b) in a.bodies.iter().zip(b.bodies.iter()) {
        assert_eq!((&a.name, a.surface, a.medium, a.extent), (&b.name, b.surface, b.medium, b.extent));
        assert_eq!(a.geometry.bounds(), b.geometry.bounds());
        if let (Geometry::Facets(a), Geometry::Facets(b)) = (&a.geometry, &b.geometry) {
            for facet in 0..a.len() {
                assert_eq!(a.corners(facet), b.corners(facet));
                assert_eq!((a.surface(facet), a.normals(facet)), (b.surface(facet), b.normals(facet)));
            }
        }
    }
    for ray in rays() {
        assert_eq!(a.nearest(&ray, None), b.nearest(&ray, None));
        let media = |world: &World| Media::around(world, ray.origin);
        assert_eq!(media(a), media(b));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    /// After any edits, there and back, the updated world is the compiled one.
    #[test]
    fn an_updated_world_is_the_compiled_one(
        edits in prop::collection::vec((any::<u8>(), any::<usize>(), 0.0..1.0), 1..12),
    ) {
        let mut stage = stage();
        let mut world = World::compile(&stage.scene);
        let mut inverses = Vec::new();
        for (kind, place, amount) in edits {
            let Ok((next, inverse)) = stage.apply(&edit(&stage, kind, place, amount)) else { continue };
            inverses.push(inverse);
            stage = next;
            world = world.update(&stage.scene);
            assert!(world.is_of(&stage.scene));
            assert_same(&world, &World::compile(&stage.scene));
        }
        for inverse in inverses.into_iter().rev() {
            stage = stage.apply(&inverse).unwrap().0;
            world = world.update(&stage.scene);
        }
        assert_same(&world, &World::compile(&stage.scene));
    }
}

fn spread(least: i32, most: i32) -> impl Strategy<Value = f64> {
    (f64::from(least)..f64::from(most), any::<bool>()).prop_map(|(power, negative)| {
        let size = 10.0_f64.powf(power);
        if negative { -size } else { size }
    })
}

proptest! {
    /// Wherever a mesh stands and however it is turned and stretched, every facet that a ray hits is visited: the way
    /// to the geometry and back loses no hit.
    #[test]
    fn no_hit_is_lost_on_the_way_to_the_geometry(
        scale in [spread(-3, 3), spread(-3, 3), spread(-3, 3)],
        rotation in [-180.0..180.0, -180.0..180.0, -180.0..180.0],
        position in [spread(-3, 6), spread(-3, 6), spread(-3, 6)],
        start in [-3.0..3.0, -3.0..3.0, -3.0..3.0],
        aims in prop::collection::vec((0..162_u32, 0.0..1.0, 0.0..1.0), 20),
    ) {
        let placement =
            Placement { scale: scale.into(), rotation: DVec3::from(rotation), position: DVec3::from(position) };
        let object = Object::new("sheet", mesh(&sheet(9), placement, false));
        let world = World::compile(&Scene { objects: [object].into_iter().collect(), ..Scene::default() });
        let Geometry::Facets(facets) = &world.body(0).geometry else { panic!("facets") };
        let bounds = facets.bounds().unwrap();
        let corners = (0..facets.len()).flat_map(|facet| facets.corners(facet));
        prop_assert_eq!(Some(bounds), corners.map(|corner| Bounds { low: corner, high: corner }).reduce(Bounds::union));
        let origin = bounds.center() + DVec3::from(start) * (bounds.high - bounds.low);
        for (facet, a, b) in aims {
            let (a, b): (f64, f64) = (a, b);
            // into a facet, onto its edges and corners, and past it
            let [p0, p1, p2] = facets.corners(facet);
            let target = p0 + (p1 - p0) * (1.5 * a).min(1.0) + (p2 - p0) * (b - 0.2).max(0.0);
            let ray = Ray { origin, direction: (target - origin).normalize() };
            let mut visited = std::collections::BTreeSet::new();
            facets.visit(&ray, f64::INFINITY, |facet, limit| {
                visited.insert(facet);
                limit
            });
            for facet in 0..facets.len() {
                let [p0, p1, p2] = facets.corners(facet);
                if intersect_facet(&ray, p0, p1, p2).is_some() {
                    prop_assert!(visited.contains(&facet), "{facet}");
                }
            }
        }
    }
}

fn packed(world: &World, body: usize) -> &Arc<packed::Packed> {
    match &world.bodies[body].geometry {
        Geometry::Facets(facets) => facets.packed(),
        Geometry::Sphere { .. } | Geometry::Plane { .. } | Geometry::Cone(_) => panic!("no facets"),
    }
}

#[test]
fn what_did_not_change_is_not_made_again() {
    let stage = stage();
    let world = World::compile(&stage.scene);
    assert!(Arc::ptr_eq(packed(&world, 0), packed(&world, 1)), "one geometry, one hierarchy");
    assert!(!Arc::ptr_eq(packed(&world, 2), packed(&world, 3)), "baked vertices have their own");
    let updated = |edit: Edit| world.update(&stage.apply(&edit).unwrap().0.scene);
    let same_packs = |other: &World, bodies: &[usize]| {
        bodies.iter().all(|&body| Arc::ptr_eq(packed(&world, body), packed(other, body)))
    };
    let facets = [0, 1, 2, 3, 6, 7, 8];

    // world and lamp: nothing at all
    for kind in [0, 1] {
        let other = updated(edit(&stage, kind, 0, 0.7));
        assert!(Arc::ptr_eq(&world.bodies, &other.bodies) && Arc::ptr_eq(&world.top, &other.top));
    }
    // a material's colour: the surfaces
    let other = updated(edit(&stage, 2, 0, 0.7));
    assert!(Arc::ptr_eq(&world.bodies, &other.bodies) && Arc::ptr_eq(&world.top, &other.top));
    assert_eq!(other.surface(1).ka, Rgb::splat(0.7));
    // its transparency, its name, an object's material: who has which surface, no hierarchy
    for (kind, place) in [(3, 0), (4, 0), (4, 1), (6, 1), (6, 6)] {
        let other = updated(edit(&stage, kind, place, 0.7));
        assert!(Arc::ptr_eq(&world.top, &other.top), "{kind} {place}");
        let renamed = kind == 4 && place == 1; // the name stands in the parts of the sheet, which is a new one then
        assert!(same_packs(&other, if renamed { &facets[2..] } else { &facets }), "{kind} {place}");
    }
    // an object that moves: the top level
    for place in [0, 1, 2, 4] {
        let other = updated(edit(&stage, 10, place, 0.7));
        assert!(!Arc::ptr_eq(&world.top, &other.top));
        assert!(same_packs(&other, &facets), "{place}");
    }
    // the order of objects
    let other = updated(Edit::Objects(ListEdit::Move { from: 0, to: 6 }));
    assert!(Arc::ptr_eq(packed(&other, 6), packed(&world, 0)) && Arc::ptr_eq(packed(&other, 5), packed(&world, 6)));
}

#[test]
fn undo_finds_what_lives_elsewhere() {
    let before = stage();
    let world = World::compile(&before.scene);
    let removed = |stage: &Stage| {
        (0..2).fold(stage.clone(), |stage, _| stage.apply(&Edit::Objects(ListEdit::Remove { index: 0 })).unwrap().0)
    };
    let first = Arc::clone(packed(&world, 0));
    let mut later = world.update(&removed(&before).scene);
    drop(world);
    // an edit on the way
    let after = removed(&before);
    later = later.update(&after.apply(&edit(&after, 5, 1, 0.0)).unwrap().0.scene);
    assert!(Arc::ptr_eq(packed(&later.update(&before.scene), 0), &first), "the history holds the scene: it is undone");

    // nobody holds it: its memory is given back
    let geometry = Arc::downgrade(first.geometry());
    drop((before, first));
    later = later.update(&after.scene);
    drop(later.update(&Scene::default()));
    assert!(geometry.upgrade().is_none());
}

#[test]
fn a_closed_mesh_turns_with_a_mirroring_placement() {
    let world = World::compile(&stage().scene);
    assert_eq!(packed(&world, 2).enclosure(), Enclosure::Volume { inverted: false });
    let mut stage = stage();
    stage = stage.apply(&edit(&stage, 3, 0, 0.8)).unwrap().0;
    assert_eq!(world.update(&stage.scene).body(2).extent, Extent::Volume { inverted: true });
}

#[test]
fn the_cost_counts_a_geometry_once() {
    let stats = World::compile(&stage().scene).build_stats();
    // the sheet, the tetrahedron and the baked one, a cube, a box and a facet
    assert_eq!(stats.facets, 162 + 4 + 4 + 12 + 12 + 1);
    assert_eq!((stats.node_bytes % 224, stats.leaf_bytes % 160, stats.top_bytes % 224), (0, 0, 0));
    assert!(stats.leaf_bytes >= 160 * 195 / 4 && stats.top_bytes > 0);
    assert_eq!(World::default().build_stats(), BuildStats::default());
}

/// Facets that name vertices which are not there, as a checked scene has none: they are left out.
#[test]
fn facets_without_vertices_are_left_out() {
    let mut geometry = MeshGeometry::clone(&tetrahedron());
    geometry.facets[2] = [0, 1, 9];
    let glass = MaterialRef::Inline(Arc::new(Surface { kt: Rgb::WHITE, ..Surface::default() }));
    let object = Object { material: glass, ..Object::new("m", mesh(&Arc::new(geometry), at(0.0, 0.0, 0.0), true)) };
    let world = World::compile(&Scene { objects: [object].into_iter().collect(), ..Scene::default() });
    assert_eq!((packed(&world, 0).len(), world.body(0).extent), (2, Extent::Sheet));
    assert!(rays().filter(|ray| world.nearest(ray, None).is_some()).count() > 0);
}
