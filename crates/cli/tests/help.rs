//! Help, manual page and completions: they exist, in both languages, and name every option.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::{folder, outcome, run};

const COMMANDS: [&str; 10] =
    ["show", "check", "convert", "explain", "diff", "generate", "bench", "schema", "completions", "man"];

#[test]
fn every_command_has_help_in_both_languages() {
    let folder = folder();
    for command in COMMANDS {
        let (code, english, said) = run(folder.path(), &[command, "--help"]);
        assert_eq!((code, said.as_str()), (0, ""), "{command}");
        assert!(english.contains(&format!("\nUsage: lancer {command}")), "{english}");
        let (code, french, _) = run(folder.path(), &[command, "--help", "--lang", "fr"]);
        assert_eq!(code, 0);
        assert!(french.contains(&format!("\nEmploi : lancer {command}")), "{french}");
        assert_eq!(run(folder.path(), &["help", command]).1, english);
        // nothing of the other language is left
        for word in ["Usage", "Print", "possible values", "default"] {
            assert!(!french.contains(word), "`{word}` in the French help of {command}:\n{french}");
        }
    }
}

#[test]
fn the_help_of_the_program_names_every_option_of_the_contract() {
    let folder = folder();
    for lang in ["en", "fr"] {
        let (code, help, _) = run(folder.path(), &["--help", "--lang", lang]);
        assert_eq!(code, 0);
        for option in [
            "--view",
            "--all-views",
            "--size",
            "--depth",
            "--samples",
            "--adaptive",
            "--region",
            "--without",
            "--threads",
            "--engine",
            "LANCER_SIMD",
            "--max-rays",
            "--binary",
            "--stats",
            "--quiet",
            "--allow-outside",
            "--lang",
            "--help",
            "--version",
        ] {
            assert!(help.contains(option), "{option} in\n{help}");
        }
        for command in COMMANDS {
            assert!(help.contains(&format!("  {command} ")), "{command} in\n{help}");
        }
    }
}

#[test]
fn the_locale_chooses_the_language_and_lang_overrules_it() {
    let folder = folder();
    let first_line = |locale: &str, args: &[&str]| {
        let mut command = common::lancer(folder.path(), args);
        command.env("LANG", locale);
        outcome(&mut command).1.lines().next().unwrap().to_owned()
    };
    assert!(first_line("fr_FR.UTF-8", &["--help"]).starts_with("Lancer de rayon"));
    assert!(first_line("C", &["--help"]).starts_with("Ray casting"));
    assert!(first_line("de_DE.UTF-8", &["--help"]).starts_with("Ray casting"));
    assert!(first_line("fr_FR.UTF-8", &["--lang=en", "--help"]).starts_with("Ray casting"));
    assert!(first_line("C", &["--help", "--lang", "fr"]).starts_with("Lancer de rayon"));
}

#[test]
fn completions_and_manual_pages_are_there() {
    let folder = folder();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let (code, script, said) = run(folder.path(), &["completions", shell]);
        assert_eq!((code, said.as_str()), (0, ""));
        assert!(script.contains("--max-rays") || script.contains("max-rays"), "{shell}");
    }
    let (code, page, _) = run(folder.path(), &["man"]);
    assert_eq!(code, 0);
    assert!(page.contains(".TH lancer 1") && page.contains("\\-\\-max\\-rays"), "{page}");
    let (_, page, _) = run(folder.path(), &["man", "explain"]);
    assert!(page.contains("\\-\\-levels"), "{page}");
    let (_, page, _) = run(folder.path(), &["man", "--lang", "fr"]);
    assert!(page.contains(".SH NOM"), "{page}");
}

/// A command is the first word in zsh, and what follows a scene are files and options. The generator has it otherwise:
/// should it change, this says whether what is done about it still takes hold.
#[test]
fn zsh_is_offered_commands_first_and_options_behind_a_scene() {
    let (_, script, _) = run(folder().path(), &["completions", "zsh"]);
    assert!(script.contains("\":: :{_alternative 'commands::_lancer_commands' 'files::_files'}\""), "{script}");
    assert!(script.contains("case $line[1] in") && !script.contains("$line[4]"), "{script}");
    let behind = script.split_once("\n(*)\n").unwrap().1;
    assert!(behind.contains("'--view=[") && behind.contains("'*:file:_files'"), "{behind}");
}

/// What fish itself completes, where it is installed.
#[test]
fn fish_completes_commands_options_and_values() {
    let folder = folder();
    let (_, script, _) = run(folder.path(), &["completions", "fish"]);
    std::fs::write(folder.path().join("lancer.fish"), script).unwrap();
    for (typed, due) in [
        ("lancer expl", "explain"),
        ("lancer scene.xml view.xml --vi", "--view"),
        ("lancer --engine re", "reference"),
        ("lancer completions fi", "fish"),
        ("lancer diff --to", "--tolerance"),
    ] {
        let asked = format!("source lancer.fish; complete -C '{typed}'");
        match std::process::Command::new("fish").args(["-N", "-c", &asked]).current_dir(folder.path()).output() {
            Ok(output) => {
                let offered = String::from_utf8(output.stdout).unwrap();
                assert!(offered.lines().any(|line| line.split('\t').next() == Some(due)), "{typed}: {offered}");
            }
            Err(error) => return println!("left out: fish is not there ({error})"),
        }
    }
}

#[test]
fn the_version_is_told() {
    assert_eq!(
        run(folder().path(), &["--version"]),
        (0, format!("lancer {}\n", env!("CARGO_PKG_VERSION")), String::new())
    );
}
