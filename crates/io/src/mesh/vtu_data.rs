//! The arrays of a VTU file: in text, in base64, raw, compressed with zlib, LZ4 or LZMA.
//!
//! In binary an array is its number of bytes and the bytes. A compressed array has a head and
//! blocks. The head begins with the number of blocks and the size of a block before compression. The
//! size of the last block follows (0 if it is as long as the others), then the compressed sizes. In base64 the head of a compressed array is
//! encoded on its own.

use super::error::{MeshError, Place};
use super::source::{Encoding, Source};
use base64::Engine;
use base64::alphabet;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use flate2::read::ZlibDecoder;
use std::io::Read;

/// The element type of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Single precision.
    Single,
    /// Double precision.
    Double,
    /// An integer of this many bytes, signed or not.
    Integer { bytes: usize, signed: bool },
}

impl Kind {
    /// As VTK writes it, like `Float64`.
    pub fn parse(name: &str) -> Option<Kind> {
        let integer = |bytes, signed| Some(Kind::Integer { bytes, signed });
        match name {
            "Float32" => Some(Kind::Single),
            "Float64" => Some(Kind::Double),
            "Int8" => integer(1, true),
            "Int16" => integer(2, true),
            "Int32" => integer(4, true),
            "Int64" => integer(8, true),
            "UInt8" => integer(1, false),
            "UInt16" => integer(2, false),
            "UInt32" => integer(4, false),
            "UInt64" => integer(8, false),
            _ => None,
        }
    }

    fn bytes(self) -> usize {
        match self {
            Kind::Single => 4,
            Kind::Double => 8,
            Kind::Integer { bytes, .. } => bytes,
        }
    }
}

/// How the binary arrays of a file are written.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// The order of bytes.
    pub encoding: Encoding,
    /// The bytes of a number in an array's head: 4 or 8.
    pub head: usize,
    /// How arrays are compressed.
    pub compressor: Option<Compressor>,
}

/// How blocks of an array are compressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compressor {
    /// A zlib stream.
    Zlib,
    /// A bare LZ4 block.
    Lz4,
    /// LZMA in an xz stream.
    Lzma,
}

impl Compressor {
    /// As VTK names it.
    pub fn parse(name: &str) -> Option<Compressor> {
        match name {
            "vtkZLibDataCompressor" => Some(Compressor::Zlib),
            "vtkLZ4DataCompressor" => Some(Compressor::Lz4),
            "vtkLZMADataCompressor" => Some(Compressor::Lzma),
            _ => None,
        }
    }

    /// Appends a block that has at most `size` bytes before compression.
    fn unpack(self, block: &[u8], size: usize, unpacked: &mut Vec<u8>) -> Result<(), String> {
        let limit = size as u64;
        match self {
            Compressor::Zlib => ZlibDecoder::new(block)
                .take(limit)
                .read_to_end(unpacked)
                .map(drop)
                .map_err(|error| error.to_string()),
            Compressor::Lzma => lzma_rust2::XzReader::new(block, false)
                .take(limit)
                .read_to_end(unpacked)
                .map(drop)
                .map_err(|error| error.to_string()),
            Compressor::Lz4 => {
                // LZ4 makes no byte into more than 255, so a false size costs no memory.
                let size = size.min(block.len().saturating_mul(255).saturating_add(64));
                let bytes =
                    lz4_flex::block::decompress(block, size).map_err(|error| error.to_string())?;
                unpacked.extend(bytes);
                Ok(())
            }
        }
    }
}

/// No array may be longer after decompression: 512 MiB.
const UNPACKED_LIMIT: u64 = 1 << 29;

/// The numbers of an array, as doubles; for coordinates.
pub fn doubles(source: &mut Source, kind: Kind, count: usize) -> Result<Vec<f64>, MeshError> {
    let number = match kind {
        Kind::Single => Source::single,
        Kind::Double => Source::double,
        Kind::Integer { .. } => return whole_doubles(source, kind, count),
    };
    let count = source.count(
        count as i64,
        source.least_bytes(1, kind.bytes()),
        "coordinates",
    )?;
    let mut list = Vec::with_capacity(count);
    for _ in 0..count {
        list.push(number(source, "a coordinate")?);
    }
    expect_end(source, count)?;
    Ok(list)
}

/// Integers as doubles, where that is exact.
fn whole_doubles(source: &mut Source, kind: Kind, count: usize) -> Result<Vec<f64>, MeshError> {
    let list = integers(source, kind, Some(count))?;
    let double = |value: i64| {
        if value.unsigned_abs() <= 1 << 53 {
            Ok(value as f64)
        } else {
            Err(source.error(format!(
                "found the coordinate {value}, expected an integer that is a double"
            )))
        }
    };
    list.into_iter().map(double).collect()
}

/// The numbers of an array, as integers; `count` of them, or as many as there are.
pub fn integers(
    source: &mut Source,
    kind: Kind,
    count: Option<usize>,
) -> Result<Vec<i64>, MeshError> {
    let Kind::Integer { bytes, signed } = kind else {
        return Err(source.error("found numbers of floating point, expected integers"));
    };
    let mut list = Vec::new();
    while !at_end(source) {
        list.push(match source.encoding {
            Encoding::Text => source.int("an integer")?,
            encoding => {
                let digits = source.take(bytes, "an integer")?;
                integer(digits, encoding, signed)
                    .ok_or_else(|| source.error("found an integer of more than 63 bits"))?
            }
        });
    }
    match count {
        Some(count) if count != list.len() => {
            Err(source.error(format!("found {} integers, expected {count}", list.len())))
        }
        _ => Ok(list),
    }
}

