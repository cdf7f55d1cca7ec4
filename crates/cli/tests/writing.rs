//! Every writer of the program where the system fails it: files that may not grow, and a kill in the middle. What stood
//! there before stays whole, nothing is left beside it, and the message names the path.
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stderr, reason = "a test fails by panicking")]

mod common;

use common::{folder, lancer, listing, outcome, program};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// What is written, and by which command line.
const WRITERS: [(&str, &[&str]); 15] = [
    ("out.xml", &["convert", "scene.xml", "out.xml"]),
    ("out.lancer", &["convert", "scene.xml", "out.lancer"]),
    ("2009.xml", &["convert", "scene.xml", "2009.xml", "--to", "2009"]),
    ("out.view.xml", &["convert", "view.xml", "out.view.xml"]),
    ("views2009.xml", &["convert", "view.xml", "views2009.xml", "--to", "2009"]),
    ("out.pov", &["convert", "scene.xml", "out.pov", "--views", "view.xml"]),
    ("out.gltf", &["convert", "scene.xml", "out.gltf"]),
    ("out.glb", &["convert", "scene.xml", "out.glb"]),
    ("out.ppm", &["scene.xml", "view.xml", "out.ppm"]),
    ("raw.ppm", &["scene.xml", "view.xml", "raw.ppm", "--binary"]),
    ("out.png", &["scene.xml", "view.xml", "out.png"]),
    ("out.qoi", &["scene.xml", "view.xml", "out.qoi"]),
    ("out.bmp", &["scene.xml", "view.xml", "out.bmp"]),
    ("out.tif", &["scene.xml", "view.xml", "out.tif"]),
    ("out.exr", &["scene.xml", "view.xml", "out.exr"]),
];

const OLD: &str = "what stood there before";

/// The program with files that may have so many bytes; `None` where there is no `prlimit`, which counts in bytes.
fn limited(bytes: usize, folder: &Path, args: &[&str]) -> Option<(i32, String)> {
    let mut command = Command::new("prlimit");
    command.arg(format!("--fsize={bytes}")).arg(program()).args(args).current_dir(folder);
    let output = command.env("LANG", "C").env("NO_COLOR", "1").output().ok()?;
    Some((output.status.code().unwrap_or(-1), String::from_utf8(output.stderr).unwrap()))
}

#[test]
fn whatever_is_written_replaces_the_old_file_whole_or_not_at_all() {
    for (name, args) in WRITERS {
        let folder = folder();
        let path = folder.path().join(name);
        let (code, _, said) = outcome(&mut lancer(folder.path(), args));
        assert_eq!(code, 0, "{name}: {said}");
        let whole = fs::read(&path).unwrap();
        let before = listing(folder.path());
        for room in [0, 1, whole.len() / 2, whole.len() - 1] {
            fs::write(&path, OLD).unwrap();
            let Some((code, said)) = limited(room, folder.path(), args) else {
                eprintln!("left out: prlimit is not there");
                return;
            };
            assert_eq!(code, 3, "{name} with {room} bytes: {said}");
            let message =
                format!("error: `{name}` cannot be written: the file would be larger than the system allows\n");
            assert!(said.contains(&message), "{name} with {room} bytes: {said}");
            assert_eq!(fs::read_to_string(&path).unwrap(), OLD, "{name} with {room} bytes");
            assert_eq!(listing(folder.path()), before, "{name} with {room} bytes");
        }
        let (code, said) = limited(whole.len(), folder.path(), args).unwrap();
        assert_eq!(code, 0, "{name}: {said}");
        assert!(fs::read(&path).unwrap() == whole, "{name} is another than without a limit");
    }
}

/// No signal is harder than this one: nothing can be tidied up, but the old file is there until the new one is whole.
#[test]
fn a_kill_in_the_middle_leaves_the_old_file_or_the_new_one() {
    let folder = folder();
    let path = folder.path().join("out.xml");
    let args = ["convert", "large.lancer", "out.xml"];
    let (code, _, said) = outcome(&mut lancer(folder.path(), &["generate", "knot", "large.lancer", "--size", "60"]));
    assert_eq!(code, 0, "{said}");
    assert_eq!(outcome(&mut lancer(folder.path(), &args)).0, 0);
    let whole = fs::read(&path).unwrap();
    assert!(whole.len() > 100_000, "{}", whole.len());
    for _ in 0..10 {
        fs::write(&path, OLD).unwrap();
        let mut child = Command::new(program())
            .args(args)
            .current_dir(folder.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        // as soon as something is being written
        let is_part = |name: &String| name.ends_with(".part");
        while child.try_wait().unwrap().is_none() && !listing(folder.path()).iter().any(is_part) {
            std::thread::yield_now();
        }
        let _ = child.kill();
        child.wait().unwrap();
        let found = fs::read(&path).unwrap();
        assert!(found == OLD.as_bytes() || found == whole, "{} bytes that are neither", found.len());
        for part in listing(folder.path()).into_iter().filter(is_part) {
            fs::remove_file(folder.path().join(part)).unwrap();
        }
    }
}
