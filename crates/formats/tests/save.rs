//! Writing files: what stands there afterwards, and that a failure leaves the old file whole and nothing beside it.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that fails says so by panicking")]

use lancer_formats::Describe;
use lancer_formats::picture::{self, Format};
use lancer_formats::save::{self, SaveCause, SaveError};
use lancer_formats::{binary, export, n7_2009, xml};
use lancer_scene::{DVec3, Mesh, MeshGeometry, Object, Picture, Placement, PointLight, Scene, Shape, View};
use lancer_words::Lang;
use std::fs;
use std::io::{self, Write};
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const OLD: &[u8] = b"the old picture";

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

fn save(path: &Path, bytes: &[u8]) -> Result<(), SaveError> {
    save::save_output(path, |out| out.write_all(bytes))
}

/// The names in a folder.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn mode(path: &Path) -> u32 {
    fs::metadata(path).unwrap().permissions().mode() & 0o7777
}

fn set_mode(path: &Path, mode: u32) {
    fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
}

/// Root may write everywhere; the tests of what is forbidden mean nothing to it.
fn is_root() -> bool {
    fs::metadata("/proc/self").is_ok_and(|own| own.uid() == 0)
}

fn a_picture() -> Picture {
    Picture { width: 6, height: 4, bytes: (0..24).map(|i| [i, 2 * i, 255 - i]).collect(), linear: None }
}

/// A ball, a facet of a mesh, and a lamp.
fn a_scene() -> Scene {
    let geometry = MeshGeometry {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
        facets: vec![[0, 1, 2]],
        ..MeshGeometry::default()
    };
    let mesh = Mesh { geometry: geometry.into(), source: None, placement: Placement::default(), smooth: false };
    Scene {
        lights: [PointLight::new("lamp", DVec3::new(-2.0, 3.0, 0.1))].into_iter().collect(),
        objects: [
            Object::new("ball", Shape::Sphere { center: DVec3::ZERO, radius: 0.5 }),
            Object::new("flag", Shape::Mesh(mesh)),
        ]
        .into_iter()
        .collect(),
        ..Scene::default()
    }
}

fn a_view() -> View {
    let document = xml::Document::read("a.xml", b"<view version='1'><eye at='0 1 5' look-at='0 0 0'/></view>").unwrap();
    View::clone(&xml::read_views(&document).value.unwrap()[0])
}

#[test]
fn a_new_file_has_the_mode_of_any_new_file() {
    let folder = folder();
    let path = folder.path().join("output.ppm");
    save(&path, b"new").unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"new");
    let other = folder.path().join("other");
    fs::write(&other, b"").unwrap();
    assert_eq!(mode(&path), mode(&other));
    assert_eq!(names(folder.path()), ["other", "output.ppm"]);
}

#[test]
fn a_bare_name_is_written_to_the_current_folder() {
    let path = Path::new("save-test-of-a-bare-name");
    save(path, b"new").unwrap();
    assert_eq!(fs::read(path).unwrap(), b"new");
    fs::remove_file(path).unwrap();
}

#[test]
fn an_old_file_is_replaced_and_its_mode_kept() {
    let folder = folder();
    let path = folder.path().join("output.ppm");
    for bits in [0o600, 0o640, 0o755, 0o666] {
        fs::write(&path, OLD).unwrap();
        set_mode(&path, bits);
        save(&path, b"new").unwrap();
        assert_eq!((fs::read(&path).unwrap().as_slice(), mode(&path)), (&b"new"[..], bits));
    }
    assert_eq!(names(folder.path()), ["output.ppm"]);
}

/// Only root may give files away.
#[test]
fn the_owner_is_kept_where_the_system_lets_us() {
    let folder = folder();
    let path = folder.path().join("output.ppm");
    fs::write(&path, OLD).unwrap();
    let own = fs::metadata(&path).unwrap();
    let owner = if is_root() { (own.uid() + 1, own.gid() + 1) } else { (own.uid(), own.gid()) };
    std::os::unix::fs::chown(&path, Some(owner.0), Some(owner.1)).unwrap();
    set_mode(&path, 0o2750);
    save(&path, b"new").unwrap();
    let kept = fs::metadata(&path).unwrap();
    assert_eq!(((kept.uid(), kept.gid()), mode(&path)), (owner, 0o2750));
}

