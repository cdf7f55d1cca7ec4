//! Portable pixmaps: the text that is written, and everything that netpbm's manual lets a file hold.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that fails says so by panicking")]

use lancer_formats::picture::{Count, PictureProblem};
use lancer_formats::{Describe, Problem, Span, ppm};
use lancer_scene::Picture;
use lancer_words::Lang;
use proptest::prelude::*;

fn picture(width: u32, height: u32, bytes: &[[u8; 3]]) -> Picture {
    Picture { width, height, bytes: bytes.to_vec(), linear: None }
}

fn plain(picture: &Picture) -> String {
    let mut file = Vec::new();
    ppm::write_plain(picture, &mut file).unwrap();
    String::from_utf8(file).unwrap()
}

fn raw(picture: &Picture) -> Vec<u8> {
    let mut file = Vec::new();
    ppm::write_raw(picture, &mut file).unwrap();
    file
}

fn pixels(file: &[u8]) -> Vec<[u8; 3]> {
    ppm::read(file).unwrap_or_else(|wrong| panic!("{wrong:?} in {:?}", String::from_utf8_lossy(file))).bytes
}

fn refused(file: &[u8]) -> (Span, PictureProblem) {
    let wrong = ppm::read(file).unwrap_err();
    let Problem::Picture(problem) = wrong.problem else { panic!("another problem") };
    (wrong.span.unwrap(), problem)
}

#[test]
fn a_plain_pixmap_is_what_the_specification_says() {
    let picture = picture(2, 2, &[[0, 9, 10], [99, 100, 255], [1, 2, 3], [4, 5, 6]]);
    assert_eq!(plain(&picture), "P3\n# lancer\n2 2\n255\n0 9 10 99 100 255\n1 2 3 4 5 6\n");
}

#[test]
fn a_line_takes_as_many_triples_as_fit_in_70_characters() {
    let widest = picture(11, 1, &[[255; 3]; 11]);
    let text = plain(&widest);
    let lines: Vec<&str> = text.lines().skip(4).collect();
    assert_eq!(lines.iter().map(|line| line.split(' ').count()).collect::<Vec<_>>(), [15, 15, 3]);
}

#[test]
fn the_longest_line_has_exactly_70_characters() {
    let mut row = vec![[0; 3]; 11];
    row[0] = [0, 10, 100];
    let text = plain(&picture(11, 1, &row));
    assert_eq!(text.lines().nth(4).unwrap().len(), 68);
    row[1] = [10, 10, 0];
    let text = plain(&picture(11, 1, &row));
    assert_eq!(text.lines().nth(4).unwrap().len(), 70);
    row[2] = [10, 0, 0];
    let text = plain(&picture(11, 1, &row));
    assert_eq!(text.lines().nth(4).unwrap().len(), 65);
    assert_eq!(text.lines().nth(5).unwrap(), "0 0 0");
}

#[test]
fn a_picture_larger_than_any_buffer_has_no_seam() {
    let bytes: Vec<[u8; 3]> = (0..30_000_u32).map(|i| [i as u8, (i / 7) as u8, (i / 200) as u8]).collect();
    for (width, height) in [(30_000, 1), (200, 150), (1, 30_000)] {
        let picture = picture(width, height, &bytes);
        let text = plain(&picture);
        assert!(text.lines().all(|line| line.len() <= 70 && line.trim() == line));
        assert_eq!(ppm::read(text.as_bytes()).unwrap(), picture);
    }
}

#[test]
fn a_raw_pixmap_is_its_bytes() {
    assert_eq!(raw(&picture(2, 1, &[[1, 2, 3], [10, 0, 255]])), b"P6\n2 1\n255\n\x01\x02\x03\n\x00\xff");
}

