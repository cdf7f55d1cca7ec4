//! Where a reader puts what it finds wrong, so that all errors of a document are told at once.

use super::{Document, Guess, StructureProblem};
use crate::{Diagnostic, Lines, Outcome, Problem, Severity, Span};
use std::cell::OnceCell;

/// No more problems than this are kept: a document can hold millions.
const MOST: usize = 10_000;
/// Unknown words get a guess until there are this many problems.
const MOST_GUESSES: usize = 1000;

/// The problems found so far.
#[derive(Debug)]
pub(crate) struct Sink<'d> {
    document: &'d Document,
    diagnostics: Vec<Diagnostic>,
    failed: bool,
    lines: OnceCell<Lines>,
}

impl<'d> Sink<'d> {
    pub(crate) fn new(document: &'d Document) -> Sink<'d> {
        Sink { document, diagnostics: Vec::new(), failed: false, lines: OnceCell::new() }
    }

    pub(crate) fn push(&mut self, diagnostic: Diagnostic) {
        self.failed |= diagnostic.severity == Severity::Error;
        if self.diagnostics.len() < MOST {
            self.diagnostics.push(diagnostic);
        } else if self.diagnostics.len() == MOST {
            self.diagnostics.push(Diagnostic::error(None, StructureProblem::TooMany { count: MOST }));
        }
    }

    pub(crate) fn error(&mut self, span: Span, problem: impl Into<Problem>) {
        self.push(Diagnostic::error(span, problem));
    }

    pub(crate) fn warning(&mut self, span: Span, problem: impl Into<Problem>) {
        self.push(Diagnostic::warning(span, problem));
    }

    /// The value, or `None` and its fault among the problems.
    pub(crate) fn keep<T>(&mut self, result: Result<T, Box<Diagnostic>>) -> Option<T> {
        result.map_err(|fault| self.push(*fault)).ok()
    }

    /// The value, or `None` and its faults among the problems.
    pub(super) fn keep_all<T>(&mut self, result: Result<T, Vec<Diagnostic>>) -> Option<T> {
        result.map_err(|faults| faults.into_iter().for_each(|fault| self.push(fault))).ok()
    }

    /// Whether further problems are not kept, so that nothing need be found out about them.
    pub(super) fn is_full(&self) -> bool {
        self.diagnostics.len() > MOST
    }

    /// What an unknown word was probably meant to be. Guesses take their time: hostile documents get only so many.
    pub(crate) fn guess<'a>(&self, found: &str, legal: impl IntoIterator<Item = &'a str>) -> Guess {
        const COMPARED: usize = 1000;
        if self.diagnostics.len() < MOST_GUESSES {
            Guess::among(found, legal.into_iter().take(COMPARED))
        } else {
            Guess(None)
        }
    }

    /// The line of an offset, from 1.
    pub(crate) fn line(&self, offset: usize) -> usize {
        let lines = self.lines.get_or_init(|| Lines::new(&self.document.source().text));
        lines.line(offset)
    }

    /// Whether some problem is an error.
    pub(super) fn has_failed(&self) -> bool {
        self.failed
    }

    /// The value if no problem is an error, and all problems in the order of the text.
    pub(crate) fn finish<T>(mut self, value: Option<T>) -> Outcome<T> {
        // What has no place comes last.
        self.diagnostics.sort_by_key(|diagnostic| diagnostic.span.map_or(usize::MAX, |span| span.start));
        Outcome { value: value.filter(|_| !self.failed), diagnostics: self.diagnostics }
    }
}
