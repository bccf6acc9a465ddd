//! Tetrahedral meshes of other programs: read, written, turned into tilings and back.
//!
//! | file | contents |
//! |---|---|
//! | `mod.rs` | [`Mesh`]: what all formats have in common |
//! | [`mod@format`], [`unknown`] | [`Format`]: names, extensions, first bytes; formats that are not read |
//! | [`mod@load`] | a file, or standard input, read into a mesh |
//! | `draft` | a mesh while it is read |
//! | `msh`, `msh1`, `msh2`, `msh40`, `msh4`, `msh_sections` | Gmsh MSH 1, 2, 4.0 and 4.1 |
//! | `msh_write`, `msh_groups` | MSH as it is written, with positive numbers |
//! | `vtk`, `vtk_cells`, `vtk_data`, `vtu`, `vtu_data`, `vtu_parts`, `vtu_write` | VTK legacy and XML files |
//! | `medit`, `tetgen`, `abaqus`, `nastran`, `mfem` | MEDIT, TetGen and Triangle, Abaqus, Nastran, MFEM |
//! | [`surface`] | STL and OBJ surfaces |
//! | [`source`], `words`, `lines`, [`numbering`], `element`, [`error`] | what the readers share |
//! | [`sink`], [`writer`] | what the writers share; which writer a format has |
//! | [`lattice`], `sides` | the lattice of a periodic mesh, and the facets on its sides |
//! | [`convert`], `identify`, `snap` | a mesh as a tiling |
//! | [`origin`] | a tiling's indices in the numbers of the file |
//! | [`mod@flatten`], `patch` | a tiling as a mesh |
//!
//! A reader checks form; whether the mesh tiles anything is the checker's business.
//! Every coordinate is a finite double and means the dyadic rational that it is.

mod abaqus;
pub mod convert;
mod draft;
mod element;
pub mod error;
pub mod flatten;
pub mod format;
mod identify;
pub mod lattice;
mod lines;
pub mod load;
mod medit;
mod mfem;
mod msh;
mod msh1;
mod msh2;
mod msh4;
mod msh40;
mod msh_groups;
mod msh_sections;
mod msh_write;
mod nastran;
pub mod numbering;
pub mod origin;
mod patch;
mod sides;
pub mod sink;
mod snap;
pub mod source;
pub mod surface;
mod tetgen;
pub mod unknown;
mod vtk;
mod vtk_cells;
mod vtk_data;
mod vtu;
mod vtu_data;
mod vtu_parts;
mod vtu_write;
mod words;
pub mod writer;

pub use convert::{Converted, periodic_tiling, region_tiling};
pub use element::counted;
pub use error::{MeshError, Place};
pub use flatten::{Flat, flatten};
pub use format::{Family, Format};
pub use lattice::Lattice;
pub use load::{Loaded, load};
pub use numbering::Numbering;
pub use origin::Origin;
pub use patch::patch;
pub use snap::Move;
pub use writer::{File, write};

use acutile_core::curved::Element;
use acutile_core::tiling::SimplexId;
use std::collections::BTreeMap;

/// Points and cells with the numbers that a file gives them. The cells are tetrahedra, or
/// triangles where a file has no tetrahedra.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Cartesian coordinates, finite.
    pub points: Vec<[f64; 3]>,
    /// The number of each point.
    pub nodes: Numbering,
    /// Four points each, by their indices in `points`; where the determinant of
    /// the differences to the first is positive, the orientation is.
    pub tetrahedra: Vec<[u32; 4]>,
    /// Three points each, in a mesh without tetrahedra.
    pub triangles: Vec<[u32; 3]>,
    /// The cells of second order that are not straight, by their indices. The nodes are those on the
    /// edges 01, 12, 02 (and 03, 13, 23).
    pub curved: BTreeMap<usize, Vec<u32>>,
    /// The number of each cell.
    pub elements: Numbering,
    /// The line of each cell, for text.
    pub lines: Option<Numbering>,
    /// A label of each cell (physical group, material, reference), or nothing; 0 is none.
    pub labels: Vec<i64>,
    /// The geometric entity of each cell in a Gmsh file, or nothing.
    pub entities: Vec<i64>,
    /// The names of labels of cells.
    pub names: BTreeMap<i64, String>,
    /// How many elements of other types there are, by name.
    pub others: BTreeMap<String, usize>,
    /// Parts of the file that were passed over: sections, arrays, further labels.
    pub unread: Vec<String>,
    /// How parts of the boundary are images of each other.
    pub periodic: Vec<Periodic>,
    /// How many tetrahedra were turned because the format's convention is the opposite.
    pub turned: usize,
}

/// An entity of the boundary that is the image of another one.
#[derive(Clone, Debug, PartialEq)]
pub struct Periodic {
    /// 0 for points, 1 for curves, 2 for surfaces.
    pub dimension: i64,
    /// The numbers of the image and of the original.
    pub entities: (i64, i64),
    /// The rows of a 4 x 4 matrix that takes the original to the image.
    pub affine: Option<[f64; 16]>,
    /// Pairs of an image and its original, as indices of points.
    pub nodes: Vec<(u32, u32)>,
}

impl Mesh {
    /// 3 for tetrahedra, 2 for triangles.
    pub fn dimension(&self) -> usize {
        if self.tetrahedra.is_empty() && !self.triangles.is_empty() {
            2
        } else {
            3
        }
    }

    /// The number of cells.
    pub fn cell_count(&self) -> usize {
        self.tetrahedra.len().max(self.triangles.len())
    }

    /// The corners of each cell.
    pub fn cells(&self) -> impl Iterator<Item = &[u32]> {
        let triangles = self.triangles.iter().map(|corners| &corners[..]);
        let tetrahedra = self.tetrahedra.iter().map(|corners| &corners[..]);
        tetrahedra.chain(triangles)
    }

    /// The corners of the cell with this index.
    pub fn cell(&self, index: usize) -> &[u32] {
        match self.dimension() {
            2 => &self.triangles[index],
            _ => &self.tetrahedra[index],
        }
    }

    /// The name of the cells.
    pub fn cell_name(&self) -> &'static str {
        if self.dimension() == 2 {
            "triangles"
        } else {
            "tetrahedra"
        }
    }

    /// The label of each cell, or its geometric entity where there are no labels.
    pub fn materials(&self) -> &[i64] {
        if self.labels.is_empty() {
            &self.entities
        } else {
            &self.labels
        }
    }

    /// The curved cells with all of their nodes.
    pub fn curved_elements(&self) -> Vec<(SimplexId, Element)> {
        let element = |(&cell, middles): (&usize, &Vec<u32>)| {
            let point = |index: &u32| self.points[*index as usize];
            let mut points = self.cell(cell).iter().chain(middles).map(point);
            let mut next = || points.next().unwrap_or_default();
            let element = match self.dimension() {
                2 => Element::Triangle(std::array::from_fn(|_| {
                    let [x, y, _] = next();
                    [x, y]
                })),
                _ => Element::Tetrahedron(std::array::from_fn(|_| next())),
            };
            (SimplexId::at(cell), element)
        };
        self.curved.iter().map(element).collect()
    }

    /// `12 triangles, 4 points`: the elements of other types.
    pub fn other_counts(&self) -> String {
        let counts = self.others.iter().map(|(name, n)| counted(*n, name));
        counts.collect::<Vec<_>>().join(", ")
    }

    /// Which points are corners of cells.
    pub fn used_points(&self) -> Vec<bool> {
        let mut used = vec![false; self.points.len()];
        for &corner in self.cells().flatten() {
            used[corner as usize] = true;
        }
        used
    }
}
