//! Interruptions, closed pipes and full disks: what real processes do when the world goes wrong.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::{folder, listing, program};
use std::fs;
use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Starts an endless rendering in a folder.
fn endless(folder: &std::path::Path) -> Child {
    let child = Command::new(program())
        .args(["endless.xml", "view.xml", "out.ppm", "--max-rays", "1000000000000"])
        .current_dir(folder)
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_millis(400));
    child
}

fn signal(child: &Child, name: &str) {
    let status = Command::new("kill").args([&format!("-{name}"), &child.id().to_string()]).status().unwrap();
    assert!(status.success());
}

#[test]
fn ctrl_c_and_termination_stop_within_100_ms_and_leave_nothing() {
    let folder = folder();
    let before = listing(folder.path());
    for name in ["INT", "TERM", "HUP"] {
        let mut child = endless(folder.path());
        assert!(child.try_wait().unwrap().is_none(), "the rendering should not end by itself");
        let asked = Instant::now();
        signal(&child, name);
        let status = child.wait().unwrap();
        let waited = asked.elapsed();
        assert_eq!(status.code(), Some(130), "{name}");
        // the grace of the program is 20 ms; the rest is for a busy machine
        assert!(waited < Duration::from_millis(200), "{name}: {waited:?}");
        assert_eq!(listing(folder.path()), before, "{name}");
        let mut said = String::new();
        child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
        assert_eq!(said, "", "{name}");
    }
}

/// The program waits for a reader of a named pipe, deep in the system, where no flag is looked at.
#[test]
fn ctrl_c_ends_a_program_that_waits_for_a_reader() {
    let folder = folder();
    assert!(Command::new("mkfifo").arg(folder.path().join("pipe.ppm")).status().unwrap().success());
    let mut child =
        Command::new(program()).args(["scene.xml", "view.xml", "pipe.ppm"]).current_dir(folder.path()).spawn().unwrap();
    std::thread::sleep(Duration::from_millis(400));
    assert!(child.try_wait().unwrap().is_none(), "nobody reads the pipe yet");
    let asked = Instant::now();
    signal(&child, "INT");
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert!(asked.elapsed() < Duration::from_millis(200), "{:?}", asked.elapsed());
}

/// The program waits for a scene on standard input that never comes.
#[test]
fn ctrl_c_ends_a_program_that_waits_for_its_input() {
    let folder = folder();
    let before = listing(folder.path());
    let mut child = Command::new(program())
        .args(["-", "view.xml", "out.ppm"])
        .current_dir(folder.path())
        .stdin(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_millis(400));
    assert!(child.try_wait().unwrap().is_none(), "the input is still open");
    let asked = Instant::now();
    signal(&child, "INT");
    // `wait` would close the input
    while child.try_wait().unwrap().is_none() && asked.elapsed() < Duration::from_secs(5) {
        std::thread::sleep(Duration::from_millis(1));
    }
    assert!(asked.elapsed() < Duration::from_millis(200), "{:?}", asked.elapsed());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(listing(folder.path()), before);
}

#[test]
fn a_named_pipe_with_a_reader_gets_the_picture() {
    let folder = folder();
    let pipe = folder.path().join("pipe.ppm");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let mut child =
        Command::new(program()).args(["scene.xml", "view.xml", "pipe.ppm"]).current_dir(folder.path()).spawn().unwrap();
    let picture = fs::read(&pipe).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(0));
    assert!(picture.starts_with(b"P3\n# lancer\n40 30\n255\n"));
}

/// A reader that has seen enough is no failure: nothing is said, and the exit code is 0.
#[test]
fn a_closed_pipe_is_quiet() {
    let folder = folder();
    for command in [
        "scene.xml view.xml - --size 600x600",
        "show scene.xml",
        "explain scene.xml view.xml 20 15",
        "schema",
        "completions bash",
        "man",
        "help",
        "--help",
        "--version",
    ] {
        let script = format!("{{ '{}' {command}; echo \"exit $?\" >&2; }} | true", program().display());
        let output =
            Command::new("sh").args(["-c", &script]).current_dir(folder.path()).env("LANG", "C").output().unwrap();
        assert_eq!(String::from_utf8(output.stderr).unwrap(), "exit 0\n", "{command}");
    }
}

/// Every size limit from nothing to just too little: the old file stays whole, and the message names the path.
#[test]
fn a_file_that_may_not_grow_leaves_the_old_one_whole() {
    let folder = folder();
    let before = listing(folder.path());
    let picture = folder.path().join("out.ppm");
    fs::write(&picture, "the old picture").unwrap();
    // in units of 512 bytes; the picture has some 10 kB
    for limit in [0, 1, 2, 8] {
        let script = format!("ulimit -f {limit}; exec '{}' scene.xml view.xml out.ppm", program().display());
        let output =
            Command::new("sh").args(["-c", &script]).current_dir(folder.path()).env("LANG", "C").output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(3), "{limit}: {said}");
        assert_eq!(
            said,
            "error: `out.ppm` cannot be written: the file would be larger than the system allows\n  \
             help: a file that stood there before is unchanged\n"
        );
        assert_eq!(fs::read_to_string(&picture).unwrap(), "the old picture");
        fs::remove_file(&picture).unwrap();
        assert_eq!(listing(folder.path()), before);
        fs::write(&picture, "the old picture").unwrap();
    }
}

/// A device that is always full.
#[test]
fn a_full_device_is_an_error() {
    let folder = folder();
    let said = |args: &[&str]| common::run(folder.path(), args);
    assert_eq!(
        said(&["scene.xml", "view.xml", "/dev/full"]),
        (
            3,
            String::new(),
            "error: `/dev/full` cannot be written: the disk is full\n  \
             help: a file that stood there before is unchanged\n"
                .to_owned()
        )
    );
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = Command::new(program())
        .args(["show", "scene.xml"])
        .current_dir(folder.path())
        .env("LANG", "C")
        .stdout(full)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(3));
    assert!(
        String::from_utf8(output.stderr)
            .unwrap()
            .starts_with("error: standard output cannot be written: the disk is full\n")
    );
}

/// More memory than the process may have: a message, no abort.
#[test]
fn a_picture_that_does_not_fit_into_memory_is_an_error() {
    let folder = folder();
    let script =
        format!("ulimit -v 4000000; exec '{}' scene.xml view.xml out.ppm --size 65535x65535", program().display());
    let output = Command::new("sh").args(["-c", &script]).current_dir(folder.path()).env("LANG", "C").output().unwrap();
    assert_eq!(
        (output.status.code(), String::from_utf8(output.stderr).unwrap().as_str()),
        (
            Some(3),
            "error: there is not enough memory for a picture of 65535×65535 pixels\n  \
             help: render it in parts with --region, or smaller with --size\n"
        )
    );
    assert!(!folder.path().join("out.ppm").exists());
}
