//! The guard of the tracer's cost: instructions of small pictures, counted by valgrind and compared with a record.
//!
//! A clock in a test would fail on a busy machine; the number of instructions is the same to a few in ten thousand,
//! however busy it is. The cost of a frame is that of a 64×48 picture less that of a 1×1 one, which is the cost of
//! starting, reading and compiling. One thread, because waiting threads count too.
//!
//! The program that is counted is the one of the tests: what traces is optimised there as well (Cargo.toml). valgrind
//! 3.19 knows AVX2 but not AVX-512, so `LANCER_SIMD` asks for backends that it knows. A compiler of another version makes
//! other instructions, so the record is for one compiler.

use std::fs;
use std::path::Path;
use std::process::Command;

/// The record, from the root of the checkout.
const RECORD: &str = "benches/instructions.txt";

/// What is counted: few objects with every step of the model, many balls and cones, and many facets.
const SCENES: [&str; 3] = ["scenes/course/course", "scenes/gallery/lattice", "scenes/gallery/knot"];

/// The backends, as `LANCER_SIMD` names them.
const BACKENDS: [&str; 2] = ["portable", "avx2"];

/// The per cent by which a frame may cost more than was recorded.
const FRAME_TOLERANCE: f64 = 2.0;
/// The same for starting: each new option of the command line adds to it.
const START_TOLERANCE: f64 = 20.0;

/// The instructions of one scene with one backend.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Count {
    scene: String,
    backend: String,
    /// Of a picture of one pixel.
    start: u64,
    /// Of all pixels but that one.
    frame: u64,
}

/// Counts, and compares with the record.
pub(crate) fn compare(root: &Path) -> Result<(), String> {
    if let Some(why) = impossible() {
        println!("left out: {why}, so instructions were not counted");
        return Ok(());
    }
    let (compiler, recorded) = read(&fs::read_to_string(root.join(RECORD)).unwrap_or_default());
    let here = compiler_version()?;
    if compiler != here {
        println!("left out: {RECORD} was counted with {compiler:?}, and this is {here:?}");
        return Ok(());
    }
    let counted = count(root)?;
    let (worse, better) = differences(&recorded, &counted);
    for line in &better {
        println!("{line}: renew the record, so that it stays: cargo xtask instructions --renew");
    }
    match worse.is_empty() {
        true => Ok(()),
        false => Err(format!(
            "{}\nfind out where they come from: valgrind --tool=callgrind, then callgrind_annotate\n\
             if they are meant, say why in the commit, and renew the record: cargo xtask instructions --renew",
            worse.join("\n")
        )),
    }
}

/// Counts, and writes the record.
pub(crate) fn renew(root: &Path) -> Result<(), String> {
    if let Some(why) = impossible() {
        return Err(format!("instructions cannot be counted here: {why}"));
    }
    let text = written(&compiler_version()?, &count(root)?);
    print!("{text}");
    fs::write(root.join(RECORD), text).map_err(|error| format!("{RECORD}: {error}"))
}

/// Why nothing can be counted here.
fn impossible() -> Option<&'static str> {
    let valgrind = Command::new("valgrind").arg("--version").output();
    if !cfg!(all(target_os = "linux", target_arch = "x86_64")) {
        Some("the record is for Linux on x86-64")
    } else if !valgrind.is_ok_and(|output| output.status.success()) {
        Some("valgrind is not there")
    } else {
        None
    }
}

/// Whether this machine has a backend's instructions.
fn is_available(backend: &str) -> bool {
    #[cfg(target_arch = "x86_64")]
    let avx2 = std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma");
    #[cfg(not(target_arch = "x86_64"))]
    let avx2 = false;
    backend != "avx2" || avx2
}

