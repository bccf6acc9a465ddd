//! The text of a file: from a path, standard input, or gzip; and comment lines.
//!
//! Every reader of text files starts here, so that limits and messages are the same.

use super::ImportError;
use flate2::read::MultiGzDecoder;
use std::borrow::Cow;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// No input file may be longer, decompressed: 256 MiB.
pub const BYTE_LIMIT: u64 = 1 << 28;

/// A compressed file may grow by this factor, and by [`GROWTH_ALLOWANCE`] beyond. The data that readers
/// build take up to thirty times the memory of the text. So a small file must not become a large text.
/// Meshes and tilings grow by factors of 3 to 30.
pub const GROWTH_LIMIT: u64 = 100;
/// See [`GROWTH_LIMIT`]: 1 MiB.
pub const GROWTH_ALLOWANCE: u64 = 1 << 20;

/// Reads a whole text file, or standard input for the path `-`; a file whose name ends
/// in `.gz` is decompressed.
///
/// # Errors
/// The file cannot be read or is no gzip file, is longer than [`BYTE_LIMIT`], or is not
/// UTF-8.
pub fn read_text(path: &Path) -> Result<String, ImportError> {
    String::from_utf8(read_bytes(path, BYTE_LIMIT)?).map_err(|error| ImportError::NotText {
        offset: error.utf8_error().valid_up_to(),
    })
}

/// The bytes of a file, of standard input for `-`, decompressed for `.gz`.
///
/// # Errors
/// It cannot be read, is no gzip file, or is longer than `limit`.
pub fn read_bytes(path: &Path, limit: u64) -> Result<Vec<u8>, ImportError> {
    let too_long = || ImportError::TooLong { limit };
    if path == Path::new("-") {
        return limited(io::stdin().lock(), limit, 0)?.ok_or_else(too_long);
    }
    let file = File::open(path).map_err(ImportError::Unreadable)?;
    // The system knows how long a file is; of a pipe or a device it says 0.
    let length = file.metadata().map_or(0, |metadata| metadata.len());
    if !is_gzip(path) {
        return limited(file, limit, length)?.ok_or_else(too_long);
    }
    let growth = GROWTH_ALLOWANCE.saturating_add(length.saturating_mul(GROWTH_LIMIT));
    let unpacked = MultiGzDecoder::new(io::BufReader::new(file));
    limited(unpacked, limit.min(growth), 0)?.ok_or_else(|| {
        if growth < limit {
            ImportError::GrowsTooMuch { length, growth }
        } else {
            too_long()
        }
    })
}

/// The bytes of a reader, or `None` if there are more than `limit`. Reserves space for
/// `expected` bytes, if they are allowed.
fn limited(reader: impl Read, limit: u64, expected: u64) -> Result<Option<Vec<u8>>, ImportError> {
    if expected > limit {
        return Ok(None);
    }
    let mut bytes = Vec::new();
    // A byte more, so that the end is seen without growing.
    let capacity = usize::try_from(expected).map_err(|_| too_large())?;
    bytes
        .try_reserve(capacity.saturating_add(1))
        .map_err(|_| too_large())?;
    reader
        .take(limit.saturating_add(1))
        .read_to_end(&mut bytes)
        .map_err(ImportError::Unreadable)?;
    Ok(Some(bytes).filter(|bytes| bytes.len() as u64 <= limit))
}

fn too_large() -> ImportError {
    ImportError::Unreadable(io::ErrorKind::OutOfMemory.into())
}

/// Whether the name ends in `.gz`.
pub fn is_gzip(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("gz"))
}

/// The path without `.gz`: its extension is that of the content.
pub fn uncompressed_name(path: &Path) -> Cow<'_, Path> {
    if is_gzip(path) {
        Cow::Owned(path.with_extension(""))
    } else {
        Cow::Borrowed(path)
    }
}

/// JSON in which lines that begin with `//`, after blanks, are emptied. A string of
/// JSON holds no line feed, so that no such line is part of one; the others keep their
/// numbers.
pub fn without_comments(text: &str) -> Cow<'_, str> {
    let is_comment = |line: &str| line.trim_start().starts_with("//");
    if !text.lines().any(is_comment) {
        return Cow::Borrowed(text);
    }
    let kept = |line| if is_comment(line) { "" } else { line };
    let lines: Vec<&str> = text.split('\n').map(kept).collect();
    Cow::Owned(lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comment_lines_are_emptied_and_nothing_else() {
        let text = "// a\n{ \"b\": \"// c\",\r\n  // d\r\n  \"e\": 1 }\n//";
        let kept = "\n{ \"b\": \"// c\",\r\n\n  \"e\": 1 }\n";
        assert_eq!(without_comments(text), kept);
        assert!(matches!(without_comments("{}\n"), Cow::Borrowed(_)));
    }

    #[test]
    fn names_without_gz() {
        let name = |path: &str| uncompressed_name(Path::new(path)).display().to_string();
        assert_eq!(name("d.gz/a.cif.gz"), "d.gz/a.cif");
        assert_eq!(name("a.cif"), "a.cif");
        assert_eq!(name("-"), "-");
    }
}
