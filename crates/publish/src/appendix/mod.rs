//! A LaTeX appendix about certificates. It has the theorem, the numbers by which a referee can follow the
//! proof, and the way to check it again.
//!
//! | file | part |
//! |---|---|
//! | `subject` | a confirmed certificate, and what is computed of its tiling |
//! | `rational`, `numeral`, `surd`, `tex` | exact numbers and small pieces of TeX |
//! | `breaks`, `columns` | where lines break, and how wide tables are |
//! | `theorem`, `claim`, `field` | the theorem, its statements in words, its field |
//! | `names` | what people call a construction; headings |
//! | `orbits` | representatives of the tiles under a group |
//! | `vertices`, `group`, `tiles`, `facets`, `boundary`, `volume` | a paragraph and a table for each hypothesis |
//! | `region`, `separation` | the boundary of a region: facets that meet, and what is outside |
//! | `classes` | congruence classes: edges, angles, and why they are acute |
//! | `figures` | a figure of each class |
//! | `space_group` | the type of the group, and the Wyckoff letters of the vertices |
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

pub(crate) mod bibliography;
mod boundary;
mod breaks;
mod claim;
mod classes;
mod columns;
mod conditions;
mod document;
mod facets;
mod family;
mod field;
mod figures;
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
mod space_group;
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
use breaks::breakable;
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
    /// The content.
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
    let parts = subjects
        .par_iter()
        .map(|subject| parts_of(subject, options))
        .collect();
    document::files(subjects, parts, options)
}

fn parts_of(subject: &Subject, options: &Options) -> Parts {
    let parts = unbroken_parts(subject, options);
    Parts {
        section: breakable(&parts.section),
        tables: breakable(&parts.tables),
        ..parts
    }
}

fn unbroken_parts(subject: &Subject, options: &Options) -> Parts {
    match &subject.content {
        Content::Tiling(AnyTiling::Plane(tiling)) => {
            let analysis = Analysis::of(subject, tiling, Vec::new());
            let figures = figures::triangles(&subject.name, tiling, &analysis.shapes, options);
            parts_of_tiling(&analysis, &figures)
        }
        Content::Tiling(AnyTiling::Space(tiling)) => {
            let analysis = Analysis::of(subject, tiling, stars(tiling));
            let figures = figures::solids(&subject.name, tiling, &analysis.shapes, options);
            parts_of_tiling(&analysis, &figures)
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

fn parts_of_tiling<const D: usize>(analysis: &Analysis<D>, figures: &str) -> Parts {
    Parts {
        section: section(analysis, figures),
        tables: tables(analysis),
        row: overview::row(analysis),
    }
}

/// The section on a subject.
fn section<const D: usize>(analysis: &Analysis<D>, figures: &str) -> String {
    let subject = analysis.subject;
    let citation = bibliography::citation(&subject.name, subject.source);
    [
        format!(
            "\\acutilesection{{{}}}\\label{{{}}}\n",
            names::heading(subject),
            analysis.label("section")
        ),
        names::introduction(subject, &citation),
        theorem::sizes(analysis),
        "\n\n".to_owned(),
        theorem::theorem(analysis),
        theorem::proof(analysis),
        field::root(analysis),
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
            classes::classes(analysis, figures)
        ),
        statements::statements(analysis),
        recheck::recheck(subject),
    ]
    .concat()
}

/// The long tables of a subject.
fn tables<const D: usize>(analysis: &Analysis<D>) -> String {
    [
        format!("\\section{{{}}}\n", names::heading(analysis.subject)),
        vertices::table(analysis),
        tiles::all_simplices(analysis),
        facets::all_facets(analysis),
    ]
    .concat()
}
