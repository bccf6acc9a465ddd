//! Prints a certificate's CBOR as JSON: the same items, with the members of records named.
//!
//! The certificate, its claim and witness, and the containers in these have their elements on
//! lines of their own; deeper values stay on their line. An empty array is `[]`, there are no
//! spaces, and the text ends with a line feed. Only the names depend on the grammar; whether the
//! items are a certificate is decided by others.

use super::cbor::{CborError, Item, Items};
use super::{FAMILY, KIND, kind};
use std::io::{self, Write};

/// The members of a record, in order, with the shapes of their values.
pub type Members = &'static [(&'static str, Shape)];

/// Decides whether an array is printed as a record.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// It is not.
    Plain,
    /// It is, if it is an array.
    Record(Members),
    /// Its elements are such records.
    Each(Members),
    /// A domain: a text, or its name and a polytope or a rank.
    Domain,
}

const ROOT: Members = &[
    ("low", Shape::Plain),
    ("high", Shape::Plain),
    ("denominator", Shape::Plain),
];
const FIELD: Members = &[("polynomial", Shape::Plain), ("root", Shape::Record(ROOT))];
const POLYTOPE: Members = &[
    ("denominator", Shape::Plain),
    ("vertices", Shape::Plain),
    ("faces", Shape::Plain),
];
const CLAIM: Members = &[
    ("dimension", Shape::Plain),
    ("field", Shape::Record(FIELD)),
    ("gram", Shape::Plain),
    ("domain", Shape::Domain),
    ("statements", Shape::Plain),
];
const WITNESS: Members = &[
    ("denominator", Shape::Plain),
    ("vertices", Shape::Plain),
    ("boundary", Shape::Plain),
    ("simplices", Shape::Plain),
];
const PARAMETER: Members = &[
    ("name", Shape::Plain),
    ("low", Shape::Plain),
    ("high", Shape::Plain),
];
const FAMILY_CLAIM: Members = &[
    ("dimension", Shape::Plain),
    ("field", Shape::Record(FIELD)),
    ("parameters", Shape::Each(PARAMETER)),
    ("gram", Shape::Plain),
    ("domain", Shape::Domain),
    ("statements", Shape::Plain),
];
const FAMILY_WITNESS: Members = &[
    ("denominator", Shape::Plain),
    ("vertices", Shape::Plain),
    ("boundary", Shape::Plain),
    ("tree", Shape::Plain),
    ("simplices", Shape::Plain),
];
/// The members of a certificate.
pub const CERTIFICATE: Members = &[
    ("format", Shape::Plain),
    ("version", Shape::Plain),
    ("kind", Shape::Plain),
    ("claim", Shape::Record(CLAIM)),
    ("witness", Shape::Record(WITNESS)),
];
/// The members of a claim file.
pub const CLAIM_FILE: Members = &[
    ("format", Shape::Plain),
    ("version", Shape::Plain),
    ("kind", Shape::Plain),
    ("claim", Shape::Record(CLAIM)),
];
const FAMILY_CERTIFICATE: Members = &[
    ("format", Shape::Plain),
    ("version", Shape::Plain),
    ("kind", Shape::Plain),
    ("claim", Shape::Record(FAMILY_CLAIM)),
    ("witness", Shape::Record(FAMILY_WITNESS)),
];
const FAMILY_CLAIM_FILE: Members = &[
    ("format", Shape::Plain),
    ("version", Shape::Plain),
    ("kind", Shape::Plain),
    ("claim", Shape::Record(FAMILY_CLAIM)),
];
const TILE: Members = &[
    ("denominator", Shape::Plain),
    ("vertices", Shape::Plain),
    ("classes", Shape::Plain),
];
const PATCHES_CLAIM: Members = &[
    ("field", Shape::Record(FIELD)),
    ("gram", Shape::Plain),
    ("rank", Shape::Plain),
    ("tiles", Shape::Each(TILE)),
    ("statements", Shape::Plain),
];
const PATCH: Members = &[
    ("denominator", Shape::Plain),
    ("offsets", Shape::Plain),
    ("vertices", Shape::Plain),
    ("pyramids", Shape::Plain),
    ("simplices", Shape::Plain),
];
/// The members of a certificate of the kind `patches`.
const PATCHES: Members = &[
    ("format", Shape::Plain),
    ("version", Shape::Plain),
    ("kind", Shape::Plain),
    ("claim", Shape::Record(PATCHES_CLAIM)),
    ("witness", Shape::Each(PATCH)),
];
/// The members of its claim file.
const PATCHES_CLAIM_FILE: Members = &[
    ("format", Shape::Plain),
    ("version", Shape::Plain),
    ("kind", Shape::Plain),
    ("claim", Shape::Record(PATCHES_CLAIM)),
];
/// All records. The outermost ones of all kinds have the same names.
pub const RECORDS: [Members; 15] = [
    CERTIFICATE,
    CLAIM_FILE,
    CLAIM,
    FAMILY_CLAIM,
    FAMILY_WITNESS,
    PARAMETER,
    FIELD,
    ROOT,
    POLYTOPE,
    WITNESS,
    PATCHES,
    PATCHES_CLAIM_FILE,
    PATCHES_CLAIM,
    TILE,
    PATCH,
];

