//! The one catalogue of lancer's words, in English and French.
//!
//! Every sentence that a person reads stands here as a function of the language and of its arguments, so the compiler
//! proves that no translation and no argument is missing. A file holds one area of words; the macro [`phrases`] writes
//! the functions.
//!
//! ```
//! use lancer_words::{Lang, number};
//! assert_eq!(number::objects(Lang::French, 0), "0 objet");
//! assert_eq!(number::objects(Lang::English, 2), "2 objects");
//! ```

mod lang;
pub mod number;

pub use lang::Lang;

/// Writes one function per sentence: `pub fn name(lang, arguments…) -> String`.
///
/// The sentence of each language is a format string that names the arguments.
macro_rules! phrases {
    ($($(#[$doc:meta])* $name:ident($($arg:ident),* $(,)?) { $en:literal, $fr:literal $(,)? })*) => {$(
        $(#[$doc])*
        #[doc = concat!("\n\n* English: ", $en, "\n* French: ", $fr)]
        pub fn $name(lang: $crate::Lang $(, $arg: impl std::fmt::Display)*) -> String {
            match lang {
                $crate::Lang::English => format!($en),
                $crate::Lang::French => format!($fr),
            }
        }
    )*};
}
pub(crate) use phrases;
