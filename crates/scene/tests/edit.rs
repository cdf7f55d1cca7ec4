//! Edits: each has an inverse, shares what it does not touch, and changes nothing where it is refused.

#![allow(clippy::unwrap_used, reason = "the helpers of tests may panic")]

mod arbitrary;

use arbitrary::{Extent, light, material, object, scene, stage, view, world};
use lancer_scene::{
    DVec3, Edit, EditError, Environment, Invalid, List, ListEdit, Material, MaterialRef, Mesh, MeshGeometry, Name,
    NameKind, Object, Part, Placement, PointLight, Rgb, Scene, Shape, Stage, Surface, View,
};
use proptest::prelude::*;
use proptest::sample::Index;
use std::sync::Arc;

/// What somebody may want to do to a list; places and names are found when the list is known.
#[derive(Clone, Debug)]
enum Wish<T> {
    Set(Index, T),
    /// Changes the item at a place but keeps its name.
    Restyle(Index, T),
    Insert(Index, T),
    Remove(Index),
    Move(Index, Index),
}

#[derive(Clone, Debug)]
enum StageWish {
    Title(String),
    World(Environment),
    Materials(Wish<Material>),
    Lights(Wish<PointLight>),
    /// The second index picks the material among those that there are.
    Objects(Wish<Object>, Index),
    Views(Wish<View>),
    Batch(Vec<StageWish>),
}

fn wish<T: Clone + std::fmt::Debug + 'static>(
    item: impl Strategy<Value = T> + 'static,
) -> impl Strategy<Value = Wish<T>> {
    let item = item.boxed();
    prop_oneof![
        (any::<Index>(), item.clone()).prop_map(|(at, item)| Wish::Set(at, item)),
        (any::<Index>(), item.clone()).prop_map(|(at, item)| Wish::Restyle(at, item)),
        (any::<Index>(), item).prop_map(|(at, item)| Wish::Insert(at, item)),
        any::<Index>().prop_map(Wish::Remove),
        any::<[Index; 2]>().prop_map(|[from, to]| Wish::Move(from, to)),
    ]
}

fn stage_wish() -> impl Strategy<Value = StageWish> {
    let geometries = vec![Arc::new(two_parts())];
    let single = prop_oneof![
        ".{0,5}".prop_map(StageWish::Title),
        world().prop_map(StageWish::World),
        wish(material()).prop_map(StageWish::Materials),
        wish(light()).prop_map(StageWish::Lights),
        (wish(object(vec![], geometries, Extent::Whole)), any::<Index>())
            .prop_map(|(wish, material)| StageWish::Objects(wish, material)),
        wish(view()).prop_map(StageWish::Views),
    ];
    single.prop_recursive(2, 12, 4, |inner| prop::collection::vec(inner, 0..4).prop_map(StageWish::Batch))
}

fn list_edit<T: Clone>(wish: &Wish<T>, list: &List<T>, name: impl Fn(&mut T) -> &mut Name) -> ListEdit<T> {
    // An empty list is asked for its first item: an edit that must be refused.
    let place = |index: &Index| if list.is_empty() { 0 } else { index.index(list.len()) };
    match wish {
        Wish::Set(at, item) => ListEdit::Set { index: place(at), item: Arc::new(item.clone()) },
        Wish::Restyle(at, item) => {
            let mut item = item.clone();
            if let Some(old) = list.get(place(at)) {
                *name(&mut item) = name(&mut T::clone(old)).clone();
            }
            ListEdit::Set { index: place(at), item: Arc::new(item) }
        }
        Wish::Insert(at, item) => ListEdit::Insert { index: at.index(list.len() + 1), item: Arc::new(item.clone()) },
        Wish::Remove(at) => ListEdit::Remove { index: place(at) },
        Wish::Move(from, to) => ListEdit::Move { from: place(from), to: place(to) },
    }
}

