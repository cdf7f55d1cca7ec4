//! What can be wrong with a mesh file.

use crate::Describe;
use lancer_words::{Lang, file, mesh as words, number};
use std::sync::Arc;

/// What is wrong with a mesh file. It is told at the place in the document that names the file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshProblem {
    /// The file, as the document names it, or a file that this one names.
    pub file: Arc<str>,
    /// The line it is about, from 1, in a format that has lines.
    pub line: Option<usize>,
    /// What is wrong.
    pub fault: MeshFault,
}

/// The faults of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub enum MeshFault {
    /// There is no such file.
    Missing,
    /// The system refuses to read it; its own words.
    Unreadable(String),
    /// The user must not read it.
    Forbidden,
    /// The links on its way lead in a circle.
    LinksInACircle,
    /// Its name is longer than the system allows.
    NameTooLong,
    /// There is no memory for it.
    NoMemory,
    /// It is a folder, a pipe or a device.
    NotAFile,
    /// It lies outside the document's folder.
    Outside,
    /// The file has more bytes than are read.
    TooLarge {
        /// How many are read.
        most: u64,
    },
    /// The extension, with its dot, means no mesh format.
    UnknownFormat(String),
    /// The mesh would take more memory than any plain file of that size needs.
    TooMuchMemory {
        /// The bound in bytes.
        most: usize,
    },
    /// There is not one facet.
    NoFacets,
    /// The file ends where more is due.
    EndsEarly,
    /// A number is due where this stands.
    NotANumber(String),
    /// This word stands where another is due.
    Unexpected {
        /// What stands there.
        found: String,
        /// What is due.
        due: &'static str,
    },
    /// There are too few numbers behind this word.
    TooFewNumbers(String),
    /// A coordinate is not finite or beyond the bounds of a scene.
    Coordinate(f64),
    /// A facet names a vertex that does not exist.
    NoSuchVertex {
        /// The number that it names.
        named: i64,
        /// How many vertices there are so far.
        vertices: usize,
    },
    /// A facet names a normal that does not exist.
    NoSuchNormal {
        /// The number that it names.
        named: i64,
        /// How many normals there are so far.
        normals: usize,
    },
    /// A face has fewer than three corners.
    TooFewCorners(usize),
    /// A face has more corners than are cut into triangles.
    TooManyCorners {
        /// How many it has.
        corners: usize,
        /// How many are allowed.
        most: usize,
    },
    /// There are more vertices or facets than 32 bits count.
    TooManyItems,
    /// The file does not have what its format demands; the thing's name in the format.
    Lacks(&'static str),
    /// A PLY file's body has a form that is not known.
    UnknownEncoding(String),
    /// The text of a glTF file is no such document; the decoder's words.
    BadDocument(String),
    /// A glTF file names an entry that does not exist.
    NoSuchEntry {
        /// The list, as the format calls it.
        list: &'static str,
        /// The entry.
        index: usize,
    },
    /// An entry of a glTF file contradicts the rest of the file.
    BadEntry {
        /// The list, as the format calls it.
        list: &'static str,
        /// The entry.
        index: usize,
    },
    /// The file needs an extension of glTF that is not known.
    UnknownExtension(String),
    /// Warning: a material is used that no library defines.
    UnknownMaterial(String),
    /// Warning: the normals are left out, because some are missing or no directions.
    NormalsLeftOut,
    /// Warning: textures are left out.
    TexturesLeftOut,
    /// Warning: a coefficient of a material was brought into its range.
    Clamped(String),
}

