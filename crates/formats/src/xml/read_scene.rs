//! The reader of native scene documents: a scene, and everything that is wrong with the document.

use super::contents::{contents, no_contents};
use super::fields::{Fields, Stands};
use super::naming::AutomaticNames;
use super::read_mesh::{self, MeshElements};
use super::root::{DocumentKind, check_root};
use super::sink::Sink;
use super::vocabulary::{ElementRule, LIGHT, MATERIAL, SCENE, WORLD};
use super::{Document, Element, Excerpt, StructureProblem};
use crate::mesh::MeshFiles;
use crate::{Outcome, Span};
use lancer_scene::{
    Compose, Environment, Highlight, Material, MaterialRef, MeshGeometry, Name, NameKind, Object, PointLight,
    Reflectance, Scene, Shape, Surface,
};
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::sync::Arc;

/// Reads a native scene. `files` gives the meshes that it names.
pub fn read_scene(document: &Document, files: &mut dyn MeshFiles) -> Outcome<Scene> {
    let mut sink = Sink::new(document);
    let scene = SceneReader::read(document, files, &mut sink).map(|read| read.scene);
    sink.finish(scene)
}

/// A scene with the elements that its parts were read from, in the order of its lists.
pub(super) struct ReadScene<'d> {
    pub(super) scene: Scene,
    pub(super) world: Option<Element<'d>>,
    pub(super) materials: Vec<Element<'d>>,
    pub(super) lights: Vec<Element<'d>>,
    pub(super) objects: Vec<Element<'d>>,
}

/// What the reader has found so far.
pub(super) struct SceneReader<'d, 's, 'f> {
    pub(super) sink: &'s mut Sink<'d>,
    pub(super) files: &'f mut dyn MeshFiles,
    /// Every material and every name of an object or a lamp, with the place where it stands first.
    materials: HashMap<Name, Span>,
    names: HashMap<Name, Span>,
    /// The uses of materials that do not stand further up, checked when all materials are known.
    references: Vec<(Name, Span)>,
    /// The geometries of files that keep the rules: many objects may show one.
    pub(super) sound: HashMap<*const MeshGeometry, Arc<MeshGeometry>>,
}

impl<'d> SceneReader<'d, '_, '_> {
    /// The scene as far as it could be read; some items may be missing where problems were found.
    pub(super) fn read(
        document: &'d Document,
        files: &mut dyn MeshFiles,
        sink: &mut Sink<'d>,
    ) -> Option<ReadScene<'d>> {
        if !check_root(document, DocumentKind::Scene, sink) {
            return None;
        }
        let root = document.root();
        let (materials, names) = (HashMap::new(), HashMap::new());
        let mut reader = SceneReader { sink, files, materials, names, references: Vec::new(), sound: HashMap::new() };
        let fields = Fields::read(root, &SCENE, Stands::AtRoot, reader.sink);
        let name = fields.text_of("name").map(|(name, _)| name.to_owned()).unwrap_or_default();

        let mut world: Option<(Element<'d>, Option<Environment>)> = None;
        let mut materials = Vec::new();
        let mut lights = Vec::new();
        let mut objects = Vec::new();
        for (rule, element) in contents(root, &SCENE, reader.sink) {
            match rule.name {
                "world" => world = Some((element, reader.world(element))),
                "material" => materials.push((element, reader.material(element))),
                "light" => lights.push((element, reader.light(element))),
                _ => objects.push((element, reader.object(element, rule))),
            }
        }
        reader.check_references();

        let (mut taken, mut automatic) = (Some(reader.names), None);
        let mut free_name = |stem| {
            let names = || AutomaticNames::new(taken.take().unwrap_or_default().into_keys());
            automatic.get_or_insert_with(names).next(stem)
        };
        let mut named = |name: Option<Name>, stem| name.unwrap_or_else(|| free_name(stem));
        let lights = lights.into_iter().map(|(element, light)| {
            Some((element, light.map(|(name, light)| PointLight { name: named(name, "light"), ..light })?))
        });
        let lights: Vec<_> = lights.collect::<Option<_>>()?;
        let objects = objects.into_iter().map(|(element, object)| {
            let name_object = |(name, object): (Option<Name>, Object)| {
                let name = named(name, object.shape.element());
                Object { name, ..object }
            };
            Some((element, object.map(name_object)?))
        });
        let objects: Vec<_> = objects.collect::<Option<_>>()?;
        let materials: Vec<_> =
            materials.into_iter().map(|(element, material)| Some((element, material?))).collect::<Option<_>>()?;
        let world_element = world.as_ref().map(|(element, _)| *element);
        let world = world.map_or(Some(Environment::default()), |(_, world)| world)?;
        Some(ReadScene {
            world: world_element,
            materials: materials.iter().map(|(element, _)| *element).collect(),
            lights: lights.iter().map(|(element, _)| *element).collect(),
            objects: objects.iter().map(|(element, _)| *element).collect(),
            scene: Scene {
                name,
                world,
                materials: materials.into_iter().map(|(_, material)| material).collect(),
                lights: lights.into_iter().map(|(_, light)| light).collect(),
                objects: objects.into_iter().map(|(_, object)| object).collect(),
            },
        })
    }

