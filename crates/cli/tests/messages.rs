//! Every broken document of `tests/messages` gets exactly the report that stands beside it, in both languages.
//!
//! `UPDATE_REFS=1` writes the reports anew; read them before you keep them.

use lancer::report;
use lancer_formats::mesh::{MeshFile, MeshFiles, MeshProblem};
use lancer_formats::xml::{Document, DocumentKind, read_scene, read_views};
use lancer_formats::{Diagnostic, Source, n7_2009};
use lancer_words::Lang;
use std::fs;
use std::path::{Path, PathBuf};

/// The reports are made for a terminal of this width.
const WIDTH: usize = 100;

/// What these documents say of mesh files is right; what is in the files is no matter here.
struct AnyFile;

impl MeshFiles for AnyFile {
    fn read(&mut self, _path: &str) -> Result<MeshFile, MeshProblem> {
        Ok(MeshFile::new(Default::default(), Vec::new()))
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/messages")
}

/// What is said of a document: of views if its name ends so, else of a scene.
fn diagnose(name: &str, bytes: &[u8]) -> (Source, Vec<Diagnostic>) {
    match Document::read(name, bytes) {
        Err(malformed) => (malformed.source, vec![malformed.diagnostic]),
        Ok(document) => {
            let views = name.ends_with(".view.xml");
            let diagnostics = match document.kind() {
                Some(DocumentKind::Scene2009) if !views => n7_2009::read_scene(&document).diagnostics,
                Some(DocumentKind::Views2009) if views => n7_2009::read_views(&document).diagnostics,
                _ if views => read_views(&document).diagnostics,
                _ => read_scene(&document, &mut AnyFile).diagnostics,
            };
            (document.source().clone(), diagnostics)
        }
    }
}

/// The reports in English and French, without colour.
fn reports(name: &str, bytes: &[u8]) -> String {
    let (source, diagnostics) = diagnose(name, bytes);
    let report = |lang| report::render(&source, &diagnostics, lang, false, WIDTH);
    format!("{}\n{}\n{}", report(Lang::English), "~".repeat(WIDTH), report(Lang::French))
}

#[test]
fn every_broken_document_gets_its_report() {
    let mut names: Vec<String> = fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".xml"))
        .collect();
    names.sort();
    assert!(names.len() >= 60, "only {} documents", names.len());
    let mut wrong = Vec::new();
    for name in names {
        let report = reports(&name, &fs::read(folder().join(&name)).unwrap());
        let expected = folder().join(name.replace(".xml", ".txt"));
        if std::env::var_os("UPDATE_REFS").is_some() {
            fs::write(&expected, &report).unwrap();
        } else if fs::read_to_string(&expected).ok().as_deref() != Some(report.as_str()) {
            wrong.push(format!("{name} now says:\n{report}"));
        }
    }
    assert!(wrong.is_empty(), "{} reports differ:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn colour_is_only_used_when_asked_for() {
    let (source, diagnostics) = diagnose("a.xml", b"<scene version='1'><spheer/></scene>");
    let plain = report::render(&source, &diagnostics, Lang::English, false, WIDTH);
    let colored = report::render(&source, &diagnostics, Lang::English, true, WIDTH);
    assert!(!plain.contains('\u{1b}') && colored.contains('\u{1b}'));
}

#[test]
fn a_report_is_bounded() {
    let many = format!("<scene version='1'>{}</scene>", "<spheer/>\n".repeat(30_000));
    let (source, diagnostics) = diagnose("a.xml", many.as_bytes());
    let report = report::render(&source, &diagnostics, Lang::English, false, WIDTH);
    assert!(report.len() < 200_000);
    assert!(report.contains("and 9901 more"), "{}", &report[report.len() - 200..]);

    let long = format!("<scene version='1'><mesh><vertices>{}x</vertices></mesh></scene>", "1 2 3 ".repeat(2_000_000));
    let (source, diagnostics) = diagnose("a.xml", long.as_bytes());
    assert!(report::render(&source, &diagnostics, Lang::English, false, WIDTH).len() < 4_000);
}

/// The width and the place never break the drawing.
#[test]
fn any_width_and_any_place_can_be_drawn() {
    let text = "<scene version='1'>\n\t<sphere center='é😀\u{301}漢字' radius='x'/>\r\n</scene>\n";
    let source = Source { name: "a.xml".into(), text: text.into() };
    for width in [0, 1, 39, 40, 41, 60, 1000] {
        for start in 0..=text.len() {
            for end in [start, start + 1, start + 30] {
                let span = lancer_formats::Span { start, end };
                let problem = lancer_formats::xml::SyntaxProblem::BareAmpersand;
                let report = report::render(&source, &[Diagnostic::error(span, problem)], Lang::English, false, width);
                assert!(report.contains("a.xml:"), "{report}");
            }
        }
    }
}
