//! Portable pixmaps: the subject's picture format (§4), written as text (P3) or bytes (P6), read as netpbm's manual
//! `ppm(5)` defines both.
//!
//! The manual and netpbm's own programs disagree on one point. A `#` in the header starts a comment; the manual joins
//! what stands before and after it («a comment can actually be in the middle of what you might consider a token»), the
//! programs let the end of its line count as white space. A file is read as the manual says and, where that gives no
//! picture, as the programs do.

use crate::picture::{Count, PictureProblem};
use crate::{Diagnostic, Span};
use lancer_scene::Picture;
use std::io::{self, Write};

/// No line of a plain pixmap is longer.
const LINE: usize = 70;
/// Bytes that are gathered before they are handed on.
const BLOCK: usize = 1 << 16;

/// The decimal digits of every byte with spaces behind, and how many characters they are with one space.
const DIGITS: [([u8; 4], u8); 256] = digits();

const fn digits() -> [([u8; 4], u8); 256] {
    let mut table = [([b' '; 4], 0); 256];
    let mut value = 0;
    while value < 256 {
        let (hundreds, tens, ones) = (value / 100, value / 10 % 10, value % 10);
        let mut length = 0;
        if hundreds > 0 {
            table[value].0[length] = b'0' + hundreds as u8;
            length += 1;
        }
        if value >= 10 {
            table[value].0[length] = b'0' + tens as u8;
            length += 1;
        }
        table[value].0[length] = b'0' + ones as u8;
        table[value].1 = length as u8 + 2;
        value += 1;
    }
    table
}

/// Writes a plain pixmap: `P3`, the comment `# lancer`, the size, `255`, and the triples. Every row of pixels starts
/// on a line of its own, and no line is longer than 70 characters.
///
/// # Errors
/// What `out` says; [`io::ErrorKind::InvalidInput`] for a picture whose pixels do not fill its size.
pub fn write_plain(picture: &Picture, out: &mut dyn Write) -> io::Result<()> {
    check_size(picture)?;
    write!(out, "P3\n# lancer\n{} {}\n255\n", picture.width, picture.height)?;
    let mut block = vec![0; BLOCK];
    let mut filled = 0;
    for row in picture.bytes.chunks_exact(picture.width as usize) {
        let mut column = 0;
        for &[red, green, blue] in row {
            if filled + 3 * DIGITS[0].0.len() > BLOCK {
                // All but the last character, which may have to become a line's end.
                out.write_all(&block[..filled - 1])?;
                block[0] = block[filled - 1];
                filled = 1;
            }
            let [r, g, b] = [red, green, blue].map(|value| &DIGITS[usize::from(value)]);
            let length = usize::from(r.1 + g.1 + b.1);
            // The space behind the last triple of a line becomes the line's end.
            if column + length > LINE + 1 {
                block[filled - 1] = b'\n';
                column = 0;
            }
            column += length;
            for (digits, length) in [r, g, b] {
                block[filled..filled + digits.len()].copy_from_slice(digits);
                filled += usize::from(*length);
            }
        }
        block[filled - 1] = b'\n';
    }
    out.write_all(&block[..filled])
}

/// Writes a raw pixmap: the header `P6`, the size, `255`, and three bytes a pixel.
///
/// # Errors
/// What `out` says; [`io::ErrorKind::InvalidInput`] for a picture whose pixels do not fill its size.
pub fn write_raw(picture: &Picture, out: &mut dyn Write) -> io::Result<()> {
    check_size(picture)?;
    out.write_all(format!("P6\n{} {}\n255\n", picture.width, picture.height).as_bytes())?;
    out.write_all(picture.bytes.as_flattened())
}

/// Refuses a picture whose pixels do not fill its size.
pub(crate) fn check_size(picture: &Picture) -> io::Result<()> {
    let (width, height, found) = (picture.width as usize, picture.height as usize, picture.bytes.len());
    if found == 0 || width.checked_mul(height) != Some(found) {
        let wrong = format!("a picture of {width} by {height} pixels cannot hold {found}");
        return Err(io::Error::new(io::ErrorKind::InvalidInput, wrong));
    }
    Ok(())
}

/// Whether the bytes begin like a plain or raw pixmap.
pub fn is_ppm(bytes: &[u8]) -> bool {
    bytes.starts_with(b"P3") || bytes.starts_with(b"P6")
}

/// Reads the first picture of a plain or raw pixmap. Samples are scaled from 0..maxval to 0..255 and rounded half up.
///
/// # Errors
/// The first place that breaks the format, with its bytes.
pub fn read(bytes: &[u8]) -> Result<Picture, Diagnostic> {
    if !is_ppm(bytes) {
        return Err(Diagnostic::error(Span { start: 0, end: bytes.len().min(2) }, PictureProblem::UnknownFormat));
    }
    read_as(bytes, Comments::Join).or_else(|_| read_as(bytes, Comments::Separate))
}

/// What a comment does to the characters around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Comments {
    /// It is as if it were not there, the end of its line included (the manual).
    Join,
    /// The end of its line is white space (netpbm's programs).
    Separate,
}

