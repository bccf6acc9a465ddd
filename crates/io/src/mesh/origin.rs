//! What a tiling's indices are called in the file that it was read from.

use super::Mesh;
use super::lattice::Basis;
use super::numbering::Numbering;
use acutile_core::tiling::SimplexId;
use acutile_exact::number::Number;

/// The file's numbers of tetrahedra, corners and vertices of a tiling.
#[derive(Clone, Debug, Default)]
pub struct Origin {
    nodes: Numbering,
    elements: Numbering,
    lines: Option<Numbering>,
    /// The point of each corner.
    corners: Vec<[u32; 4]>,
    /// A point of each vertex.
    representatives: Vec<u32>,
    /// The basis of the tiling's coordinates, in those of the file.
    basis: Vec<[Number; 3]>,
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
        Origin {
            nodes: mesh.nodes,
            elements: mesh.elements,
            lines: mesh.lines,
            corners: mesh.tetrahedra,
            representatives,
            basis: basis.vectors.to_vec(),
        }
    }

    /// A point of the tiling in the coordinates of the file.
    pub fn cartesian(&self, point: &[Number]) -> Vec<Number> {
        let coordinate = |j: usize| {
            let terms = point.iter().zip(&self.basis).map(|(x, b)| x * &b[j]);
            terms.fold(Number::zero(), |sum, term| sum + term)
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

    /// The number of the node at a corner (0 to 3) of a simplex.
    pub fn corner(&self, simplex: SimplexId, corner: usize) -> u64 {
        self.nodes
            .get(self.corners[simplex.index()][corner] as usize)
    }

    /// The number of a node that became this vertex, the first of those that differ by
    /// lattice vectors.
    pub fn vertex(&self, vertex: usize) -> u64 {
        self.nodes.get(self.representatives[vertex] as usize)
    }

    /// The last two corners of these simplices have been exchanged.
    pub fn reoriented(&mut self, simplices: &[SimplexId]) {
        for &simplex in simplices {
            self.corners[simplex.index()].swap(2, 3);
        }
    }
}