/// The edit that a wish means for a stage. In a batch each wish sees the stage that the ones before it leave.
fn edit(wish: &StageWish, stage: &Stage) -> Edit {
    match wish {
        StageWish::Title(title) => Edit::Title(title.clone()),
        StageWish::World(world) => Edit::World(world.clone()),
        StageWish::Materials(wish) => {
            Edit::Materials(list_edit(wish, &stage.scene.materials, |material| &mut material.name))
        }
        StageWish::Lights(wish) => Edit::Lights(list_edit(wish, &stage.scene.lights, |light| &mut light.name)),
        StageWish::Objects(wish, material) => {
            let mut edit = list_edit(wish, &stage.scene.objects, |object| &mut object.name);
            if let ListEdit::Set { item, .. } | ListEdit::Insert { item, .. } = &mut edit
                && !stage.scene.materials.is_empty()
            {
                Arc::make_mut(item).material = MaterialRef::Named(material.get(&stage.scene.materials).name.clone());
            }
            Edit::Objects(edit)
        }
        StageWish::Views(wish) => Edit::Views(list_edit(wish, &stage.views, |view| &mut view.name)),
        StageWish::Batch(wishes) => {
            let mut stage = stage.clone();
            Edit::Batch(
                wishes
                    .iter()
                    .map(|wish| {
                        let edit = edit(wish, &stage);
                        if let Ok((next, _)) = stage.apply(&edit) {
                            stage = next;
                        }
                        edit
                    })
                    .collect(),
            )
        }
    }
}

proptest! {
    #[test]
    fn an_edit_and_its_inverse_are_the_identity(
        mut stage in stage(),
        wishes in prop::collection::vec(stage_wish(), 1..6),
    ) {
        for wish in wishes {
            let edit = edit(&wish, &stage);
            let before = stage.clone();
            match stage.apply(&edit) {
                Ok((next, inverse)) => {
                    prop_assert_eq!(next.scene.check(), Ok(()), "an edit must keep the scene legal: {:?}", edit);
                    let (back, again) = next.apply(&inverse).unwrap();
                    prop_assert_eq!(&back, &stage, "edit {:?}\ninverse {:?}", edit, inverse);
                    // The inverse of the inverse does what the edit did.
                    prop_assert_eq!(&back.apply(&again).unwrap().0, &next);
                    stage = next;
                }
                Err(_) => prop_assert_eq!(&stage, &before),
            }
        }
    }

    #[test]
    fn every_list_that_an_edit_does_not_name_is_shared(stage in stage(), wish in stage_wish()) {
        let edit = edit(&wish, &stage);
        let Ok((next, _)) = stage.apply(&edit) else { return Ok(()) };
        let touched = |of: fn(&Edit) -> bool| of(&edit) || matches!(&edit, Edit::Batch(_));
        let (old, new) = (&stage.scene, &next.scene);
        if !touched(|edit| matches!(edit, Edit::Materials(_))) {
            prop_assert!(old.materials.same_items(&new.materials));
        }
        if !touched(|edit| matches!(edit, Edit::Lights(_))) {
            prop_assert!(old.lights.same_items(&new.lights));
        }
        // A material that is renamed changes the objects that name it.
        if !touched(|edit| matches!(edit, Edit::Objects(_) | Edit::Materials(_))) {
            prop_assert!(old.objects.same_items(&new.objects));
        }
        if !touched(|edit| matches!(edit, Edit::Views(_))) {
            prop_assert!(stage.views.same_items(&next.views));
        }
    }

    #[test]
    fn scenes_survive_the_removal_of_everything(scene in scene(Extent::Whole)) {
        let full = Stage { scene, ..Stage::default() };
        let first = |count, edit: fn() -> Edit| std::iter::repeat_with(edit).take(count).collect::<Vec<_>>();
        let mut edits = first(full.scene.objects.len(), || Edit::Objects(ListEdit::Remove { index: 0 }));
        edits.extend(first(full.scene.materials.len(), || Edit::Materials(ListEdit::Remove { index: 0 })));
        edits.extend(first(full.scene.lights.len(), || Edit::Lights(ListEdit::Remove { index: 0 })));
        let (empty, inverse) = full.apply(&Edit::Batch(edits)).unwrap();
        prop_assert!(empty.scene.objects.is_empty() && empty.scene.materials.is_empty());
        prop_assert_eq!(empty.apply(&inverse).unwrap().0, full);
    }
}

