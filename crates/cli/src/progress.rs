//! The progress bar: on standard error, and only where somebody looks at it.

use crate::console::Console;
use indicatif::{ProgressBar, ProgressStyle};
use lancer_words::cli as words;

/// A bar for a picture of that many pixels; hidden where nobody looks.
pub(crate) fn bar(console: &Console, view: &str, pixels: u64) -> ProgressBar {
    if !console.shows_progress() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(pixels).with_prefix(words::progress_view(console.lang, view));
    // a template that the library refused would leave its own style, which does as well
    match ProgressStyle::with_template("{prefix} {wide_bar} {percent:>3} %  {eta}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
