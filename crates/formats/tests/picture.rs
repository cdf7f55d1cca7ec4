//! Pictures in files: the format that a name means, what every format keeps, and what comparing two pictures tells.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that fails says so by panicking")]

use lancer_formats::picture::{self, Format, PictureProblem, Place, Rectangle};
use lancer_formats::{Describe, Problem};
use lancer_scene::Picture;
use lancer_words::Lang;
use std::path::Path;

const FORMATS: [Format; 7] =
    [Format::PlainPpm, Format::RawPpm, Format::Png, Format::Qoi, Format::Bmp, Format::Tiff, Format::Exr];

/// A picture whose linear colours become its bytes.
fn sample() -> Picture {
    let bytes: Vec<[u8; 3]> = (0..7 * 5_u8).map(|i| [i.wrapping_mul(37), 255 - i, i.wrapping_mul(11)]).collect();
    let linear = bytes.iter().map(|pixel| pixel.map(|byte| f32::from(byte) / 255.0)).collect();
    Picture { width: 7, height: 5, bytes, linear: Some(linear) }
}

fn file(picture: &Picture, format: Format) -> Vec<u8> {
    let mut file = Vec::new();
    picture::write(picture, format, &mut file).unwrap();
    file
}

fn problem(file: &[u8]) -> PictureProblem {
    let Problem::Picture(problem) = picture::read(file).unwrap_err().problem else { panic!("another problem") };
    problem
}

#[test]
fn the_extension_chooses_the_format() {
    let of = |name: &str, binary| Format::of_path(Path::new(name), binary);
    assert_eq!(of("output.ppm", false), Ok(Format::PlainPpm));
    assert_eq!(of("output.ppm", true), Ok(Format::RawPpm));
    assert_eq!(of("Output.PPM", true), Ok(Format::RawPpm));
    assert_eq!(of("a.b/c.PNG", true), Ok(Format::Png));
    assert_eq!(of("c.tif", false), Ok(Format::Tiff));
    assert_eq!(of("c.tiff", false), Ok(Format::Tiff));
    assert_eq!(of("c.exr", false), Ok(Format::Exr));
    // The subject names no other format: a bare name is its.
    assert_eq!(of("picture", false), Ok(Format::PlainPpm));
    assert_eq!(of("/dev/null", true), Ok(Format::RawPpm));
}

#[test]
fn an_unknown_extension_is_told_with_the_known_ones() {
    let unknown = Format::of_path(Path::new("picture.jpg"), false).unwrap_err();
    assert_eq!(
        unknown.message(Lang::English),
        "no picture format has the extension .jpg; known are .ppm .pnm .png .qoi .bmp .tif .tiff .exr"
    );
    assert_eq!(
        unknown.message(Lang::French),
        "aucun format d'image n'a l'extension .jpg ; sont connues .ppm .pnm .png .qoi .bmp .tif .tiff .exr"
    );
}

#[test]
fn every_format_gives_the_bytes_back() {
    let picture = sample();
    for format in FORMATS {
        let read = picture::read(&file(&picture, format)).unwrap();
        assert_eq!((read.width, read.height), (7, 5), "{format:?}");
        assert_eq!(read.bytes, picture.bytes, "{format:?}");
        assert_eq!(read.linear.is_some(), format.is_linear(), "{format:?}");
    }
}

#[test]
fn writing_is_deterministic() {
    for format in FORMATS {
        assert_eq!(file(&sample(), format), file(&sample(), format), "{format:?}");
    }
}

#[test]
fn openexr_keeps_the_linear_colours() {
    let mut picture = sample();
    let linear = vec![[0.25, 1e-7, 3.5]; 35];
    picture.linear = Some(linear.clone());
    let read = picture::read(&file(&picture, Format::Exr)).unwrap();
    assert_eq!(read.linear, Some(linear));
    assert_eq!(read.bytes, [[64, 0, 255]; 35]);

    picture.linear = None;
    assert_eq!(picture::read(&file(&picture, Format::Exr)).unwrap().bytes, picture.bytes);
}

/// Nothing in the file may tell a viewer to bend the bytes.
#[test]
fn a_png_has_no_gamma() {
    let file = file(&sample(), Format::Png);
    let mut chunks = Vec::new();
    let mut at = 8;
    while at < file.len() {
        let length = u32::from_be_bytes(file[at..at + 4].try_into().unwrap()) as usize;
        chunks.push(std::str::from_utf8(&file[at + 4..at + 8]).unwrap());
        at += length + 12;
    }
    assert_eq!(chunks, ["IHDR", "IDAT", "IEND"]);
}

#[test]
fn sixteen_bits_are_rounded_to_eight() {
    let wide = image::ImageBuffer::<image::Rgb<u16>, _>::from_raw(1, 1, vec![128_u16, 129, 65_535]).unwrap();
    let mut png = std::io::Cursor::new(Vec::new());
    wide.write_to(&mut png, image::ImageFormat::Png).unwrap();
    assert_eq!(picture::read(png.get_ref()).unwrap().bytes, [[0, 1, 255]]);
}

#[test]
fn a_picture_that_does_not_fill_its_size_is_written_in_no_format() {
    let bad = Picture { bytes: vec![[0; 3]; 3], ..sample() };
    for format in FORMATS {
        let error = picture::write(&bad, format, &mut Vec::new()).unwrap_err();
        assert_eq!(error.kind(), std::io::ErrorKind::InvalidInput, "{format:?}");
    }
}