#[test]
fn a_picture_that_does_not_fill_its_size_is_not_written() {
    for bad in [picture(2, 2, &[[0; 3]; 3]), picture(0, 0, &[]), picture(0, 7, &[])] {
        let error = ppm::write_plain(&bad, &mut Vec::new()).unwrap_err();
        assert_eq!(error.kind(), std::io::ErrorKind::InvalidInput);
        assert!(ppm::write_raw(&bad, &mut Vec::new()).is_err());
    }
}

#[test]
fn the_example_of_the_subject() {
    let file = b"P3\n# test.ppm\n4 4\n15\n0 0 0 0 0 0 0 0 0 15 0 15\n0 0 0 0 15 7 0 0 0 0 0 0\n\
                 0 0 0 0 0 0 0 15 7 0 0 0\n15 0 15 0 0 0 0 0 0 0 0 0\n";
    let picture = ppm::read(file).unwrap();
    assert_eq!((picture.width, picture.height), (4, 4));
    assert_eq!(picture.pixel(3, 0), Some([255, 0, 255]));
    assert_eq!(picture.pixel(1, 1), Some([0, 255, 119]));
}

#[test]
fn any_white_space_separates() {
    assert_eq!(pixels(b"P3\t\x0b2\x0c\r\n1 \n255\r1\t2\x0b3 \x0c4\n\n5 6"), [[1, 2, 3], [4, 5, 6]]);
    assert_eq!(pixels(b"P6 1 1 255\tabc"), [*b"abc"]);
}

#[test]
fn comments_stand_anywhere_in_the_header() {
    assert_eq!(pixels(b"P3# one\n# two\r#\n 2# width\n 1 # height\n255#\n 1 2 3 4 5 6"), [[1, 2, 3], [4, 5, 6]]);
    assert_eq!(pixels(b"P6#\n1 1\n# before the number 7\n255\nabc"), [*b"abc"]);
    assert_eq!(pixels(b"P3 1 1 255 # in the raster too\n1 2 # as netpbm's programs read it\n3"), [[1, 2, 3]]);
}

#[test]
fn a_comment_may_cut_a_number() {
    assert_eq!(pixels(b"P3 1 1 2#cut\n55 1 2 3"), [[1, 2, 3]]);
    assert_eq!(pixels(b"P6 1 1 25#\n#\n5 abc"), [*b"abc"]);
    let wide =
        ppm::read(b"P3 1#\n2 1 9 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0").unwrap();
    assert_eq!((wide.width, wide.height), (12, 1));
}

#[test]
fn a_comment_behind_a_number_ends_it_where_nothing_else_makes_sense() {
    let picture = ppm::read(b"P3 2#\n1#\n255#\n1 2 3 4 5 6").unwrap();
    assert_eq!((picture.width, picture.height), (2, 1));
    assert_eq!(picture.bytes, [[1, 2, 3], [4, 5, 6]]);
}

#[test]
fn the_raster_begins_behind_one_white_space_character() {
    assert_eq!(pixels(b"P6 1 1 255\n\n \t"), [[b'\n', b' ', b'\t']]);
    assert_eq!(pixels(b"P6 1 1 255 #ab"), [*b"#ab"]);
    // The manual: the end of the comment's line is not sufficient. Netpbm's programs: it is.
    assert_eq!(pixels(b"P6 1 1 255# comment\n\nabc"), [*b"abc"]);
    assert_eq!(pixels(b"P6 1 1 255# comment\nabc"), [*b"abc"]);
    assert_eq!(pixels(b"P6 1 1 255# comment\n\n\n\n"), [[b'\n'; 3]]);
}

#[test]
fn samples_are_scaled_from_every_maximal_value() {
    assert_eq!(pixels(b"P3 1 1 1 0 1 1"), [[0, 255, 255]]);
    assert_eq!(pixels(b"P3 1 1 2 0 1 2"), [[0, 128, 255]]);
    assert_eq!(pixels(b"P3 1 1 65535 0 128 65535"), [[0, 0, 255]]);
    assert_eq!(pixels(b"P3 1 1 65535 128 129 32768"), [[0, 1, 128]]);
    assert_eq!(pixels(b"P6 1 1 65535 \x00\x81\xff\xff\x80\x00"), [[1, 255, 128]]);
    assert_eq!(pixels(b"P6 1 1 256 \x00\x01\x01\x00\x00\x80"), [[1, 255, 128]]);
    assert_eq!(pixels(b"P6 1 1 15 \x00\x07\x0f"), [[0, 119, 255]]);
    assert_eq!(pixels(b"P3 0001 1 00255 000000000000000000000000255 1 2"), [[255, 1, 2]]);
}

