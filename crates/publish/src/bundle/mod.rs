//! An archive to deposit with a paper: whatever a referee needs to look at confirmed certificates
//! and to check them again.
//!
//! | file | part |
//! |---|---|
//! | `mod.rs` | which files there are |
//! | `metadata` | who deposits it: CITATION.cff, .zenodo.json |
//! | `readme` | what the archive tells a referee |
//! | `pdf` | the appendix by TeX |
//! | `zip` | the files as one |
//! | `verify.py` | a third checker, in Python; it goes into the archive |
//!
//! Nothing here proves anything: what comes in is [`Proved`].

pub mod metadata;
mod pdf;
mod readme;
mod zip;

pub use zip::archive;

use self::metadata::Deposit;
use crate::appendix::{self, File, Subject, slug};
use crate::report::{Proved, page};
use acutile_core::tiling::{AnyTiling, Tiling};
use acutile_core::with_dimension;
use acutile_io::export::tiling_text;
use acutile_io::mesh::{Format, flatten, write};
use sha2::{Digest, Sha256};

/// What the archive has beside what is made of the tilings.
const FIXED: [(&str, &str); 7] = [
    ("verify/LICENSE", include_str!("../../../../LICENSE")),
    ("docs/format.md", include_str!("../../../../docs/format.md")),
    (
        "docs/soundness.md",
        include_str!("../../../../docs/soundness.md"),
    ),
    (
        "verify/package.json",
        include_str!("../../../../verifiers/javascript/package.json"),
    ),
    (
        "verify/verifier.js",
        include_str!("../../../../verifiers/javascript/verifier.js"),
    ),
    (
        "verify/verify-cli.mjs",
        include_str!("../../../../verifiers/javascript/verify-cli.mjs"),
    ),
    (
        "verify/verify.py",
        include_str!("../../../../verifiers/python/verify.py"),
    ),
];

/// The extensions of the mesh formats, all of them as text.
const MESHES: [(&str, Format); 3] = [
    ("msh", Format::Msh4),
    ("vtu", Format::VtuText),
    ("mesh", Format::Medit),
];

/// A confirmed certificate, and what the appendix says of it.
pub struct Piece {
    pub proved: Proved,
    pub subject: Subject,
}

/// What goes into the archive.
pub struct Options {
    /// The appendix as PDF, if there is a TeX.
    pub pdf: bool,
    /// Who deposits the archive, and under which licence.
    pub deposit: Deposit,
}

/// The files by their names, and what is to be told on standard error.
pub struct Bundle {
    pub files: Vec<File>,
    pub notes: Vec<String>,
}

/// What the archive says of one tiling.
struct Entry {
    slug: String,
    /// The claim in the kernel's words.
    claim: String,
    sha256: String,
    /// How many coordinates of the meshes are rounded, and by how much; nothing in the plane.
    rounding: Option<(usize, f64)>,
}

/// All files, SHA256SUMS among them.
///
/// # Errors
/// Two tilings would have the same files.
pub fn bundle(pieces: Vec<Piece>, options: &Options) -> Result<Bundle, String> {
    let (proved, subjects): (Vec<Proved>, Vec<Subject>) =
        pieces.into_iter().map(|p| (p.proved, p.subject)).unzip();
    let mut notes = Vec::new();
    let mut files = fixed();
    let entries = entries(&proved, &mut files)?;
    files.push(file("report.html", page(&proved, None)));
    let has_pdf = add_appendix(&subjects, options, &mut files, &mut notes);
    let readme = readme::readme(&entries, !subjects.is_empty(), has_pdf, &options.deposit);
    files.extend(citation(&entries, &options.deposit));
    files.push(file("Makefile", readme::makefile()));
    files.push(file("CLAIMS.md", readme::claims(&entries)));
    files.push(file("README.md", readme));
    files.sort_by(|a, b| a.path.cmp(&b.path));
    let sums = file("SHA256SUMS", sums(&files));
    files.push(sums);
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(Bundle { files, notes })
}

