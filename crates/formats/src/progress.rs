//! How far a long reading is, for somebody who waits for it.
//!
//! Readers tell it as they go, whoever calls them; a thread that wants to know wraps its reading into [`watched`] and
//! lets another thread look. So no reader's result can depend on being watched, and none of them has one more argument.

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Readers tell after so many lines, vertices or facets.
const EVERY: usize = 1024;

/// What is being done with a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Its bytes are being brought into memory.
    Bytes,
    /// What the bytes say is being made out.
    Content,
}

/// How far a reading is. A clone shows the same reading.
#[derive(Clone, Debug, Default)]
pub struct Progress(Arc<State>);

#[derive(Debug, Default)]
struct State {
    content: AtomicBool,
    done: AtomicU64,
    all: AtomicU64,
}

impl Progress {
    /// What is being done with the file that is read just now, and how much of it is done, 0 to 1; `None` while that is
    /// not known. It begins again with each stage, and for each file that a document names.
    pub fn now(&self) -> (Stage, Option<f64>) {
        let State { content, done, all } = &*self.0;
        let stage = if content.load(Ordering::Relaxed) { Stage::Content } else { Stage::Bytes };
        let (done, all) = (done.load(Ordering::Relaxed), all.load(Ordering::Relaxed));
        (stage, (all > 0 && done > 0).then(|| (done as f64 / all as f64).min(1.0)))
    }
}

thread_local! {
    /// What watches the reading of this thread.
    static WATCHING: RefCell<Option<Progress>> = const { RefCell::new(None) };
}

/// Does some reading on this thread while `progress` shows how far it is.
pub fn watched<T>(progress: &Progress, reading: impl FnOnce() -> T) -> T {
    let before = WATCHING.replace(Some(progress.clone()));
    let read = reading();
    WATCHING.set(before);
    read
}

fn tell(news: impl FnOnce(&State)) {
    WATCHING.with_borrow(|watching| {
        if let Some(Progress(state)) = watching {
            news(state);
        }
    });
}

/// A stage begins with a file of so many bytes; 0 if nobody knows.
pub(crate) fn begin(stage: Stage, bytes: u64) {
    tell(|state| {
        state.done.store(0, Ordering::Relaxed);
        state.all.store(bytes, Ordering::Relaxed);
        state.content.store(stage == Stage::Content, Ordering::Relaxed);
    });
}

/// Reads a file that another one names; then the other one goes on where it was.
pub(crate) fn aside<T>(reading: impl FnOnce() -> T) -> T {
    let mut before = (false, 0, 0);
    tell(|State { content, done, all }| {
        before = (content.load(Ordering::Relaxed), done.load(Ordering::Relaxed), all.load(Ordering::Relaxed));
    });
    let read = reading();
    tell(|State { content, done, all }| {
        content.store(before.0, Ordering::Relaxed);
        done.store(before.1, Ordering::Relaxed);
        all.store(before.2, Ordering::Relaxed);
    });
    read
}

/// The stage has come to this byte of the file.
pub(crate) fn at(byte: u64) {
    tell(|state| state.done.store(byte, Ordering::Relaxed));
}

/// As [`at`], for a reader that has come to its `count`-th line, vertex or facet: told now and then only.
pub(crate) fn now_and_then(count: usize, byte: impl FnOnce() -> usize) {
    if count.is_multiple_of(EVERY) {
        at(byte() as u64);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_watched_is_shown_and_what_is_not_is_not() {
        let progress = Progress::default();
        begin(Stage::Content, 8);
        assert_eq!(progress.now(), (Stage::Bytes, None), "nobody watched");
        watched(&progress, || {
            begin(Stage::Bytes, 200);
            assert_eq!(progress.now(), (Stage::Bytes, None), "nothing is done");
            at(50);
            assert_eq!(progress.now(), (Stage::Bytes, Some(0.25)));
            now_and_then(EVERY + 1, || 100);
            assert_eq!(progress.now(), (Stage::Bytes, Some(0.25)), "not now");
            begin(Stage::Content, 100);
            now_and_then(2 * EVERY, || 60);
            aside(|| begin(Stage::Bytes, 7));
            assert_eq!(progress.now(), (Stage::Content, Some(0.6)), "the file goes on that named the other");
            now_and_then(3 * EVERY, || 100);
        });
        at(10);
        assert_eq!(progress.clone().now(), (Stage::Content, Some(1.0)));
    }
}
