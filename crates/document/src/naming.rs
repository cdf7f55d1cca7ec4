//! Automatic names: distinct from every other name of the stage, so that no two things of any kind are confused.

use lancer_scene::{Name, Stage, first_free_name};
use std::collections::HashSet;

/// Every name of objects, lamps, materials and views.
pub(crate) fn taken(stage: &Stage) -> HashSet<Name> {
    let scene = &stage.scene;
    let objects = scene.objects.iter().map(|object| &object.name);
    let lights = scene.lights.iter().map(|light| &light.name);
    let materials = scene.materials.iter().map(|material| &material.name);
    let views = stage.views.iter().map(|view| &view.name);
    objects.chain(lights).chain(materials).chain(views).cloned().collect()
}

/// The name of a new thing: `sphere 3`.
pub(crate) fn numbered(stem: &str, taken: &HashSet<Name>) -> Name {
    first_free_name(stem, taken)
}

/// The name of a thing that brings one with it: `rabbit`, or `rabbit 2` where that is taken.
pub(crate) fn distinct(wanted: &str, taken: &HashSet<Name>) -> Name {
    if taken.contains(wanted) { copy(wanted, taken) } else { wanted.into() }
}

/// The name of a copy: the next free number after the original's own, or from 2 on.
pub(crate) fn copy(original: &str, taken: &HashSet<Name>) -> Name {
    let numbered = original.rsplit_once(' ').and_then(|(stem, digits)| {
        let plain = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
        plain.then(|| digits.parse::<u32>().ok()).flatten().map(|number| (stem, u64::from(number) + 1))
    });
    let (stem, mut number) = numbered.unwrap_or((original, 2));
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
    fn a_copy_takes_the_next_free_number() {
        let taken = ["ball", "ball 2", "sphere 9", "sphere 11", "a 4294967295"].into_iter().map(Name::from).collect();
        assert_eq!(&*copy("ball", &taken), "ball 3");
        assert_eq!(&*copy("ball 2", &taken), "ball 3");
        assert_eq!(&*copy("sphere 9", &taken), "sphere 10");
        assert_eq!(&*copy("a 4294967295", &taken), "a 4294967296");
        assert_eq!(&*copy("a 99999999999", &taken), "a 99999999999 2", "no counting number");
        assert_eq!(&*distinct("ball", &taken), "ball 3");
        assert_eq!(&*distinct("rabbit", &taken), "rabbit");
    }
}