fn read_as(bytes: &[u8], comments: Comments) -> Result<Picture, Diagnostic> {
    let mut text = Text { bytes, at: 2, comments };
    if text.next().is_some_and(|byte| !is_space(byte)) {
        return Err(text.problem(2, PictureProblem::Junk(Count::Width)));
    }
    let width = text.number(Count::Width, u32::MAX)?;
    let height = text.number(Count::Height, u32::MAX)?;
    let maxval = text.number(Count::Maxval, 65_535)?;
    let start = text.at.min(bytes.len());
    let pixels = u64::from(width) * u64::from(height);
    let due = pixels.saturating_mul(3);
    let short = |found: usize| {
        let end = Span { start: bytes.len(), end: bytes.len() };
        Diagnostic::error(end, PictureProblem::TooShort { due, found: found as u64 })
    };
    let mut samples = if bytes[1] == b'6' {
        let sample_size = if maxval < 256 { 1 } else { 2 };
        let available = (bytes.len() - start) / sample_size;
        let due = usize::try_from(due).ok().filter(|due| *due <= available).ok_or_else(|| short(available))?;
        Samples::Raw { bytes: &bytes[..start + due * sample_size], at: start, wide: sample_size == 2 }
    } else {
        Samples::Plain(Text { bytes, at: start, comments: Comments::Separate })
    };
    // A sample takes at least one byte and the space behind it: no header can ask for more memory than its file has.
    let room = usize::try_from(pixels).unwrap_or(usize::MAX).min((bytes.len() - start) / 3 + 1);
    let mut colors = Vec::with_capacity(room);
    let scale = |sample: u32| ((510 * sample + maxval) / (2 * maxval)) as u8;
    for _ in 0..pixels {
        let mut pixel = [0; 3];
        for (channel, value) in pixel.iter_mut().enumerate() {
            *value = match samples.next(maxval)? {
                Some(sample) => scale(sample),
                None => return Err(short(3 * colors.len() + channel)),
            };
        }
        colors.push(pixel);
    }
    Ok(Picture { width, height, bytes: colors, linear: None })
}

/// Where the samples of a raster come from.
enum Samples<'a> {
    /// Numbers in text.
    Plain(Text<'a>),
    /// One byte or two, the most significant first; the slice ends with the raster.
    Raw { bytes: &'a [u8], at: usize, wide: bool },
}

impl Samples<'_> {
    /// The next sample; `None` at the end of the file.
    fn next(&mut self, maxval: u32) -> Result<Option<u32>, Diagnostic> {
        match self {
            Samples::Plain(text) => {
                if text.skip_space().is_none() {
                    return Ok(None);
                }
                let start = text.at - 1;
                let sample = text.digits(start, Count::Sample)?;
                if sample > u64::from(maxval) {
                    return Err(text.problem(start, PictureProblem::SampleAboveMaxval { sample, maxval }));
                }
                Ok(Some(sample as u32))
            }
            Samples::Raw { bytes, at, wide } => {
                let size = if *wide { 2 } else { 1 };
                let Some(sample) = bytes.get(*at..*at + size) else { return Ok(None) };
                let span = Span { start: *at, end: *at + size };
                *at += size;
                let sample = sample.iter().fold(0, |value, byte| value << 8 | u32::from(*byte));
                if sample > maxval {
                    let sample = u64::from(sample);
                    return Err(Diagnostic::error(span, PictureProblem::SampleAboveMaxval { sample, maxval }));
                }
                Ok(Some(sample))
            }
        }
    }
}

/// The characters of a header or of a plain raster, without their comments.
struct Text<'a> {
    bytes: &'a [u8],
    /// The byte after the last one that was given.
    at: usize,
    comments: Comments,
}

impl Text<'_> {
    /// The next character that is in no comment. At the end, `at` stands one behind the last byte.
    fn next(&mut self) -> Option<u8> {
        loop {
            let byte = self.bytes.get(self.at).copied();
            self.at = (self.at + 1).min(self.bytes.len() + 1);
            if byte != Some(b'#') {
                return byte;
            }
            let comment = self.bytes.get(self.at..).unwrap_or_default();
            self.at += comment.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(comment.len());
            if self.comments == Comments::Join {
                self.at += 1;
            }
        }
    }

    /// The first character that is no white space.
    fn skip_space(&mut self) -> Option<u8> {
        loop {
            match self.next() {
                Some(byte) if is_space(byte) => {}
                other => return other,
            }
        }
    }

    /// A number of the header, 1..=`max`, and the one white-space character behind it.
    fn number(&mut self, count: Count, max: u32) -> Result<u32, Diagnostic> {
        if self.skip_space().is_none() {
            return Err(self.problem(self.bytes.len(), PictureProblem::MissingNumber(count)));
        }
        let start = self.at - 1;
        let value = self.digits(start, count)?;
        match u32::try_from(value) {
            Ok(value) if (1..=max).contains(&value) => Ok(value),
            _ => Err(self.problem(start, PictureProblem::OutOfRange { count, value, max })),
        }
    }

    /// The number whose first character stands at `start` and was given last, with the white-space character behind it.
    /// A number that no `u64` holds counts as the greatest.
    fn digits(&mut self, start: usize, count: Count) -> Result<u64, Diagnostic> {
        let mut value = 0_u64;
        let mut byte = self.bytes.get(start).copied();
        while let Some(digit) = byte.filter(u8::is_ascii_digit) {
            value = value.saturating_mul(10).saturating_add(u64::from(digit - b'0'));
            byte = self.next();
        }
        match byte {
            Some(byte) if !is_space(byte) => Err(self.problem(start, PictureProblem::Junk(count))),
            _ => Ok(value),
        }
    }

    /// A problem with the word that starts at a byte.
    fn problem(&self, start: usize, problem: PictureProblem) -> Diagnostic {
        let start = start.min(self.bytes.len());
        let word = &self.bytes[start..];
        let length = word.iter().position(|byte| is_space(*byte) || *byte == b'#').unwrap_or(word.len()).min(LINE);
        Diagnostic::error(Span { start, end: start + length }, problem)
    }
}

/// What C's `isspace` calls white space, as the manual says.
fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | 0x0b | 0x0c)
}