#[test]
fn files_that_are_no_picture_are_named_so() {
    assert_eq!(problem(b""), PictureProblem::UnknownFormat);
    assert_eq!(problem(b"<scene version=\"1\"/>"), PictureProblem::UnknownFormat);
    assert_eq!(problem(b"P5 1 1 255 a"), PictureProblem::OtherNetpbm('5'));
    let other = problem(b"P7\nWIDTH 1");
    assert_eq!(other.message(Lang::English), "the file is a netpbm file of kind P7, not a colour pixmap");
    assert_eq!(other.help(Lang::English).unwrap(), "PPM (P3 or P6), PNG, QOI, BMP, TIFF and OpenEXR can be read");
    assert!(matches!(problem(b"\x89PNG\r\n\x1a\nno"), PictureProblem::Undecodable(_)));
}

/// A header of a few bytes cannot make the program take gigabytes.
#[test]
fn a_picture_too_large_for_memory_is_refused() {
    let mut png = file(&sample(), Format::Png);
    png[16..24].copy_from_slice(&[0, 0, 0xff, 0xff, 0, 0, 0xff, 0xff]);
    let check = crc32fast::hash(&png[12..29]);
    png[29..33].copy_from_slice(&check.to_be_bytes());
    let wrong = problem(&png);
    assert_eq!(wrong, PictureProblem::TooMuchMemory { most: (64 << 20) + 4096 * png.len() as u64 });
    assert_eq!(wrong.message(Lang::English), "the picture would take more than 64 MiB of memory");
}

/// Marsaglia's xorshift: the same damage in every run.
fn random(state: &mut u64) -> usize {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    (*state >> 32) as usize
}

#[test]
fn damaged_files_never_make_a_reader_panic() {
    let mut state = 0x9e37_79b9_7f4a_7c15;
    for format in FORMATS {
        let whole = file(&sample(), format);
        for end in 0..whole.len().min(400) {
            let _ = picture::read(&whole[..end]);
        }
        for _ in 0..1_000 {
            let mut damaged = whole.clone();
            for _ in 0..1 + random(&mut state) % 3 {
                let at = random(&mut state) % damaged.len();
                damaged[at] = [0, 127, 255, random(&mut state) as u8][random(&mut state) % 4];
            }
            let _ = picture::read(&damaged);
        }
    }
}

#[test]
fn equal_pictures_do_not_differ() {
    let (difference, shown) = picture::compare(&sample(), &sample(), 0).unwrap();
    assert_eq!((difference.pixels, difference.differing, difference.max, difference.mean), (35, 0, 0, 0.0));
    assert_eq!((difference.bounds, difference.first.len()), (None, 0));
    assert!(shown.bytes.iter().all(|[r, g, b]| r == g && g == b && *r < 64));
}

#[test]
fn a_difference_is_counted_measured_and_located() {
    let first = sample();
    let mut second = first.clone();
    let change = |picture: &mut Picture, x: usize, y: usize, by: [i16; 3]| {
        let pixel = &mut picture.bytes[y * 7 + x];
        for (value, by) in pixel.iter_mut().zip(by) {
            *value = (i16::from(*value) + by) as u8;
        }
        *pixel
    };
    let one = change(&mut second, 4, 1, [1, 0, 0]);
    let two = change(&mut second, 2, 3, [0, -3, 2]);

    let (difference, shown) = picture::compare(&first, &second, 0).unwrap();
    assert_eq!((difference.differing, difference.max), (2, 3));
    assert_eq!(difference.mean, 6.0 / 105.0);
    assert_eq!(difference.bounds, Some(Rectangle { x: 2, y: 1, width: 3, height: 3 }));
    assert_eq!(
        difference.first,
        [
            Place { x: 4, y: 1, first: first.pixel(4, 1).unwrap(), second: one },
            Place { x: 2, y: 3, first: first.pixel(2, 3).unwrap(), second: two },
        ]
    );
    assert_eq!((shown.pixel(4, 1), shown.pixel(2, 3)), (Some([255, 1, 0]), Some([255, 3, 0])));

    let (tolerant, _) = picture::compare(&first, &second, 1).unwrap();
    assert_eq!((tolerant.differing, tolerant.max, tolerant.mean), (1, 3, 6.0 / 105.0));
    assert_eq!(tolerant.bounds, Some(Rectangle { x: 2, y: 3, width: 1, height: 1 }));
    assert_eq!(picture::compare(&first, &second, 3).unwrap().0.differing, 0);
}

#[test]
fn at_most_ten_places_are_listed() {
    let first = sample();
    let second = Picture { bytes: vec![[128; 3]; 35], ..first.clone() };
    let (difference, _) = picture::compare(&first, &second, 0).unwrap();
    assert_eq!((difference.differing, difference.first.len()), (35, 10));
    assert_eq!(difference.bounds, Some(Rectangle { x: 0, y: 0, width: 7, height: 5 }));
}

#[test]
fn pictures_of_different_sizes_are_not_compared() {
    let second = Picture { width: 5, height: 7, ..sample() };
    let wrong = picture::compare(&sample(), &second, 0).unwrap_err();
    assert_eq!(wrong.message(Lang::English), "the pictures differ in size: 7×5 and 5×7 pixels");
}
