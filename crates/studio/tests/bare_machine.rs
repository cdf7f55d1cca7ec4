//! A machine that lacks what a window needs: one sentence says what to install, and the program exits with 3.
//!
//! The machine is a folder with the program and the libraries that it is linked with, no others; the program sees
//! nothing else (`chroot`, in a user namespace of its own where the test is not run by root). Where the system allows
//! neither, the test says so and passes.
#![allow(clippy::unwrap_used, clippy::print_stderr, reason = "helpers of a test")]
#![cfg(target_os = "linux")]

use lancer_words::{Lang, studio::app as words};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// What a window needs besides, with the packages, in the order in which it is asked for.
const NEEDED: [(&str, &str); 8] = [
    ("libX11.so.6", "libx11-6"),
    ("libX11-xcb.so.1", "libx11-xcb1"),
    ("libxcb.so.1", "libxcb1"),
    ("libXcursor.so.1", "libxcursor1"),
    ("libXi.so.6", "libxi6"),
    ("libxkbcommon.so.0", "libxkbcommon0"),
    ("libxkbcommon-x11.so.0", "libxkbcommon-x11-0"),
    ("libGL.so.1", "libgl1"),
];

/// A folder that is a machine.
struct Machine(tempfile::TempDir);

impl Machine {
    /// The program and what it is linked with.
    fn bare() -> Machine {
        let machine = Machine(tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap());
        let program = Path::new(env!("CARGO_BIN_EXE_lancer-studio"));
        let within = machine.0.path().join("lancer-studio");
        std::fs::hard_link(program, &within).or_else(|_| std::fs::copy(program, &within).map(drop)).unwrap();
        for library in linked_with(program) {
            machine.install(&library);
        }
        machine
    }

    fn install(&self, library: &Path) {
        let within = self.0.path().join(library.strip_prefix("/").unwrap());
        std::fs::create_dir_all(within.parent().unwrap()).unwrap();
        std::fs::copy(library, within).unwrap();
    }

    fn has(&self, library: &str) -> bool {
        let folders = ["lib", "usr/lib", "lib64", "usr/lib64"].map(|folder| self.0.path().join(folder));
        let triple = format!("{}-linux-gnu", std::env::consts::ARCH);
        folders.iter().any(|folder| folder.join(library).exists() || folder.join(&triple).join(library).exists())
    }

    /// Runs the program there; `None` where the system does not allow it.
    fn run(&self, display: Option<&str>, arguments: &[&str]) -> Option<Output> {
        let root = self.0.path().as_os_str();
        let ways: [&[&str]; 2] = [&["chroot"], &["unshare", "--user", "--map-root-user", "chroot"]];
        ways.into_iter().find_map(|way| {
            let mut command = Command::new(way[0]);
            command.args(&way[1..]).arg(root).arg("/lancer-studio").args(arguments);
            command.env("LANG", "C").env_remove("LC_ALL").env_remove("WAYLAND_DISPLAY").env_remove("DISPLAY");
            command.env_remove("LD_LIBRARY_PATH").envs(display.map(|display| ("DISPLAY", display)));
            // 125 to 127 are those of the programs that begin it
            command.output().ok().filter(|output| !matches!(output.status.code(), Some(1 | 125..=127)))
        })
    }
}

/// The files of the libraries that a program or a library is linked with.
fn linked_with(file: &Path) -> Vec<PathBuf> {
    let output = Command::new("ldd").arg(file).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    text.split_whitespace().filter(|word| word.starts_with('/')).map(PathBuf::from).collect()
}

/// Where the system has a library.
fn installed(library: &str) -> Option<PathBuf> {
    let triple = format!("{}-linux-gnu", std::env::consts::ARCH);
    let folders = ["/usr/lib", "/lib", "/usr/lib64"].map(PathBuf::from);
    folders
        .iter()
        .flat_map(|folder| [folder.join(&triple), folder.clone()])
        .map(|folder| folder.join(library))
        .find(|path| path.is_file())
}

fn said(output: &Output) -> (Option<i32>, String) {
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn what_is_missing_is_named_in_one_sentence() {
    let machine = Machine::bare();
    let Some(without_display) = machine.run(None, &[]) else {
        eprintln!("left out: neither chroot nor unshare is allowed here");
        return;
    };
    assert_eq!(said(&without_display), (Some(3), words::no_display(Lang::English) + "\n"));

    // nobody listens there, but what is missing is found first
    let display = Some("127.0.0.1:99");
    for (library, package) in NEEDED {
        if !machine.has(library) {
            let sentence = words::missing_library(Lang::English, library, package);
            assert_eq!(said(&machine.run(display, &[]).unwrap()), (Some(3), sentence + "\n"));
            let french = words::missing_library(Lang::French, library, package);
            assert_eq!(said(&machine.run(display, &["--lang", "fr"]).unwrap()), (Some(3), french + "\n"));
        }
        let Some(file) = installed(library) else {
            eprintln!("left out from {library} on: it is not installed here");
            return;
        };
        linked_with(&file).into_iter().chain([file]).for_each(|file| machine.install(&file));
    }
    let sentence = words::no_connection(Lang::English, "127.0.0.1:99");
    assert_eq!(said(&machine.run(display, &[]).unwrap()), (Some(3), sentence + "\n"));

    let help = machine.run(None, &["--help"]).unwrap();
    assert!(help.status.success() && help.stderr.is_empty(), "help needs no window");
}
