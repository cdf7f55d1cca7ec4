//! `lancer check` and `lancer show`: errors, findings, pairs, exit codes, and the stable JSON.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::{folder, run};
use serde_json::{Value, json};
use std::fs;

/// Two errors and a warning for those who look.
const BROKEN: &str = r#"<scene version="1">
  <world dpeth="3"/>
  <sphere center="0 0 0" radius="-1"/>
</scene>
"#;

/// A lamp inside a ball: legal, but hardly meant.
const DARK: &str = r#"<scene version="1">
  <light name="lamp" position="0 0 0"/>
  <sphere name="ball" center="0 0 0" radius="1"/>
</scene>
"#;

/// Its screen shows the scene mirrored.
const MIRRORED: &str = r#"<view version="1" name="front" width="40" height="30">
  <eye at="0 0 5"/>
  <screen origin="1 0.75 4" u="-2 0 0" v="0 -1.5 0"/>
</view>
"#;

#[test]
fn what_is_right_is_counted() {
    let folder = folder();
    assert_eq!(
        run(folder.path(), &["check", "scene.xml", "view.xml"]),
        (0, "2 files: 0 errors, 0 warnings\n".to_owned(), String::new())
    );
    assert_eq!(run(folder.path(), &["check", "scene.xml", "view.xml", "-q"]), (0, String::new(), String::new()));
}

#[test]
fn all_errors_of_all_files_are_told_at_once_and_give_1() {
    let folder = folder();
    fs::write(folder.path().join("broken.xml"), BROKEN).unwrap();
    fs::write(folder.path().join("broken.view.xml"), "<view version='1' widht='4'/>").unwrap();
    let (code, told, said) = run(folder.path(), &["check", "broken.xml", "scene.xml", "broken.view.xml"]);
    assert_eq!((code, said.as_str()), (1, ""));
    for place in ["broken.xml:2:10", "broken.xml:3:34", "broken.view.xml:1:"] {
        assert!(told.contains(place), "{place} in\n{told}");
    }
    assert!(told.ends_with("\n3 files: 4 errors, 0 warnings\n"), "{told}");

    // a rendering tells the errors of both documents too
    let (code, told, said) = run(folder.path(), &["broken.xml", "broken.view.xml"]);
    assert_eq!((code, told.as_str()), (1, ""));
    assert!(said.contains("broken.xml:2:10") && said.contains("broken.view.xml:1:"), "{said}");
    let (code, _, said) = run(folder.path(), &["broken.xml", "broken.view.xml", "--lang", "fr"]);
    assert_eq!(code, 1);
    assert!(said.contains("« world » n'a pas d'attribut « dpeth »"), "{said}");
}

#[test]
fn lint_alone_is_0_and_stands_where_the_thing_is_named() {
    let folder = folder();
    fs::write(folder.path().join("dark.xml"), DARK).unwrap();
    fs::write(folder.path().join("dark.view.xml"), MIRRORED).unwrap();
    // the only scene, and the views of its name: the eye looks at the ball from outside
    let (code, told, said) = run(folder.path(), &["check", "dark.view.xml", "dark.xml"]);
    assert_eq!((code, said.as_str()), (0, ""));
    assert!(told.contains("dark.xml:2:16"), "{told}");
    assert!(told.contains("dark.view.xml:3:4"), "{told}");
    assert!(told.ends_with("2 files: 0 errors, 2 warnings\n"), "{told}");

    // a rendering says the same beside its picture, unless it is to be quiet
    let (code, told, said) = run(folder.path(), &["dark.xml", "dark.view.xml"]);
    assert_eq!((code, told.as_str()), (0, ""));
    assert!(said.contains("dark.xml:2:16") && said.contains("dark.view.xml:3:4"), "{said}");
    assert_eq!(run(folder.path(), &["dark.xml", "dark.view.xml", "-q"]), (0, String::new(), String::new()));
}

#[test]
fn of_several_scenes_each_gets_the_views_of_its_own_name() {
    let folder = folder();
    fs::write(folder.path().join("dark.xml"), DARK).unwrap();
    fs::write(folder.path().join("dark.view.xml"), MIRRORED).unwrap();
    let told = |args: &[&str]| -> Value {
        let (code, told, said) = run(folder.path(), &[&["check", "--json"], args].concat());
        assert_eq!((code, said.as_str()), (0, ""));
        serde_json::from_str(&told).unwrap()
    };
    let codes = |file: &Value| -> Vec<String> {
        file["findings"].as_array().unwrap().iter().map(|found| found["code"].as_str().unwrap().to_owned()).collect()
    };
    let report = told(&["scene.xml", "view.xml", "dark.xml", "dark.view.xml"]);
    let files = report["files"].as_array().unwrap();
    assert_eq!(
        files.iter().map(codes).collect::<Vec<_>>(),
        [vec![], vec![], vec!["lint::lamp-inside".to_owned()], vec!["xml::mirrored-screen".to_owned()]]
    );
    assert_eq!((&report["errors"], &report["warnings"]), (&json!(0), &json!(2)));
}