    fn world(&mut self, element: Element<'d>) -> Option<Environment> {
        let fields = Fields::read(element, &WORLD, Stands::Within, self.sink);
        no_contents(element, &WORLD, self.sink);
        let world = Environment {
            ambient: fields.color("ambient")?,
            background: fields.color("background")?,
            index: fields.color("index")?,
            depth: fields.integer("depth")?,
            compose: among(Compose::ALL, Compose::word, fields.word("compose")?)?,
        };
        let rule = world.check();
        fields.checked(world, rule, self.sink)
    }

    fn material(&mut self, element: Element<'d>) -> Option<Material> {
        let fields = Fields::read(element, &MATERIAL, Stands::Within, self.sink);
        no_contents(element, &MATERIAL, self.sink);
        let name = fields.text_of("name").map(|(name, span)| (Name::from(name), span));
        if let Some((name, span)) = &name {
            claim(&mut self.materials, name, *span, NameKind::Material, self.sink);
        }
        let material = Material { name: name?.0, surface: surface(&fields)? };
        let rule = material.check();
        fields.checked(material, rule, self.sink)
    }

    /// An inline material.
    fn inline(&mut self, element: Element<'d>) -> Option<Arc<Surface>> {
        let fields = Fields::read(element, &MATERIAL, Stands::Inline, self.sink);
        no_contents(element, &MATERIAL, self.sink);
        let surface = surface(&fields)?;
        let rule = surface.check();
        fields.checked(Arc::new(surface), rule, self.sink)
    }

    fn light(&mut self, element: Element<'d>) -> Option<(Option<Name>, PointLight)> {
        let fields = Fields::read(element, &LIGHT, Stands::Within, self.sink);
        no_contents(element, &LIGHT, self.sink);
        let name = self.object_name(&fields);
        let light = PointLight {
            name: name.clone().unwrap_or_else(|| LIGHT.name.into()),
            position: fields.point("position")?,
            color: fields.color("color")?,
            visible: fields.flag("visible")?,
        };
        let rule = light.check();
        fields.checked((name, light), rule, self.sink)
    }

    fn object(&mut self, element: Element<'d>, rule: &'static ElementRule) -> Option<(Option<Name>, Object)> {
        let fields = Fields::read(element, rule, Stands::Within, self.sink);
        let name = self.object_name(&fields);
        let mut elements = MeshElements::default();
        let mut inline = None;
        for (rule, child) in contents(element, rule, self.sink) {
            match rule.name {
                "material" => inline = Some(child),
                _ => elements.add(rule, child),
            }
        }
        let material = self.material_of(&fields, inline, rule);
        let has_material = material != Some(MaterialRef::Default);
        let shape = match rule.name {
            "mesh" => read_mesh::mesh(self, element, &fields, &elements, has_material),
            _ => simple_shape(&fields, rule, self.sink),
        };
        let (material, shape) = (material?, shape?);
        let unnamed = || shape.element().into();
        let visible = fields.flag("visible")?;
        let object = Object { name: name.clone().unwrap_or_else(unnamed), material, visible, shape };
        Some((name, object))
    }

    /// The name of an object or a lamp, which no other may have.
    fn object_name(&mut self, fields: &Fields<'d>) -> Option<Name> {
        let (name, span) = fields.text_of("name")?;
        let name = Name::from(name);
        claim(&mut self.names, &name, span, NameKind::ObjectOrLight, self.sink);
        Some(name)
    }

