//! `lancer diff`: the whole text, the exit codes, the picture of the differences.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::run;
use std::fs;
use tempfile::TempDir;

/// Three pictures of 4×3 grey pixels: `b` differs from `a` in three pixels, by at most 5; `c` is smaller.
fn pictures() -> TempDir {
    let folder = TempDir::new().unwrap();
    let grey = |change: fn(usize) -> u8| {
        let triples: String = (0..12).map(|place| format!("100 {} 100\n", change(place))).collect();
        format!("P3 4 3 255\n{triples}")
    };
    fs::write(folder.path().join("a.ppm"), grey(|_| 100)).unwrap();
    fs::write(
        folder.path().join("b.ppm"),
        grey(|place| [100, 100, 100, 100, 100, 102, 95, 100, 100, 101, 100, 100][place]),
    )
    .unwrap();
    fs::write(folder.path().join("c.ppm"), "P3 1 1 255\n0 0 0\n").unwrap();
    folder
}

#[test]
fn the_same_picture_is_the_same_in_every_format() {
    let folder = pictures();
    let same = (0, "the pictures are the same\n".to_owned(), String::new());
    assert_eq!(run(folder.path(), &["diff", "a.ppm", "a.ppm"]), same);
    fs::write(
        folder.path().join("half.ppm"),
        "P3 # half the maximal value\n4 3 51\n".to_owned() + &"20 20 20 ".repeat(12),
    )
    .unwrap();
    assert_eq!(run(folder.path(), &["diff", "a.ppm", "half.ppm"]), same);
    assert_eq!(run(folder.path(), &["diff", "a.ppm", "a.ppm", "--quiet"]), (0, String::new(), String::new()));
}

#[test]
fn differences_are_counted_located_and_listed() {
    let folder = pictures();
    let (code, told, said) = run(folder.path(), &["diff", "a.ppm", "b.ppm"]);
    assert_eq!((code, said.as_str()), (1, ""));
    assert_eq!(
        told,
        "3 of 12 pixels differ (25.0000 %)
greatest difference 5 of 255, mean 0.222222
in columns 1 to 2, rows 1 to 2
the first 3:
   column      row  A            B
        1        1  100 100 100  100 102 100
        2        1  100 100 100  100  95 100
        1        2  100 100 100  100 101 100
"
    );
    let (_, told, _) = run(folder.path(), &["diff", "a.ppm", "b.ppm", "--lang", "fr"]);
    assert!(told.starts_with("3 sur 12 pixels diffèrent (25.0000 %)\n"), "{told}");
}

#[test]
fn a_tolerance_lets_small_differences_pass() {
    let folder = pictures();
    assert_eq!(run(folder.path(), &["diff", "a.ppm", "b.ppm", "--tolerance", "4", "-q"]).0, 1);
    assert_eq!(
        run(folder.path(), &["diff", "a.ppm", "b.ppm", "--tolerance", "5"]),
        (0, "12 pixels: none differs by more than 5; the greatest difference is 5 of 255\n".to_owned(), String::new())
    );
}

#[test]
fn the_differences_are_drawn() {
    let folder = pictures();
    assert_eq!(run(folder.path(), &["diff", "a.ppm", "b.ppm", "-o", "d.png", "-q"]).0, 1);
    let drawn = lancer_formats::picture::read(&fs::read(folder.path().join("d.png")).unwrap()).unwrap();
    assert_eq!((drawn.width, drawn.height), (4, 3));
    assert_eq!(drawn.pixel(0, 0), Some([25, 25, 25]));
    assert_eq!(drawn.pixel(2, 1), Some([255, 5, 0]));
    let (code, _, said) = run(folder.path(), &["diff", "a.ppm", "b.ppm", "-o", "no/such/d.png"]);
    assert_eq!(code, 3);
    assert!(said.starts_with("error: `no/such/d.png` cannot be written"), "{said}");
}

#[test]
fn pictures_of_different_sizes_differ() {
    let folder = pictures();
    let (code, told, said) = run(folder.path(), &["diff", "a.ppm", "c.ppm"]);
    assert_eq!((code, said.as_str()), (1, ""));
    assert!(told.contains("4×3") && told.contains("1×1"), "{told}");
}
