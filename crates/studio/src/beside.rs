//! Something that is made of the document on a thread of its own, again whenever the document has changed: the window
//! shows what was made last and waits for nothing.

use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// What was made last, and what is being made. `K` says what of.
pub(crate) struct Beside<K, T> {
    made: Option<(K, T)>,
    coming: Option<(K, Receiver<T>)>,
}

impl<K, T> Default for Beside<K, T> {
    fn default() -> Beside<K, T> {
        Beside { made: None, coming: None }
    }
}

impl<K, T> std::fmt::Debug for Beside<K, T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Beside").field("made", &self.made.is_some()).finish_non_exhaustive()
    }
}

impl<K: Clone + PartialEq, T: Send + 'static> Beside<K, T> {
    /// Takes what is ready, and begins to make what is wanted if that is something else; the window is woken when it is
    /// there. One thing is made at a time.
    pub(crate) fn follow(&mut self, ctx: &egui::Context, wanted: &K, make: impl FnOnce() -> T + Send + 'static) {
        if let Some((of, news)) = &self.coming {
            match news.try_recv() {
                Ok(made) => self.made = Some((of.clone(), made)),
                Err(TryRecvError::Empty) => return,
                // whoever made it has failed; what there is stays
                Err(TryRecvError::Disconnected) => {}
            }
            self.coming = None;
        }
        if !self.is_of(wanted) {
            let (result, news) = channel();
            let ctx = ctx.clone();
            std::thread::spawn(move || {
                // a window that is gone wants nothing
                let _ = result.send(make());
                ctx.request_repaint_of(egui::ViewportId::ROOT);
            });
            self.coming = Some((wanted.clone(), news));
        }
    }

    /// What was made last, whatever of.
    pub(crate) fn get(&self) -> Option<&T> {
        self.made.as_ref().map(|(_, made)| made)
    }

    /// Whether what was made last is of that.
    pub(crate) fn is_of(&self, wanted: &K) -> bool {
        self.made.as_ref().is_some_and(|(of, _)| of == wanted)
    }
}
