//! A ZIP archive that depends on nothing but what is in it: no clock, no umask, no order of a
//! directory. Written after PKWARE's APPNOTE 6.3, sections 4.3 to 4.5; without ZIP64, encryption,
//! comments and extra fields, so a crate for ZIP would bring more than is needed.

use crate::appendix::File;
use flate2::write::DeflateEncoder;
use flate2::{Compression, Crc};
use std::io::Write;

/// "Version needed": 2.0, for deflate.
const VERSION: u16 = 20;
/// Made by version 2.0 on Unix, so that the attributes are a mode.
const MADE_BY: u16 = (3 << 8) | VERSION;
/// Names are UTF-8.
const FLAGS: u16 = 1 << 11;
const DEFLATE: u16 = 8;
/// 1 January 1980, the first day that a ZIP archive can name; at midnight.
const DATE: u16 = (1 << 5) | 1;
const TIME: u16 = 0;
/// An ordinary file, `-rw-r--r--`.
const MODE: u32 = 0o100_644 << 16;

/// The bytes of the archive of these files, in this order.
///
/// # Errors
/// What does not fit without ZIP64: 2^16 files, or 4 GiB.
pub fn archive(files: &[File]) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let mut directory = Vec::new();
    for file in files {
        let too_large = || format!("{}: too large for the archive", file.path);
        let offset = size(bytes.len()).ok_or_else(too_large)?;
        let packed = packed(&file.bytes).ok_or_else(too_large)?;
        let common = common_fields(file, packed.len()).ok_or_else(too_large)?;
        header(&mut bytes, 0x0403_4b50, &[VERSION], &common);
        bytes.extend(file.path.as_bytes());
        bytes.extend(packed);
        header(&mut directory, 0x0201_4b50, &[MADE_BY, VERSION], &common);
        // The length of a comment, the number of a disk, no attributes of text.
        directory.extend([0; 6]);
        directory.extend(MODE.to_le_bytes());
        directory.extend(offset.to_le_bytes());
        directory.extend(file.path.as_bytes());
    }
    let end = end(files.len(), directory.len(), bytes.len());
    bytes.extend(directory);
    bytes.extend(end.ok_or("too many or too large files for the archive")?);
    Ok(bytes)
}

/// A size or an offset; the greatest value would mean ZIP64.
fn size(n: usize) -> Option<u32> {
    u32::try_from(n).ok().filter(|&n| n < u32::MAX)
}

/// `None` does not happen: writing to a vector does not fail.
fn packed(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).ok()?;
    encoder.finish().ok()
}

/// The common part of a local header and the central directory, from the flags on.
fn common_fields(file: &File, packed: usize) -> Option<Vec<u8>> {
    let mut crc = Crc::new();
    crc.update(&file.bytes);
    let name = u16::try_from(file.path.len()).ok()?;
    let mut fields = Vec::new();
    for field in [FLAGS, DEFLATE, TIME, DATE] {
        fields.extend(field.to_le_bytes());
    }
    for field in [crc.sum(), size(packed)?, size(file.bytes.len())?] {
        fields.extend(field.to_le_bytes());
    }
    for field in [name, 0] {
        fields.extend(field.to_le_bytes());
    }
    Some(fields)
}

fn header(bytes: &mut Vec<u8>, signature: u32, versions: &[u16], common: &[u8]) {
    bytes.extend(signature.to_le_bytes());
    for version in versions {
        bytes.extend(version.to_le_bytes());
    }
    bytes.extend(common);
}

/// The end of the central directory.
fn end(count: usize, directory: usize, offset: usize) -> Option<Vec<u8>> {
    let count = u16::try_from(count).ok().filter(|&n| n < u16::MAX)?;
    let mut fields = 0x0605_4b50_u32.to_le_bytes().to_vec();
    for field in [0, 0, count, count] {
        fields.extend(field.to_le_bytes());
    }
    for field in [size(directory)?, size(offset)?] {
        fields.extend(field.to_le_bytes());
    }
    fields.extend([0; 2]);
    Some(fields)
}
