//! The subject's contract and the options of a rendering: what is written, where, and that it is the same for every
//! number of threads.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::{folder, lancer, listing, outcome, run};
use lancer_trace::Simd;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// The header and the triples of a P3 file.
fn p3(bytes: &[u8]) -> (u32, u32, Vec<[u8; 3]>) {
    let picture = lancer_formats::picture::read(bytes).unwrap();
    assert!(bytes.starts_with(b"P3\n# lancer\n"));
    (picture.width, picture.height, picture.bytes)
}

#[test]
fn two_arguments_write_output_ppm_into_the_current_folder_and_say_nothing() {
    let folder = folder();
    assert_eq!(run(folder.path(), &["scene.xml", "view.xml"]), (0, String::new(), String::new()));
    assert_eq!(listing(folder.path()), ["endless.xml", "output.ppm", "scene.xml", "view.xml"]);
    let (width, height, pixels) = p3(&fs::read(folder.path().join("output.ppm")).unwrap());
    assert_eq!((width, height), (40, 30));
    // the sky's colour of infinity in a corner: 255·(.1 .2 .3), rounded half up
    assert_eq!(pixels[0], [26, 51, 77]);
    assert!(pixels.iter().any(|&pixel| pixel != [26, 51, 77]));
}

#[test]
fn the_third_argument_names_the_picture_and_picks_its_format() {
    let folder = folder();
    let read = |name: &str| fs::read(folder.path().join(name)).unwrap();
    for (name, magic) in [
        ("a.ppm", &b"P3\n"[..]),
        ("a.PPM", b"P3\n"),
        ("plain", b"P3\n"),
        ("a.png", b"\x89PNG"),
        ("a.qoi", b"qoif"),
        ("a.bmp", b"BM"),
        ("a.tiff", b"II"),
        ("a.exr", b"\x76\x2f\x31\x01"),
    ] {
        assert_eq!(run(folder.path(), &["scene.xml", "view.xml", name]).0, 0, "{name}");
        assert!(read(name).starts_with(magic), "{name}");
    }
    assert_eq!(run(folder.path(), &["scene.xml", "view.xml", "raw.ppm", "--binary"]).0, 0);
    assert!(read("raw.ppm").starts_with(b"P6\n"));
    for name in ["raw.ppm", "a.png", "a.qoi", "a.bmp", "a.tiff"] {
        assert_eq!(run(folder.path(), &["diff", "a.ppm", name]).0, 0, "{name}");
    }
}

#[test]
fn a_dash_is_standard_output() {
    let folder = folder();
    let (code, picture, said) = run(folder.path(), &["scene.xml", "view.xml", "-"]);
    assert_eq!((code, said.as_str()), (0, ""));
    assert_eq!(run(folder.path(), &["scene.xml", "view.xml"]).0, 0);
    assert_eq!(picture.as_bytes(), fs::read(folder.path().join("output.ppm")).unwrap());
}

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let folder = folder();
    let picture = |threads: &str| run(folder.path(), &["scene.xml", "view.xml", "-", "--threads", threads]).1;
    let one = picture("1");
    for threads in ["2", "3", "4", "16"] {
        assert_eq!(picture(threads), one, "{threads}");
    }
}

#[test]
fn the_reference_and_every_kind_of_instructions_give_the_same_bytes_and_rays() {
    let folder = folder();
    let picture = |simd: &str, options: &[&str]| {
        let args = [&["scene.xml", "view.xml", "-", "--stats=json"], options].concat();
        let mut command = lancer(folder.path(), &args);
        let (code, picture, said) = outcome(command.env("LANCER_SIMD", simd));
        assert_eq!(code, 0, "{said}");
        let stats: Value = serde_json::from_str(&said).unwrap();
        (picture, stats["pictures"][0].clone())
    };
    let (reference, of_reference) = picture("", &["--engine", "reference"]);
    assert_eq!((&of_reference["engine"], of_reference.get("instructions")), (&"reference".into(), None));
    for simd in Simd::ALL.into_iter().filter(|simd| simd.is_available()) {
        let (engine, of_engine) = picture(simd.name(), &[]);
        assert_eq!((&of_engine["engine"], &of_engine["instructions"]), (&"simd".into(), &simd.name().into()));
        assert_eq!(engine, reference, "{simd:?}");
        assert_eq!(of_engine["rays"], of_reference["rays"], "{simd:?}");
    }
}

