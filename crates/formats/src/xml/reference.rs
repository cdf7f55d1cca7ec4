//! Characters of XML: which are legal, which make names, and the references that stand for them.

use std::borrow::Cow;

/// Whether a document may hold the character (XML 1.0, production 2).
pub(super) fn is_legal(character: char) -> bool {
    matches!(character, '\t' | '\n' | '\r' | ' '..='\u{FFFD}' | '\u{10000}'..)
}

/// XML's white space.
pub(super) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r')
}

/// Whether a name may begin with the character (production 4).
pub(super) fn begins_name(character: char) -> bool {
    matches!(character,
        ':' | '_' | 'A'..='Z' | 'a'..='z'
        | '\u{C0}'..='\u{D6}' | '\u{D8}'..='\u{F6}' | '\u{F8}'..='\u{2FF}' | '\u{370}'..='\u{37D}'
        | '\u{37F}'..='\u{1FFF}' | '\u{200C}'..='\u{200D}' | '\u{2070}'..='\u{218F}' | '\u{2C00}'..='\u{2FEF}'
        | '\u{3001}'..='\u{D7FF}' | '\u{F900}'..='\u{FDCF}' | '\u{FDF0}'..='\u{FFFD}' | '\u{10000}'..='\u{EFFFF}')
}

/// Whether a name may go on with the character (production 4a).
pub(super) fn continues_name(character: char) -> bool {
    begins_name(character)
        || matches!(character,
            '-' | '.' | '0'..='9' | '\u{B7}' | '\u{300}'..='\u{36F}' | '\u{203F}'..='\u{2040}')
}

/// The length in bytes of the name at the start of a text; 0 if there is none.
pub(super) fn name_length(text: &str) -> usize {
    // Almost all names are ASCII; the first other character leads to the full rule.
    let bytes = text.as_bytes();
    let plain = bytes
        .iter()
        .position(|byte| !(byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_' | b'.' | b':')))
        .unwrap_or(bytes.len());
    if bytes.first().is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'-' | b'.')) {
        return 0;
    }
    if bytes.get(plain).is_none_or(u8::is_ascii) {
        return plain;
    }
    let mut characters = text.char_indices();
    match characters.next() {
        Some((_, first)) if begins_name(first) => {}
        _ => return 0,
    }
    characters.find(|(_, character)| !continues_name(*character)).map_or(text.len(), |(at, _)| at)
}

/// The character that a reference such as `lt` or `#233` stands for, without `&` and `;`.
pub(super) fn resolve(name: &str) -> Option<char> {
    match name {
        "lt" => Some('<'),
        "gt" => Some('>'),
        "amp" => Some('&'),
        "quot" => Some('"'),
        "apos" => Some('\''),
        _ => {
            let digits = name.strip_prefix('#')?;
            let code = match digits.strip_prefix('x') {
                Some(hex) if hex.bytes().all(|byte| byte.is_ascii_hexdigit()) => u32::from_str_radix(hex, 16).ok()?,
                None if digits.bytes().all(|byte| byte.is_ascii_digit()) => digits.parse().ok()?,
                _ => return None,
            };
            char::from_u32(code).filter(|character| is_legal(*character))
        }
    }
}

/// What a raw text says: references resolved and line ends made `\n`; in a value every line end and tab is a blank.
pub(super) fn unescape(raw: &str, in_value: bool) -> Cow<'_, str> {
    let special = |byte: &u8| matches!(byte, b'&' | b'\r') || in_value && matches!(byte, b'\n' | b'\t');
    let Some(mut at) = raw.as_bytes().iter().position(special) else {
        return Cow::Borrowed(raw);
    };
    let mut text = String::with_capacity(raw.len());
    let mut copied = 0;
    loop {
        text.push_str(&raw[copied..at]);
        copied = at + 1;
        if raw.as_bytes()[at] == b'&' {
            let name = raw[copied..].split(';').next().unwrap_or_default();
            copied += name.len() + 1;
            text.extend(resolve(name));
        } else {
            if raw[at..].starts_with("\r\n") {
                copied += 1;
            }
            text.push(if in_value { ' ' } else { '\n' });
        }
        let rest = raw.get(copied..).unwrap_or_default();
        match rest.as_bytes().iter().position(&special) {
            Some(next) => at = copied + next,
            None => {
                text.push_str(rest);
                return Cow::Owned(text);
            }
        }
    }
}

/// A text as it may stand between double quotes.
///
/// A character that no XML document may hold becomes U+FFFD; names that were checked have none.
pub fn escape(text: &str) -> Cow<'_, str> {
    let plain =
        |character: char| is_legal(character) && !matches!(character, '<' | '>' | '&' | '"' | '\t' | '\n' | '\r');
    if text.chars().all(plain) {
        return Cow::Borrowed(text);
    }
    let mut escaped = String::with_capacity(text.len() + 16);
    for character in text.chars() {
        match character {
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '&' => escaped.push_str("&amp;"),
            '"' => escaped.push_str("&quot;"),
            '\t' => escaped.push_str("&#9;"),
            '\n' => escaped.push_str("&#10;"),
            '\r' => escaped.push_str("&#13;"),
            legal if is_legal(legal) => escaped.push(legal),
            _ => escaped.push('\u{FFFD}'),
        }
    }
    Cow::Owned(escaped)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn references_stand_for_characters() {
        assert_eq!(unescape("a&lt;&#233;&#xE9;&#x1F600;b", true), "a<éé😀b");
        assert_eq!(unescape("a\r\nb\tc\rd", true), "a b c d");
        assert_eq!(unescape("a\r\nb\tc&#13;", false), "a\nb\tc\r");
        for bad in ["", "#", "#x", "#0", "#xD800", "#x110000", "#+5", "#x+5", "eacute", "#99999999999999", "#xFFFE"] {
            assert_eq!(resolve(bad), None, "{bad}");
        }
    }

    #[test]
    fn names_follow_the_grammar() {
        for (text, length) in
            [("ka=", 2), ("look-at ", 7), ("été/", 5), ("a·b>", 4), ("1a", 0), ("-a", 0), (".a", 0), ("·a", 0), ("", 0)]
        {
            assert_eq!(name_length(text), length, "{text}");
        }
    }

    proptest! {
        #[test]
        fn what_is_escaped_reads_back(text in "[\\t\\n\\r -\u{D7FF}😀]*") {
            let escaped = escape(&text);
            prop_assert_eq!(unescape(&escaped, true).into_owned(), text);
        }
    }
}
