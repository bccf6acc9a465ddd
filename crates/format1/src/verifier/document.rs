//! From bytes to data: size, header, shape, and the one byte string of each encoding.
//!
//! Nothing here knows what the data mean. A certificate in JSON is in memory, with its
//! tables transcribed; one in CBOR is gone over once, to see that it is one, and its
//! tables stay where they are.

use super::cbor::{HELD, Lists, check_held};
use super::source::{Bytes, Source, Sum};
use super::table::Table;
use super::{Limits, Refusal};
use crate::certificate::{self, Claim, FORMAT, Number, VERSION, cbor};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::io::{self, Write};

/// A certificate, its tables as rows in CBOR.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Document<'s> {
    format: String,
    version: u64,
    pub(super) claim: Claim,
    #[serde(bound(deserialize = ""))]
    pub(super) witness: Witness<'s>,
    /// Of the bytes.
    #[serde(skip)]
    pub(super) sha256: Sum,
}

/// The tables; what they mean says [`certificate::Witness`].
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, bound(deserialize = ""))]
pub(super) struct Witness<'s> {
    pub(super) vertices: Table<'s, Vec<Number>>,
    pub(super) simplices: Table<'s, Lists>,
    pub(super) mates: Table<'s, Lists>,
}

/// The certificate that these bytes are, in JSON, and that is these bytes.
pub(super) fn read_json(bytes: &[u8], limits: &Limits) -> Result<Document<'static>, Refusal> {
    check_size(bytes.len() as u64, limits)?;
    check_header(bytes)?;
    let mut document: Document = serde_json::from_slice(bytes).map_err(json)?;
    check_canonical(bytes, &document)?;
    document.sha256 = Sha256::digest(bytes).into();
    Ok(document)
}

/// |bytes| <= limit.
fn check_size(found: u64, limits: &Limits) -> Result<(), Refusal> {
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
    check_known(&header.format, header.version)
}

fn check_known(format: &str, version: u64) -> Result<(), Refusal> {
    if format != FORMAT {
        return Err(Refusal::Format {
            found: excerpt(format),
        });
    }
    match version {
        VERSION => Ok(()),
        found => Err(Refusal::Version { found }),
    }
}

/// write(parse(bytes)) = bytes. So an object has one byte string and one hash,
/// and whatever a JSON parser forgives (spaces, escapes, other notations of a
/// number or of a structure) is not forgiven here.
fn check_canonical(bytes: &[u8], document: &Document) -> Result<(), Refusal> {
    let mut again = Compared {
        bytes,
        equal: 0,
        differs: false,
    };
    let is_whole = certificate::to_writer(&mut again, document).is_ok();
    match is_whole && again.equal == bytes.len() {
        true => Ok(()),
        // Equal so far, and then a row that is not held.
        false if !is_whole && !again.differs => check_held(HELD + 1),
        false => Err(Refusal::Canonical {
            offset: again.equal,
        }),
    }
}

/// Takes what is equal to the bytes, and fails at the first byte that is not.
struct Compared<'b> {
    bytes: &'b [u8],
    equal: usize,
    differs: bool,
}

impl Write for Compared<'_> {
    fn write(&mut self, written: &[u8]) -> io::Result<usize> {
        let pairs = written.iter().zip(&self.bytes[self.equal..]);
        let equal = pairs.take_while(|(a, b)| a == b).count();
        self.equal += equal;
        self.differs |= equal < written.len();
        match equal == written.len() {
            true => Ok(equal),
            false => Err(io::ErrorKind::InvalidData.into()),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
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

/// No certificate is nested more deeply: a coefficient of a coordinate of a vertex of a
/// polytope of a domain.
const DEPTH: u8 = 16;

/// What has been read of a certificate in CBOR.
#[derive(Default)]
struct Parts<'s> {
    claim: Option<Part>,
    format: Option<String>,
    version: Option<u64>,
    witness: Option<Witness<'s>>,
    unknown: Option<String>,
}

/// The bytes from one offset to another, and their digest.
struct Part {
    from: u64,
    to: u64,
    sum: Option<Sum>,
}

/// The certificate that these bytes are, in CBOR.
pub(super) fn read_cbor<'s>(
    source: &'s Source<'s>,
    limits: &Limits,
) -> Result<Document<'s>, Refusal> {
    check_size(source.length(), limits)?;
    let mut bytes = Bytes::first(source);
    let mut parts = Parts::default();
    let members = bytes.map()?;
    bytes.members(members, |bytes, key| parts.read(bytes, source, key))?;
    if bytes.next()?.is_some() {
        return bytes.wrong("bytes behind the end");
    }
    let (Some(format), Some(version)) = (parts.format, parts.version) else {
        return bytes.wrong("no format, or no version");
    };
    check_known(&format, version)?;
    if let Some(key) = parts.unknown {
        return bytes.wrong(&format!("an unknown member: {key}"));
    }
    let (Some(claim), Some(witness)) = (parts.claim, parts.witness) else {
        return bytes.wrong("no claim, or no witness");
    };
    Ok(Document {
        claim: read_claim(source, &claim)?,
        format,
        version,
        witness,
        sha256: bytes.sum().unwrap_or_default(),
    })
}

