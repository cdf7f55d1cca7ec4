//! The real window, end to end, on a display in memory: a scene is opened, an object is moved with the mouse, both views
//! change, the scene and a picture are saved; the picture is the command line's byte for byte.
//!
//! It needs `Xvfb`, `xdotool` and ImageMagick's `import`. Without them it says so and passes, unless
//! `LANCER_REAL_WINDOW=1` asks for it.
#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stderr, reason = "helpers of a test")]

use lancer_formats::load::{LoadOptions, load_scene, load_views};
use lancer_formats::{picture, ppm};
use lancer_render::{RenderOptions, render_still};
use lancer_scene::{Picture, Shape};
use lancer_trace::{Cancel, World};
use lancer_words::{Lang, studio::app as words};
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const SCENE: &str = r##"<scene version="1" name="Real window">
  <world ambient="1" background="#00ff00"/>
  <material name="red" ka="1 0 0" kd="0"/>
  <light name="lamp" position="2 4 3"/>
  <sphere name="ball" center="0 0 0" radius="0.6" material="red"/>
</scene>
"##;
const VIEWS: &str = r#"<views version="1">
  <view name="front" width="64" height="48"><eye at="0 0 5" look-at="0 0 0"/></view>
  <view name="side" width="64" height="48"><eye at="5 0 1" look-at="0 0 0"/></view>
</views>
"#;
const SIZE: (u32, u32) = (1000, 700);
/// How long anything may take: the machine may be slow, and busy with other tests.
const PATIENCE: Duration = Duration::from_secs(180);

/// Ends a program when the test does, however it does.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A display in memory, and what is done on it.
struct Display {
    name: String,
    _server: Running,
}

impl Display {
    fn start() -> Display {
        let screen = format!("{}x{}x24", SIZE.0, SIZE.1);
        let mut server = Command::new("Xvfb");
        // without -noreset the server begins anew when xdotool leaves it, and throws the program out that is just coming
        server.args(["-displayfd", "1", "-screen", "0", &screen, "-nolisten", "tcp", "-noreset"]);
        let mut server = server.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let mut number = String::new();
        BufReader::new(server.stdout.take().unwrap()).read_line(&mut number).unwrap();
        Display { name: format!(":{}", number.trim()), _server: Running(server) }
    }

    fn xdotool(&self, line: &str) -> String {
        let output = Command::new("xdotool").args(line.split(' ')).env("DISPLAY", &self.name).output().unwrap();
        assert!(output.status.success(), "xdotool {line}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    }

    /// The window of a program, once it is seen.
    fn window(&self, name: &str, program: &mut Child, log: &Path) -> String {
        let begun = Instant::now();
        loop {
            let search = ["search", "--onlyvisible", "--name", name];
            let output = Command::new("xdotool").args(search).env("DISPLAY", &self.name).output().unwrap();
            if let Some(window) = String::from_utf8_lossy(&output.stdout).lines().next() {
                return window.to_owned();
            }
            let said = || std::fs::read_to_string(log).unwrap_or_default();
            if let Some(status) = program.try_wait().unwrap() {
                panic!("the program ended without a window, {status}: {}", said());
            }
            assert!(begun.elapsed() < PATIENCE, "no window: {}", said());
            std::thread::sleep(Duration::from_millis(100));
        }
    }

    fn shot(&self) -> Picture {
        let output = Command::new("import").args(["-window", "root", "ppm:-"]).env("DISPLAY", &self.name).output();
        picture::read(&output.unwrap().stdout).unwrap()
    }

    /// What is seen once it is so, and does not change any more.
    fn until(&self, what: &str, holds: impl Fn(&Picture) -> bool) -> Picture {
        let begun = Instant::now();
        let mut last = self.shot();
        loop {
            assert!(begun.elapsed() < PATIENCE, "{what} never comes");
            std::thread::sleep(Duration::from_millis(200));
            let shot = self.shot();
            if holds(&shot) && shot == last {
                return shot;
            }
            last = shot;
        }
    }
}

/// The pixels of one half of the screen, with their places.
fn half(shot: &Picture, right: bool) -> impl Iterator<Item = ((u32, u32), [u8; 3])> {
    let middle = middle(shot);
    let width = shot.width;
    let places = (0..shot.height).flat_map(move |y| (0..width).map(move |x| (x, y)));
    places.zip(shot.bytes.iter().copied()).filter(move |((x, _), _)| (*x >= middle) == right)
}

/// The column between the two pictures: the middle of all that is background.
fn middle(shot: &Picture) -> u32 {
    let columns = (0..shot.width).filter(|x| (0..shot.height).any(|y| shot.pixel(*x, y) == Some([0, 255, 0])));
    let (low, high) = columns.fold((u32::MAX, 0), |(low, high), x| (low.min(x), high.max(x)));
    if low > high { shot.width / 2 } else { (low + high) / 2 }
}

fn count(shot: &Picture, right: bool, color: [u8; 3]) -> usize {
    half(shot, right).filter(|(_, pixel)| *pixel == color).count()
}

/// Where the red ball stands in one of the pictures.
fn ball(shot: &Picture, right: bool) -> (u32, u32) {
    let (mut sum, mut pixels) = ((0, 0), 0);
    for ((x, y), _) in half(shot, right).filter(|(_, pixel)| *pixel == [255, 0, 0]) {
        sum = (sum.0 + x, sum.1 + y);
        pixels += 1;
    }
    assert!(pixels > 50, "no ball: {pixels} red pixels");
    (sum.0 / pixels, sum.1 / pixels)
}

fn center(path: &Path) -> Option<[f64; 3]> {
    let scene = load_scene(path, &LoadOptions::default()).ok()?.value?;
    let Shape::Sphere { center, .. } = &scene.objects.first()?.shape else { return None };
    Some(center.to_array())
}

fn is_there(program: &str) -> bool {
    let folders = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&folders).any(|folder| folder.join(program).is_file())
}

/// Whether the tests must be left out, for want of a display and a hand on it.
fn is_left_out() -> bool {
    if let Some(missing) = ["Xvfb", "xdotool", "import"].into_iter().find(|program| !is_there(program)) {
        let asked = std::env::var_os("LANCER_REAL_WINDOW").is_some();
        assert!(
            !asked,
            "{missing} is not installed: apt install xvfb xdotool imagemagick libgl1 libgl1-mesa-dri libxkbcommon-x11-0"
        );
        eprintln!("left out: {missing} is not installed");
        return true;
    }
    false
}

/// Where no file tells which key is which letter, the sentence names the package that has them.
#[test]
fn missing_keyboard_layouts_are_named() {
    if is_left_out() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let display = Display::start();
    for (lang, sentence) in
        [("en", words::no_keyboard_layouts(Lang::English)), ("fr", words::no_keyboard_layouts(Lang::French))]
    {
        let output = Command::new(env!("CARGO_BIN_EXE_lancer-studio"))
            .args(["--lang", lang])
            .env("DISPLAY", &display.name)
            .env_remove("WAYLAND_DISPLAY")
            // nowhere that the library of keyboards looks are there any
            .envs(["XKB_CONFIG_ROOT", "XKB_CONFIG_EXTRA_PATH", "XDG_CONFIG_HOME"].map(|name| (name, "/nonexistent")))
            .env("HOME", folder.path())
            .env("XDG_DATA_HOME", folder.path())
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(3));
        // the library of keyboards has a line of its own before
        assert_eq!(String::from_utf8_lossy(&output.stderr).lines().last(), Some(&*sentence));
    }
}

