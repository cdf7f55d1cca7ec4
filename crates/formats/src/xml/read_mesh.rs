//! Reads the meshes of a scene document: inline lists of numbers, or a file that the document names.

use super::contents::{contents, no_contents};
use super::fields::{Fields, Stands};
use super::number::MOST_FAULTS;
use super::read_scene::SceneReader;
use super::sink::Sink;
use super::vocabulary::{ElementRule, FACETS, MESH, NORMALS, PART, VERTICES};
use super::{Due, Element, Number, StructureProblem, ValueProblem, Written};
use crate::{Diagnostic, Span, progress};
use lancer_scene::{DVec3, Invalid, Mesh, MeshGeometry, Part, Placement, Shape, limits};
use std::sync::Arc;

/// The elements within a mesh.
#[derive(Default)]
pub(super) struct MeshElements<'d> {
    vertices: Option<Element<'d>>,
    normals: Option<Element<'d>>,
    facets: Option<Element<'d>>,
    parts: Vec<Element<'d>>,
}

impl<'d> MeshElements<'d> {
    pub(super) fn add(&mut self, rule: &'static ElementRule, element: Element<'d>) {
        match rule.name {
            "vertices" => self.vertices = Some(element),
            "normals" => self.normals = Some(element),
            "facets" => self.facets = Some(element),
            _ => self.parts.push(element),
        }
    }

    fn all(&self) -> impl Iterator<Item = (&'static ElementRule, Element<'d>)> {
        let lists = [(&VERTICES, self.vertices), (&NORMALS, self.normals), (&FACETS, self.facets)];
        let lists = lists.into_iter().filter_map(|(rule, element)| Some((rule, element?)));
        lists.chain(self.parts.iter().map(|part| (&PART, *part)))
    }
}

/// The mesh of an element. `has_material` says whether the object has a material, which replaces those of a file.
pub(super) fn mesh<'d>(
    reader: &mut SceneReader<'d, '_, '_>,
    element: Element<'d>,
    fields: &Fields<'d>,
    elements: &MeshElements<'d>,
    has_material: bool,
) -> Option<Shape> {
    let source = element.attribute("src");
    let geometry = if source.is_some() {
        let mut sound = true;
        for (rule, child) in elements.all() {
            reader.sink.error(child.name_span(), StructureProblem::BesideSource { name: rule.name });
            sound = false;
        }
        let (path, span) = fields.text_of("src").filter(|_| sound)?;
        from_file(reader, path, span, has_material)
    } else {
        inline(reader, element, elements).map(Arc::new)
    };
    // what is wrong with the placement is told whatever is wrong with the geometry
    let placed = placed(fields).and_then(|mesh| {
        let rule = Shape::Mesh(mesh.clone()).check_instance();
        fields.checked(mesh, rule, reader.sink)
    });
    let geometry = geometry?;
    // what a file holds is looked through once; there are few files, though many objects may show them
    if !reader.sound.contains_key(&Arc::as_ptr(&geometry)) {
        if let Err(rule) = geometry.check() {
            broken(&geometry, rule, fields, elements, reader.sink);
            return None;
        }
        if source.is_some() {
            reader.sound.insert(Arc::as_ptr(&geometry), Arc::clone(&geometry));
        }
    }
    placed.map(|mesh| Shape::Mesh(Mesh { geometry, ..mesh }))
}

/// The mesh that the attributes say, as yet without its geometry.
fn placed(fields: &Fields<'_>) -> Option<Mesh> {
    Some(Mesh {
        geometry: Arc::default(),
        source: fields.text_of("src").map(|(path, _)| path.into()),
        placement: Placement {
            scale: fields.point("scale")?,
            rotation: fields.point("rotation")?,
            position: fields.point("position")?,
        },
        smooth: fields.flag("smooth")?,
    })
}

