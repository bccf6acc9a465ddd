//! An archive to deposit with a paper: whatever a referee needs to look at confirmed certificates
//! and to check them again.
//!
//! | file | part |
//! |---|---|
//! | `mod.rs` | which files there are |
//! | `metadata` | who deposits it: CITATION.cff, .zenodo.json |
//! | `kernel` | the kernel's sources with the crates that they need |
//! | `readme` | what the archive tells a referee |
//! | `pdf` | the appendix by TeX |
//! | `zip` | the files as one |
//! | `verify.py` | a third checker, in Python; it goes into the archive |
//!
//! Nothing here proves anything: the input is [`Proved`] or a [`Theorem`].

mod kernel;
pub mod metadata;
mod pdf;
mod readme;
mod zip;

pub use zip::archive;

use self::metadata::Deposit;
use crate::appendix::{self, File, Subject};
use crate::report::{Proved, Shown, Theorem, mixed_page};
use acutile_core::tiling::{AnyTiling, Tiling};
use acutile_core::with_dimension;
use acutile_io::export::{coq_file, tiling_text};
use acutile_io::mesh::{Format, flatten, write};
use sha2::{Digest, Sha256};

/// The parts of the archive that do not come from the tilings.
const FIXED: [(&str, &str); 7] = [
    ("verify/LICENSE", include_str!("../../repository/LICENSE")),
    (
        "docs/format.md",
        include_str!("../../repository/docs/format.md"),
    ),
    (
        "docs/soundness.md",
        include_str!("../../repository/docs/soundness.md"),
    ),
    (
        "verify/package.json",
        include_str!("../../repository/verifiers/javascript/package.json"),
    ),
    (
        "verify/verifier.js",
        include_str!("../../repository/verifiers/javascript/verifier.js"),
    ),
    (
        "verify/verify-cli.mjs",
        include_str!("../../repository/verifiers/javascript/verify-cli.mjs"),
    ),
    (
        "verify/verify.py",
        include_str!("../../repository/verifiers/python/verify.py"),
    ),
];

/// The extensions of the mesh formats, all of them as text.
const MESHES: [(&str, Format); 3] = [
    ("msh", Format::Msh4),
    ("vtu", Format::VtuText),
    ("mesh", Format::Medit),
];

/// A confirmed certificate.
pub struct Piece {
    /// The part of the page about it.
    pub content: Content,
    /// The part of the appendix about it.
    pub subject: Subject,
}

/// The subject of a confirmed certificate.
pub enum Content {
    /// A single tiling.
    Tiling(Box<Proved>),
    /// A family, or a system of patches.
    Theorem(Box<Theorem>),
}

impl Content {
    /// Its article on a page.
    pub fn shown(&self) -> Shown<'_> {
        match self {
            Content::Tiling(proved) => Shown::Proved(proved),
            Content::Theorem(theorem) => Shown::Theorem(theorem),
        }
    }

    /// The digest of the certificate, in hexadecimal digits.
    pub fn sha256(&self) -> String {
        match self {
            Content::Tiling(proved) => proved.sha256(),
            Content::Theorem(theorem) => theorem.sha256().to_owned(),
        }
    }

    fn json(&self) -> &str {
        match self {
            Content::Tiling(proved) => proved.json(),
            Content::Theorem(theorem) => theorem.json(),
        }
    }

    /// The claim in the kernel's words.
    fn claim(&self) -> String {
        match self {
            Content::Tiling(proved) => proved.in_words(),
            Content::Theorem(theorem) => theorem.claim().to_owned(),
        }
    }

    fn tiling(&self) -> Option<&AnyTiling> {
        match self {
            Content::Tiling(proved) => Some(proved.tiling()),
            Content::Theorem(_) => None,
        }
    }
}

/// The input of the archive.
pub struct Options {
    /// The appendix as PDF, if there is a TeX.
    pub pdf: bool,
    /// The claims as theorems for Coq.
    pub coq: bool,
    /// Who deposits the archive, and under which licence.
    pub deposit: Deposit,
}

