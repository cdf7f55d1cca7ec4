//! A mistyped command is taken for the name of a scene: what goes wrong then says which command may have been meant.

use std::ffi::OsString;
use std::path::Path;

/// So many letters may be wrong.
const WRONG: usize = 2;

/// The command that the first argument may have been meant for, if it is neither one nor a file.
pub(crate) fn meant<'a>(args: &[OsString], commands: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = args.get(1)?.to_str()?;
    let is_word = word.len() > WRONG && word.chars().all(|letter| letter.is_ascii_lowercase());
    if !is_word || Path::new(word).exists() {
        return None;
    }
    let near = commands.into_iter().map(|command| (strsim::damerau_levenshtein(word, command), command));
    near.filter(|(wrong, _)| (1..=WRONG).contains(wrong)).min_by_key(|(wrong, _)| *wrong).map(|(_, command)| command)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_that_are_near_a_command() {
        let meant_by = |args: &str| {
            let args: Vec<OsString> = args.split(' ').map(OsString::from).collect();
            meant(&args, ["show", "check", "explain", "diff"])
        };
        assert_eq!(meant_by("lancer shwo a.xml"), Some("show"));
        assert_eq!(meant_by("lancer expalin a.xml v.xml 1 2"), Some("explain"));
        for not_meant in ["lancer", "lancer show", "lancer scene", "lancer di", "lancer dif.xml", "lancer --diff"] {
            assert_eq!(meant_by(not_meant), None, "{not_meant}");
        }
        // the crate's folder has a folder of that name
        assert_eq!(meant(&["lancer".into(), "src".into()], ["srcs"]), None);
    }
}