fn at_end(source: &mut Source) -> bool {
    match source.encoding {
        Encoding::Text => source.is_at_text_end(),
        _ => source.remaining() == 0,
    }
}

fn expect_end(source: &mut Source, count: usize) -> Result<(), MeshError> {
    if at_end(source) {
        Ok(())
    } else {
        Err(source.error(format!(
            "found more than the {count} numbers that were expected"
        )))
    }
}

/// The value of up to eight bytes; `None` for one that needs the 64th bit.
pub fn integer(digits: &[u8], encoding: Encoding, signed: bool) -> Option<i64> {
    let mut bytes = [0; 8];
    bytes[..digits.len()].copy_from_slice(digits);
    if encoding == Encoding::Big {
        bytes[..digits.len()].reverse();
    }
    let value = i64::from_le_bytes(bytes);
    let unused = 64 - 8 * digits.len() as u32;
    if signed {
        Some(value << unused >> unused)
    } else {
        (value >= 0).then_some(value)
    }
}

/// The bytes of a binary array that begins at the first of `data`, in base64 or raw.
pub fn unpack(
    data: &[u8],
    is_base64: bool,
    layout: Layout,
    place: Place,
) -> Result<Vec<u8>, MeshError> {
    let mut packed = Packed {
        data,
        is_base64,
        layout,
        place,
    };
    match layout.compressor {
        Some(compressor) => packed.compressed(compressor),
        None => packed.plain(),
    }
}

struct Packed<'a> {
    data: &'a [u8],
    is_base64: bool,
    layout: Layout,
    place: Place,
}

impl Packed<'_> {
    fn error(&self, problem: impl std::fmt::Display) -> MeshError {
        MeshError::at(self.place, problem)
    }

    /// The next `length` bytes, which in base64 were encoded on their own.
    fn segment(&mut self, length: usize) -> Result<Vec<u8>, MeshError> {
        let width = if self.is_base64 {
            length.div_ceil(3).checked_mul(4)
        } else {
            Some(length)
        };
        let Some((taken, rest)) = width.and_then(|width| self.data.split_at_checked(width)) else {
            return Err(self.error(format!(
                "the array should go on for {length} bytes, but {} are left in the file",
                self.data.len()
            )));
        };
        self.data = rest;
        if !self.is_base64 {
            return Ok(taken.to_vec());
        }
        let config = GeneralPurposeConfig::new()
            .with_decode_padding_mode(DecodePaddingMode::Indifferent)
            .with_decode_allow_trailing_bits(true);
        let mut bytes = GeneralPurpose::new(&alphabet::STANDARD, config)
            .decode(taken)
            .map_err(|error| self.error(format!("no base64: {error}")))?;
        if bytes.len() >= length {
            bytes.truncate(length)
        } else {
            return Err(self.error("the base64 text ends early"));
        }
        Ok(bytes)
    }

    fn head(&self, bytes: &[u8]) -> Result<Vec<usize>, MeshError> {
        let numbers = bytes.chunks_exact(self.layout.head).map(|digits| {
            integer(digits, self.layout.encoding, false)
                .and_then(|value| usize::try_from(value).ok())
                .ok_or_else(|| self.error("the head of an array has a number of more than 63 bits"))
        });
        numbers.collect()
    }

    /// Head and bytes are encoded in one, except by some writers, who end the head with a `=`.
    fn plain(&mut self) -> Result<Vec<u8>, MeshError> {
        let all = self.data;
        let head = self.segment(self.layout.head)?;
        let length = self.head(&head)?[0];
        let read = all.len() - self.data.len();
        if self.is_base64 && !all[..read].contains(&b'=') {
            self.data = all;
            let both = self.segment(length.saturating_add(self.layout.head))?;
            return Ok(both[self.layout.head..].to_vec());
        }
        self.segment(length)
    }

    fn compressed(&mut self, compressor: Compressor) -> Result<Vec<u8>, MeshError> {
        let all = self.data;
        let first = self.segment(self.layout.head)?;
        let blocks = self.head(&first)?[0];
        self.data = all;
        let head = blocks.saturating_add(3).saturating_mul(self.layout.head);
        let head = self.segment(head)?;
        let head = self.head(&head)?;
        let total = head[3..]
            .iter()
            .fold(0usize, |sum, &size| sum.saturating_add(size));
        let packed = self.segment(total)?;
        let mut unpacked = Vec::new();
        let mut rest = packed.as_slice();
        let last = blocks.wrapping_sub(1);
        for (index, &size) in head[3..].iter().enumerate() {
            let (block, after) = rest.split_at(size);
            rest = after;
            let expected = if index == last && head[2] > 0 {
                head[2]
            } else {
                head[1]
            };
            if expected.saturating_add(unpacked.len()) as u64 > UNPACKED_LIMIT {
                return Err(MeshError::limit(format!(
                    "an array has more than {UNPACKED_LIMIT} bytes after decompression"
                )));
            }
            let before = unpacked.len();
            compressor
                .unpack(block, expected, &mut unpacked)
                .map_err(|error| {
                    self.error(format!("a compressed block cannot be read: {error}"))
                })?;
            let found = unpacked.len() - before;
            if found != expected {
                return Err(self.error(format!(
                    "a compressed block has {found} bytes, expected {expected}"
                )));
            }
        }
        Ok(unpacked)
    }
}
