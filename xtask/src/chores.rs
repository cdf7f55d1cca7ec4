//! The chores: what the tests need, the tests themselves, and the checks of a submission.

use crate::instructions;
use std::path::Path;
use std::process::{Command, Stdio};

/// A program that tests use, and the Debian package that brings it.
struct Tool {
    /// A command that succeeds if the tool is there.
    probe: &'static [&'static str],
    package: &'static str,
    purpose: &'static str,
}

const XMLLINT: Tool = Tool {
    probe: &["xmllint", "--version"],
    package: "libxml2-utils",
    purpose: "checks the example documents with the published schema",
};

const PYTHON: Tool = Tool {
    probe: &["/usr/bin/python3", "-c", "import numpy"],
    package: "python3-numpy",
    purpose: "renders scenes with the independent implementation under tests/outside",
};

const VALGRIND: Tool = Tool {
    probe: &["valgrind", "--version"],
    package: "valgrind",
    purpose: "counts the instructions of small pictures, so that no change makes them dearer unseen",
};

/// Installs what is missing, then runs every test of the workspace and the independent implementation.
pub(crate) fn test(root: &Path) -> Result<(), String> {
    for tool in [&XMLLINT, &PYTHON] {
        provide(tool);
    }
    cargo(root, &["test", "--workspace", "--quiet"], &[])?;
    if succeeds(PYTHON.probe) {
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

/// Installs a tool's package where the tool is missing and this user may. A test says itself what it leaves out.
fn provide(tool: &Tool) {
    if succeeds(tool.probe) {
        return;
    }
    println!("installing {}: {}", tool.package, tool.purpose);
    let install = format!("apt-get update -q && apt-get install -q -y --no-install-recommends {}", tool.package);
    let installed = [&["sh", "-c", &install][..], &["sudo", "-n", "sh", "-c", &install][..]].into_iter().any(succeeds);
    if !installed {
        println!("could not install it; as root: apt-get install {}", tool.package);
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
