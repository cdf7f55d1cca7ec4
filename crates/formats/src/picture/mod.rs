//! Pictures in files: which format a name means, writing in it, and reading pictures of every format for a comparison.
//!
//! There is no gamma anywhere (SPEC): the eight-bit formats get the picture's bytes as they are, with no note on their
//! meaning, and OpenEXR gets the linear colours.

mod difference;
mod problem;

pub use difference::{Difference, DifferentSizes, Place, Rectangle, compare};
pub use problem::{Count, PictureProblem};

use crate::{Diagnostic, ppm};
use image::{ColorType, DynamicImage, ImageDecoder, ImageEncoder, ImageFormat};
use lancer_scene::{Picture, Rgb};
use lancer_words::{Lang, picture as words};
use std::io::{self, Cursor, Write};
use std::path::Path;

/// The most memory that decoding a picture may take: no compression in use makes a picture smaller than a thousandth.
fn most_memory(file: &[u8]) -> u64 {
    ((64 << 20) + 4096 * file.len() as u64).min(2 << 30)
}

/// The formats in which a picture can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Portable pixmap in text, P3: the subject's format.
    PlainPpm,
    /// Portable pixmap in bytes, P6.
    RawPpm,
    /// Portable Network Graphics.
    Png,
    /// Quite OK Image.
    Qoi,
    /// Windows bitmap.
    Bmp,
    /// Tagged Image File Format.
    Tiff,
    /// OpenEXR: the linear colours as 32-bit floats.
    Exr,
}

/// Every extension that is known, with its format.
const EXTENSIONS: [(&str, Format); 8] = [
    ("ppm", Format::PlainPpm),
    ("pnm", Format::PlainPpm),
    ("png", Format::Png),
    ("qoi", Format::Qoi),
    ("bmp", Format::Bmp),
    ("tif", Format::Tiff),
    ("tiff", Format::Tiff),
    ("exr", Format::Exr),
];

/// A file name's extension means no picture format.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no picture format has the extension `.{extension}`")]
pub struct UnknownExtension {
    /// The extension.
    pub extension: String,
}

impl UnknownExtension {
    /// The sentence for a person, with the extensions that are known.
    pub fn message(&self, lang: Lang) -> String {
        let known: Vec<String> = EXTENSIONS.iter().map(|(extension, _)| format!(".{extension}")).collect();
        words::unknown_extension(lang, &self.extension, known.join(" "))
    }
}

impl Format {
    /// The format that a file's extension means, whatever its case. A name without an extension gets the subject's
    /// format; `binary` chooses P6 where the name means a pixmap.
    ///
    /// # Errors
    /// An extension that is not known.
    pub fn of_path(path: &Path, binary: bool) -> Result<Format, UnknownExtension> {
        let pixmap = if binary { Format::RawPpm } else { Format::PlainPpm };
        let Some(extension) = path.extension() else { return Ok(pixmap) };
        let extension = extension.to_string_lossy();
        let known = EXTENSIONS.iter().find(|(known, _)| known.eq_ignore_ascii_case(&extension));
        match known {
            Some((_, Format::PlainPpm)) => Ok(pixmap),
            Some((_, format)) => Ok(*format),
            None => Err(UnknownExtension { extension: extension.into_owned() }),
        }
    }

    /// Whether the format holds the linear colours, so that a picture should bring them.
    pub fn is_linear(self) -> bool {
        self == Format::Exr
    }
}

/// Writes a picture. A picture without linear colours is written to OpenEXR as its bytes divided by 255.
///
/// # Errors
/// What `out` says; [`io::ErrorKind::InvalidInput`] for a picture whose pixels do not fill its size, or which is too
/// large for the format.
pub fn write(picture: &Picture, format: Format, out: &mut dyn Write) -> io::Result<()> {
    ppm::check_size(picture)?;
    let container = match format {
        Format::PlainPpm => return ppm::write_plain(picture, out),
        Format::RawPpm => return ppm::write_raw(picture, out),
        Format::Png => ImageFormat::Png,
        Format::Qoi => ImageFormat::Qoi,
        Format::Bmp => ImageFormat::Bmp,
        Format::Tiff => ImageFormat::Tiff,
        Format::Exr => ImageFormat::OpenExr,
    };
    out.write_all(&encode(picture, container)?)
}

