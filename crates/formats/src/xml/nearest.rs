//! "Did you mean": the legal word that is nearest to an unknown one.

/// Longer words are not compared: the time grows with the product of the lengths.
const LONGEST: usize = 40;

/// The legal word nearest to `found`, if one is near enough to have been meant.
///
/// Upper and lower case count as the same. Near means: a third of the letters changed, added, left out or exchanged with
/// their neighbour, or one word begins the other. Of equally near words the first is taken.
pub(super) fn nearest<'a>(found: &str, legal: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if found.chars().nth(LONGEST).is_some() {
        return None;
    }
    let wanted = found.to_lowercase();
    let far = |word: &str| {
        let word = word.to_lowercase();
        let distance = strsim::damerau_levenshtein(&wanted, &word);
        let begins = wanted.len().min(word.len()) >= 3 && (word.starts_with(&wanted) || wanted.starts_with(&word));
        let letters = wanted.chars().count().max(word.chars().count());
        match distance {
            near if near <= letters.max(3) / 3 => Some(near),
            _ if begins => Some(letters),
            _ => None,
        }
    };
    legal
        .into_iter()
        .filter(|word| word.len() <= 4 * LONGEST)
        .filter_map(|word| Some((far(word)?, word)))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, word)| word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_probably_meant() {
        let legal = ["center", "radius", "color", "position", "ka", "kd", "w", "look-at", "highlight"];
        for (found, meant) in [
            ("centre", Some("center")),
            ("Center", Some("center")),
            ("raduis", Some("radius")),
            ("colour", Some("color")),
            ("pos", Some("position")),
            ("Ka", Some("ka")),
            ("ks", Some("ka")),
            ("lookat", Some("look-at")),
            ("rayon", None),
            ("x", Some("w")),
            ("", Some("w")),
            ("shininess", None),
        ] {
            assert_eq!(nearest(found, legal), meant, "{found}");
        }
        assert_eq!(nearest(&"radius".repeat(1_000_000), legal), None);
    }
}