/// A mesh whose first facet is red and whose second has the object's own material.
fn two_parts() -> MeshGeometry {
    MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
        facets: vec![[0, 1, 2], [0, 2, 1]],
        parts: vec![Part { material: MaterialRef::Default, first: 0, count: 1 }],
        ..MeshGeometry::default()
    }
}

fn red_mesh(material: &str) -> Shape {
    let mut geometry = two_parts();
    geometry.parts[0].material = MaterialRef::Named(material.into());
    let placement = Placement::default();
    Shape::Mesh(Mesh { geometry: Arc::new(geometry), source: None, placement, smooth: false })
}

fn ball(name: &str, material: MaterialRef) -> Object {
    Object { material, ..Object::new(name, Shape::Sphere { center: DVec3::ZERO, radius: 1.0 }) }
}

fn named(name: &str) -> MaterialRef {
    MaterialRef::Named(name.into())
}

fn paint(name: &str) -> Material {
    Material { name: name.into(), surface: Surface::default() }
}

/// Materials red and blue; a red ball, a blue ball, a grey flag with a red part, a lamp.
fn small_stage() -> Stage {
    let objects =
        [ball("red ball", named("red")), ball("blue ball", named("blue")), Object::new("flag", red_mesh("red"))];
    Stage {
        scene: Scene {
            materials: [paint("red"), paint("blue")].into_iter().collect(),
            lights: [PointLight::new("lamp", DVec3::ONE)].into_iter().collect(),
            objects: objects.into_iter().collect(),
            ..Scene::default()
        },
        ..Stage::default()
    }
}

fn refusal(edit: Edit) -> EditError {
    let stage = small_stage();
    // Also as the last of a batch: what the batch did before is undone with it.
    let batch = Edit::Batch(vec![Edit::Title("new".into()), edit.clone()]);
    let errors = [&edit, &batch].map(|edit| stage.apply(edit).unwrap_err());
    assert_eq!(stage, small_stage());
    let [error, in_batch] = errors;
    assert_eq!(error, in_batch);
    error
}

#[test]
fn renaming_a_material_renames_it_where_it_is_used() {
    let stage = small_stage();
    let rename = Edit::Materials(ListEdit::Set { index: 0, item: Arc::new(paint("crimson")) });
    let (next, inverse) = stage.apply(&rename).unwrap();
    let [red, blue, flag] = &next.scene.objects[..] else { panic!() };
    assert_eq!(red.material, named("crimson"));
    assert_eq!(flag.shape, red_mesh("crimson"));
    assert!(Arc::ptr_eq(blue, &stage.scene.objects[1]), "who does not name it is shared");
    assert_eq!(stage, small_stage(), "the snapshot before the edit is as it was");
    assert_eq!(next.apply(&inverse).unwrap().0, stage);
}

#[test]
fn instances_still_share_their_geometry_when_a_part_is_renamed() {
    let scene = small_stage().scene;
    let twin = Object { name: "twin".into(), ..Object::clone(&scene.objects[2]) };
    let scene = Scene { objects: scene.objects.with(|objects| objects.push(Arc::new(twin))), ..scene };
    let stage = Stage { scene, ..Stage::default() };
    let rename = Edit::Materials(ListEdit::Set { index: 0, item: Arc::new(paint("crimson")) });
    let (next, _) = stage.apply(&rename).unwrap();
    let [flag, twin] = [2, 3].map(|at| next.scene.objects[at].shape.geometry().unwrap());
    assert_eq!(flag.parts[0].material, named("crimson"));
    assert!(Arc::ptr_eq(flag, twin));
}

