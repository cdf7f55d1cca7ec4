//! What is legal: the strategy of arbitrary scenes keeps the rules, and checking a scene is as cheap as it is large.

mod arbitrary;

use arbitrary::{Extent, scene, stage};
use lancer_scene::{
    DVec3, Invalid, MaterialRef, Mesh, MeshGeometry, Name, Object, Part, Placement, Scene, Shape, Surface,
};
use proptest::prelude::*;
use std::sync::Arc;

proptest! {
    #[test]
    fn arbitrary_scenes_are_legal(stage in stage(), contained in scene(Extent::SelfContained)) {
        prop_assert_eq!(stage.scene.check(), Ok(()));
        prop_assert_eq!(contained.check(), Ok(()));
        for view in &stage.views {
            prop_assert_eq!(view.check(), Ok(()));
        }
    }
}

fn instances(count: usize, geometry: MeshGeometry) -> Scene {
    let geometry = Arc::new(geometry);
    let instance = |number| {
        let geometry = Arc::clone(&geometry);
        let mesh = Mesh { geometry, source: None, placement: Placement::default(), smooth: false };
        Object::new(format!("instance {number}"), Shape::Mesh(mesh))
    };
    Scene { objects: (0..count).map(instance).collect(), ..Scene::default() }
}

/// 10⁵ instances of 10⁵ facets: looked at once each, not 10¹⁰ times.
#[test]
fn geometry_that_objects_share_is_checked_once() {
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
    let parts = (0..100_000).map(|first| Part { material: MaterialRef::Default, first, count: 1 }).collect();
    let facets = vec![[0, 1, 2]; 100_000];
    let scene = instances(100_000, MeshGeometry { positions, facets, parts, ..MeshGeometry::default() });
    assert_eq!(scene.check(), Ok(()));
}

/// The first object that has the geometry answers for it.
#[test]
fn every_rule_of_a_shared_geometry_is_still_kept() {
    let geometry = MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
        facets: vec![[0, 1, 2]],
        ..MeshGeometry::default()
    };
    let part = |material| vec![Part { material, first: 0, count: 1 }];
    let too_bright = Surface { kd: lancer_scene::Rgb::splat(2.0), ..Surface::default() };
    let broken = [
        (
            MeshGeometry { facets: vec![[0, 1, 3]], ..geometry.clone() },
            Invalid::FacetVertex { facet: 0, vertex: 3, vertices: 3 },
        ),
        (
            MeshGeometry { parts: part(MaterialRef::Named("red".into())), ..geometry.clone() },
            Invalid::UnknownMaterial { name: "red".into() },
        ),
        (
            MeshGeometry { parts: part(MaterialRef::Inline(Arc::new(too_bright))), ..geometry },
            Invalid::OutOfRange { field: "kd", value: 2.0, min: 0.0, max: 1.0 },
        ),
    ];
    for (geometry, rule) in broken {
        assert_eq!(instances(3, geometry).check(), Err((Some(Name::from("instance 0")), rule)));
    }
}
