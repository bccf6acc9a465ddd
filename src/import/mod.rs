//! Files that people bring, read into tilings and point sets.
//!
//! A reader checks form (what is there, of the right length, in range); whether
//! the tiling is one is the checker's business. Every error names the place.

mod certificate;
mod document;
mod domain;
mod error;
mod frame;
mod native;
mod numbers;

pub use certificate::tiling_of_certificate;
pub use error::ImportError;
pub use native::{Content, NativeFile, read_native};

use std::fs::File;
use std::io::Read;
use std::path::Path;

/// No input file may be longer: 256 MiB.
pub const BYTE_LIMIT: u64 = 1 << 28;

/// Reads a whole text file, or standard input for the path `-`.
pub fn read_text(path: &Path) -> Result<String, ImportError> {
    let mut bytes = Vec::new();
    let limited =
        |reader: &mut dyn Read, bytes: &mut Vec<u8>| reader.take(BYTE_LIMIT + 1).read_to_end(bytes);
    let read = if path == Path::new("-") {
        limited(&mut std::io::stdin().lock(), &mut bytes)
    } else {
        File::open(path).and_then(|mut file| limited(&mut file, &mut bytes))
    };
    read.map_err(ImportError::Unreadable)?;
    if bytes.len() as u64 > BYTE_LIMIT {
        return Err(ImportError::TooLong { limit: BYTE_LIMIT });
    }
    String::from_utf8(bytes).map_err(|error| ImportError::NotText {
        offset: error.utf8_error().valid_up_to(),
    })
}