fn compiler_version() -> Result<String, String> {
    let output = Command::new("rustc").arg("--version").output().map_err(|error| format!("rustc: {error}"))?;
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// The instructions of each scene with each backend that this machine has.
fn count(root: &Path) -> Result<Vec<Count>, String> {
    crate::chores::cargo(root, &["build", "--package", "lancer"], &[])?;
    let mut counts = Vec::new();
    for scene in SCENES {
        for backend in BACKENDS.into_iter().filter(|backend| is_available(backend)) {
            let start = instructions(root, scene, backend, "1x1")?;
            let whole = instructions(root, scene, backend, "64x48")?;
            let frame = whole.saturating_sub(start);
            counts.push(Count { scene: scene.to_owned(), backend: backend.to_owned(), start, frame });
        }
    }
    Ok(counts)
}

/// The instructions of one run of the program.
fn instructions(root: &Path, scene: &str, backend: &str, size: &str) -> Result<u64, String> {
    let picture = root.join("target/instructions.ppm");
    let mut command = Command::new("valgrind");
    command
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(crate::chores::built("lancer")?)
        .args([format!("{scene}.xml"), format!("{scene}.view.xml")])
        .arg(picture)
        .args(["--binary", "--samples", "1", "--threads", "1", "--quiet", "--size", size])
        .env("LANCER_SIMD", backend)
        .env("LANG", "C")
        .current_dir(root);
    let output = command.output().map_err(|error| format!("valgrind: {error}"))?;
    let told = String::from_utf8_lossy(&output.stderr);
    let collected = told.lines().find_map(|line| line.split("Collected : ").nth(1)?.trim().parse().ok());
    match collected {
        Some(count) if output.status.success() => Ok(count),
        Some(_) | None => Err(format!("{command:?}: {}\n{told}", output.status)),
    }
}

/// What costs more than its tolerance, and what costs as much less; in sentences.
fn differences(recorded: &[Count], counted: &[Count]) -> (Vec<String>, Vec<String>) {
    let (mut worse, mut better) = (Vec::new(), Vec::new());
    for now in counted {
        let Count { scene, backend, .. } = now;
        let Some(before) = recorded.iter().find(|before| before.scene == *scene && before.backend == *backend) else {
            worse.push(format!("{scene}, {backend}: nothing is recorded in {RECORD}"));
            continue;
        };
        for (what, before, now, tolerance) in [
            ("starting", before.start, now.start, START_TOLERANCE),
            ("a frame of 64×48", before.frame, now.frame, FRAME_TOLERANCE),
        ] {
            let change = 100.0 * (now as f64 / before.max(1) as f64 - 1.0);
            let told = |direction: &str| {
                let change = change.abs();
                format!("{scene}, {backend}: {what} takes {now} instructions, {change:.1} % {direction} than {before}")
            };
            if change > tolerance {
                worse.push(told("more"));
            } else if change < -tolerance {
                better.push(told("fewer"));
            }
        }
    }
    (worse, better)
}

/// The record as text.
fn written(compiler: &str, counts: &[Count]) -> String {
    let mut text = format!(
        "# Instructions of `lancer`, counted by valgrind; `cargo xtask ci` compares, `cargo xtask instructions --renew` \
         writes this.\n\
         # start: a picture of one pixel, at most {START_TOLERANCE} % more; frame: the other pixels of 64×48, at most \
         {FRAME_TOLERANCE} % more.\n\
         # {compiler}\n"
    );
    text += &format!("{:<24}{:<10}{:>12}{:>12}\n", "scene", "backend", "start", "frame");
    for Count { scene, backend, start, frame } in counts {
        text += &format!("{scene:<24}{backend:<10}{start:>12}{frame:>12}\n");
    }
    text
}

/// The compiler and the counts of a record.
fn read(text: &str) -> (String, Vec<Count>) {
    let compiler = text.lines().find_map(|line| line.strip_prefix("# rustc ")).map(|rest| format!("rustc {rest}"));
    let counts = text.lines().filter_map(|line| {
        let mut words = line.split_whitespace().map(str::to_owned);
        let (scene, backend) = (words.next()?, words.next()?);
        Some(Count { scene, backend, start: words.next()?.parse().ok()?, frame: words.next()?.parse().ok()? })
    });
    (compiler.unwrap_or_default(), counts.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(backend: &str, start: u64, frame: u64) -> Count {
        Count { scene: "scenes/a".to_owned(), backend: backend.to_owned(), start, frame }
    }

    #[test]
    fn a_record_is_read_as_it_was_written() {
        let counts = vec![count("portable", 5_623_165, 57_523_616), count("avx2", 1, 2)];
        assert_eq!(
            read(&written("rustc 1.95.0 (abc 2026-03-21)", &counts)),
            ("rustc 1.95.0 (abc 2026-03-21)".to_owned(), counts)
        );
        assert_eq!(read(""), (String::new(), Vec::new()));
    }

    #[test]
    fn the_record_of_the_checkout_holds_every_scene_and_backend() {
        let (compiler, counts) = read(&fs::read_to_string(crate::root().join(RECORD)).unwrap());
        assert!(compiler.starts_with("rustc 1."), "{compiler}");
        let held: Vec<_> = counts.iter().map(|count| (count.scene.as_str(), count.backend.as_str())).collect();
        let due: Vec<_> = SCENES.iter().flat_map(|scene| BACKENDS.map(|backend| (*scene, backend))).collect();
        assert_eq!(held, due);
    }

    #[test]
    fn more_than_the_tolerance_is_worse_and_as_much_less_is_better() {
        let before = [count("avx2", 1000, 10_000)];
        assert_eq!(differences(&before, &[count("avx2", 1190, 10_190)]), (vec![], vec![]));
        assert_eq!(differences(&before, &[count("avx2", 810, 9_810)]), (vec![], vec![]));
        let (worse, better) = differences(&before, &[count("avx2", 700, 10_300)]);
        assert_eq!(worse, ["scenes/a, avx2: a frame of 64×48 takes 10300 instructions, 3.0 % more than 10000"]);
        assert_eq!(better, ["scenes/a, avx2: starting takes 700 instructions, 30.0 % fewer than 1000"]);
        let (worse, _) = differences(&before, &[count("portable", 1, 1)]);
        assert_eq!(worse, ["scenes/a, portable: nothing is recorded in benches/instructions.txt"]);
    }
}