#[test]
fn links_are_followed_and_stay() {
    let folder = folder();
    let real = folder.path().join("pictures");
    fs::create_dir(&real).unwrap();
    fs::write(real.join("real.ppm"), OLD).unwrap();
    symlink("pictures/real.ppm", folder.path().join("first.ppm")).unwrap();
    symlink(folder.path().join("first.ppm"), folder.path().join("second.ppm")).unwrap();
    save(&folder.path().join("second.ppm"), b"new").unwrap();
    assert_eq!(fs::read(real.join("real.ppm")).unwrap(), b"new");
    assert!(folder.path().join("second.ppm").symlink_metadata().unwrap().is_symlink());
    assert!(folder.path().join("first.ppm").symlink_metadata().unwrap().is_symlink());
    assert_eq!(names(folder.path()), ["first.ppm", "pictures", "second.ppm"]);
    assert_eq!(names(&real), ["real.ppm"]);
}

#[test]
fn a_link_to_nothing_makes_what_it_names() {
    let folder = folder();
    let link = folder.path().join("link.ppm");
    symlink("real.ppm", &link).unwrap();
    save(&link, b"new").unwrap();
    assert_eq!(fs::read(folder.path().join("real.ppm")).unwrap(), b"new");
    assert!(link.symlink_metadata().unwrap().is_symlink());

    symlink("missing/real.ppm", folder.path().join("lost.ppm")).unwrap();
    let error = save(&folder.path().join("lost.ppm"), b"new").unwrap_err();
    assert_eq!(error.cause, SaveCause::MissingFolder(folder.path().join("missing")));
}

#[test]
fn links_in_a_circle_are_an_error() {
    let folder = folder();
    symlink("b", folder.path().join("a")).unwrap();
    symlink("a", folder.path().join("b")).unwrap();
    let error = save(&folder.path().join("a"), b"new").unwrap_err();
    assert!(matches!(error.cause, SaveCause::Other(_)), "{error:?}");
    assert_eq!(names(folder.path()), ["a", "b"]);
}

#[test]
fn a_missing_folder_is_named() {
    let folder = folder();
    let path = folder.path().join("no/such/output.ppm");
    let error = save(&path, b"new").unwrap_err();
    let missing = folder.path().join("no/such");
    assert_eq!(error.cause, SaveCause::MissingFolder(missing.clone()));
    let (path, missing) = (path.display(), missing.display());
    assert_eq!(error.message(Lang::English), format!("`{path}` cannot be written: there is no folder `{missing}`"));
    assert_eq!(
        error.message(Lang::French),
        format!("impossible d'écrire « {path} » : le dossier « {missing} » n'existe pas")
    );
    assert_eq!(error.help(Lang::English).unwrap(), "make the folder first, or check its name");
    assert_eq!(names(folder.path()), [""; 0]);
}

#[test]
fn a_file_in_place_of_a_folder_is_named() {
    let folder = folder();
    fs::write(folder.path().join("file"), OLD).unwrap();
    let error = save(&folder.path().join("file/output.ppm"), b"new").unwrap_err();
    assert_eq!(error.cause, SaveCause::NotAFolder(folder.path().join("file")));
}

#[test]
fn a_folder_is_never_replaced() {
    let folder = folder();
    fs::create_dir(folder.path().join("output.ppm")).unwrap();
    symlink("output.ppm", folder.path().join("link")).unwrap();
    for path in ["output.ppm", "link", "output.ppm/", "new/", ".", ".."] {
        let error = save(&folder.path().join(path), b"new").unwrap_err();
        assert_eq!(error.cause, SaveCause::IsAFolder, "{path}");
    }
    let path = folder.path().join("output.ppm");
    let error = save(&path, b"new").unwrap_err();
    assert_eq!(error.message(Lang::English), format!("`{}` cannot be written: it is a folder", path.display()));
    assert_eq!(names(folder.path()), ["link", "output.ppm"]);
}

/// A rename would not ask: the folder alone decides about it.
#[test]
fn a_read_only_file_is_refused() {
    let folder = folder();
    let path = folder.path().join("output.ppm");
    fs::write(&path, OLD).unwrap();
    set_mode(&path, 0o444);
    let error = save(&path, b"new").unwrap_err();
    assert_eq!(error.cause, SaveCause::ReadOnly);
    assert_eq!(error.message(Lang::English), format!("`{}` cannot be written: the file is read-only", path.display()));
    assert_eq!(fs::read(&path).unwrap(), OLD);
    assert_eq!(save::check(&path).unwrap_err().cause, SaveCause::ReadOnly);
}

