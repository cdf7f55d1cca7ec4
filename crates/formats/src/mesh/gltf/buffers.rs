//! The numbers of a glTF file: accessors look at views of buffers, and every look is checked before it is taken.

use super::document::{Accessor, Document};
use super::entry;
use crate::mesh::{Input, MeshFault, MeshProblem};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use glam::DVec3;
use std::collections::HashMap;
use std::rc::Rc;

/// The buffers of a document, those of one file shared.
pub(super) struct Buffers {
    buffers: Vec<Rc<[u8]>>,
    bytes_of_files: usize,
}

impl Buffers {
    /// Opens the buffers that stand in other files and decodes those that stand in the document.
    pub(super) fn read(
        document: &Document<'_>,
        binary: Option<&[u8]>,
        input: &mut Input<'_>,
    ) -> Result<Buffers, MeshProblem> {
        let mut files: HashMap<&str, Rc<[u8]>> = HashMap::new();
        let mut buffers = Buffers { buffers: Vec::new(), bytes_of_files: 0 };
        for (index, buffer) in document.buffers.iter().enumerate() {
            let bad = MeshFault::BadEntry { list: "buffers", index };
            let bytes: Rc<[u8]> = match buffer.uri.as_deref() {
                None => match binary {
                    Some(bytes) if index == 0 => bytes.into(),
                    _ => return Err(input.at(None, bad)),
                },
                Some(uri) if uri.starts_with("data:") => {
                    let text = uri.split_once(";base64,").map(|(_, text)| text);
                    let bytes = text.and_then(|text| STANDARD.decode(text).ok()).ok_or_else(|| input.at(None, bad))?;
                    bytes.into()
                }
                Some(uri) => match files.get(uri) {
                    Some(bytes) => Rc::clone(bytes),
                    None => {
                        let path = percent_encoding::percent_decode_str(uri).decode_utf8_lossy();
                        let file = input.name_beside(&path);
                        let bytes = input.beside.read(&path);
                        let bytes = bytes.map_err(|fault| MeshProblem { file, line: None, fault })?;
                        buffers.bytes_of_files += bytes.len();
                        let bytes: Rc<[u8]> = bytes.into();
                        files.insert(uri, Rc::clone(&bytes));
                        bytes
                    }
                },
            };
            if bytes.len() < buffer.byte_length {
                return Err(input.at(None, MeshFault::BadEntry { list: "buffers", index }));
            }
            buffers.buffers.push(bytes);
        }
        Ok(buffers)
    }

    /// How many bytes stand in other files.
    pub(super) fn bytes_of_files(&self) -> usize {
        self.bytes_of_files
    }

    /// The elements of an accessor, which must be of a kind.
    pub(super) fn elements(
        &self,
        document: &Document<'_>,
        index: usize,
        kind: &'static str,
    ) -> Result<Elements, MeshFault> {
        let accessor = entry(&document.accessors, index, "accessors")?;
        let bad = || MeshFault::BadEntry { list: "accessors", index };
        if accessor.sparse.is_some() {
            return Err(MeshFault::UnknownExtension("sparse".into()));
        }
        if accessor.kind != kind {
            return Err(bad());
        }
        let view_index = accessor.buffer_view.ok_or_else(bad)?;
        let view = entry(&document.buffer_views, view_index, "bufferViews")?;
        let buffer = entry(&self.buffers, view.buffer, "buffers")?;
        let component = Component::of(accessor).ok_or_else(bad)?;
        let size = component.size() * if kind == "VEC3" { 3 } else { 1 };
        let stride = view.byte_stride.unwrap_or(size);
        let end = view.byte_offset.checked_add(view.byte_length).filter(|end| *end <= buffer.len());
        let end = end.ok_or(MeshFault::BadEntry { list: "bufferViews", index: view_index })?;
        let start = view.byte_offset.checked_add(accessor.byte_offset).ok_or_else(bad)?;
        // An accessor without elements has no last one.
        let before_last = accessor.count.checked_sub(1).map_or(Some(0), |count| count.checked_mul(stride));
        let last = before_last.and_then(|before| start.checked_add(before)).ok_or_else(bad)?;
        let needed = if accessor.count == 0 { 0 } else { size };
        if last.checked_add(needed).is_none_or(|last| last > end) || stride < size {
            return Err(bad());
        }
        Ok(Elements { buffer: Rc::clone(buffer), start, stride, count: accessor.count, component })
    }
}

/// The elements of an accessor; each of them lies within the buffer.
pub(super) struct Elements {
    buffer: Rc<[u8]>,
    start: usize,
    stride: usize,
    count: usize,
    component: Component,
}

impl Elements {
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// Element `at` of three components, which must exist.
    pub(super) fn vector(&self, at: usize) -> DVec3 {
        let start = self.start + at * self.stride;
        let component = |number: usize| self.component.read(&self.buffer[start + number * self.component.size()..]);
        DVec3::new(component(0), component(1), component(2))
    }

    /// Element `at` as a number that counts, which must exist.
    pub(super) fn index(&self, at: usize) -> usize {
        self.component.read(&self.buffer[self.start + at * self.stride..]) as usize
    }
}

/// How a number stands in a buffer; integers may stand for 0..1 or -1..1.
#[derive(Clone, Copy)]
enum Component {
    I8(Scale),
    U8(Scale),
    I16(Scale),
    U16(Scale),
    U32,
    F32,
}

/// What an integer is divided by.
type Scale = f64;

impl Component {
    fn of(accessor: &Accessor<'_>) -> Option<Component> {
        let scale = |greatest: f64| if accessor.normalized { greatest } else { 1.0 };
        Some(match accessor.component_type {
            5120 => Component::I8(scale(127.0)),
            5121 => Component::U8(scale(255.0)),
            5122 => Component::I16(scale(32_767.0)),
            5123 => Component::U16(scale(65_535.0)),
            5125 => Component::U32,
            5126 => Component::F32,
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Component::I8(_) | Component::U8(_) => 1,
            Component::I16(_) | Component::U16(_) => 2,
            Component::U32 | Component::F32 => 4,
        }
    }

    fn read(self, bytes: &[u8]) -> f64 {
        match self {
            Component::I8(scale) => f64::from(bytes[0] as i8) / scale,
            Component::U8(scale) => f64::from(bytes[0]) / scale,
            Component::I16(scale) => f64::from(i16::from_le_bytes([bytes[0], bytes[1]])) / scale,
            Component::U16(scale) => f64::from(u16::from_le_bytes([bytes[0], bytes[1]])) / scale,
            Component::U32 => f64::from(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
            Component::F32 => f64::from(f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
        }
    }
}
