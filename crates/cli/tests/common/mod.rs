//! What the tests of the program share: a folder of small documents, and the program run in it.
#![allow(dead_code, reason = "each test file uses its own part")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use assert_cmd::Command;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A ball over a floor, two lamps.
pub(crate) const SCENE: &str = r##"<?xml version="1.0" encoding="UTF-8"?>
<scene version="1" name="Ball">
  <world ambient="0.2" background="0.1 0.2 0.3"/>
  <material name="mirror" ka="0.1" kd="0.3" ks="0.8" n="50" kr="0.5"/>
  <light name="lamp" position="-2 3 2"/>
  <light name="weak" position="3 2 1" color="0.3"/>
  <sphere name="ball" center="0 0.5 0" radius="0.5" material="mirror"/>
  <plane name="floor" p0="0 0 0" p1="0 0 1" p2="1 0 0"/>
</scene>
"##;

/// Two views of it.
pub(crate) const VIEWS: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<views version="1">
  <view name="front" width="40" height="30">
    <eye at="0 1 4" look-at="0 0.5 0"/>
  </view>
  <view name="above" width="32" height="24">
    <eye at="0 5 1" look-at="0 0 0"/>
  </view>
</views>
"#;

/// Three glass panes between mirrors: with a deep limit no pixel ever ends.
pub(crate) const ENDLESS: &str = r#"<scene version="1">
  <world depth="64"/>
  <material name="both" kr="0.5" kt="0.5" index="1.1"/>
  <light position="0 0 5"/>
  <box name="a" origin="-9 -9 -1" u="18 0 0" v="0 18 0" w="0 0 0.5" material="both"/>
  <box name="b" origin="-9 -9 -2" u="18 0 0" v="0 18 0" w="0 0 0.5" material="both"/>
  <box name="c" origin="-9 -9 -3" u="18 0 0" v="0 18 0" w="0 0 0.5" material="both"/>
</scene>
"#;

/// A folder with `scene.xml`, `view.xml` and `endless.xml`.
pub(crate) fn folder() -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("scene.xml"), SCENE).unwrap();
    fs::write(folder.path().join("view.xml"), VIEWS).unwrap();
    fs::write(folder.path().join("endless.xml"), ENDLESS).unwrap();
    folder
}

/// The program in a folder, in English, with its arguments.
pub(crate) fn lancer(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(program());
    command.current_dir(folder).args(args).env_remove("LANGUAGE").env_remove("LC_ALL").env_remove("LC_MESSAGES");
    command.env("LANG", "C.UTF-8").env("NO_COLOR", "1").env_remove("LANCER_SIMD");
    command
}

/// Where the program is.
pub(crate) fn program() -> PathBuf {
    PathBuf::from(env!("CARGO_BIN_EXE_lancer"))
}

/// What a run gave: exit code, standard output, standard error.
pub(crate) fn run(folder: &Path, args: &[&str]) -> (i32, String, String) {
    outcome(&mut lancer(folder, args))
}

/// What a command gives: exit code, standard output, standard error.
pub(crate) fn outcome(command: &mut Command) -> (i32, String, String) {
    let output = command.output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap_or(-1), text(output.stdout), text(output.stderr))
}

/// The names of all files in a folder, hidden ones too.
pub(crate) fn listing(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}