#[test]
fn a_read_only_folder_is_refused() {
    if is_root() {
        return;
    }
    let folder = folder();
    let path = folder.path().join("output.ppm");
    fs::write(&path, OLD).unwrap();
    set_mode(folder.path(), 0o555);
    let error = save(&path, b"new").unwrap_err();
    let checked = save::check(&path).unwrap_err();
    set_mode(folder.path(), 0o755);
    assert_eq!(error.cause, SaveCause::ReadOnlyFolder(folder.path().to_owned()));
    assert_eq!(checked, error);
    assert_eq!(fs::read(&path).unwrap(), OLD);
}

#[test]
fn checking_changes_nothing() {
    let folder = folder();
    let path = folder.path().join("output.ppm");
    save::check(&path).unwrap();
    assert_eq!(names(folder.path()), [""; 0]);
    fs::write(&path, OLD).unwrap();
    let before = fs::metadata(&path).unwrap();
    save::check(&path).unwrap();
    let after = fs::metadata(&path).unwrap();
    assert_eq!((before.ino(), before.mtime_nsec()), (after.ino(), after.mtime_nsec()));
    assert_eq!(names(folder.path()), ["output.ppm"]);
    save::check(Path::new("-")).unwrap();
    assert!(save::check(&folder.path().join("no/output.ppm")).is_err());
}

#[test]
fn a_pipe_is_written_to_and_stays() {
    let folder = folder();
    let pipe = folder.path().join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || fs::read(pipe).unwrap()
    });
    save::check(&pipe).unwrap();
    save(&pipe, b"new").unwrap();
    assert_eq!(reader.join().unwrap(), b"new");
    assert!(!fs::metadata(&pipe).unwrap().is_file());
    assert_eq!(names(folder.path()), ["pipe"]);
}

#[test]
fn a_pipe_whose_reader_goes_is_closed() {
    let folder = folder();
    let pipe = folder.path().join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || drop(fs::File::open(pipe).unwrap())
    });
    let error = save::save(&pipe, |out| {
        reader.join().unwrap();
        out.write_all(&[0; 100_000])
    })
    .unwrap_err();
    assert_eq!(error.cause, SaveCause::Closed);
}

#[test]
fn a_full_device_is_a_full_disk() {
    let path = Path::new("/dev/full");
    if !path.exists() {
        return;
    }
    let error = save(path, b"new").unwrap_err();
    assert_eq!(error.cause, SaveCause::NoSpace);
    assert_eq!(error.message(Lang::English), "`/dev/full` cannot be written: the disk is full");
    assert_eq!(error.message(Lang::French), "impossible d'écrire « /dev/full » : le disque est plein");
    assert_eq!(error.help(Lang::English).unwrap(), "a file that stood there before is unchanged");
    save(Path::new("/dev/null"), b"new").unwrap();
}

/// A place that takes so many bytes and no more.
struct Full<'a> {
    out: &'a mut dyn Write,
    room: usize,
}

impl Write for Full<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.room == 0 {
            return Err(io::ErrorKind::StorageFull.into());
        }
        let taken = self.out.write(&bytes[..bytes.len().min(self.room)])?;
        self.room -= taken;
        Ok(taken)
    }
    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

type Writer = Box<dyn Fn(&mut dyn Write) -> io::Result<()>>;

/// Everything that is written, by the names of what writes it.
fn writers() -> Vec<(String, Writer)> {
    let scene = a_scene();
    let view = a_view();
    let whole = |name: &str, bytes: Vec<u8>| -> (String, Writer) {
        (name.to_owned(), Box::new(move |out: &mut dyn Write| out.write_all(&bytes)))
    };
    // a ball becomes thousands of facets
    let flat = Scene { objects: scene.objects.with(|objects| drop(objects.remove(0))), ..scene.clone() };
    let obj = export::write_obj(&flat, "out.mtl");
    let mut writers = vec![
        whole("XML", xml::write_scene(&scene).into_bytes()),
        whole("views", xml::write_views(&[view.clone()].into_iter().collect()).into_bytes()),
        whole("binary", binary::write_scene(&scene)),
        whole("2009", n7_2009::write_scene(&scene).0.into_bytes()),
        whole("OBJ", obj.objects.into_bytes()),
        whole("MTL", obj.materials.into_bytes()),
        whole("glTF", export::write_gltf(&flat, export::Container::Text)),
    ];
    // those encode before they write
    for format in [Format::Png, Format::Qoi, Format::Bmp, Format::Tiff, Format::Exr] {
        let mut bytes = Vec::new();
        picture::write(&a_picture(), format, &mut bytes).unwrap();
        writers.push(whole(&format!("{format:?}"), bytes));
    }
    writers.push(("POV-Ray".to_owned(), Box::new(move |out| export::write_povray(&scene, &view, out))));
    for format in [Format::PlainPpm, Format::RawPpm] {
        writers.push((format!("{format:?}"), Box::new(move |out| picture::write(&a_picture(), format, out))));
    }
    writers
}

