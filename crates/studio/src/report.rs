//! What was found in a file.

use lancer_formats::{Diagnostic, Severity, Source};

/// A file that was read, and everything there is to say about it.
#[derive(Clone, Debug)]
pub struct Report {
    /// Its name and, where it has one, its text.
    pub source: Source,
    /// What was found, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
}

impl Report {
    /// How many of the problems are that bad.
    pub fn count(&self, severity: Severity) -> usize {
        self.diagnostics.iter().filter(|diagnostic| diagnostic.severity == severity).count()
    }
}
