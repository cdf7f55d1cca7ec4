//! Names of objects, lamps, materials and views.

use std::collections::HashSet;
use std::sync::Arc;

/// A name: trimmed, not empty, case-sensitive, shared between snapshots.
pub type Name = Arc<str>;

/// The three sets within which names are unique.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NameKind {
    /// Objects and lamps together.
    ObjectOrLight,
    /// Materials.
    Material,
    /// Views.
    View,
}

/// The automatic name `stem N` with the first free number from 1 on: `sphere 3`.
pub fn first_free_name(stem: &str, taken: &HashSet<Name>) -> Name {
    let mut number = 1_u64;
    loop {
        let name = format!("{stem} {number}");
        if !taken.contains(name.as_str()) {
            return name.into();
        }
        number += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_free_number_is_taken() {
        let taken = ["sphere 1", "sphere 2", "sphere 4", "Sphere 3"].into_iter().map(Name::from).collect();
        assert_eq!(&*first_free_name("sphere", &taken), "sphere 3");
        assert_eq!(&*first_free_name("cube", &taken), "cube 1");
    }
}
