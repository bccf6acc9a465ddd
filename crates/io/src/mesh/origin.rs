//! The names of a tiling's indices in the file that it was read from.

use super::Mesh;
use super::lattice::Basis;
use super::numbering::Numbering;
use acutile_core::tiling::SimplexId;
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::BTreeMap;

/// The file's numbers of tetrahedra, corners and vertices of a tiling.
#[derive(Clone, Debug, Default)]
pub struct Origin {
    nodes: Numbering,
    elements: Numbering,
    lines: Option<Numbering>,
    /// The point of each corner, one cell after the other.
    corners: Vec<u32>,
    /// The corners of a cell.
    width: usize,
    /// The label of each cell, or nothing.
    labels: Vec<i64>,
    /// The names of labels.
    names: BTreeMap<i64, String>,
    /// A point of each vertex.
    representatives: Vec<u32>,
    /// The basis of the tiling's coordinates, in those of the file.
    basis: Vec<[Number; 3]>,
    /// The z of all nodes of a plane mesh.
    height: Option<Number>,
}

/// A tetrahedron in the numbers of its file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Element {
    /// Its number.
    pub tag: u64,
    /// Its line, for text.
    pub line: Option<u64>,
}

impl Origin {
    /// The numbers of a mesh, with a point for each vertex of the tiling.
    pub fn new(mesh: Mesh, representatives: Vec<u32>, basis: &Basis) -> Self {
        let corners = mesh.cells().flatten().copied().collect();
        let width = mesh.dimension() + 1;
        let labels = mesh.materials().to_vec();
        let corner: Option<&u32> = mesh.triangles.first().map(|triangle| &triangle[0]);
        let corner = corner
            .filter(|_| width == 3)
            .map(|c| mesh.points[*c as usize]);
        let height = corner.and_then(|[.., z]| Rational::try_from(z).ok());
        let height = height.map(Number::from);
        Origin {
            nodes: mesh.nodes,
            elements: mesh.elements,
            lines: mesh.lines,
            corners,
            width,
            labels,
            names: mesh.names,
            representatives,
            height,
            basis: basis.vectors.to_vec(),
        }
    }

    /// A point of the tiling in the coordinates of the file.
    pub fn cartesian(&self, point: &[Number]) -> Vec<Number> {
        let coordinate = |j: usize| {
            let terms = point.iter().zip(&self.basis).map(|(x, b)| x * &b[j]);
            let height = self.height.clone().filter(|_| j == 2);
            let origin = height.unwrap_or_else(Number::zero);
            terms.fold(origin, |sum, term| sum + term)
        };
        (0..3).map(coordinate).collect()
    }

    /// The element that became the simplex with this index.
    pub fn tetrahedron(&self, simplex: SimplexId) -> Element {
        Element {
            tag: self.elements.get(simplex.index()),
            line: self.lines.as_ref().map(|lines| lines.get(simplex.index())),
        }
    }

    /// The label of a cell, if it has one.
    pub fn label(&self, simplex: SimplexId) -> Option<i64> {
        let label = self.labels.get(simplex.index()).copied();
        label.filter(|&label| label != 0)
    }

    /// A label as the file names it: `tag 7 "steel"`, without control characters.
    pub fn label_name(&self, label: i64) -> String {
        match self.names.get(&label) {
            Some(name) => {
                let printable = |c: char| if c.is_control() { '\u{fffd}' } else { c };
                let name: String = name.chars().map(printable).collect();
                format!("tag {label} \"{name}\"")
            }
            None => format!("tag {label}"),
        }
    }

    /// Whether the cells have labels.
    pub fn has_labels(&self) -> bool {
        !self.labels.is_empty()
    }

    /// The number of the node at a corner (0 to 3) of a simplex.
    pub fn corner(&self, simplex: SimplexId, corner: usize) -> u64 {
        let point = self.corners[simplex.index() * self.width + corner];
        self.nodes.get(point as usize)
    }

    /// The number of a node that became this vertex, the first of those that differ by
    /// lattice vectors.
    pub fn vertex(&self, vertex: usize) -> u64 {
        self.nodes.get(self.representatives[vertex] as usize)
    }

    /// The last two corners of these simplices have been exchanged.
    pub fn reoriented(&mut self, simplices: &[SimplexId]) {
        for &simplex in simplices {
            let last = simplex.index() * self.width + self.width - 1;
            self.corners.swap(last - 1, last);
        }
    }
}
