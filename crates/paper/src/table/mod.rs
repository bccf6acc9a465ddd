//! The paper's Table 1, for any constructions: radius-edge ratio, smallest and largest
//! dihedral angle, each with its minimum and maximum over the tetrahedra.
//!
//! Every figure is an enclosure of the exact value; `render` writes them in several
//! formats. The paper's own figures are judged in [`crate::paper`].

mod general;
mod render;

pub use general::{figures_of_family, of_family};
pub use render::{csv, json, latex, markdown, text};

use crate::survey::{AnyStudy, Study};
use acutile_core::quality::{Exact, Range};
use malachite::Rational;

/// The rows that the paper has, in its order: the names here and its labels.
pub const PAPER_ROWS: [(&str, &str); 14] = [
    ("z", "TCP Z from triangle tiling"),
    ("a15", "TCP A15 from square tiling"),
    ("sigma", "TCP σ"),
    ("c15", "TCP C15"),
    ("icosahedral", "TCP Z from icosahedra"),
    ("slab", "Slab"),
    ("sommerville-1", "Sommerville I"),
    ("sommerville-2", "Sommerville II"),
    ("sommerville-3", "Sommerville III"),
    ("sommerville-4", "Sommerville IV"),
    ("cube-5", "Cube V"),
    ("cube-6", "Cube VI"),
    ("regular", "Regular tetrahedron"),
    ("cube-corner", "Cube corner"),
];

/// The six columns: the measure, and the number of digits after the point in the paper.
pub const COLUMNS: [(&str, u64); 3] = [
    ("radius_edge", 3),
    ("smallest_dihedral", 2),
    ("largest_dihedral", 2),
];

/// The width of the enclosures: with outward rounding to [`DIGITS`] digits the ends
/// stay within 1e-9.
pub fn width() -> Rational {
    Rational::from_signeds(1i64, 10_000_000_000)
}

/// Digits after the point of the enclosures' ends.
pub const DIGITS: u64 = 11;

/// A figure: bounds, and the closed form where there is a short one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// Lower and upper bound; equal where the value is rational and recognised.
    pub bounds: (Rational, Rational),
    /// The exact value as text, such as `arccos(1/5)`.
    pub closed_form: Option<String>,
}

impl Figure {
    /// The figure of an exactly known value.
    pub fn of(value: &impl Exact) -> Figure {
        Figure {
            bounds: value.enclosure(&width()),
            closed_form: value.closed_form(),
        }
    }

    /// Whether the bounds are the value itself.
    pub fn is_rational(&self) -> bool {
        self.bounds.0 == self.bounds.1
    }
}

/// A row of the table.
#[derive(Clone, Debug)]
pub struct Row {
    /// The name in the catalogue.
    pub name: String,
    /// The paper's label where it has the row, else the name.
    pub label: String,
    /// 2 or 3.
    pub dimension: usize,
    /// Simplices in a cell; `None` for a system of patches.
    pub simplices: Option<usize>,
    /// Congruence classes of simplices; `None` for a construction with many members.
    pub shapes: Option<usize>,
    /// The SHA-256 of the certificate.
    pub certificate: String,
    /// Minimum and maximum for each column; `None` where no bound is known.
    pub figures: [(Option<Figure>, Option<Figure>); 3],
}

impl Row {
    /// The row of a study.
    pub fn of(name: &str, study: &AnyStudy) -> Row {
        match study {
            AnyStudy::Plane(study) => Row::of_dimension(name, study),
            AnyStudy::Space(study) => Row::of_dimension(name, study),
        }
    }

    fn of_dimension<const D: usize>(name: &str, study: &Study<D>) -> Row {
        Row {
            name: name.to_owned(),
            label: label(name).unwrap_or(name).to_owned(),
            dimension: D,
            simplices: Some(study.tiling.len()),
            shapes: Some(study.shapes().len()),
            certificate: study.certificate.clone(),
            figures: [
                figures(&study.ranges.radius_edge),
                figures(&study.ranges.smallest_dihedral),
                figures(&study.ranges.largest_dihedral),
            ],
        }
    }
}

fn figures<T: Exact>(range: &Range<T>) -> (Option<Figure>, Option<Figure>) {
    (Some(Figure::of(&range.min)), Some(Figure::of(&range.max)))
}

/// The paper's label for a construction in its table.
pub fn label(name: &str) -> Option<&'static str> {
    let row = PAPER_ROWS.iter().find(|(row, _)| *row == name)?;
    Some(row.1)
}

/// Names in the table's order: the paper's rows, then the others as they come.
pub fn order<'a>(names: &[&'a str]) -> Vec<&'a str> {
    let in_paper = PAPER_ROWS.iter().map(|(name, _)| *name);
    let others = names.iter().copied().filter(|name| label(name).is_none());
    in_paper.chain(others).collect()
}
