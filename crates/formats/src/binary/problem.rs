//! What can be wrong with a binary scene.

use crate::Describe;
use crate::xml::{Excerpt, XmlProblem};
use lancer_scene::{Invalid, Name};
use lancer_words::{Lang, binary as words};

/// Why a file is refused. Nothing of a refused file is used.
#[derive(Clone, Debug, PartialEq)]
pub enum BinaryProblem {
    /// The signature is missing.
    NotBinaryScene,
    /// The signature was changed as transfers of text do.
    TransferredAsText,
    /// Bytes are missing at the end.
    Cut {
        /// Bytes that are there.
        found: u64,
        /// Bytes that should be there, as far as they are known.
        expected: u64,
    },
    /// There are bytes behind the end.
    TooLong {
        /// Bytes that are there.
        found: u64,
        /// Bytes that the file says it has.
        expected: u64,
    },
    /// The checksum does not match.
    Damaged,
    /// The version is one that this program does not know.
    UnknownVersion {
        /// The file's version.
        found: u32,
    },
    /// The file is whole, but its content does not follow its version.
    Malformed {
        /// What was met, in the decoder's words.
        detail: String,
    },
    /// The file is whole, but the scene breaks a rule.
    Invalid {
        /// The part that breaks it; `None` for the world.
        name: Option<Name>,
        /// The rule.
        rule: Invalid,
    },
}

impl Describe for BinaryProblem {
    fn code(&self) -> &'static str {
        match self {
            BinaryProblem::NotBinaryScene => "binary::not-a-scene",
            BinaryProblem::TransferredAsText => "binary::transferred-as-text",
            BinaryProblem::Cut { .. } => "binary::cut",
            BinaryProblem::TooLong { .. } => "binary::too-long",
            BinaryProblem::Damaged => "binary::damaged",
            BinaryProblem::UnknownVersion { .. } => "binary::version",
            BinaryProblem::Malformed { .. } => "binary::malformed",
            BinaryProblem::Invalid { .. } => "binary::invalid",
        }
    }

    fn message(&self, lang: Lang) -> String {
        match self {
            BinaryProblem::NotBinaryScene => words::not_binary_scene(lang),
            BinaryProblem::TransferredAsText => words::transferred_as_text(lang),
            BinaryProblem::Cut { found, expected } if *expected <= super::frame::HEADER as u64 => {
                words::cut_in_header(lang, found)
            }
            BinaryProblem::Cut { found, expected } => words::cut(lang, found, expected),
            BinaryProblem::TooLong { found, expected } => words::too_long(lang, found, expected),
            BinaryProblem::Damaged => words::damaged(lang),
            BinaryProblem::UnknownVersion { found } if *found > super::VERSION => {
                words::newer_version(lang, found, super::VERSION)
            }
            BinaryProblem::UnknownVersion { found } => words::unknown_version(lang, found),
            BinaryProblem::Malformed { detail } => words::malformed(lang, detail),
            BinaryProblem::Invalid { name, rule } => {
                let rule = XmlProblem::from(rule.clone()).message(lang);
                match name {
                    Some(name) => words::invalid_part(lang, Excerpt::new(name), rule),
                    None => rule,
                }
            }
        }
    }

    fn label(&self, _lang: Lang) -> String {
        String::new()
    }

    fn help(&self, lang: Lang) -> Option<String> {
        Some(match self {
            BinaryProblem::NotBinaryScene => words::not_binary_scene_help(lang),
            BinaryProblem::TransferredAsText => words::transferred_as_text_help(lang),
            BinaryProblem::Cut { .. } | BinaryProblem::TooLong { .. } | BinaryProblem::Damaged => {
                words::copy_again_help(lang)
            }
            BinaryProblem::UnknownVersion { found } if *found > super::VERSION => words::newer_version_help(lang),
            BinaryProblem::UnknownVersion { .. } | BinaryProblem::Malformed { .. } | BinaryProblem::Invalid { .. } => {
                words::other_program_help(lang)
            }
        })
    }
}
