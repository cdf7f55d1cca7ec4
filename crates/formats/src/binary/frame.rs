//! The frame around the body of a binary file: signature, version, checksum, length. It notices every damage before
//! anything else is looked at.

use super::BinaryProblem;

/// The first bytes of every file: a byte that is no text, letters, both kinds of line ends, and DOS's end of file.
pub(super) const MAGIC: [u8; 8] = *b"\x89LSC\r\n\x1a\n";
const VERSION: std::ops::Range<usize> = 8..12;
const CHECKSUM: std::ops::Range<usize> = 12..16;
const LENGTH: std::ops::Range<usize> = 16..24;
/// Bytes before the body.
pub(super) const HEADER: usize = 24;

/// A new file of that version, ready for its body.
pub(super) fn begin(version: u32) -> Vec<u8> {
    let mut file = MAGIC.to_vec();
    file.extend_from_slice(&version.to_le_bytes());
    file.resize(HEADER, 0);
    file
}

/// Fills in length and checksum of a file that [`begin`] began.
pub(super) fn seal(file: &mut [u8]) {
    let length = file.len() as u64;
    file[LENGTH].copy_from_slice(&length.to_le_bytes());
    let checksum = checksum(file);
    file[CHECKSUM].copy_from_slice(&checksum.to_le_bytes());
}

/// Version and body of an undamaged file.
pub(super) fn open(file: &[u8]) -> Result<(u32, &[u8]), BinaryProblem> {
    if damaged_as_text(file) {
        return Err(BinaryProblem::TransferredAsText);
    }
    if !file.starts_with(&MAGIC) {
        // The beginning of the signature alone is a file cut there; nothing at all is no file of ours.
        let beginning = !file.is_empty() && MAGIC.starts_with(file);
        let cut = BinaryProblem::Cut { found: file.len() as u64, expected: HEADER as u64 };
        return Err(if beginning { cut } else { BinaryProblem::NotBinaryScene });
    }
    let (Some(version), Some(stored), Some(expected)) =
        (number(file, VERSION), number(file, CHECKSUM), number(file, LENGTH))
    else {
        return Err(BinaryProblem::Cut { found: file.len() as u64, expected: HEADER as u64 });
    };
    let (found, version, stored) = (file.len() as u64, u32::from_le_bytes(version), u32::from_le_bytes(stored));
    let expected = u64::from_le_bytes(expected);
    if found < expected {
        return Err(BinaryProblem::Cut { found, expected });
    }
    if found > expected {
        return Err(BinaryProblem::TooLong { found, expected });
    }
    if checksum(file) != stored {
        return Err(BinaryProblem::Damaged);
    }
    Ok((version, &file[HEADER..]))
}

/// Whether the signature went through a transfer that took the file for text: the high bit stripped, the line ends
/// changed, or the bytes re-encoded as UTF-8.
pub(super) fn damaged_as_text(file: &[u8]) -> bool {
    const STRIPPED: &[u8] = b"\x09LSC";
    const RE_ENCODED: [&[u8]; 2] = [b"\xc2\x89LSC", b"\xef\xbf\xbdLSC"];
    const LINE_ENDS: [&[u8]; 4] = [b"\x89LSC\n\x1a", b"\x89LSC\r\r", b"\x89LSC\r\x1a\n", b"\x89LSC\r\n\x1a\r"];
    std::iter::once(STRIPPED).chain(RE_ENCODED).chain(LINE_ENDS).any(|start| file.starts_with(start))
}

/// The bytes of a number of the header.
fn number<const N: usize>(file: &[u8], place: std::ops::Range<usize>) -> Option<[u8; N]> {
    file.get(place)?.try_into().ok()
}

/// The checksum of a whole file but its own four bytes.
fn checksum(file: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&file[..CHECKSUM.start]);
    hasher.update(&file[CHECKSUM.end..]);
    hasher.finalize()
}
