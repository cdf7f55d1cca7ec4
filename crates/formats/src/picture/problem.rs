//! What can be wrong with a picture file.

use crate::Describe;
use lancer_words::{Lang, picture as words};

/// The numbers of a pixmap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Count {
    /// Pixels per row.
    Width,
    /// Rows.
    Height,
    /// The value of full intensity.
    Maxval,
    /// One channel of one pixel.
    Sample,
}

impl Count {
    fn word(self, lang: Lang) -> String {
        match self {
            Count::Width => words::width(lang),
            Count::Height => words::height(lang),
            Count::Maxval => words::maxval(lang),
            Count::Sample => words::sample(lang),
        }
    }
}

/// What is wrong with a picture file.
#[derive(Clone, Debug, PartialEq)]
pub enum PictureProblem {
    /// The first bytes are those of no format that can be read.
    UnknownFormat,
    /// A bitmap, a greymap or a PAM file; the character behind the `P`.
    OtherNetpbm(char),
    /// The file ends before a number of the header.
    MissingNumber(Count),
    /// Something else stands where a number is due.
    Junk(Count),
    /// A number of the header is 0 or too large.
    OutOfRange {
        /// Which number.
        count: Count,
        /// What it is.
        value: u64,
        /// The greatest legal value.
        max: u32,
    },
    /// The file ends within the raster.
    TooShort {
        /// How many samples the size asks for.
        due: u64,
        /// How many there are.
        found: u64,
    },
    /// A sample is brighter than full intensity.
    SampleAboveMaxval {
        /// The sample.
        sample: u64,
        /// Full intensity.
        maxval: u32,
    },
    /// The decoder of another format refuses the file; its own words.
    Undecodable(String),
    /// Decoding would take too much memory.
    TooMuchMemory {
        /// The bound in bytes.
        most: u64,
    },
}

impl Describe for PictureProblem {
    fn code(&self) -> &'static str {
        match self {
            PictureProblem::UnknownFormat => "picture::unknown-format",
            PictureProblem::OtherNetpbm(_) => "picture::other-netpbm",
            PictureProblem::MissingNumber(_) => "picture::missing-number",
            PictureProblem::Junk(_) => "picture::junk",
            PictureProblem::OutOfRange { .. } => "picture::out-of-range",
            PictureProblem::TooShort { .. } => "picture::too-short",
            PictureProblem::SampleAboveMaxval { .. } => "picture::sample-above-maxval",
            PictureProblem::Undecodable(_) => "picture::undecodable",
            PictureProblem::TooMuchMemory { .. } => "picture::too-much-memory",
        }
    }

    fn message(&self, lang: Lang) -> String {
        match self {
            PictureProblem::UnknownFormat => words::unknown_format(lang),
            PictureProblem::OtherNetpbm(kind) => words::other_netpbm(lang, kind),
            PictureProblem::MissingNumber(count) => words::missing_number(lang, count.word(lang)),
            PictureProblem::Junk(count) => words::junk(lang, count.word(lang)),
            PictureProblem::OutOfRange { count, value, max } => words::out_of_range(lang, count.word(lang), value, max),
            PictureProblem::TooShort { due, found } => words::too_short(lang, due, found),
            PictureProblem::SampleAboveMaxval { sample, maxval } => words::sample_above_maxval(lang, sample, maxval),
            PictureProblem::Undecodable(cause) => words::undecodable(lang, cause),
            PictureProblem::TooMuchMemory { most } => words::too_much_memory(lang, most >> 20),
        }
    }

    fn label(&self, lang: Lang) -> String {
        match self {
            PictureProblem::Junk(_) => words::not_a_number(lang),
            PictureProblem::MissingNumber(_) | PictureProblem::TooShort { .. } => words::ends_here(lang),
            PictureProblem::UnknownFormat
            | PictureProblem::OtherNetpbm(_)
            | PictureProblem::OutOfRange { .. }
            | PictureProblem::SampleAboveMaxval { .. }
            | PictureProblem::Undecodable(_)
            | PictureProblem::TooMuchMemory { .. } => String::new(),
        }
    }

    fn help(&self, lang: Lang) -> Option<String> {
        match self {
            PictureProblem::UnknownFormat | PictureProblem::OtherNetpbm(_) => Some(words::formats_help(lang)),
            PictureProblem::MissingNumber(_) | PictureProblem::Junk(_) | PictureProblem::OutOfRange { .. } => {
                Some(words::header_help(lang))
            }
            PictureProblem::TooShort { .. } => Some(words::too_short_help(lang)),
            PictureProblem::SampleAboveMaxval { .. }
            | PictureProblem::Undecodable(_)
            | PictureProblem::TooMuchMemory { .. } => None,
        }
    }
}
