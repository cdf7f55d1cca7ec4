//! Every class of failure: the exit code and the whole text. Nothing is written where a rendering fails.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::{folder, listing, run};
use std::fs;

/// Runs the program, which must fail without a word on standard output and without a new file.
fn failure(args: &[&str]) -> (i32, String) {
    let folder = folder();
    failure_in(folder.path(), args)
}

fn failure_in(folder: &std::path::Path, args: &[&str]) -> (i32, String) {
    let before = listing(folder);
    let (code, told, said) = run(folder, args);
    assert_eq!(told, "");
    assert_eq!(listing(folder), before);
    (code, said)
}

fn told(code: i32, text: &str) -> (i32, String) {
    (code, text.to_owned())
}

#[test]
fn an_unknown_view_names_the_others() {
    assert_eq!(
        failure(&["scene.xml", "view.xml", "--view", "fromt"]),
        told(1, "error: there is no view `fromt` in `view.xml`\n  help: its views are `front`, `above`\n")
    );
    assert_eq!(
        failure(&["scene.xml", "view.xml", "--view", "fromt", "--lang", "fr"]),
        told(
            1,
            "erreur : il n'y a pas de vue « fromt » dans « view.xml »\n  aide : ses vues sont « front », « above »\n"
        )
    );
}

/// A mistyped command is read as a scene; the complaint about it says so.
#[test]
fn a_mistyped_command_is_recognised() {
    let missing = "error: `shwo` cannot be read: there is no such file\n  help: check the name and the folder\n";
    let meant = "  help: did you mean the command `show`? What stands there is taken for the name of a scene\n";
    let (code, said) = failure(&["shwo", "view.xml"]);
    assert_eq!((code, said), (3, format!("{missing}{meant}")));
    let (code, said) = failure(&["expalin", "scene.xml", "view.xml", "1", "2", "--lang", "fr"]);
    assert_eq!(code, 2);
    assert!(
        said.ends_with("aide : vouliez-vous la commande « explain » ? Ce mot est pris pour le nom d'une scène\n"),
        "{said}"
    );
    // a scene that is there is a scene, whatever its name
    let folder = folder();
    fs::copy(folder.path().join("scene.xml"), folder.path().join("shwo")).unwrap();
    assert_eq!(run(folder.path(), &["shwo", "view.xml", "-", "--size", "1x1", "--quiet"]).0, 0);
}

/// Standard input has one end.
#[test]
fn two_files_cannot_both_be_standard_input() {
    let due = "error: `-` is standard input, which can be read only once: name a file for one of the two\n";
    for args in [&["-", "-"][..], &["explain", "-", "-", "1", "1"], &["diff", "-", "-"]] {
        assert_eq!(failure(args), told(2, due), "{args:?}");
    }
}

/// A number below 0 is a wrong value, no unknown option.
#[test]
fn a_negative_column_is_a_wrong_value() {
    let (code, said) = failure(&["explain", "scene.xml", "view.xml", "-1", "5"]);
    assert!(code == 2 && said.starts_with("error: invalid value '-1' for '<X>': a whole number from 0 to"), "{said}");
}

/// One ray is one ray.
#[test]
fn a_budget_of_one_ray_is_told_in_the_singular() {
    let (code, said) = failure(&["scene.xml", "view.xml", "--max-rays", "1", "--quiet"]);
    assert!(code == 1 && said.contains("needs more than 1 ray\n"), "{said}");
}

#[test]
fn of_many_views_the_nearest_names_are_told() {
    let folder = folder();
    let views: String = (0..20)
        .map(|number| format!("<view name='camera {number:02}'><eye at='0 1 4' look-at='0 0 0'/></view>"))
        .collect();
    fs::write(folder.path().join("view.xml"), format!("<views version='1'>{views}</views>")).unwrap();
    assert_eq!(
        failure_in(folder.path(), &["scene.xml", "view.xml", "--view", "camera 7"]),
        told(
            1,
            "error: there is no view `camera 7` in `view.xml`\n  help: the nearest names of its 20 views are \
             `camera 07`, `camera 17`, `camera 00`, `camera 01`, `camera 02`\n"
        )
    );
}