/// The whole of it: members are a promise.
#[test]
fn the_json_has_this_shape() {
    let folder = folder();
    fs::write(folder.path().join("broken.xml"), BROKEN).unwrap();
    fs::write(folder.path().join("dark.xml"), DARK).unwrap();
    let (code, told, said) = run(folder.path(), &["check", "--json", "broken.xml", "dark.xml", "view.xml"]);
    assert_eq!((code, said.as_str()), (1, ""));
    assert!(told.ends_with("}\n") && !told.trim_end().contains('\n'), "one line");
    let report: Value = serde_json::from_str(&told).unwrap();
    assert_eq!(report["version"], 1);
    assert_eq!((&report["errors"], &report["warnings"]), (&json!(2), &json!(1)));
    let files = report["files"].as_array().unwrap();
    assert_eq!(files[0]["path"], "broken.xml");
    assert_eq!(files[0].get("kind"), None);
    assert_eq!(
        files[0]["findings"][0],
        json!({
            "severity": "error",
            "code": "xml::unknown-attribute",
            "message": "`world` has no attribute `dpeth`",
            "help": "its attributes: `ambient`, `background`, `index`, `depth` and `compose`",
            "place": {"line": 2, "column": 10, "start": 29, "end": 34},
        })
    );
    assert_eq!(files[1]["kind"], "scene");
    assert_eq!(files[1]["findings"][0]["severity"], "warning");
    assert_eq!(files[1]["findings"][0]["place"], json!({"line": 2, "column": 16, "start": 35, "end": 39}));
    assert_eq!(files[2], json!({"path": "view.xml", "kind": "views", "findings": []}));
}

#[test]
fn a_file_that_cannot_be_read_is_3_and_the_others_are_checked_all_the_same() {
    let folder = folder();
    fs::write(folder.path().join("broken.xml"), BROKEN).unwrap();
    let (code, told, said) = run(folder.path(), &["check", "nothing.xml", "broken.xml", "."]);
    assert_eq!(code, 3);
    assert_eq!(
        said,
        "error: `nothing.xml` cannot be read: there is no such file\n  help: check the name and the folder\n\
         error: `.` cannot be read: it is a folder\n"
    );
    assert!(told.ends_with("1 file: 2 errors, 0 warnings\n"), "{told}");
}

#[test]
fn scenes_and_views_are_shown() {
    let folder = folder();
    let (code, told, said) = run(folder.path(), &["show", "scene.xml"]);
    assert_eq!((code, said.as_str()), (0, ""));
    assert!(told.starts_with("Ball\n") && told.contains("mirror") && told.contains("floor"), "{told}");
    let (_, french, _) = run(folder.path(), &["show", "scene.xml", "--lang", "fr"]);
    assert!(french.contains("2 objets, 2 sources, 1 matière"), "{french}");
    let (code, told, _) = run(folder.path(), &["show", "view.xml"]);
    assert_eq!(code, 0);
    assert!(told.contains("front") && told.contains("40 × 30"), "{told}");
    assert_eq!(run(folder.path(), &["show", "nothing.xml"]).0, 3);
}

#[test]
fn scene_and_view_exchanged_are_both_told() {
    let folder = folder();
    let (code, told, said) = run(folder.path(), &["view.xml", "scene.xml"]);
    assert_eq!((code, told.as_str()), (1, ""));
    assert!(said.contains("this document holds views, where a scene is due"), "{said}");
    assert!(said.contains("were the two files exchanged?"), "{said}");
}

#[test]
fn missing_and_unreadable_input_is_3() {
    let folder = folder();
    assert_eq!(
        run(folder.path(), &["no.xml", "nor.xml"]),
        (
            3,
            String::new(),
            "error: `no.xml` cannot be read: there is no such file\n  help: check the name and the folder\n\
             error: `nor.xml` cannot be read: there is no such file\n  help: check the name and the folder\n"
                .to_owned()
        )
    );
    assert_eq!(
        run(folder.path(), &["diff", "no.ppm", "scene.xml", "--lang", "fr"]),
        (
            3,
            String::new(),
            "erreur : impossible de lire « no.ppm » : ce fichier n'existe pas\n  aide : vérifiez le nom et le dossier\n"
                .to_owned()
        )
    );
}
