//! Bytes to text and back: how a document is encoded, so that it is saved as it was.
//!
//! Read are UTF-8, UTF-16 with its mark, ISO-8859-1, US-ASCII, and the single-byte encodings of the WHATWG list such as
//! Windows-1252. Each of them maps text back to the very bytes that it came from.

use super::Excerpt;
use super::syntax::{Byte, SyntaxProblem};
use crate::{Source, Span};
use encoding_rs::{UTF_16BE, UTF_16LE};
use std::borrow::Cow;
use std::sync::Arc;

/// How a document's text stands in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Encoding {
    charset: Charset,
    mark: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Charset {
    Utf8,
    Utf16 { big_endian: bool },
    Latin1,
    Ascii,
    SingleByte(&'static encoding_rs::Encoding),
}

impl Default for Encoding {
    /// UTF-8 without a mark.
    fn default() -> Encoding {
        Encoding { charset: Charset::Utf8, mark: false }
    }
}

/// The declaration lies within this many bytes, or is not looked for.
const DECLARATION_BYTES: usize = 1024;
/// Offsets are kept in 32 bits.
const MAX_BYTES: usize = u32::MAX as usize;

impl Charset {
    fn name(self) -> &'static str {
        match self {
            Charset::Utf8 => "UTF-8",
            Charset::Utf16 { .. } => "UTF-16",
            Charset::Latin1 => "ISO-8859-1",
            Charset::Ascii => "US-ASCII",
            Charset::SingleByte(encoding) => encoding.name(),
        }
    }

    /// The charset of a declared label. The web reads ISO-8859-1 and US-ASCII as Windows-1252; here they are themselves.
    fn of_label(label: &str) -> Option<Charset> {
        const LATIN1: [&str; 6] = ["iso-8859-1", "iso8859-1", "iso_8859-1", "latin1", "latin-1", "l1"];
        let is = |names: &[&str]| names.iter().any(|name| label.eq_ignore_ascii_case(name));
        if is(&LATIN1) {
            Some(Charset::Latin1)
        } else if is(&["us-ascii", "ascii"]) {
            Some(Charset::Ascii)
        } else {
            let encoding = encoding_rs::Encoding::for_label(label.as_bytes())?;
            if encoding == encoding_rs::UTF_8 {
                Some(Charset::Utf8)
            } else if encoding == UTF_16LE || encoding == UTF_16BE {
                Some(Charset::Utf16 { big_endian: encoding == UTF_16BE })
            } else {
                encoding.is_single_byte().then_some(Charset::SingleByte(encoding))
            }
        }
    }

    /// The text of bytes; where they are none, a text with U+FFFD at the fault, and the place and value of the byte.
    fn decode(self, bytes: &[u8]) -> Result<Cow<'_, str>, (String, usize, u8)> {
        match self {
            Charset::Utf8 => match std::str::from_utf8(bytes) {
                Ok(text) => Ok(Cow::Borrowed(text)),
                Err(error) => {
                    let at = error.valid_up_to();
                    Err((String::from_utf8_lossy(bytes).into_owned(), at, bytes[at]))
                }
            },
            Charset::Latin1 => Ok(encoding_rs::mem::decode_latin1(bytes)),
            Charset::Ascii => match bytes.iter().position(|byte| !byte.is_ascii()) {
                None => Charset::Utf8.decode(bytes),
                Some(at) => {
                    let text = bytes.iter().map(|&byte| if byte.is_ascii() { char::from(byte) } else { '\u{FFFD}' });
                    Err((text.collect(), at, bytes[at]))
                }
            },
            Charset::Utf16 { big_endian } => decode_utf16(bytes, big_endian).map(Cow::Owned),
            Charset::SingleByte(encoding) => {
                let (text, malformed) = encoding.decode_without_bom_handling(bytes);
                match text.find('\u{FFFD}') {
                    Some(at) if malformed => {
                        let byte = bytes.get(text[..at].chars().count()).copied().unwrap_or_default();
                        Err((text.into_owned(), at, byte))
                    }
                    _ => Ok(text),
                }
            }
        }
    }
}

fn decode_utf16(bytes: &[u8], big_endian: bool) -> Result<String, (String, usize, u8)> {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let unit = |pair: &[u8; 2]| if big_endian { u16::from_be_bytes(*pair) } else { u16::from_le_bytes(*pair) };
    let mut text = String::with_capacity(bytes.len() / 2);
    let mut fault = None;
    for character in char::decode_utf16(pairs.iter().map(unit)) {
        let character = character.unwrap_or_else(|lone| {
            fault.get_or_insert((text.len(), lone.unpaired_surrogate().to_be_bytes()[0]));
            '\u{FFFD}'
        });
        text.push(character);
    }
    if let (None, [byte]) = (fault, rest) {
        fault = Some((text.len(), *byte));
        text.push('\u{FFFD}');
    }
    match fault {
        None => Ok(text),
        Some((at, byte)) => Err((text, at, byte)),
    }
}