    /// The material of an object or a part: a name, an inline one, or neither.
    pub(super) fn material_of(
        &mut self,
        fields: &Fields<'d>,
        inline: Option<Element<'d>>,
        rule: &'static ElementRule,
    ) -> Option<MaterialRef> {
        let named = fields.text_of("material").map(|(name, span)| self.reference(name, span));
        match (named, inline) {
            (None, None) => Some(MaterialRef::Default),
            (Some(name), None) => Some(MaterialRef::Named(name)),
            (None, Some(element)) => self.inline(element).map(MaterialRef::Inline),
            (Some(_), Some(element)) => {
                self.sink.error(element.name_span(), StructureProblem::TwoMaterials { element: rule.name });
                self.inline(element);
                None
            }
        }
    }

    /// The name of a material. One that does not stand further up is looked up at the end.
    fn reference(&mut self, name: &str, span: Span) -> Name {
        if let Some((known, _)) = self.materials.get_key_value(name) {
            return known.clone();
        }
        let name = Name::from(name);
        self.references.push((name.clone(), span));
        name
    }

    /// Every material that is named must exist.
    fn check_references(&mut self) {
        const LISTED: usize = 8;
        let mut known: Vec<(&Name, &Span)> = self.materials.iter().collect();
        known.sort_unstable_by_key(|(_, span)| span.start);
        for (name, span) in self.references.iter().filter(|(name, _)| !self.materials.contains_key(name)) {
            if self.sink.is_full() {
                break;
            }
            let guess = self.sink.guess(name, known.iter().map(|(name, _)| &***name));
            let known = known.iter().take(LISTED).map(|(name, _)| Excerpt::new(name)).collect();
            self.sink.error(*span, StructureProblem::UnknownMaterial { name: Excerpt::new(name), guess, known });
        }
    }
}

/// Takes a name, which must be free.
pub(super) fn claim(taken: &mut HashMap<Name, Span>, name: &Name, span: Span, kind: NameKind, sink: &mut Sink<'_>) {
    match taken.entry(name.clone()) {
        Entry::Vacant(free) => drop(free.insert(span)),
        Entry::Occupied(first) => {
            let line = sink.line(first.get().start);
            sink.error(span, StructureProblem::NameTaken { kind, name: Excerpt::new(name), line });
        }
    }
}

fn surface(fields: &Fields<'_>) -> Option<Surface> {
    Some(Surface {
        ka: fields.color("ka")?,
        kd: fields.color("kd")?,
        ks: fields.color("ks")?,
        w: among(Reflectance::ALL, Reflectance::word, fields.word("w")?)?,
        shininess: fields.color("n")?,
        kr: fields.color("kr")?,
        kt: fields.color("kt")?,
        index: fields.color("index")?,
        highlight: among(Highlight::ALL, Highlight::word, fields.word("highlight")?)?,
    })
}

/// The choice that a word of the vocabulary means.
fn among<T: Copy, const N: usize>(all: [T; N], word: fn(T) -> &'static str, found: &str) -> Option<T> {
    all.into_iter().find(|choice| word(*choice) == found)
}

/// Every shape but a mesh.
fn simple_shape(fields: &Fields<'_>, rule: &'static ElementRule, sink: &mut Sink<'_>) -> Option<Shape> {
    let points = || Some((fields.point("p0")?, fields.point("p1")?, fields.point("p2")?));
    let shape = match rule.name {
        "sphere" => Shape::Sphere { center: fields.point("center")?, radius: fields.number("radius")? },
        "plane" => points().map(|(p0, p1, p2)| Shape::Plane { p0, p1, p2 })?,
        "facet" => points().map(|(p0, p1, p2)| Shape::Facet { p0, p1, p2 })?,
        "cube" => {
            let (center, edge) = (fields.point("center")?, fields.number("edge")?);
            Shape::Cube { center, edge, rotation: fields.point("rotation")? }
        }
        "cone" => Shape::Cone {
            base: fields.point("base")?,
            top: fields.point("top")?,
            base_radius: fields.number("base-radius")?,
            top_radius: fields.number("top-radius")?,
            capped: fields.flag("capped")?,
        },
        _ => {
            let edges = [fields.point("u")?, fields.point("v")?, fields.point("w")?];
            Shape::Parallelepiped { origin: fields.point("origin")?, edges }
        }
    };
    let rule = shape.check();
    fields.checked(shape, rule, sink)
}