#[test]
fn instructions_that_are_not_there_are_wrong_use() {
    let folder = folder();
    let available: Vec<&str> = Simd::ALL.iter().filter(|simd| simd.is_available()).map(|simd| simd.name()).collect();
    let available = available.join(", ");
    for args in [
        &["scene.xml", "view.xml"][..],
        &["scene.xml", "view.xml", "--engine=reference"],
        &["explain", "scene.xml", "view.xml", "1", "1"],
    ] {
        let asking = |name: &str| outcome(lancer(folder.path(), args).env("LANCER_SIMD", name));
        assert_eq!(
            asking("sse9"),
            (
                2,
                String::new(),
                format!(
                    "error: LANCER_SIMD asks for the instructions `sse9`, which do not exist\n  \
                     help: this machine can use {available}; without the variable the last of them is used\n"
                )
            )
        );
        for simd in Simd::ALL.into_iter().filter(|simd| !simd.is_available()) {
            let (code, _, said) = asking(simd.name());
            let name = simd.name();
            assert_eq!(code, 2);
            assert!(said.contains(&format!("instructions {name}, which this machine does not have\n")), "{said}");
        }
    }
    assert!(!folder.path().join("output.ppm").exists());
}

#[test]
fn adaptive_samples_refine_some_pixels_and_regions_join() {
    let folder = folder();
    let stats = |options: &[&str]| {
        let args = [&["scene.xml", "view.xml", "-", "--samples", "4", "--stats=json"], options].concat();
        let (code, picture, said) = run(folder.path(), &args);
        assert_eq!(code, 0, "{said}");
        (p3(picture.as_bytes()).2, serde_json::from_str::<Value>(&said).unwrap()["pictures"][0].clone())
    };
    let (whole, told) = stats(&["--adaptive", "0.05"]);
    let refined = told["refined"].as_u64().unwrap();
    assert!(0 < refined && refined < 40 * 30, "{refined}");
    assert_eq!(told["rays"]["primary"], 40 * 30 + 16 * refined);
    let (left, _) = stats(&["--adaptive", "0.05", "--region", "0,0,17,30"]);
    let (right, _) = stats(&["--adaptive", "0.05", "--region", "17,0,23,30"]);
    let joined = |place: usize| match place % 40 {
        x @ 0..17 => left[place / 40 * 17 + x],
        x => right[place / 40 * 23 + x - 17],
    };
    assert!(whole.iter().enumerate().all(|(place, pixel)| *pixel == joined(place)));
    let (everywhere, _) = stats(&[]);
    assert_ne!(whole, everywhere);

    let text = run(folder.path(), &["scene.xml", "view.xml", "--samples=4", "--adaptive=0.05", "--stats"]).1;
    assert!(text.contains(" of 1,200 pixels: they differ from a neighbour and got all samples\n"), "{text}");
    assert_eq!(
        run(folder.path(), &["scene.xml", "view.xml", "--adaptive", "0.05"]),
        (
            1,
            String::new(),
            "error: view `front` takes one sample a pixel, so --adaptive has none to add\n  \
             help: say how many with --samples, such as --samples 4\n"
                .to_owned()
        )
    );
    let (code, _, said) = run(folder.path(), &["scene.xml", "view.xml", "--adaptive", "0,05"]);
    assert_eq!(code, 2);
    assert!(said.contains("a number from 0 to 1 is due, such as 0.05"), "{said}");
}

