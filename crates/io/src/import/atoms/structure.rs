//! A crystal structure: the atoms of a cell with their labels, whatever file they come from.

use super::distance::{Shortest, approximate, shortest};
use acutile_core::tiling::{Frame, PointSet};
use acutile_exact::number::{Field, Number};
use acutile_exact::polynomial::Polynomial;
use malachite::Rational;

/// A crystal structure as a point set.
pub struct Structure {
    /// The name in the file.
    pub name: String,
    /// The atoms, with coordinates in the basis of the cell.
    pub points: PointSet<3>,
    /// For each point the label of its site.
    pub labels: Vec<String>,
    /// For each point its element, as far as that is known.
    pub elements: Vec<Option<&'static str>>,
    /// Notes for the reader: replacements, rounding, warnings, counts. Each is a line.
    pub notes: Vec<String>,
    /// The free numbers with standard uncertainties, if they are asked for.
    pub variation: Option<Variation>,
}

/// A structure for each point of a box of parameters.
#[derive(Clone, Debug)]
pub struct Variation {
    /// At least one.
    pub intervals: Vec<Interval>,
    /// Up to a positive factor.
    pub gram: [[Polynomial; 3]; 3],
    /// In the order of the structure's points.
    pub points: Vec<[Polynomial; 3]>,
}

/// A parameter, from `low` to `high`.
#[derive(Clone, Debug)]
pub struct Interval {
    /// A name like `x_fe1` or `c_over_a`.
    pub name: String,
    /// The lower end, which belongs to it.
    pub low: Rational,
    /// The upper end, which belongs to it.
    pub high: Rational,
}

/// Atoms are never nearer to each other, in the units of cell lengths (ångströms).
const NEAREST: f64 = 0.5;

impl Structure {
    /// Adds the shortest distance and its atoms to the notes, as a warning if it is below 0.5 Å.
    pub fn note_distance(&mut self) {
        let note = match self.shortest() {
            None => "the shortest distance is not known: the cell is too skewed".to_owned(),
            Some(shortest) => {
                let length = approximate(&shortest.squared).sqrt();
                let (i, j) = shortest.atoms;
                let names = if i == j {
                    format!("{} and its translate", self.place(i))
                } else {
                    format!("{} and {}", self.place(i), self.place(j))
                };
                let warning = if length < NEAREST { "warning: " } else { "" };
                let advice = if length < NEAREST {
                    "; atoms are not as near as this: the file may list one twice"
                } else {
                    ""
                };
                format!("{warning}the shortest distance is {length:.4}, between {names}{advice}")
            }
        };
        self.notes.push(note);
    }

    /// The shortest distance.
    pub fn shortest(&self) -> Option<Shortest> {
        let rational = |x: &Number| x.to_rational().cloned().unwrap_or_default();
        let gram = self
            .points
            .frame
            .gram
            .each_ref()
            .map(|row| row.each_ref().map(rational));
        let points: Vec<[Rational; 3]> = self
            .points
            .points
            .iter()
            .map(|point| point.each_ref().map(rational))
            .collect();
        shortest(&gram, &points)
    }

    fn place(&self, atom: usize) -> String {
        let numbers = self.points.points[atom]
            .each_ref()
            .map(|x| format!("{:.4}", x.approximate()));
        format!("{} ({})", self.labels[atom], numbers.join(", "))
    }
}

/// Points with rational coordinates in a basis with a rational Gram matrix.
pub fn point_set<'a>(
    gram: [[Rational; 3]; 3],
    positions: impl Iterator<Item = &'a [Rational; 3]>,
) -> PointSet<3> {
    PointSet {
        frame: Frame::space(Field::rationals(), gram.map(|row| row.map(Number::from))),
        points: positions
            .map(|position| position.clone().map(Number::from))
            .collect(),
    }
}