#[test]
fn a_region_or_a_pixel_outside_the_picture_tells_its_size() {
    assert_eq!(
        failure(&["scene.xml", "view.xml", "--region", "30,0,11,5"]),
        told(
            1,
            "error: the region 30,0,11,5 does not lie in the picture\n  help: the picture of view `front` has 40×30 \
             pixels: columns 0 to 39, rows 0 to 29\n"
        )
    );
    assert_eq!(
        failure(&["explain", "scene.xml", "view.xml", "0", "30"]),
        told(
            1,
            "error: pixel 0, 30 does not lie in the picture\n  help: the picture of view `front` has 40×30 pixels: \
             columns 0 to 39, rows 0 to 29\n"
        )
    );
    assert_eq!(
        failure(&["explain", "scene.xml", "view.xml", "40", "0", "--lang", "fr"]),
        told(
            1,
            "erreur : le pixel 40, 0 sort de l'image\n  aide : l'image de la vue « front » a 40×30 pixels : colonnes 0 \
             à 39, lignes 0 à 29\n"
        )
    );
}

#[test]
fn a_pixel_that_costs_too_much_is_located() {
    let text = "error: pixel 0, 0 of view `front` needs more than 5000 rays\n  help: lower the depth limit (--depth), or \
                allow more rays with --max-rays\n";
    for threads in ["1", "4"] {
        let args = ["endless.xml", "view.xml", "--max-rays", "5000", "--threads", threads];
        assert_eq!(failure(&args), told(1, text));
    }
    assert_eq!(failure(&["explain", "endless.xml", "view.xml", "0", "0", "--max-rays", "5000"]), told(1, text));
}

#[test]
fn two_views_of_one_file_name_are_refused_before_anything_is_rendered() {
    let folder = folder();
    let view = |name: &str| format!("<view name='{name}'><eye at='0 1 4' look-at='0 0 0'/></view>");
    let views = format!("<views version='1'>{}{}</views>", view("a/b"), view("a_b"));
    fs::write(folder.path().join("view.xml"), views).unwrap();
    assert_eq!(
        failure_in(folder.path(), &["scene.xml", "view.xml", "--all-views"]),
        told(
            1,
            "error: views `a/b` and `a_b` would both be written to `output-a_b.ppm`\n  help: rename one of them, or \
             render them one at a time with --view\n"
        )
    );
}

/// All of these are found before the rendering, which would never end.
#[test]
fn what_cannot_be_written_is_found_before_the_rendering() {
    let folder = folder();
    let endless = |output: &str| failure_in(folder.path(), &["endless.xml", "view.xml", output]);
    assert_eq!(
        endless("no/such/out.ppm"),
        told(
            3,
            "error: `no/such/out.ppm` cannot be written: there is no folder `no/such`\n  help: make the folder first, or \
             check its name\n"
        )
    );
    fs::create_dir(folder.path().join("pictures")).unwrap();
    assert_eq!(
        endless("pictures"),
        told(
            3,
            "error: `pictures` cannot be written: it is a folder\n  help: name a file: a folder is never replaced\n"
        )
    );
    assert_eq!(
        endless("scene.xml/out.ppm"),
        told(3, "error: `scene.xml/out.ppm` cannot be written: `scene.xml` is no folder\n")
    );
    let read_only = folder.path().join("old.ppm");
    fs::write(&read_only, "old").unwrap();
    let mut permissions = fs::metadata(&read_only).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&read_only, permissions).unwrap();
    assert_eq!(
        endless("old.ppm"),
        told(
            3,
            "error: `old.ppm` cannot be written: the file is read-only\n  help: allow writing it (chmod u+w), or choose \
             another name\n"
        )
    );
    assert_eq!(fs::read_to_string(&read_only).unwrap(), "old");
}