#[test]
fn of_several_pictures_the_first_is_read() {
    assert_eq!(pixels(b"P6 1 1 255\nabcP6 1 1 255\ndef"), [*b"abc"]);
    assert_eq!(pixels(b"P3 1 1 255\n1 2 3 and what you like"), [[1, 2, 3]]);
}

#[test]
fn what_is_wrong_is_located() {
    let at = |start, end| Span { start, end };
    let junk = |count| PictureProblem::Junk(count);
    let range = |count, value, max| PictureProblem::OutOfRange { count, value, max };
    let cases: [(&[u8], Span, PictureProblem); 17] = [
        (b"", at(0, 0), PictureProblem::UnknownFormat),
        (b"P", at(0, 1), PictureProblem::UnknownFormat),
        (b"GIF89a", at(0, 2), PictureProblem::UnknownFormat),
        (b"P3", at(2, 2), PictureProblem::MissingNumber(Count::Width)),
        (b"P3 4 # end", at(10, 10), PictureProblem::MissingNumber(Count::Height)),
        (b"P6 4 4\n", at(7, 7), PictureProblem::MissingNumber(Count::Maxval)),
        (b"P32 1 255 1 2 3 4 5 6", at(2, 3), junk(Count::Width)),
        (b"P3 four 4 255", at(3, 7), junk(Count::Width)),
        (b"P3 4 -4 255", at(5, 7), junk(Count::Height)),
        (b"P3 4 4 1.0 0", at(7, 10), junk(Count::Maxval)),
        (b"P3 0 4 255", at(3, 4), range(Count::Width, 0, u32::MAX)),
        (b"P3 4 4294967296 255", at(5, 15), range(Count::Height, 1 << 32, u32::MAX)),
        (b"P6 1 1 65536 ", at(7, 12), range(Count::Maxval, 65_536, 65_535)),
        (b"P3 1 1 15 1 2 0x3", at(14, 17), junk(Count::Sample)),
        (b"P3 1 1 15 1 16 3", at(12, 14), PictureProblem::SampleAboveMaxval { sample: 16, maxval: 15 }),
        (b"P6 1 1 15 \x01\x10\x03", at(11, 12), PictureProblem::SampleAboveMaxval { sample: 16, maxval: 15 }),
        (b"P3 1 2 15 1 2 3 4", at(17, 17), PictureProblem::TooShort { due: 6, found: 4 }),
    ];
    for (file, span, problem) in cases {
        assert_eq!(refused(file), (span, problem), "{:?}", String::from_utf8_lossy(file));
    }
    assert_eq!(refused(b"P6 2 1 255 abcde").1, PictureProblem::TooShort { due: 6, found: 5 });
    assert_eq!(refused(b"P6 2 1 256 \0b\0d\0").1, PictureProblem::TooShort { due: 6, found: 2 });
    assert_eq!(refused(b"P6 1 1 255").1, PictureProblem::TooShort { due: 3, found: 0 });
}

#[test]
fn a_header_cannot_ask_for_more_memory_than_its_file_has() {
    let due = u64::from(u32::MAX) * u64::from(u32::MAX);
    for file in ["P3 4294967295 4294967295 255 1 2 3", "P6 4294967295 4294967295 65535 123456"] {
        let due = due.saturating_mul(3);
        assert_eq!(refused(file.as_bytes()).1, PictureProblem::TooShort { due, found: 3 }, "{file}");
    }
}