/// Tells of each rule that a geometry breaks, `first` and those that are broken once what broke it is taken away.
fn broken(
    geometry: &MeshGeometry,
    first: Invalid,
    fields: &Fields<'_>,
    elements: &MeshElements<'_>,
    sink: &mut Sink<'_>,
) {
    let mut rest = geometry.clone();
    let mut parts: Vec<usize> = (0..rest.parts.len()).collect();
    let mut found = Some(first);
    for _ in 0..MOST_FAULTS {
        let span = match found {
            Some(Invalid::PartRange { part, facets }) => {
                rest.parts.remove(part);
                let part = parts.remove(part);
                found = Some(Invalid::PartRange { part, facets });
                elements.parts.get(part).and_then(|part| Some(part.attribute("facets")?.value_span))
            }
            Some(Invalid::NormalCount { .. }) => {
                rest.normals.clear();
                elements.normals.map(Element::name_span)
            }
            Some(rule) => {
                fields.checked((), Err(rule), sink);
                return;
            }
            None => return,
        };
        if let Some(rule) = found {
            sink.error(span.unwrap_or_else(|| fields.name_span()), rule);
        }
        found = rest.check().err();
    }
}

/// The geometry of a file; what is wrong with it is told where the document names it.
fn from_file(
    reader: &mut SceneReader<'_, '_, '_>,
    path: &str,
    span: Span,
    has_material: bool,
) -> Option<Arc<MeshGeometry>> {
    match reader.files.read(path) {
        Ok(file) => {
            file.warnings.iter().for_each(|warning| reader.sink.warning(span, warning.clone()));
            Some(if has_material { file.without_materials() } else { file.geometry })
        }
        Err(problem) => {
            reader.sink.error(span, problem);
            None
        }
    }
}

fn inline<'d>(
    reader: &mut SceneReader<'d, '_, '_>,
    element: Element<'d>,
    elements: &MeshElements<'d>,
) -> Option<MeshGeometry> {
    let (Some(vertices), Some(facets)) = (elements.vertices, elements.facets) else {
        let missing = |name, sample| StructureProblem::MissingElement { name, parent: MESH.name, sample };
        let problem = match (elements.vertices, elements.facets) {
            (None, Some(_)) => missing(VERTICES.name, "<vertices>0 0 0  1 0 0  0 1 0</vertices>"),
            (Some(_), None) => missing(FACETS.name, "<facets>0 1 2</facets>"),
            _ => StructureProblem::EmptyMesh,
        };
        reader.sink.error(element.name_span(), problem);
        return None;
    };
    let positions = coordinates(vertices, &VERTICES, reader.sink);
    let normals = elements.normals.map_or(Some(Vec::new()), |normals| coordinates(normals, &NORMALS, reader.sink));
    let facets = indices(facets, positions.as_ref().map(Vec::len), reader.sink);
    let parts: Vec<Option<Part>> = elements.parts.iter().map(|part| self::part(reader, *part)).collect();
    Some(MeshGeometry {
        positions: positions?,
        normals: normals?,
        facets: facets?,
        parts: parts.into_iter().collect::<Option<_>>()?,
    })
}

/// A run of facets with a material of its own.
fn part<'d>(reader: &mut SceneReader<'d, '_, '_>, element: Element<'d>) -> Option<Part> {
    let fields = Fields::read(element, &PART, Stands::Within, reader.sink);
    let inline = contents(element, &PART, reader.sink).first().map(|(_, child)| *child);
    let material = reader.material_of(&fields, inline, &PART)?;
    let (first, count) = fields.run("facets")?;
    Some(Part { material, first, count })
}