impl<'s> Parts<'s> {
    /// The witness is behind format and version, which may be others.
    fn read(&mut self, bytes: &mut Bytes, whole: &'s Source, key: &str) -> Result<(), Refusal> {
        match key {
            "claim" => self.claim = Some(part(bytes)?),
            "format" => self.format = Some(bytes.text()?),
            "version" => self.version = Some(bytes.natural()?),
            "witness" if self.is_known() => self.witness = Some(witness(bytes, whole)?),
            _ => {
                self.unknown.get_or_insert_with(|| excerpt(key));
                bytes.skip(DEPTH)?;
            }
        }
        Ok(())
    }

    fn is_known(&self) -> bool {
        self.format.as_deref() == Some(FORMAT) && self.version == Some(VERSION)
    }
}

fn part(bytes: &mut Bytes) -> Result<Part, Refusal> {
    bytes.mark();
    let from = bytes.offset();
    bytes.skip(DEPTH)?;
    let to = bytes.offset();
    let sum = bytes.mark();
    Ok(Part { from, to, sum })
}

fn witness<'s>(bytes: &mut Bytes, whole: &'s Source) -> Result<Witness<'s>, Refusal> {
    let (mut vertices, mut simplices, mut mates) = (None, None, None);
    let members = bytes.map()?;
    bytes.members(members, |bytes, key| {
        match key {
            "vertices" => vertices = Some(Table::first(bytes, whole, key)?),
            "simplices" => simplices = Some(Table::first(bytes, whole, key)?),
            "mates" => mates = Some(Table::first(bytes, whole, key)?),
            _ => return bytes.wrong(&format!("an unknown member of the witness: {key}")),
        }
        Ok(())
    })?;
    match (vertices, simplices, mates) {
        (Some(vertices), Some(simplices), Some(mates)) => Ok(Witness {
            vertices,
            simplices,
            mates,
        }),
        _ => bytes.wrong("a member of the witness is missing"),
    }
}

/// The claim as it is known, which written again is the same.
fn read_claim(source: &Source, part: &Part) -> Result<Claim, Refusal> {
    check_held(part.to - part.from)?;
    let of_claim = source.part(part.from, part.to);
    let mut bytes = Bytes::again(&of_claim);
    let value = bytes.value(DEPTH)?;
    bytes.check_sum(&part.sum)?;
    let claim = Claim::deserialize(&value).map_err(|error| Refusal::Cbor {
        offset: part.from,
        message: excerpt(&format!("claim: {error}")),
    })?;
    match difference(&value, &claim) {
        None => Ok(claim),
        Some(at) => Err(Refusal::Canonical {
            offset: part.from as usize + at,
        }),
    }
}

/// Where the claim, written again, is first another one.
fn difference(value: &Value, claim: &Claim) -> Option<usize> {
    let (mut old, mut new) = (Vec::new(), Vec::new());
    let is_written = cbor::value(&mut old, value).is_ok() && cbor::claim(&mut new, claim).is_ok();
    let equal = old.iter().zip(&new).take_while(|(a, b)| a == b).count();
    (!is_written || old != new).then_some(equal)
}

impl Document<'_> {
    /// The same certificate in JSON.
    pub(super) fn write_json(&self, out: &mut impl Write) -> io::Result<()> {
        Ok(certificate::to_writer(out, self)?)
    }

    /// The same certificate in CBOR.
    pub(super) fn write_cbor(&self, out: &mut impl Write) -> io::Result<()> {
        let Witness {
            vertices,
            simplices,
            mates,
        } = &self.witness;
        let tables = cbor::Tables {
            mates: &mut |out| mates.copy(out),
            vertices: &mut |out| vertices.copy(out),
            simplices: &mut |out| simplices.copy(out),
        };
        cbor::certificate(out, &self.claim, tables)
    }
}