impl Encoding {
    /// The bytes of a text. A character that the encoding does not have becomes a numeric reference.
    pub fn encode(self, text: &str) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(text.len() + 3);
        if self.mark {
            let mark: &[u8] = match self.charset {
                Charset::Utf16 { big_endian: true } => b"\xFE\xFF",
                Charset::Utf16 { big_endian: false } => b"\xFF\xFE",
                Charset::Utf8 | Charset::Latin1 | Charset::Ascii | Charset::SingleByte(_) => b"\xEF\xBB\xBF",
            };
            bytes.extend_from_slice(mark);
        }
        match self.charset {
            Charset::Utf8 => bytes.extend_from_slice(text.as_bytes()),
            Charset::Utf16 { big_endian } => bytes.extend(
                text.encode_utf16().flat_map(|unit| if big_endian { unit.to_be_bytes() } else { unit.to_le_bytes() }),
            ),
            Charset::Latin1 => narrow(&mut bytes, text, 0xFF),
            Charset::Ascii => narrow(&mut bytes, text, 0x7F),
            Charset::SingleByte(encoding) => bytes.extend_from_slice(&encoding.encode(text).0),
        }
        bytes
    }
}

/// Characters up to `last` as bytes, the others as numeric references.
fn narrow(bytes: &mut Vec<u8>, text: &str, last: u8) {
    for character in text.chars() {
        match u8::try_from(character) {
            Ok(byte) if byte <= last => bytes.push(byte),
            _ => bytes.extend_from_slice(format!("&#{};", u32::from(character)).as_bytes()),
        }
    }
}

/// A source whose bytes are no text of their encoding, and what is wrong.
pub(super) type Undecodable = (Source, Option<Span>, SyntaxProblem);

/// The text of a document's bytes, without its mark.
pub(super) fn decode(name: Arc<str>, bytes: &[u8]) -> Result<(Source, Encoding), Undecodable> {
    let source = |text: &str| Source { name: name.clone(), text: text.into() };
    if bytes.is_empty() {
        return Err((source(""), None, SyntaxProblem::EmptyFile));
    }
    if bytes.len() > MAX_BYTES {
        return Err((source(""), None, SyntaxProblem::TooLarge));
    }
    let (marked, body) = match bytes {
        [0xEF, 0xBB, 0xBF, body @ ..] => (Some(Charset::Utf8), body),
        [0xFF, 0xFE, body @ ..] => (Some(Charset::Utf16 { big_endian: false }), body),
        [0xFE, 0xFF, body @ ..] => (Some(Charset::Utf16 { big_endian: true }), body),
        _ => (None, bytes),
    };
    let unmarked_utf16 = match bytes {
        [b'<', 0, ..] => Some(Charset::Utf16 { big_endian: false }),
        [0, b'<', ..] => Some(Charset::Utf16 { big_endian: true }),
        _ => None,
    };
    if let Some(charset) = unmarked_utf16 {
        let text = charset.decode(bytes).unwrap_or_else(|(text, ..)| Cow::Owned(text));
        return Err((source(&text), Some(Span { start: 0, end: 1 }), SyntaxProblem::NoByteOrderMark));
    }
    // UTF-16 declares itself in UTF-16, all others in ASCII.
    let mut head: &[u8] = &body[..body.len().min(DECLARATION_BYTES)];
    let narrowed;
    if let Some(Charset::Utf16 { big_endian }) = marked {
        let unit = |pair: &[u8; 2]| if big_endian { u16::from_be_bytes(*pair) } else { u16::from_le_bytes(*pair) };
        // what is wider than a byte is not ASCII, and 255 is not either
        narrowed =
            head.as_chunks().0.iter().map(|pair| u8::try_from(unit(pair)).unwrap_or(u8::MAX)).collect::<Vec<u8>>();
        head = &narrowed;
    }
    let declared = declared_label(head);
    let lossy = |charset: Charset| charset.decode(body).unwrap_or_else(|(text, ..)| Cow::Owned(text));
    let charset = match (&declared, marked) {
        (None, marked) => marked.unwrap_or(Charset::Utf8),
        (Some((label, span)), marked) => {
            let Some(charset) = Charset::of_label(label) else {
                let text = lossy(marked.unwrap_or(Charset::Utf8));
                return Err((
                    source(&text),
                    Some(*span),
                    SyntaxProblem::UnknownEncoding { label: Excerpt::new(label) },
                ));
            };
            let actual = match (marked, charset) {
                (Some(marked), _) => marked,
                // The declaration was legible byte by byte, so this is no UTF-16.
                (None, Charset::Utf16 { .. }) => Charset::Utf8,
                (None, charset) => charset,
            };
            if actual.name() != charset.name() {
                let problem =
                    SyntaxProblem::EncodingContradicted { declared: Excerpt::new(label), actual: actual.name() };
                return Err((source(&lossy(actual)), Some(*span), problem));
            }
            actual
        }
    };
    match charset.decode(body) {
        Ok(text) => Ok((source(&text), Encoding { charset, mark: marked.is_some() })),
        Err((text, start, byte)) => {
            let span = Span { start, end: start + '\u{FFFD}'.len_utf8() };
            Err((source(&text), Some(span), SyntaxProblem::BadBytes { byte: Byte(byte), encoding: charset.name() }))
        }
    }
}