/// The triples of an element's numbers. Comments may stand anywhere between them.
fn coordinates<'d>(element: Element<'d>, rule: &'static ElementRule, sink: &mut Sink<'d>) -> Option<Vec<DVec3>> {
    let sound = Fields::read(element, rule, Stands::Within, sink).are_sound();
    no_contents(element, rule, sink);
    let (mut triples, mut triple, mut faults) = (Vec::new(), Triple::default(), 0);
    for text in element.texts() {
        let written = text.written();
        for number in written.numbers() {
            let (min, max) = (-limits::COORDINATE, limits::COORDINATE);
            let number = number.and_then(|Number { value, span }| match value {
                value if (min..=max).contains(&value) => Ok((value, span)),
                value => {
                    Err(Box::new(Diagnostic::error(span, Invalid::OutOfRange { field: rule.name, value, min, max })))
                }
            });
            match number {
                Ok((value, span)) => {
                    triples.extend(triple.push(value, span).map(DVec3::from));
                    progress::now_and_then(triples.len(), || span.end);
                }
                Err(fault) => tell(&mut faults, *fault, sink)?,
            }
        }
        if faults == 0 {
            triple.decimal_commas(&written, sink)?;
        }
    }
    if faults > 0 {
        return None;
    }
    triple.finish(triples.len(), element, sink)?;
    sound.then_some(triples)
}

/// Tells of a fault of a list; `None` once there are so many that no more are told.
fn tell(faults: &mut usize, fault: Diagnostic, sink: &mut Sink<'_>) -> Option<()> {
    sink.push(fault);
    *faults += 1;
    (*faults < MOST_FAULTS).then_some(())
}

/// The vertex numbers of an element by threes. `vertices` is how many there are, if that is known.
fn indices<'d>(element: Element<'d>, vertices: Option<usize>, sink: &mut Sink<'d>) -> Option<Vec<[u32; 3]>> {
    let sound = Fields::read(element, &FACETS, Stands::Within, sink).are_sound();
    no_contents(element, &FACETS, sink);
    let (mut facets, mut triple) = (Vec::new(), Triple::default());
    // a list that counts from 1 would give a fault for nearly every facet
    let (mut illegible, mut beyond) = (0, 0);
    for text in element.texts() {
        let written = text.written();
        let mut numbers = written.numbers();
        while let Some(index) = numbers.next_index() {
            let (vertex, span) = match index {
                Ok(index) => index,
                Err(fault) => {
                    let span = fault.span.unwrap_or_default();
                    tell(&mut illegible, *fault, sink)?;
                    (0, span)
                }
            };
            if let Some(vertices) = vertices.filter(|vertices| vertex as usize >= *vertices) {
                if beyond < MOST_FAULTS {
                    sink.error(span, Invalid::FacetVertex { facet: facets.len(), vertex, vertices });
                }
                beyond += 1;
            }
            facets.extend(triple.push(vertex, span));
            progress::now_and_then(facets.len(), || span.end);
        }
    }
    if illegible > 0 {
        return None;
    }
    triple.finish(facets.len(), element, sink)?;
    (sound && beyond == 0).then_some(facets)
}

/// Collects what comes by threes.
#[derive(Default)]
struct Triple<T> {
    values: [T; 3],
    count: usize,
    /// Where the numbers that are not yet three stand.
    span: Span,
}

impl<T: Copy + Default> Triple<T> {
    fn push(&mut self, value: T, span: Span) -> Option<[T; 3]> {
        self.span = if self.count == 0 { span } else { Span { start: self.span.start, end: span.end } };
        self.values[self.count] = value;
        self.count = (self.count + 1) % 3;
        (self.count == 0).then_some(self.values)
    }

    /// Numbers that do not go by threes because their decimals were written with commas.
    fn decimal_commas(&self, written: &Written<'_>, sink: &mut Sink<'_>) -> Option<()> {
        if self.count == 0 {
            return Some(());
        }
        let count = written.numbers().count();
        let fault = written.miscounted(count, Due::Triples);
        let commas =
            matches!(fault.problem, crate::Problem::Xml(super::XmlProblem::Value(ValueProblem::DecimalComma { .. })));
        if !commas {
            return Some(());
        }
        sink.push(*fault);
        None
    }

    /// No numbers may be left over.
    fn finish(&self, triples: usize, element: Element<'_>, sink: &mut Sink<'_>) -> Option<()> {
        if self.count == 0 {
            return Some(());
        }
        let span = if self.span.end > self.span.start { self.span } else { element.name_span() };
        let problem = ValueProblem::NumberCount { found: 3 * triples + self.count, due: Due::Triples };
        sink.push(Diagnostic::error(span, problem));
        None
    }
}