/// Containers that begin at a depth below this have their elements on lines of their own.
const DEPTH_OF_LINES: usize = 3;
/// No certificate nests deeper; the deepest are the trees of families.
pub(super) const DEEPEST: usize = 80;

/// The members of a certificate of some kind, or of a claim file; `None` for an unknown kind.
pub fn members_of(kind: &str, is_claim_file: bool) -> Option<Members> {
    match (kind, is_claim_file) {
        (KIND, false) => Some(CERTIFICATE),
        (KIND, true) => Some(CLAIM_FILE),
        (FAMILY, false) => Some(FAMILY_CERTIFICATE),
        (FAMILY, true) => Some(FAMILY_CLAIM_FILE),
        (super::patches::KIND, false) => Some(PATCHES),
        (super::patches::KIND, true) => Some(PATCHES_CLAIM_FILE),
        _ => None,
    }
}

/// Why there is no JSON.
#[derive(Debug)]
pub enum PrintError {
    /// The bytes are not CBOR, or not of the certificate's shape.
    Cbor(CborError),
    /// The output cannot be written.
    Write(io::Error),
}

impl From<CborError> for PrintError {
    fn from(error: CborError) -> Self {
        PrintError::Cbor(error)
    }
}

impl From<io::Error> for PrintError {
    fn from(error: io::Error) -> Self {
        PrintError::Write(error)
    }
}

impl std::fmt::Display for PrintError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            PrintError::Cbor(error) => write!(f, "{error}"),
            PrintError::Write(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for PrintError {}

/// The JSON of a certificate in CBOR.
///
/// # Errors
/// If the bytes are not CBOR of a certificate's outer shape.
pub fn to_json(cbor: &[u8]) -> Result<Vec<u8>, CborError> {
    collected(cbor, false)
}

/// The JSON of a claim file in CBOR.
///
/// # Errors
/// If the bytes are not CBOR of a claim file's outer shape.
pub fn claim_to_json(cbor: &[u8]) -> Result<Vec<u8>, CborError> {
    collected(cbor, true)
}

/// Bytes of another kind are printed as a tiling, and fail where they are none.
fn collected(cbor: &[u8], is_claim_file: bool) -> Result<Vec<u8>, CborError> {
    let known = kind(cbor).and_then(|kind| members_of(kind, is_claim_file));
    let members = known.unwrap_or(if is_claim_file {
        CLAIM_FILE
    } else {
        CERTIFICATE
    });
    let mut bytes = Vec::new();
    match print(cbor, members, &mut bytes) {
        Err(PrintError::Cbor(error)) => Err(error),
        // A Vec takes every byte.
        Ok(()) | Err(PrintError::Write(_)) => Ok(bytes),
    }
}

/// Prints CBOR with these members to `out`.
///
/// # Errors
/// [`PrintError`].
pub fn print(cbor: &[u8], members: Members, out: &mut impl Write) -> Result<(), PrintError> {
    let mut printer = Printer {
        items: Items::new(cbor),
        out,
    };
    printer.item(Shape::Record(members), 0)?;
    printer.items.end()?;
    Ok(printer.out.write_all(b"\n")?)
}

struct Printer<'b, 'o, W> {
    items: Items<'b>,
    out: &'o mut W,
}

impl<W: Write> Printer<'_, '_, W> {
    fn item(&mut self, shape: Shape, depth: usize) -> Result<(), PrintError> {
        match self.items.next_item()? {
            Item::Small(value) if value.unsigned_abs() >> 53 == 0 => write!(self.out, "{value}")?,
            Item::Small(value) => write!(self.out, "\"{value}\"")?,
            Item::Big(value) => write!(self.out, "\"{}\"", value)?,
            Item::Text(text) => self.text(text)?,
            Item::Array(length) => self.container(shape, length, depth)?,
        }
        Ok(())
    }

    fn text(&mut self, text: &str) -> io::Result<()> {
        let escaped = text.replace('\\', "\\\\").replace('"', "\\\"");
        write!(self.out, "\"{escaped}\"")
    }

    fn container(&mut self, shape: Shape, length: usize, depth: usize) -> Result<(), PrintError> {
        if depth > DEEPEST {
            return Err(self.items.error("the arrays are nested too deeply").into());
        }
        let members = match shape {
            Shape::Record(members) if members.len() != length => {
                return Err(self.items.error("the record has a wrong length").into());
            }
            Shape::Record(members) => Some(members),
            _ => None,
        };
        let [open, close] = match members {
            Some(_) => [b"{", b"}"],
            None => [b"[", b"]"],
        };
        self.out.write_all(open)?;
        for index in 0..length {
            if index > 0 {
                self.out.write_all(b",")?;
            }
            self.line(depth)?;
            let inner = match (members, shape) {
                (Some(members), _) => {
                    write!(self.out, "\"{}\":", members[index].0)?;
                    members[index].1
                }
                (None, Shape::Domain) if index == 1 => Shape::Record(POLYTOPE),
                (None, Shape::Each(members)) => Shape::Record(members),
                _ => Shape::Plain,
            };
            self.item(inner, depth + 1)?;
        }
        if length > 0 {
            self.line(depth)?;
        }
        Ok(self.out.write_all(close)?)
    }

    fn line(&mut self, depth: usize) -> io::Result<()> {
        if depth < DEPTH_OF_LINES {
            self.out.write_all(b"\n")
        } else {
            Ok(())
        }
    }
}
