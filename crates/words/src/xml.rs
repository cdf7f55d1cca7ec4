//! What is said of XML documents: their form, their vocabulary and the rules of scenes and views.

use std::fmt::Display;

/// What is said of one problem.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// What is wrong; no full stop.
    pub message: String,
    /// The words under the underlined text; may be empty.
    pub label: String,
    /// The rule or the way out; may be empty.
    pub help: String,
}

impl Report {
    pub(crate) fn new(message: impl Display, label: impl Display, help: impl Display) -> Report {
        Report { message: message.to_string(), label: label.to_string(), help: help.to_string() }
    }
}

/// Writes one function per problem: `pub fn name(lang, arguments…) -> Report`, each language with its message, the words
/// under the underlined text, and the help.
macro_rules! reports {
    ($($(#[$doc:meta])* $name:ident($($arg:ident),* $(,)?) {
        $em:literal, $el:literal, $eh:literal;
        $fm:literal, $fl:literal, $fh:literal $(;)?
    })*) => {$(
        $(#[$doc])*
        #[doc = concat!("\n\n* English: ", $em, "\n* French: ", $fm)]
        pub fn $name(lang: $crate::Lang $(, $arg: impl std::fmt::Display)*) -> $crate::xml::Report {
            match lang {
                $crate::Lang::English => {
                    $crate::xml::Report::new(format_args!($em), format_args!($el), format_args!($eh))
                }
                $crate::Lang::French => {
                    $crate::xml::Report::new(format_args!($fm), format_args!($fl), format_args!($fh))
                }
            }
        }
    )*};
}

pub(crate) use reports;

pub mod report;
pub mod rule;
pub mod structure;
pub mod syntax;
pub mod value;
pub mod vocabulary;
