//! What README.md shows is what the program says: its commands are run, and their output is compared.
//!
//! In the blocks of the README a line `$ lancer …` is run; what follows it is the output, in which a line `…` stands
//! for any lines. `$ cat FILE` shows a file of the checkout, or one that the later commands find there.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod common;

use common::lancer;
use std::fs;
use std::path::Path;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The commands of the README with the output that it shows.
fn commands(readme: &str) -> Vec<(String, Vec<&str>)> {
    let mut commands: Vec<(String, Vec<&str>)> = Vec::new();
    for block in readme.split("```").skip(1).step_by(2) {
        let lines: Vec<&str> = block.lines().skip(1).collect();
        let Some(first) = lines.iter().position(|line| line.starts_with("$ ")) else { continue };
        for line in &lines[first..] {
            match line.strip_prefix("$ ") {
                Some(command) => commands.push((command.to_owned(), Vec::new())),
                None => commands.last_mut().unwrap().1.push(line),
            }
        }
    }
    commands
}

/// Whether the lines are the shown ones, where `…` stands for any number of lines.
fn agree(shown: &[&str], lines: &[&str]) -> bool {
    match shown.split_first() {
        None => lines.is_empty(),
        Some((&"…", rest)) => (0..=lines.len()).any(|skipped| agree(rest, &lines[skipped..])),
        Some((line, rest)) => lines.split_first().is_some_and(|(found, lines)| line == found && agree(rest, lines)),
    }
}

/// The words of a command; none of the README's is quoted.
fn output(folder: &Path, words: &[&str]) -> String {
    let output = lancer(folder, words).output().unwrap();
    let said = [output.stdout, output.stderr].concat();
    String::from_utf8(said).unwrap()
}

#[test]
fn the_readme_shows_what_the_program_says() {
    let folder = tempfile::tempdir().unwrap();
    let readme = fs::read_to_string(Path::new(ROOT).join("README.md")).unwrap();
    let commands = commands(&readme);
    assert!(commands.len() > 5, "the README has a tour");
    let mut wrong = Vec::new();
    for (command, shown) in &commands {
        let words: Vec<String> = command.split(' ').map(from_the_checkout).collect();
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let said = match words.as_slice() {
            ["cat", file] if Path::new(file).is_absolute() => fs::read_to_string(file).unwrap(),
            ["cat", file] => {
                fs::write(folder.path().join(file), shown.join("\n")).unwrap();
                continue;
            }
            ["lancer", arguments @ ..] => output(folder.path(), arguments),
            other => panic!("the README runs {other:?}"),
        };
        let lines: Vec<&str> = said.lines().map(str::trim_end).collect();
        if !agree(shown, &lines) {
            wrong.push(format!("$ {command}\n{said}"));
        }
    }
    assert!(wrong.is_empty(), "README.md shows something else than:\n\n{}", wrong.join("\n"));
}

/// A word of a command, with the path to the checkout where it names something there.
fn from_the_checkout(word: &str) -> String {
    let path = Path::new(ROOT).join(word);
    if word.contains('/') && path.exists() { path.to_str().unwrap().to_owned() } else { word.to_owned() }
}