#[test]
fn problems_are_told_in_both_languages() {
    let (_, short) = refused(b"P3 1 2 15 1 2 3 4");
    assert_eq!(short.message(Lang::English), "the picture needs 6 samples, but the file ends after 4");
    assert_eq!(short.message(Lang::French), "l'image compte 6 composantes, mais le fichier s'arrête après 4");
    let (_, zero) = refused(b"P3 0 4 255");
    assert_eq!(zero.message(Lang::English), "the width is 0, but must be 1 to 4294967295");
    assert_eq!(zero.code(), "picture::out-of-range");
}

fn any_picture() -> impl Strategy<Value = Picture> {
    (1_u32..40, 1_u32..6).prop_flat_map(|(width, height)| {
        proptest::collection::vec(any::<[u8; 3]>(), (width * height) as usize).prop_map(move |bytes| Picture {
            width,
            height,
            bytes,
            linear: None,
        })
    })
}

proptest! {
    #[test]
    fn both_forms_give_the_picture_back(picture in any_picture()) {
        let text = plain(&picture);
        prop_assert!(text.lines().all(|line| line.len() <= 70 && line.trim() == line));
        prop_assert_eq!(&ppm::read(text.as_bytes()).unwrap(), &picture);
        prop_assert_eq!(&ppm::read(&raw(&picture)).unwrap(), &picture);
    }

    #[test]
    fn a_file_cut_anywhere_is_refused(picture in any_picture(), cut in 0.0..1.0) {
        for file in [plain(&picture).into_bytes(), raw(&picture)] {
            // Without its last two bytes, a plain file lacks a digit of its last sample or the sample itself.
            let end = ((file.len() - 2) as f64 * cut) as usize;
            if let Ok(read) = ppm::read(&file[..end]) {
                // Only a number that was cut to fewer digits still reads.
                prop_assert!(file.starts_with(b"P3") && read.bytes[..read.bytes.len() - 1] == picture.bytes[..read.bytes.len() - 1]);
            }
        }
    }

    #[test]
    fn no_bytes_make_the_reader_panic(
        kind in prop_oneof![Just("P3"), Just("P6")],
        bytes in proptest::collection::vec(prop_oneof![Just(b' '), Just(b'#'), Just(b'\n'), b'0'..=b'9', any::<u8>()], 0..200),
    ) {
        let file = [kind.as_bytes(), &bytes].concat();
        if let Err(wrong) = ppm::read(&file) {
            let span = wrong.span.unwrap();
            prop_assert!(span.start <= span.end && span.end <= file.len());
        }
    }

    #[test]
    fn a_changed_byte_never_makes_it_panic(picture in any_picture(), at in any::<prop::sample::Index>(), byte in any::<u8>()) {
        for mut file in [plain(&picture).into_bytes(), raw(&picture)] {
            let at = at.index(file.len());
            file[at] = byte;
            let _ = ppm::read(&file);
        }
    }
}

/// Not a test of correctness: `cargo test --release -p lancer-formats --test ppm -- --ignored --nocapture`.
#[test]
#[ignore = "a measurement"]
fn full_high_definition_in_milliseconds() {
    let bytes: Vec<[u8; 3]> = (0..1920 * 1080_u32).map(|i| [i as u8, (i / 7) as u8, (i / 1920) as u8]).collect();
    let picture = picture(1920, 1080, &bytes);
    for _ in 0..5 {
        let start = std::time::Instant::now();
        let mut file = Vec::with_capacity(1 << 25);
        ppm::write_plain(&picture, &mut file).unwrap();
        let wrote = start.elapsed();
        let start = std::time::Instant::now();
        assert_eq!(ppm::read(&file).unwrap(), picture);
        println!("P3: {} bytes, written in {wrote:?}, read in {:?}", file.len(), start.elapsed());
        let file = raw(&picture);
        let start = std::time::Instant::now();
        assert_eq!(ppm::read(&file).unwrap(), picture);
        println!("P6: read in {:?}", start.elapsed());
    }
}