#[test]
fn a_region_is_a_crop_of_the_whole() {
    let folder = folder();
    let (_, _, whole) = p3(run(folder.path(), &["scene.xml", "view.xml", "-"]).1.as_bytes());
    let part = run(folder.path(), &["scene.xml", "view.xml", "-", "--region", "7,5,20,11"]).1;
    let (width, height, part) = p3(part.as_bytes());
    assert_eq!((width, height), (20, 11));
    for (place, pixel) in part.iter().enumerate() {
        assert_eq!(*pixel, whole[(5 + place / 20) * 40 + 7 + place % 20], "{place}");
    }
}

#[test]
fn views_are_chosen_by_name_or_all_rendered() {
    let folder = folder();
    let sized = |name: &str| {
        let (width, height, _) = p3(&fs::read(folder.path().join(name)).unwrap());
        (width, height)
    };
    assert_eq!(run(folder.path(), &["scene.xml", "view.xml", "--view", "above"]).0, 0);
    assert_eq!(sized("output.ppm"), (32, 24));
    assert_eq!(run(folder.path(), &["scene.xml", "view.xml", "--all-views"]).0, 0);
    assert_eq!((sized("output-front.ppm"), sized("output-above.ppm")), ((40, 30), (32, 24)));
    assert_eq!(run(folder.path(), &["scene.xml", "view.xml", "of {view}.ppm", "--all-views"]).0, 0);
    assert_eq!((sized("of front.ppm"), sized("of above.ppm")), ((40, 30), (32, 24)));
}

#[test]
fn size_samples_depth_and_steps_change_the_view() {
    let folder = folder();
    let picture = |args: &[&str]| {
        let (code, picture, said) = run(folder.path(), &[&["scene.xml", "view.xml", "-"], args].concat());
        assert_eq!((code, said.as_str()), (0, ""), "{args:?}");
        p3(picture.as_bytes())
    };
    let plain = picture(&[]);
    assert_eq!((picture(&["--size", "20x10"]).0, picture(&["--size", "20x10"]).1), (20, 10));
    assert_ne!(picture(&["--samples", "3"]), plain);
    assert_ne!(picture(&["--without", "shadows"]), plain);
    // without mirrored rays and with a depth of 0 alike, the ball's mirror term is 0
    assert_ne!(picture(&["--depth", "0"]), plain);
    assert_eq!(picture(&["--depth", "0"]), picture(&["--without", "reflection,transparency"]));
    assert_eq!(picture(&["--without", "transparency"]), plain);
}

#[test]
fn statistics_are_told_as_json() {
    let folder = folder();
    let (code, told, said) = run(folder.path(), &["scene.xml", "view.xml", "--stats=json", "--threads", "2"]);
    assert_eq!((code, said.as_str()), (0, ""));
    let stats: Value = serde_json::from_str(&told).unwrap();
    assert_eq!(stats["version"], 1);
    assert!(stats["read"].as_f64().unwrap() > 0.0 && stats["compile"].as_f64().unwrap() > 0.0);
    let picture = &stats["pictures"][0];
    assert_eq!((&picture["view"], &picture["output"]), (&"front".into(), &"output.ppm".into()));
    assert_eq!((&picture["width"], &picture["height"], &picture["threads"]), (&40.into(), &30.into(), &2.into()));
    assert!(picture["render"].as_f64().unwrap() > 0.0 && picture["write"].as_f64().unwrap() > 0.0);
    let rays = &picture["rays"];
    let count = |kind: &str| rays[kind].as_u64().unwrap();
    assert_eq!(count("primary"), 40 * 30);
    assert!(count("primary_hits") < 40 * 30 && count("reflected") > 0);
    assert_eq!(count("refracted"), 0);
    assert_eq!(picture["engine"], "simd");
    assert!(["portable", "avx2", "avx512"].iter().any(|name| picture["instructions"] == **name), "{picture}");
    assert_eq!(picture.get("refined"), None);
    assert_eq!(count("total"), count("primary") + count("reflected") + count("shadow"));

    // the same, without shadows and mirrors: primary rays alone
    let (_, told, _) = run(
        folder.path(),
        &["scene.xml", "view.xml", "--stats=json", "--without", "shadows,reflection", "--all-views"],
    );
    let stats: Value = serde_json::from_str(&told).unwrap();
    assert_eq!(stats["pictures"].as_array().unwrap().len(), 2);
    assert_eq!(stats["pictures"][1]["rays"]["total"], 32 * 24);
}