impl Describe for MeshProblem {
    fn code(&self) -> &'static str {
        match self.fault {
            MeshFault::Missing => "mesh::missing",
            MeshFault::Unreadable(_) => "mesh::unreadable",
            MeshFault::Forbidden => "mesh::forbidden",
            MeshFault::LinksInACircle => "mesh::links-in-a-circle",
            MeshFault::NameTooLong => "mesh::name-too-long",
            MeshFault::NoMemory => "mesh::no-memory",
            MeshFault::NotAFile => "mesh::not-a-file",
            MeshFault::Outside => "mesh::outside",
            MeshFault::TooLarge { .. } => "mesh::too-large",
            MeshFault::UnknownFormat(_) => "mesh::unknown-format",
            MeshFault::TooMuchMemory { .. } => "mesh::too-much-memory",
            MeshFault::NoFacets => "mesh::no-facets",
            MeshFault::EndsEarly => "mesh::ends-early",
            MeshFault::NotANumber(_) => "mesh::not-a-number",
            MeshFault::Unexpected { .. } => "mesh::unexpected",
            MeshFault::TooFewNumbers(_) => "mesh::too-few-numbers",
            MeshFault::Coordinate(_) => "mesh::coordinate",
            MeshFault::NoSuchVertex { .. } => "mesh::no-such-vertex",
            MeshFault::NoSuchNormal { .. } => "mesh::no-such-normal",
            MeshFault::TooFewCorners(_) => "mesh::too-few-corners",
            MeshFault::TooManyCorners { .. } => "mesh::too-many-corners",
            MeshFault::TooManyItems => "mesh::too-many-items",
            MeshFault::Lacks(_) => "mesh::lacks",
            MeshFault::UnknownEncoding(_) => "mesh::unknown-encoding",
            MeshFault::BadDocument(_) => "mesh::bad-document",
            MeshFault::NoSuchEntry { .. } => "mesh::no-such-entry",
            MeshFault::BadEntry { .. } => "mesh::bad-entry",
            MeshFault::UnknownExtension(_) => "mesh::unknown-extension",
            MeshFault::UnknownMaterial(_) => "mesh::unknown-material",
            MeshFault::NormalsLeftOut => "mesh::normals-left-out",
            MeshFault::TexturesLeftOut => "mesh::textures-left-out",
            MeshFault::Clamped(_) => "mesh::clamped",
        }
    }

    fn message(&self, lang: Lang) -> String {
        let fault = match &self.fault {
            MeshFault::Missing => words::missing(lang),
            MeshFault::Unreadable(cause) => words::unreadable(lang, cause),
            MeshFault::Forbidden => words::unreadable(lang, file::forbidden(lang)),
            MeshFault::LinksInACircle => words::unreadable(lang, file::links_in_a_circle(lang)),
            MeshFault::NameTooLong => words::unreadable(lang, file::name_too_long(lang)),
            MeshFault::NoMemory => words::unreadable(lang, file::no_memory(lang)),
            MeshFault::NotAFile => words::not_a_file(lang),
            MeshFault::Outside => words::outside(lang),
            MeshFault::TooLarge { most } => words::too_large(lang, most >> 20),
            MeshFault::UnknownFormat(extension) => words::unknown_format(lang, extension),
            MeshFault::TooMuchMemory { most } => words::too_much_memory(lang, most >> 20),
            MeshFault::NoFacets => words::no_facets(lang),
            MeshFault::EndsEarly => words::ends_early(lang),
            MeshFault::NotANumber(found) => words::not_a_number(lang, found),
            MeshFault::Unexpected { found, due } => words::unexpected(lang, found, due),
            MeshFault::TooFewNumbers(word) => words::too_few_numbers(lang, word),
            MeshFault::Coordinate(value) => words::coordinate(lang, format!("{value:e}")),
            MeshFault::NoSuchVertex { named, vertices } => {
                words::no_such_vertex(lang, named, number::vertices(lang, *vertices))
            }
            MeshFault::NoSuchNormal { named, normals } => {
                words::no_such_normal(lang, named, number::normals(lang, *normals))
            }
            MeshFault::TooFewCorners(corners) => words::too_few_corners(lang, corners),
            MeshFault::TooManyCorners { corners, most } => words::too_many_corners(lang, corners, most),
            MeshFault::TooManyItems => words::too_many_items(lang),
            MeshFault::Lacks(what) => words::lacks(lang, what),
            MeshFault::UnknownEncoding(encoding) => words::unknown_encoding(lang, encoding),
            MeshFault::BadDocument(cause) => words::bad_document(lang, cause),
            MeshFault::NoSuchEntry { list, index } => words::no_such_entry(lang, list, index),
            MeshFault::BadEntry { list, index } => words::bad_entry(lang, list, index),
            MeshFault::UnknownExtension(name) => words::unknown_extension(lang, name),
            MeshFault::UnknownMaterial(name) => words::unknown_material(lang, name),
            MeshFault::NormalsLeftOut => words::normals_left_out(lang),
            MeshFault::TexturesLeftOut => words::textures_left_out(lang),
            MeshFault::Clamped(word) => words::clamped(lang, word),
        };
        match self.line {
            Some(line) => words::in_line(lang, &self.file, line, fault),
            None => words::in_file(lang, &self.file, fault),
        }
    }

    fn label(&self, lang: Lang) -> String {
        words::named_here(lang)
    }

    fn help(&self, lang: Lang) -> Option<String> {
        match &self.fault {
            MeshFault::Missing => Some(words::missing_help(lang)),
            MeshFault::NotAFile | MeshFault::UnknownFormat(_) => Some(words::formats_help(lang)),
            MeshFault::Outside => Some(words::outside_help(lang)),
            MeshFault::EndsEarly => Some(words::ends_early_help(lang)),
            MeshFault::Coordinate(_) => Some(words::coordinate_help(lang)),
            MeshFault::NoFacets => Some(words::no_facets_help(lang)),
            MeshFault::UnknownExtension(_) => Some(words::unknown_extension_help(lang)),
            MeshFault::UnknownMaterial(_) => Some(words::unknown_material_help(lang)),
            MeshFault::NormalsLeftOut => Some(words::normals_left_out_help(lang)),
            MeshFault::TexturesLeftOut => Some(words::textures_left_out_help(lang)),
            MeshFault::TooManyCorners { .. } => Some(words::too_many_corners_help(lang)),
            MeshFault::Unreadable(_)
            | MeshFault::Forbidden
            | MeshFault::LinksInACircle
            | MeshFault::NameTooLong
            | MeshFault::NoMemory
            | MeshFault::TooLarge { .. }
            | MeshFault::TooMuchMemory { .. }
            | MeshFault::NotANumber(_)
            | MeshFault::Unexpected { .. }
            | MeshFault::TooFewNumbers(_)
            | MeshFault::NoSuchVertex { .. }
            | MeshFault::NoSuchNormal { .. }
            | MeshFault::TooFewCorners(_)
            | MeshFault::TooManyItems
            | MeshFault::Lacks(_)
            | MeshFault::UnknownEncoding(_)
            | MeshFault::BadDocument(_)
            | MeshFault::NoSuchEntry { .. }
            | MeshFault::BadEntry { .. }
            | MeshFault::Clamped(_) => None,
        }
    }
}
