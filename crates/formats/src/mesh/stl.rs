//! STL, the format of rapid prototyping: facets alone, as text or as bytes. Corners at equal places become one vertex.
//! The facets' normals are those of their corners, whatever the file says.

use super::words::{Words, number, quoted};
use super::{Builder, Input, MeshFault, MeshProblem};
use crate::progress;
use glam::DVec3;
use std::collections::HashMap;

/// The bytes before the facets of a binary file: a comment and the number of facets.
const HEADER: usize = 84;
/// The bytes of a facet: a normal, three corners, and two more.
const FACET: usize = 50;

pub(super) fn read(input: &Input<'_>) -> Result<Builder, MeshProblem> {
    let mut reader = Reader { builder: Builder::new(input.bytes.len()), places: HashMap::new() };
    // Some binary files begin like a text; their length gives them away.
    match facets(input.bytes) {
        Some(facets) if input.bytes.len() == HEADER + FACET * facets => {
            reader.bytes(&input.bytes[HEADER..]).map_err(|fault| input.at(None, fault))?;
        }
        _ if input.bytes.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid")) => {
            reader.text(input)?;
        }
        Some(facets) => {
            let body = &input.bytes[HEADER..];
            let body = facets.checked_mul(FACET).and_then(|size| body.get(..size));
            let body = body.ok_or_else(|| input.at(None, MeshFault::EndsEarly))?;
            reader.bytes(body).map_err(|fault| input.at(None, fault))?;
        }
        None => return Err(input.at(None, MeshFault::EndsEarly)),
    }
    Ok(reader.builder)
}

/// How many facets a binary file says it has.
fn facets(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(HEADER - 4..HEADER)?.first_chunk()?;
    usize::try_from(u32::from_le_bytes(*count)).ok()
}

struct Reader {
    builder: Builder,
    /// The vertex at each place.
    places: HashMap<[u64; 3], u32>,
}

impl Reader {
    fn vertex(&mut self, position: DVec3) -> Result<u32, MeshFault> {
        // Adding zero makes -0 and 0 the same place.
        let place = position.to_array().map(|coordinate| (coordinate + 0.0).to_bits());
        if let Some(&vertex) = self.places.get(&place) {
            return Ok(vertex);
        }
        let vertex = self.builder.vertex(position)?;
        self.places.insert(place, vertex);
        Ok(vertex)
    }

    fn bytes(&mut self, body: &[u8]) -> Result<(), MeshFault> {
        // A closed mesh has half as many vertices as facets.
        self.places.reserve(body.len() / FACET / 2);
        for (number, facet) in body.as_chunks::<FACET>().0.iter().enumerate() {
            progress::now_and_then(number, || number * FACET);
            let mut corners = [0; 3];
            for (corner, bytes) in corners.iter_mut().zip(facet[12..48].as_chunks::<12>().0) {
                let coordinate = |at: usize| {
                    let bytes = [bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]];
                    f64::from(f32::from_le_bytes(bytes))
                };
                *corner = self.vertex(DVec3::new(coordinate(0), coordinate(4), coordinate(8)))?;
            }
            self.builder.polygon(&corners)?;
        }
        Ok(())
    }

    fn text(&mut self, input: &Input<'_>) -> Result<(), MeshProblem> {
        let mut words = Words::new(input.bytes, 1);
        self.solids(&mut words).map_err(|fault| input.at(words.line, fault))
    }

    /// The bodies of a text file, one after another; a name ends with its line.
    fn solids(&mut self, words: &mut Words<'_>) -> Result<(), MeshFault> {
        while let Some(word) = words.next() {
            expect(Some(word), "solid")?;
            words.skip_line();
            loop {
                let word = words.next().ok_or(MeshFault::EndsEarly)?;
                if word.eq_ignore_ascii_case(b"endsolid") {
                    words.skip_line();
                    break;
                }
                expect(Some(word), "facet")?;
                self.facet(words)?;
            }
        }
        Ok(())
    }

    /// A facet behind its first word.
    fn facet(&mut self, words: &mut Words<'_>) -> Result<(), MeshFault> {
        expect(words.next(), "normal")?;
        for _ in 0..3 {
            words.next().ok_or(MeshFault::EndsEarly)?;
        }
        expect(words.next(), "outer")?;
        expect(words.next(), "loop")?;
        let mut corners = [0; 3];
        for corner in &mut corners {
            expect(words.next(), "vertex")?;
            let mut coordinates = [0.0; 3];
            for coordinate in &mut coordinates {
                *coordinate = number(words.next().ok_or(MeshFault::EndsEarly)?)?;
            }
            *corner = self.vertex(coordinates.into())?;
        }
        expect(words.next(), "endloop")?;
        expect(words.next(), "endfacet")?;
        self.builder.polygon(&corners).map(drop)
    }
}

fn expect(word: Option<&[u8]>, due: &'static str) -> Result<(), MeshFault> {
    match word {
        None => Err(MeshFault::EndsEarly),
        Some(word) if word.eq_ignore_ascii_case(due.as_bytes()) => Ok(()),
        Some(word) => Err(MeshFault::Unexpected { found: quoted(word), due }),
    }
}
