//! The macro that writes the functions of the catalogue.

/// Writes one function per sentence: `pub fn name(lang, arguments…) -> String`.
///
/// The sentence of each language is a format string that names the arguments.
macro_rules! phrases {
    ($($(#[$doc:meta])* $name:ident($($arg:ident),* $(,)?) { $en:literal, $fr:literal $(,)? })*) => {$(
        $(#[$doc])*
        #[doc = concat!("\n\n```text\n", $en, "\n", $fr, "\n```")]
        pub fn $name(lang: $crate::Lang $(, $arg: impl std::fmt::Display)*) -> String {
            match lang {
                $crate::Lang::English => format!($en),
                $crate::Lang::French => format!($fr),
            }
        }
    )*};
}