#[test]
fn wrong_use_of_the_command_line() {
    let usage = "\nUsage: lancer [OPTIONS] SCENE VIEW [OUTPUT]\n       lancer COMMAND …\n";
    let more = "\nFor more information, try '--help'.\n";
    for (args, text) in [
        (
            &["scene.xml"][..],
            format!("error: the following required arguments were not provided:\n  <VIEW>\n{usage}{more}"),
        ),
        (
            &["scene.xml", "view.xml", "a.ppm", "b.ppm"],
            format!("error: unexpected argument 'b.ppm' found\n{usage}{more}"),
        ),
        (
            &["scene.xml", "view.xml", "--size", "640"],
            format!(
                "error: invalid value '640' for '--size <WxH>': a size is two whole numbers from 1 to 65535 with an x \
                 between them, such as 640x480\n{more}"
            ),
        ),
        (
            &["scene.xml", "view.xml", "--region", "1,2,3"],
            format!(
                "error: invalid value '1,2,3' for '--region <X,Y,W,H>': a region is four whole numbers: left column, \
                 top row, width and height, such as 10,20,64,48; width and height are at least 1\n{more}"
            ),
        ),
        (
            &["scene.xml", "view.xml", "--depth", "65"],
            format!("error: invalid value '65' for '--depth <N>': a whole number from 0 to 64 is due\n{more}"),
        ),
        (
            &["scene.xml", "view.xml", "--samples", "0"],
            format!("error: invalid value '0' for '--samples <N>': a whole number from 1 to 64 is due\n{more}"),
        ),
        (
            &["scene.xml", "view.xml", "--threads", "0"],
            format!("error: invalid value '0' for '--threads <N>': a whole number from 1 to 1024 is due\n{more}"),
        ),
        (
            &["scene.xml", "view.xml", "--max-rays", "0"],
            format!("error: invalid value '0' for '--max-rays <N>': a whole number of 1 or more is due\n{more}"),
        ),
        (
            &["scene.xml", "view.xml", "--without", "mirrors"],
            format!(
                "error: invalid value 'mirrors' for '--without <LIST>': the steps are shadows, reflection and \
                 transparency, separated by commas\n{more}"
            ),
        ),
        (
            &["scene.xml", "view.xml", "picture.gif"],
            "error: no picture format has the extension .gif; known are .ppm .pnm .png .qoi .bmp .tif .tiff .exr\n"
                .to_owned(),
        ),
        (
            &["scene.xml", "view.xml", "-", "--all-views"],
            "error: --all-views writes several pictures; they cannot all go to standard output\n".to_owned(),
        ),
    ] {
        assert_eq!(failure(args), (2, text), "{args:?}");
    }
}

#[test]
fn wrong_use_of_the_command_line_in_french() {
    let usage = "\nEmploi : lancer [OPTIONS] SCÈNE VUE [IMAGE]\n       lancer COMMANDE …\n";
    let more = "\nPour en savoir plus, essayez « --help ».\n";
    for (args, text) in [
        (&["scene.xml"][..], format!("erreur : il manque des arguments obligatoires : <VUE>\n{usage}{more}")),
        (
            &["scene.xml", "view.xml", "--thread", "3"],
            format!("erreur : argument inattendu « --thread »\n  vouliez-vous dire « --threads » ?\n{usage}{more}"),
        ),
        (&["scene.xml", "view.xml", "a.ppm", "b.ppm"], format!("erreur : argument inattendu « b.ppm »\n{usage}{more}")),
        (
            &["scene.xml", "view.xml", "--size", "640"],
            format!(
                "erreur : valeur invalide « 640 » pour « --size <LxH> » : une taille est formée de deux entiers de 1 à \
                 65535 séparés par un x, par exemple 640x480\n{more}"
            ),
        ),
        (
            &["scene.xml", "view.xml", "--view", "a", "--all-views"],
            format!("erreur : l'argument « --view <NOM> » ne va pas avec « --all-views »\n{usage}{more}"),
        ),
        (
            &["completions", "csh"],
            format!(
                "erreur : valeur invalide « csh » pour « <SHELL> »\n  valeurs possibles : bash, elvish, fish, powershell, \
                 zsh\n  vouliez-vous dire « zsh » ?\n{more}"
            ),
        ),
    ] {
        let (code, said) = failure(&[args, &["--lang", "fr"]].concat());
        assert_eq!((code, said), (2, text), "{args:?}");
    }
}
