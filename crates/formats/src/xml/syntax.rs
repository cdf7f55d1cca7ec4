//! What makes a text no well-formed XML.

use super::Excerpt;
use lancer_words::Lang;
use lancer_words::xml::{Report, syntax as words};

/// Writes the enum of problems with each one's code and words.
macro_rules! syntax_problems {
    ($($(#[$doc:meta])* $variant:ident $({ $($field:ident: $type:ty),* })? = $code:literal, $words:ident;)*) => {
        /// Why a text is no well-formed XML, or none that is read here.
        #[derive(Clone, Debug, PartialEq, Eq)]
        pub enum SyntaxProblem {$(
            $(#[$doc])*
            #[allow(missing_docs, reason = "the fields are what the problem's name says")]
            $variant $({ $($field: $type),* })?,
        )*}

        impl SyntaxProblem {
            pub(super) fn told(&self, lang: Lang) -> (&'static str, Report) {
                match self {
                    $(SyntaxProblem::$variant $({ $($field),* })? => ($code, words::$words(lang $($(, $field)*)?)),)*
                }
            }
        }
    };
}

syntax_problems! {
    /// The file has no bytes.
    EmptyFile = "xml::empty-file", empty_file;
    /// More than 4 GiB.
    TooLarge = "xml::too-large", too_large;
    /// An encoding that is not read.
    UnknownEncoding { label: Excerpt } = "xml::unknown-encoding", unknown_encoding;
    /// A byte that the encoding does not have.
    BadBytes { byte: Byte, encoding: &'static str } = "xml::bad-bytes", bad_bytes;
    /// The mark and the declaration disagree.
    EncodingContradicted { declared: Excerpt, actual: &'static str } = "xml::encoding-contradicted", encoding_contradicted;
    /// UTF-16 without its mark.
    NoByteOrderMark = "xml::no-byte-order-mark", no_byte_order_mark;
    /// A character that no document may hold.
    IllegalCharacter { code: CodePoint } = "xml::illegal-character", illegal_character;
    /// A malformed XML declaration.
    BadDeclaration = "xml::bad-declaration", bad_declaration;
    /// Another XML than 1.x.
    UnknownXmlVersion { version: Excerpt } = "xml::unknown-xml-version", unknown_xml_version;
    /// An XML declaration that is not at the very beginning.
    LateDeclaration = "xml::late-declaration", late_declaration;
    /// A DOCTYPE with declarations of its own: entities could grow without bound.
    InternalSubset = "xml::internal-subset", internal_subset;
    /// A malformed DOCTYPE.
    BadDoctype = "xml::bad-doctype", bad_doctype;
    /// A second DOCTYPE, or one after the root's beginning.
    MisplacedDoctype = "xml::misplaced-doctype", misplaced_doctype;
    /// `<!` and nothing known.
    UnknownMarkup = "xml::unknown-markup", unknown_markup;
    /// `<` and no name.
    TagWithoutName = "xml::tag-without-name", tag_without_name;
    /// A tag without `>`.
    TagNotEnded { name: Excerpt } = "xml::tag-not-ended", tag_not_ended;
    /// The file ends within a tag.
    EndsWithinTag { name: Excerpt } = "xml::ends-within-tag", ends_within_tag;
    /// A character that has no business in a tag.
    StrayInTag { found: char, name: Excerpt } = "xml::stray-in-tag", stray_in_tag;
    /// No white space between two attributes.
    AttributesTouch { name: Excerpt } = "xml::attributes-touch", attributes_touch;
    /// No `=`.
    AttributeWithoutValue { name: Excerpt } = "xml::attribute-without-value", attribute_without_value;
    /// No quote after `=`.
    ValueWithoutQuotes { name: Excerpt, value: Excerpt } = "xml::value-without-quotes", value_without_quotes;
    /// `<` or the end of the file before the closing quote.
    ValueNotEnded { name: Excerpt, quote: char } = "xml::value-not-ended", value_not_ended;
    /// An attribute twice in one tag.
    DuplicateAttribute { name: Excerpt, element: Excerpt, line: usize } = "xml::duplicate-attribute", duplicate_attribute;
    /// An end tag of another element than the open one.
    MismatchedEnd { found: Excerpt, open: Excerpt, line: usize } = "xml::mismatched-end", mismatched_end;
    /// An end tag of an element further out than the open one.
    OuterEnd { found: Excerpt, open: Excerpt, line: usize } = "xml::mismatched-end", outer_end;
    /// An end tag with nothing open.
    EndWithoutStart { name: Excerpt } = "xml::end-without-start", end_without_start;
    /// An end tag that holds more than a name.
    BadEndTag = "xml::bad-end-tag", bad_end_tag;
    /// An element open at the end of the file.
    ElementNotClosed { name: Excerpt, line: usize } = "xml::element-not-closed", element_not_closed;
    /// Text before or after the root.
    TextOutside = "xml::text-outside", text_outside;
    /// Text at the beginning of the file.
    NotXml = "xml::not-xml", not_xml;
    /// A second root element.
    SecondRoot { name: Excerpt } = "xml::second-root", second_root;
    /// No root element.
    NoRoot = "xml::no-root", no_root;
    /// A comment without `-->`.
    CommentNotEnded = "xml::comment-not-ended", comment_not_ended;
    /// `--` within a comment.
    DoubleDash = "xml::double-dash", double_dash;
    /// A CDATA section without `]]>`.
    CdataNotEnded = "xml::cdata-not-ended", cdata_not_ended;
    /// `]]>` outside a CDATA section.
    StrayCdataEnd = "xml::stray-cdata-end", stray_cdata_end;
    /// A malformed processing instruction.
    BadInstruction = "xml::bad-instruction", bad_instruction;
    /// `&` and no reference.
    BareAmpersand = "xml::bare-ampersand", bare_ampersand;
    /// An entity that is not predefined.
    UnknownEntity { name: Excerpt } = "xml::unknown-entity", unknown_entity;
    /// A number that names no legal character.
    BadCharacterReference { reference: Excerpt } = "xml::bad-character-reference", bad_character_reference;
    /// Deeper than any legal document.
    TooDeep { limit: usize } = "xml::too-deep", too_deep;
    /// A name that is none.
    BadName = "xml::bad-name", bad_name;
}

/// A byte, shown in hexadecimal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Byte(pub u8);

impl std::fmt::Display for Byte {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "0x{:02X}", self.0)
    }
}

/// A character, shown as Unicode's number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CodePoint(pub char);

impl std::fmt::Display for CodePoint {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "U+{:04X}", u32::from(self.0))
    }
}