#[test]
fn restyling_a_material_shares_all_objects() {
    let stage = small_stage();
    let mut restyled = paint("red");
    restyled.surface.kr = Rgb::WHITE;
    let (next, _) = stage.apply(&Edit::Materials(ListEdit::Set { index: 0, item: Arc::new(restyled) })).unwrap();
    assert!(next.scene.objects.same_items(&stage.scene.objects));
    assert!(Arc::ptr_eq(&next.scene.materials[1], &stage.scene.materials[1]));
}

#[test]
fn moving_a_mesh_shares_its_geometry() {
    let stage = small_stage();
    let mut flag = Object::clone(&stage.scene.objects[2]);
    let Shape::Mesh(mesh) = &mut flag.shape else { panic!() };
    mesh.placement.position = DVec3::X;
    let (next, _) = stage.apply(&Edit::Objects(ListEdit::Set { index: 2, item: Arc::new(flag) })).unwrap();
    let geometry = |stage: &Stage| Arc::as_ptr(stage.scene.objects[2].shape.geometry().unwrap());
    assert_eq!(geometry(&next), geometry(&stage));
    assert!(Arc::ptr_eq(&next.scene.objects[0], &stage.scene.objects[0]));
}

#[test]
fn moves_go_where_they_say() {
    let names = |stage: &Stage| stage.scene.objects.iter().map(|object| object.name.to_string()).collect::<Vec<_>>();
    let moved = |from, to| {
        let (next, inverse) = small_stage().apply(&Edit::Objects(ListEdit::Move { from, to })).unwrap();
        assert_eq!(next.apply(&inverse).unwrap().0, small_stage());
        names(&next)
    };
    assert_eq!(moved(0, 2), ["blue ball", "flag", "red ball"]);
    assert_eq!(moved(2, 0), ["flag", "red ball", "blue ball"]);
    assert_eq!(moved(1, 1), ["red ball", "blue ball", "flag"]);
}

#[test]
fn places_that_do_not_exist_are_refused() {
    let item = || Arc::new(ball("new", MaterialRef::Default));
    for edit in [
        ListEdit::Set { index: 3, item: item() },
        ListEdit::Remove { index: 3 },
        ListEdit::Move { from: 3, to: 0 },
        ListEdit::Move { from: 0, to: 3 },
    ] {
        assert_eq!(refusal(Edit::Objects(edit)), EditError::NoSuchItem { index: 3, len: 3 });
    }
    let behind = Edit::Objects(ListEdit::Insert { index: 4, item: item() });
    assert_eq!(refusal(behind), EditError::NoSuchItem { index: 4, len: 3 });
    let views = Edit::Views(ListEdit::Remove { index: 0 });
    let error = refusal(views);
    assert_eq!(error, EditError::NoSuchItem { index: 0, len: 0 });
    assert_eq!(error.to_string(), "there is no item 0 in a list of 0");
}

#[test]
fn names_that_are_taken_are_refused() {
    let taken = |name: &str, kind| EditError::Invalid(Invalid::NameTaken { name: name.into(), kind });
    let object = |name| Arc::new(ball(name, MaterialRef::Default));
    let lamp = |name| Arc::new(PointLight::new(name, DVec3::ZERO));
    let material = |name| Arc::new(paint(name));
    let of_both = NameKind::ObjectOrLight;
    let insert = |name| Edit::Objects(ListEdit::Insert { index: 0, item: object(name) });
    assert_eq!(refusal(insert("flag")), taken("flag", of_both));
    assert_eq!(refusal(insert("lamp")), taken("lamp", of_both));
    assert_eq!(refusal(Edit::Objects(ListEdit::Set { index: 0, item: object("flag") })), taken("flag", of_both));
    assert_eq!(refusal(Edit::Lights(ListEdit::Set { index: 0, item: lamp("flag") })), taken("flag", of_both));
    assert_eq!(refusal(Edit::Lights(ListEdit::Insert { index: 1, item: lamp("lamp") })), taken("lamp", of_both));
    let blue = Edit::Materials(ListEdit::Set { index: 0, item: material("blue") });
    assert_eq!(refusal(blue), taken("blue", NameKind::Material));
    // The name that the edit itself replaces is free, and materials do not share names with objects.
    assert!(small_stage().apply(&Edit::Objects(ListEdit::Set { index: 2, item: object("flag") })).is_ok());
    assert!(small_stage().apply(&Edit::Materials(ListEdit::Insert { index: 0, item: material("flag") })).is_ok());
}

