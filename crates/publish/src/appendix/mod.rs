//! A LaTeX appendix about certificates: what was proved, with the numbers by which a
//! referee can follow it, and how to check it again.
//!
//! | file | part |
//! |---|---|
//! | `subject` | a confirmed certificate, and what is computed of its tiling |
//! | `rational`, `numeral`, `surd`, `tex` | exact numbers and small pieces of TeX |
//! | `theorem` | the theorem in words; field, lattice, metric |
//! | `names` | what people call a construction |
//! | `orbits` | representatives of the tiles under a group |
//! | `vertices`, `group`, `tiles`, `facets`, `boundary`, `volume` | a paragraph and a table for each hypothesis |
//! | `region`, `separation` | the boundary of a region: facets that meet, and what is outside |
//! | `classes` | congruence classes: edges, angles, and why they are acute |
//! | `statements` | bounds, Delaunay, TCP |
//! | `family`, `conditions`, `polynomial` | families: polynomials and their signs |
//! | `patches` | systems of patches, with pictures of the pieces |
//! | `recheck` | the certificate's digest and command |
//! | `overview` | the table in the form of the paper's Table 1 |
//! | `bibliography`, `document` | references; the files |
//!
//! Nothing here proves anything: the kernel has confirmed the certificate before
//! ([`crate::report::Proved`]), and tests/appendix/check.py compares the printed numbers with
//! the certificate.

mod bibliography;
mod boundary;
mod classes;
mod conditions;
mod document;
mod facets;
mod family;
mod group;
mod names;
mod numeral;
mod orbits;
mod overview;
mod patches;
mod polynomial;
mod rational;
mod recheck;
mod region;
mod separation;
mod statements;
mod subject;
mod surd;
mod tex;
mod theorem;
mod tiles;
mod vertices;
mod volume;

pub use document::is_unchanged;
pub use subject::Subject;
pub use tex::slug;

use acutile_core::classify::stars;
use acutile_core::tiling::AnyTiling;
use acutile_core::with_family;
use rayon::prelude::*;
use subject::{Analysis, Content};

/// How the document is written.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Decimals through the package siunitx.
    pub siunitx: bool,
    /// The text in two columns, the long tables after it in one.
    pub two_column: bool,
}

/// A file of the appendix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Relative, with `/`.
    pub path: String,
    pub bytes: Vec<u8>,
}

/// What is written about one subject.
struct Parts {
    section: String,
    tables: String,
    row: Option<String>,
}

/// All files of an appendix about these subjects, several computed at a time.
pub fn appendix(subjects: &[Subject], options: &Options) -> Vec<File> {
    let parts = subjects.par_iter().map(parts_of).collect();
    document::files(subjects, parts, options)
}

fn parts_of(subject: &Subject) -> Parts {
    match &subject.content {
        Content::Tiling(AnyTiling::Plane(tiling)) => {
            parts_of_tiling(&Analysis::of(subject, tiling, Vec::new()))
        }
        Content::Tiling(AnyTiling::Space(tiling)) => {
            parts_of_tiling(&Analysis::of(subject, tiling, stars(tiling)))
        }
        Content::Family(family, tree) => Parts {
            section: with_family!(family, f => family::section(subject, f, tree)),
            tables: String::new(),
            row: None,
        },
        Content::Patches(system, words) => Parts {
            section: patches::section(subject, system, words),
            tables: String::new(),
            row: None,
        },
    }
}

fn parts_of_tiling<const D: usize>(analysis: &Analysis<D>) -> Parts {
    Parts {
        section: section(analysis),
        tables: tables(analysis),
        row: overview::row(analysis),
    }
}

/// The section on a subject.
fn section<const D: usize>(analysis: &Analysis<D>) -> String {
    let subject = analysis.subject;
    let citation = bibliography::citation(&subject.name, subject.source);
    [
        format!(
            "\\acutilesection{{{}}}\\label{{{}}}\n",
            theorem::heading(subject),
            analysis.label("section")
        ),
        theorem::introduction(subject, &citation),
        theorem::sizes(analysis),
        "\n\n".to_owned(),
        theorem::theorem(analysis),
        theorem::proof(analysis),
        theorem::root(analysis),
        format!(
            "\\acutileparagraph{{Metric (M).}} {}",
            theorem::metric(analysis)
        ),
        vertices::vertices(analysis),
        group::group(analysis),
        tiles::tiles(analysis),
        facets::facets(analysis),
        boundary::boundary(analysis),
        region::region(analysis),
        volume::volume(analysis),
        format!(
            "\\acutileparagraph{{Angles.}} {}",
            classes::classes(analysis)
        ),
        statements::statements(analysis),
        recheck::recheck(subject),
    ]
    .concat()
}

/// The long tables of a subject.
fn tables<const D: usize>(analysis: &Analysis<D>) -> String {
    [
        format!("\\section{{{}}}\n", theorem::heading(analysis.subject)),
        vertices::table(analysis),
        tiles::all_simplices(analysis),
        facets::all_facets(analysis),
    ]
    .concat()
}
