//! Where the bytes of a certificate are: in memory, or in a file that is read in pieces.
//!
//! A file is read more than once, and somebody might change it meanwhile. So every
//! pass over a part of it gives a digest, and all digests of a part must be equal.

use super::Refusal;
use sha2::{Digest, Sha256};
use std::borrow::Cow;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};

/// A string of bytes that can be read again.
pub(super) enum Source<'s> {
    Memory(Cow<'s, [u8]>),
    /// The bytes from `start` to `end` of a regular file.
    File {
        file: &'s File,
        start: u64,
        end: u64,
    },
}

impl<'s> Source<'s> {
    /// The whole of a regular file, as long as it is now.
    pub(super) fn of_file(file: &'s File) -> Result<Source<'s>, Refusal> {
        let end = file.metadata().map_err(changed)?.len();
        let start = 0;
        Ok(Source::File { file, start, end })
    }

    pub(super) fn length(&self) -> u64 {
        match self {
            Source::Memory(bytes) => bytes.len() as u64,
            Source::File { start, end, .. } => end - start,
        }
    }

    /// The bytes from `from` to `to`, which are there.
    pub(super) fn part(&'s self, from: u64, to: u64) -> Source<'s> {
        match self {
            Source::Memory(bytes) => {
                Source::Memory(Cow::Borrowed(&bytes[from as usize..to as usize]))
            }
            Source::File { file, start, .. } => Source::File {
                file,
                start: start + from,
                end: start + to,
            },
        }
    }

    fn read_at(&self, at: u64, into: &mut [u8]) -> io::Result<usize> {
        match self {
            Source::Memory(bytes) => (&bytes[at as usize..]).read(into),
            Source::File { file, start, end } => {
                let mut file: &File = file;
                file.seek(SeekFrom::Start(start + at))?;
                let left = (end - start - at).min(into.len() as u64);
                file.read(&mut into[..left as usize])
            }
        }
    }

    /// Whether nobody else can change it.
    pub(super) fn is_ours(&self) -> bool {
        matches!(self, Source::Memory(_))
    }
}

fn changed(error: io::Error) -> Refusal {
    Refusal::Changed {
        message: error.to_string(),
    }
}

/// What SHA-256 gives.
pub(super) type Sum = [u8; 32];

/// The bytes of a source from its beginning, once.
pub(super) struct Bytes<'s> {
    source: &'s Source<'s>,
    /// Of these bytes, those before `at` are gone and those before `hashed` are in the digests.
    buffer: Vec<u8>,
    at: usize,
    hashed: usize,
    /// Where the buffer ends in the source.
    end: u64,
    /// The digest of all; and of what came since [`Bytes::mark`].
    all: Option<Sha256>,
    part: Option<Sha256>,
}

impl<'s> Bytes<'s> {
    /// For the first time: with digests of the whole and of its parts, whoever owns the bytes.
    pub(super) fn first(source: &'s Source<'s>) -> Bytes<'s> {
        Bytes {
            all: Some(Sha256::new()),
            part: Some(Sha256::new()),
            ..Bytes::new(source)
        }
    }

    fn new(source: &'s Source<'s>) -> Bytes<'s> {
        Bytes {
            source,
            buffer: Vec::new(),
            at: 0,
            hashed: 0,
            end: 0,
            all: None,
            part: None,
        }
    }

    /// With a digest where somebody else might change the bytes.
    pub(super) fn again(source: &'s Source<'s>) -> Bytes<'s> {
        Bytes {
            all: (!source.is_ours()).then(Sha256::new),
            ..Bytes::new(source)
        }
    }

    /// How many bytes are gone.
    pub(super) fn offset(&self) -> u64 {
        self.end - (self.buffer.len() - self.at) as u64
    }

    /// How many bytes are to come.
    pub(super) fn left(&self) -> u64 {
        self.source.length() - self.offset()
    }

    /// The next byte; `None` at the end.
    #[inline]
    pub(super) fn next(&mut self) -> Result<Option<u8>, Refusal> {
        if self.at == self.buffer.len() {
            self.refill()?;
        }
        let byte = self.buffer.get(self.at).copied();
        self.at += usize::from(byte.is_some());
        Ok(byte)
    }

    /// Up to `length` next bytes; less where fewer are there at hand, none at the end.
    pub(super) fn some(&mut self, length: u64) -> Result<&[u8], Refusal> {
        if self.at == self.buffer.len() {
            self.refill()?;
        }
        let here = (self.buffer.len() - self.at) as u64;
        let from = self.at;
        self.at += here.min(length) as usize;
        Ok(&self.buffer[from..self.at])
    }

    /// Over all that is left, so that it is in the digest.
    pub(super) fn skip_rest(&mut self) -> Result<(), Refusal> {
        while !self.some(u64::MAX)?.is_empty() {}
        Ok(())
    }

    fn refill(&mut self) -> Result<(), Refusal> {
        const PIECE: u64 = 1 << 16;
        self.feed();
        let left = self.source.length() - self.end;
        self.buffer.resize(left.min(PIECE) as usize, 0);
        let found = match self.buffer.is_empty() {
            true => 0,
            false => {
                let found = self.source.read_at(self.end, &mut self.buffer);
                found.map_err(changed)?
            }
        };
        self.buffer.truncate(found);
        (self.at, self.hashed) = (0, 0);
        self.end += found as u64;
        match found == 0 && left > 0 {
            true => Err(changed(io::ErrorKind::UnexpectedEof.into())),
            false => Ok(()),
        }
    }

    fn feed(&mut self) {
        let new = &self.buffer[self.hashed..self.at];
        for digest in [&mut self.all, &mut self.part].into_iter().flatten() {
            digest.update(new);
        }
        self.hashed = self.at;
    }

    /// The digest since the last mark, and a new mark; `None` without digests.
    pub(super) fn mark(&mut self) -> Option<Sum> {
        self.feed();
        Some(self.part.as_mut()?.finalize_reset().into())
    }

    /// The digest of all that is gone.
    pub(super) fn sum(mut self) -> Option<Sum> {
        self.feed();
        Some(self.all?.finalize().into())
    }
}

