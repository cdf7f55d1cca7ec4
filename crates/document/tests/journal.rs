//! The journal: what a kill leaves, and what it never touches.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

#[path = "../../scene/tests/arbitrary/mod.rs"]
mod arbitrary;

use lancer_document::insert::{NewItem, Standpoint};
use lancer_document::journal::{Journal, left_behind};
use lancer_document::{Document, StepName};
use lancer_formats::load::LoadOptions;
use lancer_formats::save::SceneFormat;
use lancer_scene::Stage;
use proptest::prelude::*;
use std::fs;
use std::path::Path;
use std::process::Command;

const FOLDER: &str = "LANCER_TEST_JOURNAL";

fn add(document: &mut Document, item: NewItem) {
    document.add(item, &Standpoint::default()).unwrap();
}

/// A document of a file with one sphere, and two changes that are not saved.
fn changed(folder: &Path) -> Document {
    let path = folder.join("scene.xml");
    let mut document = Document::new(StepName::New, Stage::default());
    add(&mut document, NewItem::Sphere);
    let saved = document.saving_scene(&path, SceneFormat::Xml).write().unwrap();
    document.saved_scene(saved);
    add(&mut document, NewItem::Cube);
    add(&mut document, NewItem::Facet);
    document
}

/// Not a test by itself: the program that the next test kills.
#[test]
fn edits_and_dies() {
    let Some(folder) = std::env::var_os(FOLDER) else { return };
    let folder = Path::new(&folder);
    let mut journal = Journal::begin(&folder.join("data")).unwrap();
    let mut document = changed(folder);
    journal.follow(&document);
    add(&mut document, NewItem::Light);
    journal.follow(&document);
    journal.wait();
    std::process::abort();
}

#[test]
fn a_kill_loses_nothing_that_was_kept() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("data");
    let program = std::env::current_exe().unwrap();
    let run = Command::new(program).args(["--exact", "edits_and_dies"]).env(FOLDER, folder.path()).output().unwrap();
    assert!(!run.status.success(), "it was to die");
    let file = fs::read(folder.path().join("scene.xml")).unwrap();

    let mut found = left_behind(&data);
    assert_eq!(found.len(), 1);
    let left = found.remove(0);
    let entry = left.read().unwrap();
    assert_eq!(entry.scene.as_deref(), Some(&*folder.path().join("scene.xml")));
    let options = LoadOptions::default();
    let (scene, views) = entry.files(&options);
    let mut document = Document::recover(entry, scene, views, options);
    assert_eq!(document.stage().scene.objects.len(), 3);
    assert_eq!(document.stage().scene.lights.len(), 1);
    assert!(document.scene_is_modified());
    assert_eq!(document.scene_path(), Some(&*folder.path().join("scene.xml")));
    assert_eq!(document.history().names().collect::<Vec<_>>(), [&StepName::Opened, &StepName::Recovered]);

    // a second program does not get it meanwhile, and its own journal is another file
    assert!(left_behind(&data).is_empty());
    let mut journal = Journal::begin(&data).unwrap();
    journal.follow(&document);
    journal.wait();
    assert_eq!(journal.failure(), None);
    left.discard();
    assert!(journal.path().exists());
    assert_eq!(fs::read(folder.path().join("scene.xml")).unwrap(), file, "the user's file is as it was");
    document.undo();
    assert_eq!(document.stage().scene.objects.len(), 1, "what the file holds is one step back");
}

/// A recovery that is put off is offered again; one that is declined is not.
#[test]
fn what_is_left_is_offered_until_it_is_discarded() {
    let folder = tempfile::tempdir().unwrap();
    let program = std::env::current_exe().unwrap();
    Command::new(program).args(["--exact", "edits_and_dies"]).env(FOLDER, folder.path()).output().unwrap();
    let data = folder.path().join("data");
    drop(left_behind(&data));
    let mut journal = Journal::begin(&data).unwrap();
    journal.follow(&changed(folder.path()));
    journal.wait();
    let mut found = left_behind(&data);
    assert_eq!(found.len(), 1, "the living journal is not offered");
    found.remove(0).discard();
    assert!(left_behind(&data).is_empty());
}

