//! PLY, the Stanford polygon format: a header that describes its elements, then their values as text or as bytes of
//! either order.
//!
//! Of the elements, `vertex` (`x y z`, perhaps `nx ny nz`) and `face` (the list `vertex_indices` or `vertex_index`) are
//! used; all others are let pass.

use super::words::{Words, number, quoted};
use super::{Builder, Input, MeshFault, MeshProblem};
use crate::progress;
use glam::DVec3;

pub(super) fn read(input: &Input<'_>) -> Result<Builder, MeshProblem> {
    let (header, body) = Header::read(input)?;
    let mut reader =
        Reader { bytes: input.bytes.len(), body, builder: Builder::new(input.bytes.len()), corners: Vec::new() };
    for element in &header.elements {
        let result = match element.name {
            b"vertex" => reader.vertices(element),
            b"face" => reader.faces(element),
            _ => reader.let_pass(element),
        };
        result.map_err(|fault| input.at(reader.body.line(), fault))?;
    }
    Ok(reader.builder)
}

/// The types of numbers, all of which an `f64` holds exactly.
#[derive(Clone, Copy)]
enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn named(word: &[u8]) -> Result<Scalar, MeshFault> {
        Ok(match word {
            b"char" | b"int8" => Scalar::I8,
            b"uchar" | b"uint8" => Scalar::U8,
            b"short" | b"int16" => Scalar::I16,
            b"ushort" | b"uint16" => Scalar::U16,
            b"int" | b"int32" => Scalar::I32,
            b"uint" | b"uint32" => Scalar::U32,
            b"float" | b"float32" => Scalar::F32,
            b"double" | b"float64" => Scalar::F64,
            _ => return Err(MeshFault::Unexpected { found: quoted(word), due: "type" }),
        })
    }
}

struct Property<'a> {
    name: &'a [u8],
    /// The type of the count, if it is a list.
    list: Option<Scalar>,
    scalar: Scalar,
}

struct Element<'a> {
    name: &'a [u8],
    count: u64,
    properties: Vec<Property<'a>>,
}

struct Header<'a> {
    elements: Vec<Element<'a>>,
}

impl<'a> Header<'a> {
    /// The header, and the body behind it.
    fn read(input: &Input<'a>) -> Result<(Header<'a>, Body<'a>), MeshProblem> {
        let mut rest = input.bytes;
        let mut header = Header { elements: Vec::new() };
        let mut order = None;
        for line in 1.. {
            let Some(end) = memchr::memchr(b'\n', rest) else {
                let fault = if line == 1 { unexpected(rest, "ply") } else { MeshFault::EndsEarly };
                return Err(input.at(line, fault));
            };
            let text = rest[..end].trim_ascii();
            rest = &rest[end + 1..];
            if line == 1 {
                if text != b"ply" {
                    return Err(input.at(line, unexpected(text, "ply")));
                }
            } else if text == b"end_header" {
                let body = match order {
                    Some(Order::Text) => Body::Text(Words::new(rest, line + 1)),
                    Some(Order::Little) => Body::Bytes { rest, big: false },
                    Some(Order::Big) => Body::Bytes { rest, big: true },
                    None => return Err(input.at(line, MeshFault::Lacks("format"))),
                };
                return Ok((header, body));
            } else {
                header.line(text, &mut order).map_err(|fault| input.at(line, fault))?;
            }
        }
        Err(input.at(None, MeshFault::EndsEarly))
    }

    fn line(&mut self, text: &'a [u8], order: &mut Option<Order>) -> Result<(), MeshFault> {
        let words: Vec<&[u8]> = Words::new(text, 1).take(5).collect();
        match words[..] {
            [] | [b"comment" | b"obj_info", ..] => {}
            [b"format", b"ascii", ..] => *order = Some(Order::Text),
            [b"format", b"binary_little_endian", ..] => *order = Some(Order::Little),
            [b"format", b"binary_big_endian", ..] => *order = Some(Order::Big),
            [b"format", other, ..] => return Err(MeshFault::UnknownEncoding(quoted(other))),
            [b"element", name, count] => {
                let digits = std::str::from_utf8(count).ok();
                let count = digits
                    .and_then(|digits| digits.parse().ok())
                    .ok_or_else(|| MeshFault::NotANumber(quoted(count)))?;
                self.elements.push(Element { name, count, properties: Vec::new() });
            }
            [b"property", ref property @ ..] => {
                let element = self.elements.last_mut().ok_or_else(|| unexpected(text, "element"))?;
                element.properties.push(match *property {
                    [b"list", count, scalar, name] => {
                        Property { name, list: Some(Scalar::named(count)?), scalar: Scalar::named(scalar)? }
                    }
                    [scalar, name] => Property { name, list: None, scalar: Scalar::named(scalar)? },
                    _ => return Err(unexpected(text, "property")),
                });
            }
            _ => return Err(unexpected(text, "end_header")),
        }
        Ok(())
    }
}

fn unexpected(text: &[u8], due: &'static str) -> MeshFault {
    MeshFault::Unexpected { found: quoted(text), due }
}

#[derive(Clone, Copy)]
enum Order {
    Text,
    Little,
    Big,
}