impl Bytes<'_> {
    /// That a pass saw what the first one saw.
    pub(super) fn check_sum(self, first: &Option<Sum>) -> Result<(), Refusal> {
        match self.sum() {
            None => Ok(()),
            sum if sum == *first => Ok(()),
            _ => Err(Refusal::Changed {
                message: "its digest is another".to_owned(),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::document::{Document, read_cbor};
    use super::super::{Limits, Refusal, check, geometry, shape};
    use super::Source;
    use std::fs::{self, File};

    /// Reads a certificate from a file, changes the file, and goes over its tables again.
    fn read_and_change(change: impl Fn(&mut Vec<u8>)) -> Result<(), Refusal> {
        let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
        let path = format!("{root}/tests/certificates/cbor/valid--space-a15-tcp.cbor");
        let mut bytes = fs::read(path).unwrap();
        let place = tempfile::NamedTempFile::new().unwrap();
        fs::write(place.path(), &bytes).unwrap();
        let file = File::open(place.path()).unwrap();
        let source = Source::of_file(&file).unwrap();
        let document: Document = read_cbor(&source, &Limits::DEFAULT).unwrap();
        change(&mut bytes);
        fs::write(place.path(), &bytes).unwrap();
        document.witness.mates.each(|_, _| Ok(()))?;
        document.witness.vertices.each(|_, _| Ok(()))?;
        document.witness.simplices.each(|_, _| Ok(()))
    }

    /// The last byte is a shift of the last corner.
    #[test]
    fn a_file_that_changes_is_declined() {
        assert_eq!(read_and_change(|_| {}), Ok(()));
        let changes: [fn(&mut Vec<u8>); 3] = [
            |bytes| *bytes.last_mut().unwrap() ^= 1,
            |bytes| bytes.truncate(bytes.len() - 1),
            |bytes| bytes.clear(),
        ];
        for change in changes {
            let refusal = read_and_change(change).unwrap_err();
            assert_eq!(refusal.code(), "changed", "{refusal}");
        }
    }

    /// Wherever one byte changes after the first pass: nothing panics, and no refusal speaks of
    /// bytes whose digest was not told. The claim is not read again.
    #[test]
    fn any_byte_that_changes_is_declined_or_not_seen() {
        let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
        let path = format!("{root}/tests/certificates/cbor/valid--space-a15-tcp.cbor");
        let bytes = fs::read(path).unwrap();
        let place = tempfile::NamedTempFile::new().unwrap();
        fs::write(place.path(), &bytes).unwrap();
        let file = File::open(place.path()).unwrap();
        let source = Source::of_file(&file).unwrap();
        let document = read_cbor(&source, &Limits::DEFAULT).unwrap();
        let mut seen = 0;
        for at in 0..bytes.len() {
            let mut changed = bytes.clone();
            changed[at] ^= [1, 0x80, 0x1f, 0xff][at % 4];
            fs::write(place.path(), &changed).unwrap();
            match check(&document, &Limits::DEFAULT, shape::CHECKS, geometry::CHECKS) {
                Ok(_) => {}
                Err(refusal) => {
                    assert_eq!(refusal.code(), "changed", "byte {at}: {refusal}");
                    seen += 1;
                }
            }
        }
        assert!(seen > bytes.len() / 2, "{seen} of {}", bytes.len());
    }
}
