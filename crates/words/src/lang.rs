//! The two languages, and how one is chosen from a locale's name.

/// A language that lancer speaks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Lang {
    /// English, also for every locale that is not French.
    #[default]
    English,
    /// French, in the terms of the course's subject.
    French,
}

impl Lang {
    /// Both languages, for tests and menus.
    pub const ALL: [Lang; 2] = [Lang::English, Lang::French];

    /// The language of a locale's name such as `fr_FR.UTF-8`, `fr-CA`, `C` or `en`.
    pub fn of_locale(locale: &str) -> Lang {
        let language = locale.split(['_', '-', '.', '@']).next().unwrap_or_default();
        if language.eq_ignore_ascii_case("fr") { Lang::French } else { Lang::English }
    }

    /// The two-letter code of ISO 639-1: `en`, `fr`.
    pub fn code(self) -> &'static str {
        match self {
            Lang::English => "en",
            Lang::French => "fr",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn locales_name_their_language() {
        for (locale, lang) in [
            ("fr_FR.UTF-8", Lang::French),
            ("FR", Lang::French),
            ("fr-CA", Lang::French),
            ("C", Lang::English),
            ("", Lang::English),
            ("frisian", Lang::English),
            ("de_DE", Lang::English),
        ] {
            assert_eq!(Lang::of_locale(locale), lang, "{locale}");
        }
    }
}
