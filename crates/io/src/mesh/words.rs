//! Words of a text as numbers, and as they are shown in messages.

/// The bytes after a byte order mark of UTF-8.
pub fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}

/// The double nearest to a decimal text, infinite beyond the range.
pub fn decimal_double(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    if !begins_as_number(word) {
        return None;
    }
    match text.parse() {
        Ok(value) => Some(value),
        Err(_) => text.replace(['d', 'D'], "e").parse().ok(),
    }
}

/// Whether a digit or a point comes first, after a sign or not. Such a word means the same to
/// Rust; apart from these Rust reads only `inf` and `nan`.
fn begins_as_number(word: &[u8]) -> bool {
    let unsigned = match word {
        [b'-' | b'+', rest @ ..] => rest,
        rest => rest,
    };
    matches!(unsigned, [b'0'..=b'9' | b'.', ..])
}

/// A decimal integer with an optional sign.
pub fn integer(word: &[u8]) -> Option<i64> {
    let (negative, digits) = match word {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    if digits.is_empty() || digits.len() > 18 {
        return None;
    }
    let mut value = 0i64;
    for digit in digits {
        if !digit.is_ascii_digit() {
            return None;
        }
        value = value * 10 + i64::from(digit - b'0');
    }
    Some(if negative { -value } else { value })
}

/// A word in quotes, not longer than a line.
pub fn shown(word: &[u8]) -> String {
    let text = String::from_utf8_lossy(&word[..word.len().min(40)]);
    let dots = if word.len() > 40 { "..." } else { "" };
    format!("\"{}{dots}\"", text.escape_debug())
}
