//! `lancer check FILE…`: every error and every suspicious thing in scenes and views.
//!
//! A document of views is looked at together with its scene, because many things only show when an eye looks: the scene
//! of the same name beside it (`first.view.xml` with `first.xml`), or the only scene that is given.

use crate::console::Stream;
use crate::documents::{self, Content, Document};
use crate::{Context, Exit, Failure, flags};
use clap::{ArgAction, ArgMatches, Command, value_parser};
use lancer_formats::{Describe, Diagnostic, Problem, Severity};
use lancer_scene::{Finding, Scene, View, Weight};
use lancer_words::cli::{self as words, help};
use lancer_words::{Lang, number};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

pub(crate) fn command(lang: Lang) -> Command {
    Command::new("check")
        .about(help::about_check(lang))
        .after_help(help::after_check(lang))
        .arg(
            flags::positional("files", lang, help::file_value(lang), help::check_files_help(lang))
                .value_parser(value_parser!(PathBuf))
                .action(ArgAction::Append)
                .num_args(1..)
                .required(true),
        )
        .args([
            flags::switch("json", lang, help::check_json_help(lang)),
            flags::quiet(lang),
            flags::allow_outside(lang),
        ])
}

pub(crate) fn run(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    let console = context.console.quiet_if(matches.get_flag("quiet"));
    let mut exit = Exit::Done;
    let mut documents = Vec::new();
    for path in matches.get_many::<PathBuf>("files").into_iter().flatten() {
        match documents::read(path, &flags::load_options(matches)) {
            Ok(document) => documents.push(document),
            Err(failure) => exit = exit.max(console.fail(&failure)),
        }
    }
    lint_together(&mut documents);
    let errors = documents.iter().map(|document| document.count(Severity::Error)).sum();
    let warnings = documents.iter().map(|document| document.count(Severity::Warning)).sum();
    if matches.get_flag("json") {
        console.print_json(&Report::new(&documents, errors, warnings, console.lang))?;
    } else {
        for document in documents.iter().filter(|document| !document.diagnostics.is_empty()) {
            console.print(document.report(&console, Stream::Output) + "\n")?;
        }
        if !console.quiet {
            let files = number::files(console.lang, documents.len());
            let (errors, warnings) = (number::errors(console.lang, errors), number::warnings(console.lang, warnings));
            console.print(words::check_summary(console.lang, files, errors, warnings) + "\n")?;
        }
    }
    Ok(if errors > 0 { exit.max(Exit::Wrong) } else { exit })
}

/// Adds what lint finds to each scene's and each view's diagnostics.
fn lint_together(documents: &mut [Document]) {
    let scenes: Vec<(usize, Scene)> = documents
        .iter()
        .enumerate()
        .filter_map(|(place, document)| match &document.content {
            Some(Content::Scene(scene)) => Some((place, scene.clone())),
            Some(Content::Views(_)) | None => None,
        })
        .collect();
    let owners: Vec<Option<usize>> = documents.iter().map(|document| scene_of(document, documents, &scenes)).collect();
    for (place, scene) in scenes {
        let with: Vec<usize> = (0..owners.len()).filter(|&other| owners[other] == Some(place)).collect();
        let view_documents: Vec<&Document> = with.iter().map(|&other| &documents[other]).collect();
        let views: Vec<Arc<View>> = view_documents.iter().flat_map(|document| document.views().to_vec()).collect();
        for (finding, owner, span) in documents::findings(&scene, &views, &documents[place], &view_documents) {
            let owner = owner.map_or(place, |owner| with[owner]);
            documents[owner].diagnostics.push(Diagnostic::warning(span, finding));
        }
    }
}

/// The place of the scene that a document of views goes with.
fn scene_of(document: &Document, documents: &[Document], scenes: &[(usize, Scene)]) -> Option<usize> {
    if !matches!(document.content, Some(Content::Views(_))) {
        return None;
    }
    let same_name = |place: usize| stem(&documents[place].path) == stem(&document.path);
    let by_name = scenes.iter().map(|(place, _)| *place).find(|&place| same_name(place));
    by_name.or(match scenes {
        [(only, _)] => Some(*only),
        _ => None,
    })
}

/// A path without its extension, and without the `.view` before it.
fn stem(path: &Path) -> PathBuf {
    let stem = path.with_extension("");
    match stem.extension() {
        Some(extension) if extension == "view" || extension == "views" => stem.with_extension(""),
        Some(_) | None => stem,
    }
}

/// What is found, for programs. Version 1; later versions may add members.
#[derive(Serialize)]
struct Report<'a> {
    version: u32,
    files: Vec<File<'a>>,
    /// How many errors and warnings there are in all files.
    errors: usize,
    warnings: usize,
}

/// One document.
#[derive(Serialize)]
struct File<'a> {
    path: String,
    /// `scene` or `views`; nothing where errors leave it open.
    #[serde(skip_serializing_if = "Option::is_none")]
    kind: Option<&'a str>,
    findings: Vec<Found>,
}

/// One thing that is wrong or suspicious.
#[derive(Serialize)]
struct Found {
    /// `error`, `warning`, or `note` for what may well be meant.
    severity: &'static str,
    /// A stable name such as `xml::unknown-attribute`.
    code: &'static str,
    /// In the language of the program.
    message: String,
    /// The rule or the way out.
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<String>,
    /// Where, if it has a place in the text.
    #[serde(skip_serializing_if = "Option::is_none")]
    place: Option<Place>,
}

/// A place in a text.
#[derive(Serialize)]
struct Place {
    /// From 1.
    line: usize,
    /// From 1, in characters.
    column: usize,
    /// The first byte and the byte after the last, of the text in UTF-8.
    start: usize,
    end: usize,
}

impl<'a> Report<'a> {
    fn new(documents: &'a [Document], errors: usize, warnings: usize, lang: Lang) -> Report<'a> {
        let files = documents
            .iter()
            .map(|document| File {
                path: document.path.display().to_string(),
                kind: document.content.as_ref().map(|content| match content {
                    Content::Scene(_) => "scene",
                    Content::Views(_) => "views",
                }),
                findings: document.diagnostics.iter().map(|found| Found::new(found, document, lang)).collect(),
            })
            .collect();
        Report { version: 1, files, errors, warnings }
    }
}

impl Found {
    fn new(diagnostic: &Diagnostic, document: &Document, lang: Lang) -> Found {
        let problem = &diagnostic.problem;
        Found {
            severity: match (diagnostic.severity, problem) {
                (Severity::Error, _) => "error",
                (Severity::Warning, Problem::Lint(finding)) if is_note(finding) => "note",
                (Severity::Warning, _) => "warning",
            },
            code: problem.code(),
            message: problem.message(lang),
            help: problem.help(lang),
            place: diagnostic.span.map(|span| {
                let (line, column) = document.source.position(span.start);
                Place { line, column, start: span.start, end: span.end }
            }),
        }
    }
}

/// Whether a finding may well be meant.
fn is_note(finding: &Finding) -> bool {
    finding.weight() == Weight::Note
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn views_go_with_the_scene_of_the_same_name() {
        assert_eq!(stem(Path::new("scenes/first.view.xml")), stem(Path::new("scenes/first.xml")));
        assert_eq!(stem(Path::new("scenes/first.view.xml")), stem(Path::new("scenes/first.lancer")));
        assert_ne!(stem(Path::new("scenes/first.view.xml")), stem(Path::new("other/first.xml")));
        assert_ne!(stem(Path::new("first.v2.xml")), stem(Path::new("first.xml")));
    }
}
