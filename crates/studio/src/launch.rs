//! Opening the window, or saying in one sentence why there is none.
//!
//! The toolkit panics where a library of the system is missing; that is caught before the window is there, and the
//! library is named.

use crate::dialogs::SystemDialogs;
use crate::settings::Settings;
use crate::{Start, Studio, welcome};
use egui::ViewportBuilder;
use lancer_render::Tracing;
use lancer_words::{Lang, studio::app as words};
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The name under which the system knows the program.
const NAME: &str = "lancer-studio";

/// The libraries of a window under X11, with the packages of Debian that bring them.
const LIBRARIES: [(&str, &str); 8] = [
    ("libX11.so.6", "libx11-6"),
    ("libX11-xcb.so.1", "libx11-xcb1"),
    ("libxcb.so.1", "libxcb1"),
    ("libXcursor.so.1", "libxcursor1"),
    ("libXi.so.6", "libxi6"),
    ("libxkbcommon.so.0", "libxkbcommon0"),
    ("libxkbcommon-x11.so.0", "libxkbcommon-x11-0"),
    ("libGL.so.1", "libgl1"),
];

/// Shows the window until it is closed.
///
/// # Errors
/// The sentence that says why there is no window.
pub fn run(lang: Option<Lang>, open: Vec<PathBuf>, tracing: Tracing) -> Result<(), String> {
    let spoken = lang.unwrap_or_else(of_locale);
    let set = |name: &str| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    if cfg!(target_os = "linux") && !set("DISPLAY") && !set("WAYLAND_DISPLAY") {
        return Err(words::no_display(spoken));
    }
    let options = eframe::NativeOptions {
        viewport: ViewportBuilder::default()
            .with_app_id(NAME)
            .with_title("lancer")
            .with_inner_size([1280.0, 800.0])
            .with_min_inner_size([720.0, 480.0])
            .with_drag_and_drop(true)
            .with_icon(icon()),
        // nothing here has a gradient, and OpenGL in software pays for it at every pixel
        dithering: false,
        ..eframe::NativeOptions::default()
    };
    let begun = Arc::new(AtomicBool::new(false));
    let window = {
        let begun = Arc::clone(&begun);
        move || {
            eframe::run_native(
                NAME,
                options,
                Box::new(move |creation| {
                    begun.store(true, Ordering::Relaxed);
                    let ctx = &creation.egui_ctx;
                    let dialogs = Box::new(SystemDialogs::new(ctx.clone()));
                    let settings = Settings::restored(creation.storage);
                    let journals = eframe::storage_dir(NAME).map(|folder| folder.join("journals"));
                    let start = Start { settings, lang, tracing, stage: welcome::stage(), open, dialogs, journals };
                    Ok(Box::new(Studio::new(ctx, start)))
                }),
            )
        }
    };
    let hook = panic::take_hook();
    let quiet = Arc::clone(&begun);
    let loud = Arc::new(hook);
    panic::set_hook(Box::new(move |info| {
        if quiet.load(Ordering::Relaxed) {
            loud(info);
        }
    }));
    match panic::catch_unwind(AssertUnwindSafe(window)) {
        Ok(Ok(())) => Ok(()),
        Ok(Err(eframe::Error::WinitEventLoop(_))) if first_missing().is_none() => {
            let display = ["WAYLAND_DISPLAY", "DISPLAY"].iter().find_map(|name| std::env::var(name).ok());
            Err(words::no_connection(spoken, display.unwrap_or_default()))
        }
        Ok(Err(error)) => Err(why(spoken, &error.to_string())),
        Err(cause) if begun.load(Ordering::Relaxed) => panic::resume_unwind(cause),
        Err(cause) => {
            let text = cause.downcast_ref::<String>().cloned();
            let text = text.or_else(|| cause.downcast_ref::<&str>().map(|text| (*text).to_owned()));
            Err(why(spoken, &text.unwrap_or_default()))
        }
    }
}

