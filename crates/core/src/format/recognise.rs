//! Tells from the first bytes whether data are a certificate, and in which encoding.

use super::FORMAT;
use super::cbor::Items;
use super::json::{self, JsonError};
use malachite::Integer;
use std::borrow::Cow;

/// An encoding of a certificate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// For people.
    Json,
    /// The certificate itself.
    Cbor,
}

/// The encoding of the certificate that begins like this; `None` if the bytes are something else.
/// The first 64 bytes are enough.
///
/// CBOR begins with the head of an array and the format's name, a byte that no JSON text begins
/// with. JSON begins with `{`, and its first member is the format.
pub fn recognise(bytes: &[u8]) -> Option<Encoding> {
    let mut items = Items::new(bytes);
    if items.array().is_ok() && items.text().is_ok_and(|text| text == FORMAT) {
        return Some(Encoding::Cbor);
    }
    let mut begin = bytes
        .iter()
        .take(BEGIN)
        .filter(|b| !b.is_ascii_whitespace());
    let expected = format!("{{\"format\":\"{FORMAT}\"");
    let is_json = expected.bytes().all(|byte| begin.next() == Some(&byte));
    is_json.then_some(Encoding::Json)
}

/// The version of a certificate in CBOR, if it begins as one of any version does.
pub fn version(cbor: &[u8]) -> Option<Integer> {
    let mut items = Items::new(cbor);
    items.array().ok()?;
    let is_format = items.text().ok()? == FORMAT;
    is_format.then(|| items.integer().ok()).flatten()
}

/// The kind of a certificate or claim file in CBOR: its third item, if that is a text.
pub fn kind(cbor: &[u8]) -> Option<&str> {
    let mut items = Items::new(cbor);
    items.array().ok()?;
    items.text().ok()?;
    items.integer().ok()?;
    items.text().ok()
}

/// Bytes that are searched for the format of JSON.
const BEGIN: usize = 1024;

/// The CBOR of a certificate in either encoding. Bytes that begin with `{` or a space are taken
/// as JSON; all others are left as they are.
///
/// # Errors
/// If JSON is not canonical.
pub fn to_cbor(bytes: &[u8]) -> Result<Cow<'_, [u8]>, JsonError> {
    match bytes.first() {
        Some(b'{' | b' ' | b'\t' | b'\n' | b'\r') => Ok(Cow::Owned(json::to_cbor(bytes)?)),
        _ => Ok(Cow::Borrowed(bytes)),
    }
}
