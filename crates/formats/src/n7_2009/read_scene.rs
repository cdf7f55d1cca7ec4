//! The reader of `Scene` documents.

use super::reader::{
    AMBIENT, CUBE, DIFFUSE, FACET, FACETS, LAMP, MATERIAL, OBJECT, PLANE, REFLECTION, REFRACTION, Reader, Rule, SCENE,
    SPECULAR, SPHERE,
};
use super::{DEPTH, N7Problem, Points, UNIT, lone_facet};
use crate::Outcome;
use crate::xml::{AutomaticNames, Document, Element};
use lancer_scene::{
    Color, DVec3, Environment, MaterialRef, Mesh, MeshGeometry, Object, Placement, PointLight, Rgb, Scene, Shape,
    Surface, limits,
};
use std::collections::HashMap;
use std::sync::Arc;

/// Reads a scene of 2009.
pub fn read_scene(document: &Document) -> Outcome<Scene> {
    let mut reader = Reader::new(document);
    let scene = reader.check_root(document.root(), SCENE.name).then(|| reader.scene(document.root())).flatten();
    reader.sink.finish(scene)
}

impl<'d> Reader<'d> {
    fn scene(&mut self, root: Element<'d>) -> Option<Scene> {
        let mut names = AutomaticNames::new([]);
        let (mut lights, mut objects, mut colours) = (Vec::new(), Vec::new(), Vec::new());
        for (name, element) in self.open(root, &SCENE) {
            match name {
                "ObjetGraphique" => objects.push(self.object(element)),
                "Source" => lights.push(self.lamp(element)),
                _ => colours.push((element, self.colour(element))),
            }
        }
        let Some((last, colour)) = colours.pop() else {
            self.sink.error(root.name_span(), N7Problem::MissingElement { parent: SCENE.name, due: &["Couleur"] });
            return None;
        };
        let line = self.sink.line(last.span().start);
        for (earlier, _) in colours {
            self.sink.warning(earlier.name_span(), N7Problem::EarlierColour { line });
        }
        let mut named_light =
            |(position, color)| PointLight { color, ..PointLight::new(names.next("light"), position) };
        let lights = lights.into_iter().map(|light| Some(named_light(light?))).collect::<Option<_>>()?;
        let mut named_object = |(surface, shape): (Surface, Shape)| Object {
            name: names.next(shape.element()),
            material: MaterialRef::Inline(Arc::new(surface)),
            visible: true,
            shape,
        };
        let objects = objects.into_iter().map(|object| Some(named_object(object?))).collect::<Option<_>>()?;
        let (ambient, background) = (colour?, colour?);
        let world = Environment { ambient, background, depth: DEPTH, ..Environment::default() };
        Some(Scene { world, lights, objects, ..Scene::default() })
    }

    fn lamp(&mut self, element: Element<'d>) -> Option<(DVec3, Color)> {
        let within = self.open(element, &LAMP);
        let position = self.points((element, &LAMP), &within, Points::OfLamp);
        let colour = self.only((element, &LAMP), &within, &["Couleur"]).and_then(|colour| self.colour(colour));
        let [position] = position?;
        Some((position, colour?))
    }

    fn object(&mut self, element: Element<'d>) -> Option<(Surface, Shape)> {
        let within = self.open(element, &OBJECT);
        let surface = self.only((element, &OBJECT), &within, &["Matiere"]).and_then(|element| self.surface(element));
        let shape = self.only((element, &OBJECT), &within, &["Sphere", "Plan", "Cube", "ObjetFacette"]);
        let shape = shape.and_then(|element| self.shape(element));
        Some((surface?, shape?))
    }

