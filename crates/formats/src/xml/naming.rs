//! Automatic names of what has none: `sphere 3`, the first number that is free.

use lancer_scene::Name;
use std::collections::{HashMap, HashSet};

/// Gives out free names. All names that stand in the document must be known before the first is given.
///
/// The same names as `lancer_scene::first_free_name` finds, without counting from 1 again for each.
#[derive(Clone, Debug)]
pub struct AutomaticNames {
    taken: HashSet<Name>,
    counted: HashMap<&'static str, u64>,
}

impl AutomaticNames {
    /// Names beside those that are taken.
    pub fn new(taken: impl IntoIterator<Item = Name>) -> AutomaticNames {
        AutomaticNames { taken: taken.into_iter().collect(), counted: HashMap::new() }
    }

    /// The next free name `stem N`.
    pub fn next(&mut self, stem: &'static str) -> Name {
        let counted = self.counted.entry(stem).or_default();
        loop {
            *counted += 1;
            let name = format!("{stem} {counted}");
            if !self.taken.contains(name.as_str()) {
                return name.into();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lancer_scene::first_free_name;

    #[test]
    fn the_same_names_as_the_model_gives() {
        let mut taken: HashSet<Name> = ["sphere 2", "sphere 5", "cube 1", "sphere"].map(Name::from).into();
        let mut names = AutomaticNames::new(taken.iter().cloned());
        for stem in ["sphere", "sphere", "cube", "sphere", "sphere"] {
            let expected = first_free_name(stem, &taken);
            assert_eq!(names.next(stem), expected);
            taken.insert(expected);
        }
    }
}
