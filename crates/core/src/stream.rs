//! Bytes that one thread writes and another one reads: a certificate goes to the kernel while it is
//! written. The writer keeps all bytes, and the reader gets the same ones in the same order.

use std::io::{self, Read, Write};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};

/// Chunks that wait for the reader.
const CHUNKS: usize = 16;

/// The end that writes. It keeps the bytes, whether the reader still wants them or not.
pub struct Writer {
    kept: Vec<u8>,
    chunks: SyncSender<Vec<u8>>,
}

/// The end that reads.
pub struct Reader {
    chunks: Receiver<Vec<u8>>,
    chunk: Vec<u8>,
    /// The bytes of the chunk that are read.
    read: usize,
}

/// Both ends.
pub fn stream() -> (Writer, Reader) {
    let (sender, receiver) = sync_channel(CHUNKS);
    let writer = Writer {
        kept: Vec::new(),
        chunks: sender,
    };
    let reader = Reader {
        chunks: receiver,
        chunk: Vec::new(),
        read: 0,
    };
    (writer, reader)
}

impl Writer {
    /// Ends the stream, and returns all its bytes.
    pub fn finish(self) -> Vec<u8> {
        self.kept
    }
}

impl Write for Writer {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.kept.extend_from_slice(bytes);
        // A reader that has refused the certificate is gone.
        let _ = self.chunks.send(bytes.to_vec());
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Read for Reader {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        while self.read == self.chunk.len() {
            // The stream ends when the writer is gone.
            let Ok(chunk) = self.chunks.recv() else {
                return Ok(0);
            };
            self.chunk = chunk;
            self.read = 0;
        }
        let rest = &self.chunk[self.read..];
        let count = rest.len().min(buffer.len());
        buffer[..count].copy_from_slice(&rest[..count]);
        self.read += count;
        Ok(count)
    }
}
