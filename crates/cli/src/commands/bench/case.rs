//! What is measured: the fixed set of generated scenes, and how others are asked for.

use lancer_scene::generate::Family;
use lancer_words::Lang;
use lancer_words::cli::bench as words;

/// A generated scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Case {
    /// Its family.
    pub(super) family: Family,
    /// Its size, one of the family's.
    pub(super) size: u32,
}

/// What is measured where nothing is asked for: few objects and many, spheres and facets, one surface from ten thousand
/// facets to four millions, and glass.
const FIXED: [Case; 11] = [
    Case::new(Family::Course, 1),
    Case::new(Family::Sphereflake, 4),
    Case::new(Family::Sphereflake, 6),
    Case::new(Family::Tetrahedron, 8),
    Case::new(Family::Mountain, 8),
    Case::new(Family::Field, 71),
    Case::new(Family::Field, 708),
    Case::new(Family::Field, 1415),
    Case::new(Family::Knot, 100),
    Case::new(Family::Pebble, 59),
    Case::new(Family::Nest, 6),
];

impl Case {
    const fn new(family: Family, size: u32) -> Case {
        Case { family, size }
    }

    /// The fixed set.
    pub(super) fn fixed() -> Vec<Case> {
        FIXED.to_vec()
    }

    /// The name by which it is asked for: `field:708`.
    pub(super) fn name(self) -> String {
        format!("{}:{}", self.family.word(), self.size)
    }

    /// The scenes that `NAME` or `NAME:SIZE` means, or what is due instead.
    pub(super) fn asked(lang: Lang, text: &str) -> Result<Vec<Case>, String> {
        let (name, size) = text.split_once(':').map_or((text, None), |(name, size)| (name, Some(size)));
        let family = Family::ALL.into_iter().find(|family| family.word() == name);
        let family = family.ok_or_else(|| words::unknown_scene(lang, names()))?;
        let Some(size) = size else {
            let fixed: Vec<Case> = FIXED.into_iter().filter(|case| case.family == family).collect();
            // a family for looking at is not in the fixed set
            return Ok(if fixed.is_empty() { vec![Case::new(family, family.usual_size())] } else { fixed });
        };
        let sizes = family.sizes();
        match size.parse().ok().filter(|size| sizes.contains(size)) {
            Some(size) => Ok(vec![Case { family, size }]),
            None => Err(words::bad_size_of(lang, name, sizes.start(), sizes.end())),
        }
    }
}

/// The names of all families.
pub(super) fn names() -> String {
    Family::ALL.map(Family::word).join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fixed_set_holds_sizes_that_its_families_have() {
        assert!(FIXED.iter().all(|case| case.family.sizes().contains(&case.size)));
    }

    #[test]
    fn a_name_means_the_sizes_of_the_fixed_set_and_a_name_with_a_size_that_one() {
        let asked = |text| Case::asked(Lang::English, text);
        assert_eq!(asked("course"), Ok(vec![Case::new(Family::Course, 1)]));
        assert_eq!(asked("field").unwrap().len(), 3);
        assert_eq!(asked("sponge"), Ok(vec![Case::new(Family::Sponge, 3)]));
        assert_eq!(asked("field:20"), Ok(vec![Case::new(Family::Field, 20)]));
        assert_eq!(asked("knot:2"), Err("the size of knot is a whole number from 3 to 500".to_owned()));
        assert!(asked("knot:").is_err() && asked("knot:-3").is_err() && asked("knot:7:7").is_err());
        assert_eq!(
            asked("teapot"),
            Err("the scenes are course, sphereflake, tetrahedron, mountain, field, knot, pebble, nest, lattice, \
sponge; a size may follow a colon, as in field:708"
                .to_owned())
        );
    }
}
