//! The names of simplices, corners and vertices in messages: their indices, or the
//! numbers of the file that a mesh was read from.

use crate::tiling::{SimplexId, Tiling};
use acutile_exact::number::Number;

/// The coordinates of a point in the file, from those in the basis.
type Place<'a> = Box<dyn Fn(&[Number]) -> Vec<Number> + 'a>;

/// The names of one tiling's parts.
pub struct Names<'a> {
    simplex: Box<dyn Fn(SimplexId) -> String + 'a>,
    corner: Box<dyn Fn(SimplexId, usize) -> String + 'a>,
    vertex: Box<dyn Fn(usize) -> String + 'a>,
    label: Box<dyn Fn(SimplexId) -> Option<String> + 'a>,
    point: Option<Place<'a>>,
    is_exact: bool,
}

impl<'a> Names<'a> {
    /// Indices from zero: `simplex 3`, and corners as `5+(0, 1, 0)`.
    pub fn of<const D: usize>(tiling: &'a Tiling<D>) -> Self {
        Names::new(
            |simplex| format!("simplex {simplex}"),
            |simplex, corner| tiling.simplex(simplex)[corner].to_string(),
            |vertex| format!("vertex {vertex}"),
        )
    }

    /// A simplex by its index, a corner by the index of its simplex and its place in it, a
    /// vertex by its index.
    pub fn new(
        simplex: impl Fn(SimplexId) -> String + 'a,
        corner: impl Fn(SimplexId, usize) -> String + 'a,
        vertex: impl Fn(usize) -> String + 'a,
    ) -> Self {
        Names {
            simplex: Box::new(simplex),
            corner: Box::new(corner),
            vertex: Box::new(vertex),
            label: Box::new(|_| None),
            point: None,
            is_exact: false,
        }
    }

    /// The same, with names of labels of simplices.
    pub fn with_labels(self, label: impl Fn(SimplexId) -> Option<String> + 'a) -> Self {
        Names {
            label: Box::new(label),
            ..self
        }
    }

    /// The same, with points in the coordinates of the file and not in those of the basis.
    pub fn with_points(self, point: impl Fn(&[Number]) -> Vec<Number> + 'a) -> Self {
        Names {
            point: Some(Box::new(point)),
            ..self
        }
    }

    /// The same; long exact numbers are written in full, or only about.
    pub fn exact(self, is_exact: bool) -> Self {
        Names { is_exact, ..self }
    }

    /// Whether long exact numbers are written in full.
    pub fn is_exact(&self) -> bool {
        self.is_exact
    }

    /// The label of a simplex, if it has one.
    pub fn label(&self, simplex: SimplexId) -> Option<String> {
        (self.label)(simplex)
    }

    /// A point in the coordinates of the file, if they are others than those of the basis.
    pub fn point(&self, point: &[Number]) -> Option<Vec<Number>> {
        self.point.as_ref().map(|in_file| in_file(point))
    }

    /// The name of a simplex.
    pub fn simplex(&self, simplex: SimplexId) -> String {
        (self.simplex)(simplex)
    }

    /// The name of a corner of a simplex.
    pub fn corner(&self, simplex: SimplexId, corner: usize) -> String {
        (self.corner)(simplex, corner)
    }

    /// The name of a vertex.
    pub fn vertex(&self, vertex: usize) -> String {
        (self.vertex)(vertex)
    }
}
