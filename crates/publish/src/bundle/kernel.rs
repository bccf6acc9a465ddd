//! The sources of the kernel with the crates that they need, so that an archive can be checked with Rust and
//! without network.
//!
//! `verifiers/rust/vendor.py` makes the package of crates, and says what is left out of them.

use crate::appendix::File;
use flate2::read::GzDecoder;
use std::io::Read;

/// Crates as `cargo vendor` writes them, the lock file, and the configuration; a tar file.
const CRATES: &[u8] = include_bytes!("../../repository/verifiers/rust/vendor.tar.gz");

const MANIFEST: &str = include_str!("../../repository/kernel/manifest.toml");

macro_rules! sources {
    ($($name:literal)*) => {
        [$(($name, include_str!(concat!("../../repository/kernel/src/", $name)))),*]
    };
}

const SOURCES: [(&str, &str); 34] = sources![
    "boxes.rs" "cbor.rs" "claim.rs" "corners.rs" "domain.rs" "edges.rs" "family.rs" "filter.rs" "front.rs" "help.txt"
    "int.rs" "joins.rs" "lib.rs" "limits.rs" "main.rs" "meets.rs" "numbers.rs" "patch.rs" "patches.rs" "planes.rs"
    "polynomial.rs" "refusal.rs" "region.rs" "ring.rs" "root.rs" "row.rs" "rules.rs" "table.rs" "text.rs" "tiling.rs"
    "transcript.rs" "valences.rs" "vertices.rs" "walls.rs"
];

/// The folder in the archive; `cargo build --offline` works in it.
const FOLDER: &str = "verify/rust";

/// All files of the folder.
///
/// # Errors
/// The package cannot be unpacked.
pub fn files() -> Result<Vec<File>, String> {
    let text = |path: &str, text: &str| File {
        path: format!("{FOLDER}/{path}"),
        bytes: text.as_bytes().to_vec(),
    };
    let mut files = vec![text("Cargo.toml", &format!("{MANIFEST}\n[workspace]\n"))];
    files.extend(SOURCES.map(|(name, source)| text(&format!("src/{name}"), source)));
    files.extend(crates()?);
    Ok(files)
}

fn crates() -> Result<Vec<File>, String> {
    let mut tar = Vec::new();
    GzDecoder::new(CRATES)
        .read_to_end(&mut tar)
        .map_err(|error| format!("the package of crates: {error}"))?;
    let mut files = Vec::new();
    let mut rest = tar.as_slice();
    // The end is a block of zeros.
    while rest.first().is_some_and(|byte| *byte != 0) {
        let (file, after) = entry(rest).ok_or("the package of crates is damaged")?;
        files.push(file);
        rest = after;
    }
    Ok(files)
}

/// The first entry of a tar file in the format of POSIX 1988 (ustar). It has a header of 512 bytes,
/// and the content in blocks of 512 bytes.
fn entry(tar: &[u8]) -> Option<(File, &[u8])> {
    let (header, rest) = tar.split_at_checked(BLOCK)?;
    let word = |bytes: &[u8]| {
        let end = bytes.iter().position(|b| *b == 0).unwrap_or(bytes.len());
        String::from_utf8(bytes[..end].to_vec()).ok()
    };
    let (name, prefix) = (word(&header[..100])?, word(&header[345..500])?);
    let size = usize::from_str_radix(word(&header[124..136])?.trim(), 8).ok()?;
    let (content, rest) = rest.split_at_checked(size.next_multiple_of(BLOCK))?;
    let path = if prefix.is_empty() {
        format!("{FOLDER}/{name}")
    } else {
        format!("{FOLDER}/{prefix}/{name}")
    };
    let bytes = content[..size].to_vec();
    Some((File { path, bytes }, rest))
}

const BLOCK: usize = 512;

#[cfg(test)]
mod tests {
    use super::{SOURCES, files};

    #[test]
    fn every_source_of_the_kernel_is_there() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../kernel/src");
        let mut found: Vec<String> = std::fs::read_dir(folder)
            .expect("the kernel")
            .map(|entry| {
                entry
                    .expect("a file")
                    .file_name()
                    .into_string()
                    .expect("UTF-8")
            })
            .collect();
        found.sort();
        assert_eq!(found, SOURCES.map(|(name, _)| name));
    }

    #[test]
    fn the_package_has_the_crates_of_the_kernel() {
        let files = files().expect("files");
        for path in [
            "verify/rust/.cargo/config.toml",
            "verify/rust/Cargo.lock",
            "verify/rust/src/main.rs",
        ] {
            assert!(files.iter().any(|file| file.path == path), "{path}");
        }
        let has = |name: &str| {
            let start = format!("verify/rust/vendor/{name}-");
            files
                .iter()
                .any(|f| f.path.starts_with(&start) && f.path.ends_with("/src/lib.rs"))
        };
        assert!(
            ["num-bigint", "num-integer", "num-traits", "sha2", "digest"]
                .iter()
                .all(|name| has(name))
        );
    }
}