#[test]
fn the_real_window_from_opening_to_saving() {
    if is_left_out() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let (scene, views) = (folder.path().join("one.xml"), folder.path().join("one.view.xml"));
    std::fs::write(&scene, SCENE).unwrap();
    std::fs::write(&views, VIEWS).unwrap();
    let display = Display::start();
    let log = folder.path().join("log");
    let studio = Command::new(env!("CARGO_BIN_EXE_lancer-studio"))
        .arg(&scene)
        .envs([("DISPLAY", display.name.as_str()), ("LANG", "C")])
        .env("XDG_DATA_HOME", folder.path().join("data"))
        // no dialog of the system: the program's own one asks
        .env("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nonexistent")
        .env_remove("WAYLAND_DISPLAY")
        .stderr(std::fs::File::create(&log).unwrap())
        .spawn();
    let mut studio = Running(studio.unwrap());
    let window = display.window("lancer", &mut studio.0, &log);
    display.xdotool(&format!("windowsize --sync {window} {} {}", SIZE.0, SIZE.1));
    display.xdotool(&format!("windowmove {window} 0 0"));
    display.xdotool(&format!("windowfocus {window}"));

    let begin = display.until("both pictures", |shot| {
        [false, true]
            .iter()
            .all(|right| count(shot, *right, [0, 255, 0]) > 2000 && count(shot, *right, [255, 0, 0]) > 50)
    });
    let [front, side] = [false, true].map(|right| ball(&begin, right));

    // a click selects the ball, a drag moves it
    display.xdotool(&format!("mousemove {} {} click 1", front.0, front.1));
    display.until("the outline", |shot| *shot != begin);
    display.xdotool("mousedown 1");
    for _ in 0..8 {
        display.xdotool("mousemove_relative -- 4 -5");
        std::thread::sleep(Duration::from_millis(100));
    }
    display.xdotool("mouseup 1");
    let moved = |shot: &Picture| {
        let [now, beside] = [false, true].map(|right| ball(shot, right));
        now.0 > front.0 + 15 && now.1 + 15 < front.1 && beside.1 + 10 < side.1
    };
    display.until("the ball at its new place in both views", moved);

    display.xdotool("key ctrl+s");
    let begun = Instant::now();
    while center(&scene).is_none_or(|center| center[0] == 0.0) {
        assert!(begun.elapsed() < PATIENCE, "the scene is not saved");
        std::thread::sleep(Duration::from_millis(100));
    }
    let [x, y, z] = center(&scene).unwrap();
    assert!(x > 0.1 && y > 0.1 && z.abs() < 1e-9, "moved in the plane of the front view: {x} {y} {z}");

    let file = folder.path().join("picture.ppm");
    let before = display.shot();
    display.xdotool("key ctrl+e");
    display.until("the dialog", |shot| *shot != before && count(shot, false, [255, 0, 0]) < 50);
    display.xdotool("key ctrl+a");
    display.xdotool(&format!("type --delay 20 {}", file.display()));
    display.xdotool("key Return");
    let still = {
        let scene = load_scene(&scene, &LoadOptions::default()).unwrap().value.unwrap();
        let views = load_views(&views, &LoadOptions::default()).unwrap().value.unwrap();
        let options = RenderOptions::default();
        render_still(&World::compile(&scene), &views[0], &options, &Cancel::default(), |_, _| ()).unwrap().picture
    };
    let mut due = Vec::new();
    ppm::write_plain(&still, &mut due).unwrap();
    let begun = Instant::now();
    while !std::fs::read(&file).is_ok_and(|bytes| bytes == due) {
        assert!(begun.elapsed() < PATIENCE, "the picture is not saved, or another one");
        std::thread::sleep(Duration::from_millis(100));
    }
}