fn of_locale() -> Lang {
    sys_locale::get_locale().map(|locale| Lang::of_locale(&locale)).unwrap_or_default()
}

/// The first library that is not there, with its package.
fn first_missing() -> Option<&'static (&'static str, &'static str)> {
    LIBRARIES.iter().find(|(library, _)| cfg!(target_os = "linux") && !is_installed(library))
}

/// Why there is no window: the library or the files that are missing, else what the toolkit says.
fn why(lang: Lang, cause: &str) -> String {
    match first_missing() {
        Some((library, package)) => words::missing_library(lang, library, package),
        // so the toolkit calls the files that say which key is which letter
        None if cause.contains("XKBNotFound") => words::no_keyboard_layouts(lang),
        None => words::no_window(lang, cause.lines().next().unwrap_or_default().trim()),
    }
}

/// Whether the system's loader would find a library, as far as its cache and the usual folders tell.
fn is_installed(library: &str) -> bool {
    let folders = ["/lib", "/usr/lib", "/lib64", "/usr/lib64", "/usr/local/lib", "/run/opengl-driver/lib"];
    let own = std::env::var("LD_LIBRARY_PATH").unwrap_or_default();
    let cache = std::fs::read("/etc/ld.so.cache").unwrap_or_default();
    // the cache holds the whole paths between zero bytes
    let listed = cache.split(|byte| *byte == 0).filter_map(|text| std::str::from_utf8(text).ok()).map(Path::new);
    let listed = listed.filter(|path| path.file_name().is_some_and(|name| name == library)).map(Path::to_owned);
    let triple = format!("{}-linux-gnu", std::env::consts::ARCH);
    let folders = own.split(':').filter(|folder| !folder.is_empty()).chain(folders).map(Path::new);
    let usual = folders.flat_map(|folder| [folder.join(library), folder.join(&triple).join(library)]);
    listed.chain(usual).any(|path| path.metadata().is_ok_and(|file| file.is_file() && file.len() > 0))
}

/// The window's picture: a lit ball, drawn by its formula.
fn icon() -> egui::IconData {
    const SIDE: usize = 64;
    let mut rgba = vec![0; SIDE * SIDE * 4];
    for (place, pixel) in rgba.chunks_exact_mut(4).enumerate() {
        let at = |count: usize| (count as f32 + 0.5) / SIDE as f32 * 2.0 - 1.0;
        let (x, y) = (at(place % SIDE) / 0.94, at(place / SIDE) / 0.94);
        let rim = 1.0 - x * x - y * y;
        if rim <= 0.0 {
            continue;
        }
        let z = rim.sqrt();
        let diffuse = (x * -0.5 + y * -0.6 + z * 0.62).max(0.0);
        let highlight = (2.0 * diffuse * z - 0.62).max(0.0).powi(24);
        let color = [0.16, 0.45, 0.68].map(|base| (base * (0.25 + 0.9 * diffuse) + highlight).min(1.0));
        for (byte, value) in pixel.iter_mut().zip(color.into_iter().chain([(rim * 12.0).min(1.0)])) {
            *byte = (value * 255.0) as u8;
        }
    }
    egui::IconData { rgba, width: SIDE as u32, height: SIDE as u32 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_library_that_is_not_there_is_named() {
        assert!(!is_installed("libno-such-library.so.9"));
        assert!(is_installed("libc.so.6"), "every Linux program is linked with it");
        let sentence = words::missing_library(Lang::English, "libGL.so.1", "libgl1");
        assert!(sentence.contains("libGL.so.1") && sentence.contains("apt install libgl1"));
    }

    #[test]
    fn the_icon_is_a_ball() {
        let icon = icon();
        assert_eq!(icon.rgba.len(), 64 * 64 * 4);
        assert_eq!((icon.rgba[3], icon.rgba[(32 * 64 + 32) * 4 + 3]), (0, 255), "clear corner, solid middle");
    }
}