/// The values behind the header.
enum Body<'a> {
    Text(Words<'a>),
    Bytes { rest: &'a [u8], big: bool },
}

impl Body<'_> {
    /// The line of the last value, where there are lines.
    fn line(&self) -> Option<usize> {
        match self {
            Body::Text(words) => Some(words.line),
            Body::Bytes { .. } => None,
        }
    }

    /// How many bytes are not read yet.
    fn left(&self) -> usize {
        match self {
            Body::Text(words) => words.left(),
            Body::Bytes { rest, .. } => rest.len(),
        }
    }

    fn next(&mut self, scalar: Scalar) -> Result<f64, MeshFault> {
        let (rest, big) = match self {
            Body::Text(words) => return number(words.next().ok_or(MeshFault::EndsEarly)?),
            Body::Bytes { rest, big } => (rest, *big),
        };
        macro_rules! next {
            ($type:ty) => {{
                let (bytes, after) = rest.split_first_chunk().ok_or(MeshFault::EndsEarly)?;
                *rest = after;
                f64::from(if big { <$type>::from_be_bytes(*bytes) } else { <$type>::from_le_bytes(*bytes) })
            }};
        }
        Ok(match scalar {
            Scalar::I8 => next!(i8),
            Scalar::U8 => next!(u8),
            Scalar::I16 => next!(i16),
            Scalar::U16 => next!(u16),
            Scalar::I32 => next!(i32),
            Scalar::U32 => next!(u32),
            Scalar::F32 => next!(f32),
            Scalar::F64 => next!(f64),
        })
    }

    /// The length of a list.
    fn length(&mut self, scalar: Scalar) -> Result<u32, MeshFault> {
        let length = self.next(scalar)?;
        whole(length).ok_or_else(|| MeshFault::Unexpected { found: length.to_string(), due: "count" })
    }
}

/// A number that counts or names something.
fn whole(value: f64) -> Option<u32> {
    (value >= 0.0 && value <= f64::from(u32::MAX) && value.fract() == 0.0).then_some(value as u32)
}

struct Reader<'a> {
    /// The length of the file.
    bytes: usize,
    body: Body<'a>,
    builder: Builder,
    corners: Vec<u32>,
}

impl Reader<'_> {
    fn vertices(&mut self, element: &Element<'_>) -> Result<(), MeshFault> {
        // Where each property goes: 0 to 2 the position, 3 to 5 the normal, 6 nowhere.
        const NAMES: [&[u8]; 6] = [b"x", b"y", b"z", b"nx", b"ny", b"nz"];
        let place = |property: &Property<'_>| {
            NAMES.iter().position(|name| property.list.is_none() && *name == property.name).unwrap_or(6)
        };
        let places: Vec<usize> = element.properties.iter().map(place).collect();
        for (place, due) in [(0, "x"), (1, "y"), (2, "z")] {
            if !places.contains(&place) {
                return Err(MeshFault::Lacks(due));
            }
        }
        let normals = (3..6).all(|place| places.contains(&place));
        for number in 0..element.count {
            progress::now_and_then(number as usize, || self.bytes - self.body.left());
            let mut values = [0.0; 7];
            for (property, &place) in element.properties.iter().zip(&places) {
                match property.list {
                    None => values[place] = self.body.next(property.scalar)?,
                    Some(count) => self.skip_list(count, property.scalar)?,
                }
            }
            let [x, y, z, nx, ny, nz, _] = values;
            if normals {
                self.builder.geometry.normals.push(DVec3::new(nx, ny, nz));
            }
            self.builder.vertex(DVec3::new(x, y, z))?;
        }
        Ok(())
    }

    fn faces(&mut self, element: &Element<'_>) -> Result<(), MeshFault> {
        let is_corners = |property: &Property<'_>| {
            property.list.is_some() && matches!(property.name, b"vertex_indices" | b"vertex_index")
        };
        let corners = element.properties.iter().position(is_corners).ok_or(MeshFault::Lacks("vertex_indices"))?;
        for number in 0..element.count {
            progress::now_and_then(number as usize, || self.bytes - self.body.left());
            for (place, property) in element.properties.iter().enumerate() {
                match property.list {
                    None => drop(self.body.next(property.scalar)?),
                    Some(count) if place != corners => self.skip_list(count, property.scalar)?,
                    Some(count) => self.face(count, property.scalar)?,
                }
            }
        }
        Ok(())
    }

    fn face(&mut self, count: Scalar, scalar: Scalar) -> Result<(), MeshFault> {
        let length = self.body.length(count)?;
        let vertices = self.builder.vertices();
        self.corners.clear();
        for _ in 0..length {
            let named = self.body.next(scalar)?;
            let no_such = || MeshFault::NoSuchVertex { named: named as i64, vertices };
            self.corners.push(whole(named).ok_or_else(no_such)?);
        }
        self.builder.polygon(&self.corners).map(drop)
    }

    fn let_pass(&mut self, element: &Element<'_>) -> Result<(), MeshFault> {
        if element.properties.is_empty() {
            return Ok(());
        }
        for _ in 0..element.count {
            for property in &element.properties {
                match property.list {
                    None => drop(self.body.next(property.scalar)?),
                    Some(count) => self.skip_list(count, property.scalar)?,
                }
            }
        }
        Ok(())
    }

    fn skip_list(&mut self, count: Scalar, scalar: Scalar) -> Result<(), MeshFault> {
        for _ in 0..self.body.length(count)? {
            self.body.next(scalar)?;
        }
        Ok(())
    }
}
