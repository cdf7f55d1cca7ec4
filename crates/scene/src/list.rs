//! A list whose items and backbone are shared between snapshots.

use std::ops::Deref;
use std::sync::Arc;

/// An ordered list of shared items. A clone costs two counters; a change copies pointers, never items.
#[derive(Debug)]
pub struct List<T>(Arc<Vec<Arc<T>>>);

impl<T> List<T> {
    /// The list with `change` made to a copy of its backbone.
    #[must_use]
    pub fn with(&self, change: impl FnOnce(&mut Vec<Arc<T>>)) -> List<T> {
        let mut items = Vec::clone(&self.0);
        change(&mut items);
        List(Arc::new(items))
    }

    /// Makes `change` to the backbone, which is copied first if it is shared.
    pub(crate) fn change(&mut self, change: impl FnOnce(&mut Vec<Arc<T>>)) {
        change(Arc::make_mut(&mut self.0));
    }

    /// Whether both lists are the same in memory, item by item: what an update need not look at again.
    pub fn same_items(&self, other: &List<T>) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
            || self.len() == other.len() && self.iter().zip(other.iter()).all(|(a, b)| Arc::ptr_eq(a, b))
    }
}

impl<T> Clone for List<T> {
    fn clone(&self) -> List<T> {
        List(Arc::clone(&self.0))
    }
}

impl<T> Default for List<T> {
    fn default() -> List<T> {
        List(Arc::default())
    }
}

impl<T: PartialEq> PartialEq for List<T> {
    fn eq(&self, other: &List<T>) -> bool {
        // what is shared is equal: only what changed is looked into
        self.len() == other.len() && self.iter().zip(other.iter()).all(|(a, b)| Arc::ptr_eq(a, b) || a == b)
    }
}

impl<T> Deref for List<T> {
    type Target = [Arc<T>];
    fn deref(&self) -> &[Arc<T>] {
        &self.0
    }
}

impl<T> FromIterator<T> for List<T> {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> List<T> {
        List(Arc::new(items.into_iter().map(Arc::new).collect()))
    }
}

impl<T> FromIterator<Arc<T>> for List<T> {
    fn from_iter<I: IntoIterator<Item = Arc<T>>>(items: I) -> List<T> {
        List(Arc::new(items.into_iter().collect()))
    }
}

impl<'a, T> IntoIterator for &'a List<T> {
    type Item = &'a Arc<T>;
    type IntoIter = std::slice::Iter<'a, Arc<T>>;
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}