#[test]
fn materials_in_use_stay_and_unknown_ones_are_refused() {
    let in_use = |name: &str, user: &str| EditError::MaterialInUse { name: name.into(), user: user.into() };
    let remove = |index| Edit::Materials(ListEdit::Remove { index });
    assert_eq!(refusal(remove(0)), in_use("red", "red ball"));
    assert_eq!(refusal(remove(1)), in_use("blue", "blue ball"));
    // A part of a mesh counts, too.
    let without_ball = Edit::Batch(vec![Edit::Objects(ListEdit::Remove { index: 0 }), remove(0)]);
    assert_eq!(refusal(without_ball), in_use("red", "flag"));
    let unknown = EditError::Invalid(Invalid::UnknownMaterial { name: "green".into() });
    for object in [ball("new", named("green")), Object::new("new", red_mesh("green"))] {
        assert_eq!(refusal(Edit::Objects(ListEdit::Insert { index: 0, item: Arc::new(object) })), unknown);
    }
}

#[test]
fn illegal_items_are_refused() {
    let radius = Object::new("new", Shape::Sphere { center: DVec3::ZERO, radius: 0.0 });
    let rule = Invalid::OutOfRange { field: "radius", value: 0.0, min: 1e-9, max: 1e9 };
    assert_eq!(refusal(Edit::Objects(ListEdit::Insert { index: 0, item: Arc::new(radius) })), rule.into());

    let nameless = Object::new(" new", Shape::Sphere { center: DVec3::ZERO, radius: 1.0 });
    let bad_name = EditError::Invalid(Invalid::BadName);
    assert_eq!(refusal(Edit::Objects(ListEdit::Insert { index: 0, item: Arc::new(nameless) })), bad_name);

    let nowhere = PointLight::new("new", DVec3::new(0.0, f64::NAN, 0.0));
    let rule = Invalid::NotFinite { field: "position" };
    assert_eq!(refusal(Edit::Lights(ListEdit::Insert { index: 0, item: Arc::new(nowhere) })), rule.into());

    let mut dazzling = paint("red");
    dazzling.surface.kd = Rgb::new(0.0, 1.5, 0.0);
    let rule = Invalid::OutOfRange { field: "kd", value: 1.5, min: 0.0, max: 1.0 };
    assert_eq!(refusal(Edit::Materials(ListEdit::Set { index: 0, item: Arc::new(dazzling) })), rule.into());

    let deep = Environment { depth: 65, ..Environment::default() };
    let rule = Invalid::OutOfRange { field: "depth", value: 65.0, min: 0.0, max: 64.0 };
    assert_eq!(refusal(Edit::World(deep)), rule.into());
}

/// Two edits that would break a rule alone can be legal together, in the right order.
#[test]
fn a_batch_is_checked_step_by_step() {
    let add = Edit::Materials(ListEdit::Insert { index: 2, item: Arc::new(paint("green")) });
    let use_it = Edit::Objects(ListEdit::Set { index: 0, item: Arc::new(ball("red ball", named("green"))) });
    let (next, inverse) = small_stage().apply(&Edit::Batch(vec![add.clone(), use_it.clone()])).unwrap();
    assert_eq!(next.scene.objects[0].material, named("green"));
    assert_eq!(next.apply(&inverse).unwrap().0, small_stage());
    assert_eq!(
        refusal(Edit::Batch(vec![use_it, add])),
        EditError::Invalid(Invalid::UnknownMaterial { name: "green".into() })
    );
}
