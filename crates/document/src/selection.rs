//! What is selected: things by their names, which stay the same while lists change around them.

use lancer_scene::{Name, Stage};
use std::collections::HashMap;

/// Something that can be selected.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Item {
    /// Ambient light, background, medium, depth, composition.
    World,
    /// A lamp.
    Light(Name),
    /// An object.
    Object(Name),
    /// A material.
    Material(Name),
    /// A view.
    View(Name),
}

impl Item {
    /// The name; `None` for the world.
    pub fn name(&self) -> Option<&Name> {
        match self {
            Item::World => None,
            Item::Light(name) | Item::Object(name) | Item::Material(name) | Item::View(name) => Some(name),
        }
    }

    /// The place in its list; `None` if there is no such thing (and for the world).
    pub fn place(&self, stage: &Stage) -> Option<usize> {
        let scene = &stage.scene;
        match self {
            Item::World => None,
            Item::Light(name) => scene.lights.iter().position(|light| light.name == *name),
            Item::Object(name) => scene.objects.iter().position(|object| object.name == *name),
            Item::Material(name) => scene.materials.iter().position(|material| material.name == *name),
            Item::View(name) => stage.views.iter().position(|view| view.name == *name),
        }
    }

    /// Whether there is such a thing.
    pub fn exists(&self, stage: &Stage) -> bool {
        matches!(self, Item::World) || self.place(stage).is_some()
    }
}

/// The selected things in the order in which they were selected; the last one is shown in the properties.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection(Vec<Item>);

impl Selection {
    /// Selects one thing alone.
    pub fn only(item: Item) -> Selection {
        Selection(vec![item])
    }

    /// Adds a thing, or takes it out if it is there.
    pub fn toggle(&mut self, item: Item) {
        match self.0.iter().position(|known| *known == item) {
            Some(place) => drop(self.0.remove(place)),
            None => self.0.push(item),
        }
    }

    /// Selects several things.
    pub fn set(&mut self, items: impl IntoIterator<Item = Item>) {
        self.0 = items.into_iter().collect();
    }

    /// Selects nothing.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Whether the thing is selected.
    pub fn contains(&self, item: &Item) -> bool {
        self.0.contains(item)
    }

    /// The thing that was selected last.
    pub fn primary(&self) -> Option<&Item> {
        self.0.last()
    }

    /// The selected things.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &Item> {
        self.0.iter()
    }

    /// Whether nothing is selected.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Forgets what does not exist.
    pub(crate) fn prune(&mut self, stage: &Stage) {
        let places = Places::of(stage);
        self.0.retain(|item| places.have(item));
    }

    /// Follows a change of the stage: what has a new name in the same place stays selected, what is gone does not.
    pub(crate) fn follow(&mut self, old: &Stage, new: &Stage) {
        if self.0.is_empty() {
            return;
        }
        let places = Places::of(new);
        for item in &mut self.0 {
            if !places.have(item)
                && let Some(renamed) = renamed(item, old, new)
            {
                *item = renamed;
            }
        }
        self.0.retain(|item| places.have(item));
    }
}

/// The names of a stage and their places, to look up many things.
pub(crate) struct Places<'a> {
    objects: HashMap<&'a str, usize>,
    lights: HashMap<&'a str, usize>,
    materials: HashMap<&'a str, usize>,
    views: HashMap<&'a str, usize>,
}

impl<'a> Places<'a> {
    pub(crate) fn of(stage: &'a Stage) -> Places<'a> {
        fn places<'a>(names: impl Iterator<Item = &'a Name>) -> HashMap<&'a str, usize> {
            names.enumerate().map(|(place, name)| (&**name, place)).collect()
        }
        let scene = &stage.scene;
        Places {
            objects: places(scene.objects.iter().map(|object| &object.name)),
            lights: places(scene.lights.iter().map(|light| &light.name)),
            materials: places(scene.materials.iter().map(|material| &material.name)),
            views: places(stage.views.iter().map(|view| &view.name)),
        }
    }

    /// What [`Item::place`] gives.
    pub(crate) fn place(&self, item: &Item) -> Option<usize> {
        match item {
            Item::World => None,
            Item::Light(name) => self.lights.get(&**name).copied(),
            Item::Object(name) => self.objects.get(&**name).copied(),
            Item::Material(name) => self.materials.get(&**name).copied(),
            Item::View(name) => self.views.get(&**name).copied(),
        }
    }

    fn have(&self, item: &Item) -> bool {
        *item == Item::World || self.place(item).is_some()
    }
}

/// What a thing that is gone is called now: a list of the same length has a name in its place that was not there.
fn renamed(item: &Item, old: &Stage, new: &Stage) -> Option<Item> {
    let place = item.place(old)?;
    let now = match item {
        Item::World => None,
        Item::Light(_) => {
            let same = old.scene.lights.len() == new.scene.lights.len();
            new.scene.lights.get(place).filter(|_| same).map(|light| Item::Light(light.name.clone()))
        }
        Item::Object(_) => {
            let same = old.scene.objects.len() == new.scene.objects.len();
            new.scene.objects.get(place).filter(|_| same).map(|object| Item::Object(object.name.clone()))
        }
        Item::Material(_) => {
            let same = old.scene.materials.len() == new.scene.materials.len();
            new.scene.materials.get(place).filter(|_| same).map(|material| Item::Material(material.name.clone()))
        }
        Item::View(_) => {
            let same = old.views.len() == new.views.len();
            new.views.get(place).filter(|_| same).map(|view| Item::View(view.name.clone()))
        }
    };
    now.filter(|now| !now.exists(old))
}
