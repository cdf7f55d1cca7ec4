//! The progress bar: on standard error, and only where somebody looks at it.

use crate::console::Console;
use indicatif::{ProgressBar, ProgressStyle};

/// A bar for a view's picture; hidden where nobody looks.
pub(crate) fn bar(console: &Console, view: &str) -> ProgressBar {
    if !console.shows_progress() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(1).with_prefix(view.to_owned());
    // a template that the library refused would leave its own style, which does as well
    match ProgressStyle::with_template("{prefix} {wide_bar} {percent:>3} %  {eta}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
