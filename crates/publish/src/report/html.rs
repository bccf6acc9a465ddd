//! Text into HTML: escaping, data in script elements, templates, and the hashes of the content
//! security policy. Names and descriptions come from files of strangers.

use serde_json::Value;
use sha2::{Digest, Sha256};
use std::fmt::Write;

/// `text` as character data or as a quoted attribute's value.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            // No other control character is allowed in a document.
            c if c.is_control() && !matches!(c, '\n' | '\t') => escaped.push('\u{fffd}'),
            c => escaped.push(c),
        }
    }
    escaped
}

/// A value as the content of `<script type="application/json">`: nothing in it can end the
/// element or begin a comment.
pub fn script_json(value: &Value) -> String {
    let mut safe = String::new();
    for c in value.to_string().chars() {
        match c {
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' => {
                // Writing to a string cannot fail.
                let _ = write!(safe, "\\u{:04x}", u32::from(c));
            }
            c => safe.push(c),
        }
    }
    safe
}

/// `template` with every `{{key}}` replaced, in one pass. So a value is never read as a template. An
/// unknown key stays.
pub fn fill(template: &str, values: &[(&str, &str)]) -> String {
    let mut text = String::with_capacity(template.len());
    let mut rest = template;
    while let Some(start) = rest.find("{{") {
        let (before, tail) = rest.split_at(start);
        text.push_str(before);
        let value = tail.find("}}").and_then(|end| {
            let (_, value) = values.iter().find(|(key, _)| *key == &tail[2..end])?;
            Some((end + 2, *value))
        });
        let (taken, value) = value.unwrap_or((2, "{{"));
        text.push_str(value);
        rest = &tail[taken..];
    }
    text + rest
}

/// The source expression of a content security policy for an inline script or style.
pub fn policy_hash(content: &str) -> String {
    format!("'sha256-{}'", base64(&Sha256::digest(content)))
}

/// Base 64 with padding (RFC 4648).
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let byte = |k: usize| u32::from(chunk.get(k).copied().unwrap_or(0));
        let word = byte(0) << 16 | byte(1) << 8 | byte(2);
        for k in 0..4 {
            let digit = DIGITS[(word >> (18 - 6 * k) & 63) as usize];
            text.push(if k <= chunk.len() {
                char::from(digit)
            } else {
                '='
            });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{base64, escape, fill, script_json};
    use serde_json::json;

    #[test]
    fn base64_as_in_rfc_4648() {
        let cases = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foobar", "Zm9vYmFy"),
        ];
        for (text, expected) in cases {
            assert_eq!(base64(text.as_bytes()), expected);
        }
    }

    #[test]
    fn values_are_not_templates() {
        let filled = fill("{{a}} {{b}} {{c}} {{", &[("a", "{{b}}"), ("b", "2")]);
        assert_eq!(filled, "{{b}} 2 {{c}} {{");
    }

    #[test]
    fn nothing_ends_an_element() {
        assert_eq!(escape("<a b='\"'>&"), "&lt;a b=&#39;&quot;&#39;&gt;&amp;");
        assert_eq!(escape("a\u{0}b"), "a\u{fffd}b");
        let text = script_json(&json!("</script><!--&\u{2028}"));
        assert_eq!(text, r#""\u003c/script\u003e\u003c!--\u0026\u2028""#);
    }
}
