//! Where pictures go: which file for which view.

use crate::{Context, Failure};
use lancer_formats::save::{self, STANDARD};
use lancer_scene::View;
use lancer_trace::Cancel;
use std::collections::HashMap;
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What stands in a file name for the view's name.
const PLACEHOLDER: &str = "{view}";

/// Whether a path means standard output.
pub(crate) fn is_standard(path: &Path) -> bool {
    path == Path::new(STANDARD)
}

/// The file of each view when all of them are rendered. The view's name replaces every `{view}` in the file name; if
/// there is none, it stands before the extension: `output.ppm` becomes `output-front.ppm`.
///
/// # Errors
/// [`Failure::SameOutput`] where two views would get one file: names may differ in characters that no file name can
/// have.
pub(crate) fn for_all_views(output: &Path, views: &[View]) -> Result<Vec<PathBuf>, Failure> {
    let mut taken = HashMap::new();
    let mut paths = Vec::with_capacity(views.len());
    for view in views {
        let path = with_view(output, &view.name);
        if let Some(first) = taken.insert(path.clone(), &view.name) {
            return Err(Failure::SameOutput { views: [first.clone(), view.name.clone()], path });
        }
        paths.push(path);
    }
    Ok(paths)
}

/// The output's path for the view of that name.
fn with_view(output: &Path, view: &str) -> PathBuf {
    let view: String = view.chars().map(|c| if may_stand_in_a_file_name(c) { c } else { '_' }).collect();
    match output.file_name().and_then(|name| name.to_str()) {
        Some(name) if name.contains(PLACEHOLDER) => output.with_file_name(name.replace(PLACEHOLDER, &view)),
        Some(_) | None => {
            let mut name = output.file_stem().unwrap_or_default().to_owned();
            name.push("-");
            name.push(view);
            if let Some(extension) = output.extension() {
                name.push(OsString::from("."));
                name.push(extension);
            }
            output.with_file_name(name)
        }
    }
}

/// Whether every file system takes the character.
fn may_stand_in_a_file_name(c: char) -> bool {
    !c.is_control() && !matches!(c, '/' | '\\' | ':' | '*' | '?' | '"' | '<' | '>' | '|')
}

/// Writes a file that can be computed again, unless the program is asked to stop before it is whole.
///
/// # Errors
/// Why it cannot be written. That the reader of a pipe went away is none: it has seen enough.
pub(crate) fn write(
    path: &Path,
    context: &Context,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Failure> {
    unless_stopped([path], context, || {
        save::save_output(path, |out| write(&mut Heeding { out, cancel: &context.cancel }))
    })
}

/// Writes somebody's document, and the files that belong to it: they are on the disk before what any of them replaces is
/// gone.
///
/// # Errors
/// Those of [`write`].
pub(crate) fn write_documents(files: &[(&Path, &[u8])], context: &Context) -> Result<(), Failure> {
    let writes = files.iter().map(|&(path, bytes)| {
        (path, move |out: &mut dyn Write| Heeding { out, cancel: &context.cancel }.write_all(bytes))
    });
    unless_stopped(files.iter().map(|(path, _)| *path), context, || save::save_together(writes))
}

fn unless_stopped<'a>(
    paths: impl IntoIterator<Item = &'a Path>,
    context: &Context,
    save: impl FnOnce() -> Result<(), save::SaveError>,
) -> Result<(), Failure> {
    // devices, pipes and standard output are written directly: there nothing is left behind
    let is_direct = |path: &Path| is_standard(path) || path.metadata().is_ok_and(|found| !found.is_file());
    let directly = paths.into_iter().all(is_direct);
    let saved = if directly { save() } else { context.writing.guard(save) };
    match saved {
        Ok(()) => Ok(()),
        Err(_) if context.cancel.is_cancelled() => Err(Failure::Interrupted),
        Err(error) if error.cause == save::SaveCause::Closed && is_standard(&error.path) => Ok(()),
        Err(error) => Err(Failure::Save(error)),
    }
}

/// A writer that fails once the program is asked to stop.
struct Heeding<'a> {
    out: &'a mut dyn Write,
    cancel: &'a Cancel,
}

impl Write for Heeding<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.cancel.is_cancelled() {
            // not `Interrupted`, which means "try again"
            true => Err(io::Error::other("interrupted")),
            false => self.out.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(output: &str, view: &str) -> String {
        with_view(Path::new(output), view).to_str().unwrap().to_owned()
    }

    #[test]
    fn the_view_stands_before_the_extension_or_where_the_pattern_says() {
        assert_eq!(named("output.ppm", "front"), "output-front.ppm");
        assert_eq!(named("pictures/my.scene.png", "from above"), "pictures/my.scene-from above.png");
        assert_eq!(named("output", "front"), "output-front");
        assert_eq!(named("pictures/{view}.png", "front"), "pictures/front.png");
        assert_eq!(named("{view}/{view}-{view}.png", "a"), "{view}/a-a.png");
    }

    #[test]
    fn a_view_cannot_leave_the_folder() {
        assert_eq!(named("pictures/{view}.png", "../../etc/passwd"), "pictures/.._.._etc_passwd.png");
        assert_eq!(named("output.ppm", "a\nb"), "output-a_b.ppm");
    }
}