/// The author's citation and Zenodo record; without an author the citation of acutile.
fn citation(entries: &[Entry], deposit: &Deposit) -> Vec<File> {
    let slugs: Vec<&str> = entries.iter().map(|entry| entry.slug.as_str()).collect();
    let own = include_str!("../../../../CITATION.cff").to_owned();
    let citation = deposit.citation(&slugs).unwrap_or(own);
    let zenodo = deposit.zenodo(&slugs);
    let zenodo = zenodo.map(|text| file(".zenodo.json", text));
    [file("CITATION.cff", citation)]
        .into_iter()
        .chain(zenodo)
        .collect()
}

fn entries(proved: &[Proved], files: &mut Vec<File>) -> Result<Vec<Entry>, String> {
    let mut entries: Vec<Entry> = Vec::new();
    for proved in proved {
        let entry = entry(proved, files);
        let slug = &entry.slug;
        // Some file systems do not tell A15 from a15.
        let is_same = |other: &Entry| other.slug.eq_ignore_ascii_case(slug);
        if entries.iter().any(is_same) {
            return Err(format!("two inputs would both be {slug}"));
        }
        entries.push(entry);
    }
    Ok(entries)
}

/// Adds the appendix, if there is something to say in it; whether with PDF.
fn add_appendix(
    subjects: &[Subject],
    options: &Options,
    files: &mut Vec<File>,
    notes: &mut Vec<String>,
) -> bool {
    if subjects.is_empty() {
        return false;
    }
    let appendix = appendix::appendix(subjects, &appendix::Options::default());
    let pdfs = match options.pdf {
        true => pdf::compile(&appendix).unwrap_or_else(|reason| {
            notes.push(format!("{reason}: the appendix comes without PDF"));
            Vec::new()
        }),
        false => Vec::new(),
    };
    let has_pdf = !pdfs.is_empty();
    files.extend(appendix.into_iter().chain(pdfs).map(in_appendix));
    has_pdf
}

fn fixed() -> Vec<File> {
    FIXED
        .iter()
        .map(|(path, text)| file(path, (*text).to_owned()))
        .collect()
}

fn file(path: &str, text: String) -> File {
    File {
        path: path.to_owned(),
        bytes: text.into_bytes(),
    }
}

fn in_appendix(file: File) -> File {
    File {
        path: format!("appendix/{}", file.path),
        ..file
    }
}

/// Adds the certificate in both encodings, the tiling and its meshes.
fn entry(proved: &Proved, files: &mut Vec<File>) -> Entry {
    let slug = slug(&proved.name);
    files.push(File {
        path: format!("certificates/{slug}.cbor"),
        bytes: proved.certificate().to_vec(),
    });
    files.push(file(
        &format!("certificates/{slug}.json"),
        proved.json().to_owned(),
    ));
    let text = with_dimension!(proved.tiling(), AnyTiling, t => tiling_text(t, &slug));
    files.push(file(&format!("tilings/{slug}.json"), text));
    let rounding = match proved.tiling() {
        AnyTiling::Plane(_) => None,
        AnyTiling::Space(tiling) => Some(meshes(tiling, &slug, files)),
    };
    Entry {
        claim: proved.in_words(),
        sha256: proved.sha256(),
        slug,
        rounding,
    }
}

/// Adds the meshes; how many coordinates were rounded, and by how much at most.
fn meshes(tiling: &Tiling<3>, slug: &str, files: &mut Vec<File>) -> (usize, f64) {
    let flat = flatten(tiling, None).expect("a proved tiling has a metric");
    for (extension, format) in MESHES {
        // These formats are one file each.
        files.extend(write(&flat.mesh, format).into_iter().map(|mesh| File {
            path: format!("tilings/{slug}.{extension}"),
            bytes: mesh.bytes,
        }));
    }
    (flat.rounded, flat.largest_move)
}

/// Lines as `sha256sum` writes and reads them.
fn sums(files: &[File]) -> String {
    let line = |file: &File| {
        let digest = Sha256::digest(&file.bytes);
        let hex: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        format!("{hex}  {}\n", file.path)
    };
    files.iter().map(line).collect()
}
