//! Wavefront OBJ: lines of vertices, normals and polygons, with materials from libraries beside the file.
//!
//! Texture coordinates, groups, lines, points and free-form surfaces are let pass, as is every word that is not known:
//! programs add their own.

use super::words::{Words, number, quoted};
use super::{Builder, Input, MeshFault, MeshProblem, mtl};
use crate::progress;
use glam::DVec3;
use lancer_scene::Surface;
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// A corner without a normal.
const NONE: u32 = u32::MAX;

pub(super) fn read(input: &mut Input<'_>) -> Result<Builder, MeshProblem> {
    let mut reader = Reader {
        builder: Builder::new(input.bytes.len()),
        normals: Vec::new(),
        facet_normals: Vec::new(),
        corners: Vec::new(),
        corner_normals: Vec::new(),
        materials: HashMap::new(),
        unknown: HashSet::new(),
    };
    let mut lines = Lines::of(input.bytes);
    while let Some((line, text)) = lines.next() {
        progress::now_and_then(line, || input.bytes.len() - lines.rest.len());
        let mut words = Words::new(&text, line);
        let Some(keyword) = words.next() else { continue };
        let result = match keyword {
            b"v" => point(keyword, words).and_then(|position| reader.builder.vertex(position).map(drop)),
            b"vn" => point(keyword, words).map(|normal| reader.normals.push(normal)),
            b"f" => reader.face(words),
            b"mtllib" => {
                reader.libraries(text[6..].trim_ascii(), line, input);
                Ok(())
            }
            b"usemtl" => {
                reader.use_material(text[6..].trim_ascii(), line, input);
                Ok(())
            }
            _ => Ok(()),
        };
        result.map_err(|fault| input.at(line, fault))?;
    }
    if reader.give_normals().map_err(|fault| input.at(None, fault))? {
        input.warn(None, MeshFault::NormalsLeftOut);
    }
    Ok(reader.builder)
}

struct Reader {
    builder: Builder,
    /// The file's list of normals.
    normals: Vec<DVec3>,
    /// For each facet the normals of its corners, as numbers in that list.
    facet_normals: Vec<[u32; 3]>,
    corners: Vec<u32>,
    corner_normals: Vec<u32>,
    materials: HashMap<Vec<u8>, Arc<Surface>>,
    /// The materials that were missed already.
    unknown: HashSet<Vec<u8>>,
}

impl Reader {
    fn face(&mut self, words: Words<'_>) -> Result<(), MeshFault> {
        self.corners.clear();
        self.corner_normals.clear();
        for word in words.take_while(|word| !word.starts_with(b"#")) {
            let mut parts = word.split(|byte| *byte == b'/');
            let vertices = self.builder.vertices();
            let vertex = entry(parts.next().unwrap_or_default(), vertices)?
                .map_err(|named| MeshFault::NoSuchVertex { named, vertices })?;
            let normal = match parts.nth(1) {
                None | Some(b"") => NONE,
                Some(part) => {
                    let normals = self.normals.len();
                    entry(part, normals)?.map_err(|named| MeshFault::NoSuchNormal { named, normals })?
                }
            };
            self.corners.push(vertex);
            self.corner_normals.push(normal);
        }
        let normals = &self.corner_normals;
        let cut = self.builder.polygon(&self.corners)?.iter();
        self.facet_normals.extend(cut.map(|triangle| triangle.map(|corner| normals[corner])));
        Ok(())
    }

    /// Reads the libraries that a line names. A name may hold spaces, or there may be several.
    fn libraries(&mut self, names: &[u8], line: usize, input: &mut Input<'_>) {
        let whole = [names];
        let several: Vec<&[u8]> = Words::new(names, line).collect();
        let found = |input: &mut Input<'_>, name: &[u8]| input.beside.read(&String::from_utf8_lossy(name));
        let names = match found(input, names) {
            Err(MeshFault::Missing) if several.len() > 1 => several.as_slice(),
            Ok(_) | Err(_) => whole.as_slice(),
        };
        for name in names {
            let file = input.name_beside(&String::from_utf8_lossy(name));
            match found(input, name) {
                Ok(bytes) => {
                    let (materials, warnings) = mtl::read(&file, &bytes);
                    self.materials.extend(materials);
                    input.pass_on(warnings);
                }
                Err(fault) => input.pass_on([MeshProblem { file, line: None, fault }]),
            }
        }
    }