    /// The surface of a `Matiere`. An element that is missing means black.
    fn surface(&mut self, element: Element<'d>) -> Option<Surface> {
        let within = self.open(element, &MATERIAL);
        let mut coefficient = |rule: &Rule| match self.at_most_one(&MATERIAL, &within, &[rule.name]) {
            Some(element) => {
                let colours = self.open(element, rule);
                let colour = self.only((element, rule), &colours, &["Couleur"]);
                colour.and_then(|colour| self.colour(colour))
            }
            None => Some(Rgb::BLACK),
        };
        let [ka, kd, ks, kr, kt] = [&AMBIENT, &DIFFUSE, &SPECULAR, &REFLECTION, &REFRACTION].map(&mut coefficient);
        let shininess = match within.iter().find(|(name, _)| *name == SPECULAR.name) {
            Some(&(_, specular)) => {
                let number = self.number_or(specular, "n", UNIT);
                number.map(|number| self.clamped(number, "n", 0.0, UNIT * limits::SHININESS) / UNIT)
            }
            None => Some(1.0),
        };
        let index = self.number_or(element, "n", UNIT);
        let (kt, index) = (kt?, index?);
        // Documents give 0 for what does not refract.
        let index = if index.value == 0.0 && kt == Rgb::BLACK {
            1.0
        } else if index.value < UNIT * limits::LEAST {
            self.sink.error(index.span, N7Problem::BadIndex { found: index.value });
            return None;
        } else {
            self.within(index, "n", UNIT * limits::LEAST, UNIT * limits::COORDINATE)? / UNIT
        };
        Some(Surface {
            ka: ka?,
            kd: kd?,
            ks: ks?,
            shininess: Rgb::splat(shininess?),
            kr: kr?,
            kt,
            index: Rgb::splat(index),
            ..Surface::default()
        })
    }

    fn shape(&mut self, element: Element<'d>) -> Option<Shape> {
        let shape = match element.name() {
            "Sphere" => {
                let within = self.open(element, &SPHERE);
                let center = self.points((element, &SPHERE), &within, Points::OfSphere);
                let radius = self.number(element, &SPHERE, "rayon");
                let radius = radius.and_then(|radius| self.within(radius, "rayon", limits::LEAST, limits::COORDINATE));
                let [center] = center?;
                Shape::Sphere { center, radius: radius? }
            }
            "Plan" => {
                let within = self.open(element, &PLANE);
                let [p0, p1, p2] = self.points((element, &PLANE), &within, Points::OfPlane)?;
                Shape::Plane { p0, p1, p2 }
            }
            "Cube" => {
                let within = self.open(element, &CUBE);
                let [origin, u, v, w] = self.points((element, &CUBE), &within, Points::OfBox)?;
                Shape::Parallelepiped { origin, edges: [u - origin, v - origin, w - origin] }
            }
            _ => return self.facets(element),
        };
        match shape.check() {
            Ok(()) => Some(shape),
            Err(rule) => {
                self.sink.error(element.name_span(), rule);
                None
            }
        }
    }

    /// A lone facet, or a mesh with its equal points made one.
    fn facets(&mut self, element: Element<'d>) -> Option<Shape> {
        let mut facets: Vec<Option<[DVec3; 3]>> = Vec::new();
        for (_, facet) in self.open(element, &FACETS) {
            let within = self.open(facet, &FACET);
            facets.push(self.points((facet, &FACET), &within, Points::OfFacet));
        }
        let facets = facets.into_iter().collect::<Option<Vec<_>>>()?;
        if let Some(facet) = lone_facet(&facets) {
            return Some(facet);
        }
        let mut geometry = MeshGeometry::default();
        let mut numbers = HashMap::new();
        for facet in facets {
            geometry.facets.push(facet.map(|point| {
                // Adding zero makes -0 and 0 the same place.
                *numbers.entry((point + DVec3::ZERO).to_array().map(f64::to_bits)).or_insert_with(|| {
                    geometry.positions.push(point);
                    geometry.positions.len() as u32 - 1
                })
            }));
        }
        let placement = Placement::default();
        Some(Shape::Mesh(Mesh { geometry: Arc::new(geometry), source: None, placement, smooth: false }))
    }
}