/// The encoding that an XML declaration at the head of a file names, and its place, which is the same in the text
/// because all before it is ASCII.
fn declared_label(head: &[u8]) -> Option<(String, Span)> {
    let head = head.strip_prefix(b"<?xml").map(|_| head)?;
    let end = head.windows(2).position(|pair| pair == b"?>")?;
    let at = head[..end].windows(8).position(|word| word == b"encoding")? + 8;
    let value = head[at..end].iter().position(|byte| matches!(byte, b'"' | b'\'')).map(|quote| at + quote)?;
    if !head[at..value].iter().all(|byte| byte.is_ascii_whitespace() || *byte == b'=') {
        return None;
    }
    let length = head[value + 1..end].iter().position(|&byte| byte == head[value])?;
    let span = Span { start: value + 1, end: value + 1 + length };
    if !head[..span.end].is_ascii() {
        return None;
    }
    let label = std::str::from_utf8(&head[span.start..span.end]).ok()?;
    Some((label.to_owned(), span))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every byte that an encoding reads is written back as itself.
    #[test]
    fn single_bytes_survive() {
        let labels = ["ISO-8859-1", "US-ASCII", "windows-1252", "ISO-8859-15", "windows-1251", "koi8-r", "macintosh"];
        for label in labels {
            let charset = Charset::of_label(label).unwrap();
            for byte in 0..=255_u8 {
                if let Ok(text) = charset.decode(&[byte]) {
                    let encoding = Encoding { charset, mark: false };
                    assert_eq!(encoding.encode(&text), [byte], "{label} {text:?}");
                }
            }
        }
    }

    #[test]
    fn latin_1_is_itself_and_windows_1252_has_the_euro() {
        assert_eq!(Charset::of_label("Latin1").unwrap().decode(b"\x80").unwrap(), "\u{80}");
        assert_eq!(Charset::of_label("CP1252").unwrap().decode(b"\x80").unwrap(), "€");
    }

    #[test]
    fn what_an_encoding_lacks_becomes_a_reference() {
        let encoding = |label| Encoding { charset: Charset::of_label(label).unwrap(), mark: false };
        assert_eq!(encoding("ISO-8859-1").encode("é€"), b"\xE9&#8364;");
        assert_eq!(encoding("windows-1252").encode("é€→"), b"\xE9\x80&#8594;");
        assert_eq!(encoding("US-ASCII").encode("é"), b"&#233;");
    }

    /// A declaration that is damaged before the encoding's name tells nothing: its place in the bytes would be another in
    /// the text.
    #[test]
    fn a_damaged_declaration_is_no_declaration() {
        let wide = |text: &str| -> Vec<u8> {
            std::iter::once(0xFEFF).chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect()
        };
        for bytes in [
            b"<?xml version=\"\xE9.0\" encoding=\"EBCDIC\"?><a/>".to_vec(),
            wide("<?xml versi\u{6F00}n=\"1.0\" encoding=\"UTF-8\"?><a/>"),
            wide("<?xml version=\"1.0\" encoding=\"UTF-\u{6F08}\"?><a/>"),
        ] {
            if let Err((source, Some(span), problem)) = decode("a.xml".into(), &bytes) {
                let boundary = |at| source.text.is_char_boundary(at);
                assert!(boundary(span.start) && boundary(span.end), "{problem:?} {:?}", source.text);
                assert!(matches!(problem, SyntaxProblem::BadBytes { .. }), "{problem:?} {:?}", source.text);
            }
        }
    }

    #[test]
    fn wide_text_keeps_its_order_and_mark() {
        for bytes in [&b"\xFF\xFE<\0a\0/\0>\0"[..], b"\xFE\xFF\0<\0a\0/\0>"] {
            let (source, encoding) = decode("a.xml".into(), bytes).unwrap();
            assert_eq!(&*source.text, "<a/>");
            assert_eq!(encoding.encode(&source.text), bytes);
        }
        let odd = decode("a.xml".into(), b"\xFF\xFE<\0\x3D\xD8a").unwrap_err();
        assert_eq!(odd.2, SyntaxProblem::BadBytes { byte: Byte(0xD8), encoding: "UTF-16" });
    }
}