    fn use_material(&mut self, name: &[u8], line: usize, input: &mut Input<'_>) {
        let material = self.materials.get(name);
        self.builder.set_material(material);
        if material.is_none() && self.unknown.insert(name.to_owned()) {
            input.warn(line, MeshFault::UnknownMaterial(quoted(name)));
        }
    }

    /// Gives every vertex its normal. A vertex with several normals becomes several vertices; the scene merges them
    /// again where it asks whether the mesh is closed. True: some corners have normals and others not, so that none
    /// is used.
    fn give_normals(&mut self) -> Result<bool, MeshFault> {
        let with = self.facet_normals.iter().flatten().filter(|normal| **normal != NONE).count();
        if with == 0 || with < 3 * self.facet_normals.len() {
            return Ok(with > 0);
        }
        let mut first = vec![NONE; self.builder.vertices()];
        let mut others = HashMap::new();
        self.builder.geometry.normals = vec![DVec3::ZERO; self.builder.vertices()];
        for (facet, normals) in self.facet_normals.iter().enumerate() {
            for (corner, &normal) in normals.iter().enumerate() {
                let vertex = self.builder.geometry.facets[facet][corner];
                let direction = self.normals[normal as usize];
                let known = &mut first[vertex as usize];
                if *known == NONE {
                    *known = normal;
                    self.builder.geometry.normals[vertex as usize] = direction;
                } else if self.builder.geometry.normals[vertex as usize] != direction {
                    let other = match others.get(&(vertex, normal)) {
                        Some(&other) => other,
                        None => {
                            let other = self.builder.vertex(self.builder.geometry.positions[vertex as usize])?;
                            self.builder.geometry.normals.push(direction);
                            others.insert((vertex, normal), other);
                            other
                        }
                    };
                    self.builder.geometry.facets[facet][corner] = other;
                }
            }
        }
        Ok(false)
    }
}

/// The first three numbers of a line; a weight or a colour behind them is let pass.
fn point(keyword: &[u8], mut words: Words<'_>) -> Result<DVec3, MeshFault> {
    let mut coordinates = [0.0; 3];
    for coordinate in &mut coordinates {
        *coordinate = number(words.next().ok_or_else(|| MeshFault::TooFewNumbers(quoted(keyword)))?)?;
    }
    Ok(coordinates.into())
}

/// The entry that a number of a face names among the `count` before it: from 1, or backwards from -1. The inner error
/// is a number that names none.
fn entry(word: &[u8], count: usize) -> Result<Result<u32, i64>, MeshFault> {
    let text = std::str::from_utf8(word).ok();
    let named: i64 = text.and_then(|text| text.parse().ok()).ok_or_else(|| MeshFault::NotANumber(quoted(word)))?;
    let index = if named > 0 { named - 1 } else { named.saturating_add_unsigned(count as u64) };
    let exists = named != 0 && (0..count as i64).contains(&index);
    Ok(if exists { u32::try_from(index).map_err(|_| named) } else { Err(named) })
}

/// The lines of a file with their numbers; a backslash at the end of a line joins the next one to it.
struct Lines<'a> {
    rest: &'a [u8],
    line: usize,
}

impl<'a> Lines<'a> {
    fn of(bytes: &'a [u8]) -> Lines<'a> {
        Lines { rest: bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes), line: 0 }
    }

    fn one(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        self.line += 1;
        let end = memchr::memchr(b'\n', self.rest);
        let (line, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest.get(1..).unwrap_or_default();
        Some(line.trim_ascii())
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, Cow<'a, [u8]>);

    fn next(&mut self) -> Option<Self::Item> {
        let first = self.one()?;
        let number = self.line;
        let Some(start) = first.strip_suffix(b"\\") else { return Some((number, Cow::Borrowed(first))) };
        let mut joined = start.to_vec();
        while let Some(next) = self.one() {
            joined.push(b' ');
            match next.strip_suffix(b"\\") {
                Some(part) => joined.extend_from_slice(part),
                None => {
                    joined.extend_from_slice(next);
                    break;
                }
            }
        }
        Some((number, Cow::Owned(joined)))
    }
}