/// The files by their names, and the notes for standard error.
pub struct Bundle {
    /// The files, sorted by path.
    pub files: Vec<File>,
    /// Sentences for standard error.
    pub notes: Vec<String>,
}

/// The archive's data about one certificate.
struct Entry {
    slug: String,
    /// The claim in the kernel's words.
    claim: String,
    sha256: String,
    /// Whether it is about a single tiling, which is there as a file.
    is_tiling: bool,
    /// How many coordinates of the meshes are rounded, and by how much; nothing in the plane.
    rounding: Option<(usize, f64)>,
}

/// All files, SHA256SUMS among them.
///
/// # Errors
/// Two tilings would have the same files.
pub fn bundle(pieces: Vec<Piece>, options: &Options) -> Result<Bundle, String> {
    let mut notes = Vec::new();
    let mut files = fixed();
    files.extend(kernel::files()?);
    let entries = entries(&pieces, &mut files)?;
    if options.coq {
        add_theorems(&pieces, &mut files)?;
    }
    let (contents, subjects): (Vec<Content>, Vec<Subject>) =
        pieces.into_iter().map(|p| (p.content, p.subject)).unzip();
    let shown: Vec<Shown> = contents.iter().map(Content::shown).collect();
    files.push(file("report.html", mixed_page(&shown, None)));
    let has_pdf = add_appendix(&subjects, options, &mut files, &mut notes);
    let parts = readme::Parts {
        has_appendix: !subjects.is_empty(),
        has_pdf,
        has_theorems: options.coq,
    };
    let readme = readme::readme(&entries, parts, &options.deposit);
    files.push(file("expected-output.txt", readme::expected(&entries)));
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
    let own = include_str!("../../repository/CITATION.cff").to_owned();
    let citation = deposit.citation(&slugs).unwrap_or(own);
    let zenodo = deposit.zenodo(&slugs);
    let zenodo = zenodo.map(|text| file(".zenodo.json", text));
    [file("CITATION.cff", citation)]
        .into_iter()
        .chain(zenodo)
        .collect()
}

fn entries(pieces: &[Piece], files: &mut Vec<File>) -> Result<Vec<Entry>, String> {
    let mut entries: Vec<Entry> = Vec::new();
    for piece in pieces {
        let entry = entry(piece, files);
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

/// Adds the claims as theorems for Coq.
fn add_theorems(pieces: &[Piece], files: &mut Vec<File>) -> Result<(), String> {
    for Piece { subject, .. } in pieces {
        let theorem = coq_file(subject.certificate())?;
        files.push(file(&format!("coq/{}.v", subject.slug()), theorem));
    }
    Ok(())
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
    let pdfs = if options.pdf {
        pdf::compile(&appendix).unwrap_or_else(|reason| {
            notes.push(format!("{reason}: the appendix comes without PDF"));
            Vec::new()
        })
    } else {
        Vec::new()
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

/// Adds the certificate in both encodings, and a single tiling with its meshes.
fn entry(Piece { content, subject }: &Piece, files: &mut Vec<File>) -> Entry {
    let slug = subject.slug();
    files.push(File {
        path: format!("certificates/{slug}.cbor"),
        bytes: subject.certificate().to_vec(),
    });
    let json = content.json().to_owned();
    files.push(file(&format!("certificates/{slug}.json"), json));
    let mut rounding = None;
    if let Some(tiling) = content.tiling() {
        let text = with_dimension!(tiling, AnyTiling, t => tiling_text(t, &slug));
        files.push(file(&format!("tilings/{slug}.json"), text));
        if let AnyTiling::Space(tiling) = tiling {
            rounding = Some(meshes(tiling, &slug, files));
        }
    }
    Entry {
        claim: content.claim(),
        sha256: subject.sha256().to_owned(),
        slug,
        is_tiling: content.tiling().is_some(),
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
