//! Which language the program speaks: `--lang`, else the locale.
//!
//! Help and complaints about the command line are in that language too, so it must be known before the command line is
//! parsed. `--lang` is therefore taken out of the arguments first, wherever it stands; a value that is no language is
//! left in, for the parser to complain about.

use lancer_words::Lang;
use std::ffi::OsString;

/// The language, and the arguments without `--lang`.
pub(crate) fn choose(args: impl IntoIterator<Item = OsString>) -> (Lang, Vec<OsString>) {
    let mut chosen = None;
    let mut rest = Vec::new();
    let mut args = args.into_iter().peekable();
    while let Some(arg) = args.next() {
        if arg == "--" {
            rest.push(arg);
            rest.extend(args);
            break;
        }
        let after_equals = arg.to_str().and_then(|arg| arg.strip_prefix("--lang=")).and_then(language);
        let after_space =
            (arg == "--lang").then(|| args.peek().and_then(|next| next.to_str()).and_then(language)).flatten();
        match (after_equals, after_space) {
            (Some(lang), _) => chosen = Some(lang),
            (None, Some(lang)) => {
                args.next();
                chosen = Some(lang);
            }
            (None, None) => rest.push(arg),
        }
    }
    (chosen.unwrap_or_else(of_locale), rest)
}

/// The language of that code.
fn language(code: &str) -> Option<Lang> {
    Lang::ALL.into_iter().find(|lang| lang.code() == code)
}

/// The language of the locale; English where there is none.
fn of_locale() -> Lang {
    sys_locale::get_locale().map(|locale| Lang::of_locale(&locale)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn choose_of(args: &str) -> (Lang, String) {
        let (lang, rest) = choose(args.split(' ').map(OsString::from));
        let rest: Vec<_> = rest.into_iter().map(|arg| arg.into_string().unwrap()).collect();
        (lang, rest.join(" "))
    }

    #[test]
    fn lang_is_taken_out_wherever_it_stands() {
        assert_eq!(choose_of("--lang fr show a.xml"), (Lang::French, "show a.xml".into()));
        assert_eq!(choose_of("a.xml --lang=fr b.xml"), (Lang::French, "a.xml b.xml".into()));
        assert_eq!(choose_of("a.xml --lang fr --lang en"), (Lang::English, "a.xml".into()));
    }

    #[test]
    fn what_is_no_language_and_what_comes_after_two_dashes_is_left_in() {
        assert_eq!(choose_of("--lang de a").1, "--lang de a");
        assert_eq!(choose_of("--lang").1, "--lang");
        assert_eq!(choose_of("--lang en -- --lang fr"), (Lang::English, "-- --lang fr".into()));
    }
}
