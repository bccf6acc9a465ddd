//! From bytes to passive data: size, header, shape, and the one byte string.
//!
//! Nothing here knows what the data mean.

use super::{Limits, Refusal};
use crate::certificate::{Certificate, FORMAT, VERSION, to_bytes};
use serde::Deserialize;

/// The certificate that these bytes are, and that is these bytes.
pub(super) fn read(bytes: &[u8], limits: &Limits) -> Result<Certificate, Refusal> {
    check_size(bytes, limits)?;
    check_header(bytes)?;
    let certificate = serde_json::from_slice(bytes).map_err(json)?;
    check_canonical(bytes, &certificate)?;
    Ok(certificate)
}

/// |bytes| <= limit.
fn check_size(bytes: &[u8], limits: &Limits) -> Result<(), Refusal> {
    let found = bytes.len() as u64;
    match found <= limits.bytes {
        true => Ok(()),
        false => Err(Refusal::TooManyBytes {
            found,
            limit: limits.bytes,
        }),
    }
}

/// `format` and `version` as known. They are looked at before the rest, whose
/// shape another version may change.
fn check_header(bytes: &[u8]) -> Result<(), Refusal> {
    #[derive(Deserialize)]
    struct Header {
        format: String,
        version: u64,
    }
    let header: Header = serde_json::from_slice(bytes).map_err(json)?;
    if header.format != FORMAT {
        return Err(Refusal::Format {
            found: excerpt(&header.format),
        });
    }
    if header.version != VERSION {
        return Err(Refusal::Version {
            found: header.version,
        });
    }
    Ok(())
}

/// write(parse(bytes)) = bytes. So an object has one byte string and one hash,
/// and whatever a JSON parser forgives (spaces, escapes, other notations of a
/// number or of a structure) is not forgiven here.
fn check_canonical(bytes: &[u8], certificate: &Certificate) -> Result<(), Refusal> {
    let again = to_bytes(certificate);
    if again == bytes {
        return Ok(());
    }
    let offset = again.iter().zip(bytes).take_while(|(a, b)| a == b).count();
    Err(Refusal::Canonical { offset })
}

fn json(error: serde_json::Error) -> Refusal {
    Refusal::Json {
        message: excerpt(&error.to_string()),
    }
}

/// The beginning of a text from the file, so that no message is as long as it.
pub(super) fn excerpt(text: &str) -> String {
    const LENGTH: usize = 200;
    match text.char_indices().nth(LENGTH) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