#[test]
fn statistics_are_told_as_text_beside_a_picture_on_standard_output() {
    let folder = folder();
    let (code, picture, said) = run(folder.path(), &["scene.xml", "view.xml", "-", "--stats", "--threads", "1"]);
    assert_eq!(code, 0);
    assert!(picture.starts_with("P3\n"));
    let words: Vec<&str> = said.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert_eq!(words, ["read", "compile", "render", "write", "rays", "primary", "reflected", "refracted", "shadow"]);
    assert!(said.contains("view `front` to -, 40×30, 1 thread, engine simd ("), "{said}");
    let (_, told, _) = run(folder.path(), &["scene.xml", "view.xml", "--stats", "--lang", "fr"]);
    assert!(told.starts_with("lecture ") && told.contains("\n  primaires "), "{told}");
}

/// `script` gives the program a terminal. On it somebody sees a bar, and at the end where the picture is.
#[test]
#[cfg(target_os = "linux")]
fn progress_is_shown_on_a_terminal_only() {
    let folder = folder();
    let on_a_terminal = |options: &str| {
        let command = format!("'{}' scene.xml view.xml {options}", common::program().display());
        let mut script = assert_cmd::Command::new("script");
        script.args(["-qec", &command, "/dev/null"]).current_dir(folder.path()).env("LANG", "C").env("TERM", "xterm");
        script.output().ok().map(|output| String::from_utf8_lossy(&output.stdout).into_owned())
    };
    // a machine without `script` cannot show it
    let Some(shown) = on_a_terminal("") else { return };
    assert!(shown.contains("front ") && shown.contains(" %") && shown.contains("output.ppm: 40×30, "), "{shown:?}");
    assert_eq!(on_a_terminal("-q").unwrap(), "");
    assert_eq!(run(folder.path(), &["scene.xml", "view.xml"]), (0, String::new(), String::new()));
}

#[test]
#[cfg(unix)]
fn links_are_followed_and_modes_kept() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = folder();
    let real = folder.path().join("real.ppm");
    fs::write(&real, "old").unwrap();
    fs::set_permissions(&real, fs::Permissions::from_mode(0o640)).unwrap();
    symlink("real.ppm", folder.path().join("link.ppm")).unwrap();
    assert_eq!(run(folder.path(), &["scene.xml", "view.xml", "link.ppm"]).0, 0);
    assert!(folder.path().join("link.ppm").is_symlink());
    assert!(fs::read(&real).unwrap().starts_with(b"P3\n"));
    assert_eq!(fs::metadata(&real).unwrap().permissions().mode() & 0o777, 0o640);
}

#[test]
fn a_scene_named_like_a_command_is_given_with_its_folder() {
    let folder = folder();
    fs::copy(folder.path().join("scene.xml"), folder.path().join("show")).unwrap();
    assert_eq!(run(folder.path(), &["./show", "view.xml"]), (0, String::new(), String::new()));
}

#[test]
#[cfg(unix)]
fn paths_need_not_be_unicode() {
    use std::os::unix::ffi::OsStrExt;
    let folder = folder();
    let name = Path::new(std::ffi::OsStr::from_bytes(b"sc\xe8ne.xml"));
    fs::copy(folder.path().join("scene.xml"), folder.path().join(name)).unwrap();
    let mut command = lancer(folder.path(), &[]);
    command.arg(name).args(["view.xml", "-", "--size", "2x2"]);
    assert_eq!(outcome(&mut command).0, 0);
}
