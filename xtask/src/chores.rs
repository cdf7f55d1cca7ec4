//! The chores: what the tests need, the tests themselves, and the checks of a submission.

use crate::instructions;
use std::path::Path;
use std::process::{Command, Stdio};

/// Something that tests use, and the Debian packages that bring it.
struct Tool {
    /// A command that succeeds if the tool is there.
    probe: &'static [&'static str],
    packages: &'static [&'static str],
    purpose: &'static str,
}

/// The independent implementation under tests/outside.
const PYTHON: Tool = Tool {
    probe: &["/usr/bin/python3", "-c", "import numpy"],
    packages: &["python3-numpy"],
    purpose: "renders scenes with the independent implementation under tests/outside",
};

const TOOLS: [Tool; 4] = [
    Tool {
        probe: &["xmllint", "--version"],
        packages: &["libxml2-utils"],
        purpose: "checks the example documents with the published schema",
    },
    PYTHON,
    Tool {
        probe: &["sh", "-c", "command -v Xvfb && command -v xdotool && command -v import"],
        packages: &["xvfb", "xdotool", "imagemagick"],
        purpose: "a display in memory and a hand on it, for the test of the real window",
    },
    Tool {
        probe: &[
            "sh",
            "-c",
            "for library in libGL.so.1 libX11-xcb.so.1 libXcursor.so.1 libXi.so.6 libxkbcommon-x11.so.0; do \
             PATH=$PATH:/sbin ldconfig -p | grep -q $library || exit 1; done",
        ],
        packages: &[
            "libgl1",
            "libgl1-mesa-dri",
            "libegl1",
            "libx11-xcb1",
            "libxcursor1",
            "libxi6",
            "libxkbcommon0",
            "libxkbcommon-x11-0",
        ],
        purpose: "the libraries of a window, with OpenGL in software",
    },
];

/// Counts instructions.
const VALGRIND: Tool = Tool {
    probe: &["valgrind", "--version"],
    packages: &["valgrind"],
    purpose: "counts the instructions of small pictures, so that no change makes them dearer unseen",
};

/// Installs what is missing, then runs every test of the workspace and the independent implementation.
pub(crate) fn test(root: &Path) -> Result<(), String> {
    for tool in &TOOLS {
        provide(tool);
    }
    cargo(root, &["test", "--workspace", "--quiet"], &[])?;
    if succeeds(PYTHON.probe) {
        run(root, Command::new("/usr/bin/python3").arg("tests/outside/laws.py"))?;
        cargo(root, &["build", "--package", "lancer"], &[])?;
        let lancer = root.join("target/debug/lancer");
        run(root, Command::new("/usr/bin/python3").arg("tests/outside/agrees.py").arg(lancer))?;
        run(root, Command::new("/usr/bin/python3").arg("tests/outside/suite.py"))?;
    } else {
        println!("left out: python3 with numpy is not there, so nothing was compared with tests/outside");
    }
    Ok(())
}

/// The tests, then formatting, lints and documentation, warnings as errors, and the count of instructions.
pub(crate) fn ci(root: &Path) -> Result<(), String> {
    test(root)?;
    cargo(root, &["fmt", "--all", "--check"], &[])?;
    cargo(root, &["clippy", "--workspace", "--all-targets", "--quiet", "--", "--deny", "warnings"], &[])?;
    cargo(root, &["doc", "--workspace", "--no-deps", "--quiet"], &[("RUSTDOCFLAGS", "--deny warnings")])?;
    provide(&VALGRIND);
    instructions::compare(root)
}

/// Installs a tool's packages where the tool is missing and this user may. A test says itself what it leaves out.
fn provide(tool: &Tool) {
    if succeeds(tool.probe) {
        return;
    }
    let packages = tool.packages.join(" ");
    println!("installing {packages}: {}", tool.purpose);
    let install = format!("apt-get update -q && apt-get install -q -y --no-install-recommends {packages}");
    let installed = [&["sh", "-c", &install][..], &["sudo", "-n", "sh", "-c", &install][..]].into_iter().any(succeeds);
    if !installed {
        println!("could not install it; as root: apt-get install {packages}");
    }
}

/// Whether a command runs and succeeds.
fn succeeds(command: &[&str]) -> bool {
    let [program, arguments @ ..] = command else { return false };
    Command::new(program)
        .args(arguments)
        .env("DEBIAN_FRONTEND", "noninteractive")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}

/// Runs cargo in the checkout.
pub(crate) fn cargo(root: &Path, arguments: &[&str], environment: &[(&str, &str)]) -> Result<(), String> {
    run(root, Command::new(env!("CARGO")).args(arguments).envs(environment.iter().copied()))
}

fn run(root: &Path, command: &mut Command) -> Result<(), String> {
    println!("+ {command:?}");
    let status = command.current_dir(root).status().map_err(|error| format!("{command:?}: {error}"))?;
    if status.success() { Ok(()) } else { Err(format!("{command:?}: {status}")) }
}