#[test]
fn a_journal_goes_when_nothing_would_be_lost() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("data");
    let mut journal = Journal::begin(&data).unwrap();
    let mut document = changed(folder.path());
    let there = |journal: &Journal| {
        journal.wait();
        journal.path().exists()
    };
    journal.follow(&document);
    assert!(there(&journal));
    // undone to what was saved
    document.undo();
    document.undo();
    journal.follow(&document);
    assert!(!there(&journal));
    document.redo();
    journal.follow(&document);
    assert!(there(&journal));
    // saved
    let saved = document.saving_scene(&folder.path().join("scene.xml"), SceneFormat::Xml).write().unwrap();
    document.saved_scene(saved);
    journal.follow(&document);
    assert!(!there(&journal));
    // discarded
    add(&mut document, NewItem::Plane);
    journal.follow(&document);
    assert!(there(&journal));
    journal.forget();
    assert!(!there(&journal));
    drop(journal);
    assert_eq!(fs::read_dir(&data).unwrap().count(), 0, "nothing is left of it");
}

/// Serialising a scene would make a drag stutter.
#[test]
fn a_gesture_is_kept_when_it_is_over() {
    let folder = tempfile::tempdir().unwrap();
    let mut journal = Journal::begin(folder.path()).unwrap();
    let mut document = Document::new(StepName::New, Stage::default());
    document.begin(StepName::Titled);
    document.preview(&lancer_scene::Edit::Title("dragged".into())).unwrap();
    journal.follow(&document);
    journal.wait();
    assert!(!journal.path().exists());
    document.commit();
    journal.follow(&document);
    journal.wait();
    assert!(journal.path().exists());
}

#[test]
fn a_damaged_journal_is_no_entry() {
    let folder = tempfile::tempdir().unwrap();
    let mut journal = Journal::begin(folder.path()).unwrap();
    journal.follow(&changed(folder.path()));
    journal.wait();
    let bytes = fs::read(journal.path()).unwrap();
    let other = folder.path().join("77.journal");
    let read = |bytes: &[u8]| {
        fs::write(&other, bytes).unwrap();
        let found = left_behind(folder.path());
        found.iter().map(|left| left.read()).collect::<Vec<_>>()
    };
    assert!(matches!(&read(&bytes)[..], [Some(_)]));
    for length in (0..bytes.len()).step_by(7) {
        assert_eq!(read(&bytes[..length]), [None], "cut at {length}");
    }
    let mut long = bytes;
    long[8..16].fill(0xff);
    assert_eq!(read(&long), [None]);
}

#[test]
fn a_folder_that_cannot_be_written_is_an_error_and_no_panic() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    assert!(Journal::begin(&file.join("data")).is_err());
    assert!(left_behind(&file).is_empty());
    // gone while it runs
    let data = folder.path().join("data");
    let mut journal = Journal::begin(&data).unwrap();
    fs::remove_dir_all(&data).unwrap();
    journal.follow(&changed(folder.path()));
    journal.wait();
    assert!(journal.failure().is_some());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::default() })]

    /// Whatever the stage, what is kept is the stage.
    #[test]
    fn what_is_kept_is_the_stage(stage in arbitrary::stage()) {
        let folder = tempfile::tempdir().unwrap();
        let mut journal = Journal::begin(folder.path()).unwrap();
        let mut document = Document::new(StepName::New, stage.clone());
        let title = format!("{} changed", stage.scene.name);
        document.apply(StepName::Titled, &lancer_scene::Edit::Title(title.clone())).unwrap();
        journal.follow(&document);
        journal.wait();
        fs::copy(journal.path(), folder.path().join("copy.journal")).unwrap();
        let entry = left_behind(folder.path()).remove(0).read().unwrap();
        prop_assert_eq!(&entry.stage, document.stage());
        prop_assert_eq!((entry.scene, entry.views), (None, None));
    }
}

/// Whoever has just looked around in a scene that was never saved has nothing to lose; a view that was made is kept.
#[test]
fn looking_around_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("data");
    let mut first = Document::new(StepName::New, Stage::default());
    add(&mut first, NewItem::View(None));
    let mut document = Document::new(StepName::New, first.stage().clone());
    let mut journal = Journal::begin(&data).unwrap();
    let name = document.stage().views[0].name.clone();
    let turned = lancer_document::attribute::edit_view(document.stage(), &name, |view| view.eye.x += 1.0).unwrap();
    document.apply(StepName::Navigated(name.clone()), &turned).unwrap();
    journal.follow(&document);
    journal.wait();
    assert!(document.is_modified() && !document.has_work_to_lose() && !journal.path().exists());
    add(&mut document, NewItem::View(None));
    journal.follow(&document);
    journal.wait();
    assert!(document.has_work_to_lose() && journal.path().exists());
}
