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

#[test]
fn the_version_is_told() {
    assert_eq!(
        run(folder().path(), &["--version"]),
        (0, format!("lancer {}\n", env!("CARGO_PKG_VERSION")), String::new())
    );
}