#[test]
fn a_writer_that_fails_at_any_byte_leaves_the_old_file_whole() {
    let folder = folder();
    let path = folder.path().join("output.ppm");
    fs::write(&path, OLD).unwrap();
    set_mode(&path, 0o640);
    for (name, write) in writers() {
        let mut whole = Vec::new();
        write(&mut whole).unwrap();
        for room in 0..whole.len() {
            let error = save::save_output(&path, |out| write(&mut Full { out, room })).unwrap_err();
            assert_eq!(error, SaveError { path: path.clone(), cause: SaveCause::NoSpace }, "{name} at {room}");
            assert_eq!(fs::read(&path).unwrap(), OLD, "{name} at {room}");
            assert_eq!(names(folder.path()), ["output.ppm"], "{name} at {room}");
        }
        let room = whole.len();
        save::save(&path, |out| write(&mut Full { out, room })).unwrap();
        assert_eq!((fs::read(&path).unwrap(), mode(&path)), (whole, 0o640), "{name}");
        fs::write(&path, OLD).unwrap();
    }
}

#[test]
fn a_writer_that_panics_leaves_the_old_file_whole() {
    let folder = folder();
    let path = folder.path().join("output.ppm");
    fs::write(&path, OLD).unwrap();
    let panics = std::panic::catch_unwind(|| {
        let _ = save::save(&path, |out| {
            out.write_all(&[0; 100_000])?;
            panic!("on purpose")
        });
    });
    assert!(panics.is_err());
    assert_eq!(fs::read(&path).unwrap(), OLD);
    assert_eq!(names(folder.path()), ["output.ppm"]);
}

const TARGET: &str = "LANCER_SAVE_TEST_TARGET";

/// The part of the next test that runs in a process with a file-size limit.
#[test]
fn in_a_limited_process() {
    let Some(path) = std::env::var_os(TARGET).map(PathBuf::from) else { return };
    let error = save(&path, &[b'x'; 1_000_000]).unwrap_err();
    assert_eq!(error, SaveError { path, cause: SaveCause::TooLarge });
    println!("refused");
}

/// One real process whose files may not grow beyond 4 KiB, with the signal of that limit ignored and not.
#[test]
fn a_file_size_limit_leaves_the_old_file_whole() {
    let folder = folder();
    let path = folder.path().join("output.ppm");
    fs::write(&path, OLD).unwrap();
    let run = |script: &str| {
        Command::new("sh")
            .args(["-c", script])
            .arg(std::env::current_exe().unwrap())
            .env(TARGET, &path)
            .stdin(Stdio::null())
            .output()
            .unwrap()
    };
    let ignored = run("trap '' XFSZ; ulimit -f 8; exec \"$0\" --exact in_a_limited_process --nocapture");
    let printed = String::from_utf8_lossy(&ignored.stdout);
    assert!(ignored.status.success() && printed.contains("refused"), "{ignored:?}");
    assert_eq!(fs::read(&path).unwrap(), OLD);
    assert_eq!(names(folder.path()), ["output.ppm"]);

    let killed = run("ulimit -c 0; ulimit -f 8; exec \"$0\" --exact in_a_limited_process");
    assert!(!killed.status.success());
    assert_eq!(fs::read(&path).unwrap(), OLD);
}

const CONTENT: &str = "P3\n# lancer\n1 1\n255\n1 2 3\n";

/// The part of the next test whose standard output is a pipe.
#[test]
fn in_a_process_with_an_output() {
    let Some(path) = std::env::var_os(TARGET).map(PathBuf::from) else { return };
    save(&path, CONTENT.as_bytes()).unwrap();
}

#[test]
fn a_hyphen_is_standard_output() {
    for path in ["-", "/dev/stdout"] {
        let output = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "in_a_process_with_an_output", "--nocapture"])
            .env(TARGET, path)
            .output()
            .unwrap();
        assert!(String::from_utf8(output.stdout).unwrap().contains(CONTENT));
    }
    // Only the hyphen is looked for: /dev/stdout is a regular file wherever this test's own output goes to one.
    assert!(!Path::new("-").exists());
}
