//! Files that people bring, read into tilings and point sets.
//!
//! A reader checks form (presence, length, range); whether
//! the tiling is one is the checker's business. Every error names the place.

mod atoms;
pub mod cif;
pub mod crystal;
mod document;
mod domain;
mod error;
mod excerpt;
mod frame;
mod native;
mod numbers;
mod text;
mod words;

pub use error::ImportError;
pub use excerpt::Excerpt;
pub use native::{Content, NativeFile, read_document, read_native};
pub use text::{BYTE_LIMIT, is_gzip, read_bytes, read_text, uncompressed_name, without_comments};
pub use words::of_io as io_words;