/// The whole file in memory: two of the encoders go back to fill in what they know only at the end.
fn encode(picture: &Picture, container: ImageFormat) -> io::Result<Vec<u8>> {
    let mut file = Cursor::new(Vec::new());
    let (width, height) = (picture.width, picture.height);
    let result = if container == ImageFormat::OpenExr {
        let linear = match &picture.linear {
            Some(linear) if linear.len() == picture.bytes.len() => linear.clone(),
            _ => picture.bytes.iter().map(|pixel| pixel.map(|byte| f32::from(byte) / 255.0)).collect(),
        };
        let encoder = image::codecs::openexr::OpenExrEncoder::new(&mut file);
        encoder.write_image(bytemuck::cast_slice(&linear), width, height, ColorType::Rgb32F.into())
    } else {
        let bytes = picture.bytes.as_flattened();
        image::write_buffer_with_format(&mut file, bytes, width, height, ColorType::Rgb8, container)
    };
    result.map_err(|error| match error {
        image::ImageError::IoError(error) => error,
        image::ImageError::Decoding(_)
        | image::ImageError::Encoding(_)
        | image::ImageError::Parameter(_)
        | image::ImageError::Limits(_)
        | image::ImageError::Unsupported(_) => io::Error::new(io::ErrorKind::InvalidInput, error.to_string()),
    })?;
    Ok(file.into_inner())
}

/// Reads a picture of any format that can be written, decided by its first bytes. An opacity is left out.
///
/// # Errors
/// What is wrong with the file.
pub fn read(bytes: &[u8]) -> Result<Picture, Diagnostic> {
    if let [b'P', kind @ b'1'..=b'7', ..] = bytes {
        return match kind {
            b'3' | b'6' => ppm::read(bytes),
            _ => Err(Diagnostic::error(None, PictureProblem::OtherNetpbm(char::from(*kind)))),
        };
    }
    let unknown = || Diagnostic::error(None, PictureProblem::UnknownFormat);
    let container = image::guess_format(bytes).map_err(|_| unknown())?;
    let known = [ImageFormat::Png, ImageFormat::Qoi, ImageFormat::Bmp, ImageFormat::Tiff, ImageFormat::OpenExr];
    if !known.contains(&container) {
        return Err(unknown());
    }
    decode(bytes, container).map_err(|error| Diagnostic::error(None, problem(&error, most_memory(bytes))))
}

fn problem(error: &image::ImageError, most: u64) -> PictureProblem {
    match error {
        image::ImageError::Limits(_) => PictureProblem::TooMuchMemory { most },
        image::ImageError::Decoding(_)
        | image::ImageError::Encoding(_)
        | image::ImageError::Parameter(_)
        | image::ImageError::Unsupported(_)
        | image::ImageError::IoError(_) => PictureProblem::Undecodable(error.to_string()),
    }
}

fn decode(bytes: &[u8], container: ImageFormat) -> image::ImageResult<Picture> {
    let mut limits = image::Limits::default();
    limits.max_alloc = Some(most_memory(bytes));
    let mut reader = image::ImageReader::with_format(Cursor::new(bytes), container);
    reader.limits(limits.clone());
    let decoder = reader.into_decoder()?;
    limits.reserve(decoder.total_bytes())?;
    let (width, height) = decoder.dimensions();
    let linear = matches!(decoder.color_type(), ColorType::Rgb32F | ColorType::Rgba32F);
    let image = DynamicImage::from_decoder(decoder)?;
    if !linear {
        let image = image.into_rgb8();
        let bytes = image.pixels().map(|pixel| pixel.0).collect();
        return Ok(Picture { width, height, bytes, linear: None });
    }
    let linear: Vec<[f32; 3]> = image.into_rgb32f().pixels().map(|pixel| pixel.0).collect();
    let bytes = linear.iter().map(|pixel| Rgb::from(pixel.map(f64::from)).to_bytes()).collect();
    Ok(Picture { width, height, bytes, linear: Some(linear) })
}
